"""The look of all pictures, and how one is saved."""

import textwrap

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (the backend must be chosen first)

from analysis.words import units  # noqa: E402

# Okabe and Ito's palette without yellow, which is too light for a line on white.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]

pyplot.rcParams.update({
    "font.size": 10, "axes.titlesize": 10, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e6e6e6", "grid.linewidth": 0.7, "axes.axisbelow": True,
    "legend.frameon": False, "legend.fontsize": 9, "lines.linewidth": 1.5, "lines.markersize": 4.5,
    "svg.hashsalt": "sandglass", "savefig.facecolor": "white",
})


def literal(text):
    """Text that mathtext must leave alone."""
    return text.replace("$", r"\$")


def wrapped(text, width, lines=2):
    return literal("\n".join(textwrap.wrap(text, width, max_lines=lines, placeholder="…")))


def axis_label(label, unit, width):
    """Label and, on its own line, the unit."""
    return wrapped(label, width) + (literal(f"\n[{units(unit)}]") if units(unit) else "")


def headed(picture, title):
    picture.suptitle(title, x=0.02, y=0.985, ha="left", va="top", fontsize=10.5, weight="bold")


def save(figure, stem):
    """Writes <stem>.svg and <stem>.png; the SVG has no date, so the same numbers give the same file."""
    stem.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(stem.with_name(stem.name + ".svg"), metadata={"Date": None})
    figure.savefig(stem.with_name(stem.name + ".png"), dpi=144)
    pyplot.close(figure)
