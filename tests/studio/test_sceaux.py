"""A facade of ordinary photographs: new points by mouse and by keyboard, a scale bar, control; all of it taken back.

The places are those of tie points that the orientation found; a click beside one is brought to what is nearest there.
"""

import itertools
import os
from pathlib import Path

import numpy as np
import pytest

from raybundle.commands.orient import orient
from raybundle.measuring.journal import entries_of, journal_path
from raybundle.results.folder import read_result
from tests.studio.browser import ARGUMENTS, Hand, chromium, served

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: the page is not tested here")

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[3] / "shared/data"))
PHOTOS = DATA / "photos/sceaux-castle/images"
SIZE = 2832, 2128
POINTS, RAYS = 3, 3
pytestmark = [
    pytest.mark.data, pytest.mark.bench, pytest.mark.skipif(not PHOTOS.is_dir(), reason=f"{PHOTOS} is absent"),
]  # fmt: skip


@pytest.fixture(scope="module")
def oriented(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sceaux")
    orient([PHOTOS], folder / "project", report=False)
    return folder


@pytest.fixture
def page(project):
    path = chromium()
    if path is None:
        pytest.skip("no Chromium is here (RAYBUNDLE_CHROMIUM may name one): the page is not tested here")
    with served(project, PHOTOS) as address, sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=list(ARGUMENTS))
        page = browser.new_page(viewport={"width": 1366, "height": 768})
        page.set_default_timeout(60_000)
        page.goto(address)
        Hand(page).wait("Adjusted")
        yield page
        browser.close()


@pytest.fixture
def spots(project):
    """Places [px] of tie points far apart in one triple of photographs, and their coordinates."""
    block = read_result(project / "result").block
    o, names = block.observations, block.images.ids
    seen = np.zeros((len(block.points), len(names)), bool)
    seen[o.point, o.image] = True
    triple = max(itertools.combinations(range(len(names)), RAYS), key=lambda t: seen[:, t].all(axis=1).sum())
    common = np.flatnonzero(seen[:, triple].all(axis=1))
    chosen = [int(common[0])]
    while len(chosen) < POINTS:  # the one farthest from all that are chosen
        apart = np.linalg.norm(block.points.xyz[common, None] - block.points.xyz[None, chosen], axis=2).min(axis=1)
        chosen.append(int(common[np.argmax(apart)]))

    def place(point, image):
        return tuple(o.xy_px[(o.point == point) & (o.image == image)][0].tolist())

    return [({names[i]: place(p, i) for i in triple}, block.points.xyz[p]) for p in chosen]


def number(value):
    return repr(float(value))


def measured_by_mouse(page, hand, places):
    hand.new_point()
    for image, (x, y) in places.items():
        hand.click_at(image, x + 0.4, y - 0.3)


def measured_by_keys(page, hand, places):
    hand.new_point()
    for image, (x, y) in places.items():
        for _ in range(20):
            if page.locator(".pane.active .name", has_text=image).count():
                break
            page.keyboard.press("]")
        page.locator(".pane.active .canvas:focus").wait_for()
        hand.hair_to(x, y)
        page.keyboard.press("Enter")
        page.locator(".marks", has_text=image).wait_for()


def pressed_by_mouse(page, _, what):
    page.click(what)


def pressed_by_keys(page, hand, what):
    hand.tab_to(what)
    page.keyboard.press("Enter")


def given_by_mouse(page, hand, values, deed):
    for field, value in values.items():
        if field.endswith("role"):
            page.select_option(f"#{field}", value)
        else:
            page.fill(f"#{field}", value)
    pressed_by_mouse(page, hand, deed)


def given_by_keys(page, hand, values, deed):
    for field, value in values.items():
        hand.tab_to(f"#{field}")
        page.keyboard.press("Control+a")
        page.keyboard.type(value)
    pressed_by_keys(page, hand, deed)


@pytest.mark.parametrize(
    ("measured", "given", "pressed"),
    [
        (measured_by_mouse, given_by_mouse, pressed_by_mouse),
        (measured_by_keys, given_by_keys, pressed_by_keys),
    ],
    ids=["mouse", "keyboard"],
)
def test_points_a_bar_and_control_on_a_facade(page, project, spots, measured, given, pressed):
    hand = Hand(page, SIZE)
    names = []
    for places, _ in spots:
        measured(page, hand, places)
        names.append(page.locator("#point-name").input_value())
        page.locator(".where .sigma").first.wait_for()
        assert all(float(t) > 0 for t in page.locator(".where .sigma").all_inner_texts())
        assert f"{RAYS} rays" in page.locator("#right").inner_text()
    length = float(np.linalg.norm(spots[1][1] - spots[0][1]))
    bar = {"start": names[0], "end": names[1], "length": length, "sigma": length / 1000}
    told = {f"bar-{k}": v if isinstance(v, str) else number(v) for k, v in bar.items()}
    given(page, hand, told, "#bar-add")
    hand.wait("scale bar")
    pressed(page, hand, "summary:has-text('Control')")
    for name, (_, xyz) in reversed([*zip(names, spots, strict=True)]):  # the last is the current one
        page.locator("[role=option]", has_text=name).first.click() if measured is measured_by_mouse else chosen(
            page, hand, name
        )
        values = {"control-role": "control", **{f"control-{a}": number(v) for a, v in zip("XYZ", xyz, strict=True)}}
        values |= {f"control-s{a}": number(length / 1000) for a in "XYZ"}
        given(page, hand, values, "#control-give")
        hand.wait(f"{name}: control")
    pressed(page, hand, "#adjust")
    hand.wait("Adjusted: sigma0", 120)
    adjusted = read_result(project / "result")
    roles = dict(zip(adjusted.block.points.ids, np.asarray(adjusted.block.points.role).tolist(), strict=True))
    assert [roles[n] for n in names] == [1, 1, 1]
    of = adjusted.observations.text
    kept = [p for p, rejected in zip(of["point"], of["rejected"], strict=True) if p in names and not rejected]
    assert len(kept) == POINTS * RAYS, "snapped to the same spot in each photograph"
    count = 0
    while page.locator("#undo").is_enabled():
        pressed(page, hand, "#undo")
        page.locator("#message", has_text="taken back").wait_for()
        page.wait_for_timeout(150)
        count += 1
    deeds = ["put"] * POINTS * RAYS + ["bar"] + ["point"] * POINTS
    assert count == len(deeds)
    entries = list(entries_of(journal_path(project)))
    assert [e.verb for e in entries] == deeds + ["undo"] * count
    at = iter(entries)
    for name, (places, _) in zip(names, spots, strict=True):
        for image, place in places.items():
            a = next(at).arguments
            assert (a["point"], a["image"]) == (name, image)
            assert np.hypot(a["x_px"] - place[0], a["y_px"] - place[1]) < 5
            assert a["clicked"] is not None
    assert next(at).arguments.items() >= bar.items()
    for name, (_, xyz) in reversed([*zip(names, spots, strict=True)]):
        a = next(at).arguments
        assert (a["point"], a["role"]) == (name, "control")
        np.testing.assert_allclose(a["xyz"], xyz, rtol=1e-12)


def chosen(page, hand, name):
    """A point chosen with keys alone: its name typed where the current one stands."""
    page.keyboard.press("F2")
    page.keyboard.press("Control+a")
    page.keyboard.type(name)
    page.keyboard.press("Enter")
