"""Stage: the tie points in object space, and the final adjustment of what is placed together and of parts apart."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import RejectMode
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role
from raybundle.block.relative import relative_control
from raybundle.calibration.several_cameras import several_cameras
from raybundle.errors import Message, NotSolvable, message, phrase
from raybundle.io.photos.cameras import CameraGroup
from raybundle.io.photos.photo import Photo
from raybundle.matching.features import FeatureMethod
from raybundle.matching.verify import VerifiedPair
from raybundle.pipeline.stage import Means, Stage
from raybundle.placing.georeference import Georeferenced
from raybundle.placing.marks import Given
from raybundle.placing.positions import GPS_M, flight_lines, without_idle
from raybundle.placing.recorded_positions import with_relative_precision
from raybundle.ties.explained_matches import pair_fits, unexplained_notice
from raybundle.ties.points import FeatureStore
from raybundle.ties.wrong_stations import with_probabilities
from raybundle.workflows.final_adjustment import adjusted_component, final_adjustment, left_out, undetermined_component
from raybundle.workflows.orienting.connected_components import (
    ConnectedComponent,
    apart_notice,
    component_folder,
    joined_notice,
    place_components,
)
from raybundle.workflows.orienting.cropped import cropped_notices
from raybundle.workflows.orienting.excluded_features import Dropped
from raybundle.workflows.orienting.options import OrientOptions
from raybundle.workflows.orienting.previous_names import Earlier, named_as_before
from raybundle.workflows.orienting.read_out import rolling_shutters, with_cause
from raybundle.workflows.orienting.same_camera import shared_sensors
from raybundle.workflows.orienting.state import ORIENT, OrientState, SceneState
from raybundle.workflows.scenes.placing import place_with_scenes
from raybundle.workflows.stage_arrays import Reasons
from raybundle.workflows.stage_memory import room_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the final adjustment depends on."""

    name: str
    """of the project"""
    options: OrientOptions
    given: Given
    photos: tuple[Photo, ...]
    blocks: tuple[Block, ...]
    groups: tuple[CameraGroup, ...]
    features: FeatureStore
    pairs: tuple[VerifiedPair, ...]
    method: FeatureMethod
    remarks: tuple[str, ...]
    notices: tuple[Notice, ...]
    dropped: Dropped | None
    scenes: SceneState | None
    earlier: Earlier | None
    reject: RejectMode


@dataclass(frozen=True, slots=True, kw_only=True)
class Adjusted:
    """What came of the photographs."""

    adjustment: Adjustment
    other_components: tuple[ConnectedComponent, ...]
    groups: tuple[CameraGroup, ...]
    placed: Georeferenced
    lost: Reasons
    """scenes that nothing places"""


def _inputs(state: OrientState) -> Inputs:
    return Inputs(
        name=state.asked.name, options=state.asked.options, given=state.given, photos=state.photos,
        blocks=state.blocks, groups=state.groups, features=state.found, pairs=state.pairs,
        method=state.method,
        remarks=(*state.remarks, *state.reported), notices=state.notices, dropped=state.dropped, scenes=state.scenes,
        earlier=state.asked.earlier, reject=state.asked.reject,
    )  # fmt: skip


def adjust(i: Inputs, means: Means) -> Adjusted:
    """Bring everything to object space, adjust it, and say what there is to say."""
    lost: Reasons = ()
    if i.scenes is None:
        placed, apart = place_components(i.blocks, i.photos, i.given)
    else:
        placed, apart, lost = place_with_scenes(i.scenes, i.options, i.blocks, i.photos, i.given, i.features, i.method)
    placed, *apart = (replace(p, block=replace(p.block, name=i.name)) for p in (placed, *apart))
    placed = replace(placed, block=named_as_before(placed.block, i.earlier, placed.marked))
    placed = _relative(placed, i.photos, i.options.relative)
    with room_of(means, max(len(p.block.observations) for p in (placed, *apart))) as room:
        done = _adjusted(i, placed, apart, means)
    every = (done.adjustment, *(p.adjustment for p in done.other_components))
    rows = sum(len(a.given.observations) for a in every)
    cropped = [n for a in every for n in cropped_notices(a)]
    xy, names = i.features.xy_px(), [p.name for p in i.photos]
    fits = [pair_fits(a.adjusted, names, xy, i.pairs) for a in every]
    reported = (
        *kept_joins(i.notices, {name for name, _ in left_out(done.adjustment, done.other_components)}),
        *cropped,
        *(n for a, f in zip(every, fits, strict=True) for n in unexplained_notice(a.adjusted, f)),
        *incomplete_notice(i, done),
        *([] if i.dropped is None else [i.dropped.notice(rows)]),
    )
    adjustment = replace(done.adjustment, notices=(*reported, *done.adjustment.notices, *room.notices()))
    adjustment = with_probabilities(adjustment, fits[0], ())
    parts = tuple(
        replace(p, adjustment=with_probabilities(p.adjustment, f, reported))
        for p, f in zip(done.other_components, fits[1:], strict=True)
    )
    return replace(done, adjustment=adjustment, other_components=parts, lost=lost)


