"""What the residuals of matched windows show of relief within them: two figures of each tie point.

A window that is plane leaves the noise of its grey values.  Relief displaces parts of it along the parallax, and the
residuals grow: by how much is the misfit.  So do occlusions, reflections, blur that differs; but these displace parts
in any direction.  What is displaced along the parallax over what is displaced across is the relief.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each
from raybundle.ties.block import viewing_lines

CALM = 0.05
"""Share of the windows of one size and brightness that are plane: their residuals are the noise."""
CLASSES, FEWEST = 4, 100
"""Classes of brightness, where each has so many matches: the noise of a sensor grows with it."""
TOGETHER = 9
"""Points whose parts are looked at together: those of one point are few, and hold noise."""


def misfit_and_relief(block: Block, residual: Array, window_px: Array, reference: Mask) -> tuple[Array, Array]:
    """Two figures (p,) of the points of a block; NaN where nothing was matched.

    residual    (m, FIGURES) of the matches, as `WindowMatches.residual` has them
    window_px   (m,) standard deviation of the windows' weights; NaN where nothing was matched
    reference   (m,) image points from which windows are taken
    The first is the variance of the residuals over that of the noise, geometric mean of the matches; the second the
    power of displacements along the parallax over that across, of the point and its neighbours.
    """
    o, count = block.observations, len(block.points)
    rows = np.flatnonzero(np.isfinite(window_px) & (residual[:, 0] > 0))
    misfit, relief = np.full(count, np.nan), np.full(count, np.nan)
    if not len(rows):
        return misfit, relief
    point = o.point[rows]
    ratio = np.log(residual[rows, 0] / _noise(residual[rows], window_px[rows]))
    matches = np.bincount(point, minlength=count)
    there = matches > 0
    misfit[there] = np.exp(np.bincount(point, ratio, count)[there] / matches[there])
    along = parallax(block, rows, reference)
    length = np.linalg.norm(along, axis=1, keepdims=True)
    along = np.divide(along, length, out=np.zeros_like(along), where=length > 0)
    along, across = _powers(residual[rows], along)
    sums = np.stack([np.bincount(point, values, count) for values in (along, across)], axis=1)
    relief[there] = _together(block.points.xyz[there], sums[there])
    return misfit, relief


def _noise(residual: Array, window_px: Array) -> Array:
    """(k,) variance of the noise of matches, by windows of the same size and brightness."""
    found = np.empty(len(residual))
    for size in np.unique(window_px):
        mine = np.flatnonzero(window_px == size)
        mine = mine[np.argsort(residual[mine, 1], kind="stable")]
        for some in np.array_split(mine, max(1, min(CLASSES, len(mine) // FEWEST))):
            found[some] = np.quantile(residual[some, 0], CALM)
    return found


def parallax(block: Block, rows: Index, reference: Mask) -> Array:
    """(k, 2) how image points move where the points move away along the rays of their references [px per length]."""
    o, xyz = block.observations, block.points.xyz
    of = np.full(len(block.points), -1)
    of[o.point[reference]] = np.flatnonzero(reference)
    own = of[o.point[rows]]
    origin, direction = viewing_lines(replace(block, observations=o.rows(own)))
    point = o.point[rows]
    step = 1e-3 * np.linalg.norm(xyz[point] - origin, axis=1, keepdims=True)
    found = np.zeros((len(rows), 2))
    for image, mine in enumerate(rows_of_each(o.image[rows], len(block.images))):
        if len(mine):
            here = xyz[point[mine]]
            there = here + step[mine] * direction[mine]
            found[mine] = predicted_px(block, image, there) - predicted_px(block, image, here)
    return np.divide(found, step, out=np.zeros_like(found), where=step > 0)


def _powers(residual: Array, along: Array) -> tuple[Array, Array]:
    """(k,) each: squares of displacements along a direction (k, 2) and across, in units of what noise of 1 makes."""

    def power(d: Array) -> Array:
        terms = np.stack([d[:, 0] ** 2, 2 * d[:, 0] * d[:, 1], d[:, 1] ** 2], axis=1)
        found, unit = (terms * residual[:, 2:5]).sum(axis=1), (terms * residual[:, 5:8]).sum(axis=1)
        return np.divide(found, unit, out=np.zeros(len(d)), where=unit > 0)

    return power(along), power(along[:, ::-1] * [-1.0, 1.0])


def _together(xyz: Array, sums: Array) -> Array:
    """(k,) ratio of two sums (k, 2) over each point and its nearest neighbours."""
    from scipy.spatial import KDTree

    near = KDTree(xyz).query(xyz, k=min(TOGETHER, len(xyz)))[1].reshape(len(xyz), -1)
    along, across = sums[near].sum(axis=1).T
    return np.divide(along, across, out=np.ones(len(xyz)), where=across > 0)
