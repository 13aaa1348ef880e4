"""An orbit by its state vectors: polynomials through the nearest of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from math import lgamma

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

LEAST = 4
"""State vectors of an orbit."""
NEAREST = 8
"""State vectors through which the orbit's polynomial runs."""
BEYOND = 0.5
"""Steps of the table by which an image may end before or after it."""
CONTRADICTING = 0.1
"""Share by which velocities may differ from those of the positions: a chord of a tenth of a turn is 2 % short."""
DENSE_S = 5.0
"""Steps of state vectors up to which their noise is tested: interpolation amplifies it by distance over step"""
NOISE = 1e-3
"""Noise of velocities, or of positions over a step, from which on a polynomial is fitted [m/s]: 0.1 m on the ground"""
TRUNCATION_M = 1e-5
"""Of the polynomial that is fitted to noisy state vectors"""
ORBITAL = (1e3, 1e5)
"""Speeds of satellites [m/s]; what is slower is no free fall, and may move as it likes"""
FARTHEST_M = 1e12
VARIANCE_STEPS = 5
LEAST_SIGMA = 1e-9
"""Keeps weights finite [m, m/s]"""


@dataclass(frozen=True, kw_only=True, eq=False)
class Orbit:
    """State vectors in the frame that turns with the body."""

    times: Array
    """(n,) [s]"""
    positions: Array
    """(n, 3) [m]"""
    velocities: Array
    """(n, 3) [m/s]"""
    joint: bool = True
    """Whether velocities are derivatives of the positions; else the file means an interpolation of each by itself"""
    noise_m: float = 0.0
    noise_m_s: float = 0.0
    """Standard deviations of the positions and velocities that `fitted` replaced; 0: it replaced none"""

    def __post_init__(self) -> None:
        """Refuse tables that are none."""
        if len(self.times) < LEAST or not len(self.times) == len(self.positions) == len(self.velocities):
            raise InputError("trajectory.count", table="ephemeris", times=len(self.times), n=len(self.positions))
        step = np.diff(self.times)
        if not (step > 0).all():
            k = int(np.argmin(step))
            times = self.times[k : k + 2].tolist()
            raise InputError(
                "trajectory.time_order", table="ephemeris", time_s=times[1], entry=k + 2, before_s=times[0]
            )
        # by the chord; an orbit bends by far less from one entry to the next
        chord = np.diff(self.positions, axis=0) / step[:, None]
        mean = (self.velocities[1:] + self.velocities[:-1]) / 2
        off, speed = np.linalg.norm(chord - mean, axis=1), np.linalg.norm(chord, axis=1)
        if not (off <= CONTRADICTING * speed).all():
            k = int(np.argmax(np.nan_to_num(off / np.maximum(speed, 1e-300), nan=np.inf)))
            raise InputError(
                "trajectory.velocity_contradicts",
                table="ephemeris", entry=k + 1, moved=float(speed[k]), stated=float(np.linalg.norm(mean[k])),
            )  # fmt: skip

    @staticmethod
    def of_inertial(
        times: Array, positions: Array, velocities: Array, axes: Array, omega: Array, *, joint: bool = True
    ) -> Orbit:  # fmt: skip
        """State vectors that stand in an inertial frame.

        axes   (n, 3, 3) rotations from it to the body
        omega  (n, 3) angular velocity of the body in it [rad/s]
        """
        moving = velocities - np.cross(omega, positions)
        return Orbit(
            times=times,
            positions=np.einsum("nij,nj->ni", axes, positions),
            velocities=np.einsum("nij,nj->ni", axes, moving),
            joint=joint,
        )

    def fitted(self) -> Orbit:
        """The orbit with the state vectors of a polynomial through dense, noisy ones; else itself.

        Least squares with positions and velocities weighted by their estimated variance components.  The degree follows
        from the truncation of a circular orbit over this time.
        """
        n, middle, half = len(self.times), float(self.times[0] + self.times[-1]) / 2, float(np.ptp(self.times)) / 2
        step = float(np.median(np.diff(self.times)))
        radius, speed = (float(np.linalg.norm(v, axis=1).max()) for v in (self.positions, self.velocities))
        if not (self.joint and step <= DENSE_S and ORBITAL[0] < speed < ORBITAL[1] and speed < radius < FARTHEST_M):
            return self
        turn = np.log(half * speed / radius)
        limit = np.log(TRUNCATION_M / radius)
        degree = next((d for d in range(1, n - 2) if (d + 1) * turn - lgamma(d + 2) - d * np.log(2) < limit), None)
        if degree is None:
            return self
        u = (self.times - middle) / half
        values = np.polynomial.chebyshev.chebvander(u, degree)
        slopes = np.polynomial.chebyshev.chebval(u, np.polynomial.chebyshev.chebder(np.eye(degree + 1))).T / half
        sigma = np.ones(2)
        P, V = self.positions, self.velocities
        for _ in range(VARIANCE_STEPS):
            Q, R = np.linalg.qr(np.concatenate([values / sigma[0], slopes / sigma[1]]))
            c = np.linalg.solve(R, Q.T @ np.concatenate([self.positions / sigma[0], self.velocities / sigma[1]]))
            P, V = values @ c, slopes @ c
            squares = np.array([np.sum((P - self.positions) ** 2), np.sum((V - self.velocities) ** 2)])
            sigma = np.sqrt(squares / 3 / (n - np.array([np.sum(Q[:n] ** 2), np.sum(Q[n:] ** 2)]))) + LEAST_SIGMA
        if max(sigma[0] / step, sigma[1]) <= NOISE:
            return self
        return replace(self, positions=P, velocities=V, noise_m=float(sigma[0]), noise_m_s=float(sigma[1]))

    @property
    def cover(self) -> tuple[float, float]:
        """Times between which the orbit is known: those of the table, and half a step more."""
        step = BEYOND * float(np.median(np.diff(self.times)))
        return float(self.times[0]) - step, float(self.times[-1]) + step

    @cached_property
    def _pieces(self) -> tuple[Array, Array, Array, Array]:
        """Middle, half length (k,) and coefficients (k, q, 3), twice, of positions and velocities by intervals."""
        n = len(self.times)
        m = min(NEAREST, n)
        first = np.clip(np.arange(n - 1) - m // 2 + 1, 0, n - m).astype(np.int32)
        at = self.times[first[:, None] + np.arange(m)]
        middle, half = (at[:, 0] + at[:, -1]) / 2, (at[:, -1] - at[:, 0]) / 2
        u = (at - middle[:, None]) / half[:, None]
        power = np.arange(2 * m if self.joint else m)
        values = u[..., None] ** power
        rows, start = first[:, None] + np.arange(m), self.positions[first][:, None]
        P, V = self.positions[rows] - start, self.velocities[rows] * half[:, None, None]
        if self.joint:
            slopes = power * u[..., None] ** np.maximum(power - 1, 0)
            P = np.linalg.solve(np.concatenate([values, slopes], axis=1), np.concatenate([P, V], axis=1))
            V = P[:, 1:] * power[1:, None]
        else:
            P, V = np.linalg.solve(values, P), np.linalg.solve(values, V)
        P[:, :1] += start
        return middle, half, P, V

    def at(self, t: Array) -> tuple[Array, Array, Array]:
        """Position, velocity, acceleration (n, 3) at times (n,)."""
        k = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, len(self.times) - 2)
        middle, half, c, s = self._pieces
        u, h = (t - middle[k]) / half[k], half[k]
        P = np.stack([polynomial(c[k, :, axis], u)[0] for axis in range(3)], axis=1)
        V, A = np.moveaxis(np.array([polynomial(s[k, :, axis], u) for axis in range(3)]), 0, 2)
        return P, V / h[:, None], A / (h * h)[:, None]


def polynomial(c: Array, x: Array) -> tuple[Array, Array]:
    """Values and slopes (n,) at x (n,) of polynomials with coefficients (n, k) by rising powers."""
    value, slope = np.zeros(len(x)), np.zeros(len(x))
    for k in range(c.shape[1] - 1, -1, -1):
        slope = slope * x + value
        value = value * x + c[:, k]
    return value, slope
