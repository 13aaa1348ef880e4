"""Parameters of interior orientations, antennas and IMUs that are observed: each near the value that was given."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from raybundle.observations.kind import Named, ObservationKind, Observed, Rows, Scope, Values, partials


class ObservedParameter(ObservationKind):
    """v = parameter - given."""

    name = "parameter"
    group = "parameters"
    order = 4
    title = "Observed parameters"
    object = "camera"
    quantities = "observed parameters"
    unit = "own"

    def rows(self, table: Any, scope: Scope) -> Rows:
        found = [
            (r, k, i.given[i.symbols[k]], i.sigma[i.symbols[k]])
            for r, i in enumerate(scope.interior)
            for k in i.free
            if i.sigma.get(i.symbols[k], 0) > 0
        ]
        return Rows.of(*np.array(found, float).reshape(-1, 4).T)

    def observed(self, table: Any, rows: Rows, scope: Scope, values: Values) -> Observed:
        residual = values.interior[rows.item, rows.component] - rows.value
        return Observed(residual, (partials("interior", np.arange(len(rows)), rows.item, rows.component, np.ones(1)),))

    def named(self, table: Any, rows: Rows, scope: Scope) -> Named:
        mine = [scope.interior[r] for r in rows.item.tolist()]
        symbols = (i.symbols[k] for i, k in zip(mine, rows.component.tolist(), strict=True))
        return Named(tuple(i.key for i in mine), tuple(symbols))

    def weighted(self, block: Any, factor: float) -> Any:
        cameras = (replace(c, sigma={s: v * factor for s, v in c.sigma.items()}) for c in block.cameras)
        return replace(block, cameras=tuple(cameras))
