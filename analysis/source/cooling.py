"""Figures 3.2 to 3.4: homogeneous cooling."""

import numpy as np

from analysis.source.methods import OWN, PLAIN
from analysis.source.panels import BLACK, finish, panels, shade
from analysis.source.runs import Lacking, mean_error


def _collisions(run, name):
    """Collisions per particle at the samples of a series, mean over replicas."""
    count = run.species["count"]
    return np.mean([2 * np.interp(item.time, hits.time, hits.value) / count
                    for item, hits in zip(run.series(name), run.series("collisions"))], axis=0)


def _haff_time(run):
    """t0 from the slope of sqrt(E0/E) = 1 + t/t0 over each replica; mean."""
    slopes = [np.polyfit(item.time, np.sqrt(item.value[0] / item.value), 1)[0] for item in run.series("energy")]
    return 1 / np.mean(slopes)


def _draw_energies(panel, runs, label):
    for index, run in enumerate(runs):
        t0 = _haff_time(run)
        series = run.series("energy")
        last = min(item.time[-1] for item in series)
        times = np.geomspace(last / 1e4, last, 60)
        logs = [np.interp(times, item.time, np.log(item.value / item.value[0])) for item in series]
        panel.plot(times / t0, np.exp(np.mean(logs, axis=0)), "o", markerfacecolor="none", markersize=4,
                   color=shade(index, len(runs)), label=label(run), markevery=(index % 3, 3))
    x = np.geomspace(1e-2, panel.get_xlim()[1], 200)
    panel.plot(x, (1 + x) ** -2.0, color=BLACK, linewidth=1, label="(1 + t/t0)⁻²", zorder=1)
    panel.set(xscale="log", yscale="log", xlabel="t / t0", ylabel="E / E0", xlim=(1e-2, None))
    panel.legend()


def draw_dilute(case, stem):
    runs = [run for run in case.choose("dilute-*", OWN)]
    picture, [[panel]] = panels()
    _draw_energies(panel, sorted(runs, key=lambda run: run.species["restitution"]),
                   lambda run: f"r = {run.species['restitution']:g}")
    finish(picture, "3.2", f"Dilute gas, {OWN}: Haff's law for every r", stem)


def draw_dense(case, stem):
    runs = sorted(case.choose("crowded-*", OWN), key=lambda run: run.fraction)
    picture, [[panel]] = panels()
    picture.subplots_adjust(left=0.17)
    for index, run in enumerate(runs):
        series = run.series("energy")
        energy, error = mean_error([item.value / item.value[0] for item in series])
        tau = _collisions(run, "energy")
        panel.plot(tau, energy, color=shade(index, len(runs)), label=f"area fraction {run.fraction:.3g}")
        loss = (1 - run.species["restitution"] ** 2) / 2
    panel.plot(tau, np.exp(-loss * tau), ":", color=BLACK, linewidth=2, label="Haff's law")
    panel.set(xlabel="collisions per particle", ylabel="E / E0")
    panel.legend()
    finish(picture, "3.3", "Full cells, r = 0.99999: the loss per collision is right", stem)


def draw_moments(case, stem):
    try:
        runs = case.choose("moments-*")
    except Lacking:
        runs = case.choose("dilute-*", PLAIN)
    runs = sorted(runs, key=lambda run: run.species["restitution"])
    picture, [row] = panels(len(runs), width=3.4 * len(runs) + 1)
    for panel, run in zip(row, runs):
        series, names = run.series("moments"), run.series("moments")[0].quantity.components
        tau = _collisions(run, "moments")
        for order, maxwell in (("m4", 3), ("m6", 15), ("m8", 105)):
            power = int(order[1]) / 2
            values = [item.value[:, names.index(order)] / item.value[:, names.index("m2")] ** power / maxwell
                      for item in series]
            mean, error = mean_error(values)
            panel.plot(tau, mean, label=f"moment {order[1]}")
            panel.fill_between(tau, mean - error, mean + error, alpha=0.2, linewidth=0)
        panel.axhline(1, color=BLACK, linewidth=1)
        panel.set(title=f"r = {run.species['restitution']:g}", xlabel="collisions per particle")
    row[0].set_ylabel("over Maxwell's value")
    row[0].legend(loc="lower left")
    finish(picture, "3.4", "Moments leave Maxwell's values", stem)


FIGURES = {"3.2": draw_dilute, "3.3": draw_dense, "3.4": draw_moments}
