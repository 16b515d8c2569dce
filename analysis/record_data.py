"""What a record holds, ready to draw: curves with their standard errors, histograms, fields."""

import tomllib
from dataclasses import dataclass

import numpy as np

from analysis.words import units


@dataclass(frozen=True)
class Curve:
    """`error` is one standard error, NaN where it is not known; `name` is empty where a quantity has one curve."""

    name: str
    x: np.ndarray
    y: np.ndarray
    error: np.ndarray


@dataclass(frozen=True)
class Panel:
    """One picture: curves over x, or an image of the plane (rows: second axis) where `image` is given."""

    title: str
    x_label: str
    x_units: str
    y_label: str    # units of curves; of an image, its second axis
    curves: list[Curve]
    image: np.ndarray | None = None


def mean_error(values):
    """Mean over independent arrays and its standard error; NaN for a single one."""
    values = np.asarray(values, float)
    if len(values) == 1:
        return values[0], np.full(values[0].shape, np.nan)
    return values.mean(axis=0), values.std(axis=0, ddof=1) / len(values) ** 0.5


def together(replicas):
    """(times, values [replica, sample, *shape]) of one quantity, on the times of its shortest replica."""
    base = min(replicas, key=lambda item: len(item.time))
    time = base.time[base.time <= min(item.time[-1] for item in replicas)]
    found = []
    for item in replicas:
        flat = item.value.reshape(len(item.time), -1)
        found.append(np.stack([np.interp(time, item.time, column) for column in flat.T], axis=1)
                     .reshape(len(time), *item.value.shape[1:]))
    return time, np.array(found)


def _labels(quantity, count):
    return list(quantity.components) if len(quantity.components) == count else [str(index + 1) for index in range(count)]


def curves_in_time(name, replicas):
    """A panel of each component against time, mean over the replicas."""
    quantity = replicas[0].quantity
    time, values = together(replicas)
    mean, error = mean_error(values.reshape(len(values), len(time), -1))
    count = mean.shape[1]
    names = _labels(quantity, count) if count > 1 else [""]
    return Panel(name, "time", "time", quantity.units,
                 [Curve(label, time, mean[:, index], error[:, index]) for index, label in enumerate(names)])


def _average(record, name):
    """(value, standard error) over samples and replicas: the record's own estimate, or the mean of the samples."""
    if name in record.estimates:
        estimate = record.estimates[name]
        return estimate.value, estimate.standard_error
    return mean_error([item.value.mean(axis=0) for item in record.series[name]])


def histogram(record, name):
    """A panel over the bins of the last dimension."""
    quantity = record.series[name][0].quantity
    value, error = (np.ravel(each) for each in _average(record, name))
    edges = np.asarray(quantity.axis, float)
    middle = (edges[1:] + edges[:-1]) / 2 if len(edges) == len(value) + 1 else np.arange(len(value)) + 0.5
    label = quantity.axis_label if len(edges) == len(value) + 1 else "bin"
    return Panel(f"{name}, mean over the run", label, "", quantity.units, [Curve("", middle, value, error)])


def _field_names(name, units, dimension, count):
    """[(name, units)] of what a field holds in each bin; density, velocities and temperature of 'fields'."""
    parts = units.split("; ")
    if name == "fields" and count == dimension + 2 and len(parts) == 3:
        names = ["density"] + [f"velocity {axis}" for axis in "xyz"[:dimension]] + ["temperature"]
        return list(zip(names, parts[:1] + parts[1:2] * dimension + parts[2:]))
    return [(f"{name} {'xyz'[index] if count == dimension else index + 1}" if count > 1 else name, parts[0])
            for index in range(count)]


def field(record, name, dimension, size):
    """Panels of a field: a profile where it varies along one axis, else an image of the first two."""
    quantity = record.series[name][0].quantity
    value, error = _average(record, name)
    if value.ndim == dimension:
        value, error = value[..., None], error[..., None]
    axes = [axis for axis in range(dimension) if value.shape[axis] > 1] or [0]
    panels = []
    for index, (label, unit) in enumerate(_field_names(name, quantity.units, dimension, value.shape[-1])):
        mean, noise = value[..., index], error[..., index]
        if len(axes) == 1:
            axis = axes[0]
            middle = (np.arange(mean.shape[axis]) + 0.5) * size[axis] / mean.shape[axis]
            panels.append(Panel(f"{label}, mean over the run", "xyz"[axis], "length", unit, [Curve("", middle, np.ravel(mean), np.ravel(noise))]))
        else:
            others = tuple(axis for axis in range(dimension) if axis not in axes[:2])
            typical = np.sqrt(np.nanmean(noise ** 2)) if np.isfinite(noise).any() else np.nan
            noted = f", std. error {typical:.2g}" if np.isfinite(typical) else ""
            title = f"{label} [{units(unit)}]{noted}"
            panels.append(Panel(title, "xyz"[axes[0]], "length", "xyz"[axes[1]], [], mean.mean(axis=others).T))
    return panels


def panels(record):
    """Every series of a record, in its order."""
    domain = tomllib.loads(record.scene)["domain"]
    size, found = domain["size"], []
    for name, replicas in record.series.items():
        shape = replicas[0].value.shape[1:]
        if not len(replicas[0].time):
            continue
        if len(replicas[0].quantity.axis) or (len(shape) == 1 and not replicas[0].quantity.components):
            found.append(histogram(record, name))
        elif len(shape) >= len(size) and not replicas[0].quantity.components:
            found += field(record, name, len(size), size)
        else:
            found.append(curves_in_time(name, replicas))
    return found
