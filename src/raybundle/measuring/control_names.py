"""Control given by hand in a block that positions of photographs place: whether each name has its coordinates.

Control and positions may differ by a shift, which is estimated (`placing.positions`); nothing else moves the points
against each other.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import linear_sum_assignment

from raybundle.block import Block
from raybundle.errors import InputError, message
from raybundle.measuring.state import State
from raybundle.numerics.arrays import Array

FEWEST = 3
"""Points: without one, two are left which agree in the shift or do not."""
ROUGHLY, SIGMAS = 0.1, 4.0
"""How far places before the adjustment may miss: a share of the extent, or standard deviations of the positions."""


def check_names(block: Block, state: State, places: Array) -> None:
    """Raise InputError for control that no shift brings to its marks.

    places  (p, 3) where the rays of the marks meet; NaN elsewhere
    """
    p, sigma = block.points, block.stations.sigma[np.isfinite(block.stations.sigma)]
    known = np.isfinite(p.xyz).all(axis=1) & p.is_control.all(axis=1) & np.isfinite(places).all(axis=1)
    at = [k for k in np.flatnonzero(known).tolist() if p.ids[k] in state.points]
    if len(at) < FEWEST or not len(sigma):
        return
    given, seen = p.xyz[at] - p.xyz[at].mean(axis=0), places[at] - places[at].mean(axis=0)
    extent = float(np.median(np.linalg.norm(seen, axis=1)))
    limit = max(ROUGHLY * extent, SIGMAS * float(np.median(sigma)))
    missed = _misfit(given - seen)
    if not missed > limit:
        return
    row, column = linear_sum_assignment(np.linalg.norm(given[:, None] - seen[None], axis=2) ** 2)
    exchanged = _misfit(given[row] - seen[column]) <= limit
    pairs = [
        message("mark.control_named", point=p.ids[at[i]], at=p.ids[at[j]])
        for i, j in zip(row.tolist(), column.tolist(), strict=True)
        if i != j and exchanged
    ]
    raise InputError(
        "mark.control_names", n=len(at), missed=missed, limit=limit, unit=block.length_unit, exchanged=len(pairs),
        details=pairs,
    )  # fmt: skip


def _misfit(apart: Array) -> float:
    """The median distance of points after a common shift, which that of one of them is: the best."""
    distances = np.linalg.norm(apart[:, None] - apart[None], axis=2)
    return min(float(np.median(np.delete(d, k))) for k, d in enumerate(distances))
