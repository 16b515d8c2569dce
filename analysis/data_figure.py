"""The data behind a check: several runs in one picture, theory as a line above the markers, residuals below."""

import numpy as np
from matplotlib.ticker import NullFormatter

from analysis.plotting import INK, axis_label, literal, method_look, save, wrapped
from analysis.residual import STANDARD, residual
from analysis.two_panels import BANDS, band, frame, is_spread, known, legend, plain_ticks
from analysis.words import labelled

FAR = 6                 # a residual beyond this many standard errors stands at the edge
SMALLEST = 1e-12        # what a logarithmic axis shows of values
MOST = 28               # markers of one set of data


def _thin(x, logarithmic):
    """Indices of at most MOST values that are spread over the axis."""
    if len(x) <= MOST:
        return np.arange(len(x))
    if not logarithmic:
        return np.unique(np.linspace(0, len(x) - 1, MOST).astype(int))
    positive = np.array([value if value > 0 else np.nan for value in x])
    wanted = np.geomspace(np.nanmin(positive), np.nanmax(positive), MOST)
    return np.unique([int(np.nanargmin(np.abs(np.log(positive / each)))) for each in wanted])


def _curve(panel, lower, item, figure, variants, first):
    """One run: data as markers, theory as a line above them; returns the label of its residuals."""
    label = ""
    for line in figure.lines:
        panel.plot(line.x, line.y, color=INK, linewidth=1.1, zorder=6,
                   label="theory" if first else None)
    for index, points in enumerate(figure.points):
        if not np.isfinite(points.y).any():
            continue
        look = method_look(item.verdict.variant, variants)
        chosen = _thin(points.x, panel.get_xscale() == "log")
        x, y = np.array(points.x)[chosen], np.array(points.y)[chosen]
        error = np.nan_to_num(np.array(points.error, float)[chosen]) if points.error else None
        panel.errorbar(x, y, yerr=error, fmt=look["marker"], color=look["color"], markerfacecolor="white",
                       markersize=3.8, elinewidth=0.8, label=literal(item.verdict.variant), zorder=3)
        if points.expected and not figure.lines:
            panel.plot(points.x, points.expected, color=INK, linewidth=1.1, zorder=6, label="theory" if first else None)
        if points.expected:
            values, errors, label = residual(points, figure.y, item.verdict)
            values = np.clip(values, -FAR, FAR) if label == STANDARD else values
            lower.errorbar(x, np.array(values)[chosen],
                           yerr=None if errors is None else np.nan_to_num(np.array(errors)[chosen]),
                           fmt=look["marker"], color=look["color"], markerfacecolor="white", markersize=3.8,
                           elinewidth=0.8, zorder=3)
    return label


def _wide(sets, logarithmic, lowest):
    """Whether these sets of numbers need a logarithmic axis: asked for, or of very different size."""
    ends = [max(each) for each in sets if each and min(each) >= lowest]
    return logarithmic or (len(ends) == len(sets) and is_spread(ends))


def _scales(panel, pairs):
    figure = pairs[0][1]
    sets = [points for _, each in pairs for points in each.points if len(points.x)]
    y = [[value for value in points.y if known(value)] for points in sets]
    panel.set_xscale("log" if _wide([points.x for points in sets], figure.x.logarithmic, 0.0) else "linear")
    panel.set_yscale("log" if _wide(y, figure.y.logarithmic, SMALLEST) else "linear")


def has_residuals(pairs):
    return any(points.expected and points.x for _, figure in pairs for points in figure.points)


def draw_data(pairs, stem, taller=0.0):
    """Data of several runs in one picture; `pairs`: [(evidence, its figure)], alike in axes; `taller`: in inches."""
    figure = pairs[0][1]
    variants = list(dict.fromkeys(item.verdict.variant for item, _ in pairs))
    picture, upper, lower = frame(["theory"] + variants, taller=taller)
    labels = []
    _scales(upper, pairs)
    for index, (item, each) in enumerate(pairs):
        labels.append(_curve(upper, lower, item, each, variants, index == 0))
    upper.set_ylabel(axis_label(figure.y.label, figure.y.units, 34))
    lowest = lower
    if has_residuals(pairs):
        label = next(filter(None, labels))
        if label in BANDS:
            band(lower, *BANDS[label])
        lower.axhline(0, color=INK, linewidth=1.2, zorder=1)
        lower.set_ylabel(literal(label))
        if label == STANDARD:
            lower.set_ylim(-1.1 * FAR, 1.1 * FAR)
    else:
        lower.remove()
        upper.set_subplotspec(picture.axes[0].get_gridspec()[:, 0])
        upper.tick_params(labelbottom=True)
        lowest = upper
    lowest.set_xlabel(wrapped(labelled(figure.x.label, figure.x.units), 60, 1))
    if not upper.has_data():
        upper.text(0.5, 0.5, "no finite data", transform=upper.transAxes, ha="center", color="#777777")
    for axis in {upper.yaxis, lowest.xaxis, lowest.yaxis}:
        plain_ticks(axis)
    if upper.get_yscale() == "log":
        upper.yaxis.set_minor_formatter(NullFormatter())
    picture.align_ylabels()
    legend(picture, upper)
    save(picture, stem, png=False)
