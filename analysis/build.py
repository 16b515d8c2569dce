"""Draws every picture of a report and writes its pages and exports."""

import os
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import partial

from analysis import comparison, headlines
from analysis.checks import split
from analysis.data_figure import draw_data
from analysis.equations import draw_equation
from analysis.exports import write_csv, write_junit
from analysis.flows import flow_table
from analysis.flows_figure import draw_flows
from analysis.grid import grid
from analysis.ledger import write_ledger
from analysis.matrix_figure import draw_matrix
from analysis.pages import write_pages
from analysis.source.build import draw_sources
from analysis.summary import headline, quantities
from analysis.sweep_figures import draw_frontier, draw_knob
from analysis.verdict_figure import draw_verdicts, room
from analysis.words import slug


@dataclass(frozen=True)
class Detail:
    """The methods of one point beside each other."""

    point: str
    title: str
    name: str     # inside figures/, without ending


@dataclass
class Pictures:
    """Names of pictures inside figures/, without ending."""

    verdicts: dict = field(default_factory=dict)    # (case, check) -> name
    data: dict = field(default_factory=dict)        # (case, check) -> name, where a figure is shown nowhere before
    details: dict = field(default_factory=dict)     # (case, check) -> [Detail]
    equation: dict = field(default_factory=dict)    # tex -> name, only those that could be drawn
    knob: dict = field(default_factory=dict)        # index of the sweep -> name
    frontier: dict = field(default_factory=dict)    # (case, quantity) -> name
    comparison: dict = field(default_factory=dict)  # case -> [comparison.Comparison]
    headlines: list = field(default_factory=list)   # [headlines.Headline]


def _pairs(group, index):
    """[(evidence, its figure of this index)] of those that have it."""
    return [(item, item.figures[index]) for item in group.evidence if len(item.figures) > index]


def _alike(pairs):
    """Groups of figures with the same axes, which may share a picture."""
    found = {}
    for item, figure in pairs:
        found.setdefault((figure.title, figure.x, figure.y), []).append((item, figure))
    return list(found.values())


class _CasePlan:
    """The pictures of one case; a figure that an earlier check has shown already is not drawn again."""

    def __init__(self, case, figures):
        self.case, self.figures, self.shown, self.jobs = case, figures, set(), []

    def fresh(self, pairs):
        """Whether the page does not show this set of data yet; it counts as shown from now on."""
        key = hash(tuple(repr((item.verdict.variant, item.verdict.point, figure)) for item, figure in pairs))
        new = key not in self.shown
        self.shown.add(key)
        return new

    def add(self, draw, what, *name):
        name = slug("case", self.case.name, *name)
        self.jobs.append(partial(draw, what, self.figures / name))
        return name

    def details(self, group):
        """One picture for each point and figure of a check, where the overlay holds more than that."""
        found = []
        for point in group.points:
            for index in range(max(len(item.figures) for item in group.evidence)):
                pairs = [pair for pair in _pairs(group, index) if pair[0].verdict.point == point]
                for number, alike in enumerate(_alike(pairs)):
                    if self.fresh(alike):
                        name = self.add(draw_data, alike, group.check, point, f"{index}.{number}")
                        found.append(Detail(point, alike[0][1].title, name))
        return found


def _plan_case(case, figures, pictures):
    plan = _CasePlan(case, figures)
    for group in split(case)[0]:
        key = case.name, group.check
        pictures.verdicts[key] = plan.add(draw_verdicts, group, group.check)
        overlays = _alike(_pairs(group, 0))
        if overlays and plan.fresh(overlays[0]):
            draw = partial(draw_data, taller=room(group.points))
            pictures.data[key] = plan.add(draw, overlays[0], group.check, "data")
        pictures.details[key] = plan.details(group)
    return plan.jobs


def _plan(report, folder, figures):
    """(names of pictures, jobs that draw them)."""
    pictures = Pictures()
    jobs = [partial(draw_matrix, grid(report), f"{headline(report)}.", figures / "matrix"),
            partial(draw_flows, flow_table(report), figures / "flows")]
    for case in report.cases:
        pictures.comparison[case.name], more = comparison.plan(case, folder, figures)
        jobs += more + _plan_case(case, figures, pictures)
    for key, group in quantities(report.sweeps).items():
        pictures.frontier[key] = "frontier." + slug(*key)
        jobs.append(partial(draw_frontier, [sweep for _, sweep in group], figures / pictures.frontier[key]))
        for index, sweep in group:
            pictures.knob[index] = "knob." + slug(sweep.case, sweep.variant, sweep.quantity, sweep.knob)
            jobs.append(partial(draw_knob, sweep, figures / pictures.knob[index]))
    pictures.headlines, more = headlines.plan(report, folder, figures)
    return pictures, more + jobs


def _run(job):
    job()


def _draw_equations(report, pictures, figures):
    for equation in {item.tex: item for case in report.cases for item in case.equations}.values():
        name = "equation." + slug(equation.tex)
        if draw_equation(equation.tex, figures / f"{name}.svg"):
            pictures.equation[equation.tex] = name


def build(report, folder):
    """Fills the folder; returns the path of its front page."""
    figures = folder / "figures"
    pictures, jobs = _plan(report, folder, figures)
    with ProcessPoolExecutor(min(len(os.sched_getaffinity(0)), 8)) as pool:
        sources = draw_sources(report, folder, pool)
        list(pool.map(_run, jobs, chunksize=4))
        sources = {name: [job.result() for job in drawn] for name, drawn in sources.items()}
    _draw_equations(report, pictures, figures)
    write_csv(report, folder / "verdicts.csv")
    write_junit(report, folder / "junit.xml")
    write_ledger(report, folder, sources)
    write_pages(report, folder, pictures)
    return folder / "index.html"
