"""A picture of two panels: what was found above, how far it lies from what is expected below."""

import math

from matplotlib.ticker import FuncFormatter

from analysis.plotting import pyplot
from analysis.residual import BUDGET, STANDARD
from analysis.words import number

SIZE = (6.2, 4.3)       # inches: two beside each other on a laptop
RATIO = [1.75, 1]       # heights of the panels
GREY = "#999999"
BANDS = {STANDARD: (2, "band: two standard errors"), BUDGET: (1, "band: the error budget")}


def known(value):
    return value is not None and math.isfinite(value)


def is_spread(values):
    """Whether positive values need a logarithmic axis."""
    return len(values) > 0 and min(values) > 0 and max(values) > 30 * min(values)


def plain_ticks(axis):
    """Powers of ten stand at the ticks, not beside the axis."""
    low, high = axis.get_view_interval()
    if axis.get_scale() == "linear" and not 1e-3 <= max(abs(low), abs(high)) < 1e5:
        axis.set_major_formatter(FuncFormatter(lambda value, _: number(value, 3)))


def band(panel, limit, text):
    panel.axhspan(-limit, limit, color=GREY, alpha=0.2, linewidth=0)
    panel.text(0.995, 0.02, text, transform=panel.transAxes, ha="right", va="bottom", fontsize=7.5, color="#777777")


def frame(names, lower_labels=0.0, taller=0.0):
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


def legend(picture, panel):
    handles, names = panel.get_legend_handles_labels()
    unique = dict(zip(names, handles))
    if unique:
        picture.legend(unique.values(), unique.keys(), loc="upper left", bbox_to_anchor=(0.12, 1.0), fontsize=8.5,
                       ncol=_columns(unique), handletextpad=0.2, columnspacing=1.0, borderaxespad=0.3)
