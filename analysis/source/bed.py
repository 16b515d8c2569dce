"""Figures 3.42 to 3.44: vibrated beds."""

import numpy as np

from analysis.source.panels import BLACK, finish, marks, middle, ordered, panels, style
from analysis.source.runs import Lacking, mean_error

REST = 2.492e-3   # height of the centre of mass at rest: the source's number


def _walls(run):
    return {wall["side"]: wall for wall in run.scene.get("wall", [])}


def speed(run):
    """V = 2 pi A f of the bottom."""
    bottom = next((wall for wall in _walls(run).values() if "amplitude" in wall), None)
    return 2 * np.pi * bottom["amplitude"] * bottom["frequency"] if bottom else 0.0


def restitutions(run):
    """(of particles, of side walls)"""
    return run.species["restitution"], _walls(run).get("x-low", {}).get("restitution", 1.0)


def _beds(case, r=None, w=None):
    """Beds in two dimensions between side walls."""
    found = [run for run in case.choose("r-*") if (r, w) == (None, None) or restitutions(run) == (r, w)]
    if not found:
        raise Lacking(f"no bed with restitutions {r} and {w}" if r else "no bed")
    return found


def height(run):
    """Height of the centre of mass: mean of all but the first quarter, and its error over replicas."""
    return mean_error([item.value[len(item.value) // 4:, -1].mean() for item in run.series("centre-of-mass")])


def _by_variant(runs):
    groups = {}
    for run in ordered(runs):
        groups.setdefault(run.variant, []).append(run)
    return groups


def _draw_heights(panel, runs, less):
    for index, (variant, group) in enumerate(_by_variant(runs).items()):
        rows = np.array(sorted((speed(run), *height(run)) for run in group))
        rows = rows[rows[:, 1] > less]   # a bed below the height at rest has no place on a logarithmic axis
        marks(panel, rows[:, 0], (rows[:, 1] - less) * 1e3, rows[:, 2] * 1e3, index,
              color=style(variant)["color"], linestyle="-", label=variant)
    panel.set(xscale="log", yscale="log", xlabel="V [m/s]")


def draw_methods(case, stem):
    picture, [[panel]] = panels()
    _draw_heights(panel, _beds(case, 0.9, 1.0), 0)
    panel.axhline(REST * 1e3, linestyle=":", color=BLACK, label="at rest")
    panel.set_ylabel("height of the centre of mass H [mm]")
    panel.legend()
    finish(picture, "3.42", "Height against V, elastic walls, r = 0.9 (left part)", stem)


def draw_velocities(case, stem):
    runs = [run for run in _beds(case, 0.9, 1.0) if abs(speed(run) - 0.6) < 1e-3]
    if not runs:
        raise Lacking("no bed at V = 0.6 m/s")
    picture, [row] = panels(2)
    for run in ordered(runs):
        for panel, axis, name in zip(row, ("x", "y"), ("U_x", "U_z")):
            series = run.series(f"velocity-histogram-{axis}")
            counts = sum(item.value[len(item.value) // 4:].sum(axis=0) for item in series)
            edges = np.array(series[0].quantity.axis)
            share = counts / counts.sum() / np.diff(edges)
            panel.plot(middle(edges), np.where(share > 0, share, np.nan), label=run.variant, **style(run.variant))
            panel.set(yscale="log", xlabel=f"{name} [m/s]", xlim=(-2.5, 2.5))
    row[0].set_ylabel("P(U) [s/m]")
    row[0].legend()
    finish(picture, "3.43", "Velocities at V = 0.6 m/s: horizontal even, vertical skewed", stem)


def draw_scaling(case, stem):
    pairs = [(0.9, 1.0), (0.9, 0.9), (1.0, 0.9)]
    runs = {pair: [run for run in _beds(case) if restitutions(run) == pair] for pair in pairs}
    runs = {pair: group for pair, group in runs.items() if len({speed(run) for run in group}) > 1}
    if not runs:
        raise Lacking("no pair of restitutions at two speeds")
    picture, [row] = panels(len(runs))
    for panel, ((r, w), group) in zip(row, runs.items()):
        _draw_heights(panel, group, REST)
        low, high = panel.get_xlim()
        guide, top = np.array([max(low, high / 10), high]), panel.get_ylim()[1]
        for power, line in ((2, ":"), (1.5, "--"), (1, "-.")):
            panel.plot(guide, 0.7 * top * (guide / high) ** power, line, color=BLACK, linewidth=1, label=f"V^{power}")
        panel.set(title=f"r = {r:g}, walls {w:g}")
        panel.legend(fontsize=7.5)
    row[0].set_ylabel("H(V) - H(0) [mm]")
    finish(picture, "3.44", "Rise of the bed against V", stem)


FIGURES = {"3.42": draw_methods, "3.43": draw_velocities, "3.44": draw_scaling}
