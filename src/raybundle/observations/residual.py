"""Kinds of observations that state their residual alone: their derivatives follow from it."""

from __future__ import annotations

import warnings
from abc import abstractmethod
from functools import cached_property
from typing import Any, ClassVar, cast

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.duals import Dual
from raybundle.numerics.rotation import cross_matrix
from raybundle.observations.correlation import correlated
from raybundle.observations.kind import Named, ObservationKind, Observed, Of, Partials, Rows, Scope, Values, partials
from raybundle.observations.table import SIGMA, Table

TINY = 1e-300
"""Square of a length below which it has no direction [length unit^2]."""


class Unknowns:
    """Values of an iteration that the rows of a table ask for.

    To a type checker they are arrays; they are `Dual`s, which carry their partial derivatives.
    """

    def __init__(self, values: Values, scope: Scope, own: Array | None = None, things: Index | None = None) -> None:
        """Of the values, and of the kind's own unknowns (count, w) with the one of each row (k,)."""
        self._values, self._own, self._things = values, own, things
        self.shift = scope.shift
        """(3,) what coordinates here are less than those of the block"""
        self.blocks: list[tuple[Of, Index, Array]] = []
        """kind, items (k,) and components (w,) of each group of unknowns"""

    def point(self, points: Index) -> Array:
        """(k, 3) coordinates of object points, in the shifted frame."""
        return self._seeded("point", points, self._values.xyz[points], np.eye(3))

    def centre(self, images: Index) -> Array:
        """(k, 3) projection centres of images, in the shifted frame."""
        return self._seeded("centre", images, self._values.centre[images], np.eye(3))

    def rotation(self, images: Index) -> Array:
        """(k, 3, 3) rotations from object axes to those of images."""
        R = self._values.rotation[images]
        return self._seeded("rotation", images, R, np.einsum("jab,kbc->kacj", cross_matrix(np.eye(3)), R))

    def interior(self, positions: Index, parameters: Array) -> Array:
        """(k, w) parameters of cameras or instruments: positions (k,) in `Scope.interior`, and which of them (w,)."""
        which = np.atleast_1d(parameters)
        values = self._values.interior[np.asarray(positions)[:, None], which]
        return self._seeded("interior", positions, values, np.eye(len(which)), which)

    @cached_property
    def own(self) -> Array:
        """(k, w) unknowns of the row's thing, as of the sphere on which a point lies."""
        assert self._own is not None
        assert self._things is not None
        return self._seeded("own", self._things, self._own[self._things], np.eye(self._own.shape[1]))

    def _seeded(self, of: Of, items: Index, value: Array, by: Array, components: Array | None = None) -> Array:
        if len(items) and np.min(items) < 0:
            raise TypeError(f"a row names no {of}: leave out such rows in `used`")
        width = by.shape[-1]
        self.blocks.append((of, np.asarray(items, np.int32), np.arange(width) if components is None else components))
        return cast("Array", Dual(value, {len(self.blocks) - 1: np.broadcast_to(by, (*value.shape, width))}))


