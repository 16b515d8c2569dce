"""python3 -m analysis report|table FOLDER, against FOLDER EARLIER, source-figures SOURCE FOLDER, plot|impact RECORD"""

import argparse
import sys
from pathlib import Path

from analysis.errors import InputError
from analysis.load import load_report, load_verdicts

LEDGER = Path(__file__).parent.parent / "reference" / "claims.toml"


def _arguments():
    parser = argparse.ArgumentParser("python3 -m analysis", description="Pages from a report folder.")
    commands = parser.add_subparsers(dest="command", required=True)
    for name, text in (("report", "write pages, pictures, CSV and JUnit XML"), ("table", "print a table")):
        command = commands.add_parser(name, help=text)
        command.add_argument("folder", type=Path, help="the folder that 'sandglass validate' filled")
        command.add_argument("--claims", type=Path, default=LEDGER, help="ledger of claims (TOML)")
    against = commands.add_parser("against", help="compare with an earlier report: verdicts, values, costs")
    against.add_argument("folder", type=Path, help="the folder that 'sandglass validate' filled")
    against.add_argument("earlier", type=Path, help="one that it filled before")
    source = commands.add_parser("source-figures", help="draw the figures of a source, ours beside its words")
    source.add_argument("source", help="MUL: Müller 2001, GRE: Greenspan 1972, KAW: Kawasaki 1986")
    source.add_argument("folder", type=Path, help="the folder that 'sandglass validate' filled")
    plot = commands.add_parser("plot", help="draw each series, histogram and field of a record, with error bars")
    plot.add_argument("record", type=Path, help="that 'sandglass run' wrote")
    plot.add_argument("--output", "-o", type=Path, help=".svg, .png or .pdf (default: NAME.svg here, for NAME.h5)")
    plot.add_argument("--overwrite", action="store_true", help="replace a picture of that name")
    impact = commands.add_parser("impact", help="print c(tau) of an event-driven record as lines of a scene")
    impact.add_argument("record", type=Path, help="with the observer 'impact-parameter'")
    impact.add_argument("--window", type=float, default=10.0, help="collisions per particle in each fit")
    return parser.parse_args()


def main():
    """0: written; 2: bad input, said on standard error."""
    arguments = _arguments()
    try:
        if arguments.command == "impact":
            from analysis.impact import print_coefficient
            print_coefficient(arguments.record, arguments.window)
            return 0
        if arguments.command == "plot":
            from analysis.record_figure import draw_record
            output = arguments.output or Path(arguments.record.stem + ".svg")
            print(f"{draw_record(arguments.record, output, arguments.overwrite)} panels: {output}")
            return 0
        if arguments.command == "against":
            from analysis.against import compare
            print(compare(load_verdicts(arguments.folder), load_verdicts(arguments.earlier)))
            return 0
        if arguments.command == "source-figures":
            from analysis.source.build import source_figures
            page, drawn = source_figures(arguments.source, load_report(arguments.folder), arguments.folder)
            print(f"{sum(bool(item.picture) for item in drawn)} of {len(drawn)} figures: {page}")
            return 0
        report = load_report(arguments.folder, arguments.claims)
        if arguments.command == "table":
            from analysis.table import print_table
            print_table(report)
        else:
            from analysis.build import build
            print(build(report, arguments.folder))
    except InputError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        remedy = "make the folder writable, or free space"
        print(f"error: {error.filename}: {error.strerror}; {remedy}", file=sys.stderr)
        return 2
    return 0


def run():
    """The command 'sandglass-analysis' of an installed package."""
    sys.exit(main())


if __name__ == "__main__":
    run()
