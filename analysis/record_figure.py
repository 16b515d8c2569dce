"""A record as one picture: a panel for each series, histogram and field, and for the last frame of its particles."""

import math
import os
import tomllib

import h5py
import numpy as np

from analysis.clustering_panels import show_disks
from analysis.errors import InputError
from analysis.plotting import COLOURS, follow_scheme, literal, pyplot, wrapped
from analysis.record import load_record
from analysis.record_data import panels
from analysis.words import labelled, units

PANEL = (4.6, 3.1)   # inches
COLUMNS = 3
BARS = 40            # error bars of a curve
DECADES = 1e3        # positive values that spread further stand on a logarithmic axis
ENDINGS = (".svg", ".png", ".pdf")


def _curves(axes, panel):
    for index, curve in enumerate(panel.curves):
        colour = COLOURS[index % len(COLOURS)]
        axes.plot(curve.x, curve.y, color=colour, linewidth=1.2, label=literal(curve.name) or None)
        every = max(1, math.ceil(len(curve.x) / BARS))
        if np.isfinite(curve.error).any():
            axes.errorbar(curve.x[::every], curve.y[::every], yerr=np.nan_to_num(curve.error[::every]), fmt="none",
                          ecolor=colour, capsize=1.5, elinewidth=0.8)
    if len(panel.curves) > 1:
        axes.legend(fontsize=7.5, ncol=math.ceil(len(panel.curves) / 6), loc="best")
    axes.set_ylabel(literal(f"[{units(panel.y_label)}]" if units(panel.y_label) else "value"))
    values = np.concatenate([curve.y for curve in panel.curves])
    if values.min() > 0 and values.max() > DECADES * values.min():
        axes.set_yscale("log")


def _image(axes, panel, size):
    shown = axes.imshow(panel.image, origin="lower", aspect="auto", extent=(0, size[0], 0, size[1]), cmap="viridis",
                        interpolation="nearest")
    axes.figure.colorbar(shown, ax=axes)
    axes.set_ylabel(f"{panel.y_label} [length]")
    axes.grid(False)


def _diameters(file, scene):
    """Of the particles of the last frame: of their species, else of the only one."""
    found = np.array([item.get("diameter", 1.0) for item in scene["species"]])
    group = file["particles/all"]
    return found[group["species/value"][-1]] if "species" in group else np.full(group["position/value"].shape[1], found[0])


def _frame(axes, path, scene):
    """The last frame of a flat scene."""
    with h5py.File(path, "r") as file:
        group = file["particles/all"]
        position, time, edges = group["position/value"][-1], group["position/time"][-1], group["box/edges"][()]
        there = np.isfinite(position[:, 0])
        show_disks(axes, position[there], _diameters(file, scene)[there])
    axes.set(xlim=(0, edges[0]), ylim=(0, edges[1]), aspect="equal", xlabel="x [length]", ylabel="y [length]")
    axes.set_title(f"particles at time {time:.4g}")
    axes.grid(False)


def _has_frames(path, scene):
    with h5py.File(path, "r") as file:
        return len(scene["domain"]["size"]) == 2 and "particles/all/position/value" in file


def _check_output(output, overwrite):
    if output.suffix not in ENDINGS:
        raise InputError(output, "", f"'{output.suffix}' is no format of a picture",
                         f"end the name with {', '.join(ENDINGS)}")
    if output.exists() and not overwrite:
        raise InputError(output, "", "is there already", "give another --output, or --overwrite")


def draw_record(path, output, overwrite=False):
    """Writes the picture, whose ending names the format; returns the number of its panels. Throws InputError."""
    _check_output(output, overwrite)
    record = load_record(path)
    scene, found = tomllib.loads(record.scene), panels(record)
    frames = _has_frames(path, scene)
    count = len(found) + frames
    if not count:
        raise InputError(path, "", "holds no series and no particles",
                         "give the scene an [[observe]], or [output] trajectory")
    columns = min(COLUMNS, count)
    rows = math.ceil(count / columns)
    picture, axes = pyplot.subplots(rows, columns, squeeze=False, layout="constrained",
                                    figsize=(max(6, PANEL[0] * columns), PANEL[1] * rows + 0.4))
    axes = axes.ravel()
    for each, panel in zip(axes, found):
        each.set_title(wrapped(panel.title, 44, 1))
        each.set_xlabel(wrapped(labelled(panel.x_label, panel.x_units), 44, 1))
        _curves(each, panel) if panel.image is None else _image(each, panel, scene["domain"]["size"])
    if frames:
        _frame(axes[len(found)], path, scene)
    for each in axes[count:]:
        each.set_axis_off()
    replicas = len(record.seeds)
    bars = (f"mean of {replicas} replicas, bars: one standard error" if replicas > 1
            else "one replica: no error bars against time")
    picture.suptitle(literal(f"{path.name}: {bars}"), x=0.01, ha="left", weight="bold", fontsize=10.5)
    _write(picture, output)
    return count


def _write(picture, output):
    """Beside the name first, so that a picture appears whole or not at all."""
    part = output.with_name(f".{output.name}.part-{os.getpid()}{output.suffix}")
    picture.savefig(part, **({"metadata": {"Date": None}} if output.suffix == ".svg" else {"dpi": 120}))
    pyplot.close(picture)
    if output.suffix == ".svg":
        part.write_text(follow_scheme(part.read_text(encoding="utf-8")), encoding="utf-8")
    part.replace(output)
