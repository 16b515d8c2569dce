"""A report against an earlier one: verdicts that changed, values that moved, what a run costs now."""

import math
from collections import defaultdict

MOVED = 4.0      # standard errors of the difference
COST = 1.25      # ratio of CPU seconds, either way, of a case and variant that is worth a line
SHORTEST = 1.0   # CPU seconds below which a ratio says nothing


def _name(key):
    return " / ".join(key)


def _spread(one, other):
    return math.hypot(one.stderr or 0, other.stderr or 0)


def changed_verdicts(now, before):
    """Lines "before -> now  case / variant / point / check", checks that came and went included."""
    words = {key: (before[key].verdict if key in before else "absent", now[key].verdict if key in now else "absent")
             for key in now | before}
    return [f"{old} -> {new}  {_name(key)}" for key, (old, new) in sorted(words.items()) if old != new]


def moved_values(now, before):
    """Lines of the values that differ by more than chance, the farthest first. Exact ones may not differ at all."""
    moves = []
    for key in now.keys() & before.keys():
        new, old = now[key], before[key]
        if new.value is None or old.value is None or new.value == old.value:
            continue
        spread = _spread(new, old)
        distance = abs(new.value - old.value) / spread if spread else math.inf
        if distance > MOVED:
            far = f"{distance:.1f} standard errors" if spread else "no error bar"
            moves.append((-distance, f"{old.value:.6g} -> {new.value:.6g} {new.units}  {far}  {_name(key)}"))
    return [line for _, line in sorted(moves)]


def _costs(verdicts):
    """CPU seconds of each case and variant, each run once."""
    runs = {verdict.run: verdict.cpu_seconds or 0 for verdict in verdicts.values()}
    costs = defaultdict(float)
    for (case, variant, _), seconds in runs.items():
        costs[case, variant] += seconds
    return costs


def cost_ratios(now, before):
    """A line for all runs that both reports hold, then one for each case and variant that costs another amount now."""
    common = {verdict.run for verdict in now.values()} & {verdict.run for verdict in before.values()}
    kept = [{key: verdict for key, verdict in report.items() if verdict.run in common} for report in (now, before)]
    new, old = (_costs(verdicts) for verdicts in kept)
    total = [sum(costs.values()) for costs in (new, old)]
    lines = [f"{total[0] / total[1]:.2f} x  all runs of both: {total[1]:.1f} -> {total[0]:.1f} CPU s"] if total[1] else []
    ratios = [(new[key] / old[key], key) for key in new if min(new[key], old[key]) > SHORTEST]
    for ratio, key in sorted(ratios, reverse=True):
        if ratio > COST or ratio < 1 / COST:
            lines.append(f"{ratio:.2f} x  {_name(key)}: {old[key]:.1f} -> {new[key]:.1f} CPU s")
    return lines


def compare(now, before):
    """The text of a comparison. `now`, `before`: verdicts by their key, as analysis.load.load_verdicts reads them."""
    parts = [("verdicts that changed", changed_verdicts(now, before)), ("values that moved", moved_values(now, before)),
             ("costs", cost_ratios(now, before))]
    text = [f"{len(now)} checks, {len(before)} in the earlier report"]
    for title, lines in parts:
        text.append(f"{title}:" if lines else f"{title}: none")
        text += [f"  {line}" for line in lines]
    return "\n".join(text)
