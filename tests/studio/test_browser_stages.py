"""Stages run, stopped and run again in the browser; the calibration and its targets looked at."""

import pytest

from raybundle.words import headline
from tests.studio.browser import Hand, served
from tests.studio.test_browser import context
from tests.studio.test_targets import COLUMNS, ROWS, board

AT_ONCE = """() => {
  const stop = document.querySelector("#run-stop");
  const press = (_, watch) => {
    if (stop.disabled) return;
    watch.disconnect();
    stop.click();
  };
  new MutationObserver(press).observe(stop, { attributes: true });
}"""
"""Stop pressed as soon as it can be: where everything is kept, a fast machine has run all stages in a second."""

__all__ = ["board", "context"]  # fixtures
pytestmark = pytest.mark.long


@pytest.fixture
def address(board):
    with served(board / "calibration", board / "photos") as address:
        yield address


def test_run_stop_run_again_and_look(context, address, board):
    page = context.new_page()
    page.goto(address)
    hand = Hand(page)
    hand.wait("studio_page.adjusted")
    page.click("#tab-decide")
    page.click("#decide-run")
    page.check("#run-shear")
    page.locator("code.command", has_text="--target chessboard-7x6 --shear --out calibration").wait_for()
    page.uncheck("#run-shear")
    hand.tab_to("#run-begin")
    page.evaluate(AT_ONCE)
    page.keyboard.press("Enter")
    page.locator(".counts", has_text=headline("studio_run.ended", {"outcome": "stopped", "time": ""})).wait_for()
    assert (board / "calibration" / "result.json").is_file()
    page.click("#run-begin")
    page.locator(".counts", has_text=headline("studio_run.ended", {"outcome": "done", "time": ""})).wait_for()
    assert page.locator(".stages tr.kept").count() >= 1
    page.locator(".stages tr", has_text=f"{7 * COLUMNS * ROWS} points of").wait_for()
    page.locator(".printed", has_text="7 of 7").wait_for()
    page.click("#decide-calibration")
    page.locator(".verdict").wait_for()
    page.locator(".figures img").first.scroll_into_view_if_needed()
    page.wait_for_function(
        "[...document.querySelectorAll('.figures img')].some(i => i.complete && i.naturalWidth > 100)"
    )
    page.click("#decide-targets")
    page.locator("#targets-by-photograph tbody tr").nth(6).wait_for()
    page.get_by_role("button", name="board_1.jpg").first.click()
    page.locator("#tab-images[aria-selected=true]").wait_for()
    assert page.locator("#targets").is_checked()
    page.locator("#legend-target-used:visible").wait_for()
    drawn = page.locator(".pane.active").locator("canvas.over")
    before = drawn.screenshot()
    page.uncheck("#targets")
    page.wait_for_timeout(200)
    assert drawn.screenshot() != before
