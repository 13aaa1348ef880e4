"""Control points that were given the coordinates of another one, as when a line of a file is copied."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.block import Block, Role
from raybundle.errors import Message, message
from raybundle.numerics.arrays import Array

APART = 5.0
"""Standard deviations of a difference beyond which it is one: by chance one of a million."""
ROUNDING = 1e-12
"""Share of the largest coordinate up to which two are the same number."""
SHOWN = 5


@dataclass(frozen=True, slots=True, kw_only=True)
class Twins:
    """Two names with coordinates that do not differ."""

    first: str
    second: str
    apart_px: float
    """Between their images in one photograph, where that is more than their standard deviations explain; else 0"""
    image: str
    """That photograph"""


def identical_control(block: Block) -> list[Twins]:
    """Pairs of control or check points whose coordinates agree within the standard deviation of their difference.

    Two names of one point are possible, and two points so close that their survey does not distinguish them.  That they
    are different ones and wrongly given is stated by a photograph that shows both: farther apart than APART standard
    deviations of the measurement, and than APART of their coordinates at the largest scale at which control points
    stand in any photograph.  Where no two lie far enough apart to show that scale, only numbers that are the same do:
    no survey of standard deviations above 0 gives two points the same.
    """
    points = block.points
    given = np.isfinite(points.xyz).all(axis=1) & np.isfinite(points.sigma).all(axis=1)
    rows = np.flatnonzero(given & np.isin(np.asarray(points.role), (Role.CONTROL, Role.CHECK)))
    if len(rows) < 2:
        return []
    xyz, sigma = points.xyz[rows], points.sigma[rows]
    order = np.lexsort(xyz.T[::-1])
    near = ROUNDING * float(np.abs(xyz).max())
    largest = float(sigma.max())
    found: list[Twins] = []
    for n, a in enumerate(order):
        for b in order[n + 1 :]:
            if xyz[b, 0] - xyz[a, 0] > near + 1.5 * largest:
                break
            allowed = near + np.hypot(sigma[a], sigma[b])
            if (np.abs(xyz[b] - xyz[a]) <= allowed).all():
                found.append(_twins(block, rows, *sorted((int(rows[a]), int(rows[b])))))
    return found


def _twins(block: Block, rows: Array, a: int, b: int) -> Twins:
    """The pair and, of the photographs that show both, the one in which they are farthest apart beyond doubt."""
    o, points = block.observations, block.points
    loose = APART * float(np.linalg.norm(np.hypot(points.sigma[a], points.sigma[b])))
    scale = _largest_scale(block, rows, 2 * loose)
    copied = (np.abs(points.xyz[a] - points.xyz[b]) <= ROUNDING * np.abs(points.xyz[[a, b]]).max()).all()
    allowed = loose * scale if scale > 0 else 0.0 if copied else np.inf
    best, where = 0.0, ""
    for image in np.intersect1d(o.image[o.point == a], o.image[o.point == b]):
        i, j = (np.flatnonzero((o.image == image) & (o.point == p))[0] for p in (a, b))
        gap = float(np.linalg.norm(o.xy_px[i] - o.xy_px[j]))
        noise = APART * float(np.sqrt(o.cov_px2[[i, j], :2].sum(axis=0).max()))
        if gap > max(noise + allowed, best):
            best, where = gap, block.images.ids[image]
    return Twins(first=points.ids[a], second=points.ids[b], apart_px=best, image=where)


def _largest_scale(block: Block, rows: Array, least: float) -> float:
    """Pixels for a unit of length between points farther apart than `least`, at most; 0 where there are none."""
    o, largest = block.observations, 0.0
    known = np.isin(o.point, rows)
    for image in np.unique(o.image[known]):
        mine = np.flatnonzero(known & (o.image == image))
        xy, xyz = o.xy_px[mine], block.points.xyz[o.point[mine]]
        i, j = np.triu_indices(len(mine), 1)
        length = np.linalg.norm(xyz[i] - xyz[j], axis=1)
        far = length > least
        scale = np.linalg.norm(xy[i] - xy[j], axis=1)[far] / length[far]
        largest = max(largest, float(scale.max(initial=0.0)))
    return largest


def identical_notices(block: Block) -> list[Notice]:
    """A fault for pairs that photographs distinguish, a caution for others."""
    pairs = identical_control(block)
    found: list[Notice] = []
    for wrong in (True, False):
        mine = [p for p in pairs if (p.apart_px > 0) == wrong]
        if mine:
            found.append(
                Notice(
                    code="control_identical" if wrong else "control_identical.alike",
                    values={"pairs": len(mine)},
                    ids=tuple(dict.fromkeys(name for p in mine for name in (p.first, p.second)))[:100],
                    measured=Severity.FAULT if wrong else Severity.WARNING,
                    details=tuple(map(_pair, mine[:SHOWN])),
                )
            )
    return found


def _pair(p: Twins) -> Message:
    if p.apart_px > 0:
        return message(
            "control_identical.pair_apart", first=p.first, second=p.second, apart_px=p.apart_px, image=p.image
        )
    return message("control_identical.pair", first=p.first, second=p.second)
