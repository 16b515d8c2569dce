"""Figures 3.17 to 3.23: flow through a pipe."""

import numpy as np

from analysis import pipe_figures as pictures
from analysis.source.methods import OWN
from analysis.source.panels import BLACK, finish, marks, panels, shade
from analysis.source.runs import Lacking, mean_error


def _fraction(run):
    return round(run.fraction, 3)


def _roughness(run):
    walls = run.scene.get("wall", [])
    return walls[0].get("probability", 1.0) if walls else 0.0


def _falling(case, **wanted):
    """Runs of the source's own method in the field of gravity with the wanted r, nu or p (None: any), one for each scene."""
    of = {"r": lambda run: run.species["restitution"], "nu": _fraction, "p": _roughness}
    found = [run for run in case.choose("*", OWN) if any(run.scene.get("forces", {}).get("gravity", []))]
    found = [run for run in found
             if all(abs(of[key](run) - value) < 1e-9 for key, value in wanted.items() if value is not None)]
    if not found:
        raise Lacking(f"no run of {OWN} with " + ", ".join(f"{key} = {value}" for key, value in wanted.items()))
    return found


def _space_time(runs, number, title, label, stem):
    picture, rows = panels(1, len(runs), width=8.4)
    for [panel], run in zip(rows, runs):
        slices = pictures.load_slices(run.path)
        panel.imshow(slices.fraction[0].T, origin="lower", aspect="auto", cmap="Greys", vmin=0, vmax=pictures.DENSEST,
                     extent=(slices.time[0], slices.time[-1], 0, slices.length), interpolation="nearest")
        panel.set(title=label(run), ylabel="y / d")
        panel.grid(False)
    rows[-1][0].set_xlabel("time")
    finish(picture, number, title, stem)


def _length(run):
    return run.scene["domain"]["size"][-1]


def _by_restitution(runs, length):
    """One run for each restitution, the largest first: of several the one whose `length` of the pipe is least."""
    chosen = {run.species["restitution"]: run for run in sorted(runs, key=lambda run: -length(run))}
    return [chosen[key] for key in sorted(chosen, reverse=True)]


def _restitution(run):
    return f"r = {run.species['restitution']:g}"


def draw_waves(case, stem):
    runs = _by_restitution(_falling(case, nu=0.38, p=0.1), _length)
    _space_time([runs[0], runs[-1]] if len(runs) > 1 else runs, "3.17",
                "Density along the pipe: waves for r = 0 (black: area fraction 0.85)", _restitution, stem)


def draw_slice(case, stem):
    runs = _by_restitution(_falling(case, nu=0.38, p=0.1), _length)
    runs = [runs[0], runs[-1]] if len(runs) > 1 else runs
    picture, [row] = panels(len(runs))
    for panel, run in zip(row, runs):
        slices = pictures.load_slices(run.path)
        panel.plot(slices.time, slices.fraction[0, :, 0], linewidth=0.8)
        panel.set(xlabel="time", title=_restitution(run), ylim=(0, 1))
    row[0].set_ylabel("area fraction in a slice")
    finish(picture, "3.18", "Density in one slice", stem)


def draw_spectra(case, stem):
    runs = _by_restitution(_falling(case, nu=0.38, p=0.1), lambda run: -_length(run))
    picture, [[panel]] = panels()
    for index, run in enumerate(runs):
        frequency, power = pictures.mean_spectrum(pictures.load_slices(run.path))
        panel.plot(frequency[1:-1], power[1:-1], color=shade(index, len(runs)), label=_restitution(run))
    top = max(range(1, len(power) - 1), key=lambda k: power[k])
    guide = frequency[top] * np.array([1, 15])
    panel.plot(guide, 1.5 * power[top] * (guide / guide[0]) ** -1.3, ":", color=BLACK, label="slope -1.3")
    panel.set(xscale="log", yscale="log", xlabel="frequency", ylabel="P(f)")
    panel.legend()
    finish(picture, "3.19", "Power spectrum of the density in a slice", stem)


