"""Figures 3.24 to 3.32: heaps."""

import numpy as np

from analysis.source.methods import OWN
from analysis.source.panels import BLACK, band, finish, marks, panels, shade
from analysis.source.runs import Lacking

SURFACE = "free-surface"


def _poured(run):
    return sum(source.get("count", 0) for source in run.scene.get("source", []))


def _speed(run):
    sources = run.scene.get("source", [])
    return -sources[0].get("velocity", [0.0, 0.0])[-1] if sources else 0.0


def _largest(case):
    """The run with most particles on a plane, dissipative but not completely."""
    runs = [run for run in case.choose("*", OWN) if run.point not in ("box", "table")
            and 0.8 < run.species["restitution"] < 1 and SURFACE in run.record.series]
    if not runs:
        raise Lacking(f"no heap of {OWN} on a plane")
    return max(runs, key=_poured)


def surface(run, sample=-1):
    """Places from the middle of the box, in diameters, height and its standard error."""
    height, error = run.mean(SURFACE, sample)
    width = run.scene["domain"]["size"][0] / len(height)
    return (np.arange(len(height)) + 0.5 - len(height) / 2) * width, height, error


def _show(panel, run, label, sample=-1, **look):
    x, height, error = surface(run, sample)
    band(panel, x, height, error, label=label, **look)


def draw_heap(case, stem):
    run = _largest(case)
    picture, [[panel]] = panels(width=7.2)
    _show(panel, run, f"{_poured(run)} particles, mean of {len(run.series(SURFACE))}", color="#0072b2")
    panel.set(xlabel="x / d", ylabel="h / d", ylim=(0, None))
    panel.legend()
    finish(picture, "3.24", f"A heap of {_poured(run)} particles, r = {run.species['restitution']:g}", stem)


def _growing(run):
    """[(time, x, h)] of up to six heaps from a hundred particles to all: median over the samples of ten particles before and
    after, in which nobody rebounds, without the stream."""
    [source] = run.scene["source"]
    runs, rate = run.series(SURFACE), source["rate"]
    times = runs[0].time
    last = np.searchsorted(times, source["count"] / rate * 1.0001) - 1
    stream = source.get("width", [0.0])[0] / 2 + 1
    heaps = []
    for particles in np.geomspace(min(100, times[last] * rate), times[last] * rate, 6):
        sample = min(last, np.searchsorted(times, particles / rate * 0.9999))
        near = np.abs(times - times[sample]) * rate <= 10
        x, _, _ = surface(run, sample)
        height = np.mean([np.median(item.value[near], axis=0) for item in runs], axis=0)
        heaps.append((times[sample], x, np.where(np.abs(x) < stream, np.nan, height)))
    return heaps


def draw_growth(case, stem):
    heaps = _growing(_largest(case))
    picture, [row] = panels(2)
    for index, (time, x, height) in enumerate(heaps):
        colour, root = shade(index, len(heaps)), time ** 0.5
        row[0].plot(x, height, color=colour, label=f"t = {time:g}")
        row[1].plot(x / root, height / root, color=colour)
    reach = heaps[-1][1].max() / heaps[-1][0] ** 0.5
    row[0].set(xlabel="x / d", ylabel="h / d", ylim=(0, None))
    row[1].set(xlabel="x / (d √t)", ylabel="h / (d √t)", title="over the root of the time", xlim=(-reach, reach),
               ylim=(0, None))
    row[0].legend()
    finish(picture, "3.26", "A growing heap", stem)


def _slopes(case):
    """Rows (r, slope, standard error) of the heaps poured alike, of those with most restitutions."""
    alike = {}
    for run, item in case.verdicts("heap-slope"):
        if run.variant == OWN and item.value is not None:
            row = run.species["restitution"], item.value, item.stderr or 0.0
            alike.setdefault((str(run.scene.get("source")), str(run.scene["domain"])), []).append(row)
    return np.array(sorted(max(alike.values(), key=len, default=[]))).reshape(-1, 3)


def draw_slopes(case, stem):
    rows = _slopes(case)
    if len(rows) < 2:
        raise Lacking("slopes at one restitution: a curve needs two")
    picture, [[panel]] = panels()
    marks(panel, *rows.T, color="#0072b2", linestyle="none")
    for ratio, name in ((1, "1"), (1 / 2, "1/2"), (1 / 3, "1/3")):
        panel.axhline(ratio, linestyle=":", linewidth=0.8, color=BLACK)
        panel.annotate(name, (0, ratio), xycoords=("axes fraction", "data"), xytext=(4, 2),
                       textcoords="offset points", color=BLACK)
    panel.set(xlabel="restitution r", ylabel="slope (dotted: ratios of a lattice)", ylim=(0, None))
    finish(picture, "3.27", "Slope against restitution", stem)


