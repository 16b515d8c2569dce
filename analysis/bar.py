"""The error budget as a stacked bar with the deviation as a mark on the same scale."""

from dataclasses import dataclass

PARTS = ("statistical", "reference", "systematic")
REACH = 3.0   # a deviation beyond this many budgets is drawn at the end of the bar


@dataclass(frozen=True)
class Bar:
    """Per cent of the bar's width."""

    segments: list[tuple[str, float]]
    mark: float
    beyond: bool


def budget_bar(verdict):
    """None where budget or deviation is unknown.

    Statistical and reference part add in quadrature, so each segment shows its share of the plain sum.
    """
    share, parts = verdict.share, verdict.budget_parts
    sizes = [(name, getattr(parts, name) or 0.0) for name in PARTS]
    whole = sum(value for _, value in sizes)
    if share is None or whole <= 0:
        return None
    scale = 100 / max(1.15, min(share, REACH) * 1.05)
    segments = [(name, scale * value / whole) for name, value in sizes if value > 0]
    return Bar(segments, scale * min(share, REACH), share > REACH)
