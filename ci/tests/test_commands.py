"""The two commands refuse bad input at once, with the allowed words and the nearest spelling."""
import os
import subprocess
from pathlib import Path

import pytest

CI = Path(__file__).resolve().parents[1]


def run(*command, **environment):
    words = [str(word) for word in command]
    return subprocess.run(words, capture_output=True, text=True, env=os.environ | environment)


def shell(script, **environment):
    return run("bash", "-c", f"source {CI}/lib.sh; {script}", **environment)


@pytest.mark.parametrize("command", ["test", "validate", "fuzz"])
def test_help(command):
    done = run(CI / command, "--help")
    assert done.returncode == 0
    assert done.stdout.startswith(f"usage: ci/{command}")


@pytest.mark.parametrize("arguments, complaint", [
    (["validate", "--tier", "smok"], "tier 'smok'; did you mean 'smoke'? (allowed: smoke standard paper)"),
    (["validate", "--tier=hour"], "unknown tier 'hour' (allowed: smoke standard paper)"),
    (["validate", "--teir", "smoke"], "unknown option '--teir'; did you mean '--tier'?"),
    (["validate", "--tier"], "--tier needs a value"),
    (["validate", "--against", "nowhere"], "--against nowhere: no report is there (no verdicts.json)"),
    (["validate", "--jobs", "0"], "--jobs 0: a whole number from 1"),
    (["fuzz", "--minutes", "0"], "--minutes 0: a whole number from 1"),
    (["fuzz", "--minuts", "5"], "unknown option '--minuts'; did you mean '--minutes'?"),
    (["test", "--no-instal"], "unknown option '--no-instal'; did you mean '--no-install'?"),
])
def test_bad_input(arguments, complaint):
    done = run(CI / arguments[0], *arguments[1:])
    assert done.returncode == 2
    assert complaint in done.stderr


@pytest.mark.parametrize("a, b, distance", [("", "abc", 3), ("abc", "", 3), ("kitten", "sitting", 3)])
def test_edit_distance(a, b, distance):
    assert shell(f"edit_distance '{a}' '{b}'").stdout == f"{distance}\n"


def fake_dpkg(folder, *installed):
    """A dpkg-query that knows of `installed` alone."""
    program = folder / "dpkg-query"
    lines = [f"echo '{name} installed'" for name in installed]
    program.write_text("\n".join(["#!/bin/sh", *lines, "exit 1\n"]))
    program.chmod(0o755)
    return f"{folder}:{os.environ['PATH']}"


def test_missing_packages_are_named_and_not_installed(tmp_path):
    done = shell("install_packages no format", PATH=fake_dpkg(tmp_path, "cmake"))
    assert done.returncode == 2
    assert "apt-get install --no-install-recommends clang-format-14" in done.stderr


def test_nothing_missing_is_silent(tmp_path):
    path = fake_dpkg(tmp_path, "clang-format-14")
    done = shell("apt() { echo called; }; install_packages yes format", PATH=path)
    assert (done.returncode, done.stdout) == (0, "")


def test_package_lists_are_tried_twice():
    done = shell("sleep() { :; }; apt() { echo try; false; }; update_package_lists || echo gave up")
    assert done.stdout.split("\n") == ["try", "try", "gave up", ""]


def test_python_without_the_modules_is_passed_over(tmp_path):
    barren = tmp_path / "python3"
    barren.write_text("#!/bin/sh\nexit 1\n")
    barren.chmod(0o755)
    done = shell("find_python json", SANDGLASS_PYTHON=str(barren))
    assert done.returncode == 0
    assert done.stdout.strip() not in ("", str(barren))


def test_failed_step_shows_the_end_of_its_log(tmp_path):
    done = shell(f"logs={tmp_path}; step try 'trying' bash -c 'echo first; echo last >&2; exit 7'")
    assert done.returncode == 7
    assert done.stdout.startswith("trying ... failed with exit code 7")
    assert "  | first\n  | last\n" in done.stdout
    assert done.stdout.endswith(f"whole log: {tmp_path}/try.log\n")


def test_every_bug_of_the_list_still_finds_its_place():
    done = run(CI / "source-bugs", "--list")
    assert done.returncode == 0, done.stderr
    assert "gravity-of-steps-reversed" in done.stdout.split()


def test_unknown_source_bug():
    done = run(CI / "source-bugs", "--bug", "pair-with-itsel")
    assert done.returncode == 2
    assert "did you mean 'pair-with-itself'?" in done.stderr
