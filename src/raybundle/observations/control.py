"""Given coordinates of object points, each with a standard deviation of its own."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.observations.kind import Named, ObservationKind, Observed, Rows, Scope, Values, partials


class Control(ObservationKind):
    """v = X - X_given.  Held coordinates are no observations; those of eliminated points go with the points."""

    name = "control"
    group = "control"
    order = 0
    title = "Control points"
    object = "point"
    quantities = "control coordinates"
    unit = "length"
    carries_datum = True

    def rows(self, table: Any, scope: Scope) -> Rows:
        point, axis = np.argwhere(scope.coordinates).T
        shift: Array = scope.shift[axis]
        return Rows.of(point, axis, scope.xyz[point, axis] - shift, scope.sigma[point, axis], shift)

    def observed(self, table: Any, rows: Rows, scope: Scope, values: Values) -> Observed:
        residual = values.xyz[rows.item, rows.component] - rows.value
        return Observed(residual, (partials("point", np.arange(len(rows)), rows.item, rows.component, np.ones(1)),))

    def named(self, table: Any, rows: Rows, scope: Scope) -> Named:
        return Named(
            tuple(scope.point_ids[k] for k in rows.item.tolist()), tuple("XYZ"[a] for a in rows.component.tolist())
        )

    def weighted(self, block: Any, factor: float) -> Any:
        points = block.points
        return replace(
            block, points=replace(points, sigma=np.where(points.is_control, factor * points.sigma, points.sigma))
        )
