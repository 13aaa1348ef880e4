"""Parameters of interior orientations, antennas and IMUs that are observed: each near the value that was given.

Each for itself, or all together as a calibration gave them, with their covariance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.observations.kind import Interior, Joint, Named, ObservationKind, Observed, Rows, Scope, Values, partials


@dataclass(frozen=True, slots=True, kw_only=True)
class Calibrated:
    """Parameters of a camera as a calibration found them."""

    symbols: tuple[str, ...]
    values: tuple[float, ...]
    sigma: tuple[float, ...]
    correlations: tuple[tuple[float, ...], ...]
    """Of each parameter with those before it and itself (1)"""

    @property
    def correlation(self) -> Array:
        """(u, u) of all with all."""
        R = np.zeros((len(self.symbols),) * 2)
        for k, row in enumerate(self.correlations):
            R[k, : k + 1] = R[: k + 1, k] = row
        return R

    @property
    def covariance(self) -> Array:
        """(u, u) of the symbols."""
        return self.correlation * np.outer(self.sigma, self.sigma)


class ObservedParameter(ObservationKind):
    """v = parameter - given; those of a calibration are correlated.

    Of a calibration of which some parameters are held, the others are observed as it shows them given those.
    """

    name = "parameter"
    group = "parameters"
    order = 4
    title = "Observed parameters"
    object = "camera"
    quantities = "observed parameters"
    unit = "own"

    def rows(self, table: Any, scope: Scope) -> Rows:
        item, component, value, sigma, joint = list[int](), list[int](), list[float](), list[float](), list[Joint]()
        for r, i in enumerate(scope.interior):
            for k in i.free:
                if i.sigma.get(i.symbols[k], 0) > 0:
                    item, component = [*item, r], [*component, k]
                    value, sigma = [*value, i.given[i.symbols[k]]], [*sigma, i.sigma[i.symbols[k]]]
            places, expected, C = _calibrated(i)
            if not places:
                continue
            size = np.sqrt(np.diagonal(C))
            joint.append(Joint(len(item) + np.arange(len(places), dtype=np.int32), C / np.outer(size, size)))
            item, component = [*item, *[r] * len(places)], [*component, *places]
            value, sigma = [*value, *expected.tolist()], [*sigma, *size.tolist()]
        return Rows.of(item, component, value, sigma, joint=tuple(joint))

    def observed(self, table: Any, rows: Rows, scope: Scope, values: Values) -> Observed:
        residual = values.interior[rows.item, rows.component] - rows.value
        return Observed(residual, (partials("interior", np.arange(len(rows)), rows.item, rows.component, np.ones(1)),))

    def named(self, table: Any, rows: Rows, scope: Scope) -> Named:
        mine = [scope.interior[r] for r in rows.item.tolist()]
        symbols = (i.symbols[k] for i, k in zip(mine, rows.component.tolist(), strict=True))
        together = {int(k) for j in rows.joint for k in j.rows}
        origin = tuple("calibration" if k in together else "" for k in range(len(rows))) if together else ()
        return Named(tuple(i.key for i in mine), tuple(symbols), origin)

    def weighted(self, block: Any, factor: float) -> Any:
        def of(camera: Any) -> Any:
            c = camera.calibrated
            wider = None if c is None else replace(c, sigma=tuple(factor * s for s in c.sigma))
            return replace(camera, sigma={s: v * factor for s, v in camera.sigma.items()}, calibrated=wider)

        return replace(block, cameras=tuple(map(of, block.cameras)))


def _calibrated(interior: Interior) -> tuple[list[int], Array, Array]:
    """Positions of the free parameters that a calibration shows, what it expects of them, and their covariance."""
    known: Calibrated | None = interior.calibrated
    if known is None:
        return [], np.zeros(0), np.zeros((0, 0))
    at = [interior.symbols.index(s) for s in known.symbols]
    free = np.array([p in interior.free for p in at], bool)
    C, expected = known.covariance, np.array(known.values)
    held = np.array([interior.given.get(s, v) for s, v in zip(known.symbols, known.values, strict=True)])
    if free.any() and not free.all():
        gain = np.linalg.solve(C[np.ix_(~free, ~free)], C[np.ix_(~free, free)]).T
        expected = expected[free] + gain @ (held - expected)[~free]
        C = C[np.ix_(free, free)] - gain @ C[np.ix_(~free, free)]
        C = (C + C.T) / 2
    return [p for p, f in zip(at, free.tolist(), strict=True) if f], expected, C
