"""The folded matrix: one cell for each case and method variant, with counts and the worst deviation."""

from dataclasses import dataclass

from analysis.model import Verdict
from analysis.words import GOOD, VERDICTS, ratio, worst


@dataclass(frozen=True)
class Fold:
    """All checks of one variant in one case."""

    verdicts: list[Verdict]

    def count(self, *names):
        return sum(item.verdict in names for item in self.verdicts)

    @property
    def verdict(self):
        return worst(item.verdict for item in self.verdicts)

    @property
    def demanded(self):
        """Checks that must hold: all but those where the case expects a failure."""
        return len(self.verdicts) - self.count("expected-fail", "unexpected-pass")

    @property
    def worst(self):
        """The check with the largest deviation in units of its budget.

        Of the checks that decide the colour where some block; else of those that must hold, since a known limit
        is meant to exceed its budget.
        """
        for names in ((self.verdict,) if self.blocking else ("pass",), VERDICTS):
            chosen = [item for item in self.verdicts if item.verdict in names]
            if chosen:
                return max(chosen, key=lambda item: -1.0 if item.share is None else item.share)

    @property
    def blocking(self):
        return [item for item in self.verdicts if item.verdict not in GOOD]

    @property
    def cpu_seconds(self):
        """Of its runs; None when it is not known of any."""
        known = {item.point: item.cpu_seconds for item in self.verdicts if item.cpu_seconds is not None}
        return sum(known.values()) if known else None

    @property
    def points(self):
        """{point: its verdicts}, in the order of the case."""
        found = {}
        for item in self.verdicts:
            found.setdefault(item.point, []).append(item)
        return found

    @property
    def tallies(self):
        """[(verdict, text)] of the verdicts that occur, what blocks first: ("pass", "✓ 34/34")."""
        order = [name for name in reversed(VERDICTS) if name not in GOOD] + list(GOOD)
        counts = {name: str(self.count(name)) for name in order if self.count(name)}
        if "pass" in counts:
            counts["pass"] += f"/{self.demanded}"
        return [(name, f"{VERDICTS[name].symbol} {text}") for name, text in counts.items()]

    @property
    def sentence(self):
        parts = [f"{self.count('pass')} of {self.demanded} checks hold"] if self.demanded else []
        for name in VERDICTS:
            if name != "pass" and self.count(name):
                parts.append(f"{VERDICTS[name].word}: {self.count(name)}")
        deviation = f"{self.worst.check} at {self.worst.point}, {ratio(self.worst.share)} of its error budget"
        return f"{'; '.join(parts)}; largest deviation: {deviation}"


@dataclass(frozen=True)
class Grid:
    variants: list[str]
    topics: dict[str, dict[str, dict[str, Fold]]]   # topic -> case -> variant -> cell

    @property
    def folds(self):
        return [fold for cases in self.topics.values() for cells in cases.values() for fold in cells.values()]


def _columns(cases):
    """Variants that run in most cases first; equals in the order of the case that has the most variants."""
    widest = sorted(cases.values(), key=len, reverse=True)
    order = list(dict.fromkeys(variant for cells in widest for variant in cells))
    return sorted(order, key=lambda variant: -sum(variant in cells for cells in cases.values()))


def _in_order(topic):
    """Gases first, few balls last, others between in the order of the alphabet."""
    return {"kinetic-theory": 0, "granular-flow": 1, "few-body": 3}.get(topic, 2), topic


def grid(report):
    """The folded matrix of a report; rows are cases grouped by topic."""
    topics, cases = {}, {}
    for case in report.cases:
        cells = {}
        for item in case.evidence:
            cells.setdefault(item.verdict.variant, []).append(item.verdict)
        cases[case.name] = {variant: Fold(items) for variant, items in cells.items()}
        topics.setdefault(case.topic, {})[case.name] = cases[case.name]
    return Grid(_columns(cases), {topic: topics[topic] for topic in sorted(topics, key=_in_order)})
