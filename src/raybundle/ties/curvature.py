"""Matches of windows in which the surface is curved are displaced along the parallax, and corrected for it.

An affine map brings a window onto another where the surface is plane.  Where it is curved, the map fits the mean of the
surface over the window: a point on a ball lies inside the ball.  With k the mean curvature along the ray of the
reference [length / px^2] the match is displaced by p k r: p is the parallax of a unit of length, r [px^2] follows from
the window and its grey values (`WindowMatches.residual`).  Two sources give k: the residuals of grey values of all
matches of a point, and a quadratic surface through its neighbours.  The latter is precise, and wrong beside a crease.
It counts as far as neighbours fit it; where the residuals contradict it beyond chance, they replace it.

Constants by trials on the errors of tie points of rendered sets; `benchmarks/tie_curvature.py` judges them.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block import Block
from raybundle.numerics.arrays import Array, Mask
from raybundle.ties.block import object_pixel, viewing_lines
from raybundle.ties.relief import parallax

NEIGHBOURS = 12
FITTING, SIGNIFICANT = 50.0, 3.7
"""Half of the curvature of neighbours counts where their scatter about it has so many times the variance of noise; more
is allowed where the curvature is larger than so many of its standard deviations."""
SHARED = 0.25
"""The curvature by the residuals of n matches has the variance SHARED (1 + n) over the sum of their weights: half of
the noise of grey values is that of the reference, which they share."""
BEYOND = 2.8
"""Standard deviations by which chance lets residuals contradict neighbours"""
OF_RESIDUALS, OF_CORRECTION = 1.4, 0.2
"""Variance that remains, over that of the residuals' part and over the square of the correction"""
LEAST = 0.1
"""What remains counts as far as its variance exceeds this share of that of the point's depth."""
PART = 20_000
"""Points at a time"""


def without_curvature(block: Block, residual: Array, reference: Mask, matched: Mask) -> Block:
    """The block with matches as of a plane surface, and `Points.sigma_curvature`.

    residual   (m, FIGURES) of the matches, see `WindowMatches.residual`
    reference  (m,) image points from which windows are taken
    matched    (m,) image points that matching measured
    """
    o, points = block.observations, block.points
    rows = np.flatnonzero(matched & (residual[:, 0] > 0) & np.isfinite(points.xyz[o.point]).all(axis=1))
    point, p, r = o.point[rows], parallax(block, rows, reference), residual[rows]

    def sums(values: Array) -> Array:
        return np.bincount(point, values, len(points))

    weight = _quadratic_form(p, r[:, 10:13]) / r[:, 0]
    weights = sums(weight)
    known = np.flatnonzero(weights > 0)
    weights = weights[known]
    by_residuals = sums((p * r[:, 8:10]).sum(axis=1) / r[:, 0])[known] / weights
    variance = SHARED * (1 + np.bincount(point, minlength=len(points))[known]) / weights
    own = np.full(len(points), -1)
    own[o.point[reference]] = np.flatnonzero(reference)
    own = own[known]
    xx, yy, xy = o.cov_px2[rows].T
    information = sums(_quadratic_form(p, np.stack([yy, -xy, xx], axis=1)) / (xx * yy - xy**2))[known]
    direction = viewing_lines(replace(block, observations=o.rows(own)))[1]
    curvature = of_neighbours(points.xyz[known], direction, 1 / information) * object_pixel(block, own) ** 2
    excess = np.maximum((by_residuals - curvature) ** 2 - BEYOND**2 * variance, 0)
    part = excess / (excess + variance)
    curvature += part * (by_residuals - curvature)
    reach = np.abs(sums(weight * r[:, 13])[known]) / weights
    sigma, of_point = np.full(len(points), np.nan), np.zeros(len(points))
    left = reach**2 * (OF_RESIDUALS * part * variance + OF_CORRECTION * curvature**2) - LEAST / information
    sigma[known] = np.sqrt(np.where(left > 0, left, np.nan))
    of_point[known] = curvature
    xy_px = o.xy_px.copy()
    xy_px[rows] -= p * (of_point[point] * r[:, 13])[:, None]
    return replace(block, observations=replace(o, xy_px=xy_px), points=replace(points, sigma_curvature=sigma))


def _quadratic_form(p: Array, m: Array) -> Array:
    """(k,) p' M p of vectors (k, 2) and matrices (k, 3) as xx, xy, yy."""
    return p[:, 0] ** 2 * m[:, 0] + 2 * p[:, 0] * p[:, 1] * m[:, 1] + p[:, 1] ** 2 * m[:, 2]


def of_neighbours(xyz: Array, direction: Array, variance: Array) -> Array:
    """(k,) mean curvature [1 / length] along unit directions (k, 3) of a surface through points (k, 3), as it counts.

    variance  (k,) of the points along their directions
    All of it counts where neighbours fit a quadratic surface, nothing where they do not.
    """
    from scipy.spatial import KDTree

    found = np.zeros(len(xyz))
    if len(xyz) <= NEIGHBOURS:
        return found
    near = KDTree(xyz).query(xyz, k=NEIGHBOURS + 1)[1].reshape(len(xyz), -1)
    for k in range(0, len(xyz), PART):
        rows = slice(k, k + PART)
        found[rows] = _of_place(
            xyz[near[rows]] - xyz[rows, None], direction[rows], np.median(variance[near[rows]], axis=1)
        )
    return found


def _of_place(v: Array, d: Array, noise: Array) -> Array:
    """Of neighbours (k, n, 3) relative to their points; see `of_neighbours`."""
    first = np.cross(d, np.where(np.abs(d[:, :1]) < 0.6, [[1.0, 0, 0]], [[0, 1.0, 0]]))
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    x, y, z = (np.einsum("pki,pi->pk", v, e) for e in (first, np.cross(d, first), d))
    size = np.sqrt((x**2 + y**2).mean(axis=1, keepdims=True)) + 1e-100
    x, y = x / size, y / size
    A = np.stack([np.ones_like(x), x, y, x * y, (x**2 + y**2) / 4, (x**2 - y**2) / 4], axis=-1)
    Q = np.linalg.inv(A.swapaxes(1, 2) @ A + 1e-9 * np.eye(6))
    solved = Q @ (A.swapaxes(1, 2) @ z[..., None])
    scatter = ((z - (A @ solved)[..., 0]) ** 2).sum(axis=1) / (NEIGHBOURS - 5)
    sum_of_both, spread = solved[:, 4, 0], scatter * Q[:, 4, 4]
    significance = np.divide(sum_of_both**2, spread, out=np.zeros(len(v)), where=spread > 0) / SIGNIFICANT**2
    counts = 1 / (1 + scatter / noise / FITTING / (1 + significance))
    return counts * sum_of_both / (2 * size[:, 0] ** 2)
