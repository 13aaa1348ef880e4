"""Sums of parameters that are observed: what was known of a camera before, smoothness of trajectories."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.observations.kind import Named, ObservationKind, Observed, Rows, Scope, Values, partials

SMALLEST = 1e-3
"""Share of its observed value that a sum has at least whose logarithm is observed: a step may overshoot to below 0."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Relation:
    """A sum of parameters of one camera that is observed."""

    name: str
    """For statistics and messages."""
    terms: Mapping[str, float]
    """Symbol -> factor."""
    sigma: float
    observed: float = 0.0
    """What the sum is."""
    logarithm: bool = False
    """Whether it is the sum's natural logarithm that is observed: of what is known by a factor, as a length."""
    origin: Literal["", "known before", "calibration"] = ""
    """Where it comes from: what was known of a camera before (`block.known`); a calibration, in files written before
    those had a place of their own (`block.stored`)."""


class RelationOfParameters(ObservationKind):
    """v = sum of factors times parameters - observed, or its natural logarithm - observed."""

    name = "relation"
    group = "relations"
    order = 5
    title = "Relations of parameters, smoothness of trajectories"
    object = "camera"
    quantities = "relations of parameters"
    unit = "own"

    def rows(self, table: Any, scope: Scope) -> Rows:
        found = [
            (r, k, relation.observed, relation.sigma)
            for r, i in enumerate(scope.interior)
            for k, relation in enumerate(i.relations)
            if {i.symbols[f] for f in i.free} & {*relation.terms}
        ]
        return Rows.of(*np.array(found, float).reshape(-1, 4).T)

    def observed(self, table: Any, rows: Rows, scope: Scope, values: Values) -> Observed:
        residual, found = np.zeros(len(rows)), []
        for n, (r, k) in enumerate(zip(rows.item.tolist(), rows.component.tolist(), strict=True)):
            interior = scope.interior[r]
            relation: Relation = interior.relations[k]
            places = [interior.symbols.index(s) for s in relation.terms]
            factors: Array = np.array([*relation.terms.values()])
            seen = float(factors @ values.interior[r, places])
            if relation.logarithm:
                seen = max(seen, SMALLEST * float(np.exp(rows.value[n])))
                factors, seen = factors / seen, float(np.log(seen))
            residual[n] = seen - rows.value[n]
            found.append(
                partials("interior", np.full(len(places), n), np.full(len(places), r), np.array(places), factors)
            )
        return Observed(residual, tuple(found))

    def named(self, table: Any, rows: Rows, scope: Scope) -> Named:
        mine = [scope.interior[r] for r in rows.item.tolist()]
        relations: list[Relation] = [i.relations[k] for i, k in zip(mine, rows.component.tolist(), strict=True)]
        return Named(tuple(i.key for i in mine), tuple(r.name for r in relations), tuple(r.origin for r in relations))

    def weighted(self, block: Any, factor: float) -> Any:
        def of(r: Relation) -> Relation:
            return r if r.origin == "known before" else replace(r, sigma=factor * r.sigma)

        return replace(block, cameras=tuple(replace(c, relations=tuple(map(of, c.relations))) for c in block.cameras))
