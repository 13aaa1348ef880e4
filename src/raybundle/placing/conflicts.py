"""Which group of given values contradicts the rest: scale bars, control, positions, each left out in turn.

Where a block has no solution, or a bad one, the first thing that fails (a rank defect, rays that end parallel) is
seldom the cause: a length in millimetres or positions in degrees tear the block until something gives way.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Distances, Stations
from raybundle.errors import Message, message
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import factor_unit

NEAR = 0.01
"""Relative distance from a unit's factor within which it is named: photographs and control know the scale better."""
DEGREES = (180.0, 90.0)
"""Largest longitude and latitude."""
TINY = 1e-3
"""Extent of positions over that of the photographs' own from which on they may be degrees: 1 degree is 111 km."""


Group = Literal["bars", "positions", "control"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Conflict:
    """A group of given values without which the block is adjusted well."""

    group: Group
    count: int
    sigma0: float
    """without the group"""
    factor: float = float("nan")
    """median of given lengths over adjusted ones"""
    unit: str = ""
    """in which the values seem to be given"""
    other_unit: str = ""
    """in which what they contradict would have to be given instead"""


def conflicts(block: Block, solved: Callable[[Block], Adjustment | None], without_control: Block) -> list[Conflict]:
    """The groups without which the block has a solution that fits; empty where there is none.

    solved           adjusts a block with little else; None where there is no solution
    without_control  the block whose control points are tie points
    """
    control = int(block.points.is_control.any(axis=1).sum())
    tries: list[tuple[Group, int, Block]] = []
    if len(block.distances):
        tries.append(("bars", len(block.distances), block.having(Distances.empty())))
    if len(block.stations.image):
        tries.append(("positions", len(block.stations.image), block.having(Stations.empty())))
    if control:
        tries.append(("control", control, without_control))
    if len(tries) < 2 and not control:
        return []
    found: list[Conflict] = []
    for group, count, rest in tries:
        result = solved(rest)
        if result is None or not result.sigma0 <= POOR_FIT:
            continue
        factor, unit, other = float("nan"), "", ""
        if group == "bars":
            factor = _of_lengths(block, result.adjusted)
            unit = factor_unit(factor, block.length_unit, NEAR, kilometres=True)
            other = factor_unit(1 / factor, block.length_unit, NEAR)
        elif group == "positions":
            factor, unit = _of_positions(block, result.adjusted)
        found.append(
            Conflict(group=group, count=count, sigma0=result.sigma0, factor=factor, unit=unit, other_unit=other)
        )
    return found


def conflict_message(found: list[Conflict], sigma0: float) -> Message:
    """The groups that contradict each other; sigma0 NaN where there is no solution with everything."""
    others = [c.group for c in found if c.group != "bars"]
    solved = bool(np.isfinite(sigma0))
    return message(
        "groups_contradict", groups=len(found), solved=solved, sigma0=sigma0 if solved else None,
        details=[_group_message(c, others[0] if others else "none") for c in found],
    )  # fmt: skip


def conflict_notice(found: list[Conflict], sigma0: float) -> Notice:
    """The fault of a result."""
    m = conflict_message(found, sigma0)
    return Notice(code="groups_contradict", measured=Severity.FAULT, values=m.values, details=m.details)


def _group_message(conflict: Conflict, other: str) -> Message:
    """A group and the units that explain it; `other` is what contradicts the bars as well as they do it."""
    known = bool(np.isfinite(conflict.factor)) and bool(conflict.unit or (conflict.other_unit and other != "none"))
    return message(
        "groups_contradict.group", group=conflict.group, n=conflict.count, sigma0=conflict.sigma0,
        factor=conflict.factor if known else None, unit=conflict.unit or "none",
        other=other if conflict.other_unit else "none", other_unit=conflict.other_unit,
    )  # fmt: skip


def _of_lengths(block: Block, adjusted: Block) -> float:
    """Median factor of the given lengths; NaN without one."""
    index = {name: k for k, name in enumerate(adjusted.points.ids)}
    d, ids = block.distances, block.points.ids
    ends = [(index.get(ids[a]), index.get(ids[b])) for a, b in zip(d.start.tolist(), d.end.tolist(), strict=True)]
    rows = [k for k, (a, b) in enumerate(ends) if a is not None and b is not None]
    xyz = adjusted.points.xyz
    own = np.array([np.linalg.norm(xyz[ends[k][0]] - xyz[ends[k][1]]) for k in rows])
    factor = np.asarray(d.length)[rows] / np.maximum(own, 1e-300)
    if not len(factor):
        return float("nan")
    return float(np.median(factor))


def _of_positions(block: Block, adjusted: Block) -> tuple[float, str]:
    """Extent of the positions over that of the adjusted centres in plan, and "degrees" where they may be some."""
    given: Array = np.asarray(block.stations.xyz)[:, :2]
    index = {name: k for k, name in enumerate(adjusted.images.ids)}
    rows = [index[block.images.ids[i]] for i in block.stations.image.tolist()]
    own = float(np.linalg.norm(np.ptp(adjusted.images.centre[rows, :2], axis=0)))
    factor = float(np.linalg.norm(np.ptp(given, axis=0))) / max(own, 1e-300)
    inside = bool((np.abs(given) <= DEGREES).all()) and factor < TINY
    return factor, "degrees" if inside else ""
