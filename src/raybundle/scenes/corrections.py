"""Curves in time with few coefficients, which correct a trajectory where a polynomial is too stiff.

    c(tau) = sum_k B_k(tau) c_k        tau from -1 at the first line to +1 at the last

Each coefficient acts near its place alone, so that a point touches few of them.  Beyond the ends curves go on
straight.  Coefficients without points nearby are not determined by the observations; give them a prior.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index

MOST = 1000
"""Coefficients that a curve can have."""


class Curve(Protocol):
    """What a trajectory's corrections ask of a curve."""

    @property
    def coefficients(self) -> int:
        """Their number."""
        ...

    @property
    def width(self) -> int:
        """Coefficients that act at one time."""
        ...

    @property
    def places(self) -> Array:
        """(k,) tau where each coefficient acts most; a straight line has its own values as coefficients."""
        ...

    def local(self, tau: Array) -> tuple[Index, Array, Array]:
        """First coefficient (n,) that acts at times (n,), values and slopes by tau (n, width) of the B_k from it on."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Fixes:
    """Orientation fixes at equal distances: the coefficients are the corrections there.

    Between them the cubic through the four nearest fixes (Lagrange), of lower degree where there are fewer; its slope
    jumps at a fix, by as much as the cubic differs from the truth (Ebner, Kornus and Ohlhof 1994).
    """

    count: int

    def __post_init__(self) -> None:
        """Refuse numbers that are none."""
        if not 2 <= self.count <= MOST:
            raise InputError("orientation_fix.count", n=self.count, most=MOST)

    @property
    def coefficients(self) -> int:
        """As `Curve`."""
        return self.count

    @property
    def width(self) -> int:
        """As `Curve`."""
        return min(4, self.count)

    @property
    def places(self) -> Array:
        """As `Curve`."""
        return np.linspace(-1.0, 1.0, self.count)

    def local(self, tau: Array) -> tuple[Index, Array, Array]:
        """As `Curve`."""
        inside = np.clip(tau, -1.0, 1.0)
        m = self.width
        u = (inside + 1) * (self.count - 1) / 2
        first = np.clip(np.floor(u).astype(np.int32) - (m - 1) // 2, 0, self.count - m)
        s, power = (u - first)[:, None], np.arange(m)
        through = np.linalg.inv(power[:, None] ** power)  # coefficients by the powers of s of the B_k: one at k alone
        values = s**power @ through
        slopes = (self.count - 1) / 2 * (power * s ** np.maximum(power - 1, 0)) @ through
        return first, values + (tau - inside)[:, None] * slopes, slopes


@dataclass(frozen=True, slots=True, kw_only=True)
class FixesAt:
    """Orientation fixes at given times, as those of a table of an orbit or an INS; else as `Fixes`."""

    at: tuple[float, ...]
    """tau of each, increasing; some may lie before the first line or after the last."""

    def __post_init__(self) -> None:
        """Refuse times that are none, or that say nothing of the image."""
        if not 2 <= len(self.at) <= MOST:
            raise InputError("orientation_fix.count", n=len(self.at), most=MOST)
        step = np.diff(self.at)
        if not (np.isfinite(self.at).all() and (step > 0).all()):
            k = int(np.argmin(step))
            raise InputError("orientation_fix.time_order", earlier=k + 1, later=k + 2)
        if self.at[0] >= 1 or self.at[-1] <= -1:
            raise InputError("orientation_fix.outside_image")

    @property
    def coefficients(self) -> int:
        """As `Curve`."""
        return len(self.at)

    @property
    def width(self) -> int:
        """As `Curve`."""
        return min(4, len(self.at))

    @property
    def places(self) -> Array:
        """As `Curve`."""
        return np.array(self.at)

    def local(self, tau: Array) -> tuple[Index, Array, Array]:
        """As `Curve`."""
        at, m = np.array(self.at), self.width
        inside = np.clip(tau, at[0], at[-1])
        between = np.searchsorted(at, inside, side="right").astype(np.int32) - 1
        first = np.clip(between - (m - 1) // 2, 0, len(at) - m)
        near = at[first[:, None] + np.arange(m)]
        values, slopes = np.ones((len(inside), m)), np.zeros((len(inside), m))
        for k in range(m):
            for j in range(m):
                if j == k:
                    continue
                width = near[:, k] - near[:, j]
                share = (inside - near[:, j]) / width
                slopes[:, k] = slopes[:, k] * share + values[:, k] / width
                values[:, k] *= share
        return first, values + (tau - inside)[:, None] * slopes, slopes


@dataclass(frozen=True, slots=True, kw_only=True)
class Pieces:
    """Polynomials over pieces of equal length that go over into each other smoothly.

    Written as B-splines, whose knots between pieces have the multiplicity degree - continuity (de Boor 1978), so that
    continuity holds exactly and needs no conditions.  The defaults are the cubic spline.
    """

    count: int
    """Pieces."""
    degree: int = 3
    """1, 2 or 3."""
    continuity: int | None = None
    """Derivatives that agree where pieces meet: 0 (the values alone) to degree - 1, which None stands for."""

    def __post_init__(self) -> None:
        """Refuse numbers that are none."""
        if not 1 <= self.degree <= 3:
            raise InputError("pieces.degree", degree=self.degree)
        if self.continuity is not None and not 0 <= self.continuity < self.degree:
            raise InputError("pieces.continuity", continuity=self.continuity, degree=self.degree, most=self.degree - 1)
        if not 1 <= self.count <= MOST or self.coefficients > MOST:
            raise InputError("pieces.count", n=self.count, coefficients=self.coefficients, most=MOST)

    @property
    def new(self) -> int:
        """Coefficients that each piece after the first brings."""
        return self.degree - (self.degree - 1 if self.continuity is None else self.continuity)

    @property
    def coefficients(self) -> int:
        """As `Curve`."""
        return (self.count - 1) * self.new + self.degree + 1

    @property
    def width(self) -> int:
        """As `Curve`."""
        return self.degree + 1

    @property
    def knots(self) -> Array:
        """(coefficients + degree + 1,) tau, each as often as its multiplicity states."""
        ends = self.degree + 1
        between = np.linspace(-1.0, 1.0, self.count + 1)[1:-1]
        return np.concatenate([np.full(ends, -1.0), np.repeat(between, self.new), np.full(ends, 1.0)])

    @property
    def places(self) -> Array:
        """As `Curve`: the means of `degree` knots each (Greville)."""
        t = self.knots
        return np.array([t[k + 1 : k + 1 + self.degree].mean() for k in range(self.coefficients)])

    def local(self, tau: Array) -> tuple[Index, Array, Array]:
        """As `Curve`."""
        inside = np.clip(tau, -1.0, 1.0)
        piece = np.clip(np.floor((inside + 1) * self.count / 2).astype(np.int32), 0, self.count - 1)
        first = piece * self.new
        t, span = self.knots, first + self.degree
        lower, values = np.ones((len(inside), 1)), np.ones((len(inside), 1))
        for j in range(1, self.degree + 1):
            lower = values
            values = np.zeros((len(inside), j + 1))
            for r in range(j):
                right, left = t[span + r + 1] - inside, inside - t[span + 1 - j + r]
                share = lower[:, r] / (right + left)
                values[:, r] += right * share
                values[:, r + 1] += left * share
        slopes = np.zeros_like(values)
        for r in range(self.degree):
            rise = self.degree * lower[:, r] / (t[span + r + 1] - t[span + 1 - self.degree + r])
            slopes[:, r] -= rise
            slopes[:, r + 1] += rise
        return first.astype(np.int32), values + (tau - inside)[:, None] * slopes, slopes


def bends(curve: Curve) -> list[tuple[int, Array]]:
    """First of three neighbouring coefficients, and the factors (3,) of their bend, which a straight line has not.

    With equal distances c_k - 2 c_(k+1) + c_(k+2), the second difference.  Observed as zero with a standard deviation
    it keeps coefficients without points of their own determined (of splines: Eilers and Marx 1996).
    """
    at = curve.places
    usual = 2.0 / (curve.coefficients - 1)
    found: list[tuple[int, Array]] = []
    for k in range(curve.coefficients - 2):
        before, after = usual / (at[k + 1] - at[k]), usual / (at[k + 2] - at[k + 1])
        found.append((k, np.array([before, -before - after, after])))
    return found
