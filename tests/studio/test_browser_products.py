"""Products in the browser: an area drawn on a plan is the outline of a volume, files are listed."""

import pytest

from raybundle.measuring.journal import journal_path, state_of
from raybundle.words import headline
from tests.studio.browser import Hand
from tests.studio.test_browser import address, context
from tests.studio.test_products import CELL, LEFT, TOP, surface

__all__ = ["address", "context", "surface"]  # fixtures
pytestmark = pytest.mark.long


def test_an_area_is_drawn_and_files_are_made(context, surface, address, project):
    page = context.new_page()
    page.goto(address)
    Hand(page).wait("studio_page.adjusted")
    page.click("#tab-products")
    page.click("#plan-area")
    box = page.locator("#plan").bounding_box()
    scale = min(box["width"] / 60, box["height"] / 40)
    left, top = box["x"] + box["width"] / 2 - 30 * scale, box["y"] + box["height"] / 2 - 20 * scale
    corners = [(10, 10), (50, 12), (30, 36)]
    for column, row in corners:
        page.mouse.click(left + column * scale, top + row * scale)
    page.select_option("#plan-file", "surface/heights.tif")  # what is drawn stays
    page.click("#plan-use-area")
    outline = page.locator("#product-volume-outline")
    page.locator("code.command:visible", has_text="--outline").wait_for()
    drawn = [tuple(map(float, xy.split())) for xy in outline.input_value().strip("'").split(",")]
    for (x, y), (column, row) in zip(drawn, corners, strict=True):
        assert x == pytest.approx(LEFT + CELL * column, abs=2 * CELL / scale)
        assert y == pytest.approx(TOP - CELL * row, abs=2 * CELL / scale)
    page.click("#product-plan")
    page.fill("#drawing-name", "pile")
    page.fill("#drawing-note", "gravel")
    page.click("#drawing-keep")
    page.get_by_title(headline("studio_product.edit", {"name": "pile"})).wait_for()
    assert state_of(journal_path(project)).drawings["pile"].note == "gravel"
    page.get_by_title(headline("studio_product.erase", {"name": "pile"})).click()
    page.locator("#drawings:visible").wait_for(state="detached")
    page.click("#undo")
    page.get_by_title(headline("studio_product.edit", {"name": "pile"})).click()
    page.locator("#plan-use-area:visible").wait_for()
    page.click("#product-exchange")
    page.select_option("#product-exchange-to", "ply")
    page.locator("code.command:visible", has_text="--to ply").wait_for()
    page.click("#make-exchange")
    page.locator(".counts:visible", has_text=headline("studio_run.ended", {"outcome": "done", "time": ""})).wait_for()
    page.click("#product-files")
    page.get_by_role("link", name="exchange-1.ply").wait_for()
    assert (project / "exports" / "exchange-1.ply").is_file()
    page.click("#product-plan")
    page.locator("#plan").focus()
    for key in ("Escape", "ArrowLeft", "+"):
        page.keyboard.press(key)
    page.locator("#plan-place", has_text="X ").wait_for()
