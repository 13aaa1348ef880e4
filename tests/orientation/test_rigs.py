"""Rigs from rough approximate values and from none: counted by station, mounted by their single images."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.blunders.behind_cameras import meeting_before_cameras
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system import defects
from raybundle.block import Role
from raybundle.block.rigs import with_shared_orientation, without_rigs
from raybundle.block.select import select_block
from raybundle.errors import RankDefect
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.orientation.rays import angular_residuals, rays_of
from raybundle.orientation.rigs.pose import Common, StationRays, joined_by_stations, resected_station
from tests.orientation.rig_blocks import MOUNTING, RIGS, rig_block, rough
from tests.truth.mixed_blocks import two_camera_rig

OPTIONS = AdjustmentOptions(jobs=1, statistics=False, tolerance=1e-9)
NAN = float("nan")


def assert_same(result, truth):
    """All observations take part, and all values are the same."""
    assert result.image_observations.used.all()
    assert result.sigma0 == pytest.approx(truth.sigma0, rel=1e-6)
    for a, b in (
        (result.adjusted.points.xyz, truth.adjusted.points.xyz),
        (result.adjusted.images.centre, truth.adjusted.images.centre),
        (result.adjusted.images.rotation, truth.adjusted.images.rotation),
    ):
        assert np.abs(a - b).max() < 6e-6


@pytest.mark.parametrize("kind", RIGS)
def test_a_rig_of_which_nothing_is_known_ends_where_it_does_from_the_truth(kind):
    block = rig_block(kind, 5)
    start = rough(block, 5, centre=NAN, degrees=0.0, points=None, mounting="unknown")
    assert_same(adjust(start, OPTIONS), adjust(block, OPTIONS))


@pytest.mark.parametrize(("centre", "degrees"), [(0.05, 1.5), (0.2, 5.0)])
def test_rough_stations_lose_no_points(centre, degrees):
    block = rig_block("six", 4)
    start = rough(block, 4, centre=centre, degrees=degrees, points=None, mounting="near")
    assert_same(adjust(start, OPTIONS), adjust(block, OPTIONS))


def test_cameras_that_share_no_points_are_joined_by_their_stations():
    block = rig_block("back to back", 3, turn=0.5, stations=14, control=6, points=200)
    o, p = block.observations, len(block.points)
    by_first, by_second = (np.bincount(o.point[block.images.camera[o.image] == k], minlength=p) > 0 for k in (0, 1))
    rays = np.bincount(o.point, minlength=p)
    kept = (by_first != by_second) & (rays > 1)
    control = np.isin(np.arange(p), np.flatnonzero(kept & by_first)[::8])
    role = np.where(control, Role.CONTROL, Role.TIE).astype(np.int32)
    sigma = np.where(control[:, None], 0.001, np.full((p, 3), np.nan))
    block = select_block(replace(block, points=replace(block.points, role=role, sigma=sigma)), "point", kept)
    assert len(defects.components(replace(block, images=replace(block.images, station=None)), no_rows(block))) == 2
    assert len(defects.components(block, no_rows(block))) == 1
    start = rough(block, 3, centre=NAN, degrees=0.0, points=None, mounting="unknown")
    assert_same(adjust(start, OPTIONS), adjust(block, OPTIONS))


def test_a_calibrated_base_gives_a_free_rig_its_scale():
    block = rig_block("pair", 2, control=0, free=())
    start = rough(block, 2, centre=NAN, degrees=0.0, points=None, mounting="true")
    result = adjust(start, OPTIONS)
    truth = adjust(block, OPTIONS)
    assert result.image_observations.used.all()
    assert result.sigma0 == pytest.approx(truth.sigma0, rel=1e-6)
    centres = [np.unique(r.adjusted.images.centre, axis=0) for r in (result, truth)]
    size = [np.linalg.norm(c - c.mean(axis=0), axis=1).sum() for c in centres]
    assert size[0] == pytest.approx(size[1], rel=1e-4)


def no_rows(block):
    """(m,) no image observation."""
    return np.zeros(len(block.observations), bool)


def thinned(block, image, count):
    """The block of which an image has this many image points."""
    o = block.observations
    out = np.flatnonzero(o.image == image)[count:]
    return replace(block, observations=o.rows(np.setdiff1d(np.arange(len(o)), out)))


def test_image_points_are_counted_by_station():
    block = two_camera_rig()
    enough = thinned(block, 3, 2)
    defects.check_images(enough, no_rows(enough), {})
    assert adjust(enough, OPTIONS).converged
    few = thinned(thinned(block, 3, 1), 2, 1)
    with pytest.raises(RankDefect, match=r"3.*4.*image\.too_few_points") as error:
        defects.check_images(few, no_rows(few), {})
    assert [u.name for u in error.value.undetermined] == ["3", "4"]


def test_an_image_without_points_has_the_orientation_of_its_station():
    block = thinned(two_camera_rig(), 3, 0)
    moved = replace(block, images=replace(block.images, centre=block.images.centre + 0.02))
    adjusted = adjust(moved, OPTIONS).adjusted.images
    np.testing.assert_array_equal(adjusted.centre[3], adjusted.centre[2])
    np.testing.assert_array_equal(adjusted.rotation[3], adjusted.rotation[2])


def test_an_orientation_is_given_once_a_station():
    block = two_camera_rig()
    centre, rotation = block.images.centre.copy(), block.images.rotation.copy()
    centre[1::2], rotation[1::2] = np.nan, np.nan
    start = replace(block, images=replace(block.images, centre=centre, rotation=rotation))
    np.testing.assert_array_equal(with_shared_orientation(start).images.centre, block.images.centre)
    assert_same(adjust(start, OPTIONS), adjust(block, OPTIONS))


def test_one_station_of_a_calibrated_pair_is_adjusted():
    block = two_camera_rig()
    rows = np.flatnonzero(block.observations.image < 2)
    cameras = tuple(replace(c, estimate=()) for c in block.cameras)
    block = replace(block, cameras=cameras, observations=block.observations.rows(rows))
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    block = select_block(select_block(block, "point", rays > 1), "image", np.arange(len(block.images)) < 2)
    assert adjust(block, OPTIONS).converged


def test_each_image_by_itself_sees_what_its_rig_sees():
    block = rig_block("six", 1, noise=False)
    alone = without_rigs(block)
    o, rays = alone.observations, rays_of(alone)
    angle = angular_residuals(
        alone.images.rotation[o.image], alone.images.centre[o.image], alone.points.xyz[o.point], rays.direction
    )
    assert alone.images.station is None
    assert angle.max() < 1e-9
    assert not any(s in c.values for c in alone.cameras for s in MOUNTING)


def test_points_behind_their_cameras_are_found_before_them():
    block = rig_block("pair", 1, noise=False)
    o = block.observations
    count = np.bincount(o.point, minlength=len(block.points))
    chosen = np.argsort(-count)[:3]
    xyz = block.points.xyz.copy()
    xyz[chosen] = 40 - xyz[chosen]
    rows = np.flatnonzero(np.isin(o.point, chosen))
    points, found = meeting_before_cameras(replace(block, points=replace(block.points, xyz=xyz)), rows, 4.0)
    assert set(points) == set(chosen)
    assert np.abs(found - block.points.xyz[points]).max() < 1e-6
    wrong = o.xy_px.copy()
    wrong[rows[o.point[rows] == chosen[0]][0]] += 200.0
    left, _ = meeting_before_cameras(replace(block, observations=replace(o, xy_px=wrong)), rows, 4.0)
    assert set(left) == set(chosen[1:])


def turned(rng, count, axes):
    return rotation_from_vector(rng.normal(0, 0.4, (count, 3)) * axes)


def test_systems_are_joined_over_stations():
    rng = np.random.default_rng(2)
    M, b = rotation_from_vector(np.array([0.2, 2.8, 0.1])), np.array([0.1, -0.05, 0.2])
    S, s, t = rotation_from_vector(np.array([0.5, -1.0, 0.3])), 2.5, np.array([3.0, 4.0, -1.0])

    def commons(axes):
        found = []
        for swapped in (False, True):
            R, C = turned(rng, 5, axes), rng.uniform(-3, 3, (5, 3))
            Q, c = M @ R, C + np.einsum("nji,j->ni", R, b)
            brought = (R, C) if swapped else (Q, c)
            there = brought[0] @ S, (brought[1] - t) @ S / s
            first, second = (there, (Q, c)) if swapped else ((R, C), there)
            found.append(Common(rotation=first[0], centre=first[1], other_rotation=second[0], other_centre=second[1]))
        return found

    joined = joined_by_stations(*commons([1.0, 1.0, 1.0]), None, scaled=False)
    assert joined is not None
    assert joined.scale == pytest.approx(s, rel=1e-6)
    assert np.abs(joined.rotation - S).max() < 1e-6
    assert np.abs(joined.translation - t).max() < 1e-5
    flat = commons([0.0, 0.0, 1.0])
    assert joined_by_stations(*flat, None, scaled=False) is None
    known = joined_by_stations(*flat, (M, b), scaled=False)
    assert known is not None
    assert np.abs(known.rotation - S).max() < 1e-6


def test_a_station_is_resected_by_the_rays_of_all_its_cameras():
    rng = np.random.default_rng(4)
    R, C = rotation_from_vector(np.array([0.4, -0.2, 1.0])), np.array([1.0, 2.0, 1.5])
    origin = np.repeat([[0.0, 0.0, 0.0], [0.3, 0.0, 0.1], [0.0, 0.2, -0.1]], 4, axis=0)
    xyz = rng.uniform(-3, 3, (12, 3)) * 2
    away = (xyz - C) @ R.T - origin
    direction = away / np.linalg.norm(away, axis=1, keepdims=True)
    wrong = direction.copy()
    wrong[::4] = -wrong[::4][:, [1, 2, 0]]
    found = resected_station(StationRays(origin=origin, direction=wrong, xyz=xyz, limit=np.full(12, 0.003)))
    assert found is not None
    assert np.abs(found[0] - R).max() < 1e-9
    assert np.abs(found[1] - C).max() < 1e-8
    few = StationRays(origin=origin[:5], direction=direction[:5], xyz=xyz[:5], limit=np.full(5, 0.003))
    assert resected_station(few) is None
