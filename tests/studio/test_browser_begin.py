"""The page with photographs alone: a person clicks points, they are oriented meanwhile, and there is a report."""

import shutil

import pytest

from tests.studio.browser import ARGUMENTS, PORTAL, Hand, chromium, served, targets

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: the page is not tested here")

pytestmark = pytest.mark.long
IMAGES = ("portal_02.jpg", "portal_03.jpg", "portal_04.jpg")


@pytest.fixture
def page(tmp_path):
    path = chromium()
    if path is None:
        pytest.skip("no Chromium is here (RAYBUNDLE_CHROMIUM may name one): the page is not tested here")
    photos = tmp_path / "archive"
    photos.mkdir()
    for name in IMAGES:
        shutil.copy(PORTAL / "photos" / name, photos / name)
    with served(photos, photos) as address, sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=list(ARGUMENTS))
        context = browser.new_context(viewport={"width": 1366, "height": 768})
        context.set_default_timeout(30_000)
        wrong = []
        context.on("console", lambda m: m.type == "error" and wrong.append(m.text))
        context.on("weberror", lambda e: wrong.append(str(e.error)))
        page = context.new_page()
        page.goto(address)
        page.locator("#standing-line").wait_for()
        yield page
        context.close()
        browser.close()
        assert not wrong


def test_photographs_alone_to_a_report_by_clicks(page, tmp_path):
    """Eight targets in two photographs, five in the third, whose next one is predicted; adjusted, the report opened."""
    hand, names = Hand(page), {}
    line = page.locator("#standing-line")
    assert "0 of 3 photographs oriented" in line.inner_text()
    assert page.locator("#image-list", has_text="not oriented").count()
    measured = targets()
    for k, target in enumerate(("T1", "T2", "T3", "T4", "T5", "T6", "T7", "T8")):
        names[target] = hand.new_point()
        for image in IMAGES[:2]:
            hand.click_at(image, *measured[target][image])
        if k == 3:
            line.filter(has_text="need 2 more common points").wait_for()
    line.filter(has_text="2 of 3 photographs oriented; portal_04.jpg needs 4 more points").wait_for()
    page.locator("#image-list [role=option]", has_text="portal_02.jpg").filter(has_text="8 rays").wait_for()
    for target in ("T1", "T4", "T5", "T8", "T3"):
        page.fill("#point-name", names[target])
        page.keyboard.press("Enter")
        hand.click_at("portal_04.jpg", *measured[target]["portal_04.jpg"])
    page.locator("#standing").wait_for(state="hidden")
    page.fill("#point-name", names["T6"])
    page.keyboard.press("Enter")
    page.locator("#right", has_text="Visible there, not measured (1)").wait_for()
    assert page.locator("#report").is_hidden()
    page.click("#adjust")
    hand.wait("Adjusted: sigma0")
    with page.context.expect_page() as opened:
        page.click("#report")
    opened.value.locator("h1").first.wait_for()
    assert (tmp_path / "archive-project" / "measured-result" / "report.html").is_file()
    assert (tmp_path / "archive-project" / "measured.db").is_file()
