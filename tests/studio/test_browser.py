"""The page in a browser: measuring by mouse and by keyboard alone, nothing off the origin, nothing over another."""

import itertools
from urllib.parse import urlsplit

import numpy as np
import pytest

from raybundle.io.block.folder import read_block
from raybundle.measuring.journal import entries_of, journal_path
from raybundle.words import headline
from tests.studio.browser import Hand, served, targets

pytestmark = pytest.mark.long
EVIL = "<img src=x onerror=alert(1)><b>'\"&"
SIZES = [(1366, 768), (3840, 2160)]
CONTROLS = "#top button:visible, .bar:visible label, .bar:visible > button, #left > :visible"
IMAGES = ("portal_02.jpg", "portal_03.jpg", "portal_04.jpg")


@pytest.fixture
def address(project):
    with served(project, project.parent / "photos") as address:
        yield address


@pytest.fixture
def context(browser, address):
    """A browser's window in which nothing may go wrong or anywhere else."""
    context = browser.new_context(viewport={"width": SIZES[0][0], "height": SIZES[0][1]})
    context.set_default_timeout(30_000)
    wrong, origin = [], urlsplit(address).netloc
    context.on("console", lambda m: m.type == "error" and wrong.append(m.text))
    context.on("weberror", lambda e: wrong.append(str(e.error)))
    context.on(
        "request",
        lambda r: wrong.append(r.url) if urlsplit(r.url).netloc != origin and not r.url.startswith("blob:") else None,
    )
    context.wrong = wrong
    yield context
    context.close()
    assert not wrong


@pytest.fixture
def page(context, address):
    page = context.new_page()
    page.goto(address)
    Hand(page).wait("studio_page.adjusted")
    return page


@pytest.fixture
def hand(page):
    return Hand(page)


def verbs(project):
    return [e.verb for e in entries_of(journal_path(project))]


def undone(page, press):
    """Take everything back."""
    count = 0
    while page.locator("#undo").is_enabled():
        before = page.locator("#undo").get_attribute("title")
        assert before
        press()
        Hand(page).wait("studio_page.undone")
        page.wait_for_timeout(150)
        count += 1
    return count


def test_measuring_by_mouse(page, hand, project):
    """Two targets in three images each, their distance a scale bar, adjusted; all of it taken back."""
    names = {}
    for target in ("T7", "T8"):
        names[target] = hand.new_point()
        for image in IMAGES:
            hand.click_at(image, *targets()[target][image])
        page.locator(".where .sigma").first.wait_for()
    sigma = [float(t) for t in page.locator(".where .sigma").all_inner_texts()]
    assert all(0 < s < 0.1 for s in sigma)
    assert page.locator(".marks tr").count() == 1 + len(IMAGES)
    page.fill("#bar-start", names["T7"])
    page.fill("#bar-end", names["T8"])
    page.fill("#bar-length", "1.000")
    page.fill("#bar-sigma", "0.001")
    page.click("#bar-add")
    hand.wait("studio_point.bar_given")
    page.click("#adjust")
    hand.wait("studio_page.adjusted", "result")
    assert (project / "result" / "block" / "block.toml").is_file()
    assert undone(page, lambda: page.click("#undo")) == 7
    entries = list(entries_of(journal_path(project)))
    assert [e.verb for e in entries] == ["put"] * 6 + ["bar"] + ["undo"] * 7
    for entry, (target, image) in zip(entries, itertools.product(names, IMAGES), strict=False):
        a = entry.arguments
        assert a["point"] == names[target]
        assert np.hypot(*np.subtract((a["x_px"], a["y_px"]), targets()[target][image])) < 0.3
        assert a["how"] == "ellipse"
        assert a["clicked"] is not None
    assert {k: entries[6].arguments[k] for k in ("start", "end", "length", "sigma")} == {
        "start": names["T7"], "end": names["T8"], "length": 1.0, "sigma": 0.001,
    }  # fmt: skip


