"""The pictures of a check: its verdicts at every point, and the data behind them, all methods in colour."""

import math

import numpy as np
from matplotlib.ticker import NullFormatter

from analysis.plotting import INK, axis_label, literal, method_look, pyplot, save, wrapped
from analysis.residual import BUDGET, STANDARD, residual
from analysis.words import labelled, units

SIZE = (6.2, 4.3)       # inches: two beside each other on a laptop
EDGE = 1.6              # a deviation beyond this many budgets stands at the edge
FAR = 6                 # and a residual beyond this many standard errors
MOST = 28               # markers of one set of data
CROWDED = 60            # letters of all labels: beyond, they stand upright
RATIO = [1.75, 1]
GREY = "#999999"
BANDS = {STANDARD: (2, "band: two standard errors"), BUDGET: (1, "band: the error budget")}


def _known(number):
    return number is not None and math.isfinite(number)


def _spread(values):
    """Whether positive values need a logarithmic axis."""
    return len(values) > 0 and min(values) > 0 and max(values) > 30 * min(values)


def _places(group):
    """{(variant, point): x}: the methods of a point stand beside each other."""
    wide = max(1, len(group.variants))
    step = min(0.11, 0.7 / wide)
    return {(item.variant, item.point): group.points.index(item.point)
            + step * (group.variants.index(item.variant) - (wide - 1) / 2) for item in group.verdicts}


def signed_share(item):
    """Deviation in budgets with the sign of the deviation; None where it is not known."""
    share = item.share
    if share is None or not _known(item.value) or not _known(item.expected):
        return None
    return math.copysign(share, item.value - item.expected)


def _theory(panel, group):
    """The expectation at each point, above the markers; a bound points to the side that is right."""
    arrows = {"at-least": "^", "at-most": "v"}
    drawn = set()
    for item in group.verdicts:
        for level, arrow in ((item.expected, arrows.get(item.kind)), (item.upper, None)):
            x = group.points.index(item.point)
            if _known(level) and (x, level) not in drawn:
                drawn.add((x, level))
                panel.plot([x - 0.4, x + 0.4], [level, level], color=INK, linewidth=1.4, zorder=6)
                if arrow:
                    panel.plot([x + 0.4], [level], arrow, color=INK, markersize=4, zorder=6)


def _marks(panel, group, places):
    for variant in group.variants:
        look = method_look(variant, group.variants)
        chosen = [item for item in group.verdicts if item.variant == variant and _known(item.value)]
        panel.errorbar([places[variant, item.point] for item in chosen], [item.value for item in chosen],
                       yerr=[item.stderr or 0 for item in chosen], fmt=look["marker"], color=look["color"],
                       markerfacecolor="white", capsize=2, elinewidth=1, label=literal(variant), zorder=3)


def _band(panel, limit, text):
    panel.axhspan(-limit, limit, color=GREY, alpha=0.2, linewidth=0)
    panel.text(0.995, 0.02, text, transform=panel.transAxes, ha="right", va="bottom", fontsize=7.5, color="#777777")


def _deviations(panel, group, places):
    _band(panel, *BANDS[BUDGET])
    panel.axhline(0, color=INK, linewidth=1.2, zorder=1)
    for item in group.verdicts:
        share = signed_share(item)
        if share is not None:
            look = method_look(item.variant, group.variants)
            beyond = abs(share) > EDGE
            panel.plot([places[item.variant, item.point]], [np.clip(share, -EDGE, EDGE)],
                       {True: "^" if share > 0 else "v", False: look["marker"]}[beyond], color=look["color"],
                       markerfacecolor=look["color"] if beyond else "white", zorder=3)
    panel.set_ylim(-1.15 * EDGE, 1.15 * EDGE)
    panel.set_yticks([-1, 0, 1])
    panel.set_ylabel("deviation\n/ budget")


def room(points):
    """Inches that the labels of these points need below the first line; 0 where they lie flat."""
    return min(1.3, 0.044 * max(map(len, points))) if sum(map(len, points)) > CROWDED else 0.0


def _labels(panel, points):
    crowded = room(points) > 0
    panel.set_xticks(range(len(points)), [wrapped(point, 26, 1) for point in points], rotation=60 if crowded else 0,
                     ha="right" if crowded else "center", rotation_mode="anchor", fontsize=8.5)
    panel.set_xlim(-0.6, len(points) - 0.4)


