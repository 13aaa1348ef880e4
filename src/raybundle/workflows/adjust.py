"""Adjust any block: approximate values where they are missing, then the adjustment with its decisions."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.blunders.identical_control import identical_notices
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.decision.variance_groups import by_groups
from raybundle.adjustment.evaluation.check_points import with_check_notice
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.evaluation.residual_structure import shared_errors_notice, structure_notice
from raybundle.adjustment.noise_sample import sample_under_noise
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import FEWEST_IMAGES, AdjustmentOptions
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system import defects
from raybundle.adjustment.system.input_checks import check_entry
from raybundle.adjustment.system.scene_start import refuse_unoriented, with_scene_points
from raybundle.block import Block, Role
from raybundle.block.points import automatic
from raybundle.block.rejection import RejectionKind, known_wrong
from raybundle.block.rigs import with_shared_orientation
from raybundle.calibration.previous_calibration import calibration_notices, held_notices
from raybundle.errors import (
    DatumDefect,
    InputError,
    Message,
    NoConvergence,
    NoOrientation,
    NotSolvable,
    RankDefect,
    Value,
    as_detail,
    message,
)
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, in_rounds, silent
from raybundle.observations import observation_kinds
from raybundle.orientation.known_points import intersected_where_better, without_given_ties
from raybundle.placing.approximate_scale import start_scale_notices
from raybundle.placing.conflicts import Conflict, conflict_message, conflict_notice, conflicts
from raybundle.placing.control_blunders import as_ties, doubt_message, doubted_control, notice
from raybundle.placing.image_blunders import image_doubt_notices, origin_message, unit_message
from raybundle.placing.mirrored_images import mirrored_image_notices
from raybundle.placing.scale_bar_blunders import BarDoubt, bar_doubt_notice, doubted_bars

LOOKED_AT = 500_000
"""Image observations up to which residuals are looked at for structure, and held calibrations are tested, without being
asked: three seconds, and as long again as the adjustment."""
FEW_BEHIND = 0.005
"""Share of the image points behind cameras up to which wrong names or matches explain them."""
DOUBTED = 10.0
"""sigma0 from which on the approximate values are doubted."""
OF_CONTROL = {
    *(f"{kind}_suspect" for kind in observation_kinds), "camera_constant_unknown", "group_less_precise",
    "not_determinable", "pixel_shape", "snooping_masked", "systematic_residuals",
}  # fmt: skip
"""Notices that wrong control raises of all else: without it everything else fits"""
OF_BARS = {"distance_suspect", "distance_lost", "behind_camera"}
"""Codes of notices that a wrong scale bar may be behind."""


def adjust(block: Block, options: AdjustmentOptions | None = None, progress: Progress = silent) -> Adjustment:
    """Adjust a block, from nothing but observations and control if need be.

    Returns the adjusted block with precision, reliability and everything a report needs; raises InputError
    (bad input) or NotSolvable (no orientation found, datum or rank defect, no convergence).
    """
    began = time.perf_counter()
    progress = in_rounds(progress)
    options = AdjustmentOptions() if options is None else options
    check_entry(block, options)
    options = _as_before(block, options)
    wrong = known_wrong(block)
    defects.check_rays(block, wrong)
    twins = identical_images(block)
    identical = identical_notices(block)
    bars: BarDoubt | None = None
    try:
        result = _adjusted(block, options, progress)
        if result.sigma0 > POOR_FIT or OF_BARS & {n.code for n in result.notices}:
            bars = _doubted_bars(block, options)
    except NotSolvable as error:
        bars = None if isinstance(error, DatumDefect) else _doubted_bars(block, options)
        result = _without(bars, options, progress)
        if result is None:
            cause = _explained(error, block, options, twins, identical)
            if cause is None:
                raise
            raise error.worded(cause) from error  # in no variable: its traceback would keep it, and all it was made of
    else:
        result = _without(bars, options, progress) or result
    if twins and not result.converged:
        raise NoConvergence("adjustment.identical_images", pairs=len(twins), details=_pairs(twins))
    if twins:
        result = replace(result, notices=(_twin_notice(twins), *result.notices))
    doubt = None
    found = _conflicts(block, options) if result.sigma0 > POOR_FIT and not identical else []
    if any(c.unit or (c.other_unit and len(found) > 1) for c in found):
        identical = (*identical, conflict_notice(found, result.sigma0))
    if result.sigma0 > POOR_FIT and block.points.is_control.any() and not identical and not _held(block):
        doubt = doubted_control(block, result, options, _plainly)
    plain = (*identical, *([] if doubt is None else [notice(doubt, result.sigma0)]))
    if plain:
        # a large error has bent all others to it: what tests of single values say then is no measure
        bent = {"control_suspect"} if result.sigma0 > POOR_FIT else set[str]()
        # it is the control that contradicts them, and that is stated
        bent |= set() if doubt is None else {"image_contradicts", "control_not_located"}
        bent |= OF_CONTROL if doubt is not None and doubt.is_explained else set()
        others = [n for n in result.notices if n.code not in bent]
        result = replace(result, notices=(*plain, *others))
    if not plain and bars is None and not _held(block) and (torn := _torn(block, result, options)) is not None:
        images = image_doubt_notices(block, torn, _solver(options))
        # parameters that take up errors of images are not what is wrong
        bent = (
            {"not_determinable", "systematic_residuals", "pixel_shape", "image_contradicts"} if images else set[str]()
        )
        result = replace(result, notices=(*images, *(n for n in result.notices if n.code not in bent)))
    if bars is not None:
        others = [n for n in result.notices if bars.rest is not None or n.code not in OF_BARS]
        result = replace(result, notices=(bar_doubt_notice(bars, block.length_unit), *others))
    elif not plain and (scale := start_scale_notices(block, result)):
        others = [n for n in result.notices if n.code != "approximate_values_replaced"]
        result = replace(result, notices=(*scale, *others))
    if not plain and not _held(block) and (mirrored := mirrored_image_notices(block, result.adjusted)):
        others = [n for n in result.notices if n.code != "approximate_values_replaced"]
        result = replace(result, notices=(*mirrored, *others))
    held = () if plain else _held_calibrations(result, options)
    first = (*calibration_notices(result), *held, *_given_rejected(wrong))
    result = replace(result, notices=(*first, *result.notices, *_structure(result, options)))
    given = result.given if options.variance_groups or (bars is not None and bars.rest is not None) else block
    return with_check_notice(replace(result, given=given, seconds=time.perf_counter() - began))


def _explained(
    error: NotSolvable, block: Block, options: AdjustmentOptions, twins: list[tuple[str, str]],
    identical: Sequence[Notice],
) -> Message | None:  # fmt: skip
    """An error with what may be behind it; None where there is nothing to add."""
    why: list[Message] = [n.data for n in ([_twin_notice(twins)] if twins else identical)]
    if not why and not isinstance(error, DatumDefect):
        if (unit := unit_message(block)) is not None:
            return _joined(unit, error)
        if (origin := origin_message(block)) is not None:
            return _joined(origin[0], error)
    found = [] if why or isinstance(error, DatumDefect) else _conflicts(block, options)
    if found:
        return conflict_message(found, float("nan"))
    if not why and isinstance(error, RankDefect) and (torn := _of_control(block, options)) is not None:
        return _joined(torn, error)
    if not why and isinstance(error, NoConvergence):
        why += filter(None, [_of_control(block, options)])
    return _joined(error, *why) if why else None


def _joined(first: Message | NotSolvable, *others: Message | NotSolvable) -> Message:
    """The first message with the others as its details."""
    head, *rest = (as_detail(p) if isinstance(p, NotSolvable) else p for p in (first, *others))
    return replace(head, details=(*head.details, *rest))


def _without(bars: BarDoubt | None, options: AdjustmentOptions, progress: Progress) -> Adjustment | None:
    """The adjustment without bars that are wrong; None where none are."""
    return None if bars is None or bars.rest is None else _adjusted(bars.rest, options, progress)


def _as_before(block: Block, options: AdjustmentOptions) -> AdjustmentOptions:
    """The options, with what the block states of its adjustment before where nothing else is asked for."""
    noise = block.noise if options.noise == "auto" and block.noise else options.noise
    return replace(options, noise=noise, datum_over=options.datum_over or block.datum_over or "all")


def _given_rejected(wrong: Mask) -> tuple[Notice, ...]:
    """What there is to say of image observations that the block gives as rejected."""
    n = int(wrong.sum())
    if not n:
        return ()
    return (Notice(code="given_rejected", values={"n": n}, measured=Severity.NOTE),)


def _held_calibrations(result: Adjustment, options: AdjustmentOptions) -> tuple[Notice, ...]:
    """Where the images contradict an interior orientation that the block gives to be held, as `orient` tests it."""
    if not options.statistics or len(result.given.observations) > LOOKED_AT:
        return ()
    return held_notices(result, [c.id for c in result.given.cameras if c.scene is None and c.estimate == ()])


def _structure(result: Adjustment, options: AdjustmentOptions) -> tuple[Notice, ...]:
    """Whether image points share errors, which white noise does not know: stated wherever nobody asked for white noise.

    What was published stays comparable, so that blocks that are given are adjusted with white noise unless asked;
    `orient`, `calibrate` and `measure` carry shared errors into standard deviations.
    """
    if not options.statistics or not result.sigma0 <= POOR_FIT:  # a fault of its own, which bends all residuals
        return ()
    if options.noise != "auto":
        return ()
    more = message("residual_structure.with_fields")
    if len(result.given.observations) > LOOKED_AT:
        found = sample_under_noise(result)
        shared = None if found is None else shared_errors_notice(found, found.noise)
        if found is None or shared is None:
            return ()
        seen = message("residual_structure.sample", images=len(found.given.images))
        return (replace(shared, details=(*shared.details, seen, more)),)
    if len(np.unique(result.given.observations.image[result.image_observations.used])) >= FEWEST_IMAGES:
        shared = shared_errors_notice(result, under_noise(result).noise)
        return () if shared is None else (replace(shared, details=(*shared.details, more)),)
    points = result.given.points.ids
    if 2 * automatic(points).sum() < len(points) or (found := structure_notice(result)) is None:
        return ()
    return (replace(found, details=(*found.details, more)),)


MANY = 0.05
"""Share of image observations that are rejected from which on images, not their points, may be what is wrong"""


def _torn(block: Block, result: Adjustment, options: AdjustmentOptions) -> Adjustment | None:
    """The adjustment whose images do not fit each other: with what data snooping rejected; None where they fit."""
    if result.sigma0 > POOR_FIT:
        return result
    blunders = sum(r is not None and r.kind is RejectionKind.BLUNDER for r in result.image_observations.rejected)
    if blunders <= MANY * len(result.given.observations):
        return None
    whole = _solver(options)(block)
    return whole if whole is not None and whole.sigma0 > POOR_FIT else None


def _plainly(block: Block, options: AdjustmentOptions) -> Adjustment:
    return _adjust(block, options, silent)


def _of_control(block: Block, options: AdjustmentOptions) -> Message | None:
    """What control has to do with it that nothing can be adjusted."""
    if not block.points.is_control.any() or _held(block):
        return None
    doubt = doubted_control(block, None, options, _plainly)
    return None if doubt is None else doubt_message(doubt, float("nan"))


def _solver(options: AdjustmentOptions) -> Callable[[Block], Adjustment | None]:
    """Adjusts a block with what was given alone and without statistics; None where there is no solution."""
    brief = replace(options, statistics=False, reject="none", estimate="given", datum="auto", noise="white")

    def solved(rest: Block) -> Adjustment | None:
        return _tried(rest, brief)

    return solved


def _tried(block: Block, options: AdjustmentOptions) -> Adjustment | None:
    """The adjustment; None where there is none."""
    try:
        defects.check_rays(block, known_wrong(block))
        return _plainly(block, options)
    except (InputError, NotSolvable):
        return None


def _doubted_bars(block: Block, options: AdjustmentOptions) -> BarDoubt | None:
    """Scale bars that contradict the others, or the control."""
    return None if _held(block) or not len(block.distances) else doubted_bars(block, _solver(options))


def _conflicts(block: Block, options: AdjustmentOptions) -> list[Conflict]:
    """Groups of given values that contradict others; empty where it is control alone, which has tests of its own."""
    if _held(block) or not (len(block.distances) or len(block.stations.image)):
        return []
    control = np.flatnonzero(block.points.is_control.any(axis=1))
    found = conflicts(block, _solver(options), as_ties(block, control) if len(control) else block)
    return found if any(c.group != "control" for c in found) else []


def _adjusted(block: Block, options: AdjustmentOptions, progress: Progress) -> Adjustment:
    """The adjustment with one variance factor, or with those of groups of observations."""
    if not options.variance_groups:
        return _adjust(block, options, progress)
    return by_groups(block, options, lambda b, o: _adjust(b, o, progress))


def _adjust(block: Block, options: AdjustmentOptions, progress: Progress) -> Adjustment:
    block = with_shared_orientation(with_scene_points(block))
    observed = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    own = bool(block.images.oriented[observed].any() or _given_ties(block).any())
    afresh = own and _held(block) == 0
    try:
        result = _from_given(block, observed, options, progress)
    except (NoOrientation, NoConvergence, RankDefect) as error:
        fresh = _afresh(block, options, progress) if afresh else None
        if fresh is None or fresh.sigma0 > DOUBTED:
            raise
        return _replaced(fresh, "approximate_values_replaced.unsolvable", details=(as_detail(error),))
    if result.sigma0 > DOUBTED and afresh:
        fresh = _afresh(block, options, progress)
        if fresh is not None and fresh.sigma0 < 0.5 * result.sigma0:
            return _replaced(fresh, "approximate_values_replaced.poor", given_sigma0=result.sigma0)
    elif afresh and (lost := _behind(result)) > FEW_BEHIND * len(block.observations):
        # a minimum of its own, in which cameras look away from what they see
        fresh = _afresh(block, options, progress)
        if fresh is not None and fresh.sigma0 < max(DOUBTED, 2 * result.sigma0) and _behind(fresh) < 0.5 * lost:
            return _replaced(fresh, "approximate_values_replaced.behind", n=lost)
    return result


def _behind(result: Adjustment) -> int:
    """Image observations whose points ended behind their cameras."""
    kinds = (r.kind for r in result.image_observations.rejected if r is not None)
    return sum(kind is RejectionKind.BEHIND_CAMERA for kind in kinds)


def _from_given(block: Block, observed: Mask, options: AdjustmentOptions, progress: Progress) -> Adjustment:
    """The adjustment from the approximate values that were given, those that are missing or far off found."""
    notices = list[Notice]()
    given = intersected_where_better(block)
    start = given.block
    if len(given.gross):
        names = tuple(block.points.ids[k] for k in given.gross)
        notices.append(
            Notice(
                code="approximate_values_replaced.points",
                values={"n": len(names)},
                ids=names[:100],
                measured=Severity.NOTE,
            )
        )
    seen = np.bincount(block.observations.point, minlength=len(block.points)) > 0
    if (observed & ~block.images.oriented).any() or (seen & ~np.isfinite(block.points.xyz).all(axis=1)).any():
        from raybundle.orientation.approximate import approximate_values

        refuse_unoriented(block)
        approximate = approximate_values(_with_known(start), progress)
        start = approximate.block
        notices += approximate.notices
    return decide(start, options, progress, notices=tuple(notices))


def _given_ties(block: Block) -> Mask:
    """(p,) tie points that were given coordinates."""
    free = ~np.asarray(block.points.is_control).any(axis=1)
    return free & (np.asarray(block.points.role) == Role.TIE) & np.isfinite(block.points.xyz).all(axis=1)


def _with_known(block: Block) -> Block:
    """The block whose cameras keep what was given of them while approximate values move it; 0 is no camera constant."""
    cameras = tuple(
        replace(c, known={s: v for s, v in c.values.items() if v or s != c.sensor.symbols[0]}) for c in block.cameras
    )
    return replace(block, cameras=cameras)


def identical_images(block: Block) -> list[tuple[str, str]]:
    """Pairs of images of which nearly all image points coincide within half a pixel: the same photo twice."""
    o = block.observations
    if len(block.images) < 2 or not len(o):
        return []
    code = _codes(o.point, o.xy_px)
    order = np.lexsort((o.image, code))
    same = code[order[1:]] == code[order[:-1]]
    first, second = o.image[order[:-1]][same], o.image[order[1:]][same]
    pairs, count = np.unique(np.stack([first, second], axis=1), axis=0, return_counts=True)
    rays = np.bincount(o.image, minlength=len(block.images))
    found = [
        (int(a), int(b)) for (a, b), k in zip(pairs, count, strict=True) if k > 0.6 * min(rays[a], rays[b]) and k > 3
    ]
    return [(block.images.ids[a], block.images.ids[b]) for a, b in found]


def _codes(point: Index, xy_px: Array) -> Index:
    """(m,) one number for each object point and half pixel."""
    low, high = np.floor(xy_px.min(axis=0) * 2), np.ceil(xy_px.max(axis=0) * 2)
    wide, tall = (int(v) + 1 for v in (high - low).tolist())
    code = point.astype(np.int64)
    if (int(point.max(initial=0)) + 1) * wide * tall < 2**62:
        for axis, size in enumerate((wide, tall)):
            code *= size
            code += (np.round(xy_px[:, axis] * 2) - low[axis]).astype(np.int64)
        return code
    cells = np.column_stack([code, np.round(xy_px * 2).astype(np.int64)])  # coordinates that are no pixels
    return np.unique(cells, axis=0, return_inverse=True)[1].ravel()


def _twin_notice(twins: Sequence[tuple[str, str]]) -> Notice:
    ids = tuple(i for pair in twins for i in pair)
    return Notice(code="identical_images", values={"pairs": len(twins)}, ids=ids, details=_pairs(twins))


def _pairs(twins: Sequence[tuple[str, str]]) -> tuple[Message, ...]:
    return tuple(message("control_identical.pair", first=a, second=b) for a, b in twins[:5])


def _held(block: Block) -> int:
    return 0 if block.images.held is None else int(block.images.held.sum())


def _afresh(block: Block, options: AdjustmentOptions, progress: Progress) -> Adjustment | None:
    """The adjustment from orientations and tie points of our own; None where there is none.

    Rough approximate values can lead into a minimum that is not the lowest one, or nowhere.
    """
    from raybundle.orientation.approximate import approximate_values

    images = block.images
    blank = replace(
        without_given_ties(_with_known(block)),
        images=replace(
            images, centre=np.full_like(images.centre, np.nan), rotation=np.full_like(images.rotation, np.nan)
        ),
    )
    try:
        refuse_unoriented(blank)
        approximate = approximate_values(blank, progress)
        return decide(approximate.block, options, progress, notices=approximate.notices)
    except (InputError, NotSolvable):
        return None


def _replaced(fresh: Adjustment, code: str, details: tuple[Message, ...] = (), **values: Value) -> Adjustment:
    """The result from approximate values of our own, with a notice."""
    notice = Notice(code=code, values={**values, "sigma0": fresh.sigma0}, details=details)
    return replace(fresh, notices=(notice, *fresh.notices))
