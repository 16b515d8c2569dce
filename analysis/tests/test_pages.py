"""The written folder: links, escaping, pictures, exports."""

import csv
import re
from html.parser import HTMLParser
from urllib.parse import unquote
from xml.etree import ElementTree

import pytest

from analysis.tests import fixture


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
    assert {page.name for page in built[1].glob("*.html")} == {"index.html", "flows.html", "precision.html",
                                                                "mutants.html"}
    assert len(list(built[1].glob("case/*.html"))) == len(built[0].cases)


def test_relative_links_lead_to_files(built):
    for page in pages(built[1]):
        for target in Links(page.read_text(encoding="utf-8")).targets:
            path = unquote(target.partition("#")[0])
            if path and not re.match(r"https?:|data:", path):
                assert (page.parent / path).is_file(), f"{page.name}: {target}"


def test_nothing_is_loaded_from_elsewhere(built):
    for page in pages(built[1]):
        for tag, attributes in Links(page.read_text(encoding="utf-8")).tags:
            assert tag not in ("script", "iframe", "object", "b-", "x")
            assert not attributes.get("src", "").startswith(("http", "//", "data:"))
            assert not any(name.startswith("on") for name in attributes)
            assert "javascript:" not in attributes.get("href", "")


def test_hostile_text_is_shown_not_obeyed(built):
    page = next(built[1].glob("case/awkward*.html")).read_text(encoding="utf-8")
    assert "&lt;script&gt;alert" in page
    assert "<script" not in page


@pytest.mark.parametrize("kind", ["png", "svg"])
def test_every_figure_has_both_forms(built, kind):
    report, folder = built
    figures = sum(len(item.figures) for case in report.cases for item in case.evidence)
    names = [path.name for path in (folder / "figures").glob(f"*.{kind}")]
    drawn = [name for name in names if re.search(r"\.\d+\.(png|svg)$", name)]
    assert len(drawn) == figures
    assert (folder / "figures" / f"matrix.{kind}").stat().st_size > 5000


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
    from analysis.figures import draw_evidence
    report, folder = built
    item = next(item for case in report.cases for item in case.evidence if item.figures)
    draw_evidence(item.figures[0], item.verdict, tmp_path / "again.1")
    again = (tmp_path / "again.1.svg").read_bytes()
    assert any(path.read_bytes() == again for path in (folder / "figures").glob("*.1.svg"))


def test_fixture_has_every_verdict(built):
    from analysis.words import VERDICTS
    assert {item.verdict for item in built[0].verdicts} == set(VERDICTS)
    assert fixture.HOSTILE in {item.variant for item in built[0].verdicts}
