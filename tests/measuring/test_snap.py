"""Snapping: clicks agree, stated covariances are true, and nothing jumps."""

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.errors import InputError
from raybundle.io.photos.photo import find_photos, read_grey
from raybundle.measuring.snap import NotSnapped, Reference, Snapped, snap

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
def test_stated_covariance_is_true(kind):
    e, C = snapped(kind, 40, seed=5)
    square = np.einsum("ni,nij,nj->n", e, np.linalg.inv(C), e)
    low, high = chi2(2 * len(e)).ppf([0.0005, 0.9995])
    assert low < square.sum() < high


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


def test_auto_takes_what_fits():
    rng = np.random.default_rng(8)
    for kind in ("ellipse", "corner"):
        image, at, _ = MAKE[kind](rng)
        found = snap(image, *pictures.click_near(rng, at, 2.0))
        assert found.kind == kind
        assert found.moved_px <= 3
    image, at, reference = MAKE["patch"](rng)
    assert snap(image, *at, "auto", reference).kind in {"patch", "ellipse"}


def test_nothing_there_nothing_found():
    flat = np.full((200, 200), 90, np.uint8)
    noise = np.random.default_rng(0).normal(90, 3, (200, 200)).round().astype(np.uint8)
    edge = np.where(np.arange(200) < 100, 40, 160).astype(np.uint8)[None].repeat(200, axis=0)
    reference = Reference(grey=flat, x_px=100.0, y_px=100.0)
    for picture in (flat, noise, edge):
        found = snap(picture, 100.0, 100.0, "auto", reference)
        assert isinstance(found, NotSnapped)
        for kind in ("ellipse", "patch", "corner", "cross"):
            assert f"{kind}: " in found.why


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
        ((np.zeros((20, 20)), 1, 1), "grey pictures have 8 or 16 bits"),
        ((np.zeros((20, 20), np.uint8), 21, 1), "lies outside the picture of 20 x 20 px"),
        ((np.zeros((20, 20), np.uint8), float("nan"), 1), "lies outside"),
        ((np.zeros((20, 20), np.uint8), 1, 1, "star"), "none of ellipse, corner"),
        ((np.zeros((20, 20), np.uint8), 1, 1, "patch"), "mark the point in one first"),
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
