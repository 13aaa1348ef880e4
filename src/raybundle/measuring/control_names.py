"""Control given by hand in a block that has its place: whether it lies there, and each name has its coordinates.

Control and positions may differ by a shift, which is estimated (`placing.positions`); nothing else moves the points
against each other.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import linear_sum_assignment

from raybundle.block import Block
from raybundle.errors import InputError, message
from raybundle.measuring.actions.control import GiveControl
from raybundle.measuring.state import State
from raybundle.numerics.arrays import Array

FEWEST = 3
"""Points: without one, two are left which agree in the shift or do not."""
ROUGHLY, SIGMAS = 0.1, 4.0
"""How far places before the adjustment may miss: a share of the extent, or standard deviations of the positions."""

EXTENTS = 10.0
"""How far the nearest control point may lie from the block: more than any shift of positions, less than a wrong zone,
unit or order of coordinates makes it"""


def check_reach(block: Block, action: GiveControl, crs: str = "") -> None:
    """Raise InputError for a table of control of which even the nearest point lies far from a block that has its place.

    Distances are in plan, in extents of the block from the median of its projection centres: a geoid undulation may be
    larger than an object.
    crs  the coordinate system of the project; empty: none
    """
    stations, p = block.stations, block.points
    if not len(stations) and not p.is_control.all(axis=1).any():
        return
    xyz = np.array([[np.nan if v is None else v for v in point.xyz] for point in action.points])
    plan = np.isfinite(xyz[:, :2]).all(axis=1)
    centres = block.images.centre[block.images.oriented]
    if not plan.any() or not len(centres):
        return
    middle = np.median(centres, axis=0)
    known = p.xyz[np.isfinite(p.xyz).all(axis=1)]
    object_ = np.median(np.linalg.norm(known - middle, axis=1)) if len(known) else 0.0
    extent = max(float(np.linalg.norm(centres - middle, axis=1).max()), float(object_))
    sigma = stations.sigma[np.isfinite(stations.sigma)]
    limit = EXTENTS * (extent + (float(np.median(sigma)) if len(sigma) else 0.0))
    apart = np.where(plan, np.linalg.norm(xyz[:, :2] - middle[:2], axis=1), np.inf)
    nearest = int(np.argmin(apart))
    if float(apart[nearest]) > limit:
        raise InputError(
            "mark.control_apart", file=action.file, point=action.points[nearest].point, distance=float(apart[nearest]),
            extent=extent, limit=limit, unit=block.length_unit, crs=crs or "none",
        )  # fmt: skip


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
