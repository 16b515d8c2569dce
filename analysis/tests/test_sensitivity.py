"""Smallest errors that a check would see, and keys that none sees."""

from dataclasses import replace

import pytest

from analysis.load import load_report
from analysis.sensitivity import detectable, reason, relative, rows
from analysis.tests import fixture


def loaded(folder, *verdicts):
    files = {"verdicts.json": list(verdicts),
             "evidence/gas.json": fixture.evidence([(item, []) for item in verdicts])}
    return load_report(fixture.write(folder, files)).verdicts


@pytest.fixture
def plain(tmp_path):
    return loaded(tmp_path, fixture.verdict("gas", "dsmc", "2d", "rate", "pass", 2.01, 0.01, 2.0))[0]


def with_parts(item, **parts):
    return replace(item, budget_parts=replace(item.budget_parts, **parts))


def test_budget_and_two_standard_errors(plain):
    item = with_parts(replace(plain, budget=0.05), statistical=0.04, reference=0.0, systematic=0.01)
    assert detectable(item) == pytest.approx(0.07)
    assert relative(item) == pytest.approx(0.035)
    both = with_parts(item, reference=0.03)   # four standard errors each: 0.01 and 0.0075
    assert detectable(both) == pytest.approx(0.05 + 2 * 0.0125)


def test_exact_values_have_their_budget_alone(plain):
    item = with_parts(replace(plain, budget=0.01, stderr=0.0), statistical=0.0, reference=0.0, systematic=0.01)
    assert detectable(item) == pytest.approx(0.01)


def test_what_has_no_such_error(plain):
    assert detectable(replace(plain, kind="at-least")) is None
    assert detectable(replace(plain, known_limit="the source says so")) is None
    assert detectable(replace(plain, budget=None)) is None
    assert relative(replace(plain, expected=0.0)) is None


def test_the_largest_part_is_the_reason(plain):
    assert reason(with_parts(plain, statistical=3.0, reference=1.0, systematic=1.0)) == "length of the run"
    assert reason(with_parts(plain, statistical=1.0, reference=3.0, systematic=1.0)) == "error of the reference"
    assert reason(with_parts(plain, statistical=1.0, reference=1.0, systematic=2.0, reason="few")) == "few"


def test_rows_are_checks_of_cases(tmp_path):
    sharp = fixture.verdict("gas", "dsmc", "2d", "rate", "pass", 2.01, 0.001, 2.0)
    wide = fixture.verdict("gas", "cba", "2d", "rate", "pass", 2.01, 0.1, 2.0)
    zero = fixture.verdict("gas", "dsmc", "2d", "drift", "pass", 1e-15, 0.0, 0.0)
    found = rows(loaded(tmp_path, sharp, wide, zero))
    assert [(row.case, row.check) for row in found] == [("gas", "rate")]
    assert (found[0].sharpest.variant, found[0].widest.variant) == ("dsmc", "cba")
    assert not found[0].is_sharp


def test_the_page_lists_keys_that_no_verdict_sees(built):
    page = (built[1] / "mutants.html").read_text(encoding="utf-8")
    unseen = page.partition("Keys that no verdict sees")[2].partition("<details>")[0]
    assert "For 1 of 3 a verdict moved" in unseen
    assert "method.random-offset" in unseen and "wall.temperature" in unseen
    assert "species.restitution" not in unseen
    assert "Smallest errors that would be seen" in page
