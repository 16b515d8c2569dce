"""The matrix of cases and variants as one picture, readable 900 pixels wide."""

import textwrap

from matplotlib.patches import Rectangle

from analysis.plotting import literal, pyplot, save
from analysis.summary import rows, variants
from analysis.words import VERDICTS, number, seconds

WIDTH, ROW, LABEL = 9.0, 0.31, 2.7   # inches


def _short(text, length):
    return literal(textwrap.shorten(text, length, placeholder="…") if " " in text else
                   text if len(text) <= length else text[:length - 1] + "…")


def _cell(panel, x, y, width, cell):
    panel.add_patch(Rectangle((x, y), width - 0.04, ROW - 0.04, facecolor=cell.look.colour, alpha=0.22, linewidth=0))
    panel.add_patch(Rectangle((x, y), 0.05, ROW - 0.04, facecolor=cell.look.colour, linewidth=0))
    share = cell.shown.share
    panel.text(x + 0.11, y + ROW / 2 - 0.02, f"{cell.look.symbol} {cell.look.word}", va="center", fontsize=9)
    if share is not None and width > 1.6:
        panel.text(x + width - 0.1, y + ROW / 2 - 0.02, number(share, 2), va="center", ha="right", fontsize=8.5,
                   color="#444444")


def _legend(panel, verdicts, height):
    used = {item.verdict for item in verdicts}
    words = "    ".join(f"{look.symbol} {look.word}" for name, look in VERDICTS.items() if name in used)
    panel.text(0.05, height - 0.1, f"{words}        number: worst deviation / budget", fontsize=8.5, color="#444444",
               va="center")


def draw_matrix(verdicts, stem):
    """Saves the matrix; rows are grouped by case, columns are variants."""
    columns = variants(verdicts)
    cases = {}
    for (case, point), cells in rows(verdicts, lambda item: (item.case, item.point)).items():
        cases.setdefault(case, []).append((point, cells))
    height = ROW * (1.6 + len(cases) + sum(len(points) for points in cases.values())) + 0.35
    width = (WIDTH - LABEL) / max(1, len(columns))
    picture = pyplot.figure(figsize=(WIDTH, height))
    panel = picture.add_axes([0.005, 0, 0.99, 1], xlim=(0, WIDTH), ylim=(height, 0))
    panel.axis("off")
    for index, variant in enumerate(columns):
        panel.text(LABEL + width * index + 0.08, ROW * 0.7, _short(variant, int(width * 13)), weight="bold", fontsize=9)
    y = ROW
    for case, points in cases.items():
        panel.text(0.05, y + ROW * 0.6, _short(case, 60), weight="bold", fontsize=10, va="center")
        panel.plot([0, WIDTH], [y + 0.02, y + 0.02], color="#cccccc", linewidth=0.7)
        y += ROW
        for point, cells in points:
            panel.text(0.25, y + ROW / 2 - 0.02, _short(point, 32), va="center", fontsize=9)
            for variant, cell in cells.items():
                _cell(panel, LABEL + width * columns.index(variant), y, width, cell)
            y += ROW
    _legend(panel, verdicts, height)
    save(picture, stem)
