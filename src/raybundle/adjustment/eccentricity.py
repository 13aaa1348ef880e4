"""Circular targets: the centre of a circle's image is not the image of its centre."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.predict import residuals_px
from raybundle.block import Block
from raybundle.numerics.arrays import Array
from raybundle.platforms.station import sensor_from_object


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
