"""Velocities of what moved, from three dates on: of single points by the final adjustment, of areas by their test."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import date

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.measuring.joint import Joint
from raybundle.metrology.areas import AreaTest
from raybundle.metrology.trends import Series, Trend, trend
from raybundle.numerics.arrays import Array, Index
from raybundle.workflows.epochs.dated_points import Dated, Dates
from raybundle.workflows.epochs.stability import spread_evenly

MOST = 300
"""Points with a trend, spread evenly over those that moved: nine solutions of the normal equations for each of three
dates"""
FEWEST_DATES = 3


def trends(
    result: Adjustment, dated: Dated, dates: Dates, moved: Index, areas: Sequence[AreaTest]
) -> tuple[Trend, ...]:
    """Trends of points and areas with a place at three dates or more.

    moved  positions in `dated.bases`
    """
    if len(dates.names) < FEWEST_DATES:
        return ()
    days = np.array([date.fromisoformat(name).toordinal() for name in dates.names], float)
    freedom = float(result.redundancy) if result.redundancy > 0 else float("inf")
    made = [_of_area(a, days) for a in areas if a.given or (a.moved and not a.uneven)]
    joint = Joint.of(result, dated.place)
    there = {
        b: [k for k in np.flatnonzero(dated.at[b] >= 0).tolist() if joint.takes_part(int(dated.at[b, k]))]
        for b in moved.tolist()
    }
    enough = np.array([b for b, at in there.items() if len(at) >= FEWEST_DATES], np.int64)
    made += [
        _of_point(result, joint, dated, b, there[b], days)
        for b in spread_evenly(dated, enough, np.ones(len(enough)), MOST).tolist()
    ]
    return tuple(trend(s, freedom) for s in made)


def _of_area(a: AreaTest, days: Array) -> Series:
    k = len(a.displacement)
    return Series(
        name=a.name, area=True, first=0, dates=tuple(range(1, k + 1)), days=days[1:] - days[0],
        displacement=a.displacement, covariance=a.joint.reshape(3 * k, 3 * k),
    )  # fmt: skip


def _of_point(result: Adjustment, joint: Joint, dated: Dated, base: int, there: list[int], days: Array) -> Series:
    at = dated.at[base, there]
    metres = 0.001 if result.adjusted.length_unit == "mm" else 1.0
    xyz = metres * result.adjusted.points.xyz[at]
    k = len(at) - 1
    D = np.kron(np.hstack([-np.ones((k, 1)), np.eye(k)]), np.eye(3))
    return Series(
        name=dated.bases[base], area=False, first=there[0], dates=tuple(there[1:]),
        days=days[there[1:]] - days[there[0]], displacement=xyz[1:] - xyz[0],
        covariance=metres**2 * D @ joint.of_points(at.tolist()) @ D.T,
    )  # fmt: skip
