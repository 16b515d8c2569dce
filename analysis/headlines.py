"""The three pictures of the front page: a law over decades, a gas that clusters, accuracy against run time."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from analysis.clustering_panels import MANY, load_frames, show_density, show_disks
from analysis.comparison import can_show
from analysis.plotting import INK, literal, method_look, pyplot, save
from analysis.sweep_figures import draw_frontier
from analysis.summary import quantities

SIZE = (4.6, 3.9)   # inches
HAFF = "homogeneous-cooling", "haff-cooling"
CLUSTER = "clustering"


@dataclass(frozen=True)
class Headline:
    name: str       # inside figures/, without ending
    title: str
    text: str
    address: str    # of the page that tells more


def _cooling(report):
    """[(verdict, its figure)] of gases whose energy is held against Haff's law; the law's time scale is expected."""
    found = [item for case in report.cases if case.name == HAFF[0] for item in case.evidence
             if item.verdict.check == HAFF[1] and item.verdict.verdict == "pass" and item.figures]
    return [(item.verdict, item.figures[0].points[0]) for item in found if item.figures[0].points and item.verdict.expected]


def decades(runs):
    """How many the energy falls through, over all runs."""
    low = min((value for _, points in runs for value in points.y if value > 0), default=1.0)
    return int(np.floor(-np.log10(low) + 0.05))


def draw_cooling(runs, stem):
    """E/E0 against t/t0: every restitution, density and method on one curve."""
    picture, panel = pyplot.subplots(figsize=SIZE)
    picture.subplots_adjust(left=0.15, right=0.97, top=0.97, bottom=0.14)
    last, variants = 1.0, list(dict.fromkeys(verdict.variant for verdict, _ in runs))
    for verdict, points in runs:
        time, energy = np.array(points.x) / verdict.expected, np.array(points.y, float)
        if not (time > 0).any():
            continue
        look = method_look(verdict.variant, variants)
        first = max(time[time > 0].min(), 1e-2)
        marks = [int(np.argmin(np.abs(time - each))) for each in np.geomspace(first, time.max(), 9)]
        panel.plot(time[marks], energy[marks], look["marker"], color=look["color"], markerfacecolor="none",
                   markersize=5, markeredgewidth=0.8)
        last = max(last, time.max())
    for variant in variants:
        look = method_look(variant, variants)
        panel.plot([], [], look["marker"], color=look["color"], markerfacecolor="none", label=literal(variant))
    times = np.geomspace(1e-2, last, 200)
    panel.plot(times, (1 + times) ** -2, color=INK, linewidth=1.4, zorder=6, label="Haff: (1 + t/t₀)⁻²")
    panel.set(xscale="log", yscale="log", xlabel="t / t₀", ylabel="E / E₀", xlim=(1e-2, None), ylim=(None, 2))
    panel.legend(loc="lower left", fontsize=8.5, ncol=1, labelspacing=0.25)
    save(picture, stem)


def draw_cluster(path, stem):
    """The last frame of a record."""
    run = load_frames(path)
    picture = pyplot.figure(figsize=SIZE, dpi=150)
    panel = picture.add_axes([0.08, 0.02, 0.84, 0.96])
    position = run.position[-1][np.isfinite(run.position[-1][:, 0])]
    show_density(panel, position, run.edges) if len(position) > MANY else show_disks(panel, position)
    panel.set(xlim=(0, run.edges[0]), ylim=(0, run.edges[1]), aspect="equal", xticks=[], yticks=[])
    panel.spines[["top", "right"]].set_visible(True)
    save(picture, stem)


def _frames(report, folder):
    """A kept record of the clustering gas with frames: of the exact method, which finds contacts, if there is one."""
    kept = [folder / run.record for case in report.cases if case.name == CLUSTER for run in case.runs
            if run.record and (folder / run.record).is_file()]
    shown = [path for path in kept if can_show(path, ("particles/all/position/value",))]
    exact = [path for path in shown if can_show(path, ("sandglass/series/impact-parameter",))]
    return next(iter(exact + shown), None)


def plan(report, folder, figures):
    """(headlines that this report can show, jobs that draw them)"""
    shown, jobs = [], []

    def add(name, title, text, address, draw, what):
        shown.append(Headline(name, title, text, address))
        jobs.append(partial(draw, what, figures / name))

    runs = _cooling(report)
    if runs:
        methods = len({verdict.variant for verdict, _ in runs})
        add("headline.cooling", f"Haff's law over {decades(runs)} decades",
            f"Energy of {len(runs)} inelastic gases by {methods} method{'s' if methods != 1 else ''}, from dilute to dense, "
            "on the one curve that theory gives.",
            f"case/{HAFF[0]}.html", draw_cooling, runs)
    frames = _frames(report, folder)
    if frames:
        add("headline.cluster", "The clustering gas", "A uniform gas that loses energy in collisions does not stay uniform.",
            f"case/{CLUSTER}.html", draw_cluster, frames)
    sweeps = max(quantities(report.sweeps).values(), key=len, default=[])
    if sweeps:
        quantity = sweeps[0][1].quantity
        add("headline.frontier", "Error against run time",
            f"What accuracy costs: each knob of a method, turned, for the {quantity}.", "precision.html",
            draw_frontier, [sweep for _, sweep in sweeps])
    return shown, jobs
