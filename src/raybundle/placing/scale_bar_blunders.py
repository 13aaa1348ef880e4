"""Scale bars that contradict the other ones: compared in a block that is adjusted without any bar.

A bar that is far too long pulls its ends out of the block: right image points end behind cameras, the bar loses its
ends, and a test of its residual is far outside of what is linear.  The block without bars is not bent by them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import POOR_FIT
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Distances
from raybundle.errors import Value, message
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.length_units import factor_unit
from raybundle.placing.approximate_scale import scale_of_start

AGREE = 0.01
"""Relative difference up to which the factors of two bars agree; smaller errors are left to the tests of residuals."""
SHOWN = 5


@dataclass(frozen=True, slots=True, kw_only=True)
class BarDoubt:
    """Bars without which the block and the other bars fit; or, without `rest`, bars of which some are wrong."""

    rows: tuple[int, ...]
    names: tuple[str, ...]
    given: tuple[float, ...]
    shown: tuple[float, ...]
    """in the block without them [object unit]; up to a common factor without `rest`"""
    unit: str
    """that explains the factor of all of them"""
    rest: Block | None
    """without these bars"""


def doubted_bars(block: Block, solved: Callable[[Block], Adjustment | None]) -> BarDoubt | None:
    """The bars that contradict the others, or those among which one does; None where none does, or it is not the bars.

    solved  adjusts a block with little else; None where there is no solution
    """
    d = block.distances
    free = solved(block.having(Distances.empty())) if len(d) else None
    if free is None or not free.sigma0 <= POOR_FIT:
        return None
    own = _lengths(block, free.adjusted)
    rows = np.flatnonzero(np.isfinite(own) & (own > 0))
    factor = np.log(np.asarray(d.length)[rows] / own[rows])
    groups = _groups(factor)
    known = "scale" not in free.datum_defect
    if known:
        right = next((g for g in groups if abs(np.median(factor[g])) < AGREE), None)
        if right is None or len(groups) == 1:  # all of them against all else, or none
            return None
    elif len(groups) < 2:
        return None
    else:
        right = _right(groups, factor, scale_of_start(block, free.adjusted), block.length_unit)
    wrong = rows if right is None else np.setdiff1d(rows, rows[right])
    rest: Block | None = None
    if right is not None:
        keep = ~np.isin(np.arange(len(d)), wrong)
        rest = block.having(
            replace(d, start=d.start[keep], end=d.end[keep], length=d.length[keep], sigma=d.sigma[keep])
        )
        settled = solved(rest)
        if settled is None or not settled.sigma0 <= POOR_FIT:
            return None
        own = _lengths(block, settled.adjusted)
    units = {factor_unit(float(d.length[k] / own[k]), block.length_unit, AGREE) for k in wrong}
    ids = block.points.ids
    return BarDoubt(
        rows=tuple(wrong.tolist()),
        names=tuple(f"{ids[d.start[k]]}-{ids[d.end[k]]}" for k in wrong),
        given=tuple(float(d.length[k]) for k in wrong),
        shown=tuple(float(own[k]) for k in wrong),
        unit=units.pop() if rest is not None and len(units) == 1 else "",
        rest=rest,
    )


def bar_doubt_notice(doubt: BarDoubt, unit: str) -> Notice:
    """The fault of a result without these bars, or of one that they bend."""
    rows = list(zip(doubt.names, doubt.given, doubt.shown, strict=True))[:SHOWN]
    values: dict[str, Value] = {"bars": len(doubt.names), "given": doubt.given[0], "shown": doubt.shown[0]}
    if doubt.rest is None:
        first = doubt.given[0] / doubt.shown[0]
        each = tuple(
            message("distance_suspect.factor", name=name, given=given, unit=unit, factor=given / own / first)
            for name, given, own in rows
        )
        return Notice(code="distance_suspect.contradict", ids=doubt.names[:100], values=values, details=each)
    each = tuple(
        message("distance_suspect.bar", name=name, given=given, shown=own, unit=unit) for name, given, own in rows
    )
    likely = doubt.unit or "none"
    return Notice(
        code="distance_suspect.left_out", ids=doubt.names[:100], values={**values, "likely": likely}, details=each
    )


def _lengths(block: Block, adjusted: Block) -> Array:
    """Lengths (k,) of the bars between adjusted points; NaN where an end took no part."""
    index = {name: k for k, name in enumerate(adjusted.points.ids)}
    at = np.array([index.get(name, -1) for name in block.points.ids], int)
    xyz = np.vstack([adjusted.points.xyz, np.full((1, 3), np.nan)])
    return np.linalg.norm(xyz[at[block.distances.start]] - xyz[at[block.distances.end]], axis=1)


def _groups(factor: Array) -> list[Index]:
    """Positions of logarithmic factors that agree, in groups with gaps between them."""
    order = np.argsort(factor, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(factor[order]) > AGREE) + 1)


def _right(groups: list[Index], factor: Array, start: tuple[float, float], unit: str) -> Index | None:
    """The group that is right; None where nothing chooses one.

    That of the scale of the approximate values, or from which a unit explains the others, or the largest one.
    start  factor of the block without bars to the approximate values, and its relative standard deviation
    """
    middle = [float(np.median(factor[g])) for g in groups]
    near = [g for g, m in zip(groups, middle, strict=True) if abs(m - np.log(start[0])) < max(3 * start[1], AGREE)]
    if len(near) == 1:
        return near[0]
    explained = [
        g
        for g, m in zip(groups, middle, strict=True)
        if all(
            other is g or factor_unit(float(np.exp(o - m)), unit, AGREE)
            for other, o in zip(groups, middle, strict=True)
        )
    ]
    if len(explained) == 1:
        return explained[0]
    most = max(len(g) for g in groups)
    largest = [g for g in groups if len(g) == most]
    return largest[0] if len(largest) == 1 else None
