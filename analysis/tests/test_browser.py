"""Every page in a real browser, laptop and phone. Skipped where Chromium is not installed."""

import pytest

from analysis.tests.browser import Browser, available

pytestmark = pytest.mark.skipif(not available(), reason="chromium is not installed")

MISSING = "return [...document.images].filter(i => i.complete && !i.naturalWidth).map(i => i.src)"
LOADING = "return [...document.images].some(i => !i.complete)"
OVERFLOW = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
LINKS = "return [...document.links].map(a => a.href).filter(h => h.startsWith('file:') && h.includes('#'))"
LISTS = "return [...document.querySelectorAll('section.opened')].filter(s => s.offsetHeight).map(s => s.id)"
FOCUS = "return document.activeElement.id"
COVERED = ("const seen = document.querySelector('section.opened:target').getBoundingClientRect();"
           "return seen.top < 0 || seen.top > innerHeight")
TAB, ENTER = "Tab", "Enter"
ANCHORS = "return [...document.querySelectorAll('[id]')].map(e => e.id)"


@pytest.fixture(scope="module")
def browser():
    with Browser() as opened:
        yield opened


def pages(folder):
    return sorted(folder.glob("*.html")) + sorted(folder.glob("case/*.html"))


@pytest.mark.parametrize("width", [1280, 390])
def test_pages_show_everything(browser, built, width):
    browser.resize(width, 844)
    for page in pages(built[1]):
        browser.open(page)
        assert not browser.evaluate(LOADING)
        assert browser.evaluate(MISSING) == [], page.name
        assert browser.evaluate(OVERFLOW) <= 0, f"{page.name} is wider than {width} px"
    assert browser.complaints() == []


def test_anchors_exist(browser, built):
    anchors, wanted = {}, set()
    for page in pages(built[1]):
        browser.open(page)
        anchors[page.resolve().as_uri()] = set(browser.evaluate(ANCHORS))
        wanted |= {tuple(link.split("#")) for link in browser.evaluate(LINKS)}
    assert wanted
    assert [link for link in wanted if link[1] not in anchors[link[0]]] == []


@pytest.mark.parametrize("width", [1280, 390])
def test_a_cell_opens_and_closes_by_click(browser, built, width):
    browser.resize(width, 844)
    browser.open(built[1] / "index.html")
    assert browser.evaluate(LISTS) == []
    for variant in ("cba", "dsmc"):
        browser.click(f"a[href='#cell--equilibrium-gas--{variant}']")
        assert browser.evaluate(LISTS) == [f"cell--equilibrium-gas--{variant}"]
        assert not browser.evaluate(COVERED) and browser.evaluate(OVERFLOW) <= 0
    browser.click("td:has(> a[href='#cell--equilibrium-gas--dsmc']) > .closes")
    assert browser.evaluate(LISTS) == []
    assert browser.complaints() == []


def test_a_cell_opens_and_closes_by_keys(browser, built):
    browser.resize(1280, 844)
    browser.open(built[1] / "index.html")
    browser.evaluate("document.querySelector('.case a').focus()")
    browser.press(TAB)
    browser.press(ENTER)
    assert browser.evaluate(LISTS) == [browser.evaluate(FOCUS)] == ["cell--equilibrium-gas--cba"]
    browser.press(TAB)
    browser.press(ENTER)
    assert browser.evaluate(LISTS) == []


def test_each_opened_list_fits_the_screen(browser, built):
    for width in (1280, 390):
        browser.resize(width, 844)
        browser.open(built[1] / "index.html")
        for name in browser.evaluate("return [...document.querySelectorAll('section.opened')].map(s => s.id)"):
            browser.evaluate(f"location.hash = '{name}'")
            assert browser.evaluate(LISTS) == [name]
            assert browser.evaluate(OVERFLOW) <= 0, f"{name} is wider than {width} px"


def test_missing_picture_is_noticed(browser, built, tmp_path):
    page = tmp_path / "broken.html"
    page.write_text('<img src="nothing.svg"><div style="width:3000px">x</div>', encoding="utf-8")
    browser.open(page)
    assert len(browser.evaluate(MISSING)) == 1
    assert browser.evaluate(OVERFLOW) > 0
    assert browser.complaints() != []


def test_dark_scheme_changes_the_page(browser, built):
    colour = "return getComputedStyle(document.body).backgroundColor"
    seen = []
    for scheme in ("light", "dark"):
        browser.colours(scheme)
        browser.open(built[1] / "index.html")
        seen.append(browser.evaluate(colour))
    browser.colours("light")
    assert seen[0] != seen[1]
