"""Words, sums, bars, residuals and Markdown, each against numbers worked out by hand."""

import io

import numpy as np
import pytest

from analysis import bar, markdown, model, words
from analysis.load import load_report
from analysis.residual import BUDGET, STANDARD, residual
from analysis.summary import count, faults, headline, rows
from analysis.sweep_figures import columns, power_line, resolved
from analysis.table import may_colour
from analysis.tests import fixture


@pytest.mark.parametrize("value, text", [(1234.5, "1234"), (1.2e-7, "1.2×10⁻⁷"), (-0.5, "−0.5"), (None, "–"),
                                         (float("nan"), "–"), (0.0, "0")])
def test_number(value, text):
    assert words.number(value) == text


@pytest.mark.parametrize("value, error, text", [(1.00119, 0.00104, "1.0012 ± 0.0010"),
                                                (12.0, 3.0, "12.0 ± 3.0"),
                                                (120.0, 30.0, "120 ± 30"), (1.0, None, "1"),
                                                (1e-15, 0.0, "1×10⁻¹⁵"), (1492212.0, 1330.0, "(1.4922 ± 0.0013)×10⁶"),
                                                (-4.52e-4, 2e-7, "(−4.5200 ± 0.0020)×10⁻⁴"), (2e-12, 3e-12, "(2.0 ± 3.0)×10⁻¹²")])
def test_with_error(value, error, text):
    assert words.with_error(value, error) == text


def test_units_seconds_size():
    assert words.units("mass length^2 time^-2") == "mass length² time⁻²"
    assert words.units("1") == ""
    assert [words.seconds(x) for x in (0.012, 1.53, 83)] == ["12 ms", "1.53 s", "1 min 23 s"]
    assert words.seconds(7260) == "2 h 1 min"
    assert words.seconds(None) == "–"
    assert [words.size(x) for x in (999, 1.2e6, 3e9)] == ["999 B", "1.2 MB", "3 GB"]


def test_slug_is_safe_and_keeps_names_apart():
    assert words.slug("equilibrium-gas", "cba") == "equilibrium-gas--cba"
    assert words.slug("a/b") != words.slug("a b")
    assert "/" not in words.slug("../../etc") and len(words.slug("x" * 500)) < 120


def test_headline_counts(folder):
    report = load_report(folder)
    assert headline(report) == ("42 of 44 checks hold; 1 fails; 1 inconclusive; 2 known limits confirmed; "
                                "1 known limit not seen; 2 of 3 planted faults caught")
    assert sum(count(report.verdicts).values()) == len(report.verdicts)


def test_cell_shows_its_worst_verdict(folder):
    table = rows(load_report(folder).verdicts, lambda item: (item.case, item.point))
    cell = table["equilibrium-gas", "2d-nu-0.25"]["dsmc"]
    assert (cell.verdict, cell.shown.check, len(cell.verdicts)) == ("expected-fail", "collision-rate", 2)


def test_a_fault_is_caught_by_one_check(folder):
    assert faults(load_report(folder).mutants) == {
        "cross-section-plus-5-percent": True, "acceptance-inverted": True, "offset-dropped": False}


def judged(**more):
    row = fixture.verdict("case", "cba", "2d", "check", **more)
    return model.Verdict(**row | {"budget_parts": model.Budget(**row["budget_parts"])})


def test_bar_shares_the_budget():
    drawn = bar.budget_bar(judged(value=1.0, expected=1.0025, stderr=0.001))   # half of 0.005
    assert [name for name, _ in drawn.segments] == ["statistical", "systematic"]
    assert drawn.segments[0][1] == pytest.approx(4 * drawn.segments[1][1])
    assert drawn.mark == pytest.approx(0.5 * sum(width for _, width in drawn.segments))
    assert not drawn.beyond


def test_bar_ends_far_deviations_at_its_end():
    drawn = bar.budget_bar(judged(value=2.0))
    assert drawn.beyond and drawn.mark <= 100
    assert bar.budget_bar(judged(value=None, stderr=None)) is None


def test_residuals_choose_their_unit():
    axis = model.Axis("rate", "time^-1", False)
    points = model.Points("", [1.0, 2.0], [1.1, 2.0], [0.05, 0.0], [1.0, 2.0])
    values, errors, label = residual(points, axis, judged())
    assert label == STANDARD and errors is None
    assert values[0] == pytest.approx(2) and np.isnan(values[1])
    bare = model.Points("", [1.0], [1.1], [], [1.0])
    values, errors, label = residual(bare, axis, judged())
    assert label == BUDGET and errors is None and values == pytest.approx(20)
    other = residual(bare, model.Axis("length", "length", False), judged())
    assert other[0] == pytest.approx(0.1) and other[2] == "residual [length]"


def test_sweep_columns_leave_out_the_unknown(folder):
    sweeps = load_report(folder).sweeps
    knob, error, stderr, _ = columns(sweeps[2])
    assert knob.tolist() == [1, 4] and error.size == stderr.size == 2
    knob, error, stderr, _ = columns(sweeps[0])
    assert resolved(error, stderr).tolist() == [False, False, True, True, True]
    ends, line = power_line(knob, error, 2.0)
    assert line == pytest.approx(0.01 * ends**2)


def test_markdown_is_small_and_safe():
    text = markdown.render(fixture.README)
    assert "<h3>Equilibrium gas</h3>" in text and "<em>periodic</em>" in text
    assert "<strong>nothing</strong>" in text
    assert '<a href="https://example.org/enskog">Enskog</a>' in text
    assert "<li>pressure with the contact value</li>" in text and "<td>Enskog</td>" in text
    assert "restitution = 1.0  # &lt;elastic&gt;" in text
    assert "<img" not in text and "javascript" not in text and "a file" in text


def test_colour_only_on_a_free_terminal(monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.delenv("OMPI_COMM_WORLD_SIZE", raising=False)
    assert may_colour(Terminal()) and not may_colour(io.StringIO())
    monkeypatch.setenv("OMPI_COMM_WORLD_SIZE", "2")
    assert not may_colour(Terminal())
    monkeypatch.delenv("OMPI_COMM_WORLD_SIZE")
    monkeypatch.setenv("NO_COLOR", "1")
    assert not may_colour(Terminal())
