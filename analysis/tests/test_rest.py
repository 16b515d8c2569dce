"""Figures 3.1 to 3.6 of Kawasaki 1986: what is averaged for columns and for cooling."""

from types import SimpleNamespace

import numpy as np
import pytest

from analysis.source import rest


def run_of(species=None, scene=None, **series):
    replicas = {name: [SimpleNamespace(time=np.array(time, float), value=np.array(value, float))] * 2
                for name, (time, value) in series.items()}
    return SimpleNamespace(series=replicas.get, species=species, scene=scene)


def test_a_profile_is_that_of_its_time_or_the_mean_at_rest():
    value = np.array([10, 20, 40]).reshape(3, 1, 1, 1, 1) * np.arange(1, 9).reshape(1, 1, 4, 1, 2)
    run = run_of(scene={"domain": {"size": [1.0, 8.0, 1.0]}}, density=([0, 100, 200], value))
    heights, values = rest.profile(run, "density", 1, 0)
    assert heights == pytest.approx([1, 3, 5, 7]) and values == pytest.approx([20, 40, 60, 80])
    assert rest.profile(run, "density", 0, None)[1] == pytest.approx([30, 90, 150, 210])


def test_energies_are_over_all_of_the_start_and_against_collisions_of_a_particle():
    run = run_of(species={"count": 10}, energy=([0, 1, 2], [3, 2, 1]), collisions=([0, 2], [0, 20]),
                 **{"rotational-energy": ([0, 1, 2], [[1, 9], [1, 9], [0.5, 9]])})
    hits, translation, rotation = rest.energies(run)
    assert hits == pytest.approx([0, 2, 4])
    assert translation == pytest.approx([0.75, 0.5, 0.25]) and rotation == pytest.approx([0.25, 0.25, 0.125])
