"""The pages of a report folder, from templates."""

import re
from pathlib import Path

import jinja2
from markupsafe import Markup

from analysis import bar, claims, explain, frontier, markdown, sensitivity, summary, words
from analysis.checks import split
from analysis.flows import STANDINGS, flow_table
from analysis.grid import grid

HERE = Path(__file__).parent
OPENING = re.compile(r'<svg[^>]*?width="([\d.]+)pt" height="([\d.]+)pt"')


def _claim_pages(report):
    """{claim: address of its row}, from the top of the folder."""
    return {row.name: f"{claims.page_name(source)}#{words.slug('claim', row.name)}"
            for source, rows in claims.ledger(report).items() for row in rows}


def _size_of(folder):
    """Width and height of a picture, so that the page keeps its place before it is loaded."""
    def size(name):
        with (folder / "figures" / f"{name}.svg").open(encoding="utf-8") as stream:
            found = OPENING.search(stream.read(1000))
        pixels = [float(each) * 4 / 3 for each in found.groups()] if found else []
        return Markup('width="{:.0f}" height="{:.0f}"').format(*pixels) if found else ""
    return size


def environment(report, folder):
    """Templates with all text escaped, and the words they use."""
    result = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "templates"), autoescape=True,
                                trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    result.filters.update(number=words.number, units=words.units, seconds=words.seconds, size=words.size,
                          ratio=words.ratio, brief=words.brief, factor=words.factor, expectation=words.expectation, said=words.said,
                          capitalize_first=lambda text: text[:1].upper() + text[1:])
    result.globals.update(
        report=report, sensitivity=sensitivity, summary=summary, looks=words.VERDICTS, good=words.GOOD, worst=words.worst,
        absent=words.ABSENT, claim_states=words.CLAIM_STATES,
        slug=words.slug, with_error=words.with_error, total=summary.total, budget_bar=bar.budget_bar,
        ledger_page=claims.page_name, claim_sources=list(claims.ledger(report)), claim_pages=_claim_pages(report),
        method_summaries=explain.method_summaries(), size_of=_size_of(folder),
        style=(HERE / "style.css").read_text(encoding="utf-8"), kept=lambda name: (folder / name).is_file(),
        script_text=(HERE / "templates" / "report.js").read_text(encoding="utf-8"),
        markdown=lambda text: Markup(markdown.render(text)))
    return result


def _write(path, template, **values):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(template.render(**values), encoding="utf-8")


def write_front_page(report, folder, pictures):
    """Writes index.html; `pictures` says which files exist (see build.py)."""
    _write(folder / "index.html", environment(report, folder).get_template("index.html.j2"), root="", pictures=pictures,
           grid=grid(report), cases={case.name: case for case in report.cases},
           ledger_line=claims.sentence(report))


def write_pages(report, folder, pictures):
    """Writes index, case, flow, precision and mutant pages."""
    write_front_page(report, folder, pictures)
    templates = environment(report, folder)
    for case in report.cases:
        shown, identities = split(case)
        _write(folder / "case" / f"{words.slug(case.name)}.html", templates.get_template("case.html.j2"),
               root="../", case=case, pictures=pictures, shown=shown, identities=identities,
               settings=explain.points(case))
    _write(folder / "flows.html", templates.get_template("flows.html.j2"), root="", table=flow_table(report),
           standings=STANDINGS, cases={case.name for case in report.cases})
    _write(folder / "precision.html", templates.get_template("precision.html.j2"), root="", pictures=pictures,
           cases={case.name for case in report.cases}, quantities=summary.quantities, targets=frontier.TARGETS, cheapest=frontier.cheapest, bound=frontier.bound,
           best_bound=frontier.best_bound, judge_order=frontier.judge_order,
           cheaper_when_finer=frontier.cheaper_when_finer)
    _write(folder / "mutants.html", templates.get_template("mutants.html.j2"), root="", pictures=pictures)
