"""Draws the figures of a source from the records of a report and writes the page that sets them beside its words."""

import os
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass

from analysis.errors import InputError
from analysis.pages import environment
from analysis.source.catalogue import DRAWINGS, SourceFigure, catalogue
from analysis.source.runs import CaseRuns, Lacking


@dataclass(frozen=True)
class Drawn:
    """One figure of the page: `picture` is its name inside figures/, or empty for the reason in `lacking`."""

    figure: SourceFigure
    picture: str
    lacking: str


def _draw(name, figure, case, folder):
    if figure.missing or case is None:
        return Drawn(figure, "", figure.missing or f"the case '{figure.case}' is not in this report")
    picture = f"source-{name}-{figure.number}"
    try:
        DRAWINGS[name][figure.number](CaseRuns(case, folder), folder / "figures" / picture)
    except Lacking as reason:
        return Drawn(figure, "", str(reason))
    return Drawn(figure, picture, "")


def draw_sources(report, folder, pool):
    """{source: [job that gives a Drawn]} of the sources whose cases the report holds, at work in the pool."""
    cases = {case.name: case for case in report.cases}
    listed = {name: catalogue(name).figures for name in DRAWINGS}
    return {name: [pool.submit(_draw, name, figure, cases.get(figure.case), folder) for figure in figures]
            for name, figures in listed.items() if any(figure.case in cases for figure in figures)}


def source_figures(name, report, folder):
    """Returns (path of the page, figures). Throws InputError for an unknown source and for broken records."""
    listed = catalogue(name)
    if not any(figure.case in {case.name for case in report.cases} for figure in listed.figures):
        raise InputError(folder, "", f"holds no case that draws a figure of {listed.source}",
                         "run 'sandglass validate' for one of " + ", ".join(sorted(
                             {figure.case for figure in listed.figures if figure.case})))
    with ProcessPoolExecutor(min(len(os.sched_getaffinity(0)), 8)) as pool:
        drawn = [job.result() for job in draw_sources(report, folder, pool)[name]]
    return write_source(name, report, folder, drawn), drawn


def write_source(name, report, folder, drawn):
    """The page of a source; returns its path."""
    listed, cases = catalogue(name), {case.name for case in report.cases}
    page = folder / f"source-{name}.html"
    template = environment(report, folder).get_template("source.html.j2")
    page.write_text(template.render(root="", listed=listed, drawn=drawn, cases=cases), encoding="utf-8")
    return page
