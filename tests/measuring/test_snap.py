"""Snapping: clicks agree, stated covariances are true, and nothing jumps."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.errors import InputError
from raybundle.io.photos.photo import find_photos, read_grey
from raybundle.measuring.snap import WINDOWS_PATCH, NotSnapped, Reference, Snapped, snap

from . import pictures

PORTAL = Path(__file__).parents[2] / "demo_data/portal/photos/portal_05.jpg"
MAKE = {
    "ellipse": pictures.ellipse,
    "corner": pictures.corner,
    "cross": pictures.cross,
    "patch": lambda rng: pictures.patch(rng, PORTAL),
}


def snapped(kind, count, seed):
    rng = np.random.default_rng(seed)
    e, C = [], []
    for _ in range(count):
        image, at, reference = MAKE[kind](rng)
        found = snap(image, *pictures.click_near(rng, at), kind, reference)
        if isinstance(found, Snapped):
            xx, yy, xy = found.covariance
            e.append([found.x_px - at[0], found.y_px - at[1]])
            C.append([[xx, xy], [xy, yy]])
    assert len(e) >= 0.9 * count
    return np.array(e), np.array(C)


@pytest.mark.parametrize("kind", MAKE)
def test_stated_covariance_is_true(kind, monkeypatch):
    """Of a patch that of the grey values alone: the picture is plane and its noise white, as no surface's is."""
    monkeypatch.setattr("raybundle.measuring.snap.SURFACE_PX", 0.0)
    monkeypatch.setattr("raybundle.measuring.snap.WINDOWS_PATCH", WINDOWS_PATCH[:1])
    e, C = snapped(kind, 40, seed=5)
    square = np.einsum("ni,nij,nj->n", e, np.linalg.inv(C), e)
    low, high = chi2(2 * len(e)).ppf([0.0005, 0.9995])
    assert low < square.sum() < high


@pytest.mark.parametrize("apart_deg", [90, 65, 40])
def test_corners_of_any_angle_and_blur_have_true_covariances(apart_deg):
    """Edges that do not cross at right angles: the blurred corner is no product of blurred edges."""
    rng, square, freedom = np.random.default_rng(apart_deg), 0.0, 0
    for blur in (0.5, 1.0, 1.8):
        for _ in range(12):
            image, at = pictures.wedges(rng, np.deg2rad(apart_deg), blur)
            found = snap(image, *pictures.click_near(rng, at, 3.0), "corner")
            if isinstance(found, Snapped):
                xx, yy, xy = found.covariance
                e = np.array([found.x_px - at[0], found.y_px - at[1]])
                square += float(e @ np.linalg.solve(np.array([[xx, xy], [xy, yy]]), e))
                freedom += 2
    assert freedom >= 60
    low, high = chi2(freedom).ppf([0.0005, 0.9995])
    assert low < square < high


@pytest.mark.parametrize("kind", MAKE)
def test_ten_clicks_agree(kind):
    rng = np.random.default_rng(3)
    for _ in range(3):
        image, at, reference = MAKE[kind](rng)
        found = [snap(image, *pictures.click_near(rng, at), kind, reference) for _ in range(10)]
        xy = np.array([[f.x_px, f.y_px] for f in found if isinstance(f, Snapped)])
        assert len(xy) >= 9
        assert np.std(xy, axis=0).max() < {"ellipse": 0.02}.get(kind, 0.1)


def test_on_a_photograph_ten_clicks_agree():
    grey = read_grey(find_photos([PORTAL]).photos[0])
    rows = np.genfromtxt(PORTAL.parents[1] / "measured.csv", delimiter=",", dtype=None, encoding="utf-8", skip_header=1)
    rng, targets = np.random.default_rng(0), [r for r in rows if r[0] == PORTAL.name][3:8:2]
    lost = 0
    for _, _, x, y in targets:
        found = [snap(grey, *pictures.click_near(rng, np.array([x, y])), "ellipse") for _ in range(6)]
        if not all(isinstance(f, Snapped) for f in found):  # dots of 2 px radius, some in shadow
            lost += 1
            continue
        xy = np.array([[f.x_px, f.y_px] for f in found])
        assert np.std(xy, axis=0).max() < 0.02
        assert np.hypot(*(xy.mean(axis=0) - [x, y])) < 0.3
    assert lost <= 1


def window(rng, contrast=70.0, texture=3.0):
    """A cross of bars of 1 and 4 px half width before four panes, in the texture of paint; its place."""
    from scipy.ndimage import gaussian_filter
    from scipy.special import erf

    y, x = np.mgrid[:80, :80] + 0.5
    at, turn = 40 + rng.uniform(-0.5, 0.5, 2), rng.uniform(-0.2, 0.2)
    d = [(x - at[0]) * np.cos(turn + a) + (y - at[1]) * np.sin(turn + a) for a in (0, 1.5)]
    B = [(erf((k + h) / 1.2) - erf((k - h) / 1.2)) / 2 for k, h in zip(d, (1.2, 4.0), strict=True)]
    panes = np.choose((d[0] > 0) + 2 * (d[1] > 0), rng.uniform(50, 80, 4))
    bars = 1 - (1 - B[0]) * (1 - B[1])
    image = (
        panes * (1 - bars) + (60 + contrast) * bars + gaussian_filter(rng.normal(0, 1, x.shape), 1.0) * 3.5 * texture
    )
    return np.clip(image, 0, 255).round().astype(np.uint8), at


