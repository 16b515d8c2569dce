"""What a case page groups: checks, exact identities, what the runs of a check say alike; colours of methods."""

import math

import pytest

from analysis import explain, words
from analysis.checks import CheckGroup
from analysis.model import Budget, Evidence, Verdict
from analysis.plotting import METHODS, method_look
from analysis.tests import fixture
from analysis.verdict_figure import signed_share


def group(*rows):
    found = [Verdict(**row | {"budget_parts": Budget(**row["budget_parts"])}) for row in rows]
    return CheckGroup("check", [Evidence(item, "", []) for item in found])


def row(**more):
    return fixture.verdict("case", "cba", "2d", "check", **more)


def test_an_identity_is_exact_in_every_run():
    tiny = {"value": 4e-17, "stderr": 0.0, "expected": 0.0}
    assert group(row(**tiny), row(**tiny | {"value": 0.0})).is_identity
    assert group(row(**tiny | {"expected": 1e-9, "kind": "at-most"})).is_identity
    assert not group(row(**tiny), row(**tiny | {"value": 1e-3})).is_identity
    assert not group(row(**tiny | {"stderr": 1e-18})).is_identity
    assert not group(row(**tiny | {"verdict": "fail"})).is_identity
    assert not group(row(value=1.0, stderr=0.0, expected=1.0)).is_identity
    seen = Evidence(group(row(**tiny)).verdicts[0], "", [object()])
    assert not CheckGroup("check", [seen]).is_identity


@pytest.mark.parametrize("texts, shared", [
    (["the time scale against Haff"] * 2, "the time scale against Haff"),
    (["slope of both sides at the end; left 0.1", "slope of both sides at the end; left 0.2"], "slope of both sides at the end"),
    (["worst of six velocity moments (s4)", "worst of six velocity moments (s6)"], "worst of six velocity moments"),
    (["rate", "rate of collisions"], "rate"), (["one", "other"], "one")])
def test_a_check_says_what_its_runs_say_alike(texts, shared):
    assert group(*(row(summary=text) for text in texts)).summary == shared


def test_deviations_have_the_side_of_the_value():
    assert signed_share(group(row(value=1.0, expected=1.005)).verdicts[0]) == pytest.approx(-1)
    assert signed_share(group(row(value=1.0025, expected=1.0)).verdicts[0]) == pytest.approx(0.5)
    assert signed_share(group(row(value=None)).verdicts[0]) is None
    exact = row(value=1.0, expected=0.0) | {"budget": 0.0, "deviation": 1.0}
    assert signed_share(group(exact).verdicts[0]) == math.inf


def test_methods_of_a_picture_differ_in_colour_or_marker():
    others = METHODS + ["new", "newer"]
    looks = [tuple(method_look(name, others).values()) for name in others]
    assert len(set(looks)) == len(looks)
    assert method_look("hsmc")["color"] != method_look("hsmc-ramp", ["hsmc", "hsmc-ramp"])["color"]


def test_expectations_have_the_digits_of_the_value():
    item = group(row(value=1.49212e6, stderr=1330.0, expected=1.485713e6)).verdicts[0]
    assert words.with_error(item.value, item.stderr) == "(1.4921 ± 0.0013)×10⁶"
    assert words.expectation(item) == "1.4857×10⁶"
    assert words.expectation(group(row(value=0.31, stderr=0.02, expected=1 / 3)).verdicts[0]) == "0.333"


def test_sentences_of_the_judge_take_our_notation():
    assert words.said("deviation 3.58e-15 within budget 5.5e+03, -0.4 +- 1e-05") == (
        "deviation 3.58×10⁻¹⁵ within budget 5.5×10³, −0.4 ± 1×10⁻⁵")
    assert words.said("dsmc-bird, nu-0.25") == "dsmc-bird, nu-0.25"


def test_scenes_are_told_in_words():
    assert explain.describe('[domain]\nsize = [20.0, 10.0]\n[[species]]\ncount = 50\nrestitution = 0.9\n'
                            '[run]\nreplicas = 4\n') == "2D, box 20 × 10, N = 50, restitution 0.9, replicas 4"
    assert explain.describe("not a scene [") == ""


def test_methods_are_told_in_words():
    found = explain.method_summaries()
    assert set(METHODS) <= found.keys()
    assert found["dsmc-enskog"] == "like dsmc with Enskog's contact value"
    assert not any(text.startswith("the same") for text in found.values())
