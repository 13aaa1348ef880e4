"""What matching adds to the variances of tie points: relief within the windows, and noise that a place has more of.

A tie point is measured where its window lies, not where its surface does: relief within the window moves all of its
rays alike, along their mean direction, and no residual of the adjustment shows it.  Residuals of the grey values do.
With M how far their variance exceeds that of noise (`Points.misfit` less 1), S the share of their power that displaces
parts of the window along the parallax (1 - 1 / `Points.relief`), T the square sum of the point's residuals over its
redundancy r, W how much larger its window w is than the smallest of its neighbours, and s the standard deviation along
the rays without it, which holds how steep grey values are, and how parallax follows depth, it is

    variance = w^2 FACTOR M^a S^b T^c W^d (s^2 (1 + r) / w^2)^e

s^2 (1 + r) is the variance by few rays: what moves all rays alike does not average out.  In a larger window noise
averages out and relief, which holds together, less.  M and S are the larger of those of the point and of the median
of its neighbours: relief is a matter of a place.  Neighbours stand on the same relief, and scatter by it about a plane:
1 / variance is that of above and 1 / (OF_SCATTER scatter^2) together.  It is at least OF_PLACE times the median of the
neighbours.  What a correction for curvature leaves (`Points.sigma_curvature`) adds to it.

Residuals of a point and its neighbours whose square sum is larger than their redundancy, beyond chance, show noise
that grey values do not promise: where texture is weak, that of compression is no white noise.  The variance grows as
their ratio.

Exponents and factors by maximum likelihood (Student's distribution with 3 degrees of freedom) of the errors of tie
points of 18 rendered sets of other pixels on the object (1 to 4 mm), compression and blur
(`benchmarks/tie_roughness.py`).  The scale of that distribution holds 61 % of the errors; factors are 1.43 times those
of the fit, so that one standard deviation holds 68 %, rounded up.  OF_SCATTER is that of matches corrected for
curvature (2.1 without).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.figures import Precision
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.network import with_std
from raybundle.block import Role
from raybundle.block.rigs import without_rigs
from raybundle.numerics.arrays import Array, Index, Mask

FACTOR, BY_MISFIT, BY_RELIEF, BY_RESIDUALS, BY_WINDOW, BY_NOISE = 120.0, 2.0, 2.0, 1.0, 5.5, 2.5
OF_SCATTER, OF_PLACE = 1.5, 0.25
LEAST_MISFIT, LEAST_SHARE = 0.1, 0.03
"""What is less is noise of the figures."""
NEIGHBOURS, NEAREST, OF_PLANE = 25, 9, 10
"""Points of a place, the nearest of them, each with the point itself; neighbours through which a plane is laid"""
BEYOND = 2.0
"""Standard deviations by which chance lets residuals of a place exceed their redundancy."""
FIGURES = ("window", "misfit", "relief")
"""Columns of object points that relief is taken from, all or none."""
HIGHEST = 2.0
"""Windows (`Points.window`): a window shows no relief that is higher than it is wide."""
PART = 50_000
"""Points whose neighbours are held at a time."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Witnesses:
    """What k tie points and their neighbours show of relief and noise."""

    along: Array
    """(k,) variances along the mean rays by the adjustment"""
    window: Array
    """(k,)"""
    terms: Array
    """(k, 5) logarithms of M, S, T, W and s^2 (1 + r) / w^2"""
    scatter: Array
    """(k,) variances of neighbours about planes, along the mean ray, median of a place; infinite where they are few"""
    noise: Array
    """(k,) by how much variances are larger than the adjustment has them, by the residuals of a place; at least 1"""
    near: Index
    """(k, <= NEAREST) the point and its nearest neighbours"""

    def variance(
        self,
        factor: float = FACTOR,
        exponents: Sequence[float] = (BY_MISFIT, BY_RELIEF, BY_RESIDUALS, BY_WINDOW, BY_NOISE),
        of_scatter: float = OF_SCATTER,
        of_place: float = OF_PLACE,
    ) -> Array:
        """(k,) what is added along the mean rays."""
        own = self.window**2 * np.minimum(factor * np.exp(self.terms @ np.asarray(exponents)), HIGHEST**2)
        bound = of_scatter * self.scatter
        with np.errstate(divide="ignore"):
            own = 1 / (1 / own + 1 / bound)
        relief = np.maximum(own, of_place * np.median(own[self.near], axis=1))
        return relief + (self.noise - 1) * self.along


