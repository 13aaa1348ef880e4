"""Distances between two object points: scale bars, tape measures, distance meters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array, Index
from raybundle.observations.kind import Named, ObservationKind, Observed, Rows, Scope, Values, partials
from raybundle.observations.table import Table, Wrong, cells


@dataclass(frozen=True, slots=True, kw_only=True)
class Distances(Table):
    """Scale bars: observed distances between two object points."""

    name: ClassVar[str] = "distances"
    observed: ClassVar[str] = "length"

    start: Index = cells("point", "from")
    end: Index = cells("point", "to")
    length: Array = cells("number", "length", follows="length", limit="> 0")
    sigma: Array = cells("number", "sigma", follows="length", limit="> 0")

    def wrong(self) -> Sequence[Wrong]:
        return [Wrong(self.start == self.end, "to", lambda _: message("observation.same_point"))]


class Distance(ObservationKind):
    """v = |X_end - X_start| - length, the shortest way between two points in the frame of the object."""

    name = "distance"
    group = "distances"
    order = 1
    title = "Scale bars"
    object = "from–to"
    noun = "scale bar"
    quantities = "scale bars"
    unit = "length"
    fixes_scale = True
    table = Distances

    def points(self, table: Distances, scope: Scope) -> Index:
        used = scope.points[table.start] & scope.points[table.end]
        return np.unique(np.concatenate([table.start[used], table.end[used]]))

    def rows(self, table: Distances, scope: Scope) -> Rows:
        used = np.flatnonzero(scope.points[table.start] & scope.points[table.end])
        for d in used[~(table.sigma[used] > 0)][:1]:
            raise InputError("distance.sigma_not_positive", row=d + 1, sigma=float(table.sigma[d]))
        return Rows.of(used, np.zeros(len(used)), table.length[used], table.sigma[used])

    def observed(self, table: Distances, rows: Rows, scope: Scope, values: Values) -> Observed:
        start, end = table.start[rows.item], table.end[rows.item]
        d = values.xyz[end] - values.xyz[start]
        length = np.linalg.norm(d, axis=1)
        unit, k = d / np.maximum(length, 1e-300)[:, None], np.arange(len(rows))  # ends in one place: no direction
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
