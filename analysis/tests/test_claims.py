"""The ledger beside the verdicts: no claim without a row, no row that points nowhere."""

import re

import pytest

from analysis import claims
from analysis.load import _claims
from analysis.source.catalogue import DRAWINGS, catalogue
from analysis.tests import fixture

TOP = fixture.TOP.parent
LEDGER = _claims(TOP / "reference" / "claims.toml")
CASES = {path.name for path in TOP.glob("validation/case/*/*") if path.is_dir()}


def rows(built):
    return {row.name: row for items in claims.ledger(built[0]).values() for row in items}


def test_each_claim_has_a_row_on_the_page_of_its_source(built):
    report, folder = built
    named = {claim.id for claim in report.claims} | {name for item in report.verdicts for name in item.claims}
    assert rows(built).keys() == named
    for name in named:
        page = (folder / claims.page_name(claims.source_of(name))).read_text(encoding="utf-8")
        assert page.count(f'id="claim--{name}"') == 1, name


def test_each_row_points_to_a_check_that_is_there(built):
    report, folder = built
    for page in folder.glob("ledger-*.html"):
        for address, anchor in re.findall(r'href="(case/[^"#]+)#([^"]+)"', page.read_text(encoding="utf-8")):
            assert f'id="{anchor}"' in (folder / address).read_text(encoding="utf-8"), f"{page.name}: {address}#{anchor}"


def test_the_ledger_in_one_line_is_counted(built):
    report, folder = built
    line = "3 claims of 3 sources: 1 reproduced, 1 not reproduced, 1 not yet tested"
    assert claims.sentence(report) == line
    assert line in (folder / "index.html").read_text(encoding="utf-8")


def test_not_reproduced_beside_verdicts_that_hold_is_explained(built):
    row = rows(built)["MUL-1"]
    assert (row.claim.status, row.holding, len(row.verdicts)) == ("not reproduced", 4, 4)
    page = (built[1] / "ledger-MUL.html").read_text(encoding="utf-8")
    assert "does not hold as it stands. The 4 verdicts hold because they ask for what theory" in page
    assert rows(built)["MUL-4"].claim is None and "does not hold it" in rows(built)["MUL-4"].explanation
    assert rows(built)["GRE-1"].explanation == "No run has decided this yet."


def test_a_blocking_verdict_is_named(built):
    row = claims.Row("X-1", claims.Claim("X-1", "a claim", "a source", "reproduced"), rows(built)["MUL-4"].decisions)
    assert row.explanation == "1 of 1 verdicts of this report block: the state needs a look."


def test_the_largest_deviation_speaks_known_limits_apart(built):
    decision = next(item for item in rows(built)["BAR-2"].decisions if item.check == "collision-rate")
    assert decision.farthest.verdict == "pass" and decision.holding == 20


@pytest.mark.parametrize("claim", LEDGER, ids=lambda claim: claim.id)
def test_a_claim_of_the_ledger_names_cases_that_are_there(claim):
    assert set(claim.evidence) <= CASES
    assert bool(claim.evidence and claim.note) or claim.status == "not yet tested"


def test_verdicts_and_figures_name_claims_of_the_ledger():
    known = {claim.id for claim in LEDGER}
    assert len(known) == len(LEDGER)
    named = {figure.claim for name in DRAWINGS for figure in catalogue(name).figures if figure.claim}
    for path in TOP.glob("validation/case/*/*/case.toml"):
        named |= set(re.findall(r'"([A-Z]{3}-\d+)"', path.read_text(encoding="utf-8")))
    assert named and named <= known
    assert all(figure.claim or figure.missing for name in DRAWINGS for figure in catalogue(name).figures)
