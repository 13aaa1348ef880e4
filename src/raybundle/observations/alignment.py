"""Points that lie on a common plane, a straight line, a plumb line or at one level, each with a standard deviation.

Facades and floors, edges, plumb lines, water levels: where a figure lies is unknown, that points lie on it is observed.
The standard deviation is that of a point's distance from its figure: how even the wall is, not how well it is measured.
It is a length, so that something else must fix the scale: all would fit a smaller object better.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.observations.kind import Named, ObservationKind, Observed, Partials, Rows, Scope, Values, partials
from raybundle.observations.table import Table, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class OnFigure(Table):
    """Points on figures of one kind; the figures are known by their names alone."""

    named_by: ClassVar[tuple[str, ...]] = ("figure", "point")

    figure: tuple[str, ...]
    point: Index
    sigma: Array
    """(k,) of the point's distance from the figure [length unit]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Planes(OnFigure):
    """Points on planes."""

    name: ClassVar[str] = "planes"
    figure: tuple[str, ...] = cells("text", "plane")
    point: Index = cells("point", "point")
    sigma: Array = cells("number", "sigma", follows="length", limit="> 0")


@dataclass(frozen=True, slots=True, kw_only=True)
class Lines(OnFigure):
    """Points on straight lines."""

    name: ClassVar[str] = "lines"
    figure: tuple[str, ...] = cells("text", "line")
    point: Index = cells("point", "point")
    sigma: Array = cells("number", "sigma", follows="length", limit="> 0")


@dataclass(frozen=True, slots=True, kw_only=True)
class PlumbLines(OnFigure):
    """Points on vertical lines; Z is up."""

    name: ClassVar[str] = "plumb_lines"
    upright: ClassVar[bool] = True
    figure: tuple[str, ...] = cells("text", "plumb_line")
    point: Index = cells("point", "point")
    sigma: Array = cells("number", "sigma", follows="length", limit="> 0")


@dataclass(frozen=True, slots=True, kw_only=True)
class Levels(OnFigure):
    """Points at common heights; Z is up."""

    name: ClassVar[str] = "levels"
    upright: ClassVar[bool] = True
    figure: tuple[str, ...] = cells("text", "level")
    point: Index = cells("point", "point")
    sigma: Array = cells("number", "sigma", follows="length", limit="> 0")


