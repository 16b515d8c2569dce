"""The verdicts of a check at every point, all methods in colour, with the budget as a band."""

import math

import numpy as np
from matplotlib.patches import Rectangle

from analysis.plotting import INK, literal, method_look, save, wrapped
from analysis.residual import BUDGET
from analysis.two_panels import BANDS, GREY, band, frame, is_spread, known, legend, plain_ticks
from analysis.words import units

EDGE = 1.6              # a deviation beyond this many budgets stands at the edge
CROWDED = 66            # letters side by side: beyond, labels stand upright


def _places(group):
    """{(variant, point): x}: the methods of a point stand beside each other."""
    wide = max(1, len(group.variants))
    step = min(0.11, 0.7 / wide)
    return {(item.variant, item.point): group.points.index(item.point)
            + step * (group.variants.index(item.variant) - (wide - 1) / 2) for item in group.verdicts}


def signed_share(item):
    """Deviation in budgets with the sign of the deviation; None where it is not known."""
    share = item.share
    if share is None or not known(item.value) or not known(item.expected):
        return None
    return math.copysign(share, item.value - item.expected)


def _theory(panel, group):
    """The expectation at each point, above the markers; a bound points to the side that is right, a range is a box."""
    arrows = {"at-least": "^", "at-most": "v"}
    levels = {(group.points.index(item.point), item.expected): arrows.get(item.kind) for item in group.verdicts
              if known(item.expected) and item.kind != "between"}
    if levels:
        x, level = np.array(list(levels), float).T
        panel.hlines(level, x - 0.4, x + 0.4, color=INK, linewidth=1.4, zorder=6)
    for arrow in arrows.values():
        chosen = [place for place, kind in levels.items() if kind == arrow]
        if chosen:
            x, level = np.array(chosen, float).T
            panel.plot(x + 0.4, level, arrow, color=INK, markersize=4, zorder=6)
    for place in {(group.points.index(item.point), item.expected, item.upper) for item in group.verdicts
                  if item.kind == "between" and known(item.expected) and known(item.upper)}:
        x, low, high = place
        panel.add_patch(Rectangle((x - 0.4, low), 0.8, high - low, facecolor=GREY, edgecolor=INK, alpha=0.25))


def _levels(item):
    """What the axis must show of a verdict: its value, and the bound that is nearest to it."""
    bounds = [bound for bound in (item.expected, item.upper) if known(bound)]
    if not known(item.value):
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
    if is_spread(levels):
        panel.set_yscale("log")
        panel.set_ylim(low / 1.6, high * 1.6)
    else:
        room = 0.08 * (high - low) or 0.1 * abs(high) or 1.0
        panel.set_ylim(low - room, high + room)


def _marks(panel, group, places):
    for variant in group.variants:
        look = method_look(variant, group.variants)
        chosen = [item for item in group.verdicts if item.variant == variant and known(item.value)]
        panel.errorbar([places[variant, item.point] for item in chosen], [item.value for item in chosen],
                       yerr=[item.stderr or 0 for item in chosen], fmt=look["marker"], color=look["color"],
                       markerfacecolor="white", capsize=2, elinewidth=1, label=literal(variant), zorder=3)


def _deviations(panel, group, places):
    band(panel, *BANDS[BUDGET])
    panel.axhline(0, color=INK, linewidth=1.2, zorder=1)
    for variant in group.variants:
        look = method_look(variant, group.variants)
        pairs = [(places[variant, item.point], signed_share(item)) for item in group.verdicts
                 if item.variant == variant and signed_share(item) is not None]
        x, share = np.array(pairs, float).reshape(-1, 2).T
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


def draw_verdicts(group, stem):
    """Value of every point and method with the expectation; below it the deviation in budgets, the budget as a band."""
    picture, upper, lower = frame(["expected"] + group.variants, room(group.points))
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
    plain_ticks(upper.yaxis)
    picture.align_ylabels()
    legend(picture, upper)
    save(picture, stem, png=False)
