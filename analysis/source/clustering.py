"""Figures 3.6 to 3.10: clustering, and the impact parameters of small gases."""

import numpy as np

from analysis import clustering_figures as clustering
from analysis.source.panels import BLACK, finish, panels, shade
from analysis.source.runs import Lacking


def _largest(case, needs):
    """{variant: run} at the point with most particles that holds what the drawing needs."""
    import h5py
    groups = {}
    for point, runs in case.by_point().items():
        holding = {}
        for run in runs:
            with h5py.File(run.path, "r") as file:
                if all(name in file for name in needs):
                    holding[run.variant] = run
        if holding:
            groups[point] = holding
    if not groups:
        raise Lacking(f"no record holds {', '.join(needs)}")
    return max(groups.values(), key=lambda runs: next(iter(runs.values())).species["count"])


def _as_on_the_case_page(name):
    """The drawing of the case page, from the largest gas of the report."""
    picture = next(item for item in clustering.PICTURES if item.name == name)

    def draw(case, stem):
        runs = _largest(case, picture.needs)
        picture.draw({variant: picture.load(run.path) for variant, run in runs.items()}, stem)
    return draw


def _shares(run):
    """P(b/d) of all contacts of a run."""
    series = run.series("impact-parameter")
    counts = sum(item.value.sum(axis=0) for item in series)
    return np.array(series[0].quantity.axis), counts / counts.mean()


def draw_small(case, stem):
    elastic = sorted(case.choose("*-r-1*"), key=lambda run: run.fraction)
    dense = sorted(case.choose("nu-0.7495-*"), key=lambda run: -run.species["restitution"])
    picture, [row] = panels(2)
    for panel, runs, name, title in ((row[0], elastic, "area fraction {0.fraction:.3g}", "r = 1"),
                                     (row[1], dense, "r = {0.species[restitution]:g}", "area fraction 0.75")):
        for index, run in enumerate(runs):
            edges, share = _shares(run)
            panel.stairs(share, edges, baseline=None, linewidth=1.8, color=shade(index, len(runs)),
                         label=name.format(run))
        panel.axhline(1, linestyle=":", color=BLACK)
        panel.set(xlabel="impact parameter b / d", ylim=(0.7, None), title=title)
        panel.legend(loc="upper left")
    top = max(panel.get_ylim()[1] for panel in row)
    for panel in row:
        panel.set_ylim(top=top)
    row[0].set_ylabel("P(b/d)")
    finish(picture, "3.8", "Elastic gases have even impact parameters, dissipation makes them grazing", stem)


FIGURES = {"3.6": _as_on_the_case_page("energy"), "3.7": _as_on_the_case_page("impact"), "3.8": draw_small,
           "3.9": _as_on_the_case_page("frames"), "3.10": _as_on_the_case_page("structure")}
