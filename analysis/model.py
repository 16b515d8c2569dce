"""What a report folder holds, as plain values. A number that nobody knows is None, in arrays NaN."""

import math
from dataclasses import dataclass, field

Number = float | None


@dataclass(frozen=True)
class Budget:
    """What a value may differ from its expectation by; absolute, in the units of the value."""

    statistical: Number
    reference: Number
    systematic: Number
    reason: str
    resolution: Number


@dataclass(frozen=True)
class Verdict:
    """One row of verdicts.json: what the judge said about one check of one run."""

    case: str
    variant: str
    point: str
    check: str
    claim: str
    summary: str
    units: str
    verdict: str
    reason: str
    value: Number
    stderr: Number
    expected: Number
    deviation: Number
    budget: Number
    budget_parts: Budget
    cpu_seconds: Number
    work: Number
    work_units: str
    peak_bytes: Number
    seed: int
    tier: str
    kind: str = "equal"      # what the expectation says of the value: a key of words.EXPECTATIONS
    upper: Number = None     # where the value lies between `expected` and this
    known_limit: str = ""    # why the case expects this check to fail

    @property
    def key(self):
        return self.case, self.variant, self.point, self.check

    @property
    def run(self):
        return self.case, self.variant, self.point

    @property
    def claims(self):
        return self.claim.replace(",", " ").split()

    @property
    def share(self):
        """Deviation in units of the budget; None when either is unknown.

        A budget of zero demands the exact value, except where the judge had no budget to give.
        """
        if self.deviation is None or self.budget is None:
            return None
        if self.budget:
            return self.deviation / self.budget
        if self.verdict == "inconclusive":
            return None
        return math.inf if self.deviation else 0.0


@dataclass(frozen=True)
class Axis:
    label: str
    units: str
    logarithmic: bool


@dataclass(frozen=True)
class Points:
    """Data; `error` (one standard error) and `expected` have the length of `x` or none."""

    name: str
    x: list[float]
    y: list[float]
    error: list[float]
    expected: list[float]


@dataclass(frozen=True)
class Line:
    name: str
    x: list[float]
    y: list[float]


@dataclass(frozen=True)
class Figure:
    title: str
    x: Axis
    y: Axis
    points: list[Points]
    lines: list[Line]


@dataclass(frozen=True)
class Evidence:
    verdict: Verdict
    law: str
    figures: list[Figure]


@dataclass(frozen=True)
class Equation:
    tex: str
    text: str
    citation: str


@dataclass(frozen=True)
class Run:
    variant: str
    point: str
    seed: int
    scene: str
    record: str
    cpu_seconds: Number
    wall_seconds: Number
    peak_bytes: Number
    work: Number
    work_units: str
    counters: dict[str, Number]
    provenance: dict[str, str]


@dataclass(frozen=True)
class Case:
    name: str
    topic: str
    summary: str
    question: str
    claims: list[str]
    equations: list[Equation]
    readme: str
    runs: list[Run]
    evidence: list[Evidence]


@dataclass(frozen=True)
class SweepPoint:
    knob: Number
    value: Number
    stderr: Number
    error: Number
    cpu_seconds: Number
    work: Number


@dataclass(frozen=True)
class Sweep:
    """Error against cost as one knob of the method is turned."""

    case: str
    variant: str
    knob: str
    knob_label: str
    quantity: str
    units: str
    reference: Number
    reference_error: Number
    reference_source: str
    expected_order: Number
    points: list[SweepPoint]
    order: Number
    order_stderr: Number
    order_reason: str


@dataclass(frozen=True)
class Mutant:
    """A planted fault, seen through one check."""

    mutation: str
    summary: str
    case: str
    variant: str
    point: str
    check: str
    verdict: str
    caught: bool
    value: Number
    expected: Number
    budget: Number


@dataclass(frozen=True)
class KeyTrial:
    """A run in which the method got a key wired wrongly."""

    case: str
    variant: str
    point: str
    how: str
    check: str   # whose verdict then blocks; empty: none


@dataclass(frozen=True)
class Key:
    """A key of scenes and what became of the verdicts when it was wired wrongly."""

    key: str
    family: str   # of methods; empty where no case has the key
    used: bool    # some run says more than the default
    seen: bool
    trials: list[KeyTrial]


@dataclass(frozen=True)
class Claim:
    """A row of the ledger; its status is changed by hand, after a verdict."""

    id: str
    text: str
    source: str
    status: str
    evidence: tuple[str, ...] = ()   # cases that decide it, or will
    note: str = ""                   # what was seen


@dataclass(frozen=True)
class Report:
    verdicts: list[Verdict]
    cases: list[Case]
    sweeps: list[Sweep] = field(default_factory=list)
    mutants: list[Mutant] = field(default_factory=list)
    keys: list[Key] = field(default_factory=list)
    claims: list[Claim] = field(default_factory=list)
