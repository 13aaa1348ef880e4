"""Stage: the free network of targets, its model, cameras, circle centres and parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.blunders.pixel_shape import under_its_noise
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.records.notice import Notice, notice_of_text
from raybundle.adjustment.records.options import AdjustmentOptions, noise_of_photographs
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.block.boards import spline_camera
from raybundle.block.select import with_rows
from raybundle.calibration.eccentricity import RadiusScale, eccentricity_px, radius_scale, target_normals
from raybundle.errors import InputError, NotSolvable, phrase
from raybundle.io.photos.cameras import CameraGroup
from raybundle.io.photos.photo import Found
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress
from raybundle.pipeline.stage import Means, Stage
from raybundle.placing.recorded_positions import camera_notices
from raybundle.targets.marks import Marks, Target
from raybundle.workflows.calibrating.camera_split import cameras_apart
from raybundle.workflows.calibrating.defects import check_spline, explained
from raybundle.workflows.calibrating.model_choice import choose_models
from raybundle.workflows.calibrating.options import CalibrateOptions
from raybundle.workflows.calibrating.stages.start import with_asked_model
from raybundle.workflows.calibrating.state import CALIBRATE, Adjusted, CalibrateState, Start
from raybundle.workflows.calibrating.target_block import (
    FEWEST_TARGETS,
    completed,
    oriented_part,
    reweighted,
    target_radii,
    with_coordinates,
    with_dots,
    with_values,
)
from raybundle.workflows.final_adjustment import independent_notices
from raybundle.workflows.orienting.same_camera import shared_sensors

SETTLED_PX = 0.003
"""Change of a circle centre's correction below which it is not repeated."""
STRANGE = 0.25
"""Share of a photograph's points that are rejected, from which on it does not belong to the others."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the adjustment depends on."""

    start: Start
    found: Found
    groups: tuple[CameraGroup, ...]
    marks: tuple[tuple[Marks, ...], ...]
    targets: tuple[Target, ...]
    options: CalibrateOptions


def _inputs(state: CalibrateState) -> Inputs:
    assert state.found is not None
    return Inputs(
        start=state.begun, found=state.found, groups=state.groups, marks=state.marks, targets=state.targets,
        options=state.options,
    )  # fmt: skip


def adjust(i: Inputs, means: Means) -> Adjusted:
    """Adjust, complete, distinguish cameras, choose models, correct centres; raises NotSolvable with the reason."""
    try:
        return _adjusted(i, means)
    except (InputError, NotSolvable) as error:
        raise explained(error, i.start.given.block) from error


