"""What accuracy costs: the cheapest setting that meets a target, and whether an order is what theory says."""

import math
from dataclasses import dataclass

from analysis.model import Sweep, SweepPoint
from analysis.sweep_figures import RESOLVED

TARGETS = (0.1, 0.01, 0.001)
Z = 3   # standard errors between two orders that agree


@dataclass(frozen=True)
class Choice:
    """A point of a sweep that meets a target."""

    sweep: Sweep
    point: SweepPoint


def bound(sweep, point):
    """Error relative to the reference that the point does not exceed: error and two standard errors; None if unknown."""
    if point.error is None or point.stderr is None or not sweep.reference:
        return None
    return (point.error + RESOLVED * point.stderr) / abs(sweep.reference)


def cheapest(sweeps, target):
    """The choice of least CPU time whose bound meets the target; None where none does."""
    found = [Choice(sweep, point) for sweep in sweeps for point in sweep.points
             if point.cpu_seconds and (bound(sweep, point) or math.inf) <= target]
    return min(found, key=lambda choice: choice.point.cpu_seconds, default=None)


def best_bound(sweeps):
    """The smallest error that any setting is known to stay below."""
    known = [bound(sweep, point) for sweep in sweeps for point in sweep.points]
    return min((each for each in known if each is not None), default=None)


def local_order(sweep):
    """(order between the two finest resolved points, its standard error), or None."""
    clear = [point for point in sweep.points if point.knob and point.knob > 0 and point.error and point.stderr
             and point.error > RESOLVED * point.stderr]
    if len(clear) < 2 or sweep.expected_order is None:
        return None
    clear.sort(key=lambda point: point.knob * math.copysign(1, sweep.expected_order))
    first, second = clear[:2]
    span = math.log(first.knob / second.knob)
    noise = math.hypot(first.stderr / first.error, second.stderr / second.error)
    return math.log(first.error / second.error) / span, noise / abs(span)


def cheaper_when_finer(sweep):
    """Whether of any two settings the more accurate one takes less time."""
    known = sorted((point.error, point.cpu_seconds) for point in sweep.points
                   if point.error is not None and point.cpu_seconds is not None)
    return len(known) > 1 and all(one[1] < other[1] for one, other in zip(known, known[1:]))


@dataclass(frozen=True)
class OrderVerdict:
    symbol: str
    word: str
    text: str


def judge_order(sweep, with_error):
    """Whether the fitted order is the expected one; where it is not, what its finest points say."""
    if sweep.order is None or sweep.order_stderr is None or sweep.expected_order is None:
        return OrderVerdict("·", "no order", "too few points stand out of the noise")
    apart = abs(sweep.order - sweep.expected_order) / sweep.order_stderr if sweep.order_stderr else math.inf
    if apart <= Z:
        return OrderVerdict("✓", "as expected", f"{apart:.1f} standard errors from it")
    local = local_order(sweep)
    text = f"{apart:.0f} standard errors from it"
    if local is None:
        return OrderVerdict("✗", "not as expected", text)
    text += f"; between the two finest points that stand out of the noise {with_error(*local)}"
    if local[1] > abs(sweep.expected_order) / 4:
        return OrderVerdict("?", "not as expected, and too noisy at the fine end to tell why", text)
    if abs(local[0] - sweep.expected_order) <= Z * local[1]:
        return OrderVerdict("→", "as expected at the fine end", text
                            + ": the coarse points lie outside the range where one power describes the error")
    return OrderVerdict("✗", "not as expected", text + ": the range is not asymptotic, or theory misses a term")
