"""The pages of a report folder, from templates."""

from pathlib import Path

import jinja2
from markupsafe import Markup

from analysis import bar, markdown, summary, words
from analysis.flows import STANDINGS, flow_table
from analysis.grid import grid

HERE = Path(__file__).parent


def environment(report, folder):
    """Templates with all text escaped, and the words they use."""
    result = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "templates"), autoescape=True,
                                trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    result.filters.update(number=words.number, units=words.units, seconds=words.seconds, size=words.size,
                          ratio=words.ratio, factor=words.factor, expectation=words.expectation)
    result.globals.update(
        report=report, summary=summary, looks=words.VERDICTS, good=words.GOOD, worst=words.worst,
        absent=words.ABSENT, claim_states=words.CLAIM_STATES,
        slug=words.slug, with_error=words.with_error, total=summary.total, budget_bar=bar.budget_bar,
        style=(HERE / "style.css").read_text(encoding="utf-8"), kept=lambda name: (folder / name).is_file(),
        markdown=lambda text: Markup(markdown.render(text)))
    return result


def _write(path, template, **values):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(template.render(**values), encoding="utf-8")


def write_pages(report, folder, pictures):
    """Writes index, case, flow, precision and mutant pages; `pictures` says which files exist (see build.py)."""
    templates = environment(report, folder)
    _write(folder / "index.html", templates.get_template("index.html.j2"), root="", pictures=pictures,
           grid=grid(report), cases={case.name: case for case in report.cases})
    for case in report.cases:
        _write(folder / "case" / f"{words.slug(case.name)}.html", templates.get_template("case.html.j2"),
               root="../", case=case, pictures=pictures, key=lambda item: (item.point, item.check))
    _write(folder / "flows.html", templates.get_template("flows.html.j2"), root="", table=flow_table(report),
           standings=STANDINGS, cases={case.name for case in report.cases})
    _write(folder / "precision.html", templates.get_template("precision.html.j2"), root="", pictures=pictures,
           quantities=summary.quantities)
    _write(folder / "mutants.html", templates.get_template("mutants.html.j2"), root="", pictures=pictures)
