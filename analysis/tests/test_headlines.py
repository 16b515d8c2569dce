"""The pictures of the front page: what they need, and what they leave out."""

from types import SimpleNamespace

from analysis import headlines
from analysis.load import load_report
from analysis.model import Points


def gas(x, y, variant="dsmc"):
    return SimpleNamespace(variant=variant, expected=2.0), Points("", x, y, [], [])


def test_decades_are_whole_and_counted_from_the_start():
    assert headlines.decades([gas([0, 1], [1.0, 2e-3]), gas([0, 1], [1.0, 1.05e-5])]) == 5
    assert headlines.decades([gas([0], [float("nan")])]) == 0


def test_a_run_of_one_sample_draws_nothing(tmp_path):
    runs = [gas([0.0], [1.0]), gas([0.0, 1.0, 20.0], [1.0, 0.44, 0.008], "cba")]
    headlines.draw_cooling(runs, tmp_path / "cooling")
    assert (tmp_path / "cooling.svg").stat().st_size > 5000


def test_a_report_shows_what_it_has(folder):
    shown, jobs = headlines.plan(load_report(folder), folder, folder / "figures")
    assert [item.name for item in shown] == ["headline.frontier"] and len(jobs) == 1
    (folder / "sweeps.json").unlink()
    assert headlines.plan(load_report(folder), folder, folder / "figures") == ([], [])