def kept_joins(notices: Sequence[Notice], left: AbstractSet[str]) -> list[Notice]:
    """The notices; of wide baselines without the photographs that the adjustment left out again."""
    kept: list[Notice] = []
    for n in notices:
        ids = tuple(name for name in n.ids if name not in left)
        if n.code != "wide_baselines" or ids == n.ids:
            kept.append(n)
        elif ids:
            kept.append(replace(n, ids=ids, values={**n.values, "joined": len(ids)}))
    return kept


def _relative(placed: Georeferenced, photos: Sequence[Photo], kind: Literal["", "shift", "drift"]) -> Georeferenced:
    """Observed positions and attitudes as relative aerial control of the flight lines, where that is asked for."""
    if not kind or not len(placed.block.stations):
        return placed
    of_name = dict(zip([p.name for p in photos], flight_lines(photos).tolist(), strict=True))
    line = np.array([of_name.get(name, -1) for name in placed.block.images.ids], np.int32)
    known = np.asarray(placed.block.points.is_control.any(axis=0), bool)
    place = tuple(np.where(known, np.nan, GPS_M).tolist())
    block = without_idle(relative_control(placed.block, line, drift=kind == "drift", shift_sigma=place))
    lines = len(np.unique(line[block.stations.image]))
    left = len(placed.block.stations) - len(block.stations)
    details = list[Message]()
    if left:
        details.append(message("relative_control.excluded", n=left))
    if not known.all():
        axes = [a for a, k in zip("XYZ", known, strict=True) if not k]
        details.append(message("relative_control.open", axes=axes, plan_m=GPS_M[0], height_m=GPS_M[2]))
    values = {"photographs": len(block.stations), "lines": lines, "drift": kind == "drift"}
    notice = Notice(code="relative_control", values=values, details=tuple(details))
    return replace(placed, block=block, notices=(*placed.notices, notice))


def _adjusted(i: Inputs, placed: Georeferenced, apart: Sequence[Georeferenced], means: Means) -> Adjusted:
    """The final adjustments of what is placed together and of the parts that nothing joins to it, and the cameras.

    Photographs that turn out to be of one sensor, stored differently, are adjusted once more as of one camera.
    """
    groups, noise = i.groups, i.options.noise
    weights: Literal["given", "residuals"] = "residuals" if i.options.precise else "given"
    final = partial(
        final_adjustment, jobs=means.jobs, progress=means.progress, remarks=i.remarks, noise=noise, weights=weights,
        reject=i.reject,
    )  # fmt: skip
    parts, kept, lost = list[ConnectedComponent](), list[Georeferenced](), list[Notice]()
    for part in apart:
        try:
            parts.append(adjusted_component(part, groups, means.jobs, means.progress, noise, weights=weights))
            kept.append(part)
        except NotSolvable as error:
            lost += undetermined_component(part, error)
    first = replace(placed, notices=(*lost, *placed.notices))
    adjustment = final(first, groups)
    largest = largest_component(adjustment, parts)
    if largest is not None and not first.fixed:  # adjustments leave photographs out
        names = tuple(
            n for n, o in zip(adjustment.given.images.ids, adjustment.given.images.oriented, strict=True) if o
        )
        parts[largest] = ConnectedComponent(adjustment=adjustment, photographs=names)
        first, kept[largest] = replace(kept[largest], notices=(*lost, *kept[largest].notices)), first
        placed = first
        adjustment = final(first, groups)
    shared = shared_sensors(adjustment, groups, i.photos)
    if shared:
        groups = shared.grouped(groups)
        first = replace(first, block=shared.applied(first.block))
        adjustment = final(first, groups)
    several = several_cameras(adjustment)
    moving = rolling_shutters(adjustment, first.block, i.photos, i.options.read_out_s)
    if moving.block is not None:
        first = replace(first, block=moving.block)
        adjustment = final(first, groups)
    weighted = with_target_weights(first.block, adjustment, i.given)
    if weighted is not None:
        first = replace(first, block=weighted)
        adjustment = final(first, groups)
    adjustment = with_relative_precision(with_cause(adjustment, i.photos))
    notices = (
        *joined_notice(first.joined, adjustment.given),
        *shared.notices,
        *(several.notices if several else ()),
        *moving.notices,
        *_relief_notice(i, adjustment),
    )
    if kept:  # of what is left in the end: the adjustments leave photographs out
        left = [replace(k, block=p.adjustment.given) for k, p in zip(kept, parts, strict=True)]
        notices = (apart_notice(adjustment.given, left, [component_folder(k) for k in range(len(kept))]), *notices)
    return Adjusted(
        adjustment=replace(adjustment, notices=(*notices, *adjustment.notices)), other_components=tuple(parts),
        groups=groups, placed=placed, lost=(),
    )  # fmt: skip


