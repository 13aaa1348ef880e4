"""Which ray of a point is wrong: where the test cannot show, the point leaves rather than a ray by lot.

The residuals of a point with few rays move together: a blunder in one of three rays may show most in another one
(Förstner 1983).  Taking out the ray with the largest test value is then a coin-flip that costs a good ray, leaves the
wrong one, and a point that two rays, one of them wrong, put somewhere.
"""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera, Role
from raybundle.numerics.arrays import Array, Index, Mask

FEWEST = 3
"""Rays that a point must keep: with two of them nothing contradicts a wrong one across their common plane."""
SURE = 2.33
"""Normal quantile at which a blunder in another ray is refuted: 99 %, one-sided."""


def unlocatable(result: Adjustment, rows: Index) -> Mask:
    """(k,) of suspected image observations, whether the blunder of their tie point cannot be located.

    It cannot where fewer than three rays would be left, or where a blunder in another ray of the point explains the
    largest residual as well: it would make w1 about rho w2, with the variance 1 - rho^2 (w the test values, rho their
    correlation), so that it is not refuted where w1 - rho w2 < 2.33 sqrt(1 - rho^2).

    Control points, and points that a distance touches, are never in question here.  The correlations are those of an
    intersection from images that are held.
    """
    block = result.adjusted
    o = block.observations
    used = result.image_observations.used
    t = np.nan_to_num(np.abs(result.image_observations.t).max(axis=1))
    tie = (np.asarray(block.points.role) == Role.TIE) & ~block.points.is_control.any(axis=1)
    tie &= ~block.points_named
    found = np.zeros(len(rows), bool)
    order = np.argsort(o.point, kind="stable")
    first = np.searchsorted(o.point[order], np.arange(len(block.points) + 1))
    for k, row in enumerate(rows):
        p = int(o.point[row])
        if not tie[p]:
            continue
        rays = order[first[p] : first[p + 1]]
        rays = rays[used[rays]]
        if len(rays) <= FEWEST:
            found[k] = True
            continue
        others = rays[rays != row]
        rho = _correlations(block, int(row), others)
        found[k] = bool((t[row] - rho * t[others] < SURE * np.sqrt(1 - rho**2)).any())
    return found


def _correlations(block: Block, row: int, others: Index) -> Array:
    """Largest correlation (k,) of a residual of this ray with one of each of the others, by the point alone."""
    o = block.observations
    rays = np.concatenate([[row], others])
    image = o.image[rays]
    d = block.points.xyz[o.point[row]] - block.images.centre[image]
    distance = np.linalg.norm(d, axis=1)
    d = d / distance[:, None]
    # two directions across each ray, in units of the standard deviation of its image point
    aside = np.where(np.abs(d[:, :1]) < 0.7, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    u = np.cross(d, aside)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    c = np.array([_pixels_of_radian(k) for k in block.cameras])[block.images.camera[image]]
    sigma = np.sqrt(o.cov_px2[rays, :2].mean(axis=1)) / c
    A = np.stack([u, np.cross(d, u)], axis=1) / (distance * sigma)[:, None, None]
    flat = A.reshape(-1, 3)
    R = np.eye(len(flat)) - flat @ np.linalg.pinv(flat)
    s = np.sqrt(np.maximum(np.diagonal(R), 1e-12))
    rho = np.abs(R / np.outer(s, s))[:2].max(axis=0)
    return np.minimum(rho.reshape(-1, 2).max(axis=1)[1:], 1.0)


def _pixels_of_radian(camera: Camera) -> float:
    """Pixels of a radian on the axis; 1 of a satellite scene, whose rays are alike among themselves."""
    size = 0.0 if camera.is_scene else abs(float(camera.parameters[0])) / float(np.mean(camera.pixel_mm))
    return size or 1.0
