"""Circular targets: the centre of a circle's image is not the image of its centre."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block, as_start
from raybundle.adjustment.predict import residuals_px
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.numerics.arrays import Array
from raybundle.platforms.station import sensor_from_object

STEP = 0.5
"""Share of the offsets by which they are changed, to see what the residuals do."""
DETERMINED = 0.03
"""Standard deviation of the common factor from which on radii are left to the adjustment."""


def ellipse_points(P: Array, normal: Array, radius: Array) -> Array:
    """Points (n, 3) whose central projection is the centre of the ellipse that a circle's image is.

    P, normal  (n, 3) circle centres and unit normals in the sensor frame; radius (n,) in the unit of P
    The dual conic of the image is P P' - r^2 (I - n n'); its centre is (U W + r^2 nU nW, V W + r^2 nV nW) /
    (W^2 - r^2 (1 - nW^2)).  The point keeps the depth of the circle.
    """
    U, V, W = P.T
    a, b, c = normal.T
    r2 = radius**2
    depth = W * W - r2 * (1 - c * c)
    return np.stack([(U * W + r2 * a * c) / depth * W, (V * W + r2 * b * c) / depth * W, W], axis=1)


def eccentricity_px(block: Block, radius: Array, normal: Array) -> Array:
    """Offset (m, 2) [px] of each image observation, ellipse centre minus image of the circle's centre.

    radius  (p,) of the targets in length units; NaN or 0: not a circular target
    normal  (p, 3) unit normals in object space; their sign does not matter
    To be taken off the measured ellipse centres.  It depends on the orientation only to second order, so that
    one repetition after an adjustment is enough.  What it does not tell: distortion bends the ellipse as well, which is
    covered to first order only.
    """
    o = block.observations
    size = np.asarray(radius)[o.point]
    rows = np.flatnonzero((size > 0) & np.isfinite(normal[o.point]).all(axis=1) & block.images.oriented[o.image])
    offset = np.zeros((len(o), 2))
    if not len(rows):
        return offset
    R, X0 = block.images.rotation[o.image[rows]], block.images.centre[o.image[rows]]
    P = sensor_from_object(R, X0, block.points.xyz[o.point[rows]]).T
    n = np.einsum("nij,nj->ni", R, normal[o.point[rows]])
    there = ellipse_points(P, n, size[rows])
    # both are projected as object points of their own
    shifted = X0 + np.einsum("nji,nj->ni", R, there)
    at_centre = residuals_px(_with_points(block, rows, block.points.xyz[o.point[rows]]), np.arange(len(rows)))
    at_ellipse = residuals_px(_with_points(block, rows, shifted), np.arange(len(rows)))
    offset[rows] = at_ellipse - at_centre
    return offset


@dataclass(frozen=True, slots=True, kw_only=True)
class RadiusScale:
    """By how much the radii of circular targets differ from those that were used, all by the same factor."""

    value: float
    """Radius over the radius used."""
    std: float

    @property
    def determinable(self) -> bool:
        """Whether the images tell it better than a ruler."""
        return self.std < DETERMINED

    @property
    def significant(self) -> bool:
        """Whether it is determinable and differs from 1 (99 percent)."""
        return self.determinable and abs(self.value - 1) > 2.6 * self.std


def radius_scale(result: Adjustment, offset: Array) -> RadiusScale | None:
    """A common factor of all radii as an unknown of the adjustment; None where no centre is eccentric.

    offset  (m, 2) [px] `eccentricity_px`, which the image observations of `result` are already without
    Eccentricity grows with r^2, so that its part that no other unknown takes up is one more column of the design
    matrix: it is what the residuals change by when the offsets change (Gauss-Newton step of that unknown alone, exact
    for all the others).  What it does not tell: radii that differ from target to target.
    """
    s = result.image_observations
    used = s.used
    if not np.abs(offset[used]).max(initial=0.0) > 0:
        return None
    block = as_start(result.given, result.adjusted)
    o = result.given.observations
    more = replace(block, observations=replace(o, xy_px=o.xy_px - STEP * offset))
    free = {i.camera: i.free for i in result.interior if i.image is None}
    plain = replace(result.options, statistics=False, reject="none", robust_start=False, estimate="given")
    moved = adjust_block(more, plain, free=free, rejected=s.rejected, start="adjusted")
    column = ((moved.image_observations.residuals_px - s.residuals_px) / STEP)[used]
    weighted = _weighted(column, o.cov_px2[used])
    square = float(np.sum(weighted * column))
    if not square > 0:
        return None
    share = 1 - float(np.sum(weighted * s.residuals_px[used])) / square
    ratio = math.sqrt(max(share, 0.0))
    # of r, from that of r^2
    return RadiusScale(value=ratio, std=result.sigma0 / math.sqrt(square) / (2 * max(ratio, 0.5)))


def _weighted(column: Array, cov: Array) -> Array:
    """Inverse covariances (variances of x and y and their covariance, (m, 3)) times (m, 2)."""
    a, b, c = cov.T
    x, y = column.T
    return np.stack([b * x - c * y, a * y - c * x], axis=1) / (a * b - c * c)[:, None]


def _with_points(block: Block, rows: Array, xyz: Array) -> Block:
    """The block with these observations (k,) only, each of a point of its own at xyz (k, 3)."""
    o, k = block.observations, len(rows)
    return replace(
        block,
        observations=replace(
            o, image=o.image[rows], point=np.arange(k, dtype=np.int32), xy_px=o.xy_px[rows], cov_px2=o.cov_px2[rows]
        ),
        points=replace(
            block.points,
            ids=tuple(str(i) for i in range(k)),
            role=np.zeros(k, np.int32),
            xyz=xyz,
            sigma=np.full((k, 3), np.nan),
        ),
    )
