"""The sums that the pages show: headline, matrix, claims, cost. No verdict is made here."""

from dataclasses import dataclass

from analysis.model import Verdict
from analysis.words import GOOD, VERDICTS, worst


@dataclass(frozen=True)
class Cell:
    """All checks of one run."""

    verdicts: list[Verdict]

    @property
    def verdict(self):
        return worst(item.verdict for item in self.verdicts)

    @property
    def shown(self):
        """The check that this cell reports: the largest deviation per budget with the cell's verdict."""
        candidates = [item for item in self.verdicts if item.verdict == self.verdict]
        return max(candidates, key=lambda item: -1.0 if item.share is None else item.share)

    @property
    def look(self):
        return VERDICTS[self.verdict]

    @property
    def cpu_seconds(self):
        return self.verdicts[0].cpu_seconds


def count(verdicts):
    """How often each verdict was given, in the order of the vocabulary."""
    return {name: sum(item.verdict == name for item in verdicts) for name in VERDICTS}


def variants(verdicts):
    return list(dict.fromkeys(item.variant for item in verdicts))


def rows(verdicts, row_key):
    """The rows of a matrix with variants as columns: {row_key(verdict): {variant: Cell}}."""
    collected = {}
    for item in verdicts:
        collected.setdefault(row_key(item), {}).setdefault(item.variant, []).append(item)
    return {row: {variant: Cell(items) for variant, items in cells.items()}
            for row, cells in collected.items()}


def faults(mutants):
    """{mutation: caught by at least one check}."""
    caught = {}
    for item in mutants:
        caught[item.mutation] = caught.get(item.mutation, False) or item.caught
    return caught


def _many(amount, one, many=None):
    return f"{amount} {one if amount == 1 else many or one + 's'}"


def headline(report):
    """The whole report in one sentence."""
    tally, caught = count(report.verdicts), faults(report.mutants)
    limits = tally["expected-fail"] + tally["unexpected-pass"]
    verb = "holds" if tally["pass"] == 1 else "hold"
    parts = [f"{tally['pass']} of {_many(len(report.verdicts) - limits, 'check')} {verb}"]
    if tally["fail"]:
        parts.append(_many(tally["fail"], "fails", "fail"))
    if tally["inconclusive"]:
        parts.append(f"{tally['inconclusive']} inconclusive")
    if tally["expected-fail"]:
        parts.append(_many(tally["expected-fail"], "known limit") + " confirmed")
    if tally["unexpected-pass"]:
        parts.append(_many(tally["unexpected-pass"], "known limit") + " not seen")
    if caught:
        parts.append(f"{sum(caught.values())} of {_many(len(caught), 'planted fault')} caught")
    return "; ".join(parts)


def quantities(sweeps):
    """Sweeps that share a picture of error against cost: {(case, quantity): [(index, sweep)]}."""
    groups = {}
    for index, sweep in enumerate(sweeps):
        groups.setdefault((sweep.case, sweep.quantity), []).append((index, sweep))
    return groups


def total(numbers):
    """Sum of what is known."""
    return sum(item for item in numbers if item is not None)


def provenance(report):
    """{key: distinct values over all runs}, so that a folder made by two programs shows it."""
    collected = {}
    for case in report.cases:
        for run in case.runs:
            for key, value in run.provenance.items():
                if not value:
                    continue
                collected.setdefault(key, {})[value] = None
    distinct = {key: list(values) for key, values in collected.items()}
    if len(distinct.get("created", [])) > 1:
        distinct["created"] = [f"{min(distinct['created'])} to {max(distinct['created'])}"]
    return distinct
