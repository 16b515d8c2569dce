"""The folded matrix: what a cell says of its checks, and what the front page and the picture make of it."""

import itertools
import math
import re
from dataclasses import replace

import pytest

from analysis import matrix_figure, words
from analysis.build import Pictures, build
from analysis.grid import grid
from analysis.load import load_report
from analysis.pages import write_front_page
from analysis.summary import headline
from analysis.tests import fixture


def row(check, word="pass", share=0.5, variant="dsmc", point="2d", case="gas", **more):
    """A verdict whose deviation is `share` budgets."""
    return fixture.verdict(case, variant, point, check, word, deviation=share, budget=1.0) | more


def write(folder, *rows):
    files = {"verdicts.json": list(rows)}
    for case in dict.fromkeys(item["case"] for item in rows):
        files[f"evidence/{case}.json"] = fixture.evidence([(item, []) for item in rows if item["case"] == case])
    return fixture.write(folder, files)


def fold(folder, *rows):
    """The one cell of these checks."""
    [found] = grid(load_report(write(folder, *rows))).folds
    return found


def front_page(folder, *rows):
    write_front_page(load_report(write(folder, *rows)), folder, Pictures())
    return (folder / "index.html").read_text(encoding="utf-8")


def test_one_fail_among_passes_colours_the_cell(tmp_path):
    rows = [row(f"check-{index}", share=0.9) for index in range(30)] + [row("broken", "fail", 1.2)]
    cell = fold(tmp_path, *rows)
    assert (cell.verdict, cell.worst.check) == ("fail", "broken")
    assert cell.tallies == [("fail", "✗ 1"), ("pass", "✓ 30/31")]
    assert [item.check for item in cell.blocking] == ["broken"]
    assert '<td class="fold fail c1">' in front_page(tmp_path, *rows)


def test_a_known_limit_is_fine_but_visible(tmp_path):
    rows = [row("rate", share=0.4), row("moments", share=0.7), row("pressure", "expected-fail", 17)]
    cell = fold(tmp_path, *rows)
    assert cell.tallies == [("pass", "✓ 2/2"), ("expected-fail", "◇ 1")]
    assert (cell.blocking, cell.verdict) == ([], "expected-fail")
    assert (cell.worst.check, cell.worst.share) == ("moments", 0.7)
    page = front_page(tmp_path, *rows)
    assert '<td class="fold expected-fail c1">' in page and "◇ 1" in page


def test_a_known_limit_says_why(tmp_path):
    page = front_page(tmp_path, row("pressure", "expected-fail", 17, known_limit="no <offset>"))
    assert "no &lt;offset&gt;" in page


def test_only_known_limits_show_how_far_they_miss(tmp_path):
    cell = fold(tmp_path, row("rate", "expected-fail", 3), row("pressure", "expected-fail", 17))
    assert cell.tallies == [("expected-fail", "◇ 2")] and cell.demanded == 0
    assert cell.worst.check == "pressure"


@pytest.mark.parametrize("word", ["inconclusive", "unexpected-pass"])
def test_what_cannot_be_told_blocks(tmp_path, word):
    cell = fold(tmp_path, row("rate", share=0.9), row("noisy", word, 0.3), row("limit", "expected-fail", 5))
    assert (cell.verdict, cell.worst.check) == (word, "noisy")
    assert [item.verdict for item in cell.blocking] == [word]
    assert cell.tallies[0] == (word, f"{words.VERDICTS[word].symbol} 1")


def test_worst_deviation_is_the_largest_in_budgets(tmp_path):
    rows = [row("large", share=0.2) | {"deviation": 200.0, "budget": 1000.0},
            row("near", share=0.2) | {"deviation": 0.008, "budget": 0.01}, row("exact", budget=0.0, share=0.0)]
    cell = fold(tmp_path, *rows)
    assert (cell.worst.check, cell.worst.share) == ("near", pytest.approx(0.8))
    cell = fold(tmp_path, row("unknown", share=None), row("known", share=0.1))
    assert cell.worst.check == "known"


@pytest.mark.parametrize("word, deviation, budget, share", [
    ("pass", 0.0, 0.0, 0.0), ("fail", 1.0, 0.0, math.inf), ("inconclusive", 1.0, 0.0, None),
    ("inconclusive", None, 0.0, None), ("pass", 0.5, 2.0, 0.25)])
def test_a_budget_of_zero_demands_the_exact_value(tmp_path, word, deviation, budget, share):
    cell = fold(tmp_path, row("count", word) | {"deviation": deviation, "budget": budget})
    assert cell.worst.share == share


