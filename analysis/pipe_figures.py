"""The case 'pipe-flow' as pictures: density along the pipe against time, and its power spectrum (Müller 2001, 3.11)."""

from types import SimpleNamespace

import numpy as np

from analysis.clustering_figures import Picture
from analysis.plotting import COLOURS, headed, pyplot, save

FIELDS = "sandglass/series/fields"
DENSEST = 0.85   # black, in area fractions


def load_slices(path):
    """Area fraction of disks of diameter one in slices along y: [replica, sample, slice], and the times."""
    import h5py
    with h5py.File(path, "r") as file:
        density = file[FIELDS + "/value"][()][:, :, 0, :, 0]
        time = file[FIELDS + "/time"][0]
        length = float(np.ravel(file["particles/all/box/edges"][()])[-1])
    return SimpleNamespace(time=time, fraction=density * np.pi / 4, length=length)


def draw_space_time(runs, stem):
    """A row for each method, first replica; gravity points down."""
    picture, panels = pyplot.subplots(len(runs), 1, figsize=(8.4, 0.9 + 1.7 * len(runs)), sharex=True,
                                      squeeze=False)
    picture.subplots_adjust(left=0.08, right=0.98, top=1 - 0.5 / (0.9 + 1.7 * len(runs)), bottom=0.1, hspace=0.3)
    for panel, (name, run) in zip(panels[:, 0], runs.items()):
        panel.imshow(run.fraction[0].T, origin="lower", aspect="auto", cmap="Greys", vmin=0, vmax=DENSEST,
                     extent=(run.time[0], run.time[-1], 0, run.length), interpolation="nearest")
        panel.set(title=name, ylabel="y / d")
        panel.grid(False)
    panels[-1][0].set_xlabel("time")
    headed(picture, "Density along the pipe (white: none, black: area fraction 0.85 and more)")
    save(picture, stem)


def mean_spectrum(run):
    """Frequencies and the mean of the lines over slices and replicas, of the second half of the run."""
    late = run.fraction[:, run.fraction.shape[1] // 2:]
    samples = late.shape[1]
    lines = np.abs(np.fft.rfft(late - late.mean(axis=1, keepdims=True), axis=1)) ** 2
    power = 2 * lines.mean(axis=(0, 2)) / samples ** 2
    return np.arange(len(power)) / (run.time[-1] - run.time[-samples]), power


def draw_spectra(runs, stem):
    """Power spectrum of the area fraction in a slice, with the slope of the source."""
    picture, panel = pyplot.subplots(figsize=(5.2, 3.9))
    picture.subplots_adjust(left=0.15, right=0.96, top=0.88, bottom=0.14)
    for index, (name, run) in enumerate(runs.items()):
        frequency, power = mean_spectrum(run)
        panel.plot(frequency[1:-1], power[1:-1], color=COLOURS[index % len(COLOURS)], label=name)
    first = 1 + np.argmax(power[1:-1])
    guide = frequency[first] * np.array([1, 15])
    panel.plot(guide, 1.5 * power[first] * (guide / guide[0]) ** -1.3, ":", color="#333333", label="slope -1.3")
    panel.set(xscale="log", yscale="log", xlabel="frequency", ylabel="P(f)")
    panel.legend()
    headed(picture, "Power spectrum of the area fraction in a slice")
    save(picture, stem)


PICTURES = [
    Picture("space-time", "Density along the pipe against time, first replica.", (FIELDS,), 1, draw_space_time,
            load_slices, wide=True),
    Picture("spectra", "Power spectrum of the density in a slice, mean over slices and replicas.", (FIELDS,), 1,
            draw_spectra, load_slices),
]
