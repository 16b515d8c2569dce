"""Writes clustering-*.csv beside this file from the records of the paper tier of the case 'clustering'.

    python3 reference/source/MUL/extract_clustering.py report/records/clustering

Run from the top folder of the repository. Only by hand, with a reason: a run never makes its own reference.
"""

import csv
import sys
from pathlib import Path

import numpy as np

from analysis import load_record

METHODS = ["event-driven", "dsmc-enskog", "cba"]
TIMES = [0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60, 70, 85, 100]
LATE = [150, 200, 300, 400, 500, 700, 1000]
HERE = Path(__file__).parent


def statistics(values):
    """Mean and standard error over replicas; no error of a single one."""
    count = len(values)
    error = np.std(values, axis=0, ddof=1) / np.sqrt(count) if count > 1 else np.full(np.shape(values[0]), np.nan)
    return np.mean(values, axis=0), error


def number(value):
    return "" if np.isnan(value) else f"{value:.6g}"


def write(name, header, rows):
    with (HERE / f"clustering-{name}.csv").open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def energy(early, late):
    for method in METHODS:
        for records, times in ((early, TIMES), (late, LATE)):
            runs = records[method].series["energy"]
            # Straight line in ln between samples.
            values = [np.exp(np.interp(times, run.time, np.log(run.value / run.value[0]))) for run in runs]
            for time, mean, error in zip(times, *statistics(values)):
                yield [method, time, number(mean), number(error), len(runs)]


def sampled(early, late, quantity, times, late_times, last):
    """Rows of a binned quantity at the samples nearest to the times; bins to `last`."""
    for method in METHODS:
        for records, chosen in ((early, times), (late, late_times)):
            runs = records[method].series[quantity]
            edges = np.array(runs[0].quantity.axis)
            for time in chosen:
                values = [run.value[np.argmin(np.abs(run.time - time))] for run in runs]
                for low, high, mean, error in zip(edges, edges[1:], *statistics(values)):
                    if high <= last * (1 + 1e-9):
                        yield [method, time, f"{(low + high) / 2:.6g}", number(mean), number(error), len(runs)]


def impact(early, late):
    for records, marks in ((early, [0, 5, 10, 20, 50, 100]), (late, [100, 200, 500, 1000])):
        runs = records["event-driven"].series["impact-parameter"]
        edges = np.array(runs[0].quantity.axis)
        for begin, end in zip(marks, marks[1:]):
            inside = (runs[0].time > begin * 1.0001) & (runs[0].time <= end * 1.0001)
            counts = sum(run.value[inside].sum(axis=0) for run in runs)
            for low, high, density in zip(edges, edges[1:], counts / counts.mean()):
                yield [begin, end, f"{low:g}", f"{high:g}", number(density), int(counts.sum())]


def main(folder):
    early, late = ({method: load_record(Path(folder) / method / f"{point}.h5") for method in METHODS}
                   for point in ("source-size", "late"))
    write("energy", ["method", "t/t0", "E/E0", "standard_error", "runs"], energy(early, late))
    write("structure", ["method", "t/t0", "k L/2pi", "S", "standard_error", "runs"],
          sampled(early, late, "structure-factor", [0, 5, 10, 20, 50, 100], [200, 500, 1000], 60.5))
    write("pairs", ["method", "t/t0", "r/d", "g", "standard_error", "runs"],
          sampled(early, late, "pair-correlation", [0, 100], [1000], 5))
    write("impact", ["t/t0 from", "t/t0 to", "b/d from", "b/d to", "P", "contacts"], impact(early, late))


if __name__ == "__main__":
    main(sys.argv[1])
