"""Figures of Greenspan 1972: the list, and what is drawn between two fluids."""

import numpy as np
import pytest

from analysis.source import mixing
from analysis.source.catalogue import DRAWINGS, catalogue
from analysis.source.runs import Lacking

EDGES = np.array([100.0, 100.0])


def test_every_figure_is_listed_once_and_drawn():
    figures = catalogue("GRE").figures
    assert [item.number for item in figures] == [f"3.{number}" for number in range(1, 15)]
    assert {item.number for item in figures if item.case} == DRAWINGS["GRE"].keys()


def test_the_interface_lies_between_the_fluids():
    x, y = np.meshgrid(np.linspace(2.5, 97.5, 20), np.linspace(2.5, 97.5, 20))
    place = np.column_stack([x.ravel(), y.ravel()])
    _, height, share = mixing.share_of_heavy(place, place[:, 1] > 70, EDGES)
    middle = share[:, mixing.MESH // 2]
    assert np.all(np.diff(middle) >= 0) and middle[0] < 0.01 and middle[-1] > 0.99
    assert abs(np.interp(0.5, middle, height[:, 0]) - 70) < 1


def test_a_frame_that_is_not_there_is_named():
    fluids = mixing.Fluids(np.array([0, 80]), *(np.zeros((2, 1, 2)),) * 2, np.array([True]), EDGES)
    assert fluids.frame(80) == 1
    with pytest.raises(Lacking, match="no frame of step 160"):
        fluids.frame(160)
