"""How far data lie from what is expected, in the unit that the data allow."""

import numpy as np

from analysis.words import labelled, units

STANDARD, BUDGET = "residual\n/ std. error", "residual\n/ budget"


def residual(points, axis, verdict):
    """What the lower panel shows for one set: (values, their errors or None, label).

    In standard errors where the points have them; else in budgets where the judged value has the units of
    this axis; else plain.
    """
    y, error, expected = (np.array(item, float) for item in (points.y, points.error, points.expected))
    if error.size and np.any(error > 0):
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(error > 0, (y - expected) / error, np.nan), None, STANDARD
    if verdict.budget and units(verdict.units) == units(axis.units):
        return (y - expected) / verdict.budget, None, BUDGET
    return y - expected, error if error.size else None, labelled("residual", axis.units)
