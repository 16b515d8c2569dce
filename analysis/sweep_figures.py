"""Work-precision pictures: error against CPU time, and against the knob with the fitted order."""

import numpy as np

from analysis.plotting import COLOURS, MARKERS, axis_label, headed, pyplot, save, wrapped
from analysis.words import number


def columns(sweep):
    """knob, error, its standard error and CPU seconds of the points that a logarithmic axis can show."""
    rows = [(p.knob, p.error, p.stderr or 0.0, p.cpu_seconds or np.nan) for p in sweep.points
            if p.error is not None and p.error > 0 and p.knob is not None and p.knob > 0]
    return np.array(sorted(rows), float).reshape(-1, 4).T


def resolved(error, stderr):
    """Points whose error stands out of the noise; the fit of the order rests on them."""
    return error > 2 * stderr


def power_line(knob, error, order):
    """error = c·knob^order with c through the logarithmic mean of these points."""
    level = np.mean(np.log(error) - order * np.log(knob))
    ends = np.array([knob.min(), knob.max()])
    return ends, np.exp(level + order * np.log(ends))


def _axes(sweep, x_label):
    picture, panel = pyplot.subplots(figsize=(4.4, 3.5))
    picture.subplots_adjust(left=0.2, right=0.96, top=0.9, bottom=0.15)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlabel(wrapped(x_label, 48, 1))
    panel.set_ylabel(axis_label(f"error of {sweep.quantity}", sweep.units, 34))
    return picture, panel


def _points(panel, x, error, stderr, index, name):
    """Draws one sweep; returns whether some of its points are not resolved."""
    clear = resolved(error, stderr)
    colour, marker = COLOURS[index % len(COLOURS)], MARKERS[index % len(MARKERS)]
    panel.plot(x, error, color=colour, linewidth=0.8, alpha=0.5)
    for chosen, face in ((clear, colour), (~clear, "white")):
        if chosen.any():
            panel.errorbar(x[chosen], error[chosen], yerr=stderr[chosen], fmt=marker, color=colour, capsize=2,
                           markerfacecolor=face, elinewidth=1)
    panel.plot([], [], marker=marker, color=colour, linewidth=0.8, label=wrapped(name, 34))
    return not clear.all()


def _note(panel, unclear):
    if unclear:
        panel.plot([], [], "o", color="#777777", markerfacecolor="white",
                   label="within 2 std. errors of zero")


def _ticks(panel, knob):
    """The knob's own values, where they have room."""
    if knob.size <= 8:
        panel.set_xticks(knob, [number(value, 3) for value in knob], minor=False)
        panel.set_xticks([], minor=True)


def _finish(picture, panel, title, stem):
    if panel.get_legend_handles_labels()[0]:
        panel.legend()
    else:
        panel.text(0.5, 0.5, "no error above zero", transform=panel.transAxes, ha="center", color="#777777")
    headed(picture, wrapped(title, 48, 1))
    save(picture, stem)


def draw_knob(sweep, stem):
    """Error against the knob, with the fitted and the expected order."""
    picture, panel = _axes(sweep, sweep.knob_label)
    knob, error, stderr, _ = columns(sweep)
    if knob.size:
        unclear = _points(panel, knob, error, stderr, 0, sweep.variant)
        _note(panel, unclear)
        _ticks(panel, knob)
        _orders(panel, sweep, knob, error, resolved(error, stderr))
    _finish(picture, panel, f"{sweep.variant}: error against {sweep.knob}", stem)


def _orders(panel, sweep, knob, error, clear):
    chosen = clear if clear.sum() > 1 else np.ones_like(clear)
    named = ((sweep.order, "-", "fitted order"), (sweep.expected_order, "--", "expected order"))
    for order, style, name in named:
        if order is not None:
            x, y = power_line(knob[chosen], error[chosen], order)
            panel.plot(x, y, style, color="#333333", linewidth=1.2, label=f"{name} {number(order, 3)}")


def draw_cost(sweeps, stem):
    """Error against CPU time; several sweeps of one quantity share a picture."""
    picture, panel = _axes(sweeps[0], "CPU time [s]")
    unclear = False
    for index, sweep in enumerate(sweeps):
        _, error, stderr, cost = columns(sweep)
        if error.size:
            unclear |= _points(panel, cost, error, stderr, index, f"{sweep.variant}, {sweep.knob}")
    _note(panel, unclear)
    what = f"{sweeps[0].variant}, {sweeps[0].knob}" if len(sweeps) == 1 else sweeps[0].quantity
    _finish(picture, panel, f"{what}: error against CPU time", stem)
