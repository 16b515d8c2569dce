"""The folded matrix of cases and methods as one picture, readable 900 pixels wide."""

import textwrap
from dataclasses import dataclass

from analysis.plotting import pyplot, save, wrapped
from analysis.sheet import Sheet, extent
from analysis.words import ABSENT, GOOD, VERDICTS, ratio

WIDTH, MARGIN, LABEL = 9.0, 0.08, 1.65            # inches
ROW, NARROW_ROW, TOPIC, LINE = 0.42, 0.68, 0.3, 0.19
NARROW = 0.9                                      # columns below this have a line for each number of a cell
UPRIGHT = 1.3                                     # longest name of a narrow column
GAP = 0.05
SOFT, TRACK, EMPTY = "#555555", "#cfd4d8", "#f3f4f5"
SHADES = {True: 0.2, False: 0.5}                  # what blocks is darker
HOW_TO_READ = ("Rows: test cases. Columns: methods. 12/12, or 12 alone: all 12 checks hold. "
               "Bar and number: the largest deviation; 1 is the edge of its error budget.")


@dataclass(frozen=True)
class _Layout:
    columns: list[str]

    @property
    def width(self):
        return (WIDTH - 2 * MARGIN - LABEL) / max(1, len(self.columns))

    @property
    def narrow(self):
        return self.width < NARROW

    @property
    def row(self):
        return NARROW_ROW if self.narrow else ROW

    def left(self, variant):
        return MARGIN + LABEL + self.width * self.columns.index(variant)


def _bar(sheet, x, y, length, item):
    """The whole length is the error budget."""
    sheet.box(x, y - 0.03, length, 0.06, TRACK)
    if item.share is not None:
        sheet.box(x, y - 0.03, length * min(item.share, 1), 0.06, VERDICTS[item.verdict].colour)


def _wide_cell(sheet, x, y, width, fold):
    """Counts above, bar and deviation below."""
    sheet.text(x, y + 0.12, "   ".join(text for _, text in fold.tallies), width=width)
    text = ratio(fold.worst.share)
    _bar(sheet, x, y + 0.27, width - 0.03 - max(0.3, extent(text, 8) + 0.08), fold.worst)
    sheet.text(x + width - 0.03, y + 0.27, text, 8, ha="right", color=SOFT)


def _narrow_cell(sheet, x, y, width, fold):
    """Counts, known limits, deviation, each in its own line, and the bar."""
    first, *others = [text for _, text in fold.tallies]
    if extent(first, 7.5) > width:
        first = first.split()[-1]
    if extent(first, 7.5) > width:
        held, _, made = first.partition("/")
        first = held if held == made else first
    sheet.text(x, y + 0.12, first, width=width)
    sheet.text(x, y + 0.275, " ".join(others), width=width)
    share = ratio(fold.worst.share)
    sheet.text(x, y + 0.43, "0" if extent(share, 7) > width else share, 8, width, color=SOFT)
    _bar(sheet, x, y + 0.56, width, fold.worst)


def _cell(sheet, layout, x, y, fold):
    width, height, colour = layout.width - GAP, layout.row - GAP, VERDICTS[fold.verdict].colour
    sheet.box(x, y, width, height, colour, SHADES[fold.verdict in GOOD])
    sheet.box(x, y, 0.05, height, colour)
    draw = _narrow_cell if layout.narrow else _wide_cell
    draw(sheet, x + 0.09, y, width - 0.13, fold)


def _heads(sheet, layout, y):
    """Names of the variants: on two lines where long, upright where the columns are narrow."""
    for variant in layout.columns:
        x = layout.left(variant)
        if layout.narrow:
            sheet.text(x + layout.width / 2, y, variant, width=UPRIGHT, weight="bold", rotation=90, ha="center",
                       va="bottom")
            continue
        lines = textwrap.wrap(variant, int(layout.width * 13), max_lines=2, placeholder="…")
        for index, line in enumerate(lines):
            sheet.text(x + 0.02, y - 0.05 + 0.15 * (index - len(lines) + 1), line, width=layout.width - GAP,
                       weight="bold")


def _topic(sheet, y, topic):
    sheet.text(MARGIN, y + 0.17, topic, width=LABEL, color=SOFT)
    sheet.box(MARGIN + LABEL, y + 0.165, WIDTH - 2 * MARGIN - LABEL, 0.01, TRACK)


def _cases(sheet, layout, y, topics):
    """Returns where the next thing may be drawn."""
    for topic, cases in topics.items():
        _topic(sheet, y, topic)
        y += TOPIC
        for case, cells in cases.items():
            sheet.text(MARGIN, y + layout.row / 2 - 0.02, case, 9.5, LABEL - 0.1, weight="bold")
            for variant in layout.columns:
                x = layout.left(variant)
                if variant in cells:
                    _cell(sheet, layout, x, y, cells[variant])
                else:
                    sheet.box(x, y, layout.width - GAP, layout.row - GAP, EMPTY)
            y += layout.row
    return y


def _legend(sheet, y, present):
    """A line for each verdict that occurs, and one for a method that is not run."""
    entries = [(VERDICTS[name].colour, SHADES[name in GOOD], f"{VERDICTS[name].symbol} {VERDICTS[name].word}",
                VERDICTS[name].meaning) for name in present]
    for colour, alpha, word, meaning in entries + [(EMPTY, 1, "empty", ABSENT)]:
        sheet.box(MARGIN, y - 0.085, 0.05, 0.17, colour)
        sheet.box(MARGIN, y - 0.085, LABEL - 0.15, 0.17, colour, alpha)
        sheet.text(MARGIN + 0.1, y, word)
        sheet.text(MARGIN + LABEL, y, meaning, width=WIDTH - LABEL - 2 * MARGIN, color=SOFT)
        y += LINE


def _sheet(height):
    picture = pyplot.figure(figsize=(WIDTH, height))
    panel = picture.add_axes([0, 0, 1, 1], xlim=(0, WIDTH), ylim=(height, 0))
    panel.axis("off")
    return picture, Sheet(panel, WIDTH)


def draw_matrix(grid, title, stem):
    """Saves the matrix of `grid` under a title."""
    layout, title = _Layout(grid.variants), wrapped(title, 90)
    present = [name for name in VERDICTS if any(fold.count(name) for fold in grid.folds)]
    note = 0.42 + 0.2 * title.count("\n")
    top = note + (0.2 + UPRIGHT if layout.narrow else 0.42)
    cases = TOPIC * len(grid.topics) + layout.row * sum(map(len, grid.topics.values()))
    picture, sheet = _sheet(top + cases + 0.2 + LINE * (len(present) + 1))
    sheet.panel.text(MARGIN, 0.08, title, fontsize=11.5, weight="bold", va="top")
    sheet.text(MARGIN, note, HOW_TO_READ, width=WIDTH - 2 * MARGIN, color=SOFT)
    _heads(sheet, layout, top)
    _legend(sheet, _cases(sheet, layout, top + 0.06, grid.topics) + 0.2, present)
    save(picture, stem)
