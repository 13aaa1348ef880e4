"""What orientation and calibration do to depths and object points, beside draws of orientations."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.queries import covariance, joint_orientation
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import predicted_px
from raybundle.block.select import select_block
from raybundle.errors import InputError
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.surfaces.depths.orientation import shift_covariance
from raybundle.surfaces.depths.rays import ReferenceRays

REFERENCE, SOURCES = 4, (3, 5, 10)


@pytest.fixture(scope="module")
def adjusted():
    strips = AerialStrips(images_per_strip=7, points_per_image=40)
    strips = replace(strips, camera=replace(strips.camera, estimate=("c", "x0", "y0", "K1")))
    survey = Survey(
        seed=3, control=5, control_sigma=(0.02, 0.02, 0.02), image_sigma_px=0.5, points="approximate", approximate=1e-4
    )
    return adjust_block(simulate(aerial_scene(strips), survey).observed, AdjustmentOptions(jobs=1, noise="white"))


@pytest.fixture(scope="module")
def joint(adjusted):
    return joint_orientation(adjusted, (REFERENCE, *SOURCES))


def test_the_joint_covariance_is_that_of_the_questions(adjusted, joint):
    ids = adjusted.adjusted.images.ids
    asked = covariance(adjusted, [f"image:{ids[i]}" for i in (REFERENCE, SOURCES[0])] + ["camera:1"])
    places = [k for k, s in enumerate(joint.steps) if s.axis in range(3) and s.images[0] in (REFERENCE, SOURCES[0])]
    theirs = [k for k, name in enumerate(asked.names) if name.endswith(("X0", "Y0", "Z0"))]
    ours = joint.covariance[np.ix_(places, places)]
    assert np.allclose(ours, asked.matrix[np.ix_(theirs, theirs)], rtol=1e-9, atol=1e-9 * ours.max())
    symbols = [k for k, s in enumerate(joint.steps) if s.symbol]
    assert [joint.steps[k].symbol for k in symbols] == ["c", "x0", "y0", "K1"]
    assert all(joint.steps[k].images == (REFERENCE, *SOURCES) for k in symbols)
    assert np.linalg.eigvalsh(joint.covariance).min() > -1e-12 * joint.covariance.max()


def drawn(block, joint, draw):
    """A block whose orientations and cameras are off by a draw of the steps."""
    centre, rotation = block.images.centre.copy(), block.images.rotation.copy()
    values = dict(block.cameras[0].values)
    turn = np.zeros((len(centre), 3))
    for one, by in zip(joint.steps, draw, strict=True):
        if one.axis < 0:
            values[one.symbol] += by
        elif one.axis < 3:
            centre[one.images[0], one.axis] += by
        else:
            turn[one.images[0], one.axis - 3] += by
    images = replace(block.images, centre=centre, rotation=rotation_from_vector(turn) @ rotation)
    return replace(block, images=images, cameras=(replace(block.cameras[0], values=values),))


def test_depths_and_points_scatter_as_is_stated(adjusted, joint):
    block = adjusted.adjusted
    rays = ReferenceRays.of(block, REFERENCE)
    size = np.array([rays.camera.width_px, rays.camera.height_px])
    xy = size * np.array([[0.45, 0.15], [0.5, 0.1], [0.42, 0.2]])
    o = block.observations
    mine = o.image == REFERENCE
    known = rays.parameter(o.xy_px[mine], block.points.xyz[o.point[mine]])
    t = np.full(3, np.median(known))
    found = shift_covariance(block, joint, REFERENCE, SOURCES, (float(known.min()), float(known.max())))

    def places(b, at):
        r = ReferenceRays.of(b, REFERENCE)
        xyz = r.points(xy, at)
        return xyz, np.stack([predicted_px(b, i, xyz) for i in SOURCES], axis=1)

    xyz, there = places(block, t)
    h = 1e-5 * t
    by_t = (places(block, t + h)[1] - there) / h[:, None, None]
    k = -by_t / (by_t**2).sum(axis=(1, 2), keepdims=True)  # of t by least squares, to what the tables say
    by_t_xyz = (places(block, t + h)[0] - xyz) / h[:, None]
    rng = np.random.default_rng(5)
    root = np.linalg.cholesky(joint.covariance + 1e-18 * np.eye(len(joint.steps)) * joint.covariance.max())
    depths, points = [], []
    for _ in range(200):
        off = drawn(block, joint, root @ rng.normal(size=len(joint.steps)))
        moved = t.copy()
        for _ in range(2):
            moved = moved + (k * (places(off, moved)[1] - there)).sum(axis=(1, 2))
        depths.append(moved - t)
        points.append(places(off, moved)[0] - xyz)
    stated = found.of_depths(xy, t, k)
    ratio = np.std(depths, axis=0) / np.sqrt(stated)
    assert (np.abs(ratio - 1) < 0.17).all(), ratio
    cov = found.of_points(xy, t, k, by_t_xyz)
    for n in range(3):
        sample = np.cov(np.array(points)[:, n].T)
        whitened = np.linalg.solve(np.linalg.cholesky(cov[n]), np.linalg.cholesky(sample))
        assert np.abs(np.linalg.svd(whitened)[1] - 1).max() < 0.3


def test_an_error_of_scale_moves_points_from_where_it_is_none(adjusted, joint):
    """All projection centres further from a point by 1 in 1000: so are the object points, whatever their depths."""
    block = adjusted.adjusted
    rays = ReferenceRays.of(block, REFERENCE)
    fixed, scale = block.points.xyz.mean(axis=0) + np.array([3.0, -2.0, 1.0]), 1e-3
    centre = block.images.centre
    off = [scale * (centre[s.images[0]] - fixed)[s.axis] if 0 <= s.axis < 3 else 0.0 for s in joint.steps]
    one = replace(joint, covariance=np.outer(off, off))
    xy = np.array([[0.45, 0.15], [0.42, 0.2]]) * [rays.camera.width_px, rays.camera.height_px]
    mine = block.observations.image == REFERENCE
    known = rays.parameter(block.observations.xy_px[mine], block.points.xyz[block.observations.point[mine]])
    t = np.full(2, np.median(known))

    def places(at):
        xyz = rays.points(xy, at)
        return xyz, np.stack([predicted_px(block, i, xyz) for i in SOURCES], axis=1)

    h = 1e-5 * t
    xyz, there = places(t)
    by_t = (places(t + h)[1] - there) / h[:, None, None]
    k = -by_t / (by_t**2).sum(axis=(1, 2), keepdims=True)
    found = shift_covariance(block, one, REFERENCE, SOURCES, (float(known.min()), float(known.max())))
    cov = found.of_points(xy, t, k, (places(t + h)[0] - xyz) / h[:, None])
    moved = scale * (xyz - fixed)
    assert np.allclose(cov, moved[:, :, None] * moved[:, None], rtol=0.02, atol=2e-3 * np.abs(cov).max())


def test_what_is_held_adds_nothing(adjusted, joint):
    none = replace(joint, steps=(), covariance=np.zeros((0, 0)), unknowns=np.zeros(0, int))
    found = shift_covariance(adjusted.adjusted, none, REFERENCE, SOURCES, (0.005, 0.02))
    n = np.zeros((1, 3, 2))
    assert not found.of_points(np.ones((1, 2)), np.full(1, 0.01), n, np.ones((1, 3))).any()


def test_an_image_that_took_no_part_is_named(adjusted):
    block = adjusted.given
    o = block.observations
    without = replace(block, observations=o.rows(np.flatnonzero(o.image != 2)))
    rays = np.bincount(without.observations.point, minlength=len(block.points))
    without = select_block(without, "point", rays > 1)
    result = adjust_block(without, AdjustmentOptions(jobs=1, noise="white"))
    with pytest.raises(InputError, match=rf"{block.images.ids[2]}.*query\.image_without_part"):
        joint_orientation(result, (2, 3))
