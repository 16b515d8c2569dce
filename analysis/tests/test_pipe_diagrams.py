"""Diagrams of the case 'pipe-flow' over its points, from verdicts and small records."""

from types import SimpleNamespace

import h5py
import numpy as np
import pytest

from analysis import comparison, pipe_diagrams

WIDTH, SAMPLES = 20.0, 21


def write_run(path, fraction, rate):
    """Two replicas that carry `rate` times area fraction over pi/4 downwards, a tenth more in one of them."""
    path.parent.mkdir(parents=True, exist_ok=True)
    time = np.linspace(0, 40, SAMPLES)
    with h5py.File(path, "w") as file:
        root = file.create_group("sandglass/series")
        density = np.zeros((2, SAMPLES, 1, 8, 4))
        density[..., 0] = fraction / (np.pi / 4)
        root["fields/value"], root["fields/time"] = density, np.tile(time, (2, 1))
        count = np.zeros((2, SAMPLES, 2))
        count[..., 1] = np.outer([1, 1.1], time) * WIDTH * rate / (np.pi / 4)
        root["crossing-count/value"], root["crossing-count/time"] = count, np.tile(time, (2, 1))
        file["particles/all/box/edges"] = np.array([WIDTH, 200.0])


def case_of(folder, fractions):
    runs = []
    for fraction in fractions:
        name = f"records/nu-{fraction}.h5"
        write_run(folder / name, fraction, 50 * fraction)
        runs.append(SimpleNamespace(variant="hsmc", point=f"nu-{fraction}", record=name))
    evidence = [SimpleNamespace(verdict=SimpleNamespace(point=point, check="pipe-spectrum", variant="hsmc",
                                                        value=value, stderr=0.1))
                for point, value in (("long-r-0.6", -1.4), ("long-r-0", -1.3), ("r-0.99", -0.7))]
    return SimpleNamespace(name="pipe-flow", runs=runs, evidence=evidence)


def test_flow_rate_is_area_fraction_times_velocity(tmp_path):
    write_run(tmp_path / "a.h5", 0.3, 15)
    fraction, rate, error = pipe_diagrams.flow_rate(tmp_path / "a.h5")
    assert fraction == pytest.approx(0.3)
    assert rate == pytest.approx(15 * 1.05)
    assert error == pytest.approx(15 * 0.05)


def test_exponents_are_those_of_the_points_with_the_prefix(tmp_path):
    rows = pipe_diagrams.exponents(case_of(tmp_path, []), "long-r-")
    assert rows.T == pytest.approx(np.array([[0, -1.3, 0.1], [0.6, -1.4, 0.1]]))


def test_diagrams_are_drawn_when_there_is_enough(tmp_path):
    comparisons, jobs = comparison.plan(case_of(tmp_path, (0.3, 0.75, 0.88)), tmp_path, tmp_path / "figures")
    assert [item.point for item in comparisons] == ["all points"] * 2
    for job in jobs:
        job()
    for item in comparisons:
        assert (tmp_path / "figures" / f"{item.name}.png").stat().st_size > 5000
    assert comparison.plan(case_of(tmp_path, (0.3,)), tmp_path, tmp_path / "figures") == ([], [])
