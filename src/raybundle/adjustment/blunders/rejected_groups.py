"""Images and control points of which data snooping rejected most observations: not blunders of single points.

What is left then fits, and nothing in it shows that a photograph or the control was left out piece by piece.
"""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.block.rejection import RejectionKind
from raybundle.numerics.arrays import Array

MOST = 0.5
"""Share of the observations of an image or of the rays of a control point: more are no blunders of single points."""
TIMES = 3.0
"""Ratio of an image's share to the median one: where gross errors are many everywhere, no image stands out."""
FEWEST_POINTS, FEWEST_RAYS = 10, 3
"""Smallest numbers of image points and of rays for such a share; two rays suffice if two control points agree."""
BLUNDERS = {RejectionKind.BLUNDER, RejectionKind.BLUNDER_NOT_LOCATED}


def rejected_group_notices(result: Adjustment) -> list[Notice]:
    """Faults that name the images and control points that data snooping has left out piece by piece."""
    block, o = result.given, result.given.observations
    out = np.array([r is not None and r.kind in BLUNDERS for r in result.image_observations.rejected], bool)
    if not out.any():
        return []
    found: list[Notice] = []
    share, count = _shares(o.image, out, len(block.images))
    seen = count > 0
    usual = float(np.median(share[seen]))
    bad = np.flatnonzero((count >= FEWEST_POINTS) & (share > MOST) & (share > TIMES * usual))
    if len(bad):
        names = tuple(block.images.ids[k] for k in bad)
        values = {"images": len(names), "limit": MOST, "median": usual}
        found.append(Notice(code="image_contradicts.rejected", ids=names, values=values))
    share, count = _shares(o.point, out, len(block.points))
    control = np.any(block.points.is_control, axis=1)
    bad = np.flatnonzero(control & (count >= 2) & (share > MOST))
    if len(bad) > 1 or (len(bad) == 1 and count[bad[0]] >= FEWEST_RAYS):
        names = tuple(block.points.ids[k] for k in bad)
        values = {"points": len(names), "control": int(control.sum()), "limit": MOST}
        found.append(
            Notice(code="control_contradicts.rejected", ids=names[:100], measured=Severity.FAULT, values=values)
        )
    return found


def _shares(of: Array, out: Array, count: int) -> tuple[Array, Array]:
    number = np.bincount(of, minlength=count)
    return np.bincount(of, out, count) / np.maximum(number, 1), number
