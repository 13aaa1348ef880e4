"""A sensor's path and attitude in time from a table, and what corrects them.

Positions and quaternions are interpolated by the polynomial through the eight nearest entries (Lagrange).
Corrections are sums of a polynomial and a curve (`corrections`) of the time tau, which runs from -1 at the first line
to +1 at the last; dt is an offset between the clocks, a a lever arm:

    R(t)  =  exp([r(tau)]x) R_table(t + dt)                       body axes to detector axes             [rad]
    P(t)  =  P_table(t + dt) + E' p(tau) - R(t)' a                E rows: along track, across track, up  [m]
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.platforms.mount import Mount
from raybundle.scenes.corrections import Curve
from raybundle.sensors import Parameter

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
                raise InputError("trajectory.count", table=name, times=len(times), n=len(values))
            if not (np.isfinite(times).all() and np.isfinite(values).all()):
                raise InputError("trajectory.not_finite", table=name)
            interval = np.diff(times)
            if not (interval > 0).all():
                k = int(np.argmin(interval))
                raise InputError(
                    "trajectory.time_order", table=name, time_s=times[k + 1], entry=k + 2, before_s=times[k]
                )
        if (np.linalg.norm(self.quaternions, axis=1) < 1e-6).any():
            raise InputError("trajectory.zero_quaternion")

    def check_cover(self, first: float, last: float) -> None:
        """Raise InputError unless the tables cover these times, but for two intervals at each end, without a gap."""
        for name, times in (("ephemeris", self.position_times), ("attitude", self.attitude_times)):
            interval = np.diff(times)
            usual = float(np.median(interval))
            if first < times[0] - COVER * usual or last > times[-1] + COVER * usual:
                raise InputError(
                    "trajectory.not_covered", table=name, start_s=times[0], end_s=times[-1], first_s=first, last_s=last
                )
            wide = (interval > GAP * usual) & (times[1:] > first) & (times[:-1] < last)
            if wide.any():
                k = int(np.flatnonzero(wide)[0])
                raise InputError(
                    "trajectory.gap", table=name, gap_s=interval[k], start_s=times[k], end_s=times[k + 1], usual_s=usual
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
    from scipy.interpolate import PPoly

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


AXES = {"position": ("along", "across", "up"), "attitude": ("rx", "ry", "rz")}
"""Parameters of the corrections, by axis: along track, across track, up [m]; about the detector's axes [rad]."""
LEVER_ARM = ("ax", "ay", "az")
MOUNT = {p.symbol: p for p in Mount.parameters}
"""Between what carries several scenes and the detector of one of them: a rotation [rad] and a time [s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CorrectionModel:
    """What corrects a trajectory: polynomials, curves, or both; a time offset; a lever arm."""

    position_degree: int = -1
    """Of a polynomial along track, across track and up, -1: none; 2 is good to 1 mm over a scene of 1 to 2 s."""
    attitude_degree: int = -1
    """Of one about the detector's three axes; 2 leaves up to 1.4 px over such a scene."""
    position_curve: Curve | None = None
    attitude_curve: Curve | None = None
    """Fixes every 0.1 s leave 0.05 px."""
    time_offset: bool = False
    """dt [s]: the tables hold for line time + dt."""
    lever_arm: bool = False
    """ax, ay, az [m], in the detector's axes: from the projection centre to the point whose positions the table has."""
    mount: bool = False
    """bx, by, bz [rad], bt [s]: misalignment and time of one line of several on the trajectory."""

    def __post_init__(self) -> None:
        """Refuse degrees that are none."""
        for name in ("position_degree", "attitude_degree"):
            if not -1 <= getattr(self, name) <= 2:
                raise InputError("trajectory.degree", name=name, degree=getattr(self, name))

    @property
    def groups(self) -> dict[str, tuple[str, ...]]:
        """The parameters of each axis of a curve: rx -> rx_1, rx_2, ..."""
        found: dict[str, tuple[str, ...]] = {}
        for part, curve in (("position", self.position_curve), ("attitude", self.attitude_curve)):
            if curve is not None:
                found |= {s: tuple(f"{s}_{k + 1}" for k in range(curve.coefficients)) for s in AXES[part]}
        return found

    @property
    def symbols(self) -> tuple[str, ...]:
        """Parameters in their order: along0 across0 up0 [m], along1 ..., along_1 across_1 up_1, along_2 ...,
        rx0 ry0 rz0 [rad], rx1 ..., rx_1 ry_1 rz_1, rx_2 ..., dt [s], ax ay az [m], bx by bz [rad], bt [s].
        """  # noqa: D205
        found: list[str] = []
        for part, degree, curve in (
            ("position", self.position_degree, self.position_curve),
            ("attitude", self.attitude_degree, self.attitude_curve),
        ):
            found += [f"{s}{k}" for k in range(degree + 1) for s in AXES[part]]
            if curve is not None:
                found += [f"{s}_{k + 1}" for k in range(curve.coefficients) for s in AXES[part]]
        found += ["dt"] if self.time_offset else []
        return (*found, *(LEVER_ARM if self.lever_arm else ()), *(MOUNT if self.mount else ()))

    def members(self, name: str) -> tuple[str, ...]:
        """The parameters that a name stands for: those of an axis of a curve, or the one of that name."""
        return self.groups.get(name, (name,))

    def unit(self, symbol: str) -> str:
        """Of a parameter."""
        return "s" if symbol in {"dt", "bt"} else "rad" if symbol[0] in "rb" else "m"

    def meaning(self, symbol: str) -> tuple[str, tuple[tuple[str, str | int | bool], ...]]:
        """Of a parameter: the code of its text, and the values of this."""
        if symbol == "dt":
            return "parameter.time_offset", ()
        if symbol in MOUNT:
            return MOUNT[symbol].meaning, ()
        if symbol in LEVER_ARM:
            return "parameter.detector_lever_arm", (("axis", symbol[1]),)
        name, curve, _ = symbol.partition("_")
        quantity = name.rstrip("0123456789")
        number = int(symbol.removeprefix(quantity).removeprefix("_"))
        of = quantity if quantity in AXES["position"] else "attitude"
        return "parameter.correction", (
            ("quantity", of), ("axis", quantity[1:]), ("curve", bool(curve)), ("number", number),
        )  # fmt: skip

    def split(self, values: Array) -> CorrectionValues:
        """The values (k,) of the parameters by their parts."""
        values = np.asarray(values, float)
        k, m, total = self._ends
        if values.shape != (total,):
            raise InputError("trajectory.parameter_count", needed=total, shape=values.shape)
        arm = m + int(self.time_offset)
        mount = values[-len(MOUNT) :] if self.mount else np.zeros(len(MOUNT))
        return CorrectionValues(
            position=values[:k].reshape(-1, 3),
            attitude=values[k:m].reshape(-1, 3),
            dt=(float(values[m]) if self.time_offset else 0.0) + float(mount[3]),
            lever_arm=values[arm : arm + 3] if self.lever_arm else np.zeros(3),
            mount=mount[:3],
        )

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """As those of a sensor."""
        found = ((s, *self.meaning(s)) for s in self.symbols)
        return tuple(Parameter(s, self.unit(s), meaning, values=values) for s, meaning, values in found)

    @property
    def _ends(self) -> tuple[int, int, int]:
        """Where the parameters of position, of attitude, and all of them end."""
        k = 3 * _count(self.position_degree, self.position_curve)
        m = k + 3 * _count(self.attitude_degree, self.attitude_curve)
        return k, m, m + int(self.time_offset) + 3 * int(self.lever_arm) + len(MOUNT) * int(self.mount)

    def shapes(self, tau: Array) -> tuple[Shape, Shape]:
        """How the coefficients of position and attitude act at times tau (n,)."""
        return (
            Shape.of(tau, self.position_degree, self.position_curve),
            Shape.of(tau, self.attitude_degree, self.attitude_curve),
        )

    def touched(self, position: Shape, attitude: Shape) -> Index:
        """(n, w) positions of the parameters that act at each time: those of the shapes, then those of all times."""
        k, m, total = self._ends
        n = len(position.touched)
        by_axis = [
            (start + 3 * shape.touched[:, :, None] + np.arange(3)).reshape(n, -1)
            for start, shape in ((0, position), (k, attitude))
        ]
        rest = np.broadcast_to(np.arange(m, total), (n, total - m))
        return np.concatenate([*by_axis, rest], axis=1).astype(np.int32)

    @property
    def width(self) -> int:
        """Parameters that act at one time."""
        shapes = self.shapes(np.zeros(1))
        return self.touched(*shapes).shape[1]


