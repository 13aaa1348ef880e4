"""The report in a browser: on a phone, a tablet and a small screen nothing leaves the page, and axe-core is content."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from raybundle.report.writing import write_report
from tests.report.conftest import rich
from tests.studio.test_accessible import AXE, serious

pytestmark = pytest.mark.long
SIZES = [(390, 844), (768, 1024), (1366, 768)]
CAMERA = "Canon EOS 5D Mark III-24mm"


def with_long_names(a):
    """The camera named as photographs name it, the images as long as file names get."""

    def renamed(block):
        (camera,) = block.cameras
        ids = tuple(f"A_long_name_of_a_photograph_without_a_blank_{i}.JPG" for i in block.images.ids)
        return replace(block, cameras=(replace(camera, id=CAMERA),), images=replace(block.images, ids=ids, file=ids))

    interior = tuple(replace(i, camera=CAMERA) for i in a.interior)
    return replace(a, given=renamed(a.given), adjusted=renamed(a.adjusted), interior=interior)


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    file = tmp_path_factory.mktemp("report") / "report.html"
    write_report(with_long_names(rich()), file)
    return file


@pytest.fixture(params=SIZES, ids=lambda s: str(s[0]))
def page(request, browser, report):
    width, height = request.param
    page = browser.new_page(viewport={"width": width, "height": height})
    page.goto(report.as_uri())
    page.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)")
    yield page
    page.close()


def test_the_page_does_not_scroll_sideways(page):
    wide, room = page.evaluate("[document.documentElement.scrollWidth, innerWidth]")
    assert wide <= room
    beyond = page.evaluate(
        "[...document.querySelectorAll('body *')].filter(e => !e.closest('.scroll') && !e.closest('svg') && "
        "e.getBoundingClientRect().right > innerWidth + 1).map(e => e.outerHTML.slice(0, 80))"
    )
    assert not beyond


def test_what_scrolls_can_be_reached_by_keyboard(page):
    hidden = page.evaluate(
        "[...document.querySelectorAll('*')].filter(e => e.scrollWidth > e.clientWidth + 1 && "
        "['auto', 'scroll'].includes(getComputedStyle(e).overflowX) && e.tabIndex < 0).length"
    )
    assert hidden == 0
    box = page.locator(".scroll").first
    box.focus()
    assert page.evaluate("document.activeElement.classList.contains('scroll')")


def test_names_of_cameras_take_two_lines_at_most(page):
    lines = page.evaluate(
        f"[...document.querySelectorAll('td')].filter(e => e.textContent.includes('{CAMERA}')).map(e => "
        "{ const r = document.createRange(); r.selectNodeContents(e); "
        "return new Set([...r.getClientRects()].map(b => Math.round(b.top))).size })"
    )
    assert lines
    assert max(lines) <= 2


def test_axe_finds_nothing_serious(page):
    if not AXE.exists():
        pytest.skip("web/node_modules is not there (cd web; npm ci): axe-core is not run here")
    page.evaluate(AXE.read_text(encoding="utf-8"))
    assert not serious(page)


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="poppler is not here")
def test_print_has_no_empty_folds_and_no_contents(browser, report, tmp_path: Path):
    page = browser.new_page()
    page.goto(report.as_uri())
    page.emulate_media(media="print")
    assert not page.locator("nav").is_visible()
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    page.close()
