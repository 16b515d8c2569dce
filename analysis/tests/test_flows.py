"""The table of methods against flows: what a cell says of verdicts, costs and the source."""

import itertools
import re
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from analysis import flows, flows_figure
from analysis.cost import relative_costs
from analysis.errors import InputError
from analysis.flows import Flow, flow_table, standing
from analysis.grid import Fold
from analysis.load import load_report
from analysis.model import Run
from analysis.tests.test_grid import row, write

TOP = Path(__file__).parent.parent.parent
ANY = Flow("any", "gas", [], [], {}, {})


def fold(folder, *rows):
    report = load_report(write(folder, *rows))
    return Fold(report.verdicts)


@pytest.mark.parametrize("verdicts, word", [
    (["pass", "pass"], "suits"), (["pass", "expected-fail"], "limits"), (["expected-fail"] * 2, "unsuited"),
    (["pass", "fail"], "fails"), (["pass", "inconclusive"], "undecided"), (["pass", "unexpected-pass"], "undecided")])
def test_a_cell_sums_up_its_verdicts(tmp_path, verdicts, word):
    cell = fold(tmp_path, *(row(f"check-{index}", each) for index, each in enumerate(verdicts)))
    assert standing(ANY, cell) == (word, verdicts.count("pass"), 2)


def test_only_the_checks_that_decide_count_but_any_failure_shows(tmp_path):
    flow = replace(ANY, decide=["height"])
    limit = [row("height", "expected-fail"), row("momentum")]
    assert standing(flow, fold(tmp_path, *limit)) == ("unsuited", 0, 1)
    assert standing(flow, fold(tmp_path, *limit, row("energy", "fail", 2)))[0] == "fails"
    assert standing(flow, fold(tmp_path, row("momentum"))) == ("suits", 1, 1)


def test_a_pass_that_shows_a_departure_is_a_limit(tmp_path):
    cell = fold(tmp_path, row("energy-below"), row("momentum"))
    assert standing(replace(ANY, depart=["energy-below"]), cell) == ("limits", 1, 2)


def run(variant, cpu, work=1e6, point="2d", duration="time = 10.0", replicas=1):
    scene = f"[run]\nreplicas = {replicas}\nduration = {{ {duration} }}\n"
    return Run(variant, point, 1, scene, "", cpu, cpu, 0, work, "particle-moves", {}, {})


def test_methods_with_steps_cost_by_the_step():
    costs = relative_costs([run("dsmc", 1), run("cba", 3, 2e6), run("cba", 100, 1e6, "elsewhere")], "dsmc", set())
    assert costs == pytest.approx({"dsmc": 1, "cba": 1.5})
    assert relative_costs([run("dsmc", 1), run("cba", 3, 2e6, "elsewhere")], "dsmc", set())["cba"] == 1.5


def test_methods_by_event_cost_by_the_simulated_time():
    exact = run("exact", 8, replicas=4)
    assert relative_costs([run("dsmc", 1), exact], "dsmc", {"exact"})["exact"] == pytest.approx(2)
    through = [run("dsmc", 1, point="rest"), run("cba", 2, point="rest"), run("cba", 3), exact]
    assert relative_costs(through, "dsmc", {"exact"})["exact"] == pytest.approx(2 * 2 / 3)
    other = run("exact", 8, duration="steps = 10")
    assert "exact" not in relative_costs([run("dsmc", 1), other], "dsmc", {"exact"})


def test_without_plain_dsmc_there_is_no_cost():
    assert relative_costs([run("cba", 1)], "dsmc", set()) == {}
    assert relative_costs([run("dsmc", 1), run("cba", None)], "dsmc", set())["cba"] is None


def table_of(folder, *rows):
    return flow_table(load_report(write(folder, *rows)))


def test_a_variant_may_stand_for_a_method(tmp_path):
    table = table_of(tmp_path, row("haff", case="clustering", variant="dsmc-enskog"))
    assert table.cells["dsmc", "clustering"].variant == "dsmc-enskog"
    assert table.cells["dsmc", "clustering"].standing == "suits"
    assert [method.name for method in table.others] == ["dsmc-enskog"]


def test_what_is_not_run_says_why(tmp_path):
    table = table_of(tmp_path, row("rate", case="correlations", variant="hsmc-pb"))
    assert table.cells["hsmc-pb", "heap"].standing == "not made for it"
    assert table.cells["soft-spheres", "heap"].standing == "planned"
    assert table.cells["cba", "heap"].standing == "not run"
    assert table.cells["soft-spheres", "heap"].says.standing == "suits"


def test_a_wrong_word_of_the_source_is_named(tmp_path):
    path = tmp_path / "flows.toml"
    path.write_text(flows.TABLE.read_text(encoding="utf-8").replace('dsmc = ["suits"', 'dsmc = ["perhaps"', 1))
    with pytest.raises(InputError, match="perhaps"):
        flow_table(load_report(write(tmp_path, row("rate"))), path)


def test_the_file_names_cases_and_checks_that_exist():
    cases = {path.parent.name: path.read_text(encoding="utf-8") for path in TOP.glob("validation/case/*/*/case.toml")}
    for flow in tomllib.loads(flows.TABLE.read_text(encoding="utf-8"))["flow"]:
        for check in flow.get("decide", []) + flow.get("depart", []):
            assert f'"{check}"' in cases[flow["case"]], f"{flow['name']}: {check}"
        for variant in flow.get("as", {}).values():
            assert f'"{variant}"' in cases[flow["case"]]


def test_the_page_shows_ours_beside_the_source(tmp_path):
    from analysis.build import build
    report = load_report(write(tmp_path, row("heap-slope", "expected-fail", 3, case="heap", variant="dsmc")))
    build(report, tmp_path)
    page = (tmp_path / "flows.html").read_text(encoding="utf-8")
    assert re.search(r'<td class="unsuited" data-label="heap">\s*<a href="index.html#cell--heap--dsmc">', page)
    assert "the classical method: treats static friction" in page
    assert (tmp_path / "figures" / "flows.png").stat().st_size > 5000


def test_no_text_of_the_picture_covers_another(monkeypatch, tmp_path):
    found = []

    def look(picture, _):
        renderer = picture.canvas.get_renderer()
        found.extend((item.get_text(), item.get_window_extent(renderer)) for item in picture.axes[0].texts)

    monkeypatch.setattr(flows_figure, "save", look)
    names = [flow["case"] for flow in tomllib.loads(flows.TABLE.read_text(encoding="utf-8"))["flow"]]
    rows = [row(f"check-{count}", case=name, variant="event-driven") for name in names for count in range(100)]
    flows_figure.draw_flows(flow_table(load_report(write(tmp_path, *rows))), None)
    for (first, one), (second, other) in itertools.combinations(found, 2):
        assert not one.overlaps(other), f"{first} covers {second}"
