"""Broken folders: one clear error with file, key and remedy."""

import copy
import json
import math
import subprocess
import sys
from pathlib import Path

import pytest

from analysis.errors import InputError
from analysis.load import load_report
from analysis.tests import fixture

ROOT = Path(__file__).parents[2]
CASE = "evidence/equilibrium-gas.json"


def figure(files):
    return files[CASE]["evidence"][0]["figures"][0]


BREAKAGES = {
    "missing key": (lambda f: f["verdicts.json"][3].pop("budget"),
                    "verdicts.json: [3]: key 'budget' is missing"),
    "unknown verdict": (lambda f: f["verdicts.json"][0].update(verdict="maybe"),
                        "verdicts.json: [0].verdict: 'maybe' is not one of pass, expected-fail"),
    "text for number": (lambda f: f["verdicts.json"][0].update(value="1.0"),
                        "[0].value: must be a number or null"),
    "flag for number": (lambda f: f["verdicts.json"][0].update(seed=True),
                        "[0].seed: must be a whole number"),
    "twice": (lambda f: f["verdicts.json"].append(f["verdicts.json"][0]), "appears twice"),
    "unequal arrays": (lambda f: figure(f)["points"][0]["y"].pop(),
                       f"{CASE}: evidence[0].figures[0].points[0].y: has 30 values where x has 31"),
    "short errors": (lambda f: figure(f)["points"][1]["error"].pop(), "points[1].error: has 30 values"),
    "unequal line": (lambda f: figure(f)["lines"][0]["x"].pop(), "lines[0].y: has 31 values where x has 30"),
    "other verdict": (lambda f: f[CASE]["evidence"][0].update(verdict="fail"),
                      "is 'fail' here and 'pass' in verdicts"),
    "no evidence": (lambda f: f[CASE]["evidence"].pop(), "stands in verdicts.json but not here"),
    "no file": (lambda f: f.pop(CASE), "No such file or directory; write the folder again"),
    "not an array": (lambda f: f.update({"sweeps.json": {}}), "sweeps.json: must be an array"),
}


@pytest.mark.parametrize("name", BREAKAGES)
def test_breakage_is_named(tmp_path, name):
    damage, message = BREAKAGES[name]
    files = copy.deepcopy(fixture.documents())
    damage(files)
    with pytest.raises(InputError) as caught:
        load_report(fixture.write(tmp_path, files))
    assert message in str(caught.value)
    assert "; " in str(caught.value), "a remedy follows"


@pytest.mark.parametrize("text, problem", [('[{"case": ', "not valid JSON"), ("[NaN]", "NaN is not a JSON"),
                                           ("\x00", "not valid JSON")])
def test_malformed_json_is_named(folder, text, problem):
    (folder / "verdicts.json").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=f"verdicts.json: .*{problem}"):
        load_report(folder)


def test_unknown_numbers_stay_unknown(folder):
    report = load_report(folder)
    unknown = next(item for item in report.verdicts if item.verdict == "inconclusive")
    assert unknown.value is None and unknown.share is None
    decay = next(item for case in report.cases for item in case.evidence if item.verdict.check == "haff")
    assert math.isnan(decay.figures[0].points[0].y[5])


def test_sweeps_mutants_and_ledger_may_be_absent(folder):
    (folder / "sweeps.json").unlink()
    (folder / "mutants.json").unlink()
    report = load_report(folder, folder / "no-ledger.toml")
    assert (report.sweeps, report.mutants, report.claims) == ([], [], [])


def test_ledger_is_read(folder):
    report = load_report(folder, fixture.ledger(folder))
    assert [claim.id for claim in report.claims] == ["BAR-2", "MUL-1", "GRE-1"]


def run(*words):
    command = [sys.executable, "-m", "analysis", *words]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


@pytest.mark.parametrize("command", ["report", "table"])
def test_bad_input_ends_with_two(folder, command):
    rows = json.loads((folder / "verdicts.json").read_text())
    rows[0].pop("case")
    (folder / "verdicts.json").write_text(json.dumps(rows))
    done = run(command, str(folder))
    assert done.returncode == 2
    assert done.stderr.startswith("error: verdicts.json: [0]: key 'case' is missing")
    assert "Traceback" not in done.stderr


def test_missing_folder_ends_with_two(tmp_path):
    done = run("report", str(tmp_path / "nowhere"))
    assert done.returncode == 2 and "nowhere" in done.stderr


def test_unwritable_folder_ends_with_two(folder):
    (folder / "figures").write_text("a file where a folder must be")
    done = run("report", str(folder))
    assert done.returncode == 2
    assert "figures: File exists; make the folder writable" in done.stderr
    assert "Traceback" not in done.stderr


def test_table_has_no_colour_in_a_pipe(folder):
    done = run("table", str(folder))
    assert done.returncode == 0
    assert "\033" not in done.stdout
    assert "42 of 44 checks hold" in done.stdout.splitlines()[-1]
