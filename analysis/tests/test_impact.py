"""c(tau) from histograms of the impact parameter, drawn from the distribution itself."""

from types import SimpleNamespace
import tomllib

import numpy as np
import pytest

from analysis import impact
from analysis.errors import InputError

EDGES = np.linspace(0, 1, 21)


def record(coefficients, particles=1000, dimension=2):
    """Two replicas; each sample holds the collisions of five per particle, with its own c."""
    rows = [2.5 * particles * np.diff(impact.share_below(c, EDGES)) for c in coefficients]
    series = SimpleNamespace(value=np.array(rows), quantity=SimpleNamespace(axis=EDGES))
    scene = f"[domain]\ndimension = {dimension}\n[[species]]\ncount = {particles}\n"
    return SimpleNamespace(scene=scene, series={"impact-parameter": [series, series]})


@pytest.mark.parametrize("c", [-3.0, -0.2, 0.0, 0.1, 0.5, 0.9])
def test_finds_the_coefficient_and_its_error(c):
    draw = np.random.default_rng(3)
    shares = np.diff(impact.share_below(c, EDGES))
    fits = [impact.fitted(EDGES, draw.multinomial(20000, shares)) for _ in range(50)]
    values, errors = np.transpose(fits)
    assert abs(values.mean() - c) < 4 * errors.mean() / 50**0.5
    assert 0.6 < values.std() / errors.mean() < 1.5


def test_each_window_has_its_own(monkeypatch, capsys):
    monkeypatch.setattr(impact, "load_record", lambda path: record([0, 0, 0.4, 0.4, 0.4]))
    rows = impact.windows("some.h5", 10.0)
    assert [tau for tau, *_ in rows] == [5, 15]
    assert np.allclose([c for _, c, _ in rows], [0, 0.4], atol=1e-4)
    impact.print_coefficient("some.h5", 10.0)
    table = tomllib.loads(capsys.readouterr().out)["impact-coefficient"]
    assert table["collisions-per-particle"] == [5, 15]
    assert np.allclose(table["value"], [0, 0.4], atol=1e-4)


@pytest.mark.parametrize("broken, window, what", [
    (record([0, 0], dimension=3), 10.0, "spheres"),
    (record([0, 0]), 50.0, "before the first window"),
    (SimpleNamespace(scene="", series={}), 10.0, "no series"),
])
def test_says_what_is_missing(monkeypatch, broken, window, what):
    monkeypatch.setattr(impact, "load_record", lambda path: broken)
    with pytest.raises(InputError, match=what):
        impact.windows("some.h5", window)
