"""The include lint finds what is wrong, names its place, and is silent about a sound tree."""
import subprocess
from pathlib import Path

import pytest

LINT = Path(__file__).resolve().parents[1] / "lint-includes"
TABLE = """
| room | holds | may include |
|---|---|---|
| `sim/base` | vectors | nothing of ours |
| `sim/physics` | rules | base |
| `sim/method` | what every method offers | base |
| `sim/method/<family>` | methods | base, physics, method |
| `sim/run` | assembly | all of sim |
| `validation/judge` | verdicts | base |
| `sim/program` | the command line | all |
"""
SOUND = {
    "docs/architecture.md": TABLE,
    "sim/base/vector.hpp": "#pragma once\n#include <vector>\n",
    "sim/base/CMakeLists.txt": "sandglass_room(base LINKS Eigen3::Eigen)\n",
    "sim/physics/rule.hpp": '#include "sim/base/vector.hpp"\n',
    "sim/physics/CMakeLists.txt": "sandglass_room(physics USES base)\n",
    "sim/method/method.hpp": '#include "sim/base/vector.hpp"\n',
    "sim/method/dsmc/step.cpp": '#include "sim/physics/rule.hpp"\n#include "sim/method/method.hpp"\n',
    "sim/base/made.cpp": '#include "sandglass_commit.hpp"\n',
    "sim/method/hsmc/step.hpp": "#pragma once\n",
    "validation/judge/judge.hpp": '#include "sim/base/vector.hpp"\n',
    "sim/program/main.cpp": '#include "validation/judge/judge.hpp"\n',
    "analysis/pages.py": "import json\n",
}


@pytest.fixture
def lint(tmp_path):
    def run(**wrong):
        for path, text in (SOUND | wrong.get("files", {})).items():
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_text(text)
        done = subprocess.run([LINT, tmp_path], capture_output=True, text=True)
        return done.returncode, done.stdout
    return run


def test_sound_tree_passes(lint):
    status, text = lint()
    assert status == 0, text


@pytest.mark.parametrize("path, text, complaint", [
    ("sim/base/wrong.cpp", '\n#include "sim/physics/rule.hpp"\n', "wrong.cpp:2: sim/base may not include"),
    ("sim/run/wrong.cpp", '#include "validation/judge/judge.hpp"\n', "wrong.cpp:1: sim/run may not include"),
    ("sim/run/wrong.cpp", "#include <validation/judge/judge.hpp>\n", "wrong.cpp:1: sim/run may not include"),
    ("validation/judge/wrong.hpp", '#include "sim/physics/rule.hpp"\n', "validation/judge may not include"),
    ("sim/method/dsmc/wrong.cpp", '#include "sim/method/hsmc/step.hpp"\n', "sim/method/dsmc may not include"),
    ("sim/physics/wrong.hpp", '#include "rule.hpp"\n', "no file 'rule.hpp'; includes are written from"),
    ("sim/cellar/wrong.hpp", '#include "sim/base/vector.hpp"\n', "'sim/cellar/wrong.hpp' lies in no room"),
    ("analysis/wrong.py", "from sim import method\n", "analysis/wrong.py:1: analysis reads files"),
    ("sim/base/CMakeLists.txt", "\nsandglass_room(base\n  USES physics)\n", "CMakeLists.txt:2: USES physics"),
    ("sim/base/vector.hpp", '#include "sim/base/vector.hpp"\n', "circle: sim/base/vector.hpp -> sim/base/ve"),
    ("docs/architecture.md", TABLE.replace("| base |", "| bse |"), "no room is called 'bse'"),
    ("docs/architecture.md", TABLE.replace("verdicts | base", "verdicts | physics"), "may never include"),
    ("docs/architecture.md", "nothing\n", "no table of rooms found"),
])
def test_what_is_wrong_is_named(lint, path, text, complaint):
    status, output = lint(files={path: text})
    assert status == 1
    assert complaint in output


def test_circle_of_two_files(lint):
    include = '#include "sim/base/{}.hpp"\n'.format
    status, output = lint(files={"sim/base/a.hpp": include("b"), "sim/base/b.hpp": include("a")})
    assert status == 1
    assert "circle: sim/base/a.hpp -> sim/base/b.hpp -> sim/base/a.hpp" in output
