"""Figures of Kawasaki 1986: the list, and what is averaged for the channels."""

from types import SimpleNamespace

import numpy as np
import pytest

from analysis.source import channel
from analysis.source.catalogue import DRAWINGS, catalogue

SCENE = {"domain": {"size": [16.0, 8.0, 0.2]},
         "inflow": [{"number-density": 4.0, "temperature": 0.5, "spin-temperature": 0.25}]}


class Run:
    """Two replicas that show 1 before and 2 after half of the time; u grows from the wall y = 0 upwards."""

    scene = SCENE

    def series(self, name):
        time = np.array([0.0, 5.0, 10.0])
        value = np.ones((3, 4, 6, 1, 5) if name == "fields" else (3, 4, 6, 1)) * np.array([1, 2, 2]).reshape(
            (3,) + (1,) * (4 if name == "fields" else 3))
        if name == "fields":
            value[..., 1] = np.arange(6).reshape(6, 1)
        return [SimpleNamespace(value=value, time=time)] * 2


def test_every_figure_is_listed_once_and_drawn_or_explained():
    figures = catalogue("KAW").figures
    assert len({item.number for item in figures}) == len(figures)
    assert {item.number for item in figures if item.case} == DRAWINGS["KAW"].keys()


def test_the_later_half_is_averaged_in_the_units_of_the_inflow():
    flow = channel.load_flow(Run())
    assert flow.x == pytest.approx([2, 6, 10, 14]) and len(flow.y) == 6
    assert flow.density == pytest.approx(0.5) and flow.temperature == pytest.approx((4 + 8) / 2)
    assert flow.pressure == pytest.approx(0.5 * 4)
    assert flow.velocity[0] == pytest.approx(np.arange(6))   # sqrt(2 T) is one


def test_both_halves_are_folded():
    flow = channel.load_flow(Run()).folded()
    assert len(flow.y) == 3 and flow.velocity[0] == pytest.approx(2.5)
    assert flow.across == pytest.approx(0)
