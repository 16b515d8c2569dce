"""The smallest error of a value that its check would see, from the budget of the verdict."""

import math
from dataclasses import dataclass

from analysis.model import Verdict

SHARP = 0.03   # an error this small is seen, or the reason stands beside it


def detectable(item):
    """A value this far off fails in 49 of 50 runs: the budget and two standard errors of value and expectation.

    None where one side alone is wrong, at a known limit, and where the judge had no budget to give.
    """
    if item.kind != "equal" or item.known_limit or None in (item.budget, item.stderr, item.expected):
        return None
    parts = item.budget_parts
    coverage = parts.statistical / item.stderr if item.stderr else math.inf
    return item.budget + 2 * math.hypot(item.stderr, parts.reference / coverage)


def relative(item):
    """The same over what is expected; None where that is zero."""
    smallest = detectable(item)
    return smallest / abs(item.expected) if smallest is not None and item.expected else None


def reason(item):
    """What most of the budget is made of."""
    parts = item.budget_parts
    if parts.systematic >= max(parts.statistical, parts.reference):
        return parts.reason
    return "error of the reference" if parts.reference > parts.statistical else "length of the run"


@dataclass(frozen=True)
class Row:
    """A check of a case over its runs."""

    case: str
    check: str
    sharpest: Verdict
    widest: Verdict

    @property
    def is_sharp(self):
        return relative(self.widest) <= SHARP


def rows(verdicts):
    """One row for each case and check, the widest first. Checks that expect zero, or to rounding, have none."""
    groups = {}
    for item in verdicts:
        if relative(item) is not None:
            groups.setdefault((item.case, item.check), []).append(item)
    found = [Row(case, check, min(items, key=relative), max(items, key=relative))
             for (case, check), items in groups.items()]
    return sorted(found, key=lambda row: -relative(row.widest))