@pytest.mark.parametrize("share, text", [(None, "–"), (0.0, "0"), (1e-9, "<0.01"), (0.5, "0.50"), (9.96, "9.96"),
                                         (17.3, "17"), (2.5e6, "2.5×10⁶"), (math.inf, "∞")])
def test_ratio_is_short(share, text):
    assert words.ratio(share) == text


def test_rows_are_grouped_and_columns_sorted(tmp_path):
    few = [row("a", case="ball", variant="exact"), row("a", case="cradle", variant="exact")]
    many = [row("a", case="gas", variant=name) for name in ("slow", "quick", "exact")]
    write(tmp_path, *few, *many, row("a", case="wave", variant="quick"))
    report = load_report(tmp_path)
    assert grid(report).variants == ["exact", "quick", "slow"]
    assert list(grid(report).topics) == ["kinetic-theory"]
    assert list(grid(report).topics["kinetic-theory"]) == ["ball", "cradle", "gas", "wave"]


def test_gases_come_first_and_few_balls_last(tmp_path):
    write(tmp_path, *(row("a", case=case) for case in ("ball", "cradle", "gas", "wave")))
    report = load_report(tmp_path)
    topics = ("few-body", "transport", "kinetic-theory", "mixing")
    cases = [replace(case, topic=topic) for case, topic in zip(report.cases, topics)]
    assert list(grid(replace(report, cases=cases)).topics) == ["kinetic-theory", "mixing", "transport", "few-body"]


def test_a_cell_that_is_not_run_is_empty(tmp_path):
    page = front_page(tmp_path, row("a", case="ball", variant="exact"), row("a", case="gas", variant="quick"))
    assert page.count('<td class="fold ') == 2 and page.count('<td class="none">') == 2
    assert page.count("not run</span>") == 2


def test_every_cell_opens_its_list(built):
    page = (built[1] / "index.html").read_text(encoding="utf-8")
    opens = re.findall(r'class="opens" href="#([^"]+)"', page)
    lists = re.findall(r'<section class="opened [^"]+" id="([^"]+)"', page)
    assert sorted(opens) == sorted(lists) and len(set(opens)) == len(grid(built[0]).folds)
    assert page.count('<td data-label="check">') == len(built[0].verdicts)


def test_a_report_of_one_case_is_whole(tmp_path):
    build(load_report(write(tmp_path, row("rate"))), tmp_path)
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    assert "1 of 1 check holds." in page
    assert page.count('<td class="fold pass c1">') == 1 and "✓ 1/1" in page
    assert (tmp_path / "figures" / "matrix.png").stat().st_size > 5000


@pytest.mark.parametrize("kind, upper, text", [("equal", None, "0.5"), ("at-least", None, "≥ 0.5"),
                                               ("at-most", None, "≤ 0.5"), ("between", 2.0, "0.5 to 2")])
def test_one_sided_expectations_show_their_side(tmp_path, kind, upper, text):
    given = {"kind": kind} | ({"upper": upper} if upper else {})
    cell = fold(tmp_path, row("rate", expected=0.5) | given)
    assert words.expectation(cell.worst) == text
    assert f'<td data-label="expected">{text}</td>' in front_page(tmp_path, row("rate", expected=0.5) | given)


def texts(monkeypatch, report):
    """[(text, its box in pixels)] of the picture, and the size of the picture."""
    found = []

    def look(picture, _):
        renderer = picture.canvas.get_renderer()
        found.extend((item.get_text(), item.get_window_extent(renderer)) for item in picture.axes[0].texts)
        found.append(("", picture.bbox))

    monkeypatch.setattr(matrix_figure, "save", look)
    matrix_figure.draw_matrix(grid(report), headline(report), None)
    return found[:-1], found[-1][1]


def many_columns(folder):
    names = ["plain"] + [f"a-method-with-a-long-name-{index}" for index in range(15)]
    rows = [row(f"check-{count}", variant=name) for name in names for count in range(100)]
    return write(folder, *rows, *(row("limit", "expected-fail", 4, variant=name) for name in names[::2]))


@pytest.mark.parametrize("make", [lambda folder: fixture.write(folder, fixture.documents()),
                                  lambda folder: write(folder, row("rate")), many_columns])
def test_no_text_of_the_picture_covers_another(monkeypatch, tmp_path, make):
    boxes, whole = texts(monkeypatch, load_report(make(tmp_path)))
    for text, box in boxes:
        assert whole.x0 <= box.x0 and box.x1 <= whole.x1 and whole.y0 <= box.y0 and box.y1 <= whole.y1, text
    for (first, one), (second, other) in itertools.combinations(boxes, 2):
        assert not one.overlaps(other), f"{first} covers {second}"
