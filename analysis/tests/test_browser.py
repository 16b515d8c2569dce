"""Every page in a real browser, screen, tablet and phone. Skipped where Chromium is not installed."""

import time

import pytest

from analysis.build import build
from analysis.load import load_report
from analysis.tests import fixture
from analysis.tests.browser import Browser, available

pytestmark = pytest.mark.skipif(not available(), reason="chromium is not installed")

WIDTHS = [1440, 800, 390]
SCREEN = 900
LONGEST = {1440: 8, 800: 14, 390: 24}   # screens of a page of the fixture
FIVE = 5                                # and of a page with five checks, 26 points, eight methods, at 1440
EAGER = "for (const each of document.images) each.loading = 'eager'"
UNFOLD = "for (const each of document.querySelectorAll('details')) each.open = true"
MISSING = "return [...document.images].filter(i => i.complete && !i.naturalWidth).map(i => i.src)"
LOADING = "return [...document.images].some(i => !i.complete)"
OVERFLOW = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
HEIGHT = "return document.documentElement.scrollHeight"
# The boxes of all lines of text that can be seen, cut where a box around them cuts them.
LINES = """
const lines = [], walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
const cut = (box, clip) => ({left: Math.max(box.left, clip.left), right: Math.min(box.right, clip.right),
                             top: Math.max(box.top, clip.top), bottom: Math.min(box.bottom, clip.bottom)});
while (walk.nextNode()) {
  const node = walk.currentNode, parent = node.parentElement;
  if (!node.data.trim() || !parent.checkVisibility() || parent.closest('script, style, option, .unseen')) continue;
  const range = document.createRange();
  range.selectNodeContents(node);
  let block = parent;
  while (getComputedStyle(block).display.startsWith('inline')) block = block.parentElement;
  for (const rect of range.getClientRects()) {
    let box = {left: rect.left, right: rect.right, top: rect.top, bottom: rect.bottom}, free = false;
    for (let each = parent; each; each = each.parentElement) {
      const style = getComputedStyle(each);
      if (style.overflowX !== 'visible' && each !== document.body && each !== document.documentElement) {
        box = cut(box, each.getBoundingClientRect());
        free = true;
      }
    }
    if (box.right - box.left < 1 || box.bottom - box.top < 1) continue;
    const limit = block.getBoundingClientRect();
    lines.push({...box, text: node.data.trim().slice(0, 40), spilled: !free && rect.right > limit.right + 2});
  }
}
"""
OVERLAPS = LINES + """
lines.sort((a, b) => a.top - b.top);
const found = [];
lines.forEach((one, index) => {
  for (let next = index + 1; next < lines.length && lines[next].top < one.bottom - 4; ++next) {
    const other = lines[next];
    if (Math.min(one.right, other.right) - Math.max(one.left, other.left) > 2
        && Math.min(one.bottom, other.bottom) - other.top > 4) found.push(`${one.text} | ${other.text}`);
  }
});
return found.slice(0, 5);
"""
SPILLED = LINES + "return lines.filter(line => line.spilled).map(line => line.text).slice(0, 5)"
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


def settle(browser):
    """Waits until every picture is there."""
    browser.evaluate(EAGER)
    end = time.monotonic() + 20
    while browser.evaluate(LOADING) and time.monotonic() < end:
        time.sleep(0.05)
    assert not browser.evaluate(LOADING)


def inspect(browser, page, width):
    assert browser.evaluate(MISSING) == [], page.name
    assert browser.evaluate(OVERFLOW) <= 0, f"{page.name} is wider than {width} px"
    assert browser.evaluate(OVERLAPS) == [], f"{page.name} at {width} px: text covers text"
    assert browser.evaluate(SPILLED) == [], f"{page.name} at {width} px: text leaves its box"


@pytest.mark.parametrize("width", WIDTHS)
def test_pages_show_everything(browser, built, width):
    browser.resize(width, SCREEN)
    for page in pages(built[1]):
        browser.open(page)
        settle(browser)
        inspect(browser, page, width)
        height = browser.evaluate(HEIGHT)
        assert height <= LONGEST[width] * SCREEN, f"{page.name} has {height} px at {width} px"
        browser.evaluate(UNFOLD)
        settle(browser)
        inspect(browser, page, width)
    assert browser.complaints() == []


@pytest.fixture(scope="module")
def large(tmp_path_factory):
    """A report with a case as large as the largest of the suite, and with as many methods."""
    groups = [fixture.wide(), fixture.many_methods()]
    folder = tmp_path_factory.mktemp("large")
    files = {f"evidence/{rows[0][0]['case']}.json": fixture.evidence(rows) for rows in groups}
    files["verdicts.json"] = [row for rows in groups for row, _ in rows]
    build(load_report(fixture.write(folder, files)), folder)
    return folder / "case" / "large-case.html"


