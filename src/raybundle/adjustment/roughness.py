"""What relief within the windows of matching adds to the variances of tie points.

A tie point is measured where its window lies, not where its surface does: relief within the window moves all of its
rays alike, along their mean direction, and no residual of the adjustment shows it.  Residuals of the grey values do.
With M how far their variance exceeds that of noise (`Points.misfit` less 1), S the share of their power that displaces
parts of the window along the parallax (1 - 1 / `Points.relief`), T the square sum of the point's residuals over its
redundancy, and W how much larger its window is than the smallest of its neighbours, it is

    variance = s^2 FACTOR M^a S^b T^c W^d

where s is the standard deviation along the rays without it, which holds how steep grey values are, and how parallax
follows depth: displacements of equal size make M s^2 equal. In a larger window noise averages out and relief, which
holds together, less.  M and S are the larger of those of the point and of the median of its neighbours: relief is a
matter of a place. Exponents and factor by maximum likelihood (Student's distribution with 3 degrees of freedom) of
the errors of 12 000 tie points of three rendered sets of other pixels on the object (1, 2 and 4 mm), compression and
blur, of smooth, steep and broken ground and clutter. The scale of that distribution holds 61 % of the errors; FACTOR
is 1.43 times that of the fit, so that one standard deviation holds 68 %.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.network import with_std
from raybundle.adjustment.result import Adjustment, Notice, Precision
from raybundle.block import Role
from raybundle.block.rigs import without_rigs
from raybundle.numerics.arrays import Array, Mask

FACTOR, BY_MISFIT, BY_RELIEF, BY_RESIDUALS, BY_WINDOW = 1.45, 1.55, 1.3, 0.9, 1.0
LEAST_MISFIT, LEAST_SHARE = 0.1, 0.03
"""What is less is noise of the figures."""
NEIGHBOURS = 25
FIGURES = ("window", "misfit", "relief")
"""Columns of object points that relief is taken from, all or none."""
HIGHEST = 2.0
"""Windows (`Points.window`): a window shows no relief that is higher than it is wide."""


def with_roughness(result: Adjustment) -> Adjustment:
    """The result with variances of tie points that hold the relief within their windows; `Precision.roughness`."""
    points, precision = result.adjusted.points, result.precision
    if precision is None or points.misfit is None or points.relief is None or points.window is None:
        return result
    variance = np.diagonal(precision.object_points, axis1=1, axis2=2)
    figures = np.stack([points.misfit, points.relief, points.window], axis=1)
    known = np.isfinite(figures).all(axis=1) & np.isfinite(variance).all(axis=1)
    known &= (np.asarray(points.role) == Role.TIE) & np.isfinite(points.xyz).all(axis=1)
    direction, towards = _mean_rays(result)
    known &= towards
    if not known.any():
        return result
    d, C = direction[known], precision.object_points[known]
    exponents = np.array([BY_MISFIT, BY_RELIEF, BY_RESIDUALS, BY_WINDOW])
    factor = FACTOR * np.exp(terms(result, known) @ exponents)
    along = np.maximum(np.einsum("pi,pij,pj->p", d, C, d), 0.0)
    roughness = np.zeros((len(points), 3))
    roughness[known] = np.minimum(np.sqrt(factor * along), HIGHEST * points.window[known])[:, None] * d
    wider = widened(precision, roughness)
    network = None if result.network is None else with_std(result.network, wider.object_point_std)
    return replace(result, precision=wider, network=network)


def relief_notices(result: Adjustment) -> list[Notice]:
    """A caution where some figures of the windows of tie points are there and others are not: none then counts."""
    figures = {n: getattr(result.adjusted.points, n) for n in FIGURES}
    missing = [n for n, values in figures.items() if values is None]
    if result.precision is None or not missing or len(missing) == len(figures):
        return []
    return [Notice(code="relief_unknown", values={"columns": missing}, ids=tuple(missing))]


def widened(precision: Precision, roughness: Array) -> Precision:
    """The precision with what relief adds to the variances of points: vectors (p, 3) along their mean rays."""
    wider = precision.object_points + roughness[:, :, None] * roughness[:, None, :]
    return replace(precision, object_points=wider, roughness=roughness)


def doubled(precision: Precision | None) -> tuple[int, int]:
    """Tie points of which relief within the window more than doubles the standard deviation along their rays; of all.

    (0, 0) where no window is known.
    """
    if precision is None or precision.roughness is None:
        return 0, 0
    r, C = precision.roughness, precision.object_points
    square = (r**2).sum(axis=1)
    known = np.isfinite(square) & (square > 0)
    r, square = r[known], square[known]
    whole = np.einsum("pi,pij,pj->p", r, C[known], r) / square
    return int((whole > 4 * (whole - square)).sum()), len(r)


def terms(result: Adjustment, known: Mask) -> Array:
    """(k, 4) logarithms of M, S, T and W of the points of a mask (p,) of which window, misfit and relief are known."""
    from scipy.spatial import KDTree  # noqa: PLC0415

    points = result.adjusted.points
    assert points.misfit is not None
    assert points.relief is not None
    assert points.window is not None
    xyz = points.xyz[known]
    near = KDTree(xyz).query(xyz, k=min(NEIGHBOURS, len(xyz)))[1].reshape(len(xyz), -1)
    own = (
        np.log(np.maximum(points.misfit[known] - 1, LEAST_MISFIT)),
        np.log(np.maximum(1 - 1 / np.maximum(points.relief[known], 1), LEAST_SHARE)),
    )
    of_places = [np.maximum(t, np.median(t[near], axis=1)) for t in own]
    window = points.window[known]
    larger = np.log(window / window[near].min(axis=1))
    return np.stack([*of_places, np.log(_residual_ratio(result)[known]), larger], axis=1)


def _residual_ratio(result: Adjustment) -> Array:
    """(p,) square sum of standardised residuals over the redundancy of each point; drawn to 1 where that is little."""
    s, o = result.image_observations, result.given.observations
    rows, count = np.flatnonzero(s.used), len(result.given.points)
    sigma2 = o.cov_px2[rows, :2] * result.variance_factor
    square = (s.residuals_px[rows] ** 2 / sigma2).sum(axis=1)
    redundancy = np.nan_to_num(s.redundancy[rows].sum(axis=1))
    squares, redundancies = (np.bincount(o.point[rows], np.nan_to_num(w), count) for w in (square, redundancy))
    return (squares + 1) / (redundancies + 1)


def _mean_rays(result: Adjustment) -> tuple[Array, Mask]:
    """(p, 3) mean unit direction from each point to its projection centres, and for which points there is one."""
    block, o = without_rigs(result.adjusted), result.given.observations
    rows = np.flatnonzero(result.image_observations.used)
    ray = block.images.centre[o.image[rows]] - block.points.xyz[o.point[rows]]
    ray = ray / np.linalg.norm(ray, axis=1, keepdims=True)
    count = len(block.points)
    total = np.stack([np.bincount(o.point[rows], ray[:, k], count) for k in range(3)], axis=1)
    length = np.linalg.norm(total, axis=1)
    there = np.isfinite(length) & (length > 0)
    return np.divide(total, length[:, None], out=np.zeros_like(total), where=there[:, None]), there
