"""The matrix of cases and variants on a terminal."""

import os
import sys

from analysis.summary import headline, rows
from analysis.words import GOOD, ratio, seconds

HEAD = ("case", "point", "variant", "verdict", "checks", "worst check", "deviation/budget", "CPU time")
STYLES = {"pass": "green", "expected-fail": "blue", "inconclusive": "yellow", "unexpected-pass": "magenta",
          "fail": "red"}
CODES = {"green": 32, "blue": 34, "yellow": 33, "magenta": 35, "red": 31}

WIDEST = 32


def may_colour(stream):
    """Under mpirun a pipe looks like a terminal, hence the last condition."""
    return stream.isatty() and not os.environ.get("NO_COLOR") and "OMPI_COMM_WORLD_SIZE" not in os.environ


def _short(text):
    return text if len(text) <= WIDEST else text[:WIDEST - 1] + "…"


def lines(report):
    """[(verdict, texts of the columns)], a line per run."""
    found = []
    for (case, point), cells in rows(report.verdicts, lambda item: (item.case, item.point)).items():
        for variant, cell in cells.items():
            good = sum(item.verdict in GOOD for item in cell.verdicts)
            found.append((cell.verdict, (
                _short(case), _short(point), _short(variant), f"{cell.look.symbol} {cell.look.word}",
                f"{good}/{len(cell.verdicts)}", _short(cell.shown.check), ratio(cell.shown.share),
                seconds(cell.cpu_seconds))))
    return found


def _plain(content, stream):
    texts = [HEAD] + [line for _, line in content]
    widths = [max(len(line[column]) for line in texts) for column in range(len(HEAD))]
    colour = may_colour(stream)
    for verdict, line in [("", HEAD)] + content:
        cells = [text.ljust(width) for text, width in zip(line, widths)]
        if colour and verdict:
            cells[3] = f"\033[{CODES[STYLES[verdict]]}m{cells[3]}\033[0m"
        print("  ".join(cells).rstrip(), file=stream)


def _rich(content, stream):
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(*HEAD, box=None, header_style="bold")
    for verdict, line in content:
        table.add_row(*(Text(text, style=STYLES[verdict] if column == 3 else "")
                        for column, text in enumerate(line)))
    Console(file=stream).print(table)


def print_table(report, stream=sys.stdout):
    """With rich on a terminal when it is installed; plain columns otherwise."""
    content = lines(report)
    try:
        if not may_colour(stream):
            raise ImportError
        _rich(content, stream)
    except ImportError:
        _plain(content, stream)
    for item in report.verdicts:
        if item.verdict not in GOOD:
            print(f"{item.verdict}: {' / '.join(item.key)}: {item.reason}", file=stream)
    print(headline(report), file=stream)
