"""The look of all pictures, in light and in dark, and how one is saved."""

import re
import textwrap
import tomllib
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (the backend must be chosen first)

from analysis.words import units  # noqa: E402

# Okabe and Ito's palette without yellow, which is too light for a line on white.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">"]
INK = "#333333"

# What a viewer in dark mode sees instead of paper, ink and greys; other colours are made lighter where they must be.
DARK = {"#ffffff": "#1c2226", "#000000": "#e4e7ea", "#1d2328": "#e4e7ea", "#333333": "#d5dade", "#e6e6e6": "#353d43",
        "#555555": "#a2abb3", "#777777": "#99a3ab", "#cccccc": "#4c565e", "#f3f4f5": "#262d32", "#cfd4d8": "#47525b",
        "#808080": "#99a3ab", "#b0b0b0": "#6d7880"}
DARK_PAPER, CONTRAST = DARK["#ffffff"], 3.5   # WCAG asks for 3 of graphics

pyplot.rcParams.update({
    "font.size": 10, "axes.titlesize": 10, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e6e6e6", "grid.linewidth": 0.7, "axes.axisbelow": True,
    "axes.edgecolor": "#777777", "xtick.color": INK, "ytick.color": INK, "axes.labelcolor": INK, "text.color": INK,
    "legend.frameon": False, "legend.fontsize": 9, "lines.linewidth": 1.5, "lines.markersize": 4.5,
    "svg.hashsalt": "sandglass", "savefig.facecolor": "white",
})


# Colour and marker of a method are the same in every picture.
METHODS = tomllib.loads((Path(__file__).parent / "methods.toml").read_text(encoding="utf-8"))["methods"]


def method_look(variant, others=()):
    """{colour, marker} of a method; one that is not listed takes what the listed ones of a picture leave free."""
    if variant in METHODS:
        index = METHODS.index(variant)
        return {"color": COLOURS[index % len(COLOURS)], "marker": MARKERS[index % len(MARKERS)]}
    taken = {COLOURS[METHODS.index(name) % len(COLOURS)] for name in others if name in METHODS}
    free = [colour for colour in COLOURS if colour not in taken] or COLOURS
    index = [name for name in others if name not in METHODS].index(variant) if variant in others else 0
    return {"color": free[index % len(free)], "marker": MARKERS[-1 - index % len(MARKERS)]}


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


def _luminance(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(colour, paper):
    """Ratio of luminances as WCAG defines it, 1 to 21."""
    low, high = sorted([_luminance(colour), _luminance(paper)])
    return (high + 0.05) / (low + 0.05)


def on_dark(colour):
    """The colour that stands for this one on dark paper: mixed with white until it can be told from the paper."""
    if colour in DARK:
        return DARK[colour]
    parts = [int(colour[i:i + 2], 16) for i in (1, 3, 5)]
    while contrast(colour, DARK_PAPER) < CONTRAST:
        parts = [part + (255 - part) * 0.08 for part in parts]
        colour = "#" + "".join(f"{round(part):02x}" for part in parts)
    return colour


def follow_scheme(svg):
    """An SVG of matplotlib that follows the light or dark scheme of its viewer."""
    found = sorted(set(re.findall(r"(fill|stroke): (#[0-9a-f]{6})", svg)))
    rules = "".join(f'[style*="{kind}: {colour}"]{{{kind}:{on_dark(colour)} !important}}' for kind, colour in found
                    if on_dark(colour) != colour)
    return re.sub(r"<defs>", f"<style>@media (prefers-color-scheme: dark){{{rules}}}</style><defs>", svg, count=1)


def save(figure, stem, png=True):
    """Writes <stem>.svg and <stem>.png; the SVG has no date, so the same numbers give the same file."""
    stem.parent.mkdir(parents=True, exist_ok=True)
    path = stem.with_name(stem.name + ".svg")
    figure.savefig(path, metadata={"Date": None})
    path.write_text(follow_scheme(path.read_text(encoding="utf-8")), encoding="utf-8")
    if png:
        figure.savefig(stem.with_name(stem.name + ".png"), dpi=144)
    pyplot.close(figure)
