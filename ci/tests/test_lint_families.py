"""The lint of method names finds each way to ask for one, names its place, and is silent about a sound tree."""
import subprocess
from pathlib import Path

import pytest

LINT = Path(__file__).resolve().parents[1] / "lint-families"
FAMILY = """
family.name = "NAME";
family.presets = {{{"NAME", "the \\"Knudsen\\" limit"}, Options{}}, preset("PRESET", "with an offset")};
"""


def family(name, preset):
    return FAMILY.replace("NAME", name).replace("PRESET", preset)


SOUND = {
    "sim/scene/method/families.cpp": "all = {&dsmc_family(), &hard_balls_family()};\n",
    "sim/scene/method/options.hpp": "using MethodOptions = std::variant<DsmcOptions, HardBallsOptions>;\n",
    "sim/run/families.cpp": 'builders = {{"dsmc", a}, {"hard-balls", b}};\n',
    "sim/scene/method/dsmc.cpp": family("dsmc", "cba"),
    "sim/scene/method/hard_balls.cpp": family("hard-balls", "hard-disks"),
    "sim/method/dsmc/family.cpp": "if (std::get_if<DsmcOptions>(&options)) {}\n",
    "sim/run/plan.cpp": "if (capabilities(scene).weights) {}\n",
    "sim/run/run_test.cpp": 'if (scene.method.preset == "cba") {}\n',
    "validation/suite/case.hpp": "// dsmc, as in \"dsmc\"\n",
    "analysis/pages.py": '"""Like "dsmc"."""\nimport json\n',
    "analysis/templates/page.html": "<p>{{ method }}</p>\n",
    "ci/build": "#!/usr/bin/env python3\nprint()\n",
}


@pytest.fixture
def lint(tmp_path):
    def run(path=None, text=None):
        for name, content in (SOUND | ({path: text} if path else {})).items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(content)
        done = subprocess.run([LINT, tmp_path], capture_output=True, text=True)
        return done.returncode, done.stdout
    return run


def test_sound_tree_passes(lint):
    status, text = lint()
    assert (status, text) == (0, "no test of cba, dsmc, hard-balls, hard-disks outside their families\n")


@pytest.mark.parametrize("line, words", [
    ('if (name == "cba") {}', 'the method name "cba"'),
    ('plan("hard-disks");', 'the method name "hard-disks"'),
    ("if (method.preset == wanted) {}", "'preset =='"),
    ("if (wanted != scene.method.preset) {}", "'!= scene.method.preset'"),
    ("if (method_family(f(x)) == wanted) {}", "'method_family(f(x)) =='"),
    ("if (wanted == method_family(scene)) {}", "'== method_family('"),
    ("if (family_of(scene.method).name != wanted) {}", "'family_of(scene.method).name !='"),
    ("if (wanted == family_of(method).name) {}", "'== family_of('"),
    ("switch (method.options.index()) {}", "'options.index('"),
    ("std::holds_alternative<SoftOptions>(o);", "'holds_alternative<SoftOptions'"),
    ("std::get_if<SoftOptions>(&o);", "'get_if<SoftOptions'"),
    ("std::get<HardBallsOptions>(o);", "'HardBallsOptions'"),
    ("if (is_hard_balls(scene)) {}", "'is_hard_balls'"),
])
def test_asking_for_a_name_is_found(lint, line, words):
    status, text = lint("sim/run/wrong.cpp", f"\n{line}\n")
    assert status == 1
    assert f"sim/run/wrong.cpp:2: {words} outside the family's files; ask for a capability" in text


@pytest.mark.parametrize("path, text, words", [
    ("validation/check/wrong.hpp", None, "validation/check/wrong.hpp:1: the method name"),
    ("sim/method/wrong.cpp", None, "sim/method/wrong.cpp:1: the method name"),
    ("analysis/wrong.py", 'import json\nif method == "cba":\n    pass\n', "analysis/wrong.py:2: the method name"),
    ("ci/wrong", '#!/usr/bin/env python3\nnames = ["dsmc"]\n', "ci/wrong:2: the method name"),
    ("analysis/templates/wrong.html", "<p>\n{% if method == 'cba' %}\n", "wrong.html:2: the method name"),
    ("sim/method/dsmc/wrong.cpp", None, None),
    ("sim/scene/method/hard_balls_keys.cpp", None, None),
    ("analysis/tests/wrong.py", 'method = "cba"\n', None),
])
def test_only_a_familys_files_and_tests_may(lint, path, text, words):
    status, output = lint(path, text or 'if (name == "cba") {}\n')
    assert status == (1 if words else 0), output
    assert (words or "") in output


@pytest.mark.parametrize("line", [
    'scene.method.preset = "cba";',
    'choose(scene.method, "cba");',
    '// if (preset == "cba")',
    '/* "dsmc",\n   is_dsmc */',
    "char quote = '\"'; // \"cba\"",
    'say("a dsmc run");',
    "if (method.preset.empty()) {}",
])
def test_setting_and_saying_are_no_tests(lint, line):
    status, text = lint("sim/run/right.cpp", line + "\n")
    assert status == 0, text


@pytest.mark.parametrize("path, text, complaint", [
    ("sim/scene/method/options.hpp", "using MethodOptions = std::variant<DsmcOptions>;\n",
     "sim/scene/method/families.cpp:1: 2 families, but 1 types of options in sim/scene/method/options.hpp"),
    ("sim/scene/method/options.hpp", "\n", "2 families, but 0 types of options"),
    ("sim/scene/method/families.cpp", "\n", "sim/scene/method/families.cpp:1: 0 families, but 2 types"),
    ("sim/scene/method/dsmc.cpp", 'auto name = "dsmc";\n', "sim/scene/method/dsmc.cpp:1: no name and presets found"),
])
def test_lists_that_do_not_fit_are_reported(lint, path, text, complaint):
    status, output = lint(path, text)
    assert status == 1
    assert complaint in output
