"""Figures 3.1 to 3.6 of Kawasaki 1986: columns that come to rest, and rough spheres that cool."""

from functools import partial

import numpy as np

from analysis.source.methods import PLAIN
from analysis.source.panels import BLACK, finish, panels, shade
from analysis.source.runs import mean_error

TIMES = (0, 5, 10, 20, 50, 100)   # in mean free paths over the most probable speed
LATE = 100                        # means from there on are those at rest
COOLING = {"1-1": "(1, 1)", "1-minus-1": "(1, -1)", "0.6-1": "(0.6, 1)", "0.6-minus-1": "(0.6, -1)",
           "1-0": "(1, 0)", "0.6-0": "(0.6, 0)"}   # (ε_p, ε_s) of the source


def profile(run, name, component, time):
    """Along y, mean over replicas at a time, or from LATE on for none: (heights, values)."""
    series = run.series(name)
    picked = [item.time >= LATE if time is None else [np.abs(item.time - time).argmin()] for item in series]
    values = [item.value[rows].mean(axis=0).reshape(item.value.shape[2], -1)[:, component]
              for item, rows in zip(series, picked)]
    height = run.scene["domain"]["size"][1]
    return (np.arange(len(values[0])) + 0.5) * height / len(values[0]), mean_error(values)[0]


def law(case, run, species):
    """What the density at rest is held against: (heights, densities) of the evidence; empty without."""
    points = [figure.points[species] for item in case.case.evidence for figure in item.figures
              if item.verdict.check == "sedimentation-profile"
              and (item.verdict.variant, item.verdict.point) == (run.variant, run.point)]
    return (points[0].x, np.array(points[0].expected)) if points else ([], np.array([]))


def _draw(panel, run, name, component, unit, label):
    for index, time in enumerate(TIMES):
        y, values = profile(run, name, component, time)
        panel.plot(values / unit, y, color=shade(index, len(TIMES)), label=f"t = {time}")
    panel.set(xlabel=label, ylabel="y / λ", ylim=(0, None))
    panel.legend(fontsize=7.5)


def _mean_density(run, species):
    return run.scene["species"][species]["count"] / np.prod(run.scene["domain"]["size"])


def draw_density(number, point, case, stem):
    run = case.choose(point, PLAIN)[0]
    names = [item["name"] for item in run.scene["species"]]
    picture, [row] = panels(len(names))
    for species, (panel, name) in enumerate(zip(row, names)):
        unit = _mean_density(run, species)
        _draw(panel, run, "species-density", species, unit, f"n / n₀, {name}")
        y, values = law(case, run, species)
        panel.plot(values / unit, y, color=BLACK, linewidth=2, label="at rest, exact")
        panel.legend(fontsize=7.5)
    finish(picture, number, "Density of a column that comes to rest", stem)


def draw_temperature(case, stem):
    run = case.choose("rough-spheres", PLAIN)[0]
    picture, [[panel]] = panels()
    _draw(panel, run, "fields", -1, run.scene["initial"]["temperature"], "T / T₀ of translation")
    finish(picture, "3.1(b)", "Temperature in a column that comes to rest", stem)


def energies(run):
    """Collisions per particle, and energies of translation and spin over all of the start; means over replicas."""
    moving, turning, hits = (run.series(name) for name in ("energy", "rotational-energy", "collisions"))
    spin = [item.value.reshape(len(item.time), -1)[:, 0] for item in turning]
    start = [one.value[0] + other[0] for one, other in zip(moving, spin)]
    count = 2 / run.species["count"]
    return (mean_error([count * np.interp(item.time, hit.time, hit.value) for item, hit in zip(moving, hits)])[0],
            mean_error([item.value / first for item, first in zip(moving, start)])[0],
            mean_error([item / first for item, first in zip(spin, start)])[0])


def draw_total(case, stem):
    picture, [[panel]] = panels()
    for index, (point, name) in enumerate(COOLING.items()):
        hits, translation, rotation = energies(case.choose(point, PLAIN)[0])
        panel.plot(hits, translation + rotation, color=shade(index, len(COOLING)), label=name,
                   linestyle="--" if point == "1-minus-1" else "-")
    panel.set(xlabel="collisions per particle", ylabel="E / E₀", xlim=(0, 20), ylim=(0, 1.05))
    panel.legend(fontsize=7.5)
    finish(picture, "3.5", "Energy of rough spheres (ε_p, ε_s)", stem)


def draw_parts(case, stem):
    picture, rows = panels(3, 2, width=11)
    for panel, (point, name) in zip(rows.flat, COOLING.items()):
        hits, translation, rotation = energies(case.choose(point, PLAIN)[0])
        panel.plot(hits, translation, color=BLACK, label="translation")
        panel.plot(hits, rotation, "--", color=BLACK, label="spin")
        panel.set(title=f"(ε_p, ε_s) = {name}", xlim=(0, 20), ylim=(0, 0.55))
    rows[0, 0].legend(fontsize=7.5)
    finish(picture, "3.6", "Energies of translation and spin over all of the start, against collisions per particle", stem)


FIGURES = ({number: partial(draw_density, number.replace("a", "(a)"), point)
            for number, point in (("3.1a", "rough-spheres"), ("3.2", "mixture-1-0.464"), ("3.3", "mixture-0.1-1"),
                                  ("3.4", "mixture-0.1-0.464"))}
           | {"3.1b": draw_temperature, "3.5": draw_total, "3.6": draw_parts})
