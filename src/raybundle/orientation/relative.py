"""Relative orientation of two images."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Array, Mask
from raybundle.orientation.candidates import Pose, relative_all
from raybundle.orientation.rays import camera_rays, intersect_linear, object_rays


@dataclass(frozen=True, slots=True, kw_only=True)
class RelativeOrientation:
    """The second image in the frame of the first; the base has length 1."""

    rotation: Array
    """(3, 3) from the first image's axes to the second's"""
    base: Array
    """(3,) unit vector from the first to the second projection centre, first image's frame"""
    covariance: Array
    """(6, 6) of base (rank 2) and omega, phi, kappa: five parameters are determined"""
    inliers: Mask
    """(n,) points that took part"""
    xyz: Array
    """(n, 3) object points in units of the base, first image's frame; NaN for outliers"""
    base_to_depth: float
    """Base over the mean depth of the points"""
    alternatives: tuple[Pose, ...]
    """Other solutions that explain nearly as many points (a plane leaves two)"""
    adjustment: Adjustment


def relative_orientation(
    first: Camera, second: Camera, first_px: Array, second_px: Array, *, sigma_px: float = 1.0, outlier_px: float = 8.0
) -> RelativeOrientation:
    """Orient a second image relative to a first from common points, robust and adjusted.

    first, second          interior orientations; held
    first_px, second_px    (n, 2) the same points in both images, pixel frame
    sigma_px               standard deviation of an image coordinate
    outlier_px             largest residual of a point that takes part
    raises                 NoOrientation for fewer than six points, no base, or points at infinity

    Essential matrix (Nistér 2004) and homography (for planes), then least squares of both images' coordinates.
    """
    n = len(first_px)
    if n < 6:
        raise NoOrientation("relative.too_few_points", n=n)
    a, b = camera_rays(first, first_px), camera_rays(second, second_px)
    limit = outlier_px * float(np.mean(first.pixel_mm)) / abs(first.values["c"])
    poses = relative_all(a, b, limit)
    if not poses:
        raise NoOrientation("relative.no_solution", n=n, limit_px=outlier_px)
    best = poses[0]
    inliers = np.flatnonzero(best.inliers)
    angle = np.arccos(np.clip(np.einsum("ni,ni->n", a[inliers], b[inliers] @ best.rotation), -1, 1))
    if np.median(angle) < np.radians(0.1):
        raise NoOrientation("relative.parallel_rays", angle_deg=np.degrees(np.median(angle)))
    block = _pair_block(first, second, first_px[inliers], second_px[inliers], sigma_px, best, a[inliers], b[inliers])
    result = adjust_block(block, AdjustmentOptions())
    assert result.precision is not None
    images = result.adjusted.images
    base = images.centre[1] - images.centre[0]
    length = float(np.linalg.norm(base))
    unit = base / length
    J = np.eye(6)
    J[:3, :3] = (np.eye(3) - np.outer(unit, unit)) / length
    xyz = np.full((n, 3), np.nan)
    xyz[inliers] = (result.adjusted.points.xyz - images.centre[0]) / length
    return RelativeOrientation(
        rotation=images.rotation[1],
        base=unit,
        covariance=J @ result.precision.images[1] @ J.T,
        inliers=best.inliers,
        xyz=xyz,
        base_to_depth=float(1 / np.mean(np.abs(xyz[inliers, 2]))),
        alternatives=tuple(poses[1:]),
        adjustment=result,
    )


def _pair_block(
    first: Camera, second: Camera, first_px: Array, second_px: Array, sigma_px: float, pose: Pose, a: Array, b: Array
) -> Block:
    """Two images, the first held at the origin."""
    n = len(a)
    index = np.tile(np.arange(n, dtype=np.int32), 2)
    rotation = np.stack([np.eye(3), pose.rotation])
    centre = np.stack([np.zeros(3), pose.centre])
    image = np.repeat(np.array([0, 1], np.int32), n)
    xyz, _, _ = intersect_linear(centre[image], object_rays(rotation[image], np.concatenate([a, b])), index, n)
    return Block(
        name="relative orientation",
        cameras=(replace(first, id="1", estimate=()), replace(second, id="2", estimate=())),
        images=Images(
            ids=("first", "second"), camera=np.array([0, 1], np.int32), file=("", ""), centre=centre, rotation=rotation,
            held=np.array([True, False]),
        ),
        observations=Observations(
            image=image, point=index, xy_px=np.concatenate([first_px, second_px]),
            cov_px2=np.tile([sigma_px**2, sigma_px**2, 0.0], (2 * n, 1)),
        ),
        points=Points(
            ids=tuple(str(i) for i in range(n)), role=np.zeros(n, np.int32), xyz=xyz, sigma=np.full((n, 3), np.nan)
        ),
    )  # fmt: skip
