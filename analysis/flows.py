"""The table of methods against flows (Müller 2001, figure 2.15): our verdicts and costs beside what the source says.

Columns, rows and the words of the source: reference/source/MUL/flows.toml. A report fills the cells; nothing is judged.
"""

from dataclasses import dataclass
from pathlib import Path

from analysis.checked import read_toml
from analysis.cost import relative_costs
from analysis.grid import grid
from analysis.words import GOOD

TABLE = Path(__file__).parent.parent / "reference" / "source" / "MUL" / "flows.toml"


@dataclass(frozen=True)
class Look:
    symbol: str
    word: str
    colour: str
    meaning: str


STANDINGS = {
    "suits": Look("✓", "suits", "#009e73", "every check that decides holds"),
    "limits": Look("◐", "with limits", "#56b4e9", "some checks hold, others are known limits"),
    "unsuited": Look("◇", "unsuited", "#0072b2", "all checks that decide are known limits"),
    "fails": Look("✗", "fails", "#cc3311", "a check fails that should hold"),
    "undecided": Look("?", "undecided", "#e69f00", "an error bar is too wide, or a known limit was not seen"),
    "not made for it": Look("·", "not made for it", "#9aa3aa", "the method is made for other flows"),
    "planned": Look("·", "not built yet", "#9aa3aa", "the method comes later"),
    "not run": Look("–", "not run", "#9aa3aa", "the cases of this report do not run it"),
}
SAYS = ("suits", "limits", "unsuited")


@dataclass(frozen=True)
class Says:
    """What the source says of a method in a flow."""

    standing: str
    text: str
    part: str


@dataclass(frozen=True)
class Method:
    name: str
    title: str
    source: str            # its name in the source, if it has one
    planned: bool = False
    by_event: bool = False


@dataclass(frozen=True)
class Flow:
    name: str
    case: str
    decide: list[str]
    depart: list[str]
    stand_in: dict[str, str]   # method -> the variant of the case that stands for it
    says: dict[str, Says]


@dataclass(frozen=True)
class Cell:
    standing: str
    says: Says | None
    holds: int = 0             # checks that decide and hold
    asked: int = 0             # checks that decide
    cost: float | None = None  # of the same flow, plain dsmc being 1
    variant: str = ""
    reason: str = ""

    @property
    def look(self):
        return STANDINGS[self.standing]


@dataclass(frozen=True)
class FlowTable:
    source: str
    table: str
    flows: list[Flow]
    methods: list[Method]      # of the source
    others: list[Method]       # further variants of this report
    cells: dict[tuple[str, str], Cell]   # (method, flow)


def _says(node):
    word, text, part = [item.expect(str) for item in node]
    if word not in SAYS:
        node.fail(f"'{word}' is not one of {', '.join(SAYS)}")
    return Says(word, text, part)


def _texts(node, name):
    return [item.expect(str) for item in node[name]] if node.has(name) else []


def _flow(node):
    stand_in = {name: node["as"].text(name) for name in node["as"].expect(dict)} if node.has("as") else {}
    says = {name: _says(node["says"][name]) for name in node["says"].expect(dict)}
    return Flow(node.text("name"), node.text("case"), _texts(node, "decide"), _texts(node, "depart"), stand_in, says)


def _method(node):
    flags = [node.has(name) and node.flag(name) for name in ("planned", "by-event")]
    return Method(node.text("name"), node.text("title"), node.text("source"), *flags)


def _made_for(root):
    """{method: (flows, reason)}"""
    return {name: (_texts(node, "flows"), node.text("reason"))
            for node in root["made-for"] for name in _texts(node, "methods")}


def standing(flow, fold):
    """(standing, checks that decide and hold, checks that decide) of one variant in the case of a flow."""
    chosen = [item for item in fold.verdicts if item.check in flow.decide] or fold.verdicts
    limits = sum(item.verdict == "expected-fail" or item.check in flow.depart for item in chosen)
    holds = len(chosen) - limits
    if fold.count("fail"):
        word = "fails"
    elif any(item.verdict not in GOOD for item in fold.verdicts):
        word = "undecided"
    else:
        word = "suits" if not limits else "limits" if holds else "unsuited"
    return word, sum(item.verdict == "pass" and item.check not in flow.depart for item in chosen), len(chosen)


def _cell(method, flow, folds, costs, made_for):
    variant = flow.stand_in.get(method.name, method.name)
    says = flow.says.get(method.name)
    flows, reason = made_for.get(method.name, ([flow.name], ""))
    if variant in folds:
        word, holds, asked = standing(flow, folds[variant])
        return Cell(word, says, holds, asked, costs.get(variant), variant)
    if method.planned:
        return Cell("planned", says)
    return Cell("not run", says) if flow.name in flows else Cell("not made for it", says, reason=reason)


def _costs(flow, case, methods, plain):
    by_event = {method.name for method in methods if method.by_event}
    return relative_costs(case.runs, flow.stand_in.get(plain, plain), by_event) if case else {}


def flow_table(report, path=TABLE):
    """The table that a report fills. Throws InputError when the file of flows is not as it should be."""
    root = read_toml(path)
    flows, methods = [_flow(node) for node in root["flow"]], [_method(node) for node in root["method"]]
    made_for = _made_for(root)
    cases = {case.name: case for case in report.cases}
    folds = {name: cells for rows in grid(report).topics.values() for name, cells in rows.items()}
    found = dict.fromkeys(name for flow in flows for name in folds.get(flow.case, {}))
    others = [Method(name, name, "") for name in found if name not in {method.name for method in methods}]
    cells = {}
    for flow in flows:
        costs = _costs(flow, cases.get(flow.case), methods, root.text("plain"))
        for method in methods + others:
            cells[method.name, flow.name] = _cell(method, flow, folds.get(flow.case, {}), costs, made_for)
    return FlowTable(root.text("source"), root.text("table"), flows, methods, others, cells)