def _relief_notice(i: Inputs, adjustment: Adjustment) -> tuple[Notice, ...]:
    """That the relief of the object about tie points is in no standard deviation where no windows were matched."""
    points = adjustment.given.points
    if i.options.precise or points.window is not None or not (np.asarray(points.role) == Role.TIE).any():
        return ()
    return (Notice(code="relief_unknown.quick"),)


MOST = 0.5
"""Share of the photographs that are oriented below which a result is none of them: a test of a set, not of its figures.

What is oriented by chance, or is another object, is found among the few."""


def incomplete_notice(i: Inputs, done: Adjusted) -> tuple[Notice, ...]:
    """The fault of a result, with its parts, that holds less than half of the photographs."""
    if i.scenes is not None or not i.photos:
        return ()
    blocks = [done.adjustment.given, *(p.adjustment.given for p in done.other_components)]
    oriented, whole = sum(int(b.images.oriented.sum()) for b in blocks), len(i.photos)
    if oriented >= MOST * whole:
        return ()
    values = {"oriented": oriented, "photographs": whole, "limit": MOST}
    return (Notice(code="incomplete", values=values),)


def largest_component(main: Adjustment, parts: Sequence[ConnectedComponent]) -> int | None:
    """Number of the part that has more photographs than the main result, or as many and more points; None: no part."""

    def size(a: Adjustment) -> tuple[int, int]:
        return int(a.given.images.oriented.sum()), len(np.unique(a.given.observations.point))

    sizes = [size(p.adjustment) for p in parts]
    best = max(range(len(sizes)), key=lambda k: sizes[k], default=None)
    return None if best is None or sizes[best] <= size(main) else best


def with_target_weights(block: Block, result: Adjustment, given: Given) -> Block | None:
    """The block with standard deviations of the targets as their residuals show them beside those of all; None: as is.

    What grey values show of a target's centre is not what photographs hold of it: with its own weight it would bend
    tie points, or be rejected.  From residuals as the weights of tie points are, for all targets together.
    """
    names = {
        c.ids[int(k)] for c in given.control
        for k in np.unique(c.measurements.point[np.isfinite(c.measurements.covariances).all(axis=1)])
    }  # fmt: skip
    if not names or result.redundancy <= 0 or not result.options.statistics:
        return None
    mine = np.isin(np.array(result.given.points.ids), sorted(names))
    o, s = result.given.observations, result.image_observations
    rows = mine[o.point] & s.used
    v = s.residuals_px[rows] / np.sqrt(o.cov_px2[rows, :2])
    r = float(np.nansum(s.redundancy[rows]))
    if r < LEAST_REDUNDANCY:
        return None
    ratio = float(np.nansum(v**2)) / r / result.sigma0**2
    if abs(ratio - 1) < np.sqrt(2 / r) * 3:  # as precise as all others, by what so many show
        return None
    own = np.isin(np.array(block.points.ids), sorted(names))[block.observations.point]
    cov = np.where(own[:, None], ratio, 1.0) * block.observations.cov_px2
    return replace(block, observations=replace(block.observations, cov_px2=cov))


LEAST_REDUNDANCY = 20.0
"""Redundancy of the targets from which on their residuals show a standard deviation, to a sixth."""


def _put(state: OrientState, done: Adjusted) -> OrientState:
    scenes = state.scenes
    if scenes is not None and done.lost:
        scenes = replace(scenes, lost=done.lost)
    return replace(
        state,
        adjustment=done.adjustment,
        other_components=done.other_components,
        groups=done.groups,
        placed=done.placed,
        scenes=scenes,
    )


def _outcome(state: OrientState) -> str:
    assert state.adjustment is not None
    return phrase("stage_summary.adjustment", sigma0=state.adjustment.sigma0)


STAGE = ORIENT.register(
    Stage(name="adjustment", after=("scene_precision",), inputs=_inputs, function=adjust, put=_put, reported=_outcome)
)
