"""Points that a solution has behind their cameras or at infinity, intersected anew before their rays are rejected.

From rough approximate values a point may pass infinity on the way and end in the mirror image of its place, while its
rays meet before the cameras as these stand at the end.  Points whose rays do not meet there stay as they are.
"""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.blunders.reintersection import directions
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.block.rigs import without_rigs
from raybundle.numerics.arrays import Array, Index

ROUNDS = 4
"""Intersections with the distances from the cameras that the one before gave"""


def meeting_before_cameras(adjusted: Block, rows: Index, limit: float) -> tuple[Index, Array]:
    """Points (k,) and their places (k, 3) where all of their rays meet before the cameras.

    adjusted  the block with a solution
    rows      (m,) all image observations that take part of the points that are asked for
    limit     largest residual of an image coordinate, in standard deviations

    Squares of distances from the rays, in units of the distances from the cameras: of a camera near by, too, the angle
    counts.
    """
    alone, o = without_rigs(adjusted), adjusted.observations
    rows = rows[np.argsort(o.point[rows], kind="stable")]
    points, index = np.unique(o.point[rows], return_inverse=True)
    centre, direction = alone.images.centre[o.image[rows]], directions(alone, rows)
    P = np.eye(3) - direction[:, :, None] * direction[:, None, :]
    weight, xyz, known = np.ones(len(rows)), np.full((len(points), 3), np.nan), np.zeros(len(points), bool)
    for _ in range(ROUNDS):
        N, b = np.zeros((len(points), 3, 3)), np.zeros((len(points), 3))
        np.add.at(N, index, weight[:, None, None] * P)
        np.add.at(b, index, weight[:, None] * np.einsum("nij,nj->ni", P, centre))
        values = np.linalg.eigvalsh(N)
        known = values[:, 0] > np.finfo(float).eps * values[:, 2]
        xyz[known] = np.linalg.solve(N[known], b[known][:, :, None])[:, :, 0]
        square = np.einsum("ni,ni->n", xyz[index] - centre, xyz[index] - centre)
        weight = np.where(known[index], 1 / np.maximum(square, np.finfo(float).tiny), 1.0)
    ahead = np.einsum("ni,ni->n", xyz[index] - centre, direction) > 0
    with np.errstate(all="ignore"):
        v = np.nan_to_num(residuals_px(alone, rows, xyz[index]), nan=np.inf) / np.sqrt(o.cov_px2[rows, :2])
    fits = ahead & (np.abs(v) < limit).all(axis=1)
    meet = known & (np.bincount(index, fits, minlength=len(points)) == np.bincount(index, minlength=len(points)))
    return points[meet], xyz[meet]
