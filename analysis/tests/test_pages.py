"""The written folder: links, escaping, pictures, exports."""

import csv
import re
from html.parser import HTMLParser
from urllib.parse import unquote
from xml.etree import ElementTree

import pytest

from analysis.build import _plan
from analysis.checks import split
from analysis.plotting import COLOURS, CONTRAST, DARK_PAPER, contrast, on_dark
from analysis.tests import fixture
from analysis.verdict_figure import draw_verdicts
from analysis.words import VERDICTS


class Links(HTMLParser):
    """Targets of href and src, and all tags with their attributes."""

    def __init__(self, text):
        super().__init__()
        self.targets, self.tags = [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        self.targets += [value for name, value in attributes if name in ("href", "src")]


def pages(folder):
    return sorted(folder.glob("*.html")) + sorted(folder.glob("case/*.html"))


def test_all_pages_are_written(built):
    ledger = {f"ledger-{source}.html" for source in ("BAR", "GRE", "MUL")}
    assert {page.name for page in built[1].glob("*.html")} == {"index.html", "flows.html", "precision.html",
                                                                "mutants.html"} | ledger
    assert len(list(built[1].glob("case/*.html"))) == len(built[0].cases)


def test_relative_links_lead_to_files(built):
    for page in pages(built[1]):
        for target in Links(page.read_text(encoding="utf-8")).targets:
            path = unquote(target.partition("#")[0])
            if path and not re.match(r"https?:|data:", path):
                assert (page.parent / path).is_file(), f"{page.name}: {target}"


def own_script(built):
    """The one script of the pages, which stands in them word for word and takes nothing from a report."""
    text = (fixture.TOP / "templates" / "report.js").read_text(encoding="utf-8").strip()
    for page in pages(built[1]):
        found = page.read_text(encoding="utf-8")
        yield page, found.replace(f"<script>\n{text}\n\n</script>", "").replace(f"<script>\n{text}\n</script>", "")


def test_nothing_is_loaded_from_elsewhere(built):
    for page, text in own_script(built):
        for tag, attributes in Links(text).tags:
            assert tag not in ("script", "iframe", "object", "b-", "x")
            assert not attributes.get("src", "").startswith(("http", "//", "data:"))
            assert not any(name.startswith("on") for name in attributes)
            assert "javascript:" not in attributes.get("href", "")


def test_hostile_text_is_shown_not_obeyed(built):
    page = next(text for page, text in own_script(built) if page.name.startswith("awkward"))
    assert "&lt;script&gt;alert" in page
    assert "<script" not in page


def test_every_figure_of_the_evidence_is_drawn_once(built):
    report, folder = built
    _, jobs = _plan(report, folder, folder / "figures")
    drawn = [(item.verdict.run, repr(figure)) for job in jobs for what in job.args if isinstance(what, list)
             for item, figure in filter(lambda each: isinstance(each, tuple), what)]
    given = {(item.verdict.run, repr(figure)) for case in report.cases for item in case.evidence
             for figure in item.figures}
    assert set(drawn) == given
    assert (folder / "figures" / "matrix.png").stat().st_size > 5000


def test_each_check_has_a_picture_and_identities_have_a_line(built):
    report, folder = built
    page = (folder / "case" / "equilibrium-gas.html").read_text(encoding="utf-8")
    assert page.count('<section class="check ') == 1
    assert "case--equilibrium-gas--collision-rate.svg" in page
    assert re.search(r"Exact identities</b> hold to rounding: momentum-conservation \(20 runs, at most 1×10⁻¹⁵ mass", page)
    assert page.count('<tbody id="') == sum(item.case == "equilibrium-gas" for item in report.verdicts)


def test_pictures_follow_the_scheme_of_the_viewer(built):
    for path in (built[1] / "figures").glob("*.svg"):
        text = path.read_text(encoding="utf-8")
        assert text.count("prefers-color-scheme: dark") == 1, path.name


def test_colours_of_data_can_be_told_from_dark_paper():
    for colour in COLOURS + ["#440154", "#333333"]:   # the second last: the dark end of viridis
        assert contrast(on_dark(colour), DARK_PAPER) >= CONTRAST
    assert on_dark("#e69f00") == "#e69f00" and on_dark("#ffffff") == DARK_PAPER
    assert contrast("#000000", "#ffffff") == pytest.approx(21)


def test_unreadable_equation_stays_text(built):
    page = (built[1] / "case" / "equilibrium-gas.html").read_text(encoding="utf-8")
    assert 'alt="omega = 2 sqrt(pi) n d g sqrt(T/m)"' in page
    assert "<code>p = n T &lt; unreadable &gt;</code>" in page


def test_csv_holds_every_verdict(built):
    report, folder = built
    with (folder / "verdicts.csv").open(newline="", encoding="utf-8") as stream:
        lines = list(csv.DictReader(stream))
    assert [line["check"] for line in lines] == [item.check for item in report.verdicts]
    assert float(lines[0]["value"]) == report.verdicts[0].value
    assert lines[0]["budget_reason"] == report.verdicts[0].budget_parts.reason
    unknown = next(line for line in lines if line["verdict"] == "inconclusive")
    assert unknown["value"] == ""


def test_junit_blocks_where_the_judge_blocks(built):
    report, folder = built
    root = ElementTree.parse(folder / "junit.xml").getroot()
    types = sorted(failure.get("type") for failure in root.iter("failure"))
    assert types == ["fail", "inconclusive", "unexpected-pass"]
    assert len(list(root.iter("testcase"))) == len(report.verdicts)
    spent = sum(float(test.get("time")) for test in root.iter("testcase"))
    known = {item.run: item.cpu_seconds or 0 for item in report.verdicts}
    assert spent == pytest.approx(sum(known.values()), abs=1e-3)


def test_a_rebuilt_picture_is_the_same_file(built, tmp_path):
    report, folder = built
    group = split(report.cases[0])[0][0]
    draw_verdicts(group, tmp_path / "again")
    name = f"case--equilibrium-gas--{group.check}.svg"
    assert (tmp_path / "again.svg").read_bytes() == (folder / "figures" / name).read_bytes()


def test_fixture_has_every_verdict(built):
    assert {item.verdict for item in built[0].verdicts} == set(VERDICTS)
    assert fixture.HOSTILE in {item.variant for item in built[0].verdicts}
