"""Tracks measured again: references, affine maps to begin with, and points at their true places."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from raybundle.matching import refine
from raybundle.matching.refine import (
    NEIGHBOURS_FROM,
    Candidates,
    TrackPoints,
    choose_references,
    local_affine,
    match_candidates,
    pyramid,
    refine_tracks,
    similarity,
    smoothed,
)
from tests.matching.scenes import Texture, noisy

AFFINE = np.array([[0.94, 0.06], [-0.08, 1.03]])
MOVE = np.array([12.0, -7.5])


def points(image, point, xy, scale=None, angle=None):
    m = len(image)
    return TrackPoints(
        image=np.asarray(image, np.int32), point=np.asarray(point, np.int32), xy_px=np.asarray(xy, float),
        scale_px=np.ones(m) if scale is None else np.asarray(scale, float),
        angle=np.zeros(m) if angle is None else np.asarray(angle, float),
    )  # fmt: skip


def test_the_reference_of_a_track_is_its_largest_feature():
    p = points([0, 1, 2, 0, 1], [0, 0, 0, 1, 1], np.zeros((5, 2)), scale=[2.0, 5.0, 3.0, 4.0, 4.0])
    assert choose_references(p).tolist() == [1, 1, 1, 3, 3]


def test_the_affine_map_of_the_surroundings_is_exact_on_a_plane():
    rng = np.random.default_rng(1)
    p, at = rng.uniform(0, 1000, (2, 60, 2))
    found = local_affine(p, p @ AFFINE.T + MOVE, at)
    np.testing.assert_allclose(found, np.tile(AFFINE, (60, 1, 1)), atol=1e-4)


def test_the_affine_map_of_the_surroundings_follows_the_place():
    rng = np.random.default_rng(2)
    p = rng.uniform(0, 1000, (400, 2))
    left = p[:, :1] < 500
    q = np.where(left, p, p @ AFFINE.T)
    found = local_affine(p, q, np.array([[150.0, 500.0], [850.0, 500.0]]))
    np.testing.assert_allclose(found, [np.eye(2), AFFINE], atol=1e-4)


@pytest.mark.parametrize("line", [False, True])
def test_points_on_a_line_or_at_one_place_give_numbers(line):
    p = np.stack([np.arange(15.0), 2 * np.arange(15.0)], axis=1) if line else np.full((15, 2), 4.0)
    assert np.isfinite(local_affine(p, p + 3, np.array([[7.0, 3.0]]))).all()


def test_the_similarity_of_two_features_is_their_scale_and_turn():
    p = points([0, 1], [0, 0], np.zeros((2, 2)), scale=[2.0, 3.0], angle=[0.4, 1.3])
    (found,) = similarity(p, np.array([0]), np.array([1]))
    c, s = 1.5 * np.cos(0.9), 1.5 * np.sin(0.9)
    np.testing.assert_allclose(found, [[c, -s], [s, c]], atol=1e-12)


def test_smoothing_keeps_level_and_bits():
    rng = np.random.default_rng(3)
    eight = rng.integers(0, 256, (60, 80), dtype=np.uint8)
    sixteen = eight.astype(np.uint16) * 256
    np.testing.assert_array_equal(smoothed(eight), smoothed(sixteen))
    assert smoothed(eight).dtype == np.uint16
    assert smoothed(eight).mean() == pytest.approx(sixteen.mean(), rel=1e-2)
    assert smoothed(np.full((30, 30), 255, np.uint8)).max() <= 65535


@pytest.fixture(scope="module")
def three():
    """Three pictures of one texture and the true places of points in them."""
    texture = Texture(9)
    maps = [(np.eye(2), np.zeros(2)), (AFFINE, MOVE), (np.linalg.inv(AFFINE), np.array([-4.2, 9.1]))]
    images = [
        smoothed(texture.image(360, 320, lambda xy, A=A, t=t: (xy - t) @ np.linalg.inv(A).T)) for A, t in maps
    ]  # fmt: skip
    x, y = np.meshgrid(np.arange(70.5, 290, 24), np.arange(70.5, 250, 24))
    xy = np.stack([x.ravel(), y.ravel()], axis=1)
    return images, [xy @ A.T + t for A, t in maps]


def levels(images):
    """Pictures by number and level of their pyramid."""
    held = [pyramid(image) for image in images]
    return lambda i, level: held[i][level]


def tracks(places, noise, seed=1):
    n = len(places[0])
    image, point = np.repeat(np.arange(3), n), np.tile(np.arange(n), 3)
    true = np.concatenate(places)
    xy = true + np.random.default_rng(seed).normal(0, noise, true.shape)
    scale = np.repeat([3.0, 2.0, 2.5], n)
    return points(image, point, xy, scale=scale), true


def test_tracks_are_measured_again_ten_times_better(three):
    images, places = three
    p, _ = tracks(places, 0.4)
    r = refine_tracks(p, partial(match_candidates, image=levels(images), threads=2))
    n = len(places[0])
    assert r.reference[:n].mean() > 0.97
    assert not r.reference[n:].any()
    assert r.measured.mean() > 0.95
    np.testing.assert_array_equal(r.xy_px[r.reference], p.xy_px[r.reference])
    assert not r.cov_px2[r.reference].any()
    assert (r.correlation[r.reference] == 1).all()
    # the reference is what it is; the others are at the places that correspond to it
    for k, (A, t) in enumerate([(AFFINE, MOVE), (np.linalg.inv(AFFINE), np.array([-4.2, 9.1]))], start=1):
        rows = np.arange(k * n, (k + 1) * n)
        good = r.measured[rows]
        error = (r.xy_px[rows] - (p.xy_px[:n] @ A.T + t))[good]
        assert np.sqrt((error**2).mean()) < 0.03
        assert np.sqrt(((p.xy_px[rows] - places[k]) ** 2).mean()) > 0.3
        assert (r.cov_px2[rows][good][:, :2] > 0).all()


def test_the_number_of_threads_changes_nothing(three):
    images, places = three
    p, _ = tracks(places, 0.3)
    a, b = (refine_tracks(p, partial(match_candidates, image=levels(images), threads=k)) for k in (1, 3))
    for name in ("xy_px", "cov_px2", "measured", "reference", "correlation", "level"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name))


def test_what_shows_something_else_is_not_measured(three):
    images, places = three
    other = smoothed(Texture(77).image(360, 320))
    p, _ = tracks(places, 0.2)
    r = refine_tracks(p, partial(match_candidates, image=levels([images[0], images[1], other])))
    n = len(places[0])
    assert r.measured[:n].mean() > 0.95
    assert r.measured[2 * n :].mean() < 0.05
    np.testing.assert_array_equal(r.xy_px[2 * n :][~r.measured[2 * n :]], p.xy_px[2 * n :][~r.measured[2 * n :]])


def test_points_are_found_where_no_feature_was(three):
    images, places = three
    n = len(places[0])
    seen = np.arange(n) % 3 > 0  # in the second image two thirds are known; at least so many tell the affine map
    assert seen.sum() >= NEIGHBOURS_FROM
    image = np.concatenate([np.zeros(n), np.ones(seen.sum())])
    point = np.concatenate([np.arange(n), np.flatnonzero(seen)])
    p = points(image, point, np.concatenate([places[0], places[1][seen]]))
    hidden = np.flatnonzero(~seen)
    begin = places[1][hidden] + np.random.default_rng(5).uniform(-1, 1, (len(hidden), 2))
    c = Candidates(
        reference=hidden, image=np.ones(len(hidden), np.int32), point=hidden, xy_px=begin, row=np.full(len(hidden), -1)
    )
    m = match_candidates(p, c, levels(images))
    assert m.good.mean() > 0.95
    assert np.abs(m.xy_px - places[1][hidden])[m.good].max() < 0.05


def test_no_candidates_and_unknown_surroundings_give_nothing(three):
    images, places = three
    p = points([0, 1], [0, 0], [places[0][0], places[1][0]])
    none = np.zeros(0, np.int64)
    c = Candidates(reference=none, image=none, point=none, xy_px=np.zeros((0, 2)), row=none)
    assert len(match_candidates(p, c, levels(images)).good) == 0
    one = Candidates(
        reference=np.array([0]), image=np.array([1]), point=np.array([0]), xy_px=places[1][:1], row=np.array([-1])
    )
    assert not match_candidates(p, one, levels(images)).good.any()


def soft(image, blur, noise, seed):
    """The same picture out of focus and with noise of its grey values, smoothed as every picture is before matching."""
    import cv2

    wide = cv2.GaussianBlur(image.astype(np.float32), (0, 0), blur)
    return smoothed(np.clip(noisy(wide, noise, seed), 0, 65535).astype(np.uint16))


def test_a_level_of_the_pyramid_shows_the_same_place_at_half_the_coordinates():
    image = np.zeros((203, 301), np.uint16)
    image[96:104, 152:160] = 60000
    for step, level in enumerate(pyramid(image)):
        assert level.shape == (203 >> step, 301 >> step)
        y, x = np.indices(level.shape) + 0.5
        at = np.array([(x * level).sum(), (y * level).sum()]) / level.sum(dtype=float)
        np.testing.assert_allclose(at * 2**step, [156, 100], atol=0.01)
    assert all(a.size == 0 for a in pyramid(image[:1])[1:])


@pytest.mark.parametrize(("blur", "noise"), [(0.7, 100), (0.7, 900), (3.0, 300), (3.0, 2000), (5.0, 900), (5.0, 2000)])
def test_however_soft_and_noisy_points_are_measured_and_the_covariance_is_true(monkeypatch, blur, noise):
    texture = Texture(9, waves=80, longest=90.0)
    images = [
        soft(texture.image(500, 480), blur, noise, 1),
        soft(texture.image(500, 480, lambda xy: (xy - MOVE) @ np.linalg.inv(AFFINE).T), blur, noise, 2),
    ]
    x, y = np.meshgrid(np.arange(70.5, 430, 24), np.arange(70.5, 410, 24))
    xy = np.stack([x.ravel(), y.ravel()], axis=1)
    n, true = len(xy), xy @ AFFINE.T + MOVE
    begin = true + np.random.default_rng(0).normal(0, 0.4, true.shape)
    p = points(np.repeat([0, 1], n), np.tile(np.arange(n), 2), np.vstack([xy, begin]), scale=np.repeat([3.0, 2.0], n))
    r = refine_tracks(p, partial(match_candidates, image=levels(images)))
    assert r.measured.mean() > 0.97
    chi2 = ((r.xy_px - np.vstack([xy, true])) ** 2 / np.maximum(r.cov_px2[:, :2], 1e-12))[n:][r.measured[n:]]
    assert 0.3 < np.median(chi2) / 0.455 < 3.2  # of first-order covariances at full size: up to 30
    assert 0.3 < chi2.mean() < 3.2
    if blur > 1:
        assert np.median(r.level[n:]) >= 1
        monkeypatch.setattr(refine, "LEVELS", 1)
        fine = refine_tracks(p, partial(match_candidates, image=levels(images)))
        error = [np.sqrt(((f.xy_px[n:] - true) ** 2)[f.measured[n:]].mean()) for f in (r, fine)]
        assert fine.measured[n:].mean() < 0.9 or error[0] < 0.7 * error[1]


def test_candidates_are_looked_for_up_to_the_level_that_is_asked_for(three):
    images, places = three
    flat = [smoothed(soft(image, 6.0, 1500.0, k)) for k, image in enumerate(images[:2])]
    n = len(places[0])
    p = points(np.repeat([0, 1], n), np.tile(np.arange(n), 2), np.vstack(places[:2]))
    c = Candidates(
        reference=np.arange(n), image=np.ones(n, np.int32), point=np.arange(n), xy_px=places[1], row=n + np.arange(n)
    )
    found = [
        match_candidates(p, replace(c, coarsest=coarsest), levels(flat))
        for coarsest in (None, np.full(n, 3), np.zeros(n, int))
    ]
    np.testing.assert_array_equal(found[0].level, found[1].level)
    assert found[0].level[found[0].good].max() > 0
    assert not found[2].level[found[2].good].any()