class ResidualKind(ObservationKind, registered=False):
    """A kind that states `residual`: points, rows, names and derivatives follow from it and from its table.

    Words that it does not state follow from its name (`distance` makes "distances"), and `object` from the columns of
    its points and images.  A row takes part where all its points and images do.  What is observed is the field
    `observed` of the table, 0 where it has none, with the standard deviations of its field `sigma`.
    """

    called: ClassVar[tuple[str, ...]] = ()
    """Names of the quantities of a row; (): its noun"""
    thing: ClassVar[str] = ""
    """Field of the table with the name of what has unknowns of the kind's own (`own_start`, `own_placed`)"""
    between: ClassVar[str] = "–"
    """What stands between the names of points or images in the name of a row"""

    def __init_subclass__(cls, *, registered: bool = True) -> None:
        if registered:
            noun = cls.name.replace("_", " ")
            group = getattr(cls, "group", f"{noun}s")
            columns = [c.names[0] for _, c in cls.table.cells() if c.of in {"point", "image"}] if cls.table else []
            words = {"group": group, "title": group.capitalize(), "quantities": group, "object": "–".join(columns)}
            for word, text in words.items():
                if not hasattr(cls, word):
                    setattr(cls, word, text)
            cls.noun = cls.noun or noun
        super().__init_subclass__(registered=registered)

    @abstractmethod
    def residual(self, row: Any, at: Unknowns) -> Array:
        """Adjusted minus observed, (k,) or (k, c) where `called` has c names.

        row  the table, with a row for each observed quantity
        at   values of its points, images and unknowns
        """

    def used(self, table: Table, scope: Scope) -> Mask:
        """(k,) rows that take part."""
        found = np.ones(len(table), bool)
        for name, c in table.cells():
            at: Index | None = getattr(table, name)
            if c.of in {"point", "image"} and at is not None:
                found &= (at < 0) | (scope.points if c.of == "point" else scope.images)[at]
        return found

    def own(self, table: Any, scope: Scope) -> tuple[str, ...]:
        """Names of the things, in the order of the rows."""
        if not self.thing:
            return ()
        used = self.used(table, scope).tolist()
        return tuple(dict.fromkeys(n for n, u in zip(getattr(table, self.thing), used, strict=True) if u))

    def own_generators(self, values: Array, centre: Array) -> Array:
        """Derivatives of `own_placed` by shift, rotation and scale: a complex step, exact to the last digit."""
        placed: Any = self.own_placed
        by, step = np.zeros((len(values), self.own_width, 7)), 1e-30
        for k, turn in enumerate((*np.zeros((3, 3)), *np.eye(3), np.zeros(3)) if self.own_width else ()):
            scale = 1 + 1j * step * (k == 6)
            R = np.eye(3) + 1j * step * cross_matrix(turn)
            shift = 1j * step * (np.arange(3) == k)
            with warnings.catch_warnings():
                warnings.simplefilter("error", np.exceptions.ComplexWarning)  # a real array would lose the step
                moved: Any = np.asarray(placed(values, scale, R, centre - scale * R @ centre + shift))
            if not np.iscomplexobj(moved):
                raise TypeError(f"{self.name}: own_placed must keep complex values; use np.column_stack, no real array")
            by[:, :, k] = moved.imag / step
        return by

    def points(self, table: Any, scope: Scope) -> Index:
        """Of all rows that take part."""
        return table.rows(self.used(table, scope)).refers("point")

    def rows(self, table: Any, scope: Scope) -> Rows:
        """Of what was observed with a standard deviation."""
        shape = (len(table), max(len(self.called), 1))
        sigma = np.reshape(getattr(table, SIGMA), shape)
        value = np.reshape(getattr(table, table.observed), shape) if table.observed else np.zeros(shape)
        item, component = np.nonzero(self.used(table, scope)[:, None] & (np.nan_to_num(sigma) > 0))
        found = Rows.of(item, component, value[item, component], sigma[item, component])
        return correlated(table, found) if table.correlations_of(SIGMA) else found

    def observed(self, table: Any, rows: Rows, scope: Scope, values: Values) -> Observed:
        """Residuals, and their derivatives by the chain rule."""
        own, things = None, None
        if self.thing:
            of = {name: k for k, name in enumerate(self.own(table, scope))}
            names = getattr(table, self.thing)
            own, things = values.own[self.name], np.array([of[names[k]] for k in rows.item.tolist()], np.int32)
        at, n = Unknowns(values, scope, own, things), np.arange(len(rows))
        found: Any = self.residual(table.rows(rows.item), at)
        shape = (len(rows),) if len(self.called) < 2 else (len(rows), len(self.called))
        if not isinstance(found, Dual) or found.shape != shape:
            given = found.shape if isinstance(found, Dual) else type(found).__name__
            raise TypeError(f"{self.name}: residual must return {shape} of what `at` gives; it returned {given}")
        mine = found if found.ndim == 1 else found[n, rows.component]
        by: list[Partials] = []
        for group, d in mine.by.items():
            name, items, components = at.blocks[group]
            by += [partials(name, n, items, int(c), d[:, j]) for j, c in enumerate(components)]
        return Observed(mine.value, tuple(by))

    def named(self, table: Any, rows: Rows, scope: Scope) -> Named:
        """By the points or images of the row, and its thing."""
        ids = {"point": scope.point_ids, "image": scope.image_ids}
        columns = [
            [ids[c.of][i] for i in getattr(table, name)[rows.item].tolist()] for name, c in table.cells() if c.of in ids
        ]
        names = [self.between.join(row) for row in zip(*columns, strict=True)]
        if self.thing:
            names = [f"{getattr(table, self.thing)[k]}: {n}" for k, n in zip(rows.item.tolist(), names, strict=True)]
        called = self.called or (self.noun,)
        return Named(tuple(names), tuple(called[c] for c in rows.component.tolist()))


def length(d: Array) -> Array:
    """(k,) of vectors (k, 3); of one without a direction the derivative is 0."""
    return np.sqrt(np.maximum((d * d).sum(axis=-1), TINY))


def wrapped(angle: Array) -> Array:
    """An angle [rad] between -pi and pi."""
    return np.arctan2(np.sin(angle), np.cos(angle))
