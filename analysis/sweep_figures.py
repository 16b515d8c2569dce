"""Work-precision pictures: error against CPU time, and against the knob with the fitted order."""

import numpy as np

from analysis.plotting import COLOURS, MARKERS, literal, pyplot, save, wrapped
from analysis.words import labelled, number


def columns(sweep):
    """knob, error, its standard error and CPU seconds of the points that a logarithmic axis can show."""
    rows = [(p.knob, p.error, p.stderr or 0.0, p.cpu_seconds if p.cpu_seconds else np.nan) for p in sweep.points
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
    picture, panel = pyplot.subplots(figsize=(5.2, 4))
    picture.subplots_adjust(left=0.16, right=0.96, top=0.86, bottom=0.14)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlabel(wrapped(x_label, 60))
    panel.set_ylabel(wrapped(labelled(f"error of {sweep.quantity}", sweep.units), 40))
    return picture, panel


def _points(panel, x, error, stderr, index, name):
    clear = resolved(error, stderr)
    colour, marker = COLOURS[index % len(COLOURS)], MARKERS[index % len(MARKERS)]
    panel.plot(x, error, color=colour, linewidth=0.8, alpha=0.5)
    for chosen, face in ((clear, colour), (~clear, "white")):
        if chosen.any():
            label = name if face == colour else f"{name}: within 2 std. errors of zero"
            panel.errorbar(x[chosen], error[chosen], yerr=stderr[chosen], fmt=marker, color=colour, capsize=2,
                           markerfacecolor=face, elinewidth=1, label=wrapped(label, 44))


def _finish(picture, panel, title, stem):
    if panel.get_legend_handles_labels()[0]:
        panel.legend()
    else:
        panel.text(0.5, 0.5, "no error above zero", transform=panel.transAxes, ha="center", color="#777777")
    picture.suptitle(wrapped(title, 66), x=0.02, y=0.985, ha="left", va="top", fontsize=10.5, weight="bold")
    save(picture, stem)


def draw_knob(sweep, stem):
    """Error against the knob, with the fitted and the expected order."""
    picture, panel = _axes(sweep, sweep.knob_label)
    knob, error, stderr, _ = columns(sweep)
    if knob.size:
        _points(panel, knob, error, stderr, 0, sweep.variant)
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
    for index, sweep in enumerate(sweeps):
        _, error, stderr, cost = columns(sweep)
        if error.size:
            _points(panel, cost, error, stderr, index, literal(f"{sweep.variant}, {sweep.knob}"))
    what = f"{sweeps[0].variant}, {sweeps[0].knob}" if len(sweeps) == 1 else sweeps[0].quantity
    _finish(picture, panel, f"{what}: error against CPU time", stem)
