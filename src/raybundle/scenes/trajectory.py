"""A sensor's path and attitude in time from a table, and small polynomials that correct them.

Positions and quaternions are interpolated by the polynomial through the eight nearest entries (Lagrange).
Corrections are polynomials of the time tau, which runs from -1 at the first line to +1 at the last:

    P(t)  =  P_table(t) + E' (a0 + a1 tau + a2 tau^2)             E rows: along track, across track, up  [m]
    R(t)  =  exp([r0 + r1 tau + r2 tau^2]x) R_table(t)            body axes to detector axes             [rad]
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import cross_matrix

GAP = 1.5
"""Interval in multiples of the median interval above which a table counts as broken."""
COVER = 2.001
"""Intervals beyond its ends for which a table is continued."""
NEAREST = 8
"""Entries of a table through which the interpolating polynomial runs."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Trajectory:
    """Positions and attitudes of a sensor in the frame that turns with the body."""

    position_times: Array
    """(n,) [s]"""
    positions: Array
    """(n, 3) [m]"""
    attitude_times: Array
    """(m,) [s]"""
    quaternions: Array
    """(m, 4) detector axes to body axes, the scalar last; their signs and lengths do not matter."""

    def __post_init__(self) -> None:
        """Refuse tables that cannot be interpolated."""
        for name, times, values in (
            ("ephemeris", self.position_times, self.positions),
            ("attitude", self.attitude_times, self.quaternions),
        ):
            if len(times) != len(values) or len(times) < 2:
                raise InputError(f"{name}: {len(times)} times for {len(values)} entries; at least 2 of each are needed")
            if not (np.isfinite(times).all() and np.isfinite(values).all()):
                raise InputError(f"{name}: a time or value is not finite")
            interval = np.diff(times)
            if not (interval > 0).all():
                k = int(np.argmin(interval))
                raise InputError(f"{name}: time {times[k + 1]:g} s (entry {k + 2}) does not follow {times[k]:g} s")
        if (np.linalg.norm(self.quaternions, axis=1) < 1e-6).any():
            raise InputError("attitude: a quaternion of length zero")

    def check_cover(self, first: float, last: float) -> None:
        """Raise InputError unless the tables cover these times, but for two intervals at each end, without a gap."""
        for name, times in (("ephemeris", self.position_times), ("attitude", self.attitude_times)):
            interval = np.diff(times)
            usual = float(np.median(interval))
            if first < times[0] - COVER * usual or last > times[-1] + COVER * usual:
                raise InputError(
                    f"{name} covers {times[0]:g} to {times[-1]:g} s, the lines {first:g} to {last:g} s; the "
                    "table is cut off, or its start time belongs to another scene"
                )
            wide = (interval > GAP * usual) & (times[1:] > first) & (times[:-1] < last)
            if wide.any():
                k = int(np.flatnonzero(wide)[0])
                raise InputError(
                    f"{name} has a gap of {interval[k]:g} s from {times[k]:g} to {times[k + 1]:g} s, within the image, "
                    f"where {usual:g} s are usual; get a complete table"
                )

    @cached_property
    def _polynomials(self) -> tuple[Any, ...]:
        """Position and its first two derivatives, quaternion and its first."""
        q = self.quaternions / np.linalg.norm(self.quaternions, axis=1)[:, None]
        turned = np.cumprod(np.where(np.sum(q[1:] * q[:-1], axis=1) < 0, -1.0, 1.0))
        q[1:] *= turned[:, None]
        P = lagrange(self.position_times, self.positions)
        Q = lagrange(self.attitude_times, q, beyond=1)
        return P, P.derivative(1), P.derivative(2), Q, Q.derivative(1)

    def position(self, t: Array) -> tuple[Array, Array, Array]:
        """Position, velocity, acceleration (n, 3) at times (n,)."""
        P, V, A, _, _ = self._polynomials
        return P(t), V(t), A(t)

    def rotation(self, t: Array) -> tuple[Array, Array]:
        """Rotation (n, 3, 3) from detector to body axes and its derivative by time."""
        _, _, _, Q, dQ = self._polynomials
        q, dq = Q(t), dQ(t)
        S = q[:, :, None] * q[:, None, :]
        dS = dq[:, :, None] * q[:, None, :] + q[:, :, None] * dq[:, None, :]
        N, dN = np.einsum("nii->n", S)[:, None, None], np.einsum("nii->n", dS)[:, None, None]
        M, dM = _matrix(S), _matrix(dS)
        return M / N, dM / N - M * dN / (N * N)


