"""The command line as a user meets it: what it prints, writes and returns. Needs build/release/sandglass."""

import csv
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import time
import tomllib

import h5py
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "build" / "release" / "sandglass"

SCENE = """
run = { seed = 1, duration = { steps = STEPS } }
domain = { dimension = 2, size = [40.0, 40.0] }
method = { preset = "cba", cell-size = 5.0, weight = 0.1, time-step = 0.4 }
[[species]]
area-fraction = 0.05
restitution = 0.9
[[observe]]
what = "energy"
every = { steps = 5 }
[[observe]]
what = "collisions"
every = { steps = 5 }
[output]
trajectory = { steps = 100 }
"""


def run(*arguments, folder=None, **options):
    command = [str(PROGRAM), *map(str, arguments)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120, check=False, **options)


def wait_for(path):
    deadline = time.monotonic() + 60
    while not path.exists() and time.monotonic() < deadline:
        time.sleep(0.001)
    assert path.exists()


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "gas.toml"
    path.write_text(SCENE.replace("STEPS", "500"))
    return path


def test_help_says_what_a_key_means():
    key = run("help", "wall.amplitude").stdout
    assert key.startswith("wall.amplitude\n") and "length" in key and "allowed" in key
    assert "species.restitution" in run("help", "restitution").stdout
    assert "species" in run("help").stdout
    wrong = run("help", "restituton")
    assert wrong.returncode == 2 and "did you mean 'restitution'?" in wrong.stderr


def completed(*words):
    script = 'source <("$0" completion bash); shift 0; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _sandglass; printf "%s\\n" "${COMPREPLY[@]}"'
    path = f"{PROGRAM.parent}:{os.environ['PATH']}"
    done = subprocess.run(["bash", "-c", script, str(PROGRAM), *words], capture_output=True, text=True, check=True,
                          env=os.environ | {"PATH": path})
    return done.stdout.split()


def test_the_shell_completes_commands_options_and_names():
    assert completed("sandglass", "re") == ["resume"]
    assert completed("sandglass", "run", "scene.toml", "--ov") == ["--overwrite"]
    assert completed("sandglass", "law", "haff-time-scale-") == ["haff-time-scale-sonine"]
    assert completed("sandglass", "validate", "homog") == ["homogeneous-cooling"]
    assert completed("sandglass", "new", "heap") == ["heap-on-a-table"]
    assert "bashcompinit" in run("completion", "zsh").stdout
    assert "did you mean 'bash'" in run("completion", "bas").stderr


def test_a_new_scene_can_be_planned_and_is_not_replaced(tmp_path):
    for entry in json.loads(run("list", "templates", "--json").stdout):
        assert run("new", entry["name"], folder=tmp_path).returncode == 0
        assert run("plan", entry["name"] + ".toml", folder=tmp_path).returncode == 0
    again = run("new", "pipe", folder=tmp_path)
    assert again.returncode == 2 and "--overwrite" in again.stderr
    assert "did you mean 'pipe'?" in run("new", "pip", folder=tmp_path).stderr


def test_settings_lie_over_the_scene_and_reach_the_record(scene, tmp_path):
    settings = ("--set", "species.restitution=0.5", "--set", "run.duration.steps=10")
    assert "10 steps" in run("plan", scene, *settings).stdout
    done = run("run", scene, *settings, "-o", tmp_path / "half.h5", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    with h5py.File(tmp_path / "half.h5") as record:
        resolved = tomllib.loads(record["/sandglass/scene"][()].decode())
    assert resolved["species"][0]["restitution"] == 0.5 and resolved["run"]["duration"] == {"steps": 10}


def test_a_setting_that_is_wrong_is_named(scene):
    done = run("run", scene, "--set", "species.restituton=0.5")
    assert done.returncode == 2
    assert "--set species.restituton=0.5" in done.stderr and "did you mean 'restitution'?" in done.stderr


@pytest.mark.parametrize("what", ["methods", "observers", "cases", "laws", "checks", "claims", "mutations", "templates"])
def test_every_list_has_names_and_summaries(what):
    entries = json.loads(run("list", what, "--json").stdout)
    assert len(entries) > 3
    assert all(entry["name"] and entry["summary"] for entry in entries)


def test_law_without_arguments_says_what_it_takes_and_how_to_try_it():
    card = run("law", "haff-time-scale")
    assert card.returncode == 0 and "restitution" in card.stdout and "needed in 2D" in card.stdout


@pytest.mark.parametrize("name", [law["name"] for law in json.loads(run("list", "laws", "--json").stdout or "[]")])
def test_what_a_law_says_to_try_works(name):
    card = run("law", name)
    lines = [line for line in card.stdout.splitlines() if line.startswith("try: sandglass ")]
    for line in lines:
        tried = run(*line.removeprefix("try: sandglass ").split())
        assert tried.returncode == 0, tried.stderr
    assert card.returncode == 0


def test_law_prints_value_units_and_source():
    arguments = "restitution=0.9 diameter=1 mass=1 temperature=1 area-fraction=0.25 dimension=2".split()
    law = json.loads(run("law", "haff-time-scale", *arguments, "--json").stdout)
    # sqrt(pi) d / (2 (1 - r^2) nu g sqrt(T/m)) with g = (1 - 7 nu/16)/(1 - nu)^2: Mueller 2001, Eq. (3.2).
    contact = (1 - 7 * 0.25 / 16) / 0.75**2
    assert law["value"] == pytest.approx(3.14159265358979**0.5 / (2 * 0.19 * 0.25 * contact), rel=1e-12)
    assert law["name"] == "haff-time-scale" and law["units"] == "time" and law["source"]


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["rnu"], "did you mean 'run'"),
        (["list", "lawz"], "did you mean 'laws'"),
        (["law", "haff-time-scal"], "did you mean 'haff-time-scale'"),
        (["law", "mean-speed", "dimension=two"], "key=number"),
        (["run", "nosuch.toml"], "No such file"),
        (["check", "nosuch.h5"], "No such file"),
        (["validate", "--tier", "smok"], "did you mean 'smoke'"),
        (["validate", "equilibrum-gas"], "did you mean 'equilibrium-gas'"),
        ([], "subcommand"),
    ],
)
def test_bad_input_says_what_to_do_and_returns_2(arguments, words, tmp_path):
    finished = run(*arguments, folder=tmp_path)
    assert finished.returncode == 2
    assert words in finished.stderr + finished.stdout


