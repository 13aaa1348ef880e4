"""Coordinates of object points with the covariance matrix that they have together.

The result of a GNSS network, of a traverse, of an earlier adjustment.  What their errors have in common (the datum of
the network, a chain of baselines) is in the matrix; taken as independent they would show the place, rotation and scale
of the object better than they know it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.deviations import SMALLEST
from raybundle.observations.kind import Joint, Named, ObservationKind, Observed, Rows, Scope, Values, partials
from raybundle.observations.table import Table, Wrong, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class Coordinates(Table):
    """A row for each point of a network, and one for each pair of its points that are correlated."""

    name: ClassVar[str] = "coordinates"
    named_by: ClassVar[tuple[str, ...]] = ("network", "point", "other")
    network: tuple[str, ...] = cells("text", "network")
    point: Index = cells("point", "point")
    other: Index = cells("point", "other")
    """The point itself where coordinates and their own covariance stand, or one that it is correlated with"""
    xyz: Array = cells("number", "X", "Y", "Z", follows="position", empty=True)
    """(k, 3) [length unit]; NaN in rows of pairs"""
    covariance: Array = cells(
        "number", "cXX", "cXY", "cXZ", "cYX", "cYY", "cYZ", "cZX", "cZY", "cZZ", follows="covariance"
    )
    """(k, 9) of X, Y, Z of the point (rows) with X, Y, Z of the other (columns) [length unit^2]"""

    def with_errors(self, rng: np.random.Generator) -> Coordinates:
        """What another measurement of each network would give: errors with its covariance matrix."""
        xyz, networks = self.xyz.copy(), np.array(self.network)
        for network in dict.fromkeys(self.network):
            rows = np.flatnonzero((networks == network) & self.own)
            sigma, correlation = _covariance(self, rows, network)
            errors = sigma * (np.linalg.cholesky(correlation) @ rng.normal(0, 1, len(sigma)))
            xyz[rows] += errors.reshape(-1, 3)
        return replace(self, xyz=xyz)

    @property
    def own(self) -> Mask:
        """(k,) rows with coordinates."""
        return self.point == self.other

    def wrong(self) -> tuple[Wrong, ...]:
        own, given = self.own, np.isfinite(self.xyz)
        low, high = np.minimum(self.point, self.other).tolist(), np.maximum(self.point, self.other).tolist()
        earlier, stands = set[tuple[str, int, int]](), set[tuple[str, int]]()
        twice, alone = np.zeros(len(self), bool), np.zeros(len(self), bool)
        for k, key in enumerate(zip(self.network, low, high, strict=True)):
            twice[k] = key in earlier
            earlier.add(key)
            if key[1] == key[2]:
                stands.add(key[:2])
        for k, (n, a, b) in enumerate(zip(self.network, low, high, strict=True)):
            alone[k] = (n, a) not in stands or (n, b) not in stands
        C = self.covariance.reshape(-1, 3, 3)
        size = np.abs(C).max(axis=(1, 2), initial=0.0)
        uneven = own & (np.abs(C - np.swapaxes(C, 1, 2)).max(axis=(1, 2), initial=0.0) > 1e-6 * size)
        negative = own & ~(np.diagonal(C, axis1=1, axis2=2) > 0).all(axis=1)
        return (
            Wrong(twice, "other", lambda k: message("network.pair_twice", network=self.network[k])),
            Wrong(own & ~given.all(axis=1), "X", lambda _: message("network.coordinates_missing")),
            Wrong(~own & given.any(axis=1), "X", lambda _: message("network.coordinates_of_pair")),
            Wrong(
                alone, "other",
                lambda k: message("network.point_without_coordinates", network=self.network[k]),
            ),
            Wrong(
                negative, "cXX",
                lambda k: message("network.variance_not_positive", variance=float(C[k].diagonal().min())),
            ),
            Wrong(uneven, "cXY", lambda _: message("network.covariance_not_symmetric")),
        )  # fmt: skip


class ObservedCoordinates(ObservationKind):
    """v = X - X_given, correlated within each network."""

    name = "coordinate"
    group = "coordinates of networks"
    order = 11
    title = "Coordinates of networks, with their covariance"
    object = "point"
    noun = "point of a network"
    quantities = "coordinates of networks"
    components = ("X", "Y", "Z")
    unit = "length"
    table = Coordinates
    carries_datum = True
    carries_points = True

    def check(self, table: Coordinates, scope: Scope) -> None:
        for network in _networks(table):
            rows = _rows_of(table, scope, network)
            if not len(rows):
                continue
            _, correlation = _covariance(table, rows, network)
            least = float(np.linalg.eigvalsh(correlation)[0])
            if not least > SMALLEST:
                raise InputError(
                    "network.covariance_not_positive", network=network, n=len(rows), least=least, limit=SMALLEST
                )

    def points(self, table: Coordinates, scope: Scope) -> Index:
        return table.point[table.own & scope.points[table.point]]

    def rows(self, table: Coordinates, scope: Scope) -> Rows:
        item, sigma, joint = list[Array](), list[Array](), list[Joint]()
        start = 0
        for network in _networks(table):
            rows = _rows_of(table, scope, network)
            twice = rows[scope.coordinates[table.point[rows]].any(axis=1)]
            if len(twice):
                raise InputError(
                    "network.point_given_twice", point=scope.point_ids[table.point[twice[0]]], network=network
                )
            if not len(rows):
                continue
            own_sigma, correlation = _covariance(table, rows, network)
            item.append(rows)
            sigma.append(own_sigma)
            joint.append(Joint(start + np.arange(len(own_sigma), dtype=np.int32), correlation))
            start += len(own_sigma)
        at = np.repeat(np.concatenate([np.zeros(0, np.int64), *item]), 3)
        axis = np.tile(np.arange(3), len(at) // 3)
        shift: Array = scope.shift[axis]
        return Rows.of(
            at, axis, table.xyz[at, axis] - shift, np.concatenate([np.zeros(0), *sigma]), shift, joint=tuple(joint)
        )

    def observed(self, table: Coordinates, rows: Rows, scope: Scope, values: Values) -> Observed:
        point = table.point[rows.item]
        residual = values.xyz[point, rows.component] - rows.value
        return Observed(residual, (partials("point", np.arange(len(rows)), point, rows.component, np.ones(1)),))

    def named(self, table: Coordinates, rows: Rows, scope: Scope) -> Named:
        return Named(
            tuple(scope.point_ids[k] for k in table.point[rows.item].tolist()),
            tuple("XYZ"[a] for a in rows.component.tolist()),
        )

    def weighted(self, block: Any, factor: float) -> Any:
        table = self.table_of(block)
        return block.having(replace(table, covariance=factor**2 * table.covariance))


def _networks(table: Coordinates) -> tuple[str, ...]:
    return tuple(dict.fromkeys(table.network))


def _rows_of(table: Coordinates, scope: Scope, network: str) -> Array:
    """Rows of a network with coordinates of points that take part."""
    return np.flatnonzero((np.array(table.network) == network) & table.own & scope.points[table.point])


def _covariance(table: Coordinates, rows: Array, network: str) -> tuple[Array, Array]:
    """Standard deviations (3 k,) and correlations (3 k, 3 k) of the points of these rows."""
    at = np.full(max(table.point.max(initial=0), table.other.max(initial=0)) + 1, -1)
    at[table.point[rows]] = np.arange(len(rows))
    mine = np.flatnonzero(np.array(table.network) == network)
    mine = mine[(at[table.point[mine]] >= 0) & (at[table.other[mine]] >= 0)]
    a, b, blocks = at[table.point[mine]], at[table.other[mine]], table.covariance[mine].reshape(-1, 3, 3)
    C = np.zeros((len(rows), 3, len(rows), 3))
    C[a, :, b], C[b, :, a] = blocks, blocks.swapaxes(1, 2)
    C = C.reshape(3 * len(rows), -1)
    C = (C + C.T) / 2
    sigma = np.sqrt(np.diagonal(C))
    return sigma, C / np.outer(sigma, sigma)