def with_roughness(result: Adjustment) -> Adjustment:
    """The result with variances of tie points that hold relief and noise of their place; `Precision.roughness`."""
    points, precision = result.adjusted.points, result.precision
    if precision is None or points.misfit is None or points.relief is None or points.window is None:
        return result
    variance = np.diagonal(precision.object_points, axis1=1, axis2=2)
    figures = np.stack([points.misfit, points.relief, points.window], axis=1)
    known = np.isfinite(figures).all(axis=1) & np.isfinite(variance).all(axis=1)
    known &= (np.asarray(points.role) == Role.TIE) & np.isfinite(points.xyz).all(axis=1)
    direction, towards = mean_rays(result)
    known &= towards
    if not known.any():
        return result
    d = direction[known]
    roughness = np.zeros((len(points), 3))
    variance = witnesses(result, known, d).variance()
    if points.sigma_curvature is not None:
        variance = variance + np.nan_to_num(points.sigma_curvature[known]) ** 2
    roughness[known] = np.sqrt(variance)[:, None] * d
    wider = widened(precision, roughness)
    network = None if result.network is None else with_std(result.network, wider.object_point_std)
    return replace(result, precision=wider, network=network)


def relief_notices(result: Adjustment) -> list[Notice]:
    """A caution where some figures of the windows of tie points are there and others are not: none then counts."""
    points = result.adjusted.points
    missing = [n for n in FIGURES if getattr(points, n) is None]
    none = len(missing) == len(FIGURES) and points.sigma_curvature is None
    if result.precision is None or not missing or none:
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


def witnesses(result: Adjustment, known: Mask, direction: Array) -> Witnesses:
    """Of the points of a mask (p,) of which window, misfit and relief are known, with unit mean rays (k, 3)."""
    from scipy.spatial import KDTree

    points, precision = result.adjusted.points, result.precision
    assert precision is not None
    assert points.misfit is not None
    assert points.relief is not None
    assert points.window is not None
    xyz, window = points.xyz[known], points.window[known]
    near = KDTree(xyz).query(xyz, k=min(NEIGHBOURS, len(xyz)))[1].reshape(len(xyz), -1)
    along = np.einsum("pi,pij,pj->p", direction, precision.object_points[known], direction)
    along = np.maximum(along, np.finfo(float).tiny)
    square, redundancy = (w[known] for w in _squares(result))
    own = (
        np.log(np.maximum(points.misfit[known] - 1, LEAST_MISFIT)),
        np.log(np.maximum(1 - 1 / np.maximum(points.relief[known], 1), LEAST_SHARE)),
    )
    terms = (
        *(np.maximum(t, np.median(t[near], axis=1)) for t in own),
        np.log((square + 1) / (redundancy + 1)),
        np.log(window / window[near].min(axis=1)),
        np.log(along * (1 + redundancy) / window**2),
    )
    nearest = near[:, :NEAREST]
    return Witnesses(
        along=along, window=window, terms=np.stack(terms, axis=1), scatter=_scatter(xyz, direction, near),
        noise=_noise(square[nearest].sum(axis=1), redundancy[nearest].sum(axis=1)), near=nearest,
    )  # fmt: skip


def _noise(square: Array, redundancy: Array) -> Array:
    """(k,) square sums of residuals over their redundancies where they are larger beyond chance; else 1."""
    r = np.maximum(redundancy, 1e-9)
    return np.where(square > r + BEYOND * np.sqrt(2 * r), square / r, 1.0)


def _scatter(xyz: Array, direction: Array, near: Index) -> Array:
    """(k,) see `Witnesses.scatter`; of points (k, 3) with unit directions (k, 3) and rows of neighbours (k, n)."""
    count = min(near.shape[1] - 1, OF_PLANE)
    if count <= 3:
        return np.full(len(xyz), np.inf)
    found = np.empty(len(xyz))
    for k in range(0, len(xyz), PART):
        d = direction[k : k + PART]
        v = xyz[near[k : k + PART, 1 : count + 1]]
        v = v - v.mean(axis=1, keepdims=True)
        z = np.einsum("pki,pi->pk", v, d)
        v -= z[..., None] * d[:, None]
        N = np.einsum("pki,pkj->pij", v, v)
        # along d there is nothing to solve for; neighbours on a line leave one slope open, which is then none
        size = np.trace(N, axis1=1, axis2=2)[:, None, None] + 1e-100
        N += size * (d[:, :, None] * d[:, None, :] + 1e-9 * np.eye(3))
        slope = np.linalg.solve(N, np.einsum("pki,pk->pi", v, z)[..., None])
        left = z - (v @ slope)[..., 0]
        found[k : k + PART] = (left**2).sum(axis=1) / (count - 3)
    return np.median(found[near[:, : OF_PLANE + 1]], axis=1)


def _squares(result: Adjustment) -> tuple[Array, Array]:
    """(p,) each: square sum of standardised residuals of each point, and its redundancy."""
    s, o = result.image_observations, result.given.observations
    rows, count = np.flatnonzero(s.used), len(result.given.points)
    sigma2 = o.cov_px2[rows, :2] * result.variance_factor
    square = (s.residuals_px[rows] ** 2 / sigma2).sum(axis=1)
    redundancy = np.nan_to_num(s.redundancy[rows].sum(axis=1))
    squares, redundancies = (np.bincount(o.point[rows], np.nan_to_num(w), count) for w in (square, redundancy))
    return squares, redundancies


def mean_rays(result: Adjustment) -> tuple[Array, Mask]:
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
