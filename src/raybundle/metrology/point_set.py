"""Measured points with their joint covariance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import cross_matrix
from raybundle.numerics.transform import SimilarityTransform


@dataclass(frozen=True, slots=True, kw_only=True)
class PointSet:
    """Points of one measurement, in any datum."""

    name: str
    ids: tuple[str, ...]
    xyz: Array
    """(n, 3) coordinates [m]"""
    covariance: Array
    """(3 n, 3 n) of the coordinates in the order X, Y, Z of each point [m^2]; may be singular by the datum"""
    freedom: float = float("inf")
    """Degrees of freedom of the variance factor in the covariance; infinite where it is known beforehand"""
    free_scale: bool = False
    """Whether nothing measured the scale"""

    def __post_init__(self) -> None:
        """Raises InputError for shapes that do not fit, and for points of one name."""
        n = len(self.ids)
        if self.xyz.shape != (n, 3) or self.covariance.shape != (3 * n, 3 * n):
            raise InputError(
                "measurement.shapes", name=self.name, n=n, xyz=self.xyz.shape, covariance=self.covariance.shape
            )
        if len(set(self.ids)) != n:
            twice = next(i for i in self.ids if self.ids.count(i) > 1)
            raise InputError("measurement.point_twice", name=self.name, point=twice)

    def rows(self, at: Sequence[int] | Index) -> PointSet:
        """Some of the points."""
        at = np.asarray(at, np.int64)
        each = (3 * at[:, None] + np.arange(3)).ravel()
        return replace(
            self, ids=tuple(self.ids[k] for k in at), xyz=self.xyz[at], covariance=self.covariance[np.ix_(each, each)]
        )

    def named(self, ids: Sequence[str]) -> PointSet:
        """The points of these names; raises InputError for one that is not there."""
        place = {name: k for k, name in enumerate(self.ids)}
        missing = [i for i in ids if i not in place]
        if missing:
            raise InputError("measurement.unknown_points", name=self.name, points=missing)
        return self.rows([place[i] for i in ids])

    def moved(self, by: SimilarityTransform) -> PointSet:
        """In other axes; the transform counts as free of error."""
        n = len(self.ids)
        C = self.covariance.reshape(n, 3, n, 3)
        A = by.scale * by.rotation
        turned = np.einsum("ab,ibjc,dc->iajd", A, C, A, optimize=True)
        return replace(self, xyz=by.points(self.xyz), covariance=turned.reshape(3 * n, 3 * n))

    @property
    def sigma(self) -> Array:
        """(n, 3) standard deviations of X, Y, Z [m]."""
        return np.sqrt(np.maximum(np.diagonal(self.covariance), 0)).reshape(-1, 3)

    def scale_sigma(self, more: Array | None = None) -> float:
        """Standard deviation of the scale of all points, as a share, by their joint covariance.

        more  (n, 3) standard deviations of coordinates that they are held against [m]; None: these are exact
        """
        p = (self.xyz - self.xyz.mean(axis=0)).ravel()
        p = p / max(float(p @ p), 1e-300)
        Q = self.covariance if more is None else self.covariance + np.diag((more**2).ravel())
        return float(np.sqrt(max(float(p @ Q @ p), 0.0)))

    @property
    def own(self) -> Array:
        """(n, 3, 3) covariances of the single points."""
        n = len(self.ids)
        return self.covariance.reshape(n, 3, n, 3)[np.arange(n), :, np.arange(n), :]


def datum_directions(xyz: Array, *, scale: bool, about: Mask | None = None) -> Array:
    """(n, 3, 6 or 7) what shifts, small turns and, if asked for, a scale do to points.

    about  points of which the middle is the origin and the size the unit; None: all
    """
    some = xyz if about is None else xyz[about]
    middle = some.mean(axis=0)
    size = max(float(np.sqrt(np.mean(np.sum((some - middle) ** 2, axis=1)))), 1e-300)
    p = (xyz - middle) / size
    parts = [np.tile(np.eye(3), (len(p), 1, 1)), -cross_matrix(p)]
    return np.concatenate([*parts, p[:, :, None]] if scale else parts, axis=2)
