"""What the drawings of source figures share: a picture with panels, colours by method, data with errors."""

import numpy as np

from analysis.plotting import COLOURS, MARKERS, headed, pyplot, save
from analysis.source.methods import FITTED, METHODS

BLACK = "#333333"


def panels(columns=1, rows=1, width=None, height=3.7):
    """(picture, array of panels [row][column])"""
    size = (width or (5.4 if columns == 1 else 4.2 * columns), height if rows == 1 else 0.6 + 2.6 * rows)
    picture, found = pyplot.subplots(rows, columns, figsize=size, squeeze=False)
    picture.subplots_adjust(left=0.75 / size[0], right=1 - 0.12 / size[0], top=1 - 0.62 / size[1],
                            bottom=0.55 / size[1], wspace=0.24, hspace=0.42)
    return picture, found


def finish(picture, number, title, stem):
    headed(picture, f"{number}  {title}")
    save(picture, stem)


def style(variant):
    """Colour and line of a method, the same in all figures; fitted impact parameters are dashed."""
    index = METHODS.index(variant) if variant in METHODS else len(METHODS)
    base = METHODS.index(variant.removesuffix(FITTED)) if variant.removesuffix(FITTED) in METHODS else index
    return {"color": COLOURS[base % len(COLOURS)], "linestyle": "--" if variant.endswith(FITTED) else "-"}


def ordered(runs):
    """Runs in the order of the methods."""
    return sorted(runs, key=lambda run: (METHODS.index(run.variant) if run.variant in METHODS else len(METHODS),
                                         run.variant))


def shade(index, count):
    """Colour of one of several ordered values, dark to light."""
    return pyplot.get_cmap("viridis")(0.9 * index / max(1, count - 1))


def band(panel, x, mean, error, **look):
    """A line with its standard error."""
    panel.plot(x, mean, **look)
    panel.fill_between(x, mean - error, mean + error, color=look.get("color"), alpha=0.2, linewidth=0)


def marks(panel, x, y, error, index=0, **look):
    panel.errorbar(x, y, yerr=np.nan_to_num(np.asarray(error, float)), fmt=MARKERS[index % len(MARKERS)], capsize=2,
                   markerfacecolor="white", elinewidth=1, **look)


def middle(edges):
    edges = np.asarray(edges)
    return (edges[1:] + edges[:-1]) / 2
