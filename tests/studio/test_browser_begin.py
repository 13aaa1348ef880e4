"""The page with photographs alone: a person clicks points, they are oriented meanwhile, and there is a report."""

import shutil
from contextlib import ExitStack

import pytest

from raybundle.block import Camera
from raybundle.commands.new_project import begin
from raybundle.io.calibrations.ours import cameras_text
from raybundle.measuring.journal import entries_of, journal_path
from raybundle.sensors import sensor_models
from raybundle.words import headline
from tests.studio.browser import ARGUMENTS, PORTAL, Hand, chromium, served, targets

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: the page is not tested here")

pytestmark = pytest.mark.long
IMAGES = ("portal_02.jpg", "portal_03.jpg", "portal_04.jpg")


def step(kind, n, image, other=""):
    """The next step as the line above the images shows it."""
    return headline("measuring.next_step", {"kind": kind, "image": image, "other": other, "n": n})


@pytest.fixture
def browse():
    """Opens the page of a project or of photographs."""
    path = chromium()
    if path is None:
        pytest.skip("no Chromium is here (RAYBUNDLE_CHROMIUM may name one): the page is not tested here")
    wrong = []
    with ExitStack() as stack, sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=list(ARGUMENTS))
        context = browser.new_context(viewport={"width": 1366, "height": 768})
        context.set_default_timeout(30_000)
        context.on("console", lambda m: m.type == "error" and wrong.append(m.text))
        context.on("weberror", lambda e: wrong.append(str(e.error)))

        def open_(folder):
            page = context.new_page()
            page.goto(stack.enter_context(served(folder, folder)))
            page.locator("#standing-line").wait_for()
            return page

        yield open_
        context.close()
        browser.close()
    assert not wrong


@pytest.fixture
def page(browse, tmp_path):
    photos = tmp_path / "archive"
    photos.mkdir()
    for name in IMAGES:
        shutil.copy(PORTAL / "photos" / name, photos / name)
    return browse(photos)


def test_photographs_alone_to_a_report_by_clicks(page, tmp_path):
    """Eight targets in two photographs, five in the third, whose next one is predicted; adjusted, the report opened."""
    hand, names = Hand(page), {}
    line = page.locator("#standing-line")
    assert headline("measuring.oriented", {"n": 0, "of": 3}) in line.inner_text()
    assert page.locator("#image-list small.open").count() == 3
    measured = targets()
    for k, target in enumerate(("T1", "T2", "T3", "T4", "T5", "T6", "T7", "T8")):
        names[target] = hand.new_point()
        for image in IMAGES[:2]:
            hand.click_at(image, *measured[target][image])
        if k == 3:
            line.filter(has_text=step("common", 2, IMAGES[0], IMAGES[1])).wait_for()
    line.filter(has_text=headline("measuring.oriented", {"n": 2, "of": 3})).filter(
        has_text=step("points", 4, IMAGES[2])
    ).wait_for()
    page.locator("#image-list [role=option]", has_text="portal_02.jpg").filter(
        has_text=headline("studio_photo.rays", {"n": 8})
    ).wait_for()
    for target in ("T1", "T4", "T5", "T8", "T3"):
        page.fill("#point-name", names[target])
        page.keyboard.press("Enter")
        hand.click_at("portal_04.jpg", *measured[target]["portal_04.jpg"])
    page.locator("#standing").wait_for(state="hidden")
    page.fill("#point-name", names["T6"])
    page.keyboard.press("Enter")
    page.locator("#right", has_text=headline("studio_point.visible", {"n": 1})).wait_for()
    assert page.locator("#report").is_hidden()
    page.click("#adjust")
    hand.wait("studio_page.adjusted", "result")
    with page.context.expect_page() as opened:
        page.click("#report")
    opened.value.locator("h1").first.wait_for()
    assert (tmp_path / "archive-project" / "result" / "report.html").is_file()
    assert (tmp_path / "archive-project" / "measured.db").is_file()


def test_fiducial_marks_are_clicked_one_after_the_other(browse, tmp_path):
    """Scans of film: three fiducial marks by clicks; each is an action, the next one is chosen by itself."""
    photos = tmp_path / "scans"
    photos.mkdir()
    shutil.copy(PORTAL / "photos" / IMAGES[0], photos / IMAGES[0])
    (tmp_path / "certificate.csv").write_text("mark,x_mm,y_mm\nF1,-9,-6\nF2,9,-6\nF3,9,6\nF4,-9,6\n")
    camera = Camera(
        id="rmk", model="brown", width_px=1000, height_px=750, pixel_mm=(0.02, 0.02),
        values={p.symbol: 0.0 for p in sensor_models["brown"].parameters} | {"c": 24.0},
    )  # fmt: skip
    (tmp_path / "rmk.toml").write_text(cameras_text([camera]))
    project = begin(photos, film=tmp_path / "certificate.csv", calibration=tmp_path / "rmk.toml", pixel_mm=0.0125)
    page = browse(project)
    hand = Hand(page)
    card = page.locator("#fiducials")
    page.select_option("#snap", "hand")
    hand.open(IMAGES[0])  # the card is drawn anew while a scan is opened
    page.get_by_role("button", name="F1").click()
    card.filter(has_text=headline("studio_point.click_fiducial", {"name": "F1"})).wait_for()
    for k, (x, y) in enumerate([(80, 1080), (1520, 1085), (1525, 120)]):
        hand.point_at(IMAGES[0], x, y, zoom=2)
        hand.click_here(f"F{k + 1}")
        values = {"image": IMAGES[0], "n": k + 1, "of": 4}
        card.filter(has_text=headline("studio_point.fiducials_of", values)).wait_for()
    page.locator("#standing-line", has_text=step("points", 6, IMAGES[0])).wait_for()
    page.keyboard.press("Escape")
    page.get_by_title(headline("studio_point.remove", {"name": "F3"})).click()
    page.locator("#standing-line", has_text=step("fiducials", 1, IMAGES[0])).wait_for()
    entries = entries_of(journal_path(project))
    assert [(e.verb, e.arguments["name"]) for e in entries] == [("fiducial", f"F{k}") for k in (1, 2, 3, 3)]
    assert abs(entries[1].arguments["x_px"] - 1520) < 2
    assert entries[3].arguments["x_px"] is None