@pytest.mark.parametrize("width", WIDTHS)
def test_a_large_case_stays_short(browser, large, width):
    browser.resize(width, SCREEN)
    browser.open(large.parent.parent / "index.html")
    settle(browser)
    inspect(browser, large, width)
    browser.open(large)
    settle(browser)
    inspect(browser, large, width)
    assert browser.evaluate(HEIGHT) <= FIVE * SCREEN
    assert browser.complaints() == []


ROWS = "return [...document.querySelectorAll('.verdicts tbody')].filter(e => e.offsetHeight)"


def test_the_table_of_verdicts_sorts_and_filters(browser, large):
    browser.resize(1440, SCREEN)
    browser.open(large)
    browser.click(".verdicts th:nth-child(8) button")
    shares = browser.evaluate(ROWS + ".map(e => parseFloat(e.rows[0].cells[7].dataset.sort))")
    assert len(shares) == 26 * 8 * 5 and shares == sorted(shares, reverse=True)
    browser.click(".verdicts th:nth-child(8) button")
    assert browser.evaluate(ROWS + ".map(e => parseFloat(e.rows[0].cells[7].dataset.sort))") == sorted(shares)
    browser.evaluate("const s = document.querySelectorAll('.filters select')[1]; s.value = 'hsmc';"
                     "s.dispatchEvent(new Event('input', {bubbles: true}))")
    assert browser.evaluate(ROWS + ".length") == 26 * 5
    browser.evaluate("const s = document.querySelector('.filters input'); s.value = 'haff nu-0.07';"
                     "s.dispatchEvent(new Event('input', {bubbles: true}))")
    assert browser.evaluate(ROWS + ".map(e => e.id)") == ["large-case--hsmc--hard-3d-nu-0.07-r-0.9--haff-cooling"]
    assert "1 of 1040" in browser.evaluate("return document.querySelector('.filters').textContent")


def test_an_address_opens_the_row_that_it_names(browser, large):
    browser.resize(1440, SCREEN)
    name = "large-case--cba--hard-3d-nu-0.05-r-0.9--haff-cooling"
    browser.open(large)
    browser.evaluate(f"location.hash = '{name}'")
    browser.evaluate("return new Promise(done => setTimeout(done, 50))")
    more = f"document.getElementById('{name}').querySelector('.more')"
    assert browser.evaluate(f"return {more}.offsetHeight") > 20
    assert not browser.evaluate(f"const b = {more}.getBoundingClientRect(); return b.top < 0 || b.top > innerHeight")


def test_anchors_exist(browser, built):
    anchors, wanted = {}, set()
    for page in pages(built[1]):
        browser.open(page)
        anchors[page.resolve().as_uri()] = set(browser.evaluate(ANCHORS))
        wanted |= {tuple(link.split("#")) for link in browser.evaluate(LINKS)}
    assert wanted
    assert [link for link in wanted if link[1] not in anchors[link[0]]] == []


@pytest.mark.parametrize("width", WIDTHS)
def test_a_cell_opens_and_closes_by_click(browser, built, width):
    browser.resize(width, SCREEN)
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
    browser.resize(1440, SCREEN)
    browser.open(built[1] / "index.html")
    browser.evaluate("document.querySelector('.case a').focus()")
    browser.press(TAB)
    browser.press(ENTER)
    assert browser.evaluate(LISTS) == [browser.evaluate(FOCUS)] == ["cell--equilibrium-gas--cba"]
    browser.press(TAB)
    browser.press(ENTER)
    assert browser.evaluate(LISTS) == []


def test_each_opened_list_fits_the_screen(browser, built):
    for width in WIDTHS:
        browser.resize(width, SCREEN)
        browser.open(built[1] / "index.html")
        for name in browser.evaluate("return [...document.querySelectorAll('section.opened')].map(s => s.id)"):
            browser.evaluate(f"location.hash = '{name}'")
            assert browser.evaluate(LISTS) == [name]
            assert browser.evaluate(OVERFLOW) <= 0, f"{name} is wider than {width} px"


def test_text_upon_text_is_noticed(browser, tmp_path):
    page = tmp_path / "broken.html"
    page.write_text('<p style="position: absolute; top: 40px">one line</p><p style="position: absolute; top: 46px">'
                    'and another</p><div style="width: 20px; white-space: nowrap">wider than its box</div>',
                    encoding="utf-8")
    browser.open(page)
    assert browser.evaluate(OVERLAPS) == ["one line | and another"]
    assert browser.evaluate(SPILLED) == ["wider than its box"]


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