def test_measuring_by_keyboard_alone(page, hand, project):
    """The same without a mouse: the cross hair, the prediction of the third image, a step of a tenth of a pixel."""
    keys, names = page.keyboard, {}
    for target in ("T7", "T8"):
        names[target] = hand.new_point()
        for image, way in (("portal_01.jpg", "["), ("portal_02.jpg", "]")):
            while page.locator(".pane.active .name", has_text=image).count() == 0:
                keys.press(way)
            page.locator(".pane.active .canvas:focus").wait_for()
            hand.hair_to(*targets()[target][image])
            keys.press("Enter")
            page.locator(".marks", has_text=image).wait_for()
        page.locator(".where .sigma").first.wait_for()
        keys.press("v")
        page.wait_for_timeout(500)
        keys.press("Enter")
        page.locator(".marks tr").nth(3).wait_for()
    keys.press("Shift+ArrowRight")
    keys.press("Shift+ArrowRight")
    hand.wait("studio_point.moved")
    given = {"start": names["T7"], "end": names["T8"], "length": "1.0", "sigma": "0.001"}
    for field, value in given.items():
        hand.tab_to(f"#bar-{field}")
        keys.type(value)
    keys.press("Enter")
    hand.wait("studio_point.bar_given")
    hand.tab_to("#adjust")
    keys.press("Enter")
    hand.wait("studio_page.adjusted", "result")
    hand.tab_to(".canvas")
    assert undone(page, lambda: keys.press("Control+z")) == 8
    entries = list(entries_of(journal_path(project)))
    assert [e.verb for e in entries] == ["put"] * 6 + ["move", "bar"] + ["undo"] * 8
    last, moved = entries[5].arguments, entries[6].arguments
    assert moved["x_px"] - last["x_px"] == pytest.approx(0.2, abs=1e-6)
    assert moved["y_px"] == pytest.approx(last["y_px"], abs=1e-6)


def test_a_mark_is_dragged_and_removed_an_observation_rejected(page, hand, project):
    page.select_option("#snap", "hand")
    x, y = targets()["T7"]["portal_02.jpg"]
    hand.new_point()
    hand.point_at("portal_02.jpg", x, y)
    hand.click_here()
    page.mouse.down()
    u, v = hand.at
    page.mouse.move(u + 20, v)
    page.mouse.move(u + 41, v)
    page.mouse.up()
    hand.wait("studio_point.moved")
    page.keyboard.press("Delete")
    hand.wait("studio_point.mark_removed")
    page.keyboard.press("Escape")
    page.select_option("#filter", "weak")
    hand.wait("studio_point.mark_removed")
    page.keyboard.press("w")
    hand.wait("studio_point.worst", "|w|")
    worst = page.locator("#point-name").input_value()
    page.select_option("#filter", "all")
    page.locator(".pane.active .canvas").focus()
    page.keyboard.press("x")
    hand.wait("studio_point.rejected")
    page.keyboard.press("x")
    hand.wait("studio_point.accepted")
    entries = list(entries_of(journal_path(project)))
    assert [e.verb for e in entries] == ["put", "move", "remove", "reject", "accept"]
    put, moved, rejected = (entries[k].arguments for k in (0, 1, 3))
    assert np.hypot(put["x_px"] - x, put["y_px"] - y) < hand.fineness
    scale = 41 / (moved["x_px"] - put["x_px"])
    assert 2 < scale < 20
    assert moved["y_px"] == pytest.approx(put["y_px"], abs=0.3)
    assert rejected["point"] == worst


def test_an_answer_that_is_lost_counts_once(page, hand, project):
    """Of three tries the first does not arrive, the second arrives and its answer is lost."""
    tries = []

    def losing(route):
        tries.append(route.request.post_data_json["id"])
        if len(tries) == 1:
            return route.abort()
        if len(tries) == 2:
            route.fetch()
            return route.abort()
        return route.continue_()

    page.route("**/api/action", losing)
    hand.new_point()
    hand.click_at("portal_02.jpg", *targets()["T7"]["portal_02.jpg"])
    assert len(tries) == 3
    assert len(set(tries)) == 1
    assert verbs(project) == ["put"]
    page.context.wrong[:] = [w for w in page.context.wrong if "net::ERR_FAILED" not in w]


def test_a_second_tab_sees_what_the_first_did(page, hand, context, address):
    other = context.new_page()
    other.goto(address.split("?")[0])
    other.locator(".pane .canvas").first.wait_for()
    assert other.locator("#undo").is_disabled()
    page.bring_to_front()
    hand.new_point()
    hand.click_at("portal_02.jpg", *targets()["T7"]["portal_02.jpg"])
    other.locator("#undo:enabled").wait_for()