def _count(degree: int, curve: Curve | None) -> int:
    return degree + 1 + (0 if curve is None else curve.coefficients)


@dataclass(frozen=True, slots=True, kw_only=True)
class CorrectionValues:
    """The parameters of the corrections of one scene."""

    position: Array
    """(p, 3) coefficients, along track, across track, up [m]."""
    attitude: Array
    """(q, 3) about the detector's axes [rad]."""
    dt: float
    lever_arm: Array
    """(3,)"""
    mount: Array
    """(3,) [rad]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Shape:
    """Polynomial and curve at times (n,): which of their coefficients act, and how."""

    touched: Index
    """(n, m) positions among the coefficients."""
    values: Array
    """(n, m) B_k(tau)"""
    slopes: Array
    """(n, m) by tau"""

    @staticmethod
    def of(tau: Array, degree: int, curve: Curve | None) -> Shape:
        """Powers up to a degree, then the curve."""
        k = np.arange(degree + 1)
        values = tau[:, None] ** k
        slopes = k * tau[:, None] ** np.maximum(k - 1, 0)
        touched = np.broadcast_to(k, values.shape)
        if curve is not None:
            first, more, slope = curve.local(tau)
            touched = np.concatenate([touched, degree + 1 + first[:, None] + np.arange(curve.width)], axis=1)
            values, slopes = np.concatenate([values, more], axis=1), np.concatenate([slopes, slope], axis=1)
        return Shape(touched=touched.astype(np.int32), values=values, slopes=slopes)

    def __call__(self, coefficients: Array) -> tuple[Array, Array]:
        """Correction and its derivative by tau (n, 3), with coefficients (k, 3)."""
        mine = coefficients[self.touched]
        return np.einsum("nm,nmi->ni", self.values, mine), np.einsum("nm,nmi->ni", self.slopes, mine)
