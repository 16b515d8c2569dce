"""Writes heap-growth.csv and heap-slope.csv beside this file from the records of the paper tier of the case 'heap'.

    python3 reference/source/MUL/extract_heap.py report/records/heap/hsmc

Run from the top folder of the repository. Only by hand, with a reason: a run never makes its own reference. Surface, height,
l/r and the comparison of shapes are those of the checks (validation/check/heap_profile.hpp, heap_shape.hpp), in Python.
"""

import csv
import sys
import tomllib
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares
from scipy.special import lambertw

from analysis import load_record

HERE = Path(__file__).parent
QUANTITIES = ["height", "area", "slope", "kink_length", "advantage"]
HEADER = ["run", "particles", "state", *(name for each in QUANTITIES for name in (each, "standard_error")), "runs"]
SIZES = [100, 200, 400, 800, 1600, 3200, 6400, 10000, 15000, 20000, 25000, 30000]


def surface(series, time, source, width):
    """(x, h) of one replica around a time: medians over ten particles before and after, closed under the stream."""
    inside = np.abs(series.time - time) <= 10 / source["rate"] * (1 + 1e-9)
    height = np.median(series.value[inside], axis=0)
    step = width / len(height)
    x = (np.arange(len(height)) + 0.5) * step - source["centre"][0]
    if time <= source["count"] / source["rate"] * (1 + 1e-9):
        half = (source.get("width", [0.0])[0] + step) / 2
        under = np.flatnonzero((x > -half) & (x <= half))
        height[under] = (height[under[0] - 1] + height[under[-1] + 1]) / 2
    return x, height


def shape(x, h):
    """(area, height, half of the base) of the triangle with the moments of the surface."""
    step = x[1] - x[0]
    area = step * h.sum()
    height = 1.5 * step * (h**2).sum() / area
    return area, height, area / height


def straight_slope(x, h):
    """Mean of both sides from 0.2 to 0.7 of half the base; bins count by their part of the range."""
    half, step, sides = shape(x, h)[2], x[1] - x[0], []
    for side in (-1, 1):
        away = side * x
        part = np.clip(np.minimum(away + step / 2, 0.7 * half) - np.maximum(away - step / 2, 0.2 * half), 0, None)
        sides.append(-np.polyfit(away, h, 1, w=part**0.5)[0])
    return np.mean(sides)


def law(parameters, x):
    centre, top, slope = parameters[0], np.exp(parameters[1]), np.exp(parameters[2])
    away = np.abs(x - centre)
    if len(parameters) == 3:
        return np.maximum(0, top - slope * away)
    kink = np.exp(parameters[3])
    s = top / (slope * kink) + np.log(top / (slope * kink)) - away / kink
    large = s > 500
    w = np.where(large, s - np.log(np.maximum(s, 1)), lambertw(np.exp(np.minimum(s, 500))).real)
    for _ in range(4):
        w = np.where(large, w - (w + np.log(w) - s) / (1 + 1 / w), w)
    return slope * kink * w


def fitted(x, h, kinked):
    start = [x[h.argmax()], np.log(h.max()), np.log(h.max()**2 / (h.mean() * np.ptp(x)))]
    found = least_squares(lambda p: law(p, x) - h, start, x_scale=[1, 0.1, 0.1]).x
    if not kinked:
        return found
    return least_squares(lambda p: law(p, x) - h, [*found, found[1] - found[2] - np.log(20)], x_scale=[1, 0.1, 0.1, 0.3]).x


def tail(x, h):
    """(l/r, mean square residual of the triangle less that of (3.17) over left-out points, its error over ten folds)"""
    half = shape(x, h)[2]
    chosen = (np.abs(x) >= 0.2 * half) & (np.abs(x) <= 2 * half)
    x, h = x[chosen], h[chosen]
    stretches = int(np.clip(len(x) // 20, 1, 4))
    fold = np.arange(len(x)) * 10 * stretches // len(x) % 10
    gains = []
    for one in range(10):
        out = fold == one
        gains.append(np.subtract(*(np.mean((law(fitted(x[~out], h[~out], kinked), x[out]) - h[out])**2)
                                   for kinked in (False, True))))
    return np.exp(fitted(x, h, True)[3]), np.mean(gains), np.std(gains, ddof=1) / 10**0.5


def measured(x, h):
    """QUANTITIES of one surface, and the error of the last."""
    area, height, _ = shape(x, h)
    return height, area, straight_slope(x, h), *tail(x, h)


def row(name, state, time, runs, source, width):
    found = np.array([measured(*surface(run, time, source, width)) for run in runs])
    mean, count = found.mean(axis=0)[:5], len(runs)
    error = found[:, :5].std(axis=0, ddof=1) / count**0.5 if count > 1 else [np.nan] * 4 + [found[0, 5]]
    values = ["" if np.isnan(value) else f"{value:.4g}" for pair in zip(mean, error) for value in pair]
    return [name, min(source["count"], int(source["rate"] * time)), state, *values, count]


def rows(path):
    record = load_record(path)
    scene = tomllib.loads(record.scene)
    source, runs = scene["source"][0], record.series["free-surface"]
    last, end = min(run.time[-1] for run in runs), source["count"] / source["rate"]
    times = [("growing", size / source["rate"]) for size in SIZES if size < source["count"]]
    for state, time in [*times, ("growing", end), ("at rest", last)]:
        if time <= last and (state == "growing" or last > end):
            yield row(Path(path).stem, state, time, runs, source, scene["domain"]["size"][0])


def slopes(paths):
    """Rows (restitution, slope of the mean surface and its error, growing and at rest, runs): error by jackknife."""
    for path in paths:
        record = load_record(path)
        scene = tomllib.loads(record.scene)
        source, runs = scene["source"][0], record.series["free-surface"]
        found = []
        for time in (source["count"] / source["rate"], runs[0].time[-1]):
            surfaces = [surface(run, time, source, scene["domain"]["size"][0]) for run in runs]
            x, h = surfaces[0][0], np.array([h for _, h in surfaces])
            left_out = [straight_slope(x, np.delete(h, one, axis=0).mean(axis=0)) for one in range(len(h))]
            found += [straight_slope(x, h.mean(axis=0)), (len(h) - 1)**0.5 * np.std(left_out)]
        yield [scene["species"][0]["restitution"], *(f"{value:.4f}" for value in found), len(runs)]


def write(name, header, content):
    with (HERE / f"heap-{name}.csv").open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(content)


def main(folder):
    write("growth", HEADER, [line for name in ("large", "source-size") for line in rows(Path(folder) / f"{name}.h5")])
    write("slope", ["restitution", "growing", "standard_error", "at_rest", "standard_error", "runs"],
          sorted(slopes(Path(folder).glob("wide-r-*.h5"))))


if __name__ == "__main__":
    main(sys.argv[1])
