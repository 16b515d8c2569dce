"""Pictures that set methods beside each other, from small records laid out as the program writes them."""

from types import SimpleNamespace

import h5py
import numpy as np
import pytest

from analysis import clustering_figures, clustering_panels, comparison
from analysis.errors import InputError
from analysis.record import Quantity, Record, Series

TIMES = np.array([0.0, 1.0, 10.0, 100.0])


def series(root, name, value, axis=()):
    group = root.create_group(f"series/{name}")
    for key in ("name", "units", "summary", "axis_label"):
        group.attrs[key] = np.bytes_("x")
    group.attrs["axis"] = np.asarray(axis, float)
    group["value"], group["time"] = value[None], TIMES[:len(value)][None]
    group["step"], group["samples"] = np.arange(len(value))[None], np.array([len(value)], np.uint64)


def write_run(path, event_driven, particles=50):
    """One replica with everything that the pictures of the case show."""
    draw = np.random.default_rng(1)
    path.parent.mkdir(parents=True, exist_ok=True)
    with h5py.File(path, "w") as file:
        root = file.create_group("sandglass")
        root.attrs["schema"] = np.array([1, 0])
        root["scene"] = np.bytes_("")
        root["seed"] = np.array([1], np.uint64)
        for name in ("provenance", "counters", "timings", "estimates", "series"):
            root.create_group(name)
        series(root, "energy", 50 * (1 + TIMES) ** -2)
        series(root, "structure-factor", 1 + np.outer(TIMES, np.ones(6)), np.arange(0.5, 7))
        series(root, "pair-correlation", np.ones((4, 5)), np.arange(6))
        if event_driven:
            series(root, "impact-parameter", np.full((3, 4), 100.0), np.linspace(0, 1, 5))
        group = file.create_group("particles/all")
        group["position/value"] = 20 * draw.random((4, particles, 2))
        group["position/time"], group["box/edges"] = TIMES, np.array([20.0, 20.0])


def case_of(folder, variants=("event-driven", "cba")):
    runs = []
    for variant in variants:
        name = f"records/{variant}.h5"
        write_run(folder / name, variant == "event-driven")
        runs.append(SimpleNamespace(variant=variant, point="large", record=name))
    return SimpleNamespace(name="clustering", runs=runs)


def test_every_picture_is_drawn(tmp_path):
    comparisons, jobs = comparison.plan(case_of(tmp_path), tmp_path, tmp_path / "figures")
    assert [(item.point, item.wide) for item in comparisons] == [("large", False)] * 2 + [("large", True)] * 3
    for job in jobs:
        job()
    for item in comparisons:
        for ending in ("svg", "png"):
            assert (tmp_path / "figures" / f"{item.name}.{ending}").stat().st_size > 5000


def test_one_method_alone_is_compared_with_nothing(tmp_path):
    case = case_of(tmp_path, ("event-driven",))
    assert comparison.plan(case, tmp_path, tmp_path) == ([], [])


def test_what_was_not_kept_is_left_out(tmp_path):
    case = case_of(tmp_path, ("event-driven", "cba", "dsmc"))
    (tmp_path / "records/cba.h5").unlink()
    assert len(comparison.plan(case, tmp_path, tmp_path)[0]) == 5
    (tmp_path / "records/event-driven.h5").unlink()
    assert comparison.plan(case, tmp_path, tmp_path) == ([], [])
    case = case_of(tmp_path)
    other = SimpleNamespace(name="shear-wave", runs=case.runs)
    assert comparison.plan(other, tmp_path, tmp_path) == ([], [])


def test_a_broken_record_is_named(tmp_path):
    case = case_of(tmp_path)
    (tmp_path / "records/cba.h5").write_text("not HDF5")
    with pytest.raises(InputError, match="cba.h5"):
        comparison.plan(case, tmp_path, tmp_path)


def test_energy_is_relative_and_averaged_in_the_logarithm():
    quantity = Quantity("energy", "", "", [], (), "")
    runs = [Series(quantity, np.array(value), np.array([0.0, 2.0]), np.array([0, 1]))
            for value in ([8.0, 2.0], [4.0, 0.25])]
    record = Record("", {}, None, {}, {}, {"energy": runs}, {})
    assert clustering_figures.mean_energy(record, [0.0, 1.0]) == pytest.approx([1.0, (0.5 + 0.25) / 2])


def test_times_are_spread_evenly_in_the_logarithm():
    assert clustering_figures.spread(100, 4) == [10, 20, 50, 100]
    assert clustering_figures.spread(1000, 2) == [500, 1000]
    assert clustering_panels.shown_times(np.arange(0, 101, 5.0)) == [0, 5, 20, 100]


def test_many_particles_show_as_area_fraction(tmp_path):
    write_run(tmp_path / "a.h5", True, clustering_panels.MANY + 1)
    clustering_panels.draw_frames({"cba": clustering_panels.load_frames(tmp_path / "a.h5")}, tmp_path / "many")
    assert (tmp_path / "many.png").stat().st_size > 5000
