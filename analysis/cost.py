"""What a method costs beside plain dsmc in the same flow."""

import math
import tomllib


def _per_step(runs):
    """CPU seconds per particle-step."""
    work = sum(run.work or 0 for run in runs)
    return sum(run.cpu_seconds or 0 for run in runs) / work if work else None


def _amount(run):
    """(what the duration counts, how much of it all replicas simulate)"""
    scene = tomllib.loads(run.scene).get("run", {})
    [(unit, much)] = scene.get("duration", {"": 0}).items()
    return unit, much * scene.get("replicas", 1)


def _per_duration(run, other):
    """Run time of the one over that of the other, for the same simulated time; None if they cannot be compared."""
    (unit, much), (other_unit, other_much) = _amount(run), _amount(other)
    times = run.cpu_seconds, other.cpu_seconds
    if unit != other_unit or not (much and other_much and all(times)):
        return None
    return times[0] / much / (times[1] / other_much)


def _mean(ratios):
    """Geometric mean of those that are known."""
    known = [math.log(ratio) for ratio in ratios if ratio]
    return math.exp(sum(known) / len(known)) if known else None


def relative_costs(runs, plain, by_event):
    """{variant: its cost for the same flow, that of `plain` being 1}, where the runs of one case tell.

    Methods that move particles in steps: CPU time per particle-step, at shared points if there are any. Those of
    `by_event` have no such step: run time for the same simulated time at shared points, beside `plain` or else
    beside another method whose cost is known.
    """
    of = {}
    for run in runs:
        of.setdefault(run.variant, {})[run.point] = run
    if plain not in of:
        return {}
    costs = {plain: 1.0}
    for variant, points in of.items():
        if variant != plain and variant not in by_event:
            shared = [point for point in points if point in of[plain]] or None
            pair = [_per_step([each[point] for point in shared or each]) for each in (points, of[plain])]
            costs[variant] = pair[0] / pair[1] if all(pair) else None
    for variant in by_event & of.keys():
        for other, cost in costs.copy().items():
            shared = of[variant].keys() & of[other].keys() if cost else ()
            ratio = _mean(_per_duration(of[variant][point], of[other][point]) for point in shared)
            if ratio:
                costs[variant] = ratio * cost
                break
    return costs
