"""Work-precision pictures: error against CPU time, and against the knob. More accuracy lies lower in each of them,
and finer settings lie to the right."""

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from analysis.plotting import COLOURS, INK, MARKERS, literal, pyplot, save, wrapped
from analysis.words import number

SIZE = (4.6, 3.9)   # inches
RESOLVED = 2        # standard errors from zero


def columns(sweep):
    """knob, error, its standard error and CPU seconds of the points that a logarithmic axis can show."""
    rows = [(p.knob, p.error, p.stderr or 0.0, p.cpu_seconds or np.nan) for p in sweep.points
            if p.error is not None and p.error > 0 and p.knob is not None and p.knob > 0]
    return np.array(sorted(rows), float).reshape(-1, 4).T


def resolved(error, stderr):
    """Points whose error stands out of the noise; the fit of the order rests on them."""
    return error > RESOLVED * stderr


def power_line(knob, error, order):
    """error = c·knob^order with c through the logarithmic mean of these points."""
    level = np.mean(np.log(error) - order * np.log(knob))
    ends = np.array([knob.min(), knob.max()])
    return ends, np.exp(level + order * np.log(ends))


def finer_is_larger(sweep):
    """Whether a larger knob is the more accurate one."""
    order = sweep.expected_order if sweep.expected_order is not None else sweep.order
    return order is not None and order < 0


def share(sweep, error):
    """An error in per cent of the reference; plain where there is none."""
    return 100 * error / abs(sweep.reference) if sweep.reference else error


def _axes(sweep, x_label):
    picture, panel = pyplot.subplots(figsize=SIZE)
    picture.subplots_adjust(left=0.18, right=0.97, top=0.82, bottom=0.17)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlabel(wrapped(x_label, 50))
    unit = "% of the reference" if sweep.reference else sweep.units
    panel.set_ylabel(wrapped(f"error of the {sweep.quantity} [{unit}]", 30))
    return picture, panel


def _points(panel, x, error, stderr, index, name):
    """Draws one sweep; returns whether some of its points are not resolved."""
    clear = resolved(error, stderr)
    colour, marker = COLOURS[index % len(COLOURS)], MARKERS[index % len(MARKERS)]
    panel.plot(x, error, color=colour, linewidth=0.8, alpha=0.5)
    lower = np.where(clear, stderr, np.minimum(stderr, 0.9 * error))
    for chosen, face in ((clear, colour), (~clear, "white")):
        if chosen.any():
            panel.errorbar(x[chosen], error[chosen], yerr=[lower[chosen], stderr[chosen]], fmt=marker, color=colour,
                           capsize=2, markerfacecolor=face, elinewidth=1)
    panel.plot([], [], marker=marker, color=colour, linewidth=0.8, label=wrapped(name, 34))
    return not clear.all()


def _plain(value, _):
    return number(value, 3)


def _few_ticks(axis, ends):
    """Labels at 1, 2 and 5 where the axis spans little, else at the powers of ten; none of the others."""
    narrow = ends[1] / ends[0] < 50
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if narrow else (1,), numticks=12))
    axis.set_major_formatter(FuncFormatter(_plain))
    axis.set_minor_formatter(NullFormatter())


def _finish(picture, panel, stem, unclear):
    """The legend stands above the panel, where no point is."""
    if unclear:
        panel.plot([], [], "o", color="#777777", markerfacecolor="white", label="within 2 std. errors of zero")
    handles, names = panel.get_legend_handles_labels()
    if handles:
        picture.legend(handles, names, loc="upper left", bbox_to_anchor=(0.12, 1.0), ncol=2, fontsize=8.5,
                       columnspacing=1.2, handletextpad=0.4, labelspacing=0.3)
        _few_ticks(panel.xaxis, panel.get_xlim())
        _few_ticks(panel.yaxis, panel.get_ylim())
    else:
        panel.text(0.5, 0.5, "no error above zero", transform=panel.transAxes, ha="center", color="#777777")
    save(picture, stem)


def draw_knob(sweep, stem):
    """Error against the knob, finer to the right, with the fitted and the expected order."""
    picture, panel = _axes(sweep, f"{sweep.knob_label},\u00a0finer\u00a0to\u00a0the\u00a0right")
    knob, error, stderr, _ = columns(sweep)
    unclear = False
    if knob.size:
        unclear = _points(panel, knob, share(sweep, error), share(sweep, stderr), 0, sweep.variant)
        _orders(panel, sweep, knob, share(sweep, error), resolved(error, stderr))
        if not finer_is_larger(sweep):
            panel.set_xlim(*reversed(panel.get_xlim()))
    _finish(picture, panel, stem, unclear)


def _orders(panel, sweep, knob, error, clear):
    chosen = clear if clear.sum() > 1 else np.ones_like(clear)
    named = ((sweep.order, "-", "fitted order"), (sweep.expected_order, "--", "expected order"))
    for order, style, name in named:
        if order is not None:
            x, y = power_line(knob[chosen], error[chosen], order)
            panel.plot(x, y, style, color=INK, linewidth=1.2, label=f"{name} {number(order, 3)}")


def draw_frontier(sweeps, stem):
    """Error against CPU time, the sweeps of one quantity in one picture: lower is more accurate, left is cheaper."""
    picture, panel = _axes(sweeps[0], "CPU time [s], cheaper to the left")
    unclear, several = False, len({sweep.variant for sweep in sweeps}) > 1
    for index, sweep in enumerate(sweeps):
        _, error, stderr, cost = columns(sweep)
        if error.size and np.isfinite(cost).any():
            name = f"{sweep.variant}, {sweep.knob}" if several or len(sweeps) == 1 else sweep.knob
            unclear |= _points(panel, cost, share(sweep, error), share(sweep, stderr), index, literal(name))
    _finish(picture, panel, stem, unclear)
