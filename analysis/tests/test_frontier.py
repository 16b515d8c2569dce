"""What accuracy costs, and orders against theory, from sweeps whose numbers are known."""

import numpy as np
import pytest

from analysis import frontier, model
from analysis.sweep_figures import finer_is_larger
from analysis.tests import fixture
from analysis.words import with_error


def sweep(errors, cost, knobs=(1.0, 2.0, 4.0), stderr=1e-4, reference=1.0, **more):
    points = [model.SweepPoint(knob, reference + error, stderr, error, seconds, 1.0)
              for knob, error, seconds in zip(knobs, errors, cost)]
    row = fixture.sweep() | {"reference": reference, "points": points} | more
    return model.Sweep(**row)


def test_the_cheapest_setting_meets_its_target_with_two_standard_errors():
    quick = sweep([0.09995, 0.02], [1.0, 3.0], variant="quick")
    exact = sweep([0.05, 0.004], [2.0, 4.0], variant="exact")
    choice = frontier.cheapest([quick, exact], 0.1)   # 0.09995 + 0.0002 is above 0.1
    assert (choice.sweep.variant, choice.point.cpu_seconds) == ("exact", 2.0)
    assert frontier.cheapest([quick, exact], 0.01).point.error == 0.004
    assert frontier.cheapest([quick, exact], 0.001) is None
    assert frontier.best_bound([quick, exact]) == pytest.approx(0.0042)


def test_a_point_without_an_error_bar_meets_nothing():
    assert frontier.cheapest([sweep([0.001], [1.0], stderr=None)], 0.1) is None
    assert frontier.cheapest([sweep([0.001], [1.0], reference=0.0)], 0.1) is None


def order(value, error, sweep_errors, expected=2.0):
    return frontier.judge_order(sweep(sweep_errors, [1.0] * 3, order=value, order_stderr=error, expected_order=expected),
                                with_error)


def test_orders_are_judged_in_standard_errors():
    errors = 0.01 * np.array([1.0, 2.0, 4.0]) ** 2
    assert order(1.9, 0.05, errors).symbol == "✓"
    assert order(None, None, errors).symbol == "·"
    fine = order(1.5, 0.01, [0.01, 0.04, 0.1])   # the fine end has order 2
    assert fine.symbol == "→" and fine.text.startswith("50 standard errors from it; between the two finest points")
    assert order(1.5, 0.01, [0.01, 0.02, 0.04]).symbol == "✗"
    assert order(1.5, 0.01, [0.0003, 0.001, 0.1]).symbol == "?"
    growing = order(-0.85, 0.01, [0.2, 0.11, 0.055], expected=-1.0)   # finest: the two largest knobs
    assert growing.symbol == "→" and "−1.00" in growing.text


def test_finer_settings_lie_on_one_side():
    assert not finer_is_larger(sweep([0.1], [1.0], expected_order=2.0))
    assert finer_is_larger(sweep([0.1], [1.0], expected_order=-1.0))
    assert finer_is_larger(sweep([0.1], [1.0], expected_order=None, order=-0.5))


def test_a_knob_that_saves_time_is_named():
    assert frontier.cheaper_when_finer(sweep([0.2, 0.1, 0.05], [3.0, 2.0, 1.0]))
    assert not frontier.cheaper_when_finer(sweep([0.2, 0.1, 0.05], [1.0, 2.0, 3.0]))
