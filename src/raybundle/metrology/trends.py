"""Velocities: displacements of three dates and more against a constant velocity, by their joint covariance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail

YEAR = 365.25
"""Days"""
CONSTANT, FASTER, SLOWER, IRREGULAR = "constant", "accelerated", "decelerated", "irregular"
"""Verdicts: a constant velocity fits; a constant acceleration fits, along the velocity or against it; neither does"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Series:
    """Displacements of a point or an area against its first date."""

    name: str
    area: bool
    first: int
    """position of the first date"""
    dates: tuple[int, ...]
    """(k,) those of the others"""
    days: Array
    """(k,) since the first date"""
    displacement: Array
    """(k, axes) [m], or whatever changes"""
    covariance: Array
    """(axes k, axes k)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Trend:
    """The mean velocity of a series, its acceleration, and whether they describe it."""

    series: Series
    velocity: Array
    """(axes,) best constant velocity [m/day]"""
    velocity_covariance: Array
    """(axes, axes)"""
    p_none: float
    """probability of the velocity without motion"""
    p_constant: float
    """probability of the residuals at a constant velocity"""
    start: Array
    """(axes,) velocity at the first date, at a constant acceleration [m/day]"""
    acceleration: Array
    """(axes,) [m/day^2]"""
    acceleration_covariance: Array
    p_accelerated: float
    """probability of the residuals at a constant acceleration; NaN: three dates leave none"""

    def verdict(self, limit: float) -> str:
        """Which motion fits, each test at this probability."""
        if self.p_constant >= limit:
            return CONSTANT
        if self.p_accelerated < limit:
            return IRREGULAR
        return FASTER if self.acceleration @ self.velocity > 0 else SLOWER


def trend(series: Series, freedom: float) -> Trend:
    """The trend of a series of two later dates or more; freedom: of the variance factor in its covariance.

    Displacements are d(t) = v t, or d(t) = v t + a t^2 / 2, with the errors of the covariance: least squares, and
    F tests of what is left.
    """
    t = np.asarray(series.days, float)
    axes = series.displacement.shape[1]
    linear = np.kron(t[:, None], np.eye(axes))
    squares = np.hstack([linear, np.kron(t[:, None] ** 2 / 2, np.eye(axes))])
    v, Cv, rest = _solved(linear, series)
    x, C, left = _solved(squares, series)
    n, free = axes * len(t), axes * (len(t) - 2)
    speed = float(v @ np.linalg.solve(Cv, v))
    return Trend(
        series=series, velocity=v, velocity_covariance=Cv, p_none=fisher_tail(speed / axes, axes, freedom),
        p_constant=fisher_tail(rest / (n - axes), n - axes, freedom), start=x[:axes], acceleration=x[axes:],
        acceleration_covariance=C[axes:, axes:],
        p_accelerated=fisher_tail(left / free, free, freedom) if free else float("nan"),
    )  # fmt: skip


def _solved(A: Array, series: Series) -> tuple[Array, Array, float]:
    """Unknowns of a linear model of the displacements, their covariance, and the weighted square sum of residuals."""
    L = np.linalg.cholesky(series.covariance)
    whitened = np.linalg.solve(L, A)
    d = np.linalg.solve(L, series.displacement.ravel())
    size = np.linalg.norm(whitened, axis=0)
    Q, R = np.linalg.qr(whitened / size)
    x = np.linalg.solve(R, Q.T @ d) / size
    inverse = np.linalg.inv(R) / size[:, None]
    return x, inverse @ inverse.T, float(np.sum((d - whitened @ x) ** 2))


@dataclass(frozen=True, slots=True, kw_only=True)
class Trends:
    """The trends of a project, areas first."""

    dates: tuple[str, ...]
    trends: tuple[Trend, ...]
    limit: float
    """probability below which a motion is not of the kind that is tested: the significance over their number"""

    @classmethod
    def of(cls, dates: tuple[str, ...], trends: tuple[Trend, ...], significance: float) -> Trends:
        """Of a family of tests of this significance."""
        return cls(dates=dates, trends=trends, limit=significance / max(len(trends), 1))