def test_names_are_shown_never_interpreted(page, hand):
    page.keyboard.press("F2")
    page.keyboard.type(EVIL)
    page.keyboard.press("Enter")
    hand.click_at("portal_02.jpg", *targets()["T7"]["portal_02.jpg"])
    page.locator("[role=option]", has_text=EVIL).first.wait_for()
    page.click("#tab-journal")
    page.locator("#journal", has_text=EVIL).wait_for()
    assert page.locator("img").count() == 0


def test_every_tab_and_control_by_file(page, hand, tmp_path, project):
    """Object space is drawn, tables are sorted and lead to their image, control comes from a table."""
    page.click("#tab-space")
    page.locator("#space canvas").wait_for()
    legend = page.locator("#space-legend")
    legend.filter(has_text=headline("studio_space.role", {"role": "tie"})).wait_for()
    for by in ("sigma", "redundancy", "residual"):
        page.select_option("#space-colour", by)
        legend.filter(has_text=headline("studio_space.up_to", {"by": by, "limit": ""})).wait_for()
    page.check("#show-pairs")
    legend.filter(has_text="≥ 100").wait_for()
    page.select_option("#section-across", "2")
    page.locator("#space-bar output", has_text="±").wait_for()
    page.select_option("#section-across", "points")
    page.locator("#space-bar output", has_text=headline("studio_space.three_points_first", {})).wait_for()
    page.check("#space-measure")
    for name in read_block(project / "result" / "block").points.ids[:3]:
        page.fill("#point-name", name)
        page.keyboard.press("Enter")
        page.get_by_role("button", name=headline("studio_space.add_current", {})).click()
    page.select_option("#space-kind", "length")
    page.locator("#space-status", has_text="length").wait_for()
    page.click("#tab-tables")
    page.select_option("#table-kind", "pairs")
    page.locator("[role=columnheader]", has_text=headline("label.common_points", {})).wait_for()
    page.locator(".rows [role=row]").first.click()
    assert page.locator(".pane").count() == 2
    page.click("#tab-tables")
    for kind in ("pairs", "points", "observations"):  # all columns stand beside each other
        page.select_option("#table-kind", kind)
        page.locator(".rows [role=row]").first.wait_for()
        tops = page.locator("[role=columnheader]").evaluate_all("of => of.map((e) => e.getBoundingClientRect().top)")
        assert max(tops) - min(tops) < 10
    page.get_by_role("button", name="|w|").click()
    page.locator("[role=columnheader][aria-sort=descending]").wait_for()
    page.locator(".rows [role=row]").first.click()
    page.locator("#stage-images:visible").wait_for()
    assert page.locator("#point-name").input_value()
    table = tmp_path / "control.csv"
    table.write_text("point,X,Y,Z,sX,sY,sZ\nA,1,2,3,0.01,0.01,0.02\n", encoding="utf-8")
    page.locator("summary", has_text=headline("studio_point.control", {})).click()
    page.set_input_files("#control-file", table)
    hand.wait("studio_point.control_added", "control.csv")
    assert verbs(project) == ["control"]


@pytest.mark.parametrize("size", SIZES, ids=lambda s: f"{s[0]}x{s[1]}")
def test_nothing_lies_over_another(page, size):
    page.set_viewport_size({"width": size[0], "height": size[1]})
    for tab in ("images", "space", "tables", "journal"):
        page.click(f"#tab-{tab}")
        page.wait_for_timeout(500)
        boxes = {name: page.locator(f"#{name}").bounding_box() for name in ("top", "left", "stage", "right", "bottom")}
        assert sum(b["width"] * b["height"] for b in boxes.values()) == pytest.approx(size[0] * size[1], rel=0.002)
        assert not overlapping(boxes)
        controls = {
            f"{k} {c.inner_text()[:20] or c.get_attribute('id')}": c.bounding_box()
            for k, c in enumerate(page.locator(CONTROLS).all())
        }
        assert not overlapping(controls)
        for box in controls.values():
            assert box["x"] >= 0
            assert box["x"] + box["width"] <= size[0] + 0.5


def overlapping(boxes):
    """Pairs of boxes that share more than a pixel."""
    found = []
    for (a, p), (b, q) in itertools.combinations(boxes.items(), 2):
        wide = min(p["x"] + p["width"], q["x"] + q["width"]) - max(p["x"], q["x"])
        high = min(p["y"] + p["height"], q["y"] + q["height"]) - max(p["y"], q["y"])
        if wide > 1 and high > 1:
            found.append((a, b))
    return found
