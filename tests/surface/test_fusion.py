"""Depth maps against each other: a plane seen by three photographs of a flight."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import KDTree

from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.surfaces.depths.fusion import MapView, agreement, by_contrast
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid
from raybundle.surfaces.depths.transfer import transfer

IMAGES, STRIDE, SIGMA = (3, 4, 5), 250, 1e-7


@pytest.fixture(scope="module")
def block():
    return simulate(aerial_scene(AerialStrips(images_per_strip=7, points_per_image=40)), Survey(seed=3)).truth


def plane_map(block, image, rng, height=0.0):
    """A map of a level plane with noise of the standard deviation that it states."""
    rays = ReferenceRays.of(block, image)
    rows, columns = (n // STRIDE for n in (rays.camera.height_px, rays.camera.width_px))
    grid = PixelGrid(x0=STRIDE // 2, y0=STRIDE // 2, stride=STRIDE, rows=rows, columns=columns)
    empty = np.zeros((rows, columns))
    made = MapView(rays=rays, grid=grid, t=empty, slopes=np.zeros((2, rows, columns)), sigma=empty + SIGMA)
    xy = made.grid.xy_px.reshape(-1, 2)

    def exact(at):
        origin, direction = rays.rays(at)
        return direction[:, 2] / (height - origin[:, 2])

    t = exact(xy)
    slopes = [(exact(xy + d) - exact(xy - d)) / 2 for d in ([1.0, 0.0], [0.0, 1.0])]
    noisy = (t + rng.normal(0, SIGMA, len(t))).reshape(rows, columns)
    return MapView(
        rays=rays, grid=grid, t=noisy, sigma=empty + SIGMA,
        slopes=np.array(slopes).reshape(2, rows, columns),
    )  # fmt: skip


@pytest.fixture(scope="module")
def maps(block):
    rng = np.random.default_rng(1)
    return {i: plane_map(block, i, rng) for i in IMAGES}


def compared(block, maps, k, mine=None, apart=()):
    others = [i for i in IMAGES if i != k]
    mine = mine or maps[k]
    low, high = np.nanmin(mine.t) * 0.9, np.nanmax(mine.t) * 1.1
    tables = [transfer(block, mine.rays, i, (low, high)) for i in others]
    views = [replace(maps[i], apart=off) for i, off in zip(others, apart or [0.0] * len(others), strict=True)]
    return agreement(mine, views, tables, others, own=k)


def test_maps_of_one_plane_agree_as_often_as_chance_says(block, maps):
    found = compared(block, maps, 4)
    seen = found.agree + found.against + found.behind
    assert (seen == 2).mean() > 0.15
    assert (seen == 0).mean() < 0.3
    wrong = (found.against.sum() + found.behind.sum()) / seen.sum()
    assert wrong < 0.01  # three standard deviations: 0.3 %


def test_of_estimates_that_agree_one_is_kept(block, maps):
    found = {k: compared(block, maps, k) for k in IMAGES}
    xyz = {k: maps[k].rays.points(maps[k].grid.xy_px.reshape(-1, 2), maps[k].t.ravel()) for k in IMAGES}
    confirmed = sum(int((f.agree > f.against).sum()) for f in found.values())
    kept = np.concatenate([xyz[k][f.kept] for k, f in found.items()])
    assert 0.3 < len(kept) / confirmed < 0.6  # two or three maps see each place
    dropped = np.concatenate([xyz[k][(f.agree > f.against) & ~f.best] for k, f in found.items()])
    pixel = np.linalg.norm(xyz[3][1] - xyz[3][0])
    near, _ = KDTree(kept[:, :2]).query(dropped[:, :2])
    assert np.quantile(near, 0.99) < 2 * pixel


def test_a_point_that_others_see_through_is_not_kept(block, maps):
    k = 4
    mine = maps[k]
    t = mine.t.copy()
    t[5:8, 10:14] *= 1.02  # stands before the plane by a fiftieth of the distance
    t[12, 20] *= 0.98  # lies behind it
    shifted = MapView(rays=mine.rays, grid=mine.grid, t=t, slopes=mine.slopes, sigma=mine.sigma)
    found = compared(block, maps, k, shifted)

    def of(a):
        return a.reshape(t.shape)

    assert of(found.against)[5:8, 10:14].sum() > 0
    assert not of(found.kept)[5:8, 10:14].any()
    assert of(found.agree)[5:8, 10:14].sum() == 0
    assert of(found.behind)[12, 20] > 0
    assert of(found.against)[12, 20] == 0


def test_pixels_without_a_depth_say_nothing(block, maps):
    k, mine = 4, maps[4]
    t = mine.t.copy()
    t[::2] = np.nan
    half = MapView(rays=mine.rays, grid=mine.grid, t=t, slopes=mine.slopes, sigma=mine.sigma)
    assert len(compared(block, maps, k, half).agree) == np.isfinite(t).sum()
    away = {**maps, 5: half}
    assert compared(block, away, 3).agree.sum() < compared(block, maps, 3).agree.sum()


def test_only_what_orientation_gives_to_one_map_alone_excuses_a_difference(block, maps):
    mine = maps[4]
    # all parts are large, as of scenes whose common position is hardly known: nothing follows for the difference
    off = replace(mine, t=mine.t + 10 * SIGMA, whole=mine.sigma + 1000 * SIGMA)
    assert compared(block, maps, 4, off).agree.sum() < 0.05 * compared(block, maps, 4).agree.sum()
    excused = compared(block, maps, 4, off, apart=[5 * SIGMA, 5 * SIGMA])
    assert excused.agree.sum() > 0.8 * compared(block, maps, 4).agree.sum()
    # but the best is who knows a place best, all in all
    assert not excused.best[excused.agree > 0].any()


def test_a_doubtful_depth_stays_where_two_others_see_the_same_and_says_nothing_of_sure_ones(block, maps):
    mine = replace(maps[4], doubtful=np.ones(maps[4].t.shape, bool))
    found = compared(block, maps, 4, mine)
    twice = found.agree == 2
    assert 0.05 < twice.mean() < 0.9
    assert (found.kept <= twice).all()
    assert not found.confirmed(np.ones(len(twice), bool))  # of sure depths there is none
    assert found.confirming[twice].min() == 2
    # seen through by one of them, it goes
    low = plane_map(block, 3, np.random.default_rng(2), height=-0.5)
    through = compared(block, {**maps, 3: low}, 4, mine)
    assert (through.against > 0).sum() > 0.1 * len(twice)
    assert not through.kept[through.against > 0].any()
    # doubtful ones of another map neither confirm a sure one, nor speak against it, nor take its place
    others = {k: replace(m, doubtful=np.ones(m.t.shape, bool)) for k, m in maps.items()}
    sure = compared(block, others, 4, maps[4])
    assert not (sure.agree + sure.against).any()
    assert sure.perhaps_agree.any()
    assert sure.best.all()
    assert not sure.kept.any()


def test_differences_of_maps_are_given_in_their_standard_deviations(block, maps):
    found = compared(block, maps, 4)
    known = np.isfinite(found.scatter)
    assert known.mean() > 0.5
    assert np.median(found.scatter[known] ** 2) / 0.4549 == pytest.approx(1, abs=0.15)
    # alike errors differ by less: the same difference is more of what it may be
    alike = {k: replace(m, correlation=0.36) for k, m in maps.items()}
    assert np.allclose(compared(block, alike, 4).scatter[known], found.scatter[known] / 0.8, rtol=1e-5)


def test_where_maps_differ_by_more_than_they_state_their_points_are_worse():
    rng = np.random.default_rng(4)
    contrast = rng.uniform(1, 30, 40_000).astype(np.float32)
    off = np.where(contrast < 4, 2.0, 1.0)
    scatter = (off * rng.normal(size=len(contrast))).astype(np.float32)
    scatter[::3] = np.nan  # seen by no other map
    found = by_contrast(scatter, contrast)
    assert np.median(found[contrast < 3]) == pytest.approx(4, rel=0.15)
    assert np.median(found[contrast > 8]) == pytest.approx(1, abs=0.06)
    assert found.min() >= 1
    assert (by_contrast(scatter[:140], contrast[:140]) == 1).all()  # too few to tell
    assert (by_contrast(0.5 * scatter, contrast)[contrast > 8] == 1).all()  # never better than by theory
    few = np.concatenate([np.arange(400), np.flatnonzero(contrast > 5)])  # a small part of weak texture
    contrast[:400] = rng.uniform(1, 2, 400)
    scatter[:400] = 2 * rng.normal(size=400)
    assert np.median(by_contrast(scatter[few], contrast[few])[:400]) == pytest.approx(4, rel=0.3)
