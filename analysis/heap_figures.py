"""The case 'heap' as pictures: surfaces of the methods beside each other, and how each heap grows."""

import tomllib

import numpy as np

from analysis.clustering_figures import Picture
from analysis.plotting import COLOURS, headed, pyplot, save

SURFACE = "sandglass/series/free-surface"
WINDOW = 10  # particles poured before and after: whoever rebounds stands over a bin for less
SIZES = 8  # of a growing heap


def _source(record):
    return tomllib.loads(record.scene)["source"][0]


def _surface(record, sample):
    """Mean surface over the replicas and the standard error of each bin; in each the median over nearby samples."""
    times = record.series["free-surface"][0].time
    near = np.abs(times - times[sample]) <= WINDOW / _source(record)["rate"]
    heights = np.array([np.median(item.value[near], axis=0) for item in record.series["free-surface"]])
    error = heights.std(axis=0, ddof=1) / len(heights) ** 0.5 if len(heights) > 1 else 0 * heights[0]
    return heights.mean(axis=0), error


def _bins(record):
    """Middles of the bins from the middle of the box; the scenes give lengths in diameters."""
    count = record.series["free-surface"][0].value.shape[1]
    return ((np.arange(count) + 0.5) / count - 0.5) * tomllib.loads(record.scene)["domain"]["size"][0]


def _growing(record):
    """Samples at about equal intervals until the last particle."""
    times = record.series["free-surface"][0].time
    source = _source(record)
    last = np.searchsorted(times, source.get("count", np.inf) / source["rate"] * (1 + 1e-9)) - 1
    return np.unique(np.linspace(0, last, SIZES + 1).astype(int))[1:]


def draw_surfaces(records, stem):
    """Surface at the end, mean of the replicas with its standard error."""
    picture, panel = pyplot.subplots(figsize=(7.2, 3.6))
    picture.subplots_adjust(left=0.09, right=0.98, top=0.88, bottom=0.15)
    for index, (name, record) in enumerate(records.items()):
        height, error = _surface(record, -1)
        colour = COLOURS[index % len(COLOURS)]
        panel.plot(_bins(record), height, color=colour, label=name)
        panel.fill_between(_bins(record), height - error, height + error, color=colour, alpha=0.25, linewidth=0)
    panel.set(xlabel="x / d", ylabel="h / d", ylim=(0, None))
    panel.legend()
    headed(picture, "Full cells hold a heap; without them, or with offsets in them, it flows apart")
    save(picture, stem)


def draw_growth(records, stem):
    """Surfaces while particles come, as they are and over the root of the time."""
    picture, panels = pyplot.subplots(len(records), 2, figsize=(8.4, 0.6 + 2.5 * len(records)), squeeze=False)
    picture.subplots_adjust(left=0.08, right=0.98, top=1 - 0.5 / (0.6 + 2.5 * len(records)), bottom=0.09,
                            wspace=0.2, hspace=0.5)
    for (left, right), (name, record) in zip(panels, records.items()):
        times = record.series["free-surface"][0].time
        samples = _growing(record)
        for sample in samples:
            colour = pyplot.get_cmap("viridis")(0.92 * sample / samples[-1])
            height, _ = _surface(record, sample)
            height[np.abs(_bins(record)) <= np.diff(_bins(record))[0]] = np.nan  # one always falls there
            left.plot(_bins(record), height, color=colour)
            right.plot(_bins(record) / times[sample] ** 0.5, height / times[sample] ** 0.5, color=colour)
        left.set(title=name, xlabel="x / d", ylabel="h / d")
        right.set(title="collapsed (3.13)", xlabel="x / (d √t)", ylabel="h / (d √t)")
    headed(picture, "Growing heaps have one shape")
    save(picture, stem)


PICTURES = [
    Picture("surfaces", "Surface of the heap at the end, mean of the replicas; band: one standard error.",
            (SURFACE,), 2, draw_surfaces, wide=True),
    Picture("growth", "Growing heap: surfaces at equal intervals of time, and the same over the root of the "
            "time (Müller 2001, figure 3.26).", (SURFACE,), 2, draw_growth, wide=True),
]
