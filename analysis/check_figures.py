"""The pictures of a check: its verdicts at every point, and the data behind them, all methods in colour."""

import math

import numpy as np
from matplotlib.patches import Rectangle
from matplotlib.ticker import FuncFormatter, NullFormatter

from analysis.plotting import INK, axis_label, literal, method_look, pyplot, save, wrapped
from analysis.residual import BUDGET, STANDARD, residual
from analysis.words import labelled, number, units

SIZE = (6.2, 4.3)       # inches: two beside each other on a laptop
EDGE = 1.6              # a deviation beyond this many budgets stands at the edge
FAR = 6                 # and a residual beyond this many standard errors
SMALLEST = 1e-12        # what a logarithmic axis shows of values
MOST = 28               # markers of one set of data
CROWDED = 66            # letters side by side: beyond, labels stand upright
RATIO = [1.75, 1]
GREY = "#999999"
BANDS = {STANDARD: (2, "band: two standard errors"), BUDGET: (1, "band: the error budget")}


def _known(number):
    return number is not None and math.isfinite(number)


def _spread(values):
    """Whether positive values need a logarithmic axis."""
    return len(values) > 0 and min(values) > 0 and max(values) > 30 * min(values)


def _plain_ticks(axis):
    """Powers of ten stand at the ticks, not beside the axis."""
    low, high = axis.get_view_interval()
    if axis.get_scale() == "linear" and not 1e-3 <= max(abs(low), abs(high)) < 1e5:
        axis.set_major_formatter(FuncFormatter(lambda value, _: number(value, 3)))


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
    """The expectation at each point, above the markers; a bound points to the side that is right, a range is a box."""
    arrows = {"at-least": "^", "at-most": "v"}
    levels = {(group.points.index(item.point), item.expected): arrows.get(item.kind) for item in group.verdicts
              if _known(item.expected) and item.kind != "between"}
    if levels:
        x, level = np.array(list(levels), float).T
        panel.hlines(level, x - 0.4, x + 0.4, color=INK, linewidth=1.4, zorder=6)
    for arrow in arrows.values():
        chosen = [place for place, kind in levels.items() if kind == arrow]
        if chosen:
            x, level = np.array(chosen, float).T
            panel.plot(x + 0.4, level, arrow, color=INK, markersize=4, zorder=6)
    for place in {(group.points.index(item.point), item.expected, item.upper) for item in group.verdicts
                  if item.kind == "between" and _known(item.expected) and _known(item.upper)}:
        x, low, high = place
        panel.add_patch(Rectangle((x - 0.4, low), 0.8, high - low, facecolor=GREY, edgecolor=INK, alpha=0.25))


def _levels(item):
    """What the axis must show of a verdict: its value, and the bound that is nearest to it."""
    bounds = [bound for bound in (item.expected, item.upper) if _known(bound)]
    if not _known(item.value):
        return bounds[:1]
    error = item.stderr or 0.0
    nearest = min(bounds, key=lambda bound: abs(bound - item.value), default=item.value)
    return [item.value - error, item.value + error, nearest]


def _scale(panel, group):
    """Limits of the axis from the values; bounds far away do not stretch it."""
    levels = [level for item in group.verdicts for level in _levels(item)]
    if not levels:
        return
    low, high = min(levels), max(levels)
    if _spread(levels):
        panel.set_yscale("log")
        panel.set_ylim(low / 1.6, high * 1.6)
    else:
        room = 0.08 * (high - low) or 0.1 * abs(high) or 1.0
        panel.set_ylim(low - room, high + room)


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
    for variant in group.variants:
        look = method_look(variant, group.variants)
        known = [(places[variant, item.point], signed_share(item)) for item in group.verdicts
                 if item.variant == variant and signed_share(item) is not None]
        x, share = np.array(known, float).reshape(-1, 2).T
        for chosen, marker, face in ((abs(share) <= EDGE, look["marker"], "white"), (share > EDGE, "^", look["color"]),
                                     (share < -EDGE, "v", look["color"])):
            panel.plot(x[chosen], np.clip(share[chosen], -EDGE, EDGE), marker, color=look["color"], linestyle="none",
                       markerfacecolor=face, zorder=3)
    panel.set_ylim(-1.15 * EDGE, 1.15 * EDGE)
    panel.set_yticks([-1, 0, 1])
    panel.set_ylabel("deviation\n/ budget")


