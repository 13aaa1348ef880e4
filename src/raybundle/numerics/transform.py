"""Similarity transforms between two sets of points."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.deviations import COUPLED, deviations_after, known_after, without_remains
from raybundle.numerics.rotation import cross_matrix

TILTED = 1e-9
"""Angle between the verticals before and after [rad] from which what is upright is so no longer: 1 um in 1 km."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SimilarityTransform:
    """X -> scale * rotation @ X + translation."""

    scale: float = 1.0
    """Larger than 0"""
    rotation: Array = field(default_factory=lambda: np.eye(3))
    """(3, 3)"""
    translation: Array = field(default_factory=lambda: np.zeros(3))
    """(3,)"""

    def __post_init__(self) -> None:
        """Lists count as arrays; raises InputError for other shapes and numbers that are not finite."""
        for name, shape in (("rotation", (3, 3)), ("translation", (3,))):
            value = np.asarray(getattr(self, name), float)
            if value.shape != shape or not np.isfinite(value).all():
                raise InputError("transform.wrong_shape", name=name, shape=value.shape, needed=shape)
            object.__setattr__(self, name, value)

    @property
    def inverse(self) -> SimilarityTransform:
        """The way back."""
        R = self.rotation.T
        return SimilarityTransform(scale=1 / self.scale, rotation=R, translation=-(R @ self.translation) / self.scale)

    def after(self, first: SimilarityTransform) -> SimilarityTransform:
        """First the other, then this."""
        return SimilarityTransform(
            scale=self.scale * first.scale,
            rotation=self.rotation @ first.rotation,
            translation=self.points(first.translation[None])[0],
        )

    @property
    def is_identity(self) -> bool:
        """Whether nothing moves."""
        return bool(self.scale == 1 and (self.rotation == np.eye(3)).all() and (self.translation == 0).all())

    @property
    def tilts(self) -> bool:
        """Whether what is vertical is so no longer."""
        return bool(np.linalg.norm(self.rotation[:, 2] - [0, 0, 1]) > TILTED)

    @property
    def turns(self) -> bool:
        """Whether one of the axes gets another direction."""
        return bool(np.abs(self.rotation - np.eye(3)).max() > COUPLED)

    def points(self, xyz: Array) -> Array:
        """Transformed points (..., 3); NaN where a coordinate that is asked for is not known."""
        return self.vectors(xyz) + self.translation

    def vectors(self, d: Array) -> Array:
        """Transformed differences of points (..., 3); NaN where a component that is asked for is not known."""
        d = np.asarray(d, float)
        moved = self.scale * d @ self.rotation.T
        part = np.isnan(d).any(axis=-1) & ~np.isnan(d).all(axis=-1)
        if part.any():
            there = known_after(self.rotation, ~np.isnan(d[part]))
            rest = self.scale * np.nan_to_num(d[part]) @ without_remains(self.rotation).T
            moved[part] = np.where(there, rest, np.nan)
        return moved

    def covariances(self, covariance: Array) -> Array:
        """Transformed covariances (..., 3, 3) of points; the transform itself counts as free of error."""
        return self.scale**2 * self.rotation @ covariance @ self.rotation.T

    def deviations(self, sigma: Array) -> Array:
        """Transformed standard deviations (k, 3) of uncorrelated coordinates, NaN where not known; see `kept_after`."""
        return self.scale * deviations_after(self.rotation, sigma)

    def rotations(self, sensor_from_source: Array) -> Array:
        """Rotations (..., 3, 3) from target axes to image axes."""
        return sensor_from_source @ self.rotation.T


@dataclass(frozen=True, slots=True, kw_only=True)
class Similarity(SimilarityTransform):
    """target = scale * rotation @ source + translation, as it was fitted."""

    residuals: Array
    """(n, 3) transformed source - target"""
    sigma0: float
    """Standard deviation of a target coordinate; NaN without redundancy (n = 2 is not enough either)."""
    covariance: Array
    """(7, 7) of translation of the centroid, rotation vector, scale; a-posteriori, isotropic target errors"""


def similarity(source: Array, target: Array, weights: Array | None = None, *, scale: float | None = None) -> Similarity:
    """Least squares similarity of points (n, 3) onto points (n, 3), closed form.

    weights  (n,) of the points, 1 / variance up to a factor; None: all the same
    scale    a given scale is kept
    raises   InputError for fewer than three points or points in a line

    Horn 1987; Umeyama 1991.  Errors of the source are neglected.
    """
    source, target = np.asarray(source, float), np.asarray(target, float)
    n = len(source)
    if n < 3 or source.shape != target.shape:
        raise InputError("similarity.too_few_points", n=n)
    w = np.ones(n) if weights is None else np.asarray(weights, float)
    total = w.sum()
    cs, ct = w @ source / total, w @ target / total
    a, b = source - cs, target - ct
    u, d, vt = np.linalg.svd((b * w[:, None]).T @ a)
    if d[1] <= 1e-12 * max(d[0], 1e-300):
        raise InputError("similarity.points_in_line")
    sign = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    R = (u * sign) @ vt
    spread = float(w @ np.sum(a * a, axis=1))
    factor = float(d @ sign) / spread if scale is None else scale
    t = ct - factor * R @ cs
    residuals = factor * source @ R.T + t - target
    free = 6 + (scale is None)
    redundancy = 3 * n - free
    sigma0 = float(np.sqrt(np.sum(w[:, None] * residuals**2) / redundancy)) if redundancy > 0 else float("nan")
    turned = factor * a @ R.T
    A = np.zeros((n, 3, 7))
    A[:, :, :3] = np.eye(3)
    A[:, :, 3:6] = -cross_matrix(turned)
    A[:, :, 6] = turned / factor
    A = A[:, :, :free].reshape(-1, free)
    N = (A * np.repeat(w, 3)[:, None]).T @ A
    covariance = np.zeros((7, 7))
    covariance[:free, :free] = np.linalg.inv(N) * (sigma0**2 if redundancy > 0 else 1.0)
    return Similarity(
        scale=factor, rotation=R, translation=t, residuals=residuals, sigma0=sigma0, covariance=covariance
    )


def robust_similarity(
    source: Array, target: Array, tolerance: float, *, scale: float | None = None
) -> tuple[Similarity, Array]:
    """Similarity over the largest set of points (n, 3) that agree within a tolerance; also the mask (n,) of that set.

    scale  a given scale is kept
    All triples where there are few points, else 500 drawn by a fixed seed (RANSAC, Fischler and Bolles 1981).
    """
    n = len(source)
    from itertools import combinations
    from math import comb

    if comb(n, 3) <= 500:
        triples = [np.array(t) for t in combinations(range(n), 3)]
    else:
        rng = np.random.default_rng(0)
        triples = [rng.choice(n, 3, replace=False) for _ in range(500)]
    best, best_mask = -1.0, np.ones(n, bool)
    for t in triples:
        try:
            s = similarity(source[t], target[t], scale=scale)
        except InputError:
            continue
        error = np.linalg.norm(s.points(source) - target, axis=1)
        score = float(np.sum(np.maximum(0, 1 - (error / tolerance) ** 2)))
        if score > best:
            best, best_mask = score, error < tolerance
    if best_mask.sum() < 3:
        best_mask = np.ones(n, bool)
    return similarity(source[best_mask], target[best_mask], scale=scale), best_mask
