"""The final adjustment of an oriented block: parameters by significance, blunders by data snooping, weak images out."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Literal

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.evaluation.check_points import with_check_notice
from raybundle.adjustment.evaluation.residual_structure import structure_notice
from raybundle.adjustment.records.notice import Notice, notice_of_text
from raybundle.adjustment.records.options import (
    FEWEST_IMAGES,
    AdjustmentOptions,
    NoiseModel,
    RejectMode,
    noise_of_photographs,
)
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera, Role
from raybundle.block.select import with_rows, without_images
from raybundle.calibration.previous_calibration import calibration_notices, held_notices
from raybundle.errors import Message, NoConvergence, NotSolvable, Text, as_detail, message, phrase
from raybundle.io.photos.cameras import CameraGroup
from raybundle.numerics.arrays import Mask
from raybundle.numerics.progress import Progress
from raybundle.orientation.known_points import intersected_where_better
from raybundle.placing.georeference import Georeferenced, rejected_marks
from raybundle.placing.recorded_positions import camera_notices
from raybundle.ties.block import flat_points
from raybundle.workflows.orienting.connected_components import ConnectedComponent

FINAL = 1e-4
"""Last step of the final adjustment, in standard deviations of the unknowns."""
NAMED, ALONE = 0.05, 0.5
"""Shares of an image in what is not determined: from which on it is named, and from which on it is so by itself."""
TOO_SMALL = {"interior_least": 1.7, "interior_most": 18.0, "points_least": 1.1, "points_most": 3.4}
"""Differences of halves of nine real sets over what standard deviations by independent errors promise: roots of the
median chi-square per value, 2.9 to 330 and 1.2 to 12 (`interior_white`, `points_white` of
benchmarks/results/real_sigmas.json; the latter of eight)."""
COARSE = 1e-2
"""The same where that is not reached: still far below what a standard deviation can show."""


def final_adjustment(
    placed: Georeferenced, groups: Sequence[CameraGroup], jobs: int, progress: Progress, remarks: Sequence[str],
    noise: NoiseModel = "auto", *, weights: Literal["given", "residuals"] = "given", reject: RejectMode = "snooping",
) -> Adjustment:  # fmt: skip
    """The final adjustment: parameters by significance and determinability, blunders by data snooping.

    weights  residuals: the standard deviations of the tie points were taken from theirs
    reject   none: gross errors stay, unless there is no solution with them
    """
    notices = [notice_of_text("photographs", r) for r in remarks]
    notices += camera_notices(groups)
    photographs = int(placed.block.images.oriented.sum())
    chosen = noise_of_photographs(noise, photographs)
    options = AdjustmentOptions(
        jobs=jobs, reject=reject, tolerance=FINAL, datum_over="good", noise=chosen, weights=weights
    )
    asked = placed
    block, flat = placed.block, flat_points(placed.block) & ~placed.marked
    flat &= ~placed.block.points.is_control.any(axis=1)
    flat &= np.bincount(block.observations.point, minlength=len(block.points)) > 0
    if flat.any():
        block = with_rows(block, ~flat[block.observations.point])
        if not len(block.observations):
            raise NotSolvable("network.no_depth")
        notices.append(Notice(code="parallel_rays", values={"n": int(flat.sum())}))
        placed = _with_block(placed, block)
    placed, result = _held(placed, options, progress, notices)
    if noise == "auto" and chosen == "white":
        reason = phrase("noise.too_few_photographs", n=photographs, least=FEWEST_IMAGES)
        result = replace(result, noise=replace(result.noise, reason=reason))
    first = [
        *rejected_marks(result, placed.marked[result.given.observations.point]),
        *_lost_marks(asked, result),
    ]
    structure = structure_notice(result)  # where standard deviations do not allow for it
    first += [structure] if structure is not None else []
    given = [g.id for g in groups if g.stored is not None and g.stored.estimate == ()]
    first += independent_notices(noise, chosen, int(result.adjusted.images.oriented.sum()))
    first += [*calibration_notices(result), *held_notices(result, given)]
    return with_check_notice(replace(result, notices=(*first, *result.notices)))


def independent_notices(asked: NoiseModel, chosen: NoiseModel, images: int) -> list[Notice]:
    """That few photographs are adjusted with independent errors, which `auto` did not choose for being right."""
    if asked != "auto" or chosen != "white":
        return []
    return [Notice(code="errors_independent", values={"images": images, "least": FEWEST_IMAGES, **TOO_SMALL})]


def _lost_marks(asked: Georeferenced, result: Adjustment) -> list[Notice]:
    """Marked points of which the result has no coordinates, though they were marked more than once: each by name."""
    given, o = result.given, result.given.observations
    rays = np.bincount(o.point[result.image_observations.used], minlength=len(given.points))
    placed = (rays > 1) | np.asarray(given.points.is_control).any(axis=1)
    left = {n for n, p in zip(given.points.ids, placed.tolist(), strict=True) if p}
    before = asked.block.ray_count
    left |= {name for n in result.notices if n.code == "control_left_out" for name in n.ids}  # which that shows
    return [
        Notice(
            code="marked_lost",
            values={"point": name, "rays": int(before[k])},
            ids=(name,),
        )
        for k, name in enumerate(asked.block.points.ids)
        if asked.marked[k] and before[k] > 1 and name not in left
    ]


def left_out(adjustment: Adjustment, parts: Sequence[ConnectedComponent]) -> list[tuple[str, str]]:
    """Photographs that the final adjustments left out, and why."""
    notices = [n for a in (adjustment, *(p.adjustment for p in parts)) for n in a.notices]
    return [(n.ids[0], n.reason) for n in notices if n.code == "image_left_out"]


def _held(
    placed: Georeferenced, options: AdjustmentOptions, progress: Progress, notices: Sequence[Notice]
) -> tuple[Georeferenced, Adjustment]:
    """The adjustment of what can be adjusted: what it names as not determined leaves, and is reported.

    First images and points that are named, then the cameras' freedom, then control, with everything else as it was,
    then the image with the fewest points: a defect ends the run only where it would leave fewer than two images.
    Where control leaves, everything else returns, and nothing of what was tried with it is reported.
    """
    whole, found = placed, list[Notice]()
    while True:
        try:
            return placed, _decided(placed.block, options, progress, (*notices, *found, *placed.notices))
        except NotSolvable as error:
            less = _without_images(placed, error) or _without_points(placed, error) or _with_held_cameras(placed)
            if less is None and (less := _without_control(placed, whole, error)) is not None:
                found.clear()
            less = less or _without_smallest(placed)
            if less is None or not len(less[0].block.observations):
                raise
            placed, more = less
            found += more


def _decided(block: Block, options: AdjustmentOptions, progress: Progress, notices: tuple[Notice, ...]) -> Adjustment:
    start = intersected_where_better(block, (Role.CHECK,)).block
    if options.reject == "none":
        with suppress(NotSolvable):
            return decide(start, options, progress, notices=notices)
        options = replace(options, reject="snooping")
    try:
        result = decide(start, options, progress, notices=notices)
    except NoConvergence:
        # two photographs, or a weak interior orientation: steps of a few thousandths of a sigma that do not end
        result = decide(start, replace(options, tolerance=COARSE), progress, notices=notices)
    check = (np.asarray(block.points.role) == Role.CHECK)[:, None]
    points = result.given.points  # the coordinates to compare with are those that were given
    points = replace(points, xyz=np.where(check, block.points.xyz, points.xyz))
    return replace(result, given=replace(result.given, points=points))


Relieved = tuple[Georeferenced, list[Notice]] | None


def _without_images(placed: Georeferenced, error: NotSolvable) -> Relieved:
    """Without the images that are not determined by themselves, or the one with the largest share in it."""
    named = [u for u in error.undetermined if u.kind == "image" and u.share > NAMED]
    if not named or any(u.kind == "parameter" and u.share > named[0].share for u in error.undetermined):
        return None
    alone = [u.name for u in named if u.share > ALONE] or [named[0].name]
    return _left_out(placed, alone, phrase("excluded.undetermined"))


def excluded_image(name: str, reason: Text) -> Notice:
    """That an image takes no part."""
    return Notice(code="image_left_out", values={"image": name}, ids=(name,), reason=reason, details=(reason.message,))


def _left_out(placed: Georeferenced, names: Sequence[str], reason: Text) -> Relieved:
    ids = placed.block.images.ids
    out = np.isin(np.array(ids), names) & placed.block.images.oriented
    if not out.any() or int(placed.block.images.oriented.sum()) - int(out.sum()) < 2:
        return None
    notices = [excluded_image(name, reason) for name, o in zip(ids, out, strict=True) if o]
    return _with_block(placed, without_images(placed.block, out)), notices


def _without_points(placed: Georeferenced, error: NotSolvable) -> Relieved:
    """Without the tie points that are not determined."""
    block = placed.block
    control = np.asarray(block.points.is_control).any(axis=1)
    out = np.isin(np.array(block.points.ids), error.names("point")) & ~control
    rows = ~out[block.observations.point]
    if rows.all() or not rows.any():
        return None
    notice = Notice(code="points_left_out", values={"n": int(out.sum())})
    return _with_block(placed, with_rows(block, rows)), [notice]


def _with_held_cameras(placed: Georeferenced) -> Relieved:
    """With the interior orientations held as they are."""
    free = [c.id for c in placed.block.cameras if c.scene is None and c.estimate]
    if not free:
        return None
    cameras = tuple(replace(c, estimate=()) if c.id in free else c for c in placed.block.cameras)
    details = tuple(_scale(c) for c in placed.block.cameras if c.id in free)
    notice = Notice(code="held_not_determinable.cameras", values={"n": len(free)}, ids=tuple(free), details=details)
    return replace(placed, block=replace(placed.block, cameras=cameras)), [notice]


def _without_control(placed: Georeferenced, whole: Georeferenced, error: NotSolvable) -> Relieved:
    """The whole block without control and its marks, where the block still has some: they may be what contradicts."""
    block = placed.block
    if not np.asarray(block.points.is_control).any() or not _tie_rows(whole.block).any():
        return None
    p, rows, control = whole.block.points, _tie_rows(whole.block), _control(whole.block)
    names = [n for n, c in zip(p.ids, control, strict=True) if c]
    role, sigma = np.array(p.role), np.array(p.sigma)
    role[control], sigma[control] = Role.TIE, np.nan
    kept = np.where(control, -1, np.arange(len(p)))
    free = replace(whole.block, points=replace(p, role=role, sigma=sigma)).of_tables(
        lambda t: t.renumbered("point", kept)
    )
    left = with_rows(free, rows)
    notice = Notice(
        code="control_left_out.unsolvable", values={"n": len(names)}, ids=tuple(names),
        details=(as_detail(error),),
    )  # fmt: skip
    return _with_block(whole, left), [notice]


def _control(block: Block) -> Mask:
    return np.asarray(block.points.is_control.any(axis=1), bool)


def _tie_rows(block: Block) -> Mask:
    return ~_control(block)[block.observations.point]


def _scale(camera: Camera) -> Message:
    """The camera constant; the model for a sensor that has none."""
    symbol = camera.sensor.scale_symbol
    if not symbol:
        return message("held_not_determinable.model", camera=camera.id, model=camera.model)
    value = camera.values[symbol] / camera.pixel_mm[0]
    return message("held_not_determinable.scale", camera=camera.id, symbol=symbol, value_px=value)


def _without_smallest(placed: Georeferenced) -> Relieved:
    """Without the image that has the fewest points."""
    images = placed.block.images
    rays = np.bincount(placed.block.observations.image, minlength=len(images))
    oriented = np.flatnonzero(images.oriented)
    if not len(oriented):
        return None
    k = int(oriented[rays[oriented].argmin()])
    return _left_out(placed, [images.ids[k]], phrase("excluded.few_points", n=int(rays[k])))


def _with_block(placed: Georeferenced, block: Block) -> Georeferenced:
    """With a block of fewer points; of those that are not given, none with a single ray."""
    o = block.observations
    rays = np.bincount(o.point, minlength=len(block.points))
    lone = (rays == 1) & ~np.asarray(block.points.is_control).any(axis=1)
    if lone.any():
        block = with_rows(block, ~lone[o.point])
    return replace(placed, block=block, marked=placed.marked[np.isin(placed.block.points.ids, block.points.ids)])


def adjusted_component(
    placed: Georeferenced, groups: Sequence[CameraGroup], jobs: int, progress: Progress, noise: NoiseModel = "auto", *,
    weights: Literal["given", "residuals"] = "given",
) -> ConnectedComponent:  # fmt: skip
    """The adjustment of a part that nothing joins to the others."""
    images = placed.block.images
    names = tuple(n for n, o in zip(images.ids, images.oriented, strict=True) if o)
    return ConnectedComponent(
        adjustment=final_adjustment(placed, groups, jobs, progress, (), noise, weights=weights), photographs=names
    )


def undetermined_component(placed: Georeferenced, error: NotSolvable) -> list[Notice]:
    """The photographs of a part that nothing determines, each left out by name."""
    images = placed.block.images
    names = [n for n, o in zip(images.ids, images.oriented, strict=True) if o]
    reason = Text.of(message("excluded.part", photographs=len(names)), as_detail(error))
    return [excluded_image(n, reason) for n in names]
