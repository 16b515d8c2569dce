"""A drawing board in inches for pictures made of boxes and short texts."""

from dataclasses import dataclass

from matplotlib.font_manager import FontProperties
from matplotlib.patches import Rectangle
from matplotlib.textpath import TextPath

from analysis.plotting import literal

SMALLEST = 6.5   # points


def extent(text, size, weight="normal"):
    """Width of a text in inches."""
    font = FontProperties(size=size, weight=weight)
    return TextPath((0, 0), literal(text), prop=font).get_extents().width / 72


def fitted(text, size, width, weight="normal"):
    """(text, size) that fits into `width`: a smaller size first, then fewer letters."""
    while size > SMALLEST and extent(text, size, weight) > width:
        size -= 0.5
    while len(text) > 2 and extent(text, size, weight) > width:
        text = text[:-2] + "…"
    return text, size


@dataclass(frozen=True)
class Sheet:
    """Lengths in inches, y downwards."""

    panel: object   # axes of matplotlib
    width: float

    def text(self, x, y, text, size=8.5, width=None, **style):
        """A text that never grows wider than `width` (the sheet's, if none is given)."""
        text, size = fitted(text, size, width or self.width, style.get("weight", "normal"))
        self.panel.text(x, y, literal(text), **{"fontsize": size, "va": "center"} | style)

    def box(self, x, y, width, height, colour, alpha=1.0):
        self.panel.add_patch(Rectangle((x, y), width, height, facecolor=colour, alpha=alpha, linewidth=0))
