import pytest

from analysis.build import build
from analysis.load import load_report
from analysis.tests import fixture


@pytest.fixture
def folder(tmp_path):
    """A report folder before analysis has seen it."""
    return fixture.write(tmp_path, fixture.documents())


@pytest.fixture(scope="session")
def built(tmp_path_factory):
    """(report, its folder with all pages), made once."""
    folder = fixture.write(tmp_path_factory.mktemp("report"), fixture.documents())
    report = load_report(folder, fixture.ledger(folder))
    build(report, folder)
    return report, folder
