"""Figures 3.33 to 3.41: correlations in cooling gases."""

import numpy as np

from analysis.clustering_panels import MANY, show_density, show_disks
from analysis.impact import fitted, share_below
from analysis.source.methods import EXACT, FITTED
from analysis.source.panels import BLACK, band, finish, marks, middle, ordered, panels, shade, style
from analysis.source.runs import Lacking, mean_error


def gases(case, **wanted):
    """{(area fraction, r): runs} of the largest gases, of those with the wanted fraction or r."""
    groups, sizes = {}, {}
    for run in case.choose():
        key = round(run.fraction, 3), run.species["restitution"]
        if wanted.get("nu", key[0]) == key[0] and wanted.get("r", key[1]) == key[1]:
            groups.setdefault(key, []).append(run)
            sizes[key] = max(sizes.get(key, 0), run.species["count"])
    if not groups:
        raise Lacking("no gas with " + ", ".join(f"{key} = {value}" for key, value in wanted.items()))
    return {key: ordered(run for run in groups[key] if run.species["count"] == sizes[key]) for key in sorted(groups)}


def _tau(run):
    """Collisions per particle at the samples of the energy, mean over replicas."""
    series = run.series("collisions")
    count = min(len(item.value) for item in series)
    return 2 * np.mean([item.value[:count] for item in series], axis=0) / run.species["count"]


def _name(key):
    return f"area fraction {key[0]:g}, r = {key[1]:g}"


def _draw_energy(panel, runs):
    for run in runs:
        tau = _tau(run)
        logs = [np.log(item.value[:len(tau)] / item.value[0]) for item in run.series("energy")]
        mean, error = mean_error(logs)
        band(panel, tau, mean, error, label=run.variant, **style(run.variant))
    panel.set(xlabel="collisions per particle", ylabel="ln(E/E0)")
    panel.legend()


