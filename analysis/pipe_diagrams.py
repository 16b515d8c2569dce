"""The case 'pipe-flow' over all of its points, the words of the source beside ours: Müller 2001, figures 3.20 to 3.23."""

import re
from types import SimpleNamespace

import numpy as np

from analysis.clustering_figures import Picture
from analysis.pipe_figures import DENSEST, FIELDS, load_slices
from analysis.plotting import COLOURS, MARKERS, headed, pyplot, save, wrapped

COUNT = "sandglass/series/crossing-count"
METHOD = "hsmc"           # the source's
SHOWN = ("nu-0.3", "nu-0.75", "nu-0.88")   # figure 3.23
SOURCE = {"linestyle": ":", "color": "#333333"}


def exponents(case, prefix):
    """Rows (number in the name of the point, exponent, standard error) of the method's points."""
    rows = []
    for verdict in (item.verdict for item in case.evidence):
        name = re.fullmatch(re.escape(prefix) + r"([\d.]+)", verdict.point)
        if name and verdict.check == "pipe-spectrum" and verdict.variant == METHOD and verdict.value is not None:
            rows.append((float(name[1]), verdict.value, verdict.stderr or 0.0))
    return np.array(sorted(rows)).reshape(-1, 3).T


def flow_rate(path):
    """Area fraction and flow rate of disks of diameter one: mean over replicas in the second half, standard error."""
    import h5py
    with h5py.File(path, "r") as file:
        count, time = file[COUNT + "/value"][()].reshape(*file[COUNT + "/time"].shape, 2), file[COUNT + "/time"][0]
        width = float(np.ravel(file["particles/all/box/edges"][()])[-2])
        fraction = float(file[FIELDS + "/value"][0, 0, ..., 0].mean()) * np.pi / 4
    half = len(time) // 2
    net = np.abs(np.diff(count[:, -1] - count[:, half], axis=1))[:, 0]
    rate = net / (time[-1] - time[half]) / width * np.pi / 4
    return fraction, rate.mean(), rate.std(ddof=1) / len(rate) ** 0.5 if len(rate) > 1 else 0.0


def _kept(case, folder):
    return {run.point: folder / run.record for run in case.runs
            if run.variant == METHOD and run.record and (folder / run.record).is_file()}


def flow_rates(case, folder, prefix):
    """Rows (area fraction, flow rate, standard error) of the points that count passages."""
    paths = [path for point, path in _kept(case, folder).items() if re.fullmatch(prefix + r"[\d.]+", point)]
    return np.array(sorted(flow_rate(path) for path in paths)).reshape(-1, 3).T


def diagram_data(case, folder):
    """What the diagrams show; None where fewer than three points of any were run."""
    data = SimpleNamespace(
        restitution=exponents(case, "long-r-"), rough=exponents(case, "rough-"), dense=exponents(case, "dense-rough-"),
        fast=flow_rates(case, folder, "nu-"), slow=flow_rates(case, folder, "slow-nu-"))
    return data if max(rows.shape[1] for rows in vars(data).values()) > 2 else None


def _draw_rows(panel, rows, index, name):
    if rows.size:
        panel.errorbar(rows[0], rows[1], yerr=rows[2], fmt=MARKERS[index], color=COLOURS[index], capsize=2,
                       linestyle="-", linewidth=0.8, label=name)


def _words(panel, text):
    panel.set_title(wrapped(f"source: {text}", 44), fontsize=8, loc="left")


def draw_diagrams(data, stem):
    """Exponent against restitution and roughness, flow rate against area fraction."""
    picture, (left, middle, right) = pyplot.subplots(1, 3, figsize=(10.8, 3.9))
    picture.subplots_adjust(left=0.08, right=0.98, top=0.76, bottom=0.14, wspace=0.34)
    _draw_rows(left, data.restitution, 0, "area fraction 0.38")
    left.plot([0, 0.6, 1], [-1.3, -1.3, 0], label="source, drawn from its words", **SOURCE)
    left.set(xlabel="restitution r", ylabel="exponent of the spectrum")
    _words(left, "constant at about -1.3 below r = 0.6, approaches 0 as r -> 1")
    _draw_rows(middle, data.rough, 0, "area fraction 0.38")
    _draw_rows(middle, data.dense, 1, "area fraction 0.6, as in the source")
    middle.axhline(-0.4, label="source at p = 1", **SOURCE)
    middle.set(xscale="log", xlabel="probability p to bounce back", ylabel="exponent of the spectrum")
    _words(middle, "0 for p -> 0, lowest at p of about 0.1, about -0.4 for p -> 1")
    _draw_rows(right, data.fast, 0, "fast start")
    _draw_rows(right, data.slow, 1, "slow start")
    if data.fast.size:
        slope = data.fast[1][0] / data.fast[0][0]
        right.plot([0, 0.6], [0, 0.6 * slope], label="proportional, through our first", **SOURCE)
    right.set(xlabel="area fraction", ylabel="flow rate [√(g d)]", xlim=(0, None), ylim=(0, None))
    _words(right, "proportional up to 0.6, faster to 0.75, then flat or falling")
    for panel in (left, middle, right):
        panel.legend(fontsize=7)
    headed(picture, "Pipe flow: exponents of the density's spectrum and flow rate, ours beside the source's words")
    save(picture, stem)


def wave_data(case, folder):
    """Slices of the three area fractions of the source; None unless all were kept."""
    kept = _kept(case, folder)
    return {point: load_slices(kept[point]) for point in SHOWN} if all(point in kept for point in SHOWN) else None


def draw_waves(runs, stem):
    """The end of each run, first replica: the slope of a stripe is the speed of a wave."""
    picture, panels = pyplot.subplots(len(runs), 1, figsize=(8.4, 6.0), sharex=True)
    picture.subplots_adjust(left=0.08, right=0.98, top=0.91, bottom=0.08, hspace=0.3)
    for panel, (name, run) in zip(panels, runs.items()):
        shown = run.time > run.time[-1] - 30
        panel.imshow(run.fraction[0][shown].T, origin="lower", aspect="auto", cmap="Greys", vmin=0, vmax=DENSEST,
                     extent=(run.time[shown][0], run.time[-1], 0, run.length), interpolation="nearest")
        panel.set(title=f"area fraction {name.removeprefix('nu-')}", ylabel="y / d")
        panel.grid(False)
    panels[-1].set_xlabel("time")
    headed(picture, "Source: waves slow down at 0.88 but do not reverse (gravity points down)")
    save(picture, stem)


DIAGRAMS = [
    Picture("source", "Exponents and flow rate of all points beside the words of Müller 2001 (figures 3.20 to 3.22).",
            (), 1, draw_diagrams, diagram_data, wide=True),
    Picture("waves", "Density along the pipe at three area fractions (Müller 2001, figure 3.23).",
            (), 1, draw_waves, wave_data, wide=True),
]
