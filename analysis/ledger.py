"""Writes the pages of the ledger, one for each source, and those of the figures that the sources show."""

from analysis.claims import ledger, page_name
from analysis.pages import environment
from analysis.source.build import write_source


def write_ledger(report, folder, sources):
    """`sources`: {source: [Drawn]} of those that the report can draw."""
    template = environment(report, folder).get_template("ledger.html.j2")
    sources = {name: drawn for name, drawn in sources.items() if any(item.picture for item in drawn)}
    rows = ledger(report, sources)
    for source, items in rows.items():
        text = template.render(root="", source=source, rows=items, pages=rows, has_figures=source in sources,
                               cases={case.name for case in report.cases})
        (folder / page_name(source)).write_text(text, encoding="utf-8")
    for source, drawn in sources.items():
        write_source(source, report, folder, drawn)
