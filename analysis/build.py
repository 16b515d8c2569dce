"""Draws every picture of a report and writes its pages and exports."""

import os
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import partial

from analysis import comparison
from analysis.equations import draw_equation
from analysis.exports import write_csv, write_junit
from analysis.figures import draw_evidence
from analysis.flows import flow_table
from analysis.flows_figure import draw_flows
from analysis.grid import grid
from analysis.matrix_figure import draw_matrix
from analysis.pages import write_pages
from analysis.summary import headline, quantities
from analysis.sweep_figures import draw_cost, draw_knob
from analysis.words import slug


@dataclass
class Pictures:
    """Names of pictures inside figures/, without ending."""

    evidence: dict = field(default_factory=dict)    # verdict key -> [name]
    equation: dict = field(default_factory=dict)    # tex -> name, only those that could be drawn
    knob: dict = field(default_factory=dict)        # index of the sweep -> name
    cost: dict = field(default_factory=dict)        # (case, quantity) -> name
    comparison: dict = field(default_factory=dict)  # case -> [comparison.Comparison]


def _plan(report, folder, figures):
    """(names of pictures, jobs that draw them)."""
    pictures = Pictures()
    jobs = [partial(draw_matrix, grid(report), f"{headline(report)}.", figures / "matrix"),
            partial(draw_flows, flow_table(report), figures / "flows")]
    for case in report.cases:
        for item in case.evidence:
            names = [f"{slug(*item.verdict.key)}.{number}" for number in range(1, len(item.figures) + 1)]
            pictures.evidence[item.verdict.key] = names
            jobs += [partial(draw_evidence, figure, item.verdict, figures / name)
                     for figure, name in zip(item.figures, names)]
        pictures.comparison[case.name], more = comparison.plan(case, folder, figures)
        jobs += more
    for key, group in quantities(report.sweeps).items():
        pictures.cost[key] = "cost." + slug(*key)
        jobs.append(partial(draw_cost, [sweep for _, sweep in group], figures / pictures.cost[key]))
        for index, sweep in group:
            pictures.knob[index] = "knob." + slug(sweep.case, sweep.variant, sweep.quantity, sweep.knob)
            jobs.append(partial(draw_knob, sweep, figures / pictures.knob[index]))
    return pictures, jobs


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
        list(pool.map(_run, jobs, chunksize=4))
    _draw_equations(report, pictures, figures)
    write_csv(report, folder / "verdicts.csv")
    write_junit(report, folder / "junit.xml")
    write_pages(report, folder, pictures)
    return folder / "index.html"
