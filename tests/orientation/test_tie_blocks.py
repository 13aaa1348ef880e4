"""Blocks of natural tie points as automatic matching gives them: many points, wrong rays, no control, poor camera."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block.select import with_rows
from raybundle.errors import NoOrientation
from raybundle.orientation import approximate_values, possible_values
from raybundle.orientation.skeleton import PER_PAIR, skeleton
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, brown_camera, field_scene
from tests.orientation.scenes import errors, facade, ring, tie_block


def aerial(seed=7):
    plan = AerialStrips(
        camera=brown_camera(), height=100, relief=12, strips=3, images_per_strip=6, forward_overlap=0.7,
        side_overlap=0.5, points_per_image=900, wobble_deg=4, seed=seed,
    )  # fmt: skip
    return aerial_scene(plan)


@pytest.mark.parametrize("scene", [aerial(), ring(4000), facade(6000, 14, 7)], ids=["aerial", "ring", "facade"])
@pytest.mark.parametrize(("factor", "anywhere"), [(1.05, 0.0), (0.95, 0.05), (1.3, 0.2)])
def test_wrong_rays_are_found_and_all_images_oriented(scene, factor, anywhere):
    truth, block, wrong = tie_block(scene, 3, factor, 0.05, anywhere)
    found = approximate_values(block)
    centre, angle = errors(truth, found.block)
    assert centre < 0.02
    assert angle < np.radians(2.5)
    # vertical images over flat ground hardly determine it
    assert found.block.cameras[0].values["c"] == pytest.approx(truth.cameras[0].values["c"], rel=0.08)
    assert found.outliers[wrong].mean() > 0.8
    assert found.outliers[~wrong].mean() < 0.06
    assert np.isfinite(found.block.points.xyz).all()


def test_a_camera_of_unknown_constant_is_found_from_pairs():
    truth, block, _ = tie_block(facade(3000, 12, 2), 2, 0.0, 0.03)
    found = approximate_values(block)
    assert found.notices[0].code == "camera_constant"
    assert found.notices[0].values["source"] == "pairs"
    assert found.block.cameras[0].values["c"] == pytest.approx(truth.cameras[0].values["c"], rel=0.03)


@pytest.mark.parametrize(("depth", "control", "source"), [(0.4, 12, "dlt"), (0, 12, "plane"), (0, 0, "format")])
def test_a_camera_of_unknown_constant_is_found_from_control(depth, control, source):
    survey = Survey(image_sigma_px=0.3, orientation="absent", interior="exact", control=control)
    s = simulate(field_scene(TargetField(depth=depth)), survey)
    camera = s.observed.cameras[0]
    block = replace(s.observed, cameras=(replace(camera, values={**camera.values, "c": 0.0}),))
    found = approximate_values(block)
    assert found.notices[0].values["source"] == source
    assert found.block.cameras[0].values["c"] == pytest.approx(camera.values["c"], rel=0.01)
    assert errors(s.truth, found.block)[1] < np.radians(0.5)


def test_the_constant_of_a_fisheye_must_be_given():
    from tests.orientation.scenes import fisheye, room

    s = simulate(room(fisheye(), 4, 1), Survey(orientation="absent", interior="exact"))
    camera = s.observed.cameras[0]
    block = replace(s.observed, cameras=(replace(camera, values={**camera.values, "c": 0.0}),))
    with pytest.raises(NoOrientation, match=r"1.*0.*camera\.constant_missing"):
        approximate_values(block)


def test_the_skeleton_is_small_spread_and_keeps_control_and_pairs():
    s = simulate(ring(6000, 8), Survey(orientation="absent", control=5))
    block = s.observed
    chosen = skeleton(block)
    o, n = block.observations, len(block.images)
    rows = chosen[o.point]
    assert rows.sum() < 0.5 * len(o)
    assert chosen[np.asarray(block.points.is_control).any(axis=1)].all()
    size = np.array([block.cameras[0].width_px, block.cameras[0].height_px])
    cell = np.clip((o.xy_px / size * 4).astype(int), 0, 3) @ [4, 1] + 16 * o.image
    before, after = np.bincount(cell, minlength=16 * n), np.bincount(cell[rows], minlength=16 * n)
    assert (after[before >= 8] >= 8).all()
    for a in range(n):
        for b in range(a):
            both_ = np.intersect1d(o.point[o.image == a], o.point[o.image == b])
            assert chosen[both_].sum() >= min(len(both_), PER_PAIR) or len(both_) < 8


def test_a_small_block_is_its_own_skeleton():
    s = simulate(field_scene(TargetField()), Survey(orientation="absent"))
    assert skeleton(s.observed).all()


def test_what_cannot_be_oriented_is_named_and_the_rest_is():
    _, block, _ = tie_block(facade(1500, 10, 4), 4, 1.02, 0.0)
    o = block.observations
    few = np.flatnonzero(o.image == 9)[3:]
    block = with_rows(block, ~np.isin(np.arange(len(o)), few))
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    block = with_rows(block, rays[block.observations.point] > 1)
    found = possible_values(block)
    assert list(found.not_oriented) == ["10"]
    assert "needed" in found.not_oriented["10"] or "known points" in found.not_oriented["10"]
    assert found.block.images.oriented[:9].all()
    assert not found.block.images.oriented[9]
    with pytest.raises(NoOrientation, match=r"(?s)1.*10.*orientation\.not_found") as error:
        approximate_values(block)
    assert list(error.value.images) == ["10"]


def test_parts_that_share_few_points_are_joined_by_them():
    truth, block, _ = tie_block(facade(3000, 12, 5), 5, 1.0, 0.0)
    block = replace(block, cameras=(replace(truth.cameras[0], estimate=()),))
    o = block.observations
    left, right = (np.unique(o.point[(o.image < 6) == side]) for side in (True, False))
    common = np.intersect1d(left, right)
    # one point in each image of the other half: no image can grow across
    tie = common[np.linspace(0, len(common) - 1, 14).astype(int)]
    apart = np.setxor1d(left, right)
    block = with_rows(block, np.isin(o.point, tie) | np.isin(o.point, apart))
    found = approximate_values(block)
    centre, angle = errors(truth, found.block)
    assert centre < 0.02
    assert angle < np.radians(1.0)