def lagrange(times: Array, values: Array, *, beyond: int = 2) -> Any:
    """The polynomials through `NEAREST` entries around each interval of a table (n, k), as a SciPy PPoly.

    In local time they are small differences from the interval's first entry, so that the entries come back exactly.
    beyond  degree (1 or 2) with which the table is continued at its ends, where a high one would magnify noise
    """
    from scipy.interpolate import PPoly  # noqa: PLC0415  (SciPy only where a line sensor is used)

    n = len(times)
    m = min(NEAREST, n)
    k = np.arange(n - 1)
    window = np.clip(k - (m - 1) // 2, 0, n - m)[:, None] + np.arange(m)
    h = np.diff(times)
    s = (times[window] - times[:-1, None]) / h[:, None]
    local = np.linalg.solve(s[:, :, None] ** np.arange(m), values[window] - values[:-1, None])
    local /= h[:, None, None] ** np.arange(m)[:, None]
    local[:, 0] = values[:-1]
    inner = PPoly(np.moveaxis(local[:, ::-1], 1, 0), times)
    ends = np.zeros((2, max(m, 3), values.shape[1]))
    first, last = times[0] - h[0], times[-1]
    for end, at, start in ((ends[0], times[0], first), (ends[1], last, last)):
        value, slope, half = inner(at), inner(at, 1), inner(at, 2) / 2 if beyond == 2 else 0.0
        back = start - at
        end[0], end[1], end[2] = value + back * slope + back**2 * half, slope + 2 * back * half, half
    wide = np.zeros((n - 1, max(m, 3), values.shape[1]))
    wide[:, :m] = local
    every = np.concatenate([ends[:1], wide, ends[1:]])
    return PPoly(np.moveaxis(every[:, ::-1], 1, 0), np.concatenate([[first], times, [last + h[-1]]]))


def rotation_from_quaternion(q: Array) -> Array:
    """Rotations (n, 3, 3) of quaternions (n, 4), scalar last, of any length."""
    S = q[:, :, None] * q[:, None, :]
    return _matrix(S) / np.einsum("nii->n", S)[:, None, None]


def _matrix(S: Array) -> Array:
    """The rotation matrix, linear in the products S = q q' of a quaternion, scalar last."""
    x, y, z, w = 0, 1, 2, 3
    rows = [
        [
            S[:, w, w] + S[:, x, x] - S[:, y, y] - S[:, z, z],
            2 * (S[:, x, y] - S[:, w, z]),
            2 * (S[:, x, z] + S[:, w, y]),
        ],
        [
            2 * (S[:, x, y] + S[:, w, z]),
            S[:, w, w] - S[:, x, x] + S[:, y, y] - S[:, z, z],
            2 * (S[:, y, z] - S[:, w, x]),
        ],
        [
            2 * (S[:, x, z] - S[:, w, y]),
            2 * (S[:, y, z] + S[:, w, x]),
            S[:, w, w] - S[:, x, x] - S[:, y, y] + S[:, z, z],
        ],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


@dataclass(frozen=True, slots=True, kw_only=True)
class CorrectionModel:
    """Which polynomials correct a trajectory; degree -1: none."""

    position_degree: int = -1
    """Along track, across track and up; 2 is good to a millimetre over a scene of 1 to 2 s."""
    attitude_degree: int = -1
    """About the detector's three axes; 2 leaves up to 1.4 px over such a scene."""

    def __post_init__(self) -> None:
        """Refuse degrees that are none."""
        for name in ("position_degree", "attitude_degree"):
            if not -1 <= getattr(self, name) <= 2:
                raise InputError(f"{name} {getattr(self, name)} is not -1 (none), 0, 1 or 2")

    @property
    def symbols(self) -> tuple[str, ...]:
        """Parameters in their order: along0, across0, up0 [m], along1, ..., rx0, ry0, rz0 [rad], rx1 ..."""
        position = [f"{s}{k}" for k in range(self.position_degree + 1) for s in ("along", "across", "up")]
        return (*position, *(f"{s}{k}" for k in range(self.attitude_degree + 1) for s in ("rx", "ry", "rz")))

    def split(self, values: Array) -> tuple[Array, Array]:
        """Coefficients (p + 1, 3) of the position and (q + 1, 3) of the attitude."""
        values = np.asarray(values, float)
        if values.shape != (len(self.symbols),):
            raise InputError(f"{len(self.symbols)} correction parameters are needed, not {values.shape}")
        k = 3 * (self.position_degree + 1)
        return values[:k].reshape(-1, 3), values[k:].reshape(-1, 3)


def polynomial(coefficients: Array, tau: Array) -> tuple[Array, Array]:
    """Value and derivative by tau (n, 3) of polynomials with coefficients (p, 3), lowest power first."""
    value, slope = np.zeros((len(tau), 3)), np.zeros((len(tau), 3))
    for k in range(len(coefficients) - 1, -1, -1):
        slope = slope * tau[:, None] + value
        value = value * tau[:, None] + coefficients[k]
    return value, slope


def left_jacobian(vector: Array) -> Array:
    """(n, 3, 3): exp([v + d]x) = exp([J d]x) exp([v]x) to first order; series, for angles up to 0.01 rad."""
    K = cross_matrix(vector)
    return np.eye(3) + K / 2 + K @ K / 6
