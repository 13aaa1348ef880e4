"""The final adjustment of an oriented block: parameters by significance, blunders by data snooping, weak images out."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.decide import decide
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.structure import structure_notice
from raybundle.block import Block
from raybundle.block.select import attitudes_of, stations_of, with_rows
from raybundle.errors import NoConvergence, RankDefect
from raybundle.io.photos.cameras import CameraGroup
from raybundle.numerics.progress import Progress
from raybundle.workflows.georeference import Georeferenced, rejected_marks
from raybundle.workflows.parts import Part
from raybundle.workflows.tie_block import flat_points

FINAL = 1e-4
"""Last step of the final adjustment, in standard deviations of the unknowns."""
MOST_LEFT = 8
"""Photographs that the final adjustment may leave out one after the other."""
COARSE = 1e-2
"""The same where that is not reached: still far below what a standard deviation can tell."""


def final_adjustment(
    placed: Georeferenced, groups: Sequence[CameraGroup], jobs: int, progress: Progress, remarks: Sequence[str]
) -> Adjustment:
    """The final adjustment: parameters by significance and determinability, blunders by data snooping."""
    notices = [Notice(code="photographs", message=r) for r in remarks]
    notices += [Notice(code="camera", message=f"camera {g.id}: {r}", ids=(g.id,)) for g in groups for r in g.remarks]
    options = AdjustmentOptions(threads=jobs, reject="snooping", tolerance=FINAL, datum_over="good")
    block, flat = placed.block, flat_points(placed.block) & ~placed.marked
    flat &= ~placed.block.points.is_control.any(axis=1)
    flat &= np.bincount(block.observations.point, minlength=len(block.points)) > 0
    if flat.any():
        block = with_rows(block, ~flat[block.observations.point])
        message = f"{int(flat.sum())} tie points with parallel rays are left out: they have no depth"
        notices.append(Notice(code="parallel_rays", message=message))
        kept = np.isin(placed.block.points.ids, block.points.ids)
        placed = replace(placed, block=block, marked=placed.marked[kept])
    for _ in range(MOST_LEFT):
        try:
            result = _decided(placed.block, options, progress, (*notices, *placed.notices))
            break
        except RankDefect as error:
            named = re.search(r"exterior orientation of image (.+?) \(\d+ %\)", str(error))
            if named is None or int(placed.block.images.oriented.sum()) < 4:
                raise
            placed = _without_image(placed, named[1])
            message = f"{named[1]} is left out: what is left of its points does not determine its orientation"
            notices.append(Notice(code="image_left_out", message=message, ids=(named[1],)))
    else:
        result = _decided(placed.block, options, progress, (*notices, *placed.notices))
    first = list(rejected_marks(result, placed.marked[result.given.observations.point]))
    structure = structure_notice(result)
    first += [structure] if structure is not None else []
    return replace(result, notices=(*first, *result.notices)) if first else result


def left_out(adjustment: Adjustment, parts: Sequence[Part]) -> list[tuple[str, str]]:
    """Photographs that the final adjustments left out, and why."""
    notices = [n for a in (adjustment, *(p.adjustment for p in parts)) for n in a.notices]
    return [(n.ids[0], n.message.split(": ", 1)[1]) for n in notices if n.code == "image_left_out"]


def _decided(block: Block, options: AdjustmentOptions, progress: Progress, notices: tuple[Notice, ...]) -> Adjustment:
    try:
        return decide(block, options, progress, notices=notices)
    except NoConvergence:
        # two photographs, or a weak interior orientation: steps of a few thousandths of a sigma that do not end
        return decide(block, replace(options, tolerance=COARSE), progress, notices=notices)


def _without_image(placed: Georeferenced, name: str) -> Georeferenced:
    """The block without the image points and the orientation of an image."""
    block = placed.block
    out = np.array([n == name for n in block.images.ids])
    o = block.observations
    keep = ~out[o.image]
    rays = np.bincount(o.point[keep], minlength=len(block.points))
    fixed = block.points.is_control.any(axis=1)
    thin = with_rows(block, keep & ((rays > 1) | fixed)[o.point])
    images = replace(
        thin.images,
        centre=np.where(out[:, None], np.nan, thin.images.centre),
        rotation=np.where(out[:, None, None], np.nan, thin.images.rotation),
    )
    stations = stations_of(thin.stations, ~out[thin.stations.image])
    attitudes = attitudes_of(thin.attitudes, ~out[thin.attitudes.image])
    marked = placed.marked[np.isin(block.points.ids, thin.points.ids)]
    return replace(placed, block=replace(thin, images=images, stations=stations, attitudes=attitudes), marked=marked)


def adjusted_part(placed: Georeferenced, groups: Sequence[CameraGroup], jobs: int, progress: Progress) -> Part:
    """The adjustment of a part that nothing joins to the others."""
    images = placed.block.images
    names = tuple(n for n, o in zip(images.ids, images.oriented, strict=True) if o)
    return Part(adjustment=final_adjustment(placed, groups, jobs, progress, ()), photographs=names)