def test_run_check_and_export(scene, tmp_path):
    finished = run("run", scene.name, folder=tmp_path)
    assert finished.returncode == 0, finished.stderr
    assert "moves/s" in finished.stdout and finished.stderr == ""
    checked = run("check", "gas.h5", "--json", folder=tmp_path)
    names = {entry["check"] for entry in json.loads(checked.stdout)}
    assert names == {"haff-cooling", "cooling-per-collision"}
    for form, file in [("vtp", "gas.pvd"), ("xyz", "gas.xyz"), ("csv", "gas.csv"), ("mdanalysis", "gas.h5md")]:
        assert run("export", "gas.h5", "--format", form, folder=tmp_path).returncode == 0
        assert (tmp_path / file).stat().st_size > 0


def test_a_record_is_not_replaced_unasked(scene, tmp_path):
    assert run("run", scene.name, "--quiet", folder=tmp_path).stdout == ""
    before = (tmp_path / "gas.h5").read_bytes()
    refused = run("run", scene.name, folder=tmp_path)
    assert refused.returncode == 2 and "--overwrite" in refused.stderr
    assert (tmp_path / "gas.h5").read_bytes() == before
    assert run("run", scene.name, "--overwrite", folder=tmp_path).returncode == 0


@pytest.mark.parametrize("output,words", [("gas.toml", "is what the command reads"), ("/dev/null", "no regular file"),
                                          ("missing/gas.h5", "no such folder"), (".", "is a folder")])
def test_a_record_never_takes_the_place_of(output, words, scene, tmp_path):
    before = scene.read_bytes()
    refused = run("run", scene.name, "--overwrite", "-o", output, folder=tmp_path)
    assert refused.returncode == 2 and words in refused.stderr
    assert scene.read_bytes() == before and os.listdir(tmp_path) == ["gas.toml"]


def test_exports_replace_neither_their_record_nor_anything_unasked(scene, tmp_path):
    assert run("run", scene.name, "--quiet", folder=tmp_path).returncode == 0
    before = (tmp_path / "gas.h5").read_bytes()
    refused = run("export", "gas.h5", "--format", "csv", "--overwrite", "-o", "gas.h5", folder=tmp_path)
    assert refused.returncode == 2 and "is what the command reads" in refused.stderr
    assert (tmp_path / "gas.h5").read_bytes() == before
    (tmp_path / "gas-estimates.csv").write_text("mine")
    refused = run("export", "gas.h5", "--format", "csv", folder=tmp_path)
    assert refused.returncode == 2 and "gas-estimates.csv: exists already" in refused.stderr
    assert not (tmp_path / "gas.csv").exists() and (tmp_path / "gas-estimates.csv").read_text() == "mine"
    assert run("export", "gas.h5", "--format", "csv", "--overwrite", folder=tmp_path).returncode == 0


def test_record_of_a_scene_with_a_dot_in_its_name(scene, tmp_path):
    scene.rename(tmp_path / "nu-0.25.toml")
    assert run("run", "nu-0.25.toml", "--quiet", folder=tmp_path).returncode == 0
    assert sorted(os.listdir(tmp_path)) == ["nu-0.25.h5", "nu-0.25.toml"]


