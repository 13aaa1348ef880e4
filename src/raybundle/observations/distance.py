"""Distances between two object points: scale bars, tape measures, distance meters."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.observations.kind import Named, ObservationKind, Observed, Rows, Scope, Values, partials


@dataclass(frozen=True, slots=True, kw_only=True)
class Distances:
    """Scale bars: observed distances between two object points."""

    start: Index
    end: Index
    length: Array
    sigma: Array

    def __len__(self) -> int:
        return len(self.start)


def no_distances() -> Distances:
    """A table without rows."""
    return Distances(start=np.zeros(0, np.int32), end=np.zeros(0, np.int32), length=np.zeros(0), sigma=np.zeros(0))


class Distance(ObservationKind):
    """v = |X_end - X_start| - length, the shortest way between two points in the frame of the object."""

    name = "distance"
    group = "distances"
    order = 1
    unit = "length"
    fixes_scale = True

    def table_of(self, block: Any) -> Distances:
        return block.distances

    def points(self, table: Distances, scope: Scope) -> Index:
        used = scope.points[table.start] & scope.points[table.end]
        return np.unique(np.concatenate([table.start[used], table.end[used]]))

    def rows(self, table: Distances, scope: Scope) -> Rows:
        used = np.flatnonzero(scope.points[table.start] & scope.points[table.end])
        for d in used[~(table.sigma[used] > 0)][:1]:
            raise InputError(f"distance {d + 1}: sigma {table.sigma[d]:g} must be positive")
        return Rows.of(used, np.zeros(len(used)), table.length[used], table.sigma[used])

    def observed(self, table: Distances, rows: Rows, scope: Scope, values: Values) -> Observed:
        start, end = table.start[rows.item], table.end[rows.item]
        d = values.xyz[end] - values.xyz[start]
        length = np.linalg.norm(d, axis=1)
        unit, k = d / length[:, None], np.arange(len(rows))
        return Observed(
            length - rows.value,
            tuple(
                partials("point", k, point, axis, sign * unit[:, axis])
                for point, sign in ((start, -1.0), (end, 1.0))
                for axis in range(3)
            ),
        )

    def named(self, table: Distances, rows: Rows, scope: Scope) -> Named:
        ids = scope.point_ids
        ends = zip(table.start[rows.item].tolist(), table.end[rows.item].tolist(), strict=True)
        return Named(tuple(f"{ids[a]}-{ids[b]}" for a, b in ends), ("length",) * len(rows))

    def weighted(self, block: Any, factor: float) -> Any:
        return replace(block, distances=replace(block.distances, sigma=factor * block.distances.sigma))
