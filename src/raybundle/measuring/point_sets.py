"""The points of an adjustment as a measured set: coordinates with their joint covariance, in metres."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block.points import automatic
from raybundle.errors import InputError
from raybundle.measuring.joint import Joint
from raybundle.metrology.point_set import PointSet

MOST = 2000
"""Points of which a joint covariance is formed: 6000 x 6000 numbers"""


def point_set(result: Adjustment, name: str, points: Sequence[str] = ()) -> PointSet:
    """Points of an adjustment that take part and have a name of their own, or these.

    raises  InputError where there are none, or too many for a joint covariance
    Held points are left out: they have no errors.
    """
    joint, block = Joint.of(result), result.adjusted
    ids = block.points.ids
    mine = np.flatnonzero(joint.work.system.points_used & ~automatic(ids))
    if points:
        wanted = set(points)
        mine = mine[[ids[k] in wanted for k in mine]]
    if not len(mine):
        raise InputError("joint.no_named_points", name=name)
    if len(mine) > MOST:
        raise InputError("joint.too_many_points", name=name, n=len(mine), most=MOST)
    metres = 0.001 if block.length_unit == "mm" else 1.0
    free = result.free_scale
    return PointSet(
        name=name, ids=tuple(ids[k] for k in mine), xyz=metres * block.points.xyz[mine],
        covariance=metres**2 * joint.of_points(mine.tolist()),
        freedom=float(result.redundancy) if result.redundancy > 0 else float("inf"), free_scale=free,
    )  # fmt: skip
