"""Resection, intersection, relative orientation and DLT: right, and as precise as they say."""

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.errors import InputError, NoOrientation
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_angles
from raybundle.numerics.statistics import mahalanobis2
from raybundle.orientation import dlt, intersection, relative_orientation, resection
from raybundle.sensors import sensor_models

CAMERA = Camera(
    id="1", model="brown", width_px=6000, height_px=4000, pixel_mm=(0.004, 0.004),
    values={"c": 20.0, "x0": 0.03, "y0": -0.02, "K1": 2e-4, "K2": -4e-7, "K3": 0, "P1": 1e-5, "P2": 0, "A": 0, "S": 0},
)  # fmt: skip
MODEL = sensor_models["brown"]
VALUES = np.array([CAMERA.values[s] for s in MODEL.symbols])
ANGLES = np.radians([[8.0, -5.0, 30.0], [-6.0, 22.0, -55.0], [20.0, -15.0, 100.0]])
CENTRES = np.array([[0.1, -0.2, 6.0], [2.4, 0.1, 5.5], [-1.5, 1.8, 5.8]])
ROTATIONS = rotation_from_angles(ANGLES)


def object_points(n, seed=0, *, plane=False):
    rng = np.random.default_rng(seed)
    xyz = rng.uniform([-1.6, -1.0, -0.6], [1.6, 1.0, 0.6], (n, 3))
    if plane:
        xyz[:, 2] = 0
    return xyz


def project(i, xyz):
    image, _ = MODEL.project(((xyz - CENTRES[i]) @ ROTATIONS[i].T).T, VALUES)
    return CAMERA.pixel_from_image(image.T)


def pose_error(result, i):
    angle = angles_from_rotation(result.rotation) - ANGLES[i]
    return np.concatenate([result.centre - CENTRES[i], angle])


@pytest.mark.parametrize("plane", [False, True])
def test_resection_without_noise_is_exact(plane):
    xyz = object_points(12, plane=plane)
    result = resection(CAMERA, project(0, xyz), xyz)
    np.testing.assert_allclose(pose_error(result, 0), 0, atol=1e-9)


@pytest.mark.long
def test_resection_covariance_is_true():
    xyz, rng = object_points(10), np.random.default_rng(1)
    errors = []
    for _ in range(150):
        xy = project(0, xyz) + rng.normal(0, 0.5, (10, 2))
        result = resection(CAMERA, xy, xyz, sigma_px=0.5)
        C = result.covariance / result.adjustment.sigma0**2
        errors.append(mahalanobis2(pose_error(result, 0)[None], C)[0])
    assert kstest(errors, chi2(6).cdf).pvalue > 1e-3
    assert kstest(np.array(errors) * 1.3**2, chi2(6).cdf).pvalue < 1e-3


def test_resection_with_outliers():
    xyz = object_points(30)
    xy = project(1, xyz)
    xy[:6] += 90
    result = resection(CAMERA, xy, xyz, outlier_px=5)
    assert not result.inliers[:6].any()
    assert result.inliers[6:].all()
    np.testing.assert_allclose(pose_error(result, 1), 0, atol=1e-8)


def test_four_coplanar_points_leave_alternatives_or_one_clear_pose():
    xyz = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0.0]])
    result = resection(CAMERA, project(0, xyz), xyz)
    np.testing.assert_allclose(pose_error(result, 0), 0, atol=1e-8)


@pytest.mark.parametrize("xyz", [np.eye(3)[:2], np.arange(5)[:, None] * np.ones(3)])
def test_resection_names_what_is_missing(xyz):
    with pytest.raises(NoOrientation, match=r"resection\.in_line|resection\.too_few_points"):
        resection(CAMERA, np.full((len(xyz), 2), 2000.0), xyz)


def block_of(xyz, rng=None, sigma=0.3):
    n, p = 3, len(xyz)
    xy = np.concatenate([project(i, xyz) for i in range(n)])
    if rng is not None:
        xy = xy + rng.normal(0, sigma, xy.shape)
    return Block(
        cameras=(CAMERA,),
        images=Images(
            ids=("a", "b", "c"), camera=np.zeros(3, np.int32), file=("",) * 3, centre=CENTRES, rotation=ROTATIONS
        ),
        observations=Observations(
            image=np.repeat(np.arange(3, dtype=np.int32), p), point=np.tile(np.arange(p, dtype=np.int32), 3), xy_px=xy,
            cov_px2=np.tile([sigma**2, sigma**2, 0], (n * p, 1)),
        ),
        points=Points(
            ids=tuple(map(str, range(p))), role=np.zeros(p, np.int32), xyz=np.full((p, 3), np.nan),
            sigma=np.full((p, 3), np.nan),
        ),
    )  # fmt: skip


def test_intersection_covariance_is_true():
    xyz = object_points(1500, 3)
    result = intersection(block_of(xyz, np.random.default_rng(5)))
    C = result.covariance / result.adjustment.sigma0**2
    d2 = mahalanobis2(result.xyz - xyz, C)
    assert kstest(d2, chi2(3).cdf).pvalue > 1e-3
    assert kstest(d2 * 1.1**2, chi2(3).cdf).pvalue < 1e-3


def test_intersection_names_a_single_ray():
    from dataclasses import replace

    block = block_of(object_points(5))
    o = block.observations
    keep = ~((o.point == 2) & (o.image > 0))
    block = replace(
        block,
        observations=replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep]),
    )
    with pytest.raises(InputError, match=r"2[\s\S]*tie_points\.too_few_rays"):
        intersection(block)


@pytest.mark.parametrize("plane", [False, True])
def test_relative_orientation(plane):
    xyz = object_points(60, 7, plane=plane)
    result = relative_orientation(CAMERA, CAMERA, project(0, xyz), project(1, xyz))
    R = ROTATIONS[1] @ ROTATIONS[0].T
    base = ROTATIONS[0] @ (CENTRES[1] - CENTRES[0])
    solutions = [(result.rotation, result.base)] + [(p.rotation, p.centre) for p in result.alternatives]
    best = min(np.abs(r - R).max() + np.abs(b - base / np.linalg.norm(base)).max() for r, b in solutions)
    assert best < 1e-7 if not plane else best < 1e-3
    assert np.linalg.matrix_rank(result.covariance, tol=1e-6 * np.trace(result.covariance)) >= 4


def test_relative_orientation_needs_a_base():
    xyz = object_points(40, 7)
    with pytest.raises(NoOrientation):
        relative_orientation(CAMERA, CAMERA, project(0, xyz), project(0, xyz))


def test_dlt_recovers_the_camera():
    xyz = object_points(20, 11)
    model = sensor_models["brown"]
    values = np.array([20.0, 0.4, -0.3] + [0.0] * 7)
    for i in range(3):
        image, _ = model.project(((xyz - CENTRES[i]) @ ROTATIONS[i].T).T, values)
        result = dlt(image.T, xyz)
        assert result.c == pytest.approx(20.0, abs=1e-7)
        assert (result.x0, result.y0) == pytest.approx((0.4, -0.3), abs=1e-7)
        np.testing.assert_allclose(result.centre, CENTRES[i], atol=1e-8)
        np.testing.assert_allclose(result.rotation, ROTATIONS[i], atol=1e-8)
        assert result.residuals_mm.shape == (20, 2)


def test_dlt_refuses_a_plane():
    xyz = object_points(20, 11, plane=True)
    with pytest.raises(NoOrientation, match=r"dlt\.plane"):
        dlt(project(0, xyz), xyz)
