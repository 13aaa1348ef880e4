"""What was the command line's alone, in the page: a line, a coordinate system, a dropped table, a mask."""

import pytest

from raybundle.measuring.journal import entries_of, journal_path
from raybundle.words import headline
from tests.studio.browser import Hand
from tests.studio.test_browser import address, context, hand, page  # noqa: F401  (fixtures)

pytest.importorskip("playwright.sync_api", reason="playwright is not installed: the page is not tested here")
pytestmark = pytest.mark.long
DROP = """([name, text]) => {
  const data = new DataTransfer();
  data.items.add(new File([text], name, { type: "text/csv" }));
  window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
}"""
TABLE = "point,X,Y,Z,sX,sY,sZ\nA,1,2,3,0.01,0.01,0.02\nB,4,5,6,0.01,0.01,0.02\n"


def test_line_datum_table_and_mask(page, hand, project):  # noqa: F811
    for card in ("studio_point.lines", "studio_point.datum", "studio_point.rename_or_forget", "studio_point.masks"):
        page.locator("summary", has_text=headline(card, {})).click()
    names = page.locator(f"[aria-label={headline('studio_point.points', {})}] [role=option] b").all_inner_texts()[:3]
    page.fill("#line-name", "edge")
    page.select_option("#line-kind", "plumb")
    page.fill("#line-sigma", "0.01")
    page.fill("#line-point", names[0])
    page.keyboard.press("Enter")
    page.click("#line-give")
    hand.wait("mark.line_points")
    page.fill("#line-point", names[1])
    page.keyboard.press("Enter")
    page.keyboard.press("Enter")
    hand.wait("studio_point.line_given", "edge")
    page.locator("#command", has_text="--sigma 0.01 --figure plumb").wait_for()
    for field, name in zip(("origin", "axis", "plane"), names, strict=True):
        page.fill(f"#datum-{field}", name)
    page.keyboard.press("Enter")
    hand.wait("studio_point.datum_given")
    page.evaluate(DROP, ["given.csv", TABLE])
    hand.wait("studio_point.control_added", "given.csv")
    page.locator("#command", has_text="mark control").wait_for()
    page.click("#undo")
    hand.wait("studio_page.undone")
    masks(page, hand)
    verbs = [e.verb for e in entries_of(journal_path(project))]
    assert verbs == ["line", "datum", "control", "undo", "mask", "mask", "unmask"]
    first, second = (e.arguments for e in entries_of(journal_path(project)) if e.verb == "mask")
    assert len(first["polygon"]) == 4
    assert first["polygon"][3] == [800, 600]  # where the cross hair is
    assert second["mask"] == first["mask"]
    assert second["camera"]
    page.context.wrong[:] = [w for w in page.context.wrong if "409" not in w]  # the refusal


def masks(page, hand: Hand):  # noqa: F811
    """Three corners by mouse, one by keyboard; edited; taken away."""
    page.click("#mask-draw")
    box = page.locator(".pane.active .canvas").bounding_box()
    for x, y in ((0.3, 0.3), (0.6, 0.3), (0.6, 0.6)):
        page.mouse.click(box["x"] + x * box["width"], box["y"] + y * box["height"])
    page.keyboard.press("Enter")
    page.locator("#masks .note", has_text="4").wait_for()
    hand.tab_to("#mask-give")
    page.keyboard.press("Enter")
    hand.wait("studio_point.mask_given")
    page.locator("#legend-masked:visible").wait_for()
    page.locator("#masks table button.link").click()
    page.check("#mask-camera")
    page.click("#mask-give")
    page.locator("#masks td", has_text=headline("studio_point.camera_of", {"image": ""})).wait_for()
    page.locator("#masks table button.small").click()
    hand.wait("studio_point.removed")