def _adjusted(i: Inputs, means: Means) -> Adjusted:
    options, progress = i.options, means.progress
    notices = (*i.start.notices, *_remarks(i.found, i.groups))
    settings = AdjustmentOptions(
        jobs=means.jobs, reject="snooping", robust_start=True, noise="white",
        pixel_shape="any" if options.shear else "sensor", weights="residuals",
    )  # fmt: skip
    n = _completed(i, settings, progress)
    start, first, split, groups = _distinguished(n.start, n.first, i, settings, progress)
    notices, rows, lost = (*notices, *split), n.rows, dict(i.start.lost)
    strange = _strange(first)
    if strange:
        lost = {**lost, **{first.given.images.ids[k]: why for k, why in strange.items()}}
        start, rows = _without_images(start, rows, tuple(strange))
        first = decide(start, settings, progress)
        start = reweighted(with_values(start, first.adjusted), first.sigma0)
    if options.model in {"auto", "spline"} and not options.estimate:
        start, chosen = choose_models(start, first, settings)
        notices = (*notices, *chosen)
    if options.model == "spline":  # its surfaces take up what the best of the others leaves
        start = replace(start, cameras=tuple(spline_camera(c) for c in start.cameras))
    result, largest, scale = _adjust(start, first, n.radius[rows], options, settings, notices, progress)
    if options.model == "spline":
        check_spline(first, result)
    return Adjusted(
        adjustment=_under_noise(result, options), groups=groups, lost=tuple(_lost(lost, i.start.given.not_used)),
        completed=n.added, dots=n.linked, largest_eccentricity_px=largest, radius=scale,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class _Network:
    """A first adjustment, and the points that it found."""

    start: Block
    rows: Index
    """of the start's observations in `radius`"""
    radius: Array
    first: Adjustment
    added: int
    linked: int


def _completed(i: Inputs, settings: AdjustmentOptions, progress: Progress) -> _Network:
    """Adjusted once, dots that could not be read found where they must be, and with these adjusted again."""
    start, rows = oriented_part(i.start.approximate)
    start = with_asked_model(start, i.options.model)
    first = decide(start, settings, progress)
    given = i.start.given
    block, radius, added = completed(given.block, given.radius_px, first.adjusted, i.targets, i.marks)
    linked = 0
    if i.options.dots:
        block, radius, linked = with_dots(block, radius, first.adjusted, i.marks)
    if added or linked:
        start, rows = oriented_part(with_coordinates(with_values(block, first.adjusted)))
        first = decide(start, settings, progress)
    start = reweighted(with_values(start, first.adjusted), first.sigma0)
    return _Network(start=start, rows=rows, radius=radius, first=first, added=added, linked=linked)


def _distinguished(
    start: Block, first: Adjustment, i: Inputs, settings: AdjustmentOptions, progress: Progress
) -> tuple[Block, Adjustment, tuple[Notice, ...], tuple[CameraGroup, ...]]:
    """Photographs of two cameras distinguished, those of one sensor that are stored differently joined."""
    notices: tuple[Notice, ...] = ()
    groups = i.groups
    if i.options.split:
        start, first, notices = cameras_apart(start, first, settings, progress)
    shared = shared_sensors(first, groups, i.found.photos, reduced=False)  # of reduced ones target sizes differ
    if shared:
        start, groups = shared.applied(start), shared.grouped(groups)
        first = decide(start, settings, progress)
        start = reweighted(with_values(start, first.adjusted), first.sigma0)
    return start, first, (*notices, *shared.notices), groups


def _under_noise(result: Adjustment, options: CalibrateOptions) -> Adjustment:
    """The result under the noise model that was asked for."""
    images = len(np.unique(result.given.observations.image))
    chosen = noise_of_photographs(options.noise, images)
    if chosen == "fields":
        result = under_its_noise(under_noise(result))
    few = independent_notices(options.noise, chosen, images)
    return replace(result, notices=(*few, *result.notices))


def _strange(result: Adjustment) -> dict[int, str]:
    """Photographs of which so many points are rejected that they cannot be of this camera and object, and why."""
    o = result.given.observations
    count = np.bincount(o.image, minlength=len(result.given.images))
    out = np.bincount(o.image[~result.image_observations.used], minlength=len(count))
    found = np.flatnonzero((out > STRANGE * count) & (out >= FEWEST_TARGETS))
    if len(found) > np.count_nonzero(count) / 3:  # then it is the others, or the model
        return {}
    return {int(i): phrase("not_oriented.contradicting_share", n=int(out[i]), points=int(count[i])) for i in found}


def _without_images(block: Block, rows: Index, images: tuple[int, ...]) -> tuple[Block, Index]:
    """The block without the observations of some images, and its rows (k,) of those."""
    keep: Mask = ~np.isin(block.observations.image, images)
    centre, rotation = block.images.centre.copy(), block.images.rotation.copy()
    centre[list(images)], rotation[list(images)] = np.nan, np.nan
    without = replace(block, images=replace(block.images, centre=centre, rotation=rotation))
    part, own = oriented_part(with_rows(without, keep))
    return part, rows[np.flatnonzero(keep)[own]]


def _lost(lost: dict[str, str], before: Sequence[tuple[str, str]]) -> list[tuple[str, str]]:
    known = {name for name, _ in before}
    return [(name, why) for name, why in lost.items() if name not in known]


def _remarks(found: Found, groups: Sequence[CameraGroup]) -> list[Notice]:
    return [*(notice_of_text("photographs", r) for r in found.remarks), *camera_notices(groups)]


def _adjust(
    start: Block,
    first: Adjustment,
    radius_px: Array,
    options: CalibrateOptions,
    settings: AdjustmentOptions,
    notices: Sequence[Notice],
    progress: Progress,
) -> tuple[Adjustment, float, RadiusScale | None]:
    """The free network, ellipse centres corrected with the orientations of the adjustment before.

    Radii are those that the images show; where the eccentricities show them better, they are estimated.
    """
    shift = _eccentricity(start, first, radius_px, options)
    result = decide(_moved(start, shift), settings, progress, notices=tuple(notices))
    if start is not (clean := _without_leftovers(start, result)):
        start = clean
        result = decide(_moved(start, shift), settings, progress, notices=tuple(notices))
    again = _eccentricity(start, result, radius_px, options)
    used = result.image_observations.used
    if np.abs(again - shift)[used].max(initial=0.0) > SETTLED_PX:
        shift = again
        here = reweighted(_moved(with_values(start, result.adjusted), shift), result.sigma0)
        result = decide(here, settings, progress, notices=tuple(notices))
    scale = radius_scale(result, shift)
    if scale is not None and scale.significant:
        shift = shift * scale.value**2
        values = {"ratio": scale.value, "sigma": scale.std}
        notices = (*notices, Notice(code="target_radius", values=values))
        here = reweighted(_moved(with_values(start, result.adjusted), shift), result.sigma0)
        result = decide(here, settings, progress, notices=tuple(notices))
    return result, float(np.linalg.norm(shift[used], axis=1).max(initial=0.0)), scale


def _without_leftovers(start: Block, result: Adjustment) -> Block:
    """The block with distortion that was held in the end at zero, not where an adjustment before had left it."""
    cameras: list[Camera] = []
    for camera in start.cameras:
        free = next((i.free for i in result.interior if i.camera == camera.id), ())
        left = [
            p.symbol
            for p in camera.sensor.parameters
            if p.kind in {"radial", "decentring", "affinity", "harmonic"} and p.symbol not in free
            and camera.values.get(p.symbol, 0.0) != 0
        ]  # fmt: skip
        auto = camera.estimate == "auto"
        cameras.append(
            replace(camera, values={**camera.values, **dict.fromkeys(left, 0.0)}) if left and auto else camera
        )
    return (
        start
        if all(a is b for a, b in zip(cameras, start.cameras, strict=True))
        else replace(start, cameras=tuple(cameras))
    )


def _eccentricity(start: Block, at: Adjustment, radius_px: Array, options: CalibrateOptions) -> Array:
    """Offsets (m, 2) [px] of the centres of ellipses, with the orientations of an adjustment."""
    if not options.eccentricity or not np.isfinite(radius_px).any():
        return np.zeros_like(start.observations.xy_px)
    here = at.adjusted
    normal = target_normals(here.points.xyz)
    radius = target_radii(here, radius_px, normal, at.image_observations.used)
    return eccentricity_px(replace(here, observations=start.observations), radius, normal)


def _moved(block: Block, shift: Array) -> Block:
    return replace(block, observations=replace(block.observations, xy_px=block.observations.xy_px - shift))


STAGE = CALIBRATE.register(
    Stage(
        name="adjustment",
        after=("start",),
        inputs=_inputs,
        function=adjust,
        put=lambda s, p: replace(s, adjusted=p, groups=p.groups),
        reported=lambda s: "" if s.adjusted is None else f"sigma0 {s.adjusted.adjustment.sigma0:.3f}",
        when=lambda s: bool(s.targets),
    )
)
