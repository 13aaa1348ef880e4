"""The observations outside the images that take part in an adjustment, kind by kind, and their weights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.observations import ObservationKind, Rows, Scope, in_order


@dataclass(frozen=True, slots=True)
class Part:
    """The rows of one kind of observation outside the images."""

    kind: ObservationKind
    table: Any
    rows: Rows
    start: int
    """Position of the first among all of them"""

    @property
    def positions(self) -> Array:
        """Their positions (k,) among all of them."""
        return np.arange(self.start, self.start + len(self.rows))


@dataclass(frozen=True, slots=True)
class Correlated:
    """Rows that are weighted together, in units of their standard deviations."""

    rows: Array
    """(j,) positions among all rows, ascending"""
    root: Array
    """(j, j) L^-1 of the correlations L L': rows of it times the correlated ones are independent of each other"""

    @property
    def weight(self) -> Array:
        """(j, j) inverse of the correlations."""
        return self.root.T @ self.root


@dataclass(frozen=True, slots=True, kw_only=True)
class Extra:
    """Observations that touch no image point, kind by kind."""

    scope: Scope
    parts: tuple[Part, ...]
    sigma: Array
    """(k,) of all rows"""
    correlated: tuple[Correlated, ...] = ()

    def __len__(self) -> int:
        return len(self.sigma)

    def of(self, name: str) -> Part | None:
        """The part of a kind, if it has rows."""
        return next((p for p in self.parts if p.kind.name == name), None)

    def group_of_row(self) -> Index:
        """(k,) which rows are weighted together: a number for each group, a row alone being one."""
        group = np.arange(len(self))
        for joint in self.correlated:
            group[joint.rows] = joint.rows[0]
        return group

    def weighted(self, values: Array) -> Array:
        """P v of values (k,) in units of the standard deviations."""
        found = values.copy()
        for joint in self.correlated:
            found[joint.rows] = joint.root.T @ (joint.root @ values[joint.rows])
        return found

    def whitened(self, values: Array) -> Array:
        """L^-1 v of values (k,) in units of the standard deviations: independent, each of standard deviation 1."""
        found = values.copy()
        for joint in self.correlated:
            found[joint.rows] = joint.root @ values[joint.rows]
        return found


def carried_points(block: Block, *, datum_is_chosen: bool = False) -> Mask:
    """(p,) object points that take part by observations outside the images alone, without any ray."""
    found = np.zeros(len(block.points), bool)
    for kind in in_order():
        if kind.carries_points and not (kind.carries_datum and datum_is_chosen):
            found[kind.table_of(block).refers("point")] = True
    return found


def gathered(scope: Scope, tables: Mapping[str, Any]) -> Extra:
    """The rows of all kinds; where the datum is chosen freely, without those that would carry it.

    raises  InputError where a kind refuses its rows, or correlations are not positive definite
    """
    parts, correlated, start = list[Part](), list[Correlated](), 0
    for kind in in_order():
        if kind.carries_datum and scope.datum_is_chosen and kind.name != "control":
            continue
        rows = kind.rows(tables[kind.name], scope)
        if not len(rows):
            continue
        parts.append(Part(kind, tables[kind.name], rows, start))
        correlated += [Correlated(start + j.rows.astype(np.int64), _root(kind, j.correlation)) for j in rows.joint]
        start += len(rows)
    sigma = np.concatenate([np.zeros(0), *(p.rows.sigma for p in parts)])
    return Extra(scope=scope, parts=tuple(parts), sigma=sigma, correlated=tuple(correlated))


def _root(kind: ObservationKind, correlation: Array) -> Array:
    try:
        return np.linalg.inv(np.linalg.cholesky(correlation))
    except np.linalg.LinAlgError:
        raise InputError("observations.covariance_not_positive", kind=kind.key) from None
