"""The case 'clustering' as pictures: its scenes count time in t0 and lengths in diameters."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from analysis.clustering_panels import draw_frames, load_frames
from analysis.plotting import COLOURS, headed, pyplot, save
from analysis.record import load_record


@dataclass(frozen=True)
class Picture:
    """`needs`: what a record must hold to take part; `runs`: how many must.

    `draw` takes what `load` makes of each record, by method, and the path of the picture without ending.
    """

    name: str
    caption: str
    needs: tuple[str, ...]
    runs: int
    draw: Callable
    load: Callable = load_record
    wide: bool = False


def _is_exact(record):
    """Whether the method finds the contacts of its particles; only then are these observed."""
    return "impact-parameter" in record.series or "overlap" in record.series


def _styles(records):
    order = sorted(records, key=lambda name: not _is_exact(records[name]))
    return {name: (COLOURS[index % len(COLOURS)], ["-", "--", "-."][index % 3])
            for index, name in enumerate(order)}


def _at(series, time):
    """Index of the sample nearest to a time."""
    return int(np.argmin(np.abs(series.time - time)))


def spread(last, count):
    """About `count` times from early to late: 1, 2, 5 times powers of ten that the run reaches."""
    marks = [m * 10.0 ** e for e in range(-1, 5) for m in (1, 2, 5)]
    return [mark for mark in marks if mark <= last * 1.001][-count:]


def _colour(index, count):
    return pyplot.get_cmap("viridis")(0.92 * index / max(1, count - 1))


def mean_energy(record, times):
    """E/E0 at the times, mean over replicas."""
    return np.mean([np.exp(np.interp(times, item.time, np.log(item.value / item.value[0])))
                    for item in record.series["energy"]], axis=0)


def draw_energy(records, stem):
    """E/E0 of all methods with Haff's law, and their ratio to it."""
    picture, (upper, lower) = pyplot.subplots(2, 1, figsize=(5.2, 5.6), sharex=True, height_ratios=[1.5, 1])
    picture.subplots_adjust(left=0.15, right=0.96, top=0.91, bottom=0.1, hspace=0.08)
    last = min(item.time[-1] for record in records.values() for item in record.series["energy"])
    times = np.geomspace(0.1, last, 120)
    haff = (1 + times) ** -2
    upper.plot(times, haff, ":", color="#333333", label="Haff's law", zorder=1)
    lower.axhline(1, linestyle=":", color="#333333")
    for name, (colour, line) in _styles(records).items():
        energy = mean_energy(records[name], times)
        upper.plot(times, energy, line, color=colour, label=name, linewidth=2)
        lower.plot(times, energy / haff, line, color=colour, linewidth=2)
    upper.set(xscale="log", yscale="log", ylabel="E / E0")
    lower.set(xscale="log", yscale="log", ylabel="E / Haff", xlabel="t / t0")
    upper.legend()
    headed(picture, "The gas leaves Haff's law; hard disks keep most energy")
    save(picture, stem)


def draw_impact(records, stem):
    """P(b/d) of contacts between samples, early to late."""
    runs = next(iter(records.values())).series["impact-parameter"]
    edges, time = np.array(runs[0].quantity.axis), runs[0].time
    counts = sum(item.value for item in runs)
    marks = [0.0] + spread(time[-1], 4)
    picture, panel = pyplot.subplots(figsize=(5.2, 3.7))
    picture.subplots_adjust(left=0.13, right=0.96, top=0.88, bottom=0.14)
    panel.axhline(1, linestyle=":", color="#333333", label="molecular chaos")
    highest = 1.0
    for index, (low, high) in enumerate(zip(marks, marks[1:])):
        chosen = counts[(time > low * 1.001) & (time <= high * 1.001)].sum(axis=0)
        if chosen.sum() > 0:
            highest = max(highest, chosen.max() / chosen.mean())
            panel.stairs(chosen / chosen.mean(), edges, color=_colour(index, len(marks) - 1), linewidth=2,
                         baseline=None, label=f"t/t0 from {low:g} to {high:g}")
    panel.set(xlabel="impact parameter b / d", ylabel="P(b/d)", xlim=(0, 1), ylim=(0, 1.5 * highest))
    panel.legend(loc="upper left")
    headed(picture, "Contacts of hard disks turn grazing as clusters form")
    save(picture, stem)


