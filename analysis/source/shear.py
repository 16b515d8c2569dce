"""Figures 3.12 and 3.13: shear between moving walls."""

import numpy as np

from analysis.source.panels import BLACK, finish, marks, ordered, panels, style
from analysis.source.runs import Lacking, mean_error


def _speed(run):
    """Of one wall relative to the other, along x."""
    walls = {wall["side"]: wall.get("velocity", [0.0])[0] for wall in run.scene.get("wall", [])}
    return walls.get("y-high", 0.0) - walls.get("y-low", 0.0)


def _late(series):
    """Samples of the second half."""
    return [item.value[len(item.value) // 2:] for item in series]


def draw_profile(case, stem):
    runs = [run for run in case.choose("v-*") if abs(_speed(run) - 1) < 1e-9]
    if not runs:
        raise Lacking("no run with a wall speed of 1")
    picture, [[panel]] = panels()
    for index, run in enumerate(ordered(runs)):
        fields = _late(run.series("fields"))
        mean, error = mean_error([(item[:, 0, :, 0] * item[:, 0, :, 1]).mean(axis=0) / item[:, 0, :, 0].mean(axis=0)
                                  for item in fields])
        y = (np.arange(len(mean)) + 0.5) / len(mean)
        marks(panel, y, mean, error, index, color=style(run.variant)["color"], label=run.variant, linestyle="none")
    panel.plot([0, 1], [-0.5, 0.5], color=BLACK, linewidth=1, label="linear", zorder=1)
    panel.set(xlabel="y / H", ylabel="velocity along the walls / wall speed")
    panel.legend()
    finish(picture, "3.12", "The velocity profile is linear", stem)


def draw_force(case, stem):
    found = case.choose("v-*")
    if len({_speed(run) for run in found}) < 2:
        raise Lacking("one wall speed: a power law needs two")
    picture, [[panel]] = panels()
    first, speeds = None, []
    for index, (variant, runs) in enumerate(_by_variant(found).items()):
        runs = sorted(runs, key=_speed)
        forces = []
        for run in runs:
            series = run.series("wall-force")
            names = list(series[0].quantity.components)
            at = [names.index(name) for name in ("y-low-x", "y-high-x")]
            flat = [item.reshape(len(item), -1)[:, at] for item in _late(series)]
            forces.append(mean_error([(part[:, 1] - part[:, 0]).mean() / 2 for part in flat]))
        x, (y, error) = [_speed(run) for run in runs], np.abs(np.transpose(forces))
        speeds += x
        first = first or (x[0], y[0])
        marks(panel, x, y, error, index, color=style(variant)["color"], label=variant, linestyle="none")
    guide = np.array([min(speeds), max(speeds)])
    panel.plot(guide, first[1] * (guide / first[0]) ** 2, color=BLACK, linewidth=1, label="v²", zorder=1)
    panel.set(xscale="log", yscale="log", xlabel="wall speed v", ylabel="force F along the walls")
    panel.legend()
    finish(picture, "3.13", "Bagnold: the force goes as v²", stem)


def _by_variant(runs):
    groups = {}
    for run in ordered(runs):
        groups.setdefault(run.variant, []).append(run)
    return groups


FIGURES = {"3.12": draw_profile, "3.13": draw_force}
