"""Coordinates for every point of an oriented block, and the rays that do not fit them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.orientation.rays import Rays, angular_residuals, intersect_linear, object_rays

ROUNDS = 12
"""Rays of one point that may be left out one after the other."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Completed:
    """Coordinates of all points that oriented images see."""

    xyz: Array
    """(p, 3)"""
    outliers: Mask
    """(m,) rays that do not fit the point the others give; of two rays that do not fit each other, both"""
    weak: Mask
    """(p,) points on nearly parallel rays"""
    behind: Mask
    """(p,) points whose rays meet behind a camera"""


def complete(block: Block, rays: Rays, wanted: Mask, limits: Array) -> Completed:
    """Intersect the wanted points (p,) from the oriented images; the others keep their coordinates.

    limits  (n,) largest angle [rad] between a ray and the point, by image
    Where rays contradict each other the worst leaves, one after the other, while two are left.  Points that no
    rays determine get a place on their mean ray, at the distance of the others: the adjustment decides.
    """
    oriented = block.images.oriented
    rows = np.flatnonzero(oriented[rays.image] & wanted[rays.point])
    p, m = len(block.points), len(rays.image)
    found = Completed(
        xyz=block.points.xyz.copy(), outliers=np.zeros(m, bool), weak=np.zeros(p, bool), behind=np.zeros(p, bool)
    )
    if not len(rows):
        return found
    image = rays.image[rows]
    rotation, centre = block.images.rotation[image], block.images.centre[image]
    numbers, index = np.unique(rays.point[rows], return_inverse=True)
    direction = object_rays(rotation, rays.direction[rows])
    xyz, ratio, used = _by_majority(rotation, centre, direction, rays.direction[rows], index, limits[image])
    along = np.einsum("ni,ni->n", xyz[index] - centre, direction)
    count = np.bincount(index, used, minlength=len(numbers))
    behind = np.bincount(index, (along <= 0) & used, minlength=len(numbers)) > 0
    weak = (count < 2) | (ratio < 1e-8) | behind
    if weak.any():
        xyz[weak] = _on_rays(block, index, centre, direction, xyz, weak)[weak]
    angle = angular_residuals(rotation, centre, xyz[index], rays.direction[rows])
    found.xyz[numbers] = xyz
    found.outliers[rows] = (angle > limits[image]) & (count >= 2)[index]
    found.weak[numbers] = weak & ~behind & (count > 1)
    found.behind[numbers] = behind
    return found


def _by_majority(
    rotation: Array, centre: Array, direction: Array, sensor: Array, index: Index, limit: Array
) -> tuple[Array, Array, Mask]:
    """Points (k, 3), their eigenvalue ratios (k,) and the rays (r,) that took part."""
    k = int(index.max()) + 1
    xyz, _, ratio = intersect_linear(centre, direction, index.astype(np.int32), k)
    used = np.ones(len(index), bool)
    rows = np.arange(len(index))
    for _ in range(ROUNDS):
        excess = angular_residuals(rotation[rows], centre[rows], xyz[index[rows]], sensor[rows]) / limit[rows]
        excess[~used[rows]] = 0.0
        worst = np.zeros(k)
        np.maximum.at(worst, index[rows], excess)
        left = np.bincount(index[rows], used[rows], minlength=k)
        again = (worst > 1.0) & (left > 2)
        if not again.any():
            break
        mine = again[index[rows]]
        rows, excess = rows[mine], excess[mine]
        used[rows[excess == worst[index[rows]]]] = False
        kept = rows[used[rows]]
        numbers, local = np.unique(index[kept], return_inverse=True)
        xyz[numbers], _, ratio[numbers] = intersect_linear(
            centre[kept], direction[kept], local.astype(np.int32), len(numbers)
        )
    return xyz, ratio, used


def _on_rays(block: Block, index: Index, centre: Array, direction: Array, xyz: Array, weak: Mask) -> Array:
    """A place on the mean ray, at the median distance of the points that could be intersected."""
    count = len(xyz)
    rays = np.maximum(np.bincount(index, minlength=count), 1)[:, None]
    mean = np.stack([np.bincount(index, direction[:, k], minlength=count) for k in range(3)], axis=1) / rays
    start = np.stack([np.bincount(index, centre[:, k], minlength=count) for k in range(3)], axis=1) / rays
    known = np.concatenate([xyz[~weak], block.points.xyz[np.isfinite(block.points.xyz).all(axis=1)]])
    distance = 1.0
    if len(known):
        centres = block.images.centre[block.images.oriented]
        distance = float(np.median(np.linalg.norm(centres - np.median(known, axis=0), axis=1)))
    norm = np.maximum(np.linalg.norm(mean, axis=1), 1e-12)[:, None]
    return start + distance * mean / norm
