"""A report against an earlier one."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

from analysis.against import changed_verdicts, compare, cost_ratios, moved_values
from analysis.load import load_verdicts
from analysis.tests import fixture

ROOT = Path(__file__).parents[2]


def pair(folder, key, **changes):
    """(now, before, key) of one report, with one check of it changed now."""
    before = load_verdicts(folder)
    key = next(known for known in before if known[3] == key)
    return before | {key: replace(before[key], **changes)}, before, key


def test_a_report_against_itself_says_that_nothing_changed(folder):
    verdicts = load_verdicts(folder)
    text = compare(verdicts, verdicts)
    assert "verdicts that changed: none" in text and "values that moved: none" in text
    assert "1.00 x  all runs of both" in text


def test_verdicts_that_changed_came_or_went(folder):
    now, before, key = pair(folder, "collision-rate", verdict="fail")
    gone = dict(now)
    del gone[key]
    old = before[key].verdict
    assert changed_verdicts(now, before) == [f"{old} -> fail  {' / '.join(key)}"]
    assert changed_verdicts(gone, before) == [f"{old} -> absent  {' / '.join(key)}"]
    assert changed_verdicts(before, gone) == [f"absent -> {old}  {' / '.join(key)}"]


def test_a_value_moves_by_more_than_four_standard_errors(folder):
    known = load_verdicts(folder)
    error = next(verdict for key, verdict in known.items() if key[3] == "collision-rate").stderr
    for errors, lines in ((5.5, 0), (5.8, 1)):   # of one; the difference has sqrt(2)
        now, before, key = pair(folder, "collision-rate")
        now[key] = replace(now[key], value=before[key].value + errors * error)
        assert len(moved_values(now, before)) == lines


def test_a_value_without_an_error_bar_may_not_move_at_all(folder):
    now, before, key = pair(folder, "collision-rate", stderr=0.0)
    before[key] = now[key]
    now[key] = replace(now[key], value=now[key].value * (1 + 1e-15))
    assert "no error bar" in moved_values(now, before)[0]


def test_costs_are_those_of_runs_not_of_checks(folder):
    before = load_verdicts(folder)
    now = {key: replace(verdict, cpu_seconds=2 * (verdict.cpu_seconds or 0)) for key, verdict in before.items()}
    runs = {verdict.run: verdict.cpu_seconds or 0 for verdict in before.values()}
    lines = cost_ratios(now, before)
    assert lines[0] == f"2.00 x  all runs of both: {sum(runs.values()):.1f} -> {2 * sum(runs.values()):.1f} CPU s"
    assert all(line.startswith("2.00 x") for line in lines) and len(lines) > 1


def test_the_command_names_what_is_missing(folder, tmp_path):
    done = subprocess.run([sys.executable, "-m", "analysis", "against", folder, folder], cwd=ROOT, text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0 and "verdicts that changed: none" in done.stdout
    empty = tmp_path / "empty"
    empty.mkdir()
    done = subprocess.run([sys.executable, "-m", "analysis", "against", folder, empty], cwd=ROOT, text=True,
                          capture_output=True, check=False)
    assert done.returncode == 2 and "verdicts.json" in done.stderr


def test_the_fixture_has_what_these_tests_change():
    assert any(row["check"] == "collision-rate" for row in fixture.documents()["verdicts.json"])
