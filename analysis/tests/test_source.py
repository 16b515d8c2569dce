"""Figures of a source: the list is whole, what can be drawn is drawn, what cannot says why."""

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from analysis.errors import InputError
from analysis.load import load_report
from analysis.source import correlations, heap, pipe, runs
from analysis.source.build import source_figures
from analysis.source.catalogue import DRAWINGS, catalogue
from analysis.tests.test_comparison import series, write_run
from analysis.tests.test_grid import row, write

SCENE = '[domain]\nsize = [20.0, 20.0]\n[[species]]\ncount = 50\nrestitution = 0.8\n[method]\nweight = 2.0\n'


def report_of(folder, case, point, variants):
    """A report whose runs of one case are those of the clustering gas."""
    import json
    write(folder, *(row("check", case=case, variant=variant, point=point) for variant in variants))
    path = folder / "evidence" / f"{case}.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    for run in content["runs"]:
        run |= {"record": f"records/{run['variant']}.h5", "scene": SCENE}
        write_run(folder / run["record"], run["variant"] == "event-driven")
    path.write_text(json.dumps(content), encoding="utf-8")
    return load_report(folder)


def gas_with_pairs(folder):
    """One run of the gas of figure 3.40: T/m is 0.04 at the end, g = 2.5, G_par = 0.02, G_perp = 0.01."""
    import h5py
    path = folder / "records" / "gas.h5"
    write_run(path, True)
    with h5py.File(path, "a") as file:
        root = file["sandglass"]
        for name in ("energy", "pair-correlation"):
            del root[f"series/{name}"]
        series(root, "energy", np.array([50.0, 10.0, 5.0, 2.0]))
        for name, value in (("pair-correlation", 2.5), ("pair-velocity-parallel", 0.02), ("pair-velocity-transverse", 0.01)):
            series(root, name, np.full((4, 5), value), np.arange(6))
    scene = SCENE.replace("count = 50\nrestitution = 0.8", "count = 50\narea-fraction = 0.05\nrestitution = 0.85")
    run = SimpleNamespace(variant="event-driven", point="dilute", scene=scene, record="records/gas.h5")
    return runs.CaseRuns(SimpleNamespace(runs=[run], evidence=[]), folder)


def test_every_figure_is_listed_once_and_drawn_or_explained():
    figures = catalogue("MUL").figures
    assert [item.number for item in figures] == [f"3.{number}" for number in range(2, 45)]
    assert {item.number for item in figures if item.case} == DRAWINGS["MUL"].keys()


def test_the_page_of_the_documentation_names_what_is_missing():
    text = (Path(__file__).parent.parent.parent / "docs" / "report.md").read_text(encoding="utf-8")
    for item in catalogue("MUL").figures:
        if item.missing:
            assert re.search(rf"\b{re.escape(item.number)}[,:]", text), item.number


def test_ours_stands_beside_the_words_of_the_source(tmp_path):
    report = report_of(tmp_path, "clustering", "large", ("event-driven", "cba"))
    page, drawn = source_figures("MUL", report, tmp_path)
    shown = {item.figure.number for item in drawn if item.picture}
    assert shown == {"3.6", "3.7", "3.9", "3.10"}
    for number in shown:
        assert (tmp_path / "figures" / f"source-MUL-{number}.png").stat().st_size > 5000
    text = page.read_text(encoding="utf-8")
    assert "leaves Haff&#39;s law at t/t0 = 2" in text and "figures/source-MUL-3.6.svg" in text
    assert "the case &#39;heap&#39; is not in this report" in text and "a sketch" in text


def test_what_a_report_lacks_is_said(tmp_path):
    report = report_of(tmp_path, "heap", "plane", ("hsmc",))
    _, drawn = source_figures("MUL", report, tmp_path)
    reasons = {item.figure.number: item.lacking for item in drawn}
    assert reasons["3.24"] == "no heap of hsmc on a plane" or "free-surface" in reasons["3.24"]
    assert "two" in reasons["3.27"] and "one boundary" in reasons["3.31"]


def test_an_unknown_source_and_a_foreign_report_are_refused(tmp_path):
    report = report_of(tmp_path, "gas", "large", ("hsmc",))
    with pytest.raises(InputError, match="no figures of a source 'XYZ'"):
        source_figures("XYZ", report, tmp_path)
    with pytest.raises(InputError, match="no case that draws"):
        source_figures("MUL", report, tmp_path)


def test_the_fraction_counts_real_particles():
    assert runs.Kept("dsmc", "", SCENE, None).fraction == pytest.approx(100 * np.pi / 4 / 400)
    given = SCENE.replace("count = 50", "area-fraction = 0.3")
    assert runs.Kept("dsmc", "", given, None).fraction == 0.3


def test_pairs_of_a_cooling_gas_are_drawn_over_the_temperature(tmp_path):
    case = gas_with_pairs(tmp_path)
    distance, found = correlations.pairs(case.choose()[0])
    assert distance[0] == 0.5 and [mean[0] for mean, _ in found.values()] == pytest.approx([1.5, 0.5, 0.25])
    correlations.FIGURES["3.40"](case, tmp_path / "pairs")
    assert (tmp_path / "pairs.png").stat().st_size > 5000
    with pytest.raises(runs.Lacking, match="no gas with nu = 0.245"):
        correlations.FIGURES["3.41"](case, tmp_path / "absent")


@pytest.mark.parametrize("slope, tail", [(0.4, 3.0), (0.3, 0.0)])
def test_the_tail_is_found_in_an_exact_shape(slope, tail):
    height = np.geomspace(0.6, 19.9, 60)
    x = (20 - height) / slope + tail * np.log(20 / height)
    found = heap.fit_tail(np.concatenate([-x, x]), np.concatenate([height, height]))
    assert found == pytest.approx((20, slope, tail), rel=0.05, abs=0.01 * 20)   # two steps of the range of h_m


def test_an_error_needs_two_replicas():
    assert runs.mean_error([[1.0, 2.0]])[1].tolist() == [0, 0]
    mean, error = runs.mean_error([[1.0], [3.0]])
    assert (mean[0], error[0]) == (2, pytest.approx(1))
    with pytest.raises(runs.Lacking, match="0 of 1 runs of hsmc"):
        runs.CaseRuns(SimpleNamespace(runs=[]), None).choose("*", "hsmc")


class Pipe:
    """A run with `rate` passages down and one up per unit of time in one replica, twice as many in the other."""

    def __init__(self, restitution, length, rate=0.0):
        self.species = {"restitution": restitution}
        self.scene = {"domain": {"size": [20.0, length]}}
        time = np.arange(0, 11.0)
        passed = np.stack([time, time * (rate + 1)], axis=1)
        self.found = [SimpleNamespace(time=time, value=factor * passed) for factor in (1, 2)]

    def series(self, name):
        assert name == "crossing-count"
        return self.found


def test_the_flow_of_a_pipe_is_what_passes_a_plane():
    rate, error = pipe._flow_rate(Pipe(0, 200.0, rate=40.0))
    assert (rate, error) == pytest.approx((1.5 * 2 * np.pi / 4, 0.5 * 2 * np.pi / 4))


def test_of_pipes_alike_one_is_chosen_by_length():
    runs = [Pipe(0.99, 200.0), Pipe(0, 1000.0), Pipe(0, 200.0)]
    assert pipe._by_restitution(runs, pipe._length) == [runs[0], runs[2]]
    assert pipe._by_restitution(runs, lambda run: -pipe._length(run)) == [runs[0], runs[1]]