def _exponents(case, of, **wanted):
    """Rows (x, exponent, error) of the check 'pipe-spectrum', sorted; of several at one x the longest pipe."""
    chosen = {(run.variant, run.point) for run in _falling(case, **wanted)}
    found = {}
    for run, item in case.verdicts("pipe-spectrum"):
        if (run.variant, run.point) in chosen and item.value is not None:
            row = _length(run), item.value, item.stderr or 0.0
            found[of(run)] = max(row, found.get(of(run), row), key=lambda one: one[0])
    return np.array([(x, *found[x][1:]) for x in sorted(found)]).reshape(-1, 3)


def draw_exponent_restitution(case, stem):
    rows = _exponents(case, lambda run: run.species["restitution"], nu=0.38, p=0.1)
    if len(rows) < 2:
        raise Lacking(f"exponents at {len(rows)} restitutions: a curve needs two")
    picture, [[panel]] = panels()
    marks(panel, *rows.T, color="#0072b2", linestyle="-")
    panel.axhline(-1.3, linestyle=":", color=BLACK, label="-1.3")
    panel.set(xlabel="restitution r", ylabel="exponent")
    panel.legend()
    finish(picture, "3.20", "Exponent of the spectrum against restitution", stem)


def draw_exponent_others(case, stem):
    rough = {nu: _exponents(case, _roughness, r=0.0, nu=nu) for nu in (0.38, 0.6)}
    dense = _exponents(case, _fraction, r=0.0, p=0.1)
    if max(len(set(rows[:, 0])) for rows in rough.values()) < 2 and len(set(dense[:, 0])) < 2:
        raise Lacking("exponents at one roughness and one area fraction: a curve needs two")
    picture, [[left, right]] = panels(2)
    for (nu, rows), colour in zip(rough.items(), ("#0072b2", "#d55e00")):
        if len(rows):
            marks(left, *rows.T, color=colour, linestyle="-", label=f"area fraction {nu:g}")
    left.legend()
    left.set(xlabel="wall roughness p", ylabel="exponent", xscale="log")
    marks(right, *dense.T, color="#0072b2")
    right.set(xlabel="area fraction", ylabel="exponent")
    finish(picture, "3.21", "Exponent against roughness and density, r = 0", stem)


def _flow_rate(run):
    """nu times the mean velocity along gravity in the second half, from passages of a plane: mean, error.

    Not from the momentum: particles that are refused their moves keep velocities with which they do not move.
    """
    rates = []
    for item in run.series("crossing-count"):
        half = len(item.time) // 2
        up, down = item.value[-1] - item.value[half]
        rates.append((down - up) / (item.time[-1] - item.time[half]))
    return mean_error(np.array(rates) / run.scene["domain"]["size"][0] * np.pi / 4)


def draw_flow_rate(case, stem):
    runs = [run for run in sorted(_falling(case, r=0.0, p=0.1), key=_fraction)
            if any(item["what"] == "crossings" for item in run.scene["observe"])]
    if len({_fraction(run) for run in runs}) < 2:
        raise Lacking("flow at one area fraction: a diagram needs two")
    rows = np.array([(_fraction(run), *_flow_rate(run)) for run in runs])
    picture, [[panel]] = panels()
    marks(panel, *rows.T, color="#0072b2", label="starts of different speed")
    slope = rows[0, 1] / rows[0, 0]
    panel.plot([0, 0.6], [0, 0.6 * slope], ":", color=BLACK, label="proportional, through our first")
    panel.legend()
    panel.set(xlabel="area fraction", ylabel="flow rate (area fraction × velocity)", xlim=(0, 1), ylim=(0, None))
    finish(picture, "3.22", "Flow rate against area fraction, r = 0", stem)


def draw_densities(case, stem):
    runs = {_fraction(run): run for run in _falling(case, r=0.0, p=0.1)}
    shown = [nu for nu in (0.3, 0.75, 0.88) if nu in runs]
    if len(shown) < 2:
        raise Lacking("fewer than two of the area fractions 0.3, 0.75 and 0.88")
    _space_time([runs[nu] for nu in shown], "3.23", "Density along the pipe at three area fractions, r = 0",
                lambda run: f"area fraction {_fraction(run):g}", stem)


FIGURES = {"3.17": draw_waves, "3.18": draw_slice, "3.19": draw_spectra, "3.20": draw_exponent_restitution,
           "3.21": draw_exponent_others, "3.22": draw_flow_rate, "3.23": draw_densities}
