"""Spatial resection: the exterior orientation of one image from known points."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera, Images, Observations, Points, Role
from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Array, Mask
from raybundle.orientation.candidates import Pose, resect_all, resect_robust
from raybundle.orientation.rays import camera_rays


@dataclass(frozen=True, slots=True, kw_only=True)
class Resection:
    """An exterior orientation with its precision."""

    centre: Array
    """(3,) projection centre"""
    rotation: Array
    """(3, 3) object axes to image axes"""
    covariance: Array
    """(6, 6) of X, Y, Z, omega, phi, kappa [unit of the points, rad], a-posteriori sigma0 where there is redundancy"""
    inliers: Mask
    """(n,) points that took part"""
    alternatives: tuple[Pose, ...]
    """Other poses that fit nearly as well (three points, or four in a plane)"""
    adjustment: Adjustment
    """Residuals, redundancy numbers and all the rest"""


def single_image_block(
    camera: Camera, xy_px: Array, xyz: Array, sigma_px: float, point_sigma: Array | None, pose: Pose | None
) -> Block:
    """A block of one image and control points, held or with the sigmas (n, 3)."""
    n = len(xyz)
    sigma = np.zeros((n, 3)) if point_sigma is None else np.broadcast_to(np.asarray(point_sigma, float), (n, 3))
    return Block(
        name="resection",
        cameras=(camera,),
        images=Images(
            ids=("image",),
            camera=np.zeros(1, np.int32),
            file=("",),
            centre=np.full((1, 3), np.nan) if pose is None else pose.centre[None],
            rotation=np.full((1, 3, 3), np.nan) if pose is None else pose.rotation[None],
        ),
        observations=Observations(
            image=np.zeros(n, np.int32),
            point=np.arange(n, dtype=np.int32),
            xy_px=np.asarray(xy_px, float),
            cov_px2=np.tile([sigma_px**2, sigma_px**2, 0.0], (n, 1)),
        ),
        points=Points(
            ids=tuple(str(i) for i in range(n)),
            role=np.full(n, Role.CONTROL, np.int32),
            xyz=np.asarray(xyz, float),
            sigma=np.array(sigma),
        ),
    )


def resection(
    camera: Camera, xy_px: Array, xyz: Array, *, sigma_px: float = 1.0, point_sigma: Array | None = None,
    outlier_px: float | None = None,
) -> Resection:  # fmt: skip
    """Exterior orientation of an image of known points, closed form then adjusted.

    camera       interior orientation; its `estimate` parameters are estimated along (hold all with `estimate=()`)
    xy_px        (n, 2) measured image points, pixel frame
    xyz          (n, 3) object points
    sigma_px     standard deviation of an image coordinate
    point_sigma  (n, 3) or scalar: standard deviations of the points; None: without error
    outlier_px   points that no pose explains better than this are left out (LO-RANSAC); None: all take part
    raises       NoOrientation for fewer than three points, points in a line, or no pose that fits

    P3P after Persson and Nordberg 2018.  With three points up to four poses fit exactly, with four in a plane
    often two nearly: see `alternatives`.
    """
    xy_px, xyz = np.asarray(xy_px, float), np.asarray(xyz, float)
    direction = camera_rays(camera, xy_px)
    inliers = np.ones(len(xyz), bool)
    if len(xyz) < 3:
        raise NoOrientation("resection.too_few_points", n=len(xyz))
    if np.linalg.matrix_rank(xyz - xyz.mean(axis=0), tol=1e-9 * max(float(np.ptp(xyz)), 1e-300)) < 2:
        raise NoOrientation("resection.in_line")
    if outlier_px is not None:
        limit = outlier_px * float(np.mean(camera.pixel_mm)) / abs(camera.values["c"])
        pose = resect_robust(direction, xyz, limit)
        if pose is None:
            raise NoOrientation("resection.no_fit", limit_px=outlier_px)
        inliers = pose.inliers
    poses = resect_all(direction[inliers], xyz[inliers])
    if not poses:
        raise NoOrientation("resection.no_solution")
    sigma = None if point_sigma is None else np.broadcast_to(np.asarray(point_sigma, float), xyz.shape)[inliers]
    block = single_image_block(camera, xy_px[inliers], xyz[inliers], sigma_px, sigma, poses[0])
    result = adjust_block(block, AdjustmentOptions(datum="control"))
    assert result.precision is not None
    return Resection(
        centre=result.adjusted.images.centre[0],
        rotation=result.adjusted.images.rotation[0],
        covariance=result.precision.images[0],
        inliers=inliers,
        alternatives=tuple(poses[1:]),
        adjustment=replace(result, given=block),
    )
