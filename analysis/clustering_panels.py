"""Frames of particles beside each other: a row for each method, a column for each time."""

from dataclasses import dataclass

import numpy as np
from matplotlib.collections import EllipseCollection

from analysis.plotting import headed, pyplot, save

MANY = 30000   # from here on a disk is smaller than a pixel, and the picture shows the area fraction
CELL = 4.0     # then: edge of a cell, in diameters
COLUMNS = 4
DISK = "#3f7fb8"   # of disks, on light and on dark paper


@dataclass(frozen=True)
class Frames:
    """First replica: time [frame], position [frame, particle, axis], edges of the box [axis].

    `exact`: of a method that finds the contacts of its particles; only then are these observed.
    """

    time: np.ndarray
    position: np.ndarray
    edges: np.ndarray
    exact: bool


def load_frames(path):
    import h5py
    with h5py.File(path, "r") as file:
        group = file["particles/all"]
        exact = any(f"sandglass/series/{name}" in file for name in ("impact-parameter", "overlap"))
        return Frames(group["position/time"][()], group["position/value"][()], group["box/edges"][()], exact)


def shown_times(time):
    """The start, and times that follow each other by equal factors up to the end."""
    late = time[time > 0]
    wanted = np.geomspace(late[0], late[-1], COLUMNS - 1)
    return [time[0]] + [late[np.argmin(np.abs(np.log(late / each)))] for each in wanted]


def show_disks(panel, position, diameter=1.0):
    size = np.broadcast_to(diameter, len(position))
    panel.add_collection(EllipseCollection(size, size, 0 * size, units="xy", offsets=position,
                                           transOffset=panel.transData, facecolor=DISK,
                                           linewidth=0, rasterized=True))


def show_density(panel, position, edges):
    cells = [round(edge / CELL) for edge in edges]
    counts, *_ = np.histogram2d(*position.T, bins=cells, range=[(0, edge) for edge in edges])
    fraction = counts * np.pi / 4 / np.prod(np.array(edges) / cells)
    panel.imshow(fraction.T, origin="lower", extent=(0, edges[0], 0, edges[1]), cmap="Greys", vmin=0,
                 vmax=0.8, interpolation="nearest")


def draw_frames(runs, stem):
    order = sorted(runs, key=lambda name: not runs[name].exact)
    times = shown_times(runs[order[0]].time)
    picture, panels = pyplot.subplots(len(order), len(times), squeeze=False, dpi=130,
                                      figsize=(0.4 + 2.1 * len(times), 0.75 + 2.1 * len(order)))
    picture.subplots_adjust(left=0.05, right=0.995, top=1 - 0.62 / picture.get_figheight(), bottom=0.01,
                            wspace=0.04, hspace=0.04)
    for row, name in zip(panels, order):
        run = runs[name]
        for panel, time in zip(row, times):
            position = run.position[np.argmin(np.abs(run.time - time))]
            position = position[np.isfinite(position[:, 0])]
            (show_density(panel, position, run.edges) if len(position) > MANY else show_disks(panel, position))
            panel.set(xlim=(0, run.edges[0]), ylim=(0, run.edges[1]), aspect="equal", xticks=[], yticks=[])
            panel.spines[["top", "right"]].set_visible(True)
        row[0].set_ylabel(name)
    for panel, time in zip(panels[0], times):
        panel.set_title(f"t/t0 = {time:g}")
    headed(picture, "Every method clusters, each in its own way")
    save(picture, stem)