def room(points):
    """Inches that the labels of these points need below the first line; 0 where they lie flat."""
    return min(1.3, 0.044 * max(map(len, points))) if len(points) * max(map(len, points)) > CROWDED else 0.0


def _labels(panel, points):
    crowded = room(points) > 0
    panel.set_xticks(range(len(points)), [wrapped(point, 26, 1) for point in points], rotation=60 if crowded else 0,
                     ha="right" if crowded else "center", rotation_mode="anchor", fontsize=8.5)
    panel.set_xlim(-0.6, len(points) - 0.4)


def _frame(names, lower_labels=0.0, taller=0.0):
    """`names`: in the legend; `lower_labels`: inches below for upright labels; `taller`: inches more for the panels."""
    picture = pyplot.figure(figsize=(SIZE[0], SIZE[1] + lower_labels + taller))
    bottom = (0.46 + lower_labels) / picture.get_figheight()
    grid = picture.add_gridspec(2, 1, height_ratios=RATIO, hspace=0.09, left=0.158, right=0.985, bottom=bottom,
                                top=1 - _legend_room(names) / picture.get_figheight())
    upper = picture.add_subplot(grid[0])
    lower = picture.add_subplot(grid[1], sharex=upper)
    upper.tick_params(labelbottom=False)
    return picture, upper, lower


def _columns(names):
    """Of a legend as wide as the picture."""
    return max(1, min(5, 96 // (max(map(len, names), default=1) + 6), len(names)))


def _legend_room(names):
    """Inches above the panels."""
    return 0.14 + 0.165 * math.ceil(len(names) / _columns(names))


def _legend(picture, panel):
    handles, names = panel.get_legend_handles_labels()
    unique = dict(zip(names, handles))
    if unique:
        picture.legend(unique.values(), unique.keys(), loc="upper left", bbox_to_anchor=(0.12, 1.0), fontsize=8.5,
                       ncol=_columns(unique), handletextpad=0.2, columnspacing=1.0, borderaxespad=0.3)


def draw_verdicts(group, stem):
    """Value of every point and method with the expectation; below it the deviation in budgets, the budget as a band."""
    picture, upper, lower = _frame(["expected"] + group.variants, room(group.points))
    places = _places(group)
    upper.plot([], [], color=INK, linewidth=1.4, label="expected")
    _marks(upper, group, places)
    _theory(upper, group)
    _scale(upper, group)
    unit = group.evidence[0].verdict.units
    upper.set_ylabel(f"value [{units(unit)}]" if units(unit) else "value")
    upper.grid(axis="x", visible=False)
    lower.grid(axis="x", visible=False)
    _deviations(lower, group, places)
    _labels(lower, group.points)
    _plain_ticks(upper.yaxis)
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
    return logarithmic or (len(ends) == len(sets) and _spread(ends))


def _scales(panel, pairs):
    figure = pairs[0][1]
    sets = [points for _, each in pairs for points in each.points if len(points.x)]
    y = [[value for value in points.y if _known(value)] for points in sets]
    panel.set_xscale("log" if _wide([points.x for points in sets], figure.x.logarithmic, 0.0) else "linear")
    panel.set_yscale("log" if _wide(y, figure.y.logarithmic, SMALLEST) else "linear")


def has_residuals(pairs):
    return any(points.expected and points.x for _, figure in pairs for points in figure.points)


def draw_data(pairs, stem, taller=0.0):
    """Data of several runs in one picture; `pairs`: [(evidence, its figure)], alike in axes; `taller`: in inches."""
    figure = pairs[0][1]
    variants = list(dict.fromkeys(item.verdict.variant for item, _ in pairs))
    picture, upper, lower = _frame(["theory"] + variants, taller=taller)
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
    for axis in {upper.yaxis, lowest.xaxis, lowest.yaxis}:
        _plain_ticks(axis)
    if upper.get_yscale() == "log":
        upper.yaxis.set_minor_formatter(NullFormatter())
    picture.align_ylabels()
    _legend(picture, upper)
    save(picture, stem, png=False)
