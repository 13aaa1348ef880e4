"""Which group of given values contradicts the rest: scale bars, control, positions, each left out in turn.

Where a block has no solution, or a bad one, the first thing that fails (a rank defect, rays that end parallel) is
seldom the cause: a length in millimetres or positions in degrees tear the block until something gives way.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.severity import POOR_FIT, Severity
from raybundle.block import Block, Distances, Stations
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted
from raybundle.numerics.length_units import factor_unit

NEAR = 0.01
"""Relative distance from a unit's factor within which it is named: photographs and control know the scale better."""
DEGREES = (180.0, 90.0)
"""Largest longitude and latitude."""
TINY = 1e-3
"""Extent of positions over that of the photographs' own from which on they may be degrees: 1 degree is 111 km."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Conflict:
    """A group of given values without which the block is adjusted well."""

    group: str
    """scale bars, control points, positions"""
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
    tries: list[tuple[str, int, Block]] = []
    if len(block.distances):
        tries.append(("scale bars", len(block.distances), block.having(Distances.empty())))
    if len(block.stations.image):
        tries.append(("positions", len(block.stations.image), block.having(Stations.empty())))
    if control:
        tries.append(("control points", control, without_control))
    if len(tries) < 2 and not control:
        return []
    found: list[Conflict] = []
    for group, count, rest in tries:
        result = solved(rest)
        if result is None or not result.sigma0 <= POOR_FIT:
            continue
        factor, unit, other = float("nan"), "", ""
        if group == "scale bars":
            factor = _of_lengths(block, result.adjusted)
            unit = factor_unit(factor, block.length_unit, NEAR, kilometres=True)
            other = factor_unit(1 / factor, block.length_unit, NEAR)
        elif group == "positions":
            factor, unit = _of_positions(block, result.adjusted)
        found.append(
            Conflict(group=group, count=count, sigma0=result.sigma0, factor=factor, unit=unit, other_unit=other)
        )
    return found


def conflict_words(found: list[Conflict], sigma0: float) -> str:
    """What contradicts what, and what to do; sigma0 NaN where there is no solution with everything."""
    groups = " and ".join(counted(c.count, c.group.removesuffix("s")) for c in found)
    every = f"sigma0 {sigma0:.3g} with all of them" if np.isfinite(sigma0) else "no solution with all of them"
    each = ", ".join(f"{c.sigma0:.3g} without the {c.group}" for c in found)
    others = [c.group for c in found if c.group != "scale bars"]
    named = [words for c in found if (words := _factor_words(c, others[0] if others else ""))]
    verb = "contradict each other" if len(found) > 1 else "contradict the other observations"
    todo = " ".join(named) or "Check their unit, coordinate system and names"
    return f"{groups} {verb}: {every}, sigma0 {each}. {todo}"


def conflict_notice(found: list[Conflict], sigma0: float) -> Notice:
    """The fault of a result."""
    values: dict[str, float | int | str] = {"sigma0": sigma0}
    for c in found:
        values |= {f"{c.group}: count": c.count, f"{c.group}: sigma0 without": c.sigma0}
        values |= {f"{c.group}: factor": c.factor, f"{c.group}: unit": c.unit} if c.unit else {}
    return Notice(
        code="groups_contradict", message=conflict_words(found, sigma0), measured=Severity.FAULT, values=values
    )


def _factor_words(conflict: Conflict, other: str) -> str:
    """The question for the unit, "" without one; `other` is what contradicts the bars as well as they do it."""
    if conflict.unit == "degrees":
        return "The positions lie within the range of longitude and latitude: degrees in place of metres?"
    asked = [f"are they in {conflict.unit}"] if conflict.unit else []
    asked += [f"are the {other} in {conflict.other_unit}"] if other and conflict.other_unit else []
    return f"Given lengths are {conflict.factor:.5g} times those adjusted: {', or '.join(asked)}?" if asked else ""


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
