"""What may be asked of points of a result: values by their coordinates, with derivatives.

A quantity registers itself by standing in `QUANTITIES`: command line, Python and the studio ask all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

Quantity = Literal["coordinates", "distance", "angle", "area", "length", "plane", "line", "to_plane", "to_line"]
ALONG = 1e-6
"""Breadth of points by their length below which they are in one line, or coincide: rounding alone."""
MOST = 2000
"""Points of a question: their covariance matrix is formed as a whole, 300 MB for so many."""
DRAWS = 4000
"""Drawn sets of errors from which the mean extent of a perfect form is reported: its error is 1 %."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """Values of some points."""

    values: Array
    """(k,)"""
    by_points: Array
    """(k, 3 n) derivatives by the coordinates of the points, in their order"""
    deviations: Array | None = None
    """(j, 3 n) derivatives of the deviations from a form, of which the first value is the extent"""
    extent: Callable[[Array], Array] = lambda e: e
    """The first value (m,) of sets of deviations (m, j)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Question:
    """A quantity."""

    least: int
    most: int
    """number of points"""
    power: int
    """of the length unit: 1 a length, 2 an area; 0: degrees"""
    of: Callable[[Array], Found]
    """values of points (n, 3)"""
    names: Callable[[Sequence[str]], tuple[str, ...]]
    """of the values, by those of the points"""
    near: bool = False
    """whether it is a distance from zero, which is not normally distributed unless well above its sigma"""

    @property
    def count(self) -> str:
        """How many points it needs."""
        return str(self.least) if self.least == self.most else f"{self.least} or more"


@dataclass(frozen=True, slots=True, kw_only=True)
class Form:
    """The best plane or line through points: least squares of the distances from it."""

    centre: Array
    axes: Array
    """(3, 3) rows: along the points, across them, away from them; the largest coordinate of each is positive"""
    along: Array
    """(n, 3) places of the points on these axes, from the centre"""
    spread: Array
    """(3,) sums of squares along each axis"""

    @classmethod
    def of(cls, xyz: Array, *, plane: bool) -> Form:
        """Of points (n, 3); raises InputError where they show none."""
        centre = xyz.mean(axis=0)
        _, s, axes = np.linalg.svd(xyz - centre, full_matrices=True)
        s = np.append(s, np.zeros(3 - len(s)))
        size = float(np.abs(xyz).max()) * np.finfo(float).eps * 100
        if s[0] <= size or (plane and s[1] <= max(ALONG * s[0], size)):
            raise InputError("quantity.in_line" if plane else "quantity.coincide")
        axes = axes * np.sign(axes[np.arange(3), np.argmax(np.abs(axes), axis=1)])[:, None]
        return cls(centre=centre, axes=axes, along=(xyz - centre) @ axes.T, spread=s**2)

    def turn(self, of: int, towards: int) -> Array:
        """(n, 3) derivatives of the turn of one axis towards another by the points (perturbation of eigenvectors)."""
        a, b = self.axes[of], self.axes[towards]
        u, v = self.along[:, of, None], self.along[:, towards, None]
        return (b * u + a * v) / (self.spread[of] - self.spread[towards])

    def offset(self, at: Array, axis: int, turns: Sequence[int]) -> Array:
        """(j, n, 3) derivatives, by the points of the form, of the places (j, 3) of other points along an axis."""
        n = len(self.along)
        found = np.broadcast_to(-self.axes[axis] / n, (len(at), n, 3)).copy()
        for other in turns:
            found += at[:, other, None, None] * self.turn(axis, other)[None]
        return found


def _each(by_points: Array) -> Array:
    """(k, 3 n) of derivatives (k, n, 3)."""
    return by_points.reshape(len(by_points), -1)


def _own(form: Form, axis: int, turns: Sequence[int]) -> Array:
    """(n, n, 3) derivatives of the deviations of the points of a form along an axis."""
    found = form.offset(form.along, axis, turns)
    n = len(form.along)
    found[np.arange(n), np.arange(n)] += form.axes[axis]
    return found


def coordinates(xyz: Array) -> Found:
    """X, Y, Z of one point."""
    return Found(values=xyz[0], by_points=np.eye(3))


def distance(xyz: Array) -> Found:
    """Between two points."""
    return length(xyz)


def length(xyz: Array) -> Found:
    """Of the line from point to point."""
    d = np.diff(xyz, axis=0)
    r = np.linalg.norm(d, axis=1)
    if not (r > 0).all():
        raise InputError("quantity.coincide")
    u = d / r[:, None]
    by_points = np.zeros_like(xyz)
    by_points[:-1] -= u
    by_points[1:] += u
    return Found(values=np.array([r.sum()]), by_points=_each(by_points[None]))


def angle(xyz: Array) -> Found:
    """At the second of three points, between the other two [deg]."""
    a, b = xyz[0] - xyz[1], xyz[2] - xyz[1]
    ra, rb = np.linalg.norm(a), np.linalg.norm(b)
    with np.errstate(invalid="ignore", divide="ignore"):
        u, v = a / ra, b / rb
        value = np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v)
        # the direction in which each end opens the angle
        p, q = (u * (u @ v) - v), (v * (u @ v) - u)
        p, q = p / np.linalg.norm(p) / ra, q / np.linalg.norm(q) / rb
    by_points = np.concatenate([p, -p - q, q])[None]
    return Found(values=np.degrees(np.array([value])), by_points=np.degrees(by_points))


