"""The package as pyproject.toml describes it, and the page that reads a record."""

import re
import tomllib

import h5py
import numpy as np

from analysis.tests.fixture import TOP

PROJECT = tomllib.loads((TOP.parent / "pyproject.toml").read_text(encoding="utf-8"))
PAGE = (TOP.parent / "docs" / "read-a-record.md").read_text(encoding="utf-8")


def test_every_file_of_the_package_is_installed():
    setup = PROJECT["tool"]["setuptools"]
    rooms = {str(path.parent.relative_to(TOP.parent)).replace("/", ".") for path in TOP.rglob("*.py")
             if "tests" not in path.parts}
    assert set(setup["packages"]) == rooms
    taken = {path for pattern in setup["package-data"]["analysis"] for path in TOP.glob(pattern)}
    assert taken == {path for path in TOP.rglob("*") if path.suffix in (".css", ".j2", ".js", ".toml")}


def test_every_import_is_a_dependency():
    named = {match[1] for path in TOP.rglob("*.py") if "tests" not in path.parts
             for match in re.finditer(r"^\s*(?:import|from) (\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)}
    known = {"numpy", "h5py", "matplotlib", "jinja2"}
    assert named & known == set(PROJECT["project"]["dependencies"]) & named
    assert set(PROJECT["project"]["dependencies"]) == known


def test_the_command_of_the_package_is_there():
    module, _, name = PROJECT["project"]["scripts"]["sandglass-analysis"].partition(":")
    assert callable(getattr(__import__(module, fromlist=[name]), name))


def test_the_version_is_that_of_the_program():
    text = (TOP.parent / "CMakeLists.txt").read_text(encoding="utf-8")
    assert PROJECT["project"]["version"] in text


def test_the_ten_lines_of_the_page_draw_a_record(tmp_path, monkeypatch):
    code = re.search(r"```python\n(.*?)```", PAGE, re.DOTALL)[1]
    body = [line for line in code.splitlines() if line and not re.match(r"(?:import|from) ", line)]
    assert len(body) <= 10
    time = np.linspace(0, 10, 20)
    with h5py.File(tmp_path / "cooling.h5", "w") as file:
        root = file.create_group("sandglass")
        root.attrs["schema"], root["scene"], root["seed"] = np.array([1, 3]), np.bytes_(""), np.array([1], np.uint64)
        for name in ("provenance", "counters", "timings", "estimates"):
            root.create_group(name)
        group = root.create_group("series/energy")
        group["value"], group["time"] = 5 * (1 + time[None] / 2) ** -2, time[None]
        group["step"], group["samples"] = np.arange(20)[None], np.array([20], np.uint64)
    monkeypatch.chdir(tmp_path)
    found = {}
    exec(code, found)
    assert abs(1 / found["slope"] - 2) < 1e-9
    assert (tmp_path / "haff.png").stat().st_size > 5000