def draw_spikes(case, stem):
    runs = [run for run in case.choose("*", OWN + "*") if run.species["restitution"] == 0]
    if not runs:
        raise Lacking("no run with r = 0")
    picture, [row] = panels(len(runs))
    for panel, run in zip(row, runs):
        for item in run.series(SURFACE)[:8]:
            height = item.value[-1]
            panel.plot(np.arange(len(height)) + 0.5 - len(height) / 2, height, linewidth=0.8)
        panel.set(title=run.variant, xlabel="x / d", xlim=(-20, 20))
    row[0].set_ylabel("h / d")
    finish(picture, "3.28", "r = 0: spikes of two cells, an artefact (eight runs)", stem)


def fit_tail(x, height):
    """(h_m, m, l/r) of (3.17), x = (h_m - h)/m + (l/r) ln(h_m/h), by least squares in x over a range of h_m."""
    inside = height > 0.5
    x, height, best = np.abs(x[inside]), height[inside], (np.inf, None)
    for top in height.max() * np.linspace(0.7, 1.2, 101):
        columns = np.stack([top - height, np.log(top / height)], axis=1)
        (slope, tail), *_ = np.linalg.lstsq(columns, x, rcond=None)
        residual = np.sum((columns @ [slope, tail] - x) ** 2)
        if slope > 0 and tail >= 0 and residual < best[0]:
            best = residual, (top, 1 / slope, tail)
    return best[1]


def draw_tail(case, stem):
    run = _largest(case)
    x, height, error = surface(run)
    fit = fit_tail(x, height)
    picture, [[panel]] = panels(width=7.2)
    band(panel, x, height, error, color="#0072b2", label=f"{_poured(run)} particles")
    if fit is not None:
        top, slope, tail = fit
        h = np.geomspace(0.2, top, 200)
        line = (top - h) / slope + tail * np.log(top / h)
        for side in (1, -1):
            panel.plot(side * line, h, "--", color=BLACK, label="equation (3.17)" if side > 0 else None)
        panel.set_title(f"m = {slope:.2f}, l/r = {tail:.1f} d")
    panel.set(xlabel="x / d", ylabel="h / d", ylim=(0, None), xlim=(x[0], x[-1]))
    panel.legend()
    finish(picture, "3.29", "Surface with the logarithmic tail", stem)


def draw_boundaries(case, stem):
    runs = [case.choose(point, OWN)[0] for point in ("plane", "box", "table")
            if any(run.point == point and run.variant == OWN for run in case.case.runs)]
    if len(runs) < 2:
        raise Lacking("one boundary of three")
    picture, [[panel]] = panels(width=7.2)
    for index, run in enumerate(runs):
        x, height, _ = surface(run)
        panel.plot(x / height.max(), height / height.max(), color=shade(index, len(runs)), label=run.point)
    panel.set(xlabel="x / h_max", ylabel="h / h_max", ylim=(0, None))
    panel.legend()
    finish(picture, "3.31", "Heaps between different boundaries", stem)


def draw_heads(case, stem):
    poured = [run for run in case.choose("*", OWN)
              if _poured(run) and run.species["restitution"] > 0 and run.point not in ("box", "table")]
    runs = sorted({_speed(run): run for run in sorted(poured, key=_poured)}.values(), key=_speed)
    if len(runs) < 2:
        raise Lacking("one pouring speed: the figure needs two")
    picture, [[panel]] = panels(width=7.2)
    for index, run in enumerate(runs):
        x, height, error = surface(run)
        scale = _poured(run) ** 0.5
        band(panel, x / scale, height / scale, error / scale, color=shade(index, len(runs)),
             label=f"poured at {_speed(run):g}, N = {_poured(run)}")
    panel.set(xlabel="x / (d √N)", ylabel="h / (d √N)", ylim=(0, None))
    panel.legend()
    finish(picture, "3.32", "Violent pouring flattens the head", stem)


FIGURES = {"3.24": draw_heap, "3.26": draw_growth, "3.27": draw_slopes, "3.28": draw_spikes, "3.29": draw_tail,
           "3.31": draw_boundaries, "3.32": draw_heads}