def test_two_runs_never_share_a_record(scene, tmp_path):
    scene.write_text(SCENE.replace("STEPS", "10000000").replace("{ steps = 100 }", "{ steps = 1000000 }"))
    first = subprocess.Popen([str(PROGRAM), "run", "gas.toml", "--quiet"], cwd=tmp_path, stderr=subprocess.PIPE)
    try:
        wait_for(tmp_path / "gas.checkpoint.h5.lock")
        refused = run("run", scene.name, "--overwrite", folder=tmp_path)
    finally:
        first.kill()
        first.wait()
    assert refused.returncode == 2 and "another command is writing it" in refused.stderr
    scene.write_text(SCENE.replace("STEPS", "10"))
    assert run("run", scene.name, "--quiet", folder=tmp_path).returncode == 0, "locks of killed runs hold nobody up"
    assert sorted(os.listdir(tmp_path)) == ["gas.h5", "gas.toml"]


def test_a_run_replaces_no_checkpoint_unasked_and_names_leftovers(scene, tmp_path):
    (tmp_path / "gas.checkpoint.h5").write_text("of a run that was killed")
    (tmp_path / "gas.h5.part-4711").write_text("of another")
    refused = run("run", scene.name, folder=tmp_path)
    assert refused.returncode == 2 and "sandglass resume gas.checkpoint.h5" in refused.stderr
    assert (tmp_path / "gas.checkpoint.h5").read_text() == "of a run that was killed"
    (tmp_path / "gas.h5.part-4711").write_text("of another")
    finished = run("run", scene.name, "--overwrite", folder=tmp_path)
    assert finished.returncode == 0 and "gas.h5.part-4711" in finished.stderr
    assert sorted(os.listdir(tmp_path)) == ["gas.h5", "gas.toml"]