def _frame(lower_labels, taller=0.0):
    """`lower_labels`: inches below for upright labels; `taller`: inches more for the panels."""
    picture = pyplot.figure(figsize=(SIZE[0], SIZE[1] + lower_labels + taller))
    bottom = (0.46 + lower_labels) / picture.get_figheight()
    grid = picture.add_gridspec(2, 1, height_ratios=RATIO, hspace=0.09, left=0.135, right=0.985, bottom=bottom,
                                top=1 - 0.46 / picture.get_figheight())
    upper = picture.add_subplot(grid[0])
    lower = picture.add_subplot(grid[1], sharex=upper)
    upper.tick_params(labelbottom=False)
    return picture, upper, lower


def _legend(picture, panel):
    handles, names = panel.get_legend_handles_labels()
    unique = dict(zip(names, handles))
    if unique:
        picture.legend(unique.values(), unique.keys(), loc="upper left", bbox_to_anchor=(0.1, 1.0), fontsize=8.5,
                       ncol=min(5, len(unique)), handletextpad=0.2, columnspacing=1.0, borderaxespad=0.3)


def draw_verdicts(group, stem):
    """Value of every point and method with the expectation; below it the deviation in budgets, the budget as a band."""
    picture, upper, lower = _frame(room(group.points))
    places = _places(group)
    upper.plot([], [], color=INK, linewidth=1.4, label="expected")
    _marks(upper, group, places)
    _theory(upper, group)
    levels = [item.value for item in group.verdicts] + [item.expected for item in group.verdicts]
    if _spread([level for level in levels if _known(level)]):
        upper.set_yscale("log")
    unit = group.evidence[0].verdict.units
    upper.set_ylabel(f"value [{units(unit)}]" if units(unit) else "value")
    upper.grid(axis="x", visible=False)
    lower.grid(axis="x", visible=False)
    _deviations(lower, group, places)
    _labels(lower, group.points)
    picture.align_ylabels()
    _legend(picture, upper)
    save(picture, stem, png=False)


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
        if points.expected:
            values, errors, label = residual(points, figure.y, item.verdict)
            values = np.clip(values, -FAR, FAR) if label == STANDARD else values
            lower.errorbar(x, np.array(values)[chosen],
                           yerr=None if errors is None else np.nan_to_num(np.array(errors)[chosen]),
                           fmt=look["marker"], color=look["color"], markerfacecolor="white", markersize=3.8,
                           elinewidth=0.8, zorder=3)
    return label


def _wide(sets, logarithmic):
    """Whether these sets of numbers need a logarithmic axis: asked for, or of very different size."""
    ends = [max(each) for each in sets if each and min(each) >= 0]
    return logarithmic or (len(ends) == len(sets) and _spread(ends))


def _scales(panel, pairs):
    figure = pairs[0][1]
    sets = [points for _, each in pairs for points in each.points if len(points.x)]
    y = [[value for value in points.y if _known(value)] for points in sets]
    panel.set_xscale("log" if _wide([points.x for points in sets], figure.x.logarithmic) else "linear")
    panel.set_yscale("log" if _wide(y, figure.y.logarithmic) else "linear")


def has_residuals(pairs):
    return any(points.expected and points.x for _, figure in pairs for points in figure.points)


def draw_data(pairs, stem, taller=0.0):
    """Data of several runs in one picture; `pairs`: [(evidence, its figure)], alike in axes; `taller`: in inches."""
    figure = pairs[0][1]
    variants = list(dict.fromkeys(item.verdict.variant for item, _ in pairs))
    picture, upper, lower = _frame(0.0, taller)
    labels = []
    _scales(upper, pairs)
    for index, (item, each) in enumerate(pairs):
        labels.append(_curve(upper, lower, item, each, variants, index == 0))
    upper.set_ylabel(axis_label(figure.y.label, figure.y.units, 34))
    lowest = lower
    if has_residuals(pairs):
        label = next(filter(None, labels))
        if label in BANDS:
            _band(lower, *BANDS[label])
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
    if upper.get_yscale() == "log":
        upper.yaxis.set_minor_formatter(NullFormatter())
    picture.align_ylabels()
    _legend(picture, upper)
    save(picture, stem, png=False)
