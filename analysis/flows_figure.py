"""The table of methods against flows as one picture, readable 900 pixels wide."""

import textwrap

from analysis.flows import STANDINGS
from analysis.plotting import pyplot, save
from analysis.sheet import Sheet
from analysis.words import factor

WIDTH, MARGIN, LABEL = 9.0, 0.08, 1.15   # inches
TOP, HEAD, ROW, GAP, LINE = 0.66, 0.42, 0.6, 0.05, 0.19
INK, SOFT = "#1d2328", "#555555"
TITLE = "Which method suits which flow"
HOW_TO_READ = ("Colour and word: our checks. “3/4”: checks that decide and hold. “×2”: cost of the same flow, plain dsmc "
               "being 1. Last line: what {} says, in the same signs.")


def _heads(sheet, flows, left, width):
    for index, flow in enumerate(flows):
        for line, text in enumerate(textwrap.wrap(flow.name, 12)[:2]):
            sheet.text(left + index * width + 0.04, TOP + 0.1 + 0.16 * line, text, 9, width - GAP, weight="bold")


def _lines(cell):
    """The three lines of a cell: (text, size, weight, colour)."""
    count = f"{cell.holds}/{cell.asked}" if cell.asked else ""
    cost = factor(cell.cost) if cell.cost else ""
    says = f"source {STANDINGS[cell.says.standing].symbol}" if cell.says else ""
    return [(f"{cell.look.symbol} {cell.look.word}", 8.5, "bold" if cell.asked else "normal", INK if cell.asked else SOFT),
            ("   ".join(text for text in (count, cost) if text), 8, "normal", INK), (says, 8, "normal", SOFT)]


def _cell(sheet, x, y, width, cell):
    shade = 0.42 if cell.asked else 0.12
    sheet.box(x, y, width - GAP, ROW - GAP, cell.look.colour, shade)
    if cell.asked:
        sheet.box(x, y, 0.05, ROW - GAP, cell.look.colour)
    for index, (text, size, weight, colour) in enumerate(_lines(cell)):
        if text:
            sheet.text(x + 0.1, y + 0.11 + 0.17 * index, text, size, width - GAP - 0.12, weight=weight, color=colour)


def _legend(sheet, y, present):
    for name in present:
        look = STANDINGS[name]
        sheet.box(MARGIN, y - 0.085, LABEL - 0.05, 0.17, look.colour, 0.42)
        sheet.text(MARGIN + 0.06, y, f"{look.symbol} {look.word}", width=LABEL - 0.12)
        sheet.text(MARGIN + LABEL + 0.04, y, look.meaning, color=SOFT)
        y += LINE


def draw_flows(table, stem):
    """Saves the rows of the source's methods; other variants stand on the page alone."""
    cells = [table.cells[method.name, flow.name] for method in table.methods for flow in table.flows]
    shown = {cell.standing for cell in cells} | {cell.says.standing for cell in cells if cell.says}
    present = [name for name in STANDINGS if name in shown]
    height = TOP + HEAD + ROW * len(table.methods) + 0.15 + LINE * len(present) + 0.05
    picture = pyplot.figure(figsize=(WIDTH, height))
    panel = picture.add_axes([0, 0, 1, 1], xlim=(0, WIDTH), ylim=(height, 0))
    panel.axis("off")
    sheet = Sheet(panel, WIDTH)
    width, left = (WIDTH - 2 * MARGIN - LABEL) / len(table.flows), MARGIN + LABEL
    sheet.text(MARGIN, 0.2, TITLE, 12.5, weight="bold")
    sheet.text(MARGIN, 0.44, HOW_TO_READ.format(table.source), width=WIDTH - 2 * MARGIN, color=SOFT)
    _heads(sheet, table.flows, left, width)
    y = TOP + HEAD
    for method in table.methods:
        sheet.text(MARGIN, y + 0.2, method.title, 9.5, LABEL - 0.1, weight="bold")
        sheet.text(MARGIN, y + 0.38, f"source: {method.source}", 8, LABEL - 0.1, color=SOFT)
        for index, flow in enumerate(table.flows):
            _cell(sheet, left + index * width, y, width, table.cells[method.name, flow.name])
        y += ROW
    _legend(sheet, y + 0.2, present)
    save(picture, stem)