def test_what_appears_at_the_record_meanwhile_is_kept(scene, tmp_path):
    scene.write_text(SCENE.replace("STEPS", "30000").replace("{ steps = 100 }", "{ steps = 10000 }"))
    started = subprocess.Popen([str(PROGRAM), "run", "gas.toml", "--quiet"], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    wait_for(tmp_path / "gas.checkpoint.h5.lock")
    (tmp_path / "gas.h5").write_text("mine")
    message = started.communicate(timeout=120)[1]
    assert started.returncode == 0 and "gas-1.h5" in message
    assert (tmp_path / "gas.h5").read_text() == "mine" and (tmp_path / "gas-1.h5").stat().st_size > 1000


def test_an_event_trace_replaces_no_scene(tmp_path):
    text = HARD_DISKS.replace("events.csv", "disks.toml")
    (tmp_path / "disks.toml").write_text(text)
    refused = run("run", "disks.toml", "--overwrite", folder=tmp_path)
    assert refused.returncode == 2 and "is what the command reads" in refused.stderr
    assert (tmp_path / "disks.toml").read_text() == text


def test_plan_says_what_is_left_out(scene, tmp_path):
    plan = json.loads(run("plan", scene.name, "--json", folder=tmp_path).stdout)
    assert "gravity" in plan["left_out"] and "trajectory" in plan["used"]
    assert plan["steps"] == 500


def test_more_particles_than_fit_are_refused_before_anything_is_taken(scene, tmp_path):
    text = SCENE.replace("STEPS", "5").replace("weight = 0.1", "weight = 1e-10")
    scene.write_text(text.replace("area-fraction = 0.05", "count = 100000000000"))
    begun = time.monotonic()
    refused = run("run", scene.name, "--quiet", folder=tmp_path)
    assert refused.returncode == 2 and "do not fit into memory" in refused.stderr
    assert time.monotonic() - begun < 10 and [item.name for item in tmp_path.iterdir()] == ["gas.toml"]
    assert "; this machine has" in run("plan", scene.name, folder=tmp_path).stdout


def test_hostile_scenes_are_refused_at_once(scene, tmp_path):
    text = SCENE.replace("STEPS", "5")
    scene.write_text(text + '[[observe]]\nwhat = "energy"\n' * 200000)
    begun = time.monotonic()
    many = run("plan", scene.name, folder=tmp_path)
    assert many.returncode == 2 and "at most 1000 are allowed" in many.stderr
    assert len(many.stderr.splitlines()) == 1
    scene.write_text(".".join(["a"] * 30000) + " = 1\n")
    assert run("plan", scene.name, folder=tmp_path).returncode == 2
    assert time.monotonic() - begun < 30


def test_as_many_cells_as_are_documented_can_be_planned(scene, tmp_path):
    most = ("--set", "method.cell-size={}", "--set")
    planned = run("plan", scene, *most, "method.cells=[46340,46340]", "--json", folder=tmp_path)
    assert json.loads(planned.stdout)["cells"] == 46340**2
    refused = run("plan", scene, *most, "method.cells=[46341,46341]", folder=tmp_path)
    assert refused.returncode == 2 and "at most 2147483647 are allowed" in refused.stderr


def test_summary_says_what_no_mean_can(scene, tmp_path):
    scene.write_text(SCENE.replace("STEPS", "500"))
    lines = run("run", scene.name, folder=tmp_path).stdout.splitlines()
    energy = next(line for line in lines if line.startswith("energy"))
    assert "drifts: no steady mean" in energy or "independent samples" in energy


def test_plan_of_a_box_that_a_source_fills_shows_no_infinite_number(tmp_path):
    text = SCENE.replace("{ steps = STEPS }", "{ collisions-per-particle = 20.0 }").replace("area-fraction = 0.05", "count = 0")
    (tmp_path / "pour.toml").write_text(text + "[[source]]\nrate = 1.0\ncentre = [20.0, 20.0]\n")
    assert "unknown" in run("plan", "pour.toml", folder=tmp_path).stdout
    assert not {"nan", "-nan", "inf"} & set(run("plan", "pour.toml", folder=tmp_path).stdout.split())
    assert json.loads(run("plan", "pour.toml", "--json", folder=tmp_path).stdout)["steps"] is None


def test_check_of_a_scene_that_no_law_knows_announces_no_list(tmp_path):
    text = SCENE.replace("STEPS", "10").replace("40.0]", '40.0], sides = { x = "open" }').replace("restitution = 0.9", "restitution = 0.5")
    (tmp_path / "open.toml").write_text(text)
    assert run("run", "open.toml", "--quiet", folder=tmp_path).returncode == 0
    refused = run("check", "open.h5", folder=tmp_path)
    assert refused.returncode == 2
    assert "sandglass list checks" in refused.stderr and "and run again" not in refused.stderr


def test_warnings_of_the_plan_are_those_of_the_run_its_record_and_check(scene, tmp_path):
    sparse = ("--set", "method.weight=20.0", "--set", "run.duration.steps=10")
    planned = json.loads(run("plan", scene, *sparse, "--json", folder=tmp_path).stdout)["warnings"]
    assert any("particles per cell" in warning for warning in planned)
    done = run("run", scene, *sparse, "-o", "sparse.h5", folder=tmp_path)
    checked = run("check", "sparse.h5", folder=tmp_path)
    with h5py.File(tmp_path / "sparse.h5") as record:
        assert [text.decode() for text in record["/sandglass"].attrs["warnings"]] == planned
    for warning in planned:
        assert f"warning: {warning}" in done.stderr and f"warning: {warning}" in checked.stdout


def test_plan_flags_what_does_not_fit_and_shows_no_part_of_a_step(scene, tmp_path):
    huge = run("plan", scene, "--set", "method.weight=1e-8", folder=tmp_path)
    assert "warning" in huge.stdout and "does not fit into the memory of this machine" in huge.stdout
    long = ("--set", "run.duration={}", "--set", "run.duration.time=0.001", "--set", "method.time-step={collisions-per-particle=0.5}")
    planned = json.loads(run("plan", scene, *long, "--json", folder=tmp_path).stdout)
    assert planned["steps"] == 1 and any("the only step is cut" in warning for warning in planned["warnings"])
    assert run("run", scene, *long, "-o", "short.h5", "-q", folder=tmp_path).returncode == 0
    with h5py.File(tmp_path / "short.h5") as record:
        assert record["/sandglass/counters/steps"][0] == 1
    falling = run("plan", scene, "--set", "forces.gravity=[0.0,-1.0]", "--set", "domain.sides.y=specular", folder=tmp_path)
    assert "at the temperature of the start" in falling.stdout


def test_a_check_says_what_a_budget_as_large_as_the_effect_needs(tmp_path):
    """README's scene with restitution 0.5: the budget of Haff's law was six times its time scale, and passed."""
    text = SCENE.replace("{ steps = STEPS }", "{ collisions-per-particle = 20.0 }").replace("restitution = 0.9", "restitution = 0.5")
    text = text.replace("{ steps = 5 }", "{ collisions-per-particle = 0.5 }").replace("[40.0, 40.0]", "[400.0, 400.0]")
    (tmp_path / "few.toml").write_text(text.replace("time-step = 0.4", "time-step = { collisions-per-particle = 0.1 }"))
    assert run("run", "few.toml", "-q", folder=tmp_path).returncode == 0
    checked = run("check", "few.h5", folder=tmp_path)
    assert checked.returncode == 1
    assert "haff-cooling: the" in checked.stdout and "run longer, with more particles or more replicas" in checked.stdout


MIXTURE = """
run = { seed = 1, replicas = 2, duration = { steps = 20 } }
domain = { dimension = 2, size = [40.0, 40.0] }
method = { preset = "event-driven", time-step = 0.1 }
species = [ { name = "large", count = 20, diameter = 2.0, mass = 4.0 }, { name = "small", count = 10, diameter = 0.5, mass = 0.25 } ]
initial.positions = "random-without-overlap"
[output]
trajectory = { steps = 10 }
checkpoint = { steps = 15 }
"""


def test_exports_carry_species_diameter_and_mass_of_a_mixture(tmp_path):
    (tmp_path / "mixture.toml").write_text(MIXTURE)
    assert run("run", "mixture.toml", "-q", folder=tmp_path).returncode == 0
    for form in ("vtp", "xyz", "csv", "mdanalysis"):
        assert run("export", "mixture.h5", "--format", form, folder=tmp_path).returncode == 0
    with h5py.File(tmp_path / "mixture.h5") as record:
        species = record["/particles/all/species/value"][0]
        diameter = record["/particles/all/diameter/value"][0]
        assert record["/particles/all/diameter"].attrs["units"].decode() == "length"
        assert list(record["/particles/all/mass/value"][0]) == [4.0 if kind == 0 else 0.25 for kind in species]
        assert list(record["/sandglass/seed"]) == [1, 1]   # of the scene; replicas differ by their number
    assert list(diameter) == [2.0 if kind == 0 else 0.5 for kind in species] and sorted(set(species)) == [0, 1]
    with h5py.File(tmp_path / "mixture.h5md") as exported:
        assert list(exported["/observables/diameter/value"][0]) == list(diameter)
        assert exported["/observables/mass/value"].shape == exported["/particles/trajectory/position/value"].shape[:2]
        assert list(exported["/observables/mass/time"]) == list(exported["/particles/trajectory/position/time"])
    lines = (tmp_path / "mixture.xyz").read_text().splitlines()
    assert "species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:species_index:I:1 " in lines[1]
    rows = [line.split() for line in lines[2:32]]
    assert [row[0] for row in rows] == ["H" if kind == 0 else "He" for kind in species]
    assert [float(row[7]) for row in rows] == list(diameter / 2)
    with (tmp_path / "mixture-particles.csv").open() as table:
        read = list(csv.DictReader(table))
    assert [float(row["diameter"]) for row in read[:30]] == list(diameter) and len(read) == 90
    frame = (tmp_path / "mixture-000000.vtp").read_text()
    assert frame.count('Name="diameter"') == 1 and 'Name="mass"' in frame and 'Name="species"' in frame


def test_a_table_of_a_checkpoint_holds_what_it_has(tmp_path):
    (tmp_path / "row.toml").write_text(ROW)
    assert run("run", "row.toml", "-q", folder=tmp_path).returncode == 3
    assert run("export", "row.checkpoint.h5", "--format", "csv", folder=tmp_path).returncode == 0
    assert len((tmp_path / "row.checkpoint.csv").read_text().splitlines()) == 6
    assert len((tmp_path / "row.checkpoint-particles.csv").read_text().splitlines()) == 4
    (tmp_path / "bare.toml").write_text(ROW.replace('observe = [ { what = "energy" } ]', "").replace("0.05 }", "0.9 }"))
    assert run("run", "bare.toml", "-q", folder=tmp_path).returncode == 0
    refused = run("export", "bare.h5", "--format", "csv", folder=tmp_path)
    assert refused.returncode == 2 and "neither series nor particles" in refused.stderr


ROW = """
run.duration = { time = 1.0 }
domain = { dimension = 2, size = [20.0, 20.0] }
method = { preset = "event-driven", time-step = 0.1 }
species = [ { restitution = 0.05 } ]
initial.positions = "given"
particle = [ { position = [9.0, 10.0], velocity = [1.0, 0.0] }, { position = [10.2, 10.0], velocity = [0.0, 0.0] },
             { position = [11.7, 10.0], velocity = [-1.0, 0.0] } ]
observe = [ { what = "energy" } ]
output.checkpoint = { steps = 2 }
"""


def test_a_broken_run_keeps_what_it_has_and_goes_on_with_what_mends_it(tmp_path):
    (tmp_path / "row.toml").write_text(ROW)
    broken = run("run", "row.toml", folder=tmp_path)
    assert broken.returncode == 3 and "inelastic collapse" in broken.stderr
    assert "kept in row.broken.h5, marked as broken" in broken.stderr
    assert "go on from the last checkpoint with: sandglass resume row.checkpoint.h5" in broken.stderr
    shown = run("check", "row.broken.h5", folder=tmp_path)
    assert "Traceback" not in shown.stderr and shown.returncode != 0
    with h5py.File(tmp_path / "row.broken.h5") as record:
        assert "inelastic collapse" in record["/sandglass"].attrs["broken"].decode()
        assert record["/sandglass/series/energy/value"].shape == (1, 5)
    refused = run("resume", "row.checkpoint.h5", "--set", "species.restitution=0.5", folder=tmp_path)
    assert refused.returncode == 2 and "in [species] it would" in refused.stderr
    guard = ("--set", "method.collapse-guard=contact-time", "--set", "method.contact-time=1e-3")
    mended = run("resume", "row.checkpoint.h5", *guard, "--set", "run.duration.time=1.5", folder=tmp_path)
    assert mended.returncode == 0, mended.stderr
    with h5py.File(tmp_path / "row.h5") as record:
        changes = [text.decode() for text in record["/sandglass"].attrs["changes"]]
        assert record["/sandglass/series/energy/value"].shape == (1, 16)
    assert len(changes) == 3 and changes[0].startswith("--set method.collapse-guard=contact-time, from step 4")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_is_heeded_within_a_step(tmp_path, number):
    """This step crosses cells for years."""
    fast = ROW.replace("velocity = [1.0, 0.0]", "velocity = [1e90, 1e90]").replace("0.05 }", "1.0 }")
    (tmp_path / "fast.toml").write_text(fast)
    started = subprocess.Popen([str(PROGRAM), "run", "fast.toml"], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    time.sleep(0.5)
    begun = time.monotonic()
    started.send_signal(number)
    words = started.communicate(timeout=60)[1]
    assert started.returncode == 3 and time.monotonic() - begun < 10
    assert words.startswith("stopping; again to end at once\n") and "stopped within the step" in words
    assert "'output.checkpoint' in the scene asks for some" in words


def test_interrupt_writes_a_checkpoint_that_resumes(tmp_path):
    (tmp_path / "gas.toml").write_text(SCENE.replace("STEPS", "150000").replace("{ steps = 100 }", "{ steps = 15000 }"))
    whole = run("run", "gas.toml", "-o", "whole.h5", "--quiet", folder=tmp_path)
    assert whole.returncode == 0
    started = subprocess.Popen([str(PROGRAM), "run", "gas.toml", "-o", "cut.h5"], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    time.sleep(0.2)
    started.send_signal(signal.SIGINT)
    message = started.communicate(timeout=60)[1]
    assert started.returncode == 3 and "sandglass resume cut.checkpoint.h5" in message
    assert run("resume", "cut.checkpoint.h5", "--quiet", folder=tmp_path).returncode == 0
    for name in ("whole", "cut"):
        assert run("export", f"{name}.h5", "--format", "xyz", folder=tmp_path).returncode == 0
    assert (tmp_path / "whole.xyz").read_bytes() == (tmp_path / "cut.xyz").read_bytes()


HARD_DISKS = """
run = { seed = 1, duration = { steps = 1000 } }
domain = { dimension = 2, size = [40.0, 40.0] }
method = { preset = "event-driven", time-step = 0.05 }
[[species]]
area-fraction = 0.4
[initial]
positions = "lattice"
[output]
event-trace = "events.csv"
checkpoint = { steps = 20 }
"""


def test_after_a_hard_kill_the_event_trace_repeats_nothing(tmp_path):
    whole, cut = tmp_path / "whole", tmp_path / "cut"
    for folder in (whole, cut):
        folder.mkdir()
        (folder / "disks.toml").write_text(HARD_DISKS)
    assert run("run", "disks.toml", "--quiet", folder=whole).returncode == 0
    started = subprocess.Popen([str(PROGRAM), "run", "disks.toml", "--quiet"], cwd=cut)
    while started.poll() is None and not (cut / "disks.checkpoint.h5").exists():
        time.sleep(0.001)
    started.kill()
    assert started.wait(timeout=60) == -signal.SIGKILL, "it was done before it could be killed"
    assert 0 < (cut / "events.csv").stat().st_size < (whole / "events.csv").stat().st_size
    assert run("resume", "disks.checkpoint.h5", "--quiet", folder=cut).returncode == 0
    assert (cut / "events.csv").read_bytes() == (whole / "events.csv").read_bytes()


def test_full_disk_is_named_and_leaves_nothing_half_written(scene, tmp_path):
    def little_room():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (50000, 50000))

    finished = run("run", scene.name, folder=tmp_path, preexec_fn=little_room)
    assert finished.returncode == 3
    assert "gas.h5" in finished.stderr and "File too large" in finished.stderr
    assert sorted(os.listdir(tmp_path)) == ["gas.toml"]


MPIRUN = shutil.which("mpirun.openmpi") or shutil.which("mpirun")
AS_ANYONE = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
             "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
             "OMPI_MCA_mpi_yield_when_idle": "1"}
REFUSAL = "started on 2 ranks"
needs_mpirun = pytest.mark.skipif(MPIRUN is None, reason="no mpirun here")


def run_on_ranks(count, *arguments, folder):
    command = [MPIRUN, "-n", str(count), str(PROGRAM), *map(str, arguments)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120, check=False,
                          env=os.environ | AS_ANYONE)


def same_states():
    loader = importlib.machinery.SourceFileLoader("same_states", str(ROOT / "ci" / "same-states"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("same_states", loader))
    loader.exec_module(module)
    return module


def assert_same_record(one, other):
    """All that a run works out, bit for bit."""
    compare = same_states()
    one, other = compare.datasets(one), compare.datasets(other)
    assert one.keys() == other.keys()
    assert not [name for name in one if compare.difference(one[name], other[name])]


@needs_mpirun
@pytest.mark.parametrize("ranks", [2, 7])
def test_ranks_give_the_record_of_one(scene, tmp_path, ranks):
    assert run("run", scene.name, "-o", "one.h5", "--quiet", folder=tmp_path).returncode == 0
    finished = run_on_ranks(ranks, "run", scene.name, "-o", "many.h5", folder=tmp_path)
    assert finished.returncode == 0, finished.stderr
    assert finished.stdout.count("many.h5: 1 replica(s)") == 1
    assert_same_record(tmp_path / "one.h5", tmp_path / "many.h5")
    with h5py.File(tmp_path / "many.h5") as file:
        assert file["sandglass/timings/ranks"][()] == ranks
        assert 1 <= file["sandglass/timings/imbalance"][()] < 2


@needs_mpirun
def test_ranks_that_are_stopped_leave_one_checkpoint_for_any_number(tmp_path):
    scene = SCENE.replace("STEPS", "4000").replace("[output]", "[output]\ncheckpoint = { steps = 100 }")
    (tmp_path / "gas.toml").write_text(scene)
    assert run("run", "gas.toml", "-o", "whole.h5", "--quiet", folder=tmp_path).returncode == 0
    process = subprocess.Popen([MPIRUN, "-n", "3", str(PROGRAM), "run", "gas.toml", "-o", "cut.h5"], cwd=tmp_path,
                               text=True, stderr=subprocess.PIPE, stdout=subprocess.PIPE, env=os.environ | AS_ANYONE)
    wait_for(tmp_path / "cut.checkpoint.h5")
    # Not mpirun itself, which kills them a second later, busy machine or not, and drops what they say.
    for rank in pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split():
        os.kill(int(rank), signal.SIGTERM)
    _, words = process.communicate(timeout=60)
    assert process.returncode != 0 and words.count("sandglass resume cut.checkpoint.h5") == 1
    assert run_on_ranks(2, "resume", "cut.checkpoint.h5", "--quiet", folder=tmp_path).returncode == 0
    assert_same_record(tmp_path / "whole.h5", tmp_path / "cut.h5")


@needs_mpirun
def test_a_rank_that_dies_ends_all_and_leaves_the_last_checkpoint(tmp_path):
    scene = SCENE.replace("STEPS", "100000").replace("[output]", "[output]\ncheckpoint = { steps = 100 }")
    (tmp_path / "gas.toml").write_text(scene)
    process = subprocess.Popen([MPIRUN, "-n", "2", str(PROGRAM), "run", "gas.toml"], cwd=tmp_path, text=True,
                               stderr=subprocess.PIPE, stdout=subprocess.PIPE, env=os.environ | AS_ANYONE)
    wait_for(tmp_path / "gas.checkpoint.h5")
    ranks = subprocess.run(["ps", "-o", "pid=", "--ppid", str(process.pid)], capture_output=True, text=True, check=True)
    os.kill(int(ranks.stdout.split()[-1]), signal.SIGKILL)
    _, words = process.communicate(timeout=60)
    assert process.returncode != 0 and "Killed" in words
    with h5py.File(tmp_path / "gas.checkpoint.h5") as file:
        assert "state" in file["sandglass"]


@needs_mpirun
def test_what_ranks_cannot_share_is_refused_once(scene, tmp_path):
    scene.write_text(scene.read_text().replace("cba", "hsmc"))
    refused = run_on_ranks(2, "run", scene.name, folder=tmp_path)
    assert refused.returncode == 2
    assert refused.stderr.count(REFUSAL) == 1 and refused.stderr.count("set 'run.replicas' to 2 or more") == 1
    listed = run_on_ranks(2, "list", "methods", folder=tmp_path)
    assert listed.returncode == 2 and listed.stderr.count(REFUSAL) == 1
    assert sorted(os.listdir(tmp_path)) == ["gas.toml"]


@needs_mpirun
def test_an_error_of_the_first_rank_alone_ends_all(scene, tmp_path):
    (tmp_path / "gas.h5").write_text("stands here already")
    refused = run_on_ranks(2, "run", scene.name, folder=tmp_path)
    assert refused.returncode == 2 and refused.stderr.count("--overwrite") == 1


TOO_FAST = """
run = { seed = 1, duration = { steps = 20 } }
domain = { dimension = 2, size = [20.0, 20.0] }
method = { preset = "collisionless", time-step = 0.5 }
initial = { positions = "given" }
species = [{ diameter = 0.1 }]
particle = [{ position = [1.0, 1.0], velocity = [0.1, 0.0] }, { position = [19.0, 19.0], velocity = [1e9, 0.0] }]
obstacle = [{ centre = [10.0, 10.0], radius = 1.0 }]
observe = [{ what = "energy", every = { steps = 5 } }]
"""


@needs_mpirun
def test_an_error_of_another_rank_alone_ends_all(tmp_path):
    """The fast particle is the second rank's."""
    (tmp_path / "fast.toml").write_text(TOO_FAST)
    broken = run_on_ranks(2, "run", "fast.toml", folder=tmp_path)
    assert broken.returncode == 3 and broken.stderr.count("a million times in one step") == 1


@needs_mpirun
def test_ranks_share_replicas(scene, tmp_path):
    scene.write_text(scene.read_text().replace("seed = 1", "seed = 1, replicas = 3").replace("cba", "hsmc"))
    assert run("run", scene.name, "-o", "one.h5", "--quiet", folder=tmp_path).returncode == 0
    assert run_on_ranks(2, "run", scene.name, "-o", "many.h5", "--quiet", folder=tmp_path).returncode == 0
    assert_same_record(tmp_path / "one.h5", tmp_path / "many.h5")


def test_replicas_side_by_side_give_the_record_of_one_after_the_other(scene, tmp_path):
    replicas = ("--set", "run.replicas=5", "-q")
    assert run("run", scene, *replicas, "-o", "one.h5", folder=tmp_path).returncode == 0
    for jobs in ("2", "9"):
        done = run("run", scene, *replicas, "-j", jobs, "-o", f"jobs-{jobs}.h5", folder=tmp_path)
        assert done.returncode == 0, done.stderr
        assert_same_record(tmp_path / "one.h5", tmp_path / f"jobs-{jobs}.h5")
    refused = run("run", scene, *replicas, "-j", "2", "--set", "output.checkpoint={steps=5}", "-o", "x.h5", folder=tmp_path)
    assert refused.returncode == 2 and "leave out -j or 'output.checkpoint'" in refused.stderr


def test_replicas_side_by_side_stop_when_asked_and_end_with_the_first_error(scene, tmp_path):
    started = subprocess.Popen([str(PROGRAM), "run", scene, "--set", "run.replicas=4", "--set", "run.duration.steps=10000000",
                                "-j", "2"], cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    time.sleep(0.5)
    started.send_signal(signal.SIGTERM)
    words = started.communicate(timeout=60)[1]
    assert started.returncode == 3 and "leave no checkpoint" in words
    (tmp_path / "row.toml").write_text(ROW.replace("output.checkpoint = { steps = 2 }", "run.replicas = 3"))
    broken = run("run", "row.toml", "-j", "3", folder=tmp_path)
    assert broken.returncode == 3 and "inelastic collapse" in broken.stderr


@needs_mpirun
def test_one_rank_runs_as_without_mpirun(scene, tmp_path):
    assert run_on_ranks(1, "run", scene.name, "-o", "mpi.h5", "--quiet", folder=tmp_path).returncode == 0
    assert run("run", scene.name, "-o", "plain.h5", "--quiet", folder=tmp_path).returncode == 0
    for name in ("mpi", "plain"):
        assert run("export", f"{name}.h5", "--format", "xyz", folder=tmp_path).returncode == 0
    assert (tmp_path / "mpi.xyz").read_bytes() == (tmp_path / "plain.xyz").read_bytes()


@pytest.mark.parametrize("rank, words", [("0", 1), ("1", 0)])
def test_copies_of_a_foreign_launcher_are_refused(scene, tmp_path, rank, words):
    """Slurm without MPI, as any launcher whose MPI is not the program's: each copy is alone as far as MPI knows."""
    environment = os.environ | {"SLURM_STEP_NUM_TASKS": "2", "SLURM_PROCID": rank}
    finished = run("run", scene.name, folder=tmp_path, env=environment)
    assert finished.returncode == 2
    assert finished.stderr.count(REFUSAL) == words


def test_without_a_launcher_mpi_is_not_started(tmp_path):
    """An MPI that cannot start stops the command under a launcher only."""
    no_mpi = os.environ | {"OMPI_MCA_pml": "no-such-layer"}
    assert run("list", "methods", folder=tmp_path, env=no_mpi).returncode == 0
    assert run("list", "methods", folder=tmp_path, env=no_mpi | {"PMIX_RANK": "0"}).returncode != 0