def area(xyz: Array) -> Found:
    """Of the polygon through points in their order: that of its projection in which it is largest."""
    d = xyz - xyz.mean(axis=0)  # products of large numbers round
    before, after = np.roll(d, 1, axis=0), np.roll(d, -1, axis=0)
    vector = np.cross(d, after).sum(axis=0) / 2
    size = np.linalg.norm(vector)
    with np.errstate(invalid="ignore", divide="ignore"):
        n = vector / size
    return Found(values=np.array([size]), by_points=(np.cross(after - before, n) / 2).reshape(1, -1))


def plane(xyz: Array) -> Found:
    """Flatness, from the lowest to the highest point about the best plane, and the deviation of each point from it.

    Deviations are positive where the largest coordinate of the plane's normal is: above a floor.
    """
    form = Form.of(xyz, plane=True)
    e = form.along[:, 2]
    by_points = _own(form, 2, (0, 1))
    high, low = int(np.argmax(e)), int(np.argmin(e))
    first = (by_points[high] - by_points[low])[None]
    return Found(
        values=np.array([e[high] - e[low], *e]), by_points=_each(np.concatenate([first, by_points])),
        deviations=_each(by_points), extent=lambda drawn: np.ptp(drawn, axis=1),
    )  # fmt: skip


def line(xyz: Array) -> Found:
    """The largest distance from the best line, and that of each point."""
    form = Form.of(xyz, plane=False)
    across = [_own(form, axis, (0,)) for axis in (1, 2)]
    r, by_points = _distances(form.along, across)
    first = int(np.argmax(r))
    return Found(
        values=np.array([r[first], *r]), by_points=_each(np.concatenate([by_points[first][None], by_points])),
        deviations=_each(np.concatenate(across)),
        extent=lambda drawn: np.hypot(*np.split(drawn, 2, axis=1)).max(axis=1),
    )  # fmt: skip


def to_plane(xyz: Array) -> Found:
    """Distance of the first point from the best plane through the others."""
    form = Form.of(xyz[1:], plane=True)
    at = (xyz[:1] - form.centre) @ form.axes.T
    sign = 1.0 if at[0, 2] >= 0 else -1.0
    by_points = np.concatenate([form.axes[2][None, None], form.offset(at, 2, (0, 1))], axis=1)
    return Found(values=np.abs(at[:, 2]), by_points=_each(sign * by_points))


def to_line(xyz: Array) -> Found:
    """Distance of the first point from the best line through the others."""
    form = Form.of(xyz[1:], plane=False)
    at = (xyz[:1] - form.centre) @ form.axes.T
    across = [
        np.concatenate([form.axes[axis][None, None], form.offset(at, axis, (0,))], axis=1) for axis in (1, 2)
    ]  # fmt: skip
    r, by_points = _distances(at, across)
    return Found(values=r, by_points=_each(by_points))


def _distances(at: Array, across: Sequence[Array]) -> tuple[Array, Array]:
    """Distances (j,) from the first axis of places (j, 3), and their derivatives (j, n, 3) by those of both others."""
    r = np.hypot(at[:, 1], at[:, 2])
    with np.errstate(invalid="ignore", divide="ignore"):
        u = np.where(r[:, None] > 0, at[:, 1:] / r[:, None], [1.0, 0.0])
    return r, u[:, 0, None, None] * across[0] + u[:, 1, None, None] * across[1]


def expected_extent(found: Found, covariance: Array) -> float:
    """Mean of the first value where the points were exactly of the form, by the errors of their coordinates.

    covariance  (3 n, 3 n) of the coordinates
    """
    assert found.deviations is not None
    C = found.deviations @ covariance @ found.deviations.T
    values, vectors = np.linalg.eigh(C)
    root = vectors * np.sqrt(np.maximum(values, 0))
    drawn = np.random.default_rng(0).standard_normal((DRAWS, len(C))) @ root.T
    return float(found.extent(drawn).mean())


def _named(*names: str) -> Callable[[Sequence[str]], tuple[str, ...]]:
    return lambda _: names


QUANTITIES: Mapping[Quantity, Question] = {
    "coordinates": Question(
        least=1, most=1, power=1, of=coordinates, names=_named("X", "Y", "Z")
    ),
    "distance": Question(
        least=2, most=2, power=1, of=distance, names=_named("distance")
    ),
    "angle": Question(
        least=3, most=3, power=0, of=angle, names=_named("angle"),
    ),
    "area": Question(
        least=3, most=MOST, power=2, of=area, names=_named("area")
    ),
    "length": Question(
        least=2, most=MOST, power=1, of=length, names=_named("length")
    ),
    "plane": Question(
        least=4, most=MOST, power=1, of=plane, names=lambda p: ("flatness", *(f"off {name}" for name in p)),
    ),
    "line": Question(
        least=3, most=MOST, power=1, of=line, near=True,
        names=lambda p: ("largest distance", *(f"off {name}" for name in p)),
    ),
    "to_plane": Question(
        least=4, most=MOST, power=1, of=to_plane, names=_named("distance"), near=True,
    ),
    "to_line": Question(
        least=3, most=MOST, power=1, of=to_line, names=_named("distance"), near=True,
    ),
}  # fmt: skip
