"""Rays of satellite scenes: heights along them, tables of sources, and what corrections of scenes do to them."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.queries import covariance, joint_orientation
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import predicted_px
from raybundle.errors import phrase
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.io.block.scenes import projected
from raybundle.scenes.corrections import Fixes
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.kinds.rpc import RpcSensor
from raybundle.scenes.sensor import scene_camera, view_of
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from raybundle.scenes.trajectory import CorrectionModel
from raybundle.surfaces.depths.orientation import shift_covariance
from raybundle.surfaces.depths.pairs import LARGEST_SCALE, sources_of_each
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.transfer import TOLERANCE_PX, transfer
from tests.scenes.render import ORIGIN, PLACE
from tests.surface.scene_pair import SIZE, scene_block

REFERENCE, SOURCES = 0, (1, 2)


@pytest.fixture(scope="module")
def block():
    """Three scenes with affine biases."""
    return scene_block(bias="affine")[0]


@pytest.fixture(scope="module")
def adjusted(block):
    return adjust_block(block, AdjustmentOptions(jobs=1, noise="white"))


def with_lines(block):
    """The same images as rigorous scenes whose attitude is corrected."""
    cameras = []
    for name, pitch in (("ahead", 2.6), ("behind", -2.8), ("nadir", 0.2)):
        plan = OrbitPlan(target=ORIGIN, pitch_deg=pitch, roll_deg=0.5, width_px=SIZE, height_px=SIZE)
        corrections = CorrectionModel(attitude_degree=0, position_curve=Fixes(count=3))
        sensor = LineSensor(orbit_scene(plan), PLACE, corrections, 0.0)
        cameras.append(scene_camera(name, sensor, values={"rx0": 1e-6, "ry0": -2e-6}))
    return with_cameras(block, cameras)


def with_cameras(block, cameras):
    """The block with other scenes, seen from their viewpoints."""
    views = [view_of(c) for c in cameras]
    images = replace(
        block.images, centre=np.array([v.centre for v in views]), rotation=np.array([v.rotation for v in views])
    )
    return replace(block, cameras=tuple(cameras), images=images)


def places(rng, n=40):
    return rng.uniform(5, SIZE - 5, (n, 2)), rng.uniform(-60.0, 60.0, n)


@pytest.mark.parametrize("made", [lambda b: b, with_lines], ids=["rpc", "linescan"])
def test_heights_along_rays(block, made):
    block = made(block)
    rays = ReferenceRays.of(block, REFERENCE)
    xy, h = places(np.random.default_rng(1))
    t = ORIGIN[2] + h - rays.base_m
    assert (t > 0).all()
    xyz = rays.points(xy, t)
    assert np.abs(predicted_px(block, REFERENCE, xyz) - xy).max() < 1e-4
    assert np.abs(rays.parameter(xy, xyz) - t).max() < 1e-3
    assert np.abs(rays.depths(t) - PLACE.geographic_from_block(xyz)[:, 2]).max() < 1e-3
    numeric = (rays.points(xy, t + 3.0) - rays.points(xy, t - 3.0)) / 6.0
    assert np.abs(rays.by_t(xy, t) - numeric).max() < 1e-4
    assert (rays.directions(xy)[:, 2] < 0).all()  # away from the sensor is down, so that t grows towards it
    assert (rays.by_t(xy, t)[:, 2] > 0.99).all()
    # over a part of a scene a plane is linear in pixels and t
    x, y = xy.T
    level = rays.points(xy, np.full(len(xy), t[0]))
    A = np.column_stack([np.ones(len(xy)), x, y])
    left = level - A @ np.linalg.lstsq(A, level, rcond=None)[0]
    assert np.abs(left).max() < 0.01 * 0.7


@pytest.mark.parametrize("made", [lambda b: b, with_lines], ids=["rpc", "linescan"])
def test_tables_of_scenes_are_exact(block, made):
    block = made(block)
    rays = ReferenceRays.of(block, REFERENCE)
    xy, h = places(np.random.default_rng(2), 200)
    t = ORIGIN[2] + h - rays.base_m
    table = transfer(block, rays, 1, (float(t.min()), float(t.max())))
    exact, found = predicted_px(block, 1, rays.points(xy, t)), table.at(xy, t)
    inside = ((exact > 0) & (exact < SIZE)).all(axis=1)
    assert inside.sum() > 100
    assert np.abs(found - exact)[inside].max() < 2 * TOLERANCE_PX


def test_corrections_are_among_the_joint_orientation(adjusted):
    joint = joint_orientation(adjusted, (REFERENCE, *SOURCES))
    asked = covariance(adjusted, ["camera:ahead", "camera:behind", "camera:nadir"])
    assert [s.symbol for s in joint.steps] == 3 * ["A0", "A1", "A2", "B0", "B1", "B2"]
    assert [s.images for s in joint.steps] == [(k,) for k in (0, 1, 2) for _ in range(6)]
    assert np.allclose(joint.covariance, asked.matrix, rtol=1e-8, atol=1e-10)
    # of each other they know more than each for itself: the terrain ties them together
    assert np.abs(asked.matrix[:6, 6:12]).max() > 1e-4


def test_points_move_with_corrections_as_is_stated(adjusted):
    block, joint = adjusted.adjusted, joint_orientation(adjusted, (REFERENCE, *SOURCES))
    rays = ReferenceRays.of(block, REFERENCE)
    xy, _ = places(np.random.default_rng(3), 3)
    t = np.full(3, ORIGIN[2] - rays.base_m)
    found = shift_covariance(block, joint, REFERENCE, SOURCES, (float(t[0]) - 60, float(t[0]) + 60))

    def seen(b, at):
        xyz = ReferenceRays.of(b, REFERENCE).points(xy, at)
        return xyz, np.stack([predicted_px(b, i, xyz) for i in SOURCES], axis=1)

    xyz, there = seen(block, t)
    by_t = seen(block, t + 1.0)[1] - there
    k = -by_t / (by_t**2).sum(axis=(1, 2), keepdims=True)  # to what the tables say
    rng = np.random.default_rng(4)
    root = np.linalg.cholesky(joint.covariance + 1e-12 * joint.covariance.max() * np.eye(len(joint.steps)))
    depths, points = [], []
    for _ in range(200):
        values = [dict(c.values) for c in block.cameras]
        for one, by in zip(joint.steps, root @ rng.normal(size=len(joint.steps)), strict=True):
            values[one.images[0]][one.symbol] += by
        off = replace(block, cameras=tuple(replace(c, values=v) for c, v in zip(block.cameras, values, strict=True)))
        moved = t + (k * (seen(off, t)[1] - there)).sum(axis=(1, 2))
        depths.append(moved - t)
        points.append(seen(off, moved)[0] - xyz)
    ratio = np.std(depths, axis=0) / np.sqrt(found.of_depths(xy, t, k))
    assert (np.abs(ratio - 1) < 0.17).all(), ratio
    stated = found.of_points(xy, t, k, rays.by_t(xy, t))
    for n in range(3):
        whitened = np.linalg.solve(np.linalg.cholesky(stated[n]), np.linalg.cholesky(np.cov(np.array(points)[:, n].T)))
        assert np.abs(np.linalg.svd(whitened)[1] - 1).max() < 0.3


def test_scenes_of_a_block_are_kept_as_arrays(block):
    xyz = np.array([[10.0, -20.0, 5.0], [-30.0, 12.0, -8.0]])
    in_map = projected("EPSG:32633", (500000.0, 5316000.0, 300.0))
    elsewhere = [replace(c, scene=RpcSensor(c.scene.rpc, in_map, c.scene.size_px, c.scene.bias)) for c in block.cameras]
    other = replace(with_cameras(block, elsewhere), place=in_map)
    there = in_map.block_from_geographic(PLACE.geographic_from_block(xyz))
    for one, points in ((block, xyz), (with_lines(block), xyz), (other, there)):
        kept = block_of_arrays(arrays_of_block(one))
        assert type(kept.place) is type(one.place)
        for k in range(3):
            assert kept.cameras[k].values == one.cameras[k].values
            assert np.array_equal(predicted_px(kept, k, points), predicted_px(one, k, points))


def test_pairs_of_scenes_know_angles_and_sizes_of_pixels(block):
    found = sources_of_each(block)[0]
    assert set(found.sources) == {1, 2}
    angle = {p.source: p.angle_deg for p in found.pairs}
    rays = [ReferenceRays.of(block, k).directions(np.array([[SIZE / 2, SIZE / 2]]))[0] for k in range(3)]
    rays = [r / np.linalg.norm(r) for r in rays]
    for k in (1, 2):
        assert angle[k] == pytest.approx(np.degrees(np.arccos(rays[0] @ rays[k])), abs=0.2)
    # a camera whose constant is halved sees with pixels twice as large
    coarse = replace(block.cameras[1], pixel_mm=tuple(2.2 * p for p in block.cameras[1].pixel_mm))
    other = replace(block, cameras=(block.cameras[0], coarse, block.cameras[2]))
    pair = next(p for p in sources_of_each(other)[0].pairs if p.source == 1)
    assert pair.scale == pytest.approx(2.2, rel=0.1)
    assert pair.refusal == phrase("depths.scales_differ", ratio=pair.scale, limit=LARGEST_SCALE)
