"""Figures 3.1 to 3.14 of Greenspan 1972: two mixing fluids."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from analysis.plotting import COLOURS, headed, pyplot, save
from analysis.source.runs import Lacking

SIXTEEN_STEPS = range(160, 2081, 240)   # figures 3.1 to 3.9
MANY_STEPS = (2, 69, 300)               # figures 3.10 to 3.12
PATH_FROM, PATH_STEPS = (53.1, 46.9), range(0, 301, 10)   # figure 3.13
FIELD_STEP = 92                         # figure 3.14
HEAVY, LIGHT = COLOURS[1], COLOURS[0]
SMOOTHING = 8.0                         # of the interface: width of the weights, in the source's lengths
MESH = 80


@dataclass(frozen=True)
class Fluids:
    """First replica in the order of the identities: place and velocity [frame, particle, axis], heavy [particle]."""

    step: np.ndarray
    place: np.ndarray
    velocity: np.ndarray
    heavy: np.ndarray
    edges: np.ndarray

    def frame(self, step):
        found = np.flatnonzero(self.step == step)
        if not len(found):
            raise Lacking(f"no frame of step {step}")
        return found[0]


def load_fluids(path):
    """Throws Lacking for a record without frames, identities and two species."""
    import h5py

    with h5py.File(path, "r") as file:
        group = file.get("particles/all")
        wanted = ("position", "velocity", "species", "id")
        if group is None or any(name not in group for name in wanted):
            raise Lacking("no trajectory with identities and two species")
        order = np.argsort(group["id/value"][()], axis=1)
        read = {name: np.array([values[rows] for values, rows in zip(group[f"{name}/value"][()], order)])
                for name in wanted[:3]}
        return Fluids(group["position/step"][()], read["position"], read["velocity"], read["species"][0] == 0,
                      group["box/edges"][()])


def share_of_heavy(place, heavy, edges):
    """Share of the heavy fluid on a mesh, by numbers, each particle spread as a Gaussian: (x, y, share)."""
    x, y = np.meshgrid(*(np.linspace(0, edge, MESH) for edge in edges))
    square = (x[..., None] - place[:, 0])**2 + (y[..., None] - place[:, 1])**2
    weight = np.exp(-(square - square.min(axis=-1, keepdims=True)) / (2 * SMOOTHING**2))
    return x, y, weight[..., heavy].sum(-1) / weight.sum(-1)


def _of(case, point):
    return load_fluids(case.choose(point)[0].path)


def _panel(fluids, title, note):
    picture, panel = pyplot.subplots(figsize=(4.6, 4.9))
    picture.subplots_adjust(left=0.09, right=0.97, top=0.88, bottom=0.06)
    panel.set(xlim=(0, fluids.edges[0]), ylim=(0, fluids.edges[1]), aspect="equal", title=note)
    panel.grid(False)
    headed(picture, title)
    return picture, panel


def _letters(panel, place, heavy, size):
    for kind, letter, colour in ((heavy, "A", HEAVY), (~heavy, "B", LIGHT)):
        for x, y in place[kind]:
            panel.text(x, y, letter, color=colour, fontsize=size, ha="center", va="center", weight="bold")


def draw_sixteen(step, case, stem):
    fluids = _of(case, "example-1")
    fate = "as the printed start says" if step <= 640 else "one outcome of many"
    picture, panel = _panel(fluids, f"Example 1, step {step}", fate)
    _letters(panel, fluids.place[fluids.frame(step)], fluids.heavy, 12)
    save(picture, stem)


def draw_many(step, case, stem):
    """The line is where the nearby particles are half heavy: the source's boundary is drawn by hand."""
    fluids = _of(case, "example-2")
    place = fluids.place[fluids.frame(step)]
    picture, panel = _panel(fluids, f"Example 2, step {step}", "colour: share of heavy ones nearby; line: a half")
    x, y, share = share_of_heavy(place, fluids.heavy, fluids.edges)
    panel.contourf(x, y, share, levels=np.linspace(0, 1, 11), cmap="PuOr_r", alpha=0.35)
    if share.min() < 0.5 < share.max():
        panel.contour(x, y, share, levels=[0.5], colors="black", linewidths=1)
    _letters(panel, place, fluids.heavy, 6.5)
    save(picture, stem)


def draw_path(case, stem):
    fluids = _of(case, "example-2")
    start = np.argmin(np.linalg.norm(fluids.place[fluids.frame(0)] - PATH_FROM, axis=1))
    path = np.array([fluids.place[fluids.frame(step), start] for step in PATH_STEPS])
    picture, panel = _panel(fluids, "Path of one particle", f"from ({path[0, 0]:.1f}, {path[0, 1]:.1f}), every tenth step")
    panel.plot(*path.T, color="#999999", linewidth=0.9)
    panel.scatter(*path.T, c=list(PATH_STEPS), cmap="viridis", s=18, zorder=3)
    for k in range(0, len(path), 5):
        panel.annotate(f"{PATH_STEPS[k]}", path[k], textcoords="offset points", xytext=(4, 4), fontsize=7)
    save(picture, stem)


def draw_directions(case, stem):
    fluids = _of(case, "example-2")
    frame = fluids.frame(FIELD_STEP)
    place, velocity = fluids.place[frame], fluids.velocity[frame]
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    unit = velocity / np.where(speed > 0, speed, 1)
    picture, panel = _panel(fluids, f"Directions of motion, step {FIELD_STEP}", "all of one length; orange: heavy")
    panel.quiver(*place.T, *unit.T, color=np.where(fluids.heavy, HEAVY, LIGHT), scale=28, width=0.003)
    save(picture, stem)


FIGURES = ({f"3.{index + 1}": partial(draw_sixteen, step) for index, step in enumerate(SIXTEEN_STEPS)}
           | {f"3.{index + 10}": partial(draw_many, step) for index, step in enumerate(MANY_STEPS)}
           | {"3.13": draw_path, "3.14": draw_directions})
