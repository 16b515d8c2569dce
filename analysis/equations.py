"""Equations as pictures; one that mathtext cannot read is shown as text."""

from matplotlib import mathtext
from matplotlib.font_manager import FontProperties

from analysis.plotting import INK, follow_scheme

FONT = FontProperties(size=13, math_fontfamily="cm")


def draw_equation(tex, path):
    """Saves `tex` as SVG; returns whether it could be read."""
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        mathtext.math_to_image(f"${tex}$", path, prop=FONT, format="svg", dpi=72, color=INK)
        svg = path.read_text(encoding="utf-8").replace("fill: #ffffff", "fill: none")
        path.write_text(follow_scheme(svg), encoding="utf-8")
    except (ValueError, RuntimeError):
        path.unlink(missing_ok=True)
        return False
    return True
