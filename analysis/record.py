"""The HDF5 record of one run as numpy arrays. Layout: docs/file-formats.md, sim/record/schema/names.hpp."""

from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote

from numpy import ndarray

from analysis.errors import InputError

VERSION_MAJOR = 1
REMEDY = "give a record that 'sandglass run' or 'sandglass validate' wrote"


@dataclass(frozen=True)
class Quantity:
    """Name, units and meaning; `axis` holds the bin edges of the last dimension, when there are bins."""

    name: str
    units: str
    summary: str
    components: list[str]
    axis: ndarray | tuple
    axis_label: str


@dataclass(frozen=True)
class Series:
    """Samples of one quantity in one replica: value [sample, *shape], time and step [sample]."""

    quantity: Quantity
    value: ndarray
    time: ndarray
    step: ndarray


@dataclass(frozen=True)
class Estimate:
    """Mean over samples and replicas from start_time on: value and standard_error [*shape], NaN where the error is
    unknown. drifts: a component goes on changing, so that there is no steady mean."""

    quantity: Quantity
    value: ndarray
    standard_error: ndarray
    effective_samples: float
    start_time: float = 0.0
    drifts: bool = False


@dataclass(frozen=True)
class Record:
    """One run. `series` holds a list over replicas for each name, `counters` an array over replicas."""

    scene: str
    provenance: dict[str, str]
    seeds: ndarray
    counters: dict[str, ndarray]
    timings: dict[str, float]
    series: dict[str, list[Series]]
    estimates: dict[str, Estimate]


def _word(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def _quantity(group):
    text = {name: _word(group.attrs.get(name, "")) for name in ("name", "units", "summary", "axis_label")}
    return Quantity(components=[_word(item) for item in group.attrs.get("components", ())],
                    axis=group.attrs.get("axis", ()), **text)


def _series(group):
    """The replicas of one quantity without the padding that makes them equally long in the file."""
    quantity, arrays = _quantity(group), [group[name][()] for name in ("value", "time", "step")]
    return [Series(quantity, *(array[replica, :count] for array in arrays))
            for replica, count in enumerate(group["samples"][()].astype(int))]


def _estimate(group):
    since = {"start_time": float(group["start_time"][()]), "drifts": bool(group["drifts"][()])} \
        if "start_time" in group else {}  # not before schema {1, 3}
    return Estimate(_quantity(group), group["value"][()], group["standard_error"][()],
                    float(group["effective_samples"][()]), **since)


def _each(group, read):
    return {unquote(link): read(group[link]) for link in group}


def _read(file):
    root = file["sandglass"]
    if root.attrs["schema"][0] != VERSION_MAJOR:
        raise ValueError(f"schema {root.attrs['schema'][0]} where this reader knows {VERSION_MAJOR}")
    provenance = {name: _word(value) for name, value in root["provenance"].attrs.items()}
    return Record(_word(root["scene"][()]), provenance, root["seed"][()],
                  _each(root["counters"], lambda item: item[()]),
                  _each(root["timings"], lambda item: float(item[()])), _each(root["series"], _series),
                  _each(root["estimates"], _estimate))


def load_record(path):
    """The `/sandglass` part of a record. Throws InputError when the file is not a readable record."""
    import h5py

    if not Path(path).is_file():
        raise InputError(path, "", "no such file", REMEDY)
    try:
        with h5py.File(path, "r") as file:
            return _read(file)
    except (OSError, KeyError, ValueError) as error:
        raise InputError(path, "", f"not a Sandglass record: {error}", REMEDY) from error
