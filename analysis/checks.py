"""The checks of a case as its page shows them: what holds to rounding in one line, a picture for each of the rest."""

import os
import re
from dataclasses import dataclass

from analysis.model import Evidence
from analysis.words import GOOD, worst

SHORTEST = 15     # letters of a sentence that says something
ROUNDING = 1e-9   # what an exact identity may leave, in its own units


@dataclass(frozen=True)
class CheckGroup:
    """One check of a case at all points and by all methods."""

    check: str
    evidence: list[Evidence]

    @property
    def verdicts(self):
        return [item.verdict for item in self.evidence]

    @property
    def verdict(self):
        return worst(item.verdict for item in self.verdicts)

    @property
    def variants(self):
        return list(dict.fromkeys(item.variant for item in self.verdicts))

    @property
    def points(self):
        return list(dict.fromkeys(item.point for item in self.verdicts))

    @property
    def summary(self):
        """What the runs say alike: some add numbers of their own behind it."""
        texts = [item.summary for item in self.verdicts]
        shared = os.path.commonprefix(texts)
        if shared in texts:
            return shared
        whole = re.split(r"[;(]", shared)[0].strip(" ,")
        return whole if len(whole) >= SHORTEST else texts[0]

    @property
    def is_identity(self):
        """Nothing is left but rounding, nothing statistical is in it, and there is nothing to see."""
        return not any(item.figures for item in self.evidence) and all(map(_is_rounding, self.verdicts))

    @property
    def largest(self):
        return max(self.verdicts, key=lambda item: abs(item.value or 0))


def _is_rounding(item):
    exact = item.verdict in GOOD and not item.stderr and item.kind in ("equal", "at-most")
    return exact and item.value is not None and abs(item.value) < ROUNDING and (item.expected or 0) <= ROUNDING


def check_groups(case):
    """Checks in the order of the case."""
    found = {}
    for item in case.evidence:
        found.setdefault(item.verdict.check, []).append(item)
    return [CheckGroup(name, items) for name, items in found.items()]


def split(case):
    """(checks that get a picture, exact identities)"""
    groups = check_groups(case)
    return [item for item in groups if not item.is_identity], [item for item in groups if item.is_identity]
