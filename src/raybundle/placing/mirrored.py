"""Control in a system of the other hand: axes exchanged, or one counted the other way.

No rotation brings such coordinates onto a block.  The adjustment would reject right points one by one until the rest,
nearly in a plane, fits either way.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block, Role
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import similarity

FEWEST = 5
"""Points, as four of which one has its depth on the wrong side look like their mirror image."""
LEVEL = 1e-3
"""Probability with which control that is not mirrored is called so, at most."""
HAND = np.array([1.0, 1.0, -1.0])


def mirrored_notices(block: Block, free: Array) -> list[Notice]:
    """A fault where control and check points fit their mirror image, and as given do not.

    free  (p, 3) the points as the photographs alone have them; NaN where they do not
    With W the square sums of the residuals of similarities, W' of the mirrored points with r' = 3 n - 7, and W as given
    without the point whose absence helps most, r = r' - 3: if both fitted alike, (W / r) / (W' / r') were distributed
    as F(r, r').  One wrong point therefore does not look like a mirror; points in a plane fit either way.
    """
    points = block.points
    given = np.isin(np.asarray(points.role), (Role.CONTROL, Role.CHECK)) & np.isfinite(points.xyz).all(axis=1)
    rows = np.flatnonzero(given & np.isfinite(free).all(axis=1))
    n = len(rows)
    if n < FEWEST:
        return []
    source, target = free[rows], points.xyz[rows]
    try:
        turned = _squares(source * HAND, target)
        as_given = min(_squares(np.delete(source, k, 0), np.delete(target, k, 0)) for k in range(n))
        every = _squares(source, target)
    except InputError:  # in a line
        return []
    redundancy = 3 * n - 7
    F = (as_given / (redundancy - 3)) / max(turned / redundancy, 1e-300)
    if not fisher_tail(F, redundancy - 3, redundancy) < LEVEL:
        return []
    rms, mirror = (float(np.sqrt(W / redundancy)) for W in (every, turned))
    names = tuple(points.ids[k] for k in rows)
    values = {"n": n, "rms_m": rms, "mirrored_m": mirror}
    return [Notice(code="control_mirrored.points", ids=names[:100], values=values)]


def without_control(block: Block, rows: Index | None = None) -> Block:
    """The block in which these control and check points were given no coordinates; None: all of them."""
    p = block.points
    given = np.isin(np.asarray(p.role), (Role.CONTROL, Role.CHECK))
    given &= True if rows is None else np.isin(np.arange(len(p)), rows)
    nothing = np.where(given[:, None], np.nan, p.xyz), np.where(given[:, None], np.nan, p.sigma)
    role = np.where(given, Role.CONTROL, p.role).astype(np.int32)  # marked, and without coordinates
    return replace(block, points=replace(p, xyz=nothing[0], sigma=nothing[1], role=role))


def _squares(source: Array, target: Array) -> float:
    """Square sum of the residuals of a similarity."""
    return float(np.sum(similarity(source, target).residuals ** 2))
