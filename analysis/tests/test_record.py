"""The reader of records, against a file laid out as sim/record/schema writes it."""

import h5py
import numpy as np
import pytest

from analysis import load_record
from analysis.errors import InputError

NO_STEP = np.iinfo(np.uint64).max


def word(text):
    """A text of fixed length, as the record's writer stores it."""
    return np.bytes_(text)


def quantity(group, name, **more):
    for key, value in {"name": name, "units": "time^-1", "summary": "a quantity", "axis_label": ""}.items():
        group.attrs[key] = word(value)
    for key, value in more.items():
        group.attrs[key] = value
    return group


@pytest.fixture
def path(tmp_path):
    """Two replicas, the second one sample short."""
    with h5py.File(tmp_path / "record.h5", "w") as file:
        root = file.create_group("sandglass")
        root.attrs["schema"] = np.array([1, 0])
        root["scene"] = word("dimension = 2\n")
        root.create_group("provenance").attrs["commit"] = word("abc")
        root["seed"] = np.array([1, 2], np.uint64)
        root["counters/collisions"] = np.array([10.0, 12.0])
        root["timings/cpu-seconds"] = 1.5
        series = quantity(root.create_group("series/flow%2Fx"), "flow/x", axis=np.array([0.0, 1.0, 2.0]))
        series["samples"] = np.array([3, 2], np.uint64)
        series["value"] = np.array([[[1, 2], [3, 4], [5, 6]], [[7, 8], [9, 10], [np.nan, np.nan]]])
        series["time"] = np.array([[0, 1, 2], [0, 1, np.nan]])
        series["step"] = np.array([[0, 10, 20], [0, 10, NO_STEP]], np.uint64)
        estimate = quantity(root.create_group("estimates/rate"), "rate")
        estimate["value"], estimate["standard_error"], estimate["effective_samples"] = 1.0, np.nan, 1.0
    return tmp_path / "record.h5"


def test_record_is_read_whole(path):
    record = load_record(path)
    assert record.scene == "dimension = 2\n" and record.provenance == {"commit": "abc"}
    assert record.seeds.tolist() == [1, 2] and record.counters["collisions"].tolist() == [10, 12]
    assert record.timings == {"cpu-seconds": 1.5}
    assert record.estimates["rate"].value == 1 and np.isnan(record.estimates["rate"].standard_error)


def test_padding_is_cut_off(path):
    first, second = load_record(path).series["flow/x"]
    assert first.value.shape == (3, 2) and second.value.tolist() == [[7, 8], [9, 10]]
    assert second.step.tolist() == [0, 10] and second.time.tolist() == [0, 1]
    assert first.quantity.units == "time^-1" and first.quantity.axis.tolist() == [0, 1, 2]


def test_other_files_are_refused(path, tmp_path):
    (tmp_path / "text.h5").write_text("not HDF5")
    with h5py.File(path, "a") as file:
        file["sandglass"].attrs["schema"] = np.array([2, 0])
    cases = (("text.h5", "not a Sandglass record"), ("record.h5", "schema 2"), ("none", "no such file"))
    for broken, problem in cases:
        with pytest.raises(InputError, match=problem):
            load_record(tmp_path / broken)


def test_truncated_record_is_refused(path):
    path.write_bytes(path.read_bytes()[:2000])
    with pytest.raises(InputError, match="record.h5: not a Sandglass record"):
        load_record(path)