def draw_energies(case, stem):
    groups = gases(case)
    picture, rows = panels(2, (len(groups) + 1) // 2) if len(groups) > 1 else panels()
    for panel, (key, runs) in zip(rows.flat, groups.items()):
        _draw_energy(panel, [run for run in runs if not run.variant.endswith(FITTED)])
        panel.set_title(_name(key))
    finish(picture, "3.34", "Energy per collision", stem)


def draw_corrected(case, stem):
    groups = {key: runs for key, runs in gases(case, r=0.85).items() if any(run.variant.endswith(FITTED) for run in runs)}
    if not groups:
        raise Lacking("no run with fitted impact parameters")
    picture, [row] = panels(len(groups))
    for panel, (key, runs) in zip(row, groups.items()):
        _draw_energy(panel, runs)
        panel.set_title(_name(key))
    finish(picture, "3.37", "Energy with fitted impact parameters (dashed) and without", stem)


def _windows(run, width):
    """[(tau in the middle, edges, counts of all replicas)]"""
    series, rows = run.series("impact-parameter"), {}
    for item in series:
        ends = 2 * np.cumsum(item.value.sum(axis=1)) / run.species["count"]
        for end, counts in zip(ends, item.value):
            rows[int((end - 1e-3) // width)] = rows.get(int((end - 1e-3) // width), 0) + counts
    edges = np.array(series[0].quantity.axis)
    return [((index + 0.5) * width, edges, rows[index]) for index in sorted(rows) if np.all(rows[index] > 0)]


def _contacts(case, **wanted):
    found = {key: run for key, runs in gases(case, **wanted).items() for run in runs if run.variant == EXACT}
    if not found:
        raise Lacking(f"no run of {EXACT}")
    return found


def draw_impacts(case, stem):
    found = _contacts(case, r=0.85)
    picture, [row] = panels(len(found))
    for panel, (key, run) in zip(row, found.items()):
        windows = _windows(run, 20.0)
        shown = windows[1::max(1, len(windows) // 4)]
        for index, (tau, edges, counts) in enumerate(shown):
            colour, bins = shade(index, len(shown)), middle(edges)
            panel.plot(bins, counts / counts.mean(), "o", markersize=3, color=colour, label=f"tau = {tau:g}")
            c, _ = fitted(edges, counts)
            panel.plot(bins, np.diff(share_below(c, edges)) * len(bins), color=colour, linewidth=1)
        panel.set(xlabel="b / d", title=_name(key))
        panel.legend()
    row[0].set_ylabel("P(b/d), with fits of (3.18)")
    finish(picture, "3.35", "Impact parameters turn grazing as clusters form", stem)


def draw_coefficient(case, stem):
    picture, [[panel]] = panels()
    for index, (key, run) in enumerate(_contacts(case, r=0.85).items()):
        rows = np.array([(tau, *fitted(edges, counts)) for tau, edges, counts in _windows(run, 10.0)])
        marks(panel, *rows.T, index, color=shade(index, 2), linestyle="-", label=f"area fraction {key[0]:g}")
    panel.axhline(0, color=BLACK, linewidth=1)
    panel.set(xlabel="collisions per particle", ylabel="c of a/(1 - c b²)")
    panel.legend()
    finish(picture, "3.36", "c of the impact distribution, r = 0.85", stem)


def pairs(run):
    """(r, {name: (mean, error)}) of G_nn over n², G_par and G_perp over the temperature, at the last sample."""
    found, edges = {}, np.array(run.series("pair-correlation")[0].quantity.axis)
    density = [item.value[-1] - 1 for item in run.series("pair-correlation")]
    found["G_nn / n²"] = mean_error(density)
    energies = run.series("energy")
    for name, label in (("parallel", "G_par / (T/m)"), ("transverse", "G_perp / (T/m)")):
        values = []
        for item, energy in zip(run.series(f"pair-velocity-{name}"), energies):
            heat = np.interp(item.time[-1], energy.time, energy.value) / run.species["count"]
            values.append(item.value[-1] / heat)
        found[label] = mean_error(values)
    return middle(edges), found


def draw_pairs(number, nu, r):
    def draw(case, stem):
        [(key, runs)] = gases(case, nu=nu, r=r).items()
        runs = [run for run in runs if "pair-velocity-parallel" in run.record.series]
        if not runs:
            raise Lacking("no run that observes pair-correlation and pair-velocity")
        picture, [row] = panels(3, width=11.5)
        for run in runs:
            distance, found = pairs(run)
            for panel, (label, (mean, error)) in zip(row, found.items()):
                band(panel, distance, mean, error, label=run.variant, **style(run.variant))
                panel.set(xlabel="r / d", title=label, xscale="log", xlim=(0.5, None))
        for panel in row:
            panel.axhline(0, color=BLACK, linewidth=0.8)
        row[0].legend()
        finish(picture, number, f"Pair correlations at 140 collisions per particle, {_name(key)}", stem)
    return draw


def draw_frames(case, stem):
    import h5py
    found = {}
    for key, run in _contacts(case).items():
        with h5py.File(run.path, "r") as file:
            if "particles/all/position/value" in file:
                found[key] = file["particles/all/position/value"][-1], np.ravel(file["particles/all/box/edges"][()])
    if not found:
        raise Lacking("no record with frames of particles")
    picture, rows = panels(2, (len(found) + 1) // 2) if len(found) > 1 else panels()
    for panel, (key, (position, edges)) in zip(rows.flat, found.items()):
        (show_density(panel, position, edges) if len(position) > MANY else show_disks(panel, position))
        panel.set(xlim=(0, edges[0]), ylim=(0, edges[1]), aspect="equal", xticks=[], yticks=[], title=_name(key))
    finish(picture, "3.33", "The gases at the end: hard disks", stem)


FIGURES = {"3.33": draw_frames, "3.34": draw_energies, "3.35": draw_impacts, "3.36": draw_coefficient,
           "3.37": draw_corrected, "3.38": draw_pairs("3.38", 0.05, 0.98), "3.39": draw_pairs("3.39", 0.245, 0.98),
           "3.40": draw_pairs("3.40", 0.05, 0.85), "3.41": draw_pairs("3.41", 0.245, 0.85)}
