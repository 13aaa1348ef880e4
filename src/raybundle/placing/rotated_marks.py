"""Marks that were measured in photographs as a viewer shows them, turned by their EXIF orientation: recognised, stated.

raybundle counts the pixels as stored, and so do programs that ignore the tag; browsers and most viewers turn the
picture first.  Such marks lie inside the photographs as a rule, and contradict each other by the size of the picture.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.errors import Value
from raybundle.io.geo.control_files import ControlFile
from raybundle.io.photos.photo import Photo, stored_from_upright
from raybundle.numerics.arrays import Index, Mask
from raybundle.placing.marks import GROSS, Placing, exif_turn, intersected
from raybundle.placing.rescaled_marks import CHANCE

READINGS = 2
"""As stored, and turned: the tries of which one may agree by chance."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Reading:
    """How marks in photographs that EXIF turns agree with each other and with the marks in the others."""

    median: float
    """Distance of a mark from where the others of its point put it [px]"""
    near: int
    """Marks within the gross limit"""
    chance: float
    """Probability of that agreement by chance"""


def take_turned_back(state: Placing, photos: Sequence[Photo], control: Sequence[ControlFile], mark_px: float) -> None:
    """Bring marks of each control file to the pixels as stored, where they were measured in pictures that EXIF turns.

    They are taken so where the format cannot hold them as stored, or where more than half of those that can be looked
    at lie beyond the gross limit as stored and within it turned back, more of them than chance would bring (`CHANCE`).
    Where they fit better turned and chance may do that as well, they stay as they are and a fault states it.

    Limits: points that are marked in a single photograph each, and pictures reduced besides.
    """
    tags = np.array([exif_turn(p) for p in photos])
    for file in control:
        mine = {name: k for k, name in enumerate(state.block.points.ids)}
        points = np.array([mine[n] for n in file.ids if n in mine], np.int32)
        o = state.block.observations
        rows = np.flatnonzero(np.isin(o.point, points))
        turned = tags[o.image[rows]] != 1
        if not turned.any():
            continue
        block = _turned_back(state.block, photos, rows[turned])
        outside = not _inside(state.block, rows[turned]) and _inside(block, rows[turned])
        before = reading(state.block, rows, turned, mark_px)
        after = reading(block, rows, turned, mark_px)
        limit = GROSS * mark_px
        if not outside:
            if before is None or after is None or before.median <= limit or after.near <= before.near:
                continue
            if after.median > limit or after.chance > CHANCE:
                state.notices.append(_open(file, photos, o.image[rows[turned]], before, after, limit))
                continue
        state.block = block
        state.notices.append(_notice(file, photos, o.image[rows[turned]], before, after, outside=outside))


def reading(block: Block, rows: Index, turned: Mask, mark_px: float) -> Reading | None:
    """How well marks agree, those of photographs that EXIF turns; None where no point has a second ray.

    rows    (n,) of the marks
    turned  (n,) which of them are in photographs that EXIF turns

    A ray of a wrong mark passes within q of a place that other rays give with a probability of about 2 q / long side,
    for each coordinate that is surplus with these marks and was not without them.
    """
    o = block.observations
    point, n = o.point[rows], len(block.points)
    rays, touched = np.bincount(point, minlength=n), np.bincount(point[turned], minlength=n) > 0
    looked = np.flatnonzero(touched[point] & (rays[point] > 1))
    if not len(looked):
        return None
    mine, which = rows[looked], turned[looked]
    few = replace(block, observations=o.rows(mine))
    free = intersected(few)
    xyz = np.where(np.isfinite(free), free, block.points.xyz)
    v = residuals_px(replace(few, points=replace(block.points, xyz=xyz)), np.arange(len(mine)))
    distance = np.linalg.norm(v, axis=1)
    distance = np.where(np.isfinite(distance), distance, np.inf)
    near = distance <= GROSS * mark_px
    every, alone = (np.bincount(o.point[mine][m], minlength=n) for m in (near, near & ~which))
    surplus = int((np.maximum(2 * every - 3, 0) - np.maximum(2 * alone - 3, 0)).sum())
    side = max(max(c.width_px, c.height_px) for c in block.cameras)
    farthest = float(distance[near].max(initial=0.0))
    chance = min(1.0, READINGS * (2 * farthest / side) ** surplus) if surplus > 0 else 1.0
    return Reading(median=float(np.median(distance[which])), near=int((near & which).sum()), chance=chance)


def _turned_back(block: Block, photos: Sequence[Photo], rows: Index) -> Block:
    o = block.observations
    xy = o.xy_px.copy()
    for i in np.unique(o.image[rows]).tolist():
        these = rows[o.image[rows] == i]
        xy[these] = stored_from_upright(xy[these], photos[i])
    return replace(block, observations=replace(o, xy_px=xy))


def _inside(block: Block, rows: Index) -> bool:
    o = block.observations
    size = np.array([(c.width_px, c.height_px) for c in block.cameras], float)[block.images.camera[o.image[rows]]]
    return bool(((o.xy_px[rows] >= 0) & (o.xy_px[rows] <= size)).all())


def _lead(file: ControlFile, photos: Sequence[Photo], image: Index) -> dict[str, Value]:
    shown = np.unique(image)
    tags = np.unique([exif_turn(photos[i]) for i in shown.tolist()]).tolist()
    return {"table": file.path.name, "marks": len(image), "photographs": len(shown), "orientations": tags}


def _apart(r: Reading | None) -> float | None:
    return r.median if r is not None and np.isfinite(r.median) else None


def _notice(
    file: ControlFile, photos: Sequence[Photo], image: Index, before: Reading | None, after: Reading | None, *,
    outside: bool,
) -> Notice:  # fmt: skip
    apart = {"before_px": _apart(before), "after_px": _apart(after)}
    compared = None not in apart.values()
    return Notice(
        code="marks_turned", ids=(str(file.path.name),),
        values={**_lead(file, photos, image), **apart, "compared": compared, "outside": outside},
    )  # fmt: skip


def _open(
    file: ControlFile, photos: Sequence[Photo], image: Index, before: Reading, after: Reading, limit: float
) -> Notice:
    apart = {"before_px": _apart(before), "after_px": _apart(after)}
    return Notice(
        code="marks_turned.undecided", ids=(str(file.path.name),), measured=Severity.FAULT,
        values={
            **_lead(file, photos, image), **apart, "compared": None not in apart.values(), "limit_px": limit,
            "before_near": before.near, "after_near": after.near,
        },
    )  # fmt: skip
