"""The page that decides, in a browser: an option, a parameter, a limit, two adjustments, all of it taken back."""

import pytest

from raybundle.measuring.journal import entries_of, journal_path, state_of
from raybundle.words import headline
from tests.studio.browser import Hand
from tests.studio.test_browser import SIZES, address, context, hand, overlapping, page, undone, verbs

__all__ = ["address", "context", "hand", "page"]  # fixtures
pytestmark = pytest.mark.long
PARTS = ("run", "options", "parameters", "select", "compare", "calibration", "targets", "report")
CONTROLS = "#decide input, #decide select, #decide button"


@pytest.fixture
def decide(page):
    page.click("#tab-decide")
    page.locator("#option-reject").wait_for()
    return page


def adjusted(page, press):
    """Begin an adjustment and wait for its end."""
    page.evaluate("document.getElementById('message').dataset.code = ''")
    press()
    Hand(page).wait("studio_page.adjusted", "result")


def test_decide_adjust_compare_and_take_back(decide, hand, project):
    page = decide
    page.select_option("#option-reject", "snooping")
    page.locator("#decide code.command", has_text="raybundle mark adjust --reject snooping -- project").wait_for()
    page.locator(".option.changed", has_text="reject").wait_for()
    adjusted(page, lambda: page.click("#options-adjust"))
    page.click("#decide-parameters")
    row = page.locator(".parameters tbody tr", has=page.locator("th", has_text="K3"))
    row.locator("select").select_option("held")
    hand.wait("studio_decide.choice_stored", "K3")
    assert headline("studio_decide.status", {"status": "estimated"}) in row.inner_text()
    page.click("#decide-select")
    page.fill("#select-limit", "2.25")
    page.keyboard.press("Tab")
    counts = page.locator(".counts[aria-busy=false]", has_text="%")
    counts.wait_for()
    n = int(counts.inner_text().split(" ")[0].replace("\u202f", ""))
    assert n > 0
    page.get_by_role("button", name=headline("studio_decide.show_in_images", {})).click()
    page.locator("#legend-beyond:visible").wait_for()
    page.click("#tab-space")
    page.locator("#space-legend", has_text=headline("studio_space.beyond", {"n": ""})).wait_for()
    page.click("#tab-decide")
    page.click("#select-reject")
    hand.wait("studio_decide.rejected", "2.25")
    page.locator("#select-reject:disabled").wait_for()
    assert len(state_of(journal_path(project)).rejected) == n
    adjusted(page, lambda: page.click("#adjust"))
    page.click("#decide-parameters")
    row.locator("td").nth(1).filter(has_text=headline("studio_decide.status", {"status": "held"})).wait_for()
    page.click("#decide-compare")
    frame = page.frame_locator("#decide iframe[title^=Comparison]")
    setting = headline("report_compare.setting", {"name": "hold"})
    frame.locator("td", has_text=setting).wait_for()
    assert page.locator(".adjustments input[name=compare-first]").count() == 3
    page.click("#decide-report")
    page.frame_locator("#decide iframe[title^=Report]").locator("h1").wait_for()
    assert undone(page, lambda: page.click("#undo")) == 2
    assert verbs(project) == ["parameter", "reject_beyond", "undo", "undo"]
    state = state_of(journal_path(project))
    assert (state.parameters, state.rejected) == ({}, frozenset())


def test_reports_reach_nothing_of_the_page(decide, context):
    """The report runs its own script, of no origin; its window of its own is the same."""
    page = decide
    adjusted(page, lambda: page.click("#adjust"))
    page.click("#decide-report")
    page.frame_locator("#decide iframe[title^=Report]").locator("h1").wait_for()
    inner = next(f for f in page.frames if "/adjustment/" in f.url)
    assert inner.evaluate("origin") == "null"
    assert inner.evaluate("document.body.childElementCount") > 0
    reached = inner.evaluate("() => { try { return String(parent.document.title) } catch (e) { return e.name } }")
    assert reached == "SecurityError"
    asked = inner.evaluate("() => fetch('/api/overview').then(() => 'answered', () => 'refused')")
    assert asked == "refused"
    with context.expect_page() as opened:
        page.get_by_role("link", name=headline("studio_decide.window", {})).click()
    opened.value.locator("h1").first.wait_for()
    assert opened.value.evaluate("origin") == "null"
    context.wrong[:] = [w for w in context.wrong if "connect" not in w and "Connect" not in w]


def test_by_keyboard_alone(decide, hand, project):
    """Every control of every part is reached with the Tab key and has a name."""
    page = decide
    for part in PARTS:
        hand.tab_to(f"#decide-{part}")
        page.keyboard.press("Enter")
        page.wait_for_timeout(700)
        controls = page.locator(CONTROLS).locator("visible=true")
        for control in controls.all():
            name = control.evaluate(
                "c => c.getAttribute('aria-label') || (c.labels?.[0]?.textContent) || c.textContent"
            )
            assert name.strip(), control.evaluate("c => c.outerHTML")
    hand.tab_to("#decide-options")
    page.keyboard.press("Enter")
    hand.tab_to("#option-robust_start")
    page.keyboard.press("Space")
    page.locator("#decide code.command", has_text="--robust-start").wait_for()
    hand.tab_to("#decide-parameters")
    page.keyboard.press("Enter")
    hand.tab_to(".parameters select")
    page.keyboard.press("ArrowDown")
    hand.wait("studio_decide.choice_stored")
    assert [e.verb for e in entries_of(journal_path(project))] == ["parameter"]
    assert page.evaluate("document.activeElement.closest('table').className") == "parameters"


def test_a_refusal_says_what_is_wrong(decide, hand, context):
    page = decide
    page.fill("#option-datum_points", "nowhere")
    page.keyboard.press("Tab")
    hand.wait("studio_decide.options_stored")
    page.click("#options-adjust")
    page.locator("#message.bad", has_text="nowhere").wait_for()
    page.fill("#option-jobs", "-1")
    page.keyboard.press("Tab")
    hand.wait("setting.too_small", "[setting.too_small]")
    context.wrong[:] = [w for w in context.wrong if "409" not in w]


@pytest.mark.parametrize("size", SIZES, ids=lambda s: f"{s[0]}x{s[1]}")
def test_nothing_lies_over_another(decide, size):
    page = decide
    page.set_viewport_size({"width": size[0], "height": size[1]})
    for part in PARTS:
        page.click(f"#decide-{part}")
        page.wait_for_timeout(700)
        stage = page.locator("#stage").bounding_box()
        boxes = {f"{k}": c.bounding_box() for k, c in enumerate(page.locator(CONTROLS).locator("visible=true").all())}
        boxes = {k: b for k, b in boxes.items() if b is not None}
        assert not overlapping(boxes)
        for box in boxes.values():
            assert box["x"] >= stage["x"]
            assert box["x"] + box["width"] <= stage["x"] + stage["width"] + 0.5
