"""Pictures of the studio for the documentation: the demonstration, measured and adjusted in a browser.

    python tools/studio_pictures.py

Orients the photographs of demo_data/portal and writes docs/images/studio-*.png.  Needs playwright and a
Chromium (RAYBUNDLE_CHROMIUM names one that is not on the path).
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from PIL import Image
from playwright.sync_api import Page, sync_playwright

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from tests.studio.browser import ARGUMENTS, PORTAL, Hand, chromium, served, targets  # noqa: E402

IMAGES = ROOT / "docs" / "images"
SIZE = (1366, 768)
LARGEST = 400_000
PAGE = (
    "ffffff", "1c2530", "55616d", "d5dbe1", "f3f5f7", "1f5a8a", "26694b", "dbe8f3", "2b2b2b", "1f1f1f",
    "3a3a3a", "e8e8e8", "56b4e9", "e69f00", "d55e00", "f0e442", "2fc79a", "f5a3cf", "f7f5f0", "20406e",
    "2f86b0", "7fb79a", "c2410c", "9aa3ab", "cc3d8f", "b45f00", "111111", "8b96a1", "edf0f2",
)  # fmt: skip
SEEN = ("portal_02.jpg", "portal_04.jpg", "portal_06.jpg")


def project_in(folder: Path) -> tuple[Path, Path]:
    """The demonstration's photographs, oriented."""
    from raybundle.commands.orient import orient

    photos = folder / "photos"
    shutil.copytree(PORTAL / "photos", photos)
    orient(sorted(photos.glob("*.jpg")), folder / "facade", precise=False, report=False)
    return folder / "facade", photos


def keep(page: Page, name: str) -> None:
    """A picture of the page, in as many colours as go into its size."""
    path = IMAGES / f"studio-{name}.png"
    page.wait_for_timeout(1500)
    page.screenshot(path=path)
    with Image.open(path) as opened:
        whole = opened.convert("RGB")
    for colours in (224, 160, 112, 80, 48):
        few(whole, colours).save(path, optimize=True)
        if path.stat().st_size <= LARGEST:
            break
    print(f"{path.relative_to(ROOT)}: {path.stat().st_size / 1000:.0f} kB")


def few(picture: Image.Image, colours: int) -> Image.Image:
    """A picture in few colours: those of the page, which are few and matter, and so many of the photographs."""
    palette = picture.quantize(colours, Image.Quantize.MEDIANCUT).getpalette() or []
    fixed = [int(c[k : k + 2], 16) for c in PAGE for k in (0, 2, 4)]
    holder = Image.new("P", (1, 1))
    holder.putpalette(fixed + palette[: 3 * colours])
    return picture.quantize(palette=holder, dither=Image.Dither.NONE)


def measure(page: Page, hand: Hand, target: str, images: tuple[str, ...]) -> str:
    """A new point, marked where a target is."""
    name = hand.new_point()
    for image in images:
        hand.click_at(image, *targets()[target][image])
    page.locator(".where .sigma").first.wait_for()
    return name


def pictures(page: Page) -> None:
    """Look, measure, adjust, look again."""
    hand = Hand(page)
    hand.wait("studio_page.adjusted")
    page.locator("#image-list canvas[data-drawn]").nth(8).wait_for()
    keep(page, "images")
    ends = [measure(page, hand, "T3", SEEN)]
    page.keyboard.press("n")
    hand.wait("studio_point.new_point")
    ends.append(page.locator("#point-name").input_value())
    for image in SEEN[:2]:
        hand.click_at(image, *targets()["T4"][image])
    page.keyboard.press("g")
    page.locator("#image-list [role=option]", has_text="portal_06.jpg").click()
    page.locator(".pane .canvas").nth(1).wait_for()
    page.locator(".where .sigma").first.wait_for()
    page.wait_for_timeout(500)
    page.keyboard.press("c")
    for _ in range(6):
        page.keyboard.press("+")
    page.keyboard.press("c")
    page.locator("#loupe").check()
    u, v = _middle(page)
    page.mouse.move(u - 1, v)
    page.mouse.move(u, v)
    keep(page, "measuring")
    page.locator("#loupe").uncheck()
    page.locator(".pane.active .canvas").focus()
    page.keyboard.press("Enter")
    hand.wait("studio_point.marked")
    for field, value in {"start": ends[0], "end": ends[1], "length": "2.430", "sigma": "0.001"}.items():
        page.fill(f"#bar-{field}", value)
    page.click("#bar-add")
    hand.wait("studio_point.bar_given")
    page.click("#adjust")
    hand.wait("studio_page.adjusted", "measured-result")
    space(page)
    page.click("#tab-tables")
    page.select_option("#table-kind", "observations")
    page.get_by_role("button", name="|w|").click()
    keep(page, "tables")
    decide(page, hand)
    page.click("#tab-journal")
    keep(page, "journal")
    stages(page)


def decide(page: Page, hand: Hand) -> None:
    """The parameters of the camera, one of them to be held."""
    page.click("#tab-decide")
    page.click("#decide-parameters")
    page.get_by_role("combobox", name="K3 of camera").select_option("held")
    hand.wait("studio_decide.choice_stored")
    keep(page, "decide")


def stages(page: Page) -> None:
    """What the calibration is worth, targets over a photograph, and a run of all stages at work."""
    page.click("#tab-decide")
    page.click("#decide-calibration")
    page.locator("#decide .verdict").wait_for()
    keep(page, "calibration")
    page.click("#decide-targets")
    page.fill("#targets-family", "dots")
    page.keyboard.press("Tab")
    page.locator("#decide").get_by_role("button", name=SEEN[0], exact=True).click()
    Hand(page).wait("studio_target.found_in")
    page.select_option("#filter", "none")
    keep(page, "targets")
    page.select_option("#filter", "all")
    page.click("#tab-decide")
    page.click("#decide-run")
    page.fill("#run-photos", "photos")
    page.fill("#run-redo_from", "features")
    page.keyboard.press("Tab")
    page.locator("#decide .command", has_text="--from-stage features").wait_for()
    page.click("#run-begin")
    page.locator(".stages .at-work th", has_text="features").wait_for()
    keep(page, "run")
    page.click("#run-stop")
    page.locator("#run-begin:enabled").wait_for()


def space(page: Page) -> None:
    """Object space with ellipsoids and a distance."""
    page.click("#tab-space")
    page.locator("#space-legend", has_text="points").wait_for()
    page.select_option("#space-colour", "sigma")
    page.check("#show-ellipsoids")
    page.check("#space-measure")
    for name in ("M1", "M2"):
        page.locator("#right [role=option]", has_text=name).first.click()
        page.get_by_role("button", name="Add current point").click()
    page.locator("#space-status", has_text="±").wait_for()
    page.locator("#space canvas").focus()
    for _ in range(3):
        page.keyboard.press("+")
    keep(page, "space")


def _middle(page: Page) -> tuple[float, float]:
    box: Any = page.locator(".pane.active .canvas").bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def main() -> None:
    """Make all pictures."""
    with TemporaryDirectory() as folder:
        project, photos = project_in(Path(folder))
        with served(project, photos) as address, sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=chromium(), args=list(ARGUMENTS))
            page = browser.new_page(viewport={"width": SIZE[0], "height": SIZE[1]})
            page.goto(address)
            pictures(page)
            browser.close()


if __name__ == "__main__":
    main()
