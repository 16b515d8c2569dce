"""Evidence as a picture: theory as a line, data with error bars, residuals below."""

import numpy as np

from analysis.plotting import COLOURS, MARKERS, axis_label, headed, literal, pyplot, save, wrapped
from analysis.words import VERDICTS, labelled, units

SIZE = (4.4, 3.7)           # inches: one to one on a phone, three beside each other on a laptop
RESIDUAL_SIZE = (4.4, 4.4)
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


def _scale(panel, figure):
    panel.set_xscale("log" if figure.x.logarithmic else "linear")
    panel.set_yscale("log" if figure.y.logarithmic else "linear")


def _marks(index):
    return {"fmt": MARKERS[index % len(MARKERS)], "color": COLOURS[index % len(COLOURS)],
            "markerfacecolor": "white", "capsize": 2, "elinewidth": 1}


def _data(panel, figure):
    for index, line in enumerate(figure.lines):
        style = ["-", "--", ":", "-."][index % 4]
        panel.plot(line.x, line.y, style, color="#333333", label=wrapped(line.name, 34), zorder=3)
    for index, points in enumerate(figure.points):
        if not np.isfinite(points.y).any():
            continue
        panel.errorbar(points.x, points.y, yerr=_errors(points.error), label=wrapped(points.name, 34),
                       zorder=4, **_marks(index))


def _errors(error):
    """Error bars as matplotlib takes them: an unknown error has no bar."""
    return np.nan_to_num(np.array(error, float)) if len(error) else None


def _residuals(panel, figure, sets, verdict):
    labels = []
    for index, points in sets:
        values, errors, label = residual(points, figure.y, verdict)
        panel.errorbar(points.x, values, yerr=_errors([] if errors is None else errors),
                       **_marks(index))
        labels.append(label)
    panel.axhline(0, color="#333333", linewidth=1)
    limit = {STANDARD: 2, BUDGET: 1}.get(labels[0])
    if limit:
        panel.axhspan(-limit, limit, color="#999999", alpha=0.18, linewidth=0)
    panel.set_ylabel(literal(labels[0]))


def _legend(panel, figure):
    if panel.get_legend_handles_labels()[0]:
        panel.legend(loc="best")
    if not any(np.isfinite(points.y).any() for points in figure.points):
        panel.text(0.5, 0.5, "no finite data", transform=panel.transAxes, ha="center", color="#777777")


def _title(picture, figure, verdict):
    look = VERDICTS[verdict.verdict]
    title = wrapped(figure.title, 48)
    headed(picture, title)
    below = f"{look.symbol} {look.word}  ·  {verdict.variant}  ·  {verdict.point}"
    picture.text(0.025, 0.93 - 0.042 * title.count("\n"), wrapped(below, 64, 1), ha="left", va="top",
                 fontsize=9, bbox={"facecolor": look.colour, "alpha": 0.2, "linewidth": 0, "pad": 2})


def draw_evidence(figure, verdict, stem):
    """Saves one figure of evidence as <stem>.svg and <stem>.png."""
    sets = [(index, points) for index, points in enumerate(figure.points) if points.expected and points.x]
    picture = pyplot.figure(figsize=RESIDUAL_SIZE if sets else SIZE)
    grid = picture.add_gridspec(2 if sets else 1, 1, height_ratios=[2.6, 1] if sets else [1], hspace=0.08,
                                left=0.19, right=0.97, top=0.86, bottom=0.125)
    main = picture.add_subplot(grid[0])
    _scale(main, figure)
    _data(main, figure)
    _legend(main, figure)
    main.set_ylabel(axis_label(figure.y.label, figure.y.units, 34))
    lowest = main
    if sets:
        lowest = picture.add_subplot(grid[1], sharex=main)
        main.tick_params(labelbottom=False)
        _residuals(lowest, figure, sets, verdict)
    lowest.set_xlabel(wrapped(labelled(figure.x.label, figure.x.units), 48, 1))
    picture.align_ylabels()
    _title(picture, figure, verdict)
    save(picture, stem)