def draw_pairs(records, stem):
    """g(r) of all methods at the start and at the end."""
    picture, panels = pyplot.subplots(1, 2, figsize=(8.4, 3.7))
    picture.subplots_adjust(left=0.07, right=0.98, top=0.82, bottom=0.14, wspace=0.16)
    for name, (colour, line) in _styles(records).items():
        runs = records[name].series["pair-correlation"]
        edges = np.array(runs[0].quantity.axis)
        middle = (edges[1:] + edges[:-1]) / 2
        for panel, sample in zip(panels, (0, -1)):
            mean = np.mean([item.value[sample] for item in runs], axis=0)
            panel.plot(middle, mean, line, color=colour, label=name)
            panel.set_title(f"t/t0 = {runs[0].time[sample]:.3g}")
    for panel in panels:
        panel.set(xlabel="r / d", ylim=(0, None), xlim=(edges[0], edges[-1]))
    panels[0].set_ylabel("g(r)")
    panels[1].legend()
    headed(picture, "Only hard disks pack: short-range order that the stochastic methods do not have")
    save(picture, stem)


def draw_structure(records, stem):
    """S(k) of each method at several times, one panel each."""
    styles = _styles(records)
    picture, panels = pyplot.subplots(1, len(styles), figsize=(1.2 + 2.7 * len(styles), 3.8), sharey=True,
                                      squeeze=False)
    picture.subplots_adjust(left=0.09, right=0.98, top=0.82, bottom=0.14, wspace=0.06)
    exact = None
    for panel, name in zip(panels[0], styles):
        runs = records[name].series["structure-factor"]
        edges = np.array(runs[0].quantity.axis)
        waves = (edges[1:] + edges[:-1]) / 2
        times = [0.0] + spread(runs[0].time[-1], 5)
        if exact is not None:
            panel.plot(*exact, ":", color="#333333", linewidth=1.8, label=f"{next(iter(styles))}, latest")
            panel.legend(loc="lower left")
        for index, time in enumerate(times):
            mean = np.mean([item.value[_at(item, time)] for item in runs], axis=0)
            panel.plot(waves, mean, color=_colour(index, len(times)), linewidth=1.8,
                       label=f"t/t0 = {time:g}" if exact is None else None)
        if exact is None and _is_exact(records[name]):
            exact = waves, mean
        panel.set(xscale="log", yscale="log", xlabel="k L / 2π", title=name)
    panels[0][0].set_ylabel("S(k)")
    panels[0][0].legend(loc="upper right")
    headed(picture, "The longest waves of the density grow alike in every method, shorter ones do not")
    save(picture, stem)


FRAMES = "particles/all/position"
PICTURES = [
    Picture("energy", "Energy of each method, mean of its replicas, and its ratio to Haff's law.",
            ("sandglass/series/energy",), 2, draw_energy),
    Picture("impact", "Impact parameter of the contacts of hard disks; flat if partners were independent.",
            ("sandglass/series/impact-parameter",), 1, draw_impact),
    Picture("frames", "Particles at equal times, first replica: disks or, for more than 30000 of them, the area "
            "fraction (black: 0.8 and more).", (FRAMES,), 2, draw_frames, load_frames, wide=True),
    Picture("structure", "Structure factor of each method at equal times, mean of the replicas.",
            ("sandglass/series/structure-factor",), 2, draw_structure, wide=True),
    Picture("pairs", "Pair correlation of each method at the start and at the end.",
            ("sandglass/series/pair-correlation",), 2, draw_pairs, wide=True),
]