def test_crosses_of_windows_are_found_and_no_more_precise_than_stated():
    """Bars of unlike width before unlike panes in a texture that neighbours share: no click is refused."""
    rng, square = np.random.default_rng(3), 0.0
    for _ in range(6):
        image, at = window(rng)
        found = snap(image, *pictures.click_near(rng, at, 3.0))
        assert isinstance(found, Snapped), found.why
        assert found.kind == "cross"
        xx, yy, xy = found.covariance
        e = np.array([found.x_px - at[0], found.y_px - at[1]])
        square += float(e @ np.linalg.solve(np.array([[xx, xy], [xy, yy]]), e))
        assert max(xx, yy) < 0.09
    assert square < chi2(12).ppf(0.999)


def test_auto_takes_what_fits():
    rng = np.random.default_rng(8)
    for kind in ("ellipse", "corner"):
        image, at, _ = MAKE[kind](rng)
        found = snap(image, *pictures.click_near(rng, at, 2.0))
        assert found.kind == kind
        assert found.moved_px <= 3
    image, at, reference = MAKE["patch"](rng)
    assert snap(image, *at, "auto", reference).kind == "patch"


def test_auto_takes_what_is_clicked_not_what_is_beside_it():
    """A dot ten pixels from a corner draws no click to it, and what was no dot in the first picture is none."""
    rng = np.random.default_rng(4)
    for _ in range(6):
        image, at = pictures.wedges(rng, np.pi / 2, 0.7)
        y, x = np.mgrid[: image.shape[0], : image.shape[1]] + 0.5
        turn = rng.uniform(0, 2 * np.pi)
        spot = np.hypot(x - at[0] - 10 * np.cos(turn), y - at[1] - 10 * np.sin(turn)) < 3.5
        image = np.where(spot, 255 - image, image)
        found = snap(image, *at)
        assert isinstance(found, NotSnapped) or (found.kind != "ellipse" and found.moved_px < 1)
    image, at, _ = MAKE["ellipse"](rng)
    flat = Reference(grey=np.full((200, 200), 90, np.uint8), x_px=100.0, y_px=100.0)
    assert isinstance(snap(image, *at, "auto", flat), NotSnapped)
    assert snap(image, *at, "auto", replace(flat, kind="ellipse")).kind == "ellipse"


def test_nothing_there_nothing_found():
    flat = np.full((200, 200), 90, np.uint8)
    noise = np.random.default_rng(0).normal(90, 3, (200, 200)).round().astype(np.uint8)
    edge = np.where(np.arange(200) < 100, 40, 160).astype(np.uint8)[None].repeat(200, axis=0)
    reference = Reference(grey=flat, x_px=100.0, y_px=100.0)
    for picture in (flat, noise, edge):
        found = snap(picture, 100.0, 100.0)
        assert isinstance(found, NotSnapped)
        for kind in ("ellipse", "corner", "cross"):
            assert f"{kind}: " in found.why
        assert isinstance(snap(picture, 100.0, 100.0, "auto", reference), NotSnapped)


def test_a_jump_is_refused():
    rng = np.random.default_rng(2)
    image, at, _ = pictures.ellipse(rng)
    far = snap(image, at[0] + 15, at[1], "ellipse", reach_px=1.0)
    assert isinstance(far, NotSnapped)
    assert "px" in far.why
    within = snap(image, at[0] + 5, at[1], "ellipse", reach_px=1.0)  # of the dot: its centre is meant
    np.testing.assert_allclose((within.x_px, within.y_px), at, atol=0.1)
    image, at, _ = pictures.corner(rng)
    assert isinstance(snap(image, at[0] + 5, at[1], "corner", reach_px=2.0), NotSnapped)
    assert snap(image, at[0] + 1, at[1], "corner", reach_px=2.0).moved_px <= 2


def test_two_places_that_look_alike_are_not_chosen_between():
    rng = np.random.default_rng(4)
    tile = rng.integers(0, 255, (7, 7)).astype(np.uint8)
    wall = np.tile(tile, (20, 20))
    found = snap(wall, 70.0, 70.0, "patch", Reference(grey=wall, x_px=70.5, y_px=70.5))
    assert isinstance(found, NotSnapped)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((np.zeros((20, 20)), 1, 1), r"8.*16.*snap\.image_type"),
        ((np.zeros((20, 20), np.uint8), 21, 1), r"20.*snap\.outside"),
        ((np.zeros((20, 20), np.uint8), float("nan"), 1), r"snap\.outside"),
        ((np.zeros((20, 20), np.uint8), 1, 1, "star"), r"snap\.unknown_kind"),
        ((np.zeros((20, 20), np.uint8), 1, 1, "patch"), r"snap\.no_reference"),
    ],
)
def test_bad_input(arguments, words):
    with pytest.raises(InputError, match=words):
        snap(*arguments)


def test_at_the_border_of_a_picture():
    image = np.random.default_rng(1).integers(0, 255, (30, 30)).astype(np.uint8)
    for x, y in ((0.0, 0.0), (30.0, 30.0), (0.0, 15.0)):
        for kind in ("ellipse", "corner", "cross", "auto"):
            found = snap(image, x, y, kind)
            assert isinstance(found, NotSnapped) or found.moved_px <= 12
