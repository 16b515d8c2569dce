"""The matrix of cases and variants as one picture, readable 900 pixels wide."""

from matplotlib.patches import Rectangle

from analysis.plotting import literal, pyplot, save
from analysis.summary import rows, variants
from analysis.words import number

WIDTH, ROW, LABEL = 9.0, 0.31, 2.3   # inches


def _short(text, length):
    return literal(text if len(text) <= length else text[:length - 1] + "…")


def _cell(panel, x, y, width, cell):
    for extent, alpha in ((width - 0.04, 0.22), (0.05, 1)):
        panel.add_patch(Rectangle((x, y), extent, ROW - 0.04, facecolor=cell.look.colour, alpha=alpha,
                                  linewidth=0))
    text = f"{cell.look.symbol} {cell.look.word}"
    panel.text(x + 0.1, y + ROW / 2 - 0.02, text, va="center",
               fontsize=8.5 if 0.075 * len(text) + 0.15 < width else 7)
    share = "" if cell.shown.share is None else number(cell.shown.share, 2)
    if 0.072 * len(text + share) + 0.2 < width:
        panel.text(x + width - 0.08, y + ROW / 2 - 0.02, share, va="center", ha="right", fontsize=8,
                   color="#444")


def _canvas(columns, lines):
    height = ROW * (1 + lines) + 0.3
    picture = pyplot.figure(figsize=(WIDTH, height))
    panel = picture.add_axes([0.005, 0, 0.99, 1], xlim=(0, WIDTH), ylim=(height, 0))
    panel.axis("off")
    width = (WIDTH - LABEL) / max(1, len(columns))
    for index, variant in enumerate(columns):
        panel.text(LABEL + width * index + 0.08, ROW * 0.7, _short(variant, int(width * 15)), weight="bold",
                   fontsize=9 if len(variant) <= width * 11 else 7.5)
    return picture, panel, width


def _case(panel, y, case):
    panel.text(0.05, y + ROW * 0.6, _short(case, 60), weight="bold", fontsize=10, va="center")
    panel.plot([0, WIDTH], [y + 0.02, y + 0.02], color="#cccccc", linewidth=0.7)


def draw_matrix(verdicts, stem):
    """Saves the matrix; rows are grouped by case, columns are variants."""
    columns, cases = variants(verdicts), {}
    for (case, point), cells in rows(verdicts, lambda item: (item.case, item.point)).items():
        cases.setdefault(case, []).append((point, cells))
    picture, panel, width = _canvas(columns, len(cases) + sum(len(points) for points in cases.values()))
    y = ROW
    for case, points in cases.items():
        _case(panel, y, case)
        for point, cells in points:
            y += ROW
            panel.text(0.25, y + ROW / 2 - 0.02, _short(point, 28), va="center", fontsize=9)
            for variant, cell in cells.items():
                _cell(panel, LABEL + width * columns.index(variant), y, width, cell)
        y += ROW
    panel.text(LABEL, y + 0.14, "number: largest deviation in units of its error budget", fontsize=8,
               color="#444", va="center")
    save(picture, stem)
