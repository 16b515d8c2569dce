"""A record as a picture: what its curves show, against numbers worked out by hand, and what is refused."""

import subprocess
import sys

import h5py
import numpy as np
import pytest

from analysis import record_data
from analysis.errors import InputError
from analysis.record import Estimate, Quantity, Record, Series
from analysis.record_figure import draw_record
from analysis.tests.fixture import TOP

FLAT = '[domain]\nsize = [4.0, 2.0]\n[[species]]\ndiameter = 0.5\n[[species]]\ndiameter = 0.25\n'


def quantity(name="energy", units="1", components=(), axis=()):
    return Quantity(name, units, "", list(components), np.array(axis, float), "|b| / d")


def series(values, times=None, **more):
    values = np.asarray(values, float)
    times = np.arange(len(values)) if times is None else times
    return Series(quantity(**more), values, np.asarray(times, float), np.arange(len(values)))


def record(estimates=None, **names):
    return Record(FLAT, {}, np.array([1, 2]), {}, {}, names, estimates or {})


def test_replicas_are_averaged_with_their_standard_error():
    panel = record_data.curves_in_time("energy", [series([1, 2, 3]), series([3, 4, 5])])
    [curve] = panel.curves
    assert curve.y.tolist() == [2, 3, 4] and curve.error == pytest.approx([1, 1, 1]) and curve.name == ""


def test_replicas_of_other_times_are_read_at_those_of_the_shortest():
    time, values = record_data.together([series([0, 10], [0, 10]), series([0, 2, 4, 6, 8, 10, 12], range(0, 14, 2))])
    assert time.tolist() == [0, 10] and values.tolist() == [[0, 10], [0, 10]]


def test_one_replica_has_no_error():
    [curve] = record_data.curves_in_time("energy", [series([1, 2])]).curves
    assert np.isnan(curve.error).all()


def test_components_have_their_names():
    panel = record_data.curves_in_time("momentum", [series([[1, 2], [3, 4]], components="xy")])
    assert [curve.name for curve in panel.curves] == ["x", "y"] and panel.curves[1].y.tolist() == [2, 4]


def test_a_histogram_stands_over_the_middle_of_its_bins():
    estimate = Estimate(quantity(), np.array([4.0, 6.0]), np.array([0.1, 0.2]), 10.0)
    runs = [series([[1, 2], [3, 4]], axis=[0, 1, 3])]
    [curve] = record_data.histogram(record({"b": estimate}, b=runs), "b").curves
    assert (curve.x.tolist(), curve.y.tolist(), curve.error.tolist()) == ([0.5, 2.0], [4, 6], [0.1, 0.2])
    [plain] = record_data.histogram(record(b=runs), "b").curves   # without an estimate: the mean of the samples
    assert plain.y.tolist() == [2, 3]


def test_fields_are_profiles_or_images_with_their_units():
    units = "length^-D; length time^-1; mass length^2 time^-2"
    along = np.arange(12.0).reshape(1, 1, 3, 4)
    found = record_data.field(record(fields=[series(along, units=units)]), "fields", 2, [4.0, 3.0])
    assert [(panel.title.partition(",")[0], panel.y_label) for panel in found] == [
        ("density", "length^-D"), ("velocity x", "length time^-1"), ("velocity y", "length time^-1"),
        ("temperature", "mass length^2 time^-2")]
    assert found[0].curves[0].x.tolist() == [0.5, 1.5, 2.5] and found[0].curves[0].y.tolist() == [0, 4, 8]
    plane = np.arange(24.0).reshape(1, 2, 3, 4)
    found = record_data.field(record(fields=[series(plane, units=units)]), "fields", 2, [4.0, 3.0])
    assert found[3].image.shape == (3, 2) and found[3].image[2, 1] == 23
    assert "mass length² time⁻²" in found[3].title


@pytest.fixture
def path(tmp_path):
    """A record of two replicas with a curve, a histogram, a field and two frames of three particles."""
    def group(root, name, value, units="1", **more):
        made = root.create_group(f"series/{name}")
        for key, text in {"name": name, "units": units, "summary": "", "axis_label": "distance"}.items():
            made.attrs[key] = np.bytes_(text)
        for key, content in more.items():
            made.attrs[key] = content
        made["value"], made["samples"] = value, np.array([4, 4], np.uint64)
        made["time"], made["step"] = np.tile(np.arange(4.0), (2, 1)), np.tile(np.arange(4), (2, 1))

    draw = np.random.default_rng(1)
    with h5py.File(tmp_path / "gas.h5", "w") as file:
        root = file.create_group("sandglass")
        root.attrs["schema"] = np.array([1, 3])
        root["scene"], root["seed"] = np.bytes_(FLAT), np.array([1, 2], np.uint64)
        for name in ("provenance", "counters", "timings", "estimates"):
            root.create_group(name)
        group(root, "energy", np.geomspace(1, 1e-5, 8).reshape(2, 4), "mass length^2 time^-2")
        group(root, "pairs", draw.random((2, 4, 5)), axis=np.arange(6.0))
        group(root, "fields", draw.random((2, 4, 3, 2, 4)), "length^-D; length time^-1; mass length^2 time^-2")
        file["particles/all/position/value"] = draw.random((2, 3, 2))
        file["particles/all/position/time"] = np.array([0.0, 1.0])
        file["particles/all/species/value"] = np.array([[0, 1, 1], [0, 1, 1]], np.uint8)
        file["particles/all/box/edges"] = np.array([4.0, 2.0])
    return tmp_path / "gas.h5"


@pytest.mark.parametrize("ending", [".svg", ".png", ".pdf"])
def test_every_series_field_and_frame_has_a_panel(path, tmp_path, ending):
    output = tmp_path / f"picture{ending}"
    assert draw_record(path, output) == 1 + 1 + 4 + 1
    assert output.stat().st_size > 5000 and sorted(each.name for each in tmp_path.iterdir()) == ["gas.h5", output.name]


def test_nothing_is_overwritten_unasked(path, tmp_path):
    output = tmp_path / "picture.svg"
    output.write_text("mine")
    with pytest.raises(InputError, match="is there already; give another --output, or --overwrite"):
        draw_record(path, output)
    assert output.read_text() == "mine"
    draw_record(path, output, overwrite=True)
    with pytest.raises(InputError, match="'.h5' is no format of a picture"):
        draw_record(path, path, overwrite=True)


def test_the_command_says_what_it_wrote(path, tmp_path):
    command = [sys.executable, "-m", "analysis", "plot", str(path)]
    done = subprocess.run(command, cwd=tmp_path, env={"PYTHONPATH": str(TOP.parent), "PATH": ""}, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "7 panels: gas.svg\n")
    again = subprocess.run(command, cwd=tmp_path, env={"PYTHONPATH": str(TOP.parent), "PATH": ""}, capture_output=True, text=True)
    assert again.returncode == 2 and "is there already" in again.stderr


def test_disks_have_the_diameters_of_their_species(path):
    from analysis.record_figure import _diameters
    with h5py.File(path, "r") as file:
        scene = {"species": [{"diameter": 0.5}, {"diameter": 0.25}]}
        assert _diameters(file, scene).tolist() == [0.5, 0.25, 0.25]
