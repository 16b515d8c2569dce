"""The ledger of claims beside the verdicts: what a source says, what we find, and how far that goes."""

from dataclasses import dataclass, field

from analysis.model import Claim, Verdict
from analysis.summary import total
from analysis.words import CLAIM_STATES, GOOD, slug


@dataclass(frozen=True)
class Decision:
    """What one check of one case says of a claim."""

    case: str
    check: str
    verdicts: list[Verdict]

    @property
    def holding(self):
        return sum(item.verdict in GOOD for item in self.verdicts)

    @property
    def farthest(self):
        """The verdict with the largest deviation in budgets, known limits apart where others are there."""
        passed = [item for item in self.verdicts if item.verdict != "expected-fail"] or self.verdicts
        return max(passed, key=lambda item: -1.0 if item.share is None else item.share)


@dataclass(frozen=True)
class Row:
    """One claim; `claim` is None where a verdict names one that the ledger lacks."""

    name: str
    claim: Claim | None
    decisions: list[Decision]
    figures: list = field(default_factory=list)   # Drawn of source/build.py

    @property
    def verdicts(self):
        return [item for decision in self.decisions for item in decision.verdicts]

    @property
    def holding(self):
        return sum(decision.holding for decision in self.decisions)

    @property
    def runs(self):
        return {item.run: item.cpu_seconds for item in self.verdicts}

    @property
    def cpu_seconds(self):
        return total(self.runs.values())

    @property
    def explanation(self):
        """Why state and verdicts may stand beside each other."""
        if self.claim is None:
            return "A verdict names this claim, and the ledger does not hold it."
        count = len(self.verdicts)
        all_hold = count and self.holding == count
        if self.claim.status == "not reproduced" and all_hold:
            return (f"The sentence of the source does not hold as it stands. The {count} verdicts hold because they "
                    "ask for what theory, or the exact method, gives here, and not for the sentence.")
        if self.claim.status == "reproduced" and not count:
            return "Decided by runs that are not part of this report."
        if self.claim.status == "not yet tested":
            return "No run has decided this yet."
        if count and not all_hold:
            return f"{count - self.holding} of {count} verdicts of this report block: the state needs a look."
        return ""


def _decisions(verdicts):
    groups = {}
    for item in verdicts:
        groups.setdefault((item.case, item.check), []).append(item)
    return [Decision(case, check, items) for (case, check), items in groups.items()]


def source_of(claim):
    """'MUL-12' is of the source 'MUL'."""
    return claim.rpartition("-")[0] or claim


def ledger(report, sources=None):
    """{source: [Row]}: every claim of the ledger and every one that a verdict names. `sources`: {source: [Drawn]}."""
    known = {claim.id: claim for claim in report.claims}
    behind = {name: [] for name in known}
    for item in report.verdicts:
        for name in item.claims:
            behind.setdefault(name, []).append(item)
    figures = {}
    for drawn in (sources or {}).values():
        for item in drawn:
            figures.setdefault(item.figure.claim, []).append(item)
    pages = {}
    for name, verdicts in behind.items():
        row = Row(name, known.get(name), _decisions(verdicts), figures.get(name, []))
        pages.setdefault(source_of(name), []).append(row)
    return pages


def tally(report):
    """{state: how many claims of the ledger have it}"""
    return {state: sum(claim.status == state for claim in report.claims) for state in CLAIM_STATES}


def sentence(report):
    """The whole ledger in one line; empty without one."""
    if not report.claims:
        return ""
    counts = ", ".join(f"{count} {state}" for state, count in tally(report).items())
    return f"{len(report.claims)} claims of {len({source_of(item.id) for item in report.claims})} sources: {counts}"


def page_name(source):
    return f"ledger-{slug(source)}.html"