class _Alignment(ObservationKind, registered=False):
    """What the four have in common: v = the components of X - A along some axes, A and the axes those of the figure."""

    unit = "length"
    needs_scale = True
    called: ClassVar[str]
    least: ClassVar[int]
    """Points that a figure needs to have a place"""
    across: ClassVar[tuple[str, ...]]
    """Names of the observed distances of a point"""

    def own(self, table: OnFigure, scope: Scope) -> tuple[str, ...]:
        return tuple(
            dict.fromkeys(n for n, used in zip(table.figure, _used(table, scope).tolist(), strict=True) if used)
        )

    def points(self, table: OnFigure, scope: Scope) -> Index:
        return table.point[_used(table, scope)]

    def rows(self, table: OnFigure, scope: Scope) -> Rows:
        item = np.repeat(np.flatnonzero(_used(table, scope)), len(self.across))
        component = np.tile(np.arange(len(self.across)), len(item) // len(self.across))
        return Rows.of(item, component, np.zeros(len(item)), table.sigma[item])

    def own_start(self, table: OnFigure, scope: Scope) -> Array:
        figure, used = np.array(table.figure), _used(table, scope)
        found = list[Array]()
        for name in self.own(table, scope):
            xyz = scope.xyz[table.point[used & (figure == name)]] - scope.shift
            if len(np.unique(xyz, axis=0)) < self.least:
                raise InputError(
                    "alignment.too_few_points",
                    kind=self.called,
                    name=name,
                    n=len(np.unique(xyz, axis=0)),
                    least=self.least,
                    table=table.name,
                )
            found.append(self._fitted(xyz, name))
        return np.array(found)

    @abstractmethod
    def _fitted(self, xyz: Array, name: str) -> Array:
        """Values of the figure nearest to points (k, 3)."""

    @abstractmethod
    def _axes(self, values: Array) -> Array:
        """(count, components, 3) along which distances are counted."""

    @abstractmethod
    def _own_partials(self, values: Array, r: Array, component: Array) -> Array:
        """(k, `own_width`) by the unknowns; values (k, w) and X - A (k, 3) of each row."""

    def _anchors(self, values: Array) -> Array:
        """(count, 3) a place on each figure."""
        return values[:, -3:]

    def own_placed(self, values: Array, scale: float, R: Array, t: Array) -> Array:
        axes = [values[:, k : k + 3] @ R.T for k in range(0, values.shape[1] - 3, 3)]
        return np.concatenate([*axes, scale * values[:, -3:] @ R.T + t], axis=1)

    def observed(self, table: OnFigure, rows: Rows, scope: Scope, values: Values) -> Observed:
        own, at, r = self._apart(table, rows, scope, values)
        n, point = np.arange(len(rows)), table.point[rows.item]
        axis = self._axes(own)[at, rows.component]
        by = self._own_partials(own[at], r, rows.component)
        found: list[Partials] = [partials("point", n, point, k, axis[:, k]) for k in range(3)]
        found += [partials("own", n, at, k, by[:, k]) for k in range(self.own_width)]
        return Observed((axis * r).sum(axis=1), tuple(found))

    def places(self, table: OnFigure, rows: Rows, scope: Scope, values: Values) -> Array:
        own, at, r = self._apart(table, rows, scope, values)
        axes = self._axes(own)[at]
        return values.xyz[table.point[rows.item]] - np.einsum("kc,kci->ki", np.einsum("kci,ki->kc", axes, r), axes)

    def _apart(self, table: OnFigure, rows: Rows, scope: Scope, values: Values) -> tuple[Array, Index, Array]:
        """Values of the figures, which of them each row is of, and X - A (k, 3)."""
        names = {name: k for k, name in enumerate(self.own(table, scope))}
        at = np.array([names[table.figure[k]] for k in rows.item.tolist()], np.int32)
        own = values.own[self.name]
        return own, at, values.xyz[table.point[rows.item]] - self._anchors(own)[at]

    def named(self, table: OnFigure, rows: Rows, scope: Scope) -> Named:
        ids = (f"{table.figure[k]}: {scope.point_ids[table.point[k]]}" for k in rows.item.tolist())
        return Named(tuple(ids), tuple(self.across[c] for c in rows.component.tolist()))


class PointsOnPlane(_Alignment):
    """v = n (X - A), n the normal of the plane and A a point of it, both unknown."""

    name = "plane"
    group = "planes"
    order = 6
    title = "Points on planes"
    object = "plane: point"
    quantities = "distances of points from planes"
    table = Planes
    called = "plane"
    least = 3
    across = ("distance",)
    own_width = 3

    def _fitted(self, xyz: Array, name: str) -> Array:
        middle, s, V = _principal(xyz)
        if s[1] < FLAT * s[0]:
            raise InputError("plane.points_in_line", name=name)
        return np.concatenate([V[2], V[0], middle])

    def _axes(self, values: Array) -> Array:
        return values[:, None, :3]

    def _own_partials(self, values: Array, r: Array, component: Array) -> Array:
        n, u = values[:, :3], values[:, 3:6]
        v = np.cross(n, u)
        return np.stack([(u * r).sum(axis=1), (v * r).sum(axis=1), np.full(len(r), -1.0)], axis=1)

    def own_moved(self, values: Array, step: Array) -> Array:
        n, u, a = values[:, :3], values[:, 3:6], values[:, 6:]
        return np.concatenate([*_turned(n, u, step), a + n * step[:, 2:3]], axis=1)

    def own_generators(self, values: Array, centre: Array) -> Array:
        n, u, a = values[:, :3], values[:, 3:6], values[:, 6:]
        turn, move = _turns(n, u), _moves(a - centre)
        return np.concatenate([turn, np.einsum("ki,kij->kj", n, move)[:, None]], axis=1)


class PointsOnLine(_Alignment):
    """v = u (X - A) and w (X - A), u and w square to the line and A a point of it, all unknown."""

    name = "line"
    group = "straight lines"
    order = 7
    title = "Points on straight lines"
    object = "line: point"
    quantities = "distances of points across lines"
    components = ("1", "2")
    table = Lines
    called = "line"
    least = 2
    across = ("across 1", "across 2")
    own_width = 4

    def _fitted(self, xyz: Array, name: str) -> Array:
        middle, _, V = _principal(xyz)
        return np.concatenate([V[0], V[1], middle])

    def _axes(self, values: Array) -> Array:
        e, u = values[:, :3], values[:, 3:6]
        return np.stack([u, np.cross(e, u)], axis=1)

    def _own_partials(self, values: Array, r: Array, component: Array) -> Array:
        along = -(values[:, :3] * r).sum(axis=1)
        first = component == 0
        zero = np.zeros(len(r))
        return np.stack(
            [np.where(first, along, zero), np.where(first, zero, along), -1.0 * first, -1.0 * ~first], axis=1
        )

    def own_moved(self, values: Array, step: Array) -> Array:
        e, u, a = values[:, :3], values[:, 3:6], values[:, 6:]
        moved = a + u * step[:, 2:3] + np.cross(e, u) * step[:, 3:4]
        return np.concatenate([*_turned(e, u, step), moved], axis=1)

    def own_generators(self, values: Array, centre: Array) -> Array:
        e, u, a = values[:, :3], values[:, 3:6], values[:, 6:]
        move = np.einsum("kci,kij->kcj", np.stack([u, np.cross(e, u)], axis=1), _moves(a - centre))
        return np.concatenate([_turns(e, u), move], axis=1)


class PointsOnPlumbLine(_Alignment):
    """v = X - X_0 and Y - Y_0, both of the line unknown; shows what is vertical."""

    name = "plumb_line"
    group = "plumb lines"
    order = 8
    title = "Points on plumb lines"
    object = "plumb line: point"
    quantities = "distances of points across plumb lines"
    components = ("X", "Y")
    table = PlumbLines
    called = "plumb line"
    least = 2
    across = ("X", "Y")
    carries_datum = True
    own_width = 2

    def _fitted(self, xyz: Array, name: str) -> Array:
        return xyz.mean(axis=0)

    def _axes(self, values: Array) -> Array:
        return np.broadcast_to(np.eye(3)[:2], (len(values), 2, 3))

    def _own_partials(self, values: Array, r: Array, component: Array) -> Array:
        return -np.eye(2)[component]

    def own_moved(self, values: Array, step: Array) -> Array:
        return values + np.pad(step, ((0, 0), (0, 1)))

    def own_generators(self, values: Array, centre: Array) -> Array:
        return _upright(_moves(values - centre))[:, :2]


class PointsAtLevel(_Alignment):
    """v = Z - Z_0, the height of the level unknown; shows what is vertical."""

    name = "level"
    group = "levels"
    order = 9
    title = "Points at levels"
    object = "level: point"
    quantities = "heights of points above levels"
    table = Levels
    called = "level"
    least = 2
    across = ("Z",)
    carries_datum = True
    own_width = 1

    def _fitted(self, xyz: Array, name: str) -> Array:
        return xyz.mean(axis=0)

    def _axes(self, values: Array) -> Array:
        return np.broadcast_to(np.eye(3)[2:], (len(values), 1, 3))

    def _own_partials(self, values: Array, r: Array, component: Array) -> Array:
        return np.full((len(r), 1), -1.0)

    def own_moved(self, values: Array, step: Array) -> Array:
        return values + np.pad(step, ((0, 0), (2, 0)))

    def own_generators(self, values: Array, centre: Array) -> Array:
        return _upright(_moves(values - centre))[:, 2:]


FLAT = 1e-6
"""Of the extent of points: the width below which they lie on a straight line."""


def _used(table: OnFigure, scope: Scope) -> Mask:
    return scope.points[table.point]


def _principal(xyz: Array) -> tuple[Array, Array, Array]:
    """Middle (3,), extents (3,) and principal axes (3, 3), a row each, the longest first, right-handed."""
    middle = xyz.mean(axis=0)
    _, s, V = np.linalg.svd(np.vstack([xyz - middle, np.zeros((3, 3))]), full_matrices=False)
    return middle, s, V * np.array([1.0, 1.0, np.linalg.det(V)])[:, None]


def _turned(e: Array, u: Array, step: Array) -> tuple[Array, Array]:
    """Axes (k, 3) and one square to each after small turns towards u and e x u (k, 2 or more)."""
    a, b = step[:, :1], step[:, 1:2]
    new = e + a * u + b * np.cross(e, u)
    new = new / np.linalg.norm(new, axis=1, keepdims=True)
    side = u - a * e
    side = side - new * (side * new).sum(axis=1, keepdims=True)
    return new, side / np.linalg.norm(side, axis=1, keepdims=True)


def _turns(e: Array, u: Array) -> Array:
    """(k, 2, 7) turns of axes towards u and e x u, by rotations of the frame."""
    by = np.zeros((len(e), 2, 7))
    for k, side in enumerate((u, np.cross(e, u))):
        by[:, k, 3:6] = np.cross(e, side)  # side (w x e) = w (e x side)
    return by


def _moves(r: Array) -> Array:
    """(k, 3, 7) how places r (k, 3) from the centre move: I, [w x r], r."""
    by = np.zeros((len(r), 3, 7))
    by[:, :, :3] = np.eye(3)
    for k in range(3):
        by[:, :, 3 + k] = np.cross(np.eye(3)[k], r)
    by[:, :, 6] = r
    return by


def _upright(moves: Array) -> Array:
    """Without turns about level axes, of which figures that are upright take no part."""
    moves = moves.copy()
    moves[:, :, 3:5] = 0
    return moves
