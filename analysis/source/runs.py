"""The runs of one case as the drawings of source figures choose and read them."""

import tomllib
from dataclasses import dataclass
from fnmatch import fnmatch
from functools import cached_property
from pathlib import Path

import numpy as np

from analysis.model import Case
from analysis.record import load_record


class Lacking(Exception):
    """The report does not hold what the figure needs; the text says what."""


@dataclass(frozen=True)
class Kept:
    """One run whose record is there."""

    variant: str
    point: str
    text: str     # its scene
    path: Path

    @cached_property
    def scene(self):
        return tomllib.loads(self.text)

    @cached_property
    def record(self):
        return load_record(self.path)

    @property
    def species(self):
        return self.scene["species"][0]

    @property
    def fraction(self):
        """Area or volume fraction of the real particles."""
        species, size = self.species, self.scene["domain"]["size"]
        named = next((species[name] for name in ("area-fraction", "volume-fraction") if name in species), None)
        if named is not None:
            return named
        share = np.pi / 4 if len(size) == 2 else np.pi / 6
        weight = self.scene["method"].get("weight", 1.0)
        number = species["count"] * weight if "count" in species else species.get("number-density", np.nan) * np.prod(size)
        return float(number * share * species.get("diameter", 1.0) ** len(size) / np.prod(size))

    def series(self, name):
        """The replicas of a quantity. Throws Lacking."""
        if name not in self.record.series:
            raise Lacking(f"{self.variant} at {self.point} has no series '{name}'")
        return self.record.series[name]

    def mean(self, name, sample):
        """(mean over replicas of one sample, its standard error)"""
        return mean_error([item.value[sample] for item in self.series(name)])


def mean_error(values):
    """Mean of independent arrays and its standard error; zero for a single one."""
    values = np.array(values, float)
    error = values.std(axis=0, ddof=1) / len(values) ** 0.5 if len(values) > 1 else 0 * values[0]
    return values.mean(axis=0), error


@dataclass(frozen=True)
class CaseRuns:
    case: Case
    folder: Path

    def choose(self, points="*", variants="*", needs=1):
        """Kept runs whose names match. Throws Lacking when they are fewer than `needs`."""
        found = [Kept(run.variant, run.point, run.scene, self.folder / run.record) for run in self.case.runs
                 if fnmatch(run.point, points) and fnmatch(run.variant, variants)
                 and run.record and (self.folder / run.record).is_file()]
        if len(found) < needs:
            what = f"{variants} at {points}".replace("* at ", "")
            raise Lacking(f"{len(found)} of {needs} runs of {what} with a record in this report")
        return found

    def by_point(self, points="*", variants="*", needs=1):
        """{point: [runs]}. Throws Lacking."""
        groups = {}
        for run in self.choose(points, variants, needs):
            groups.setdefault(run.point, []).append(run)
        return groups

    def verdicts(self, check, points="*"):
        """[(run, verdict)] of one check."""
        kept = {(run.variant, run.point): run for run in self.choose(points)}
        return [(kept[item.verdict.variant, item.verdict.point], item.verdict) for item in self.case.evidence
                if item.verdict.check == check and (item.verdict.variant, item.verdict.point) in kept]
