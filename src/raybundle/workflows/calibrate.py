"""Calibration of cameras from photographs of targets or boards: free network, circle centres, model, one camera or two.

The steps: targets are measured; a board, or pairs of photographs, give the start; dots whose code could not be read are
found where they must be; photographs of two cameras are told apart; the distortion model is chosen; the centres of
ellipses are corrected; parameters are chosen by significance and determinability, blunders rejected.
"""

from __future__ import annotations

import os
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from raybundle.adjustment.calibration_quality import CalibrationQuality, calibration_qualities
from raybundle.adjustment.decide import decide
from raybundle.adjustment.eccentricity import RadiusScale, eccentricity_px, radius_scale
from raybundle.adjustment.options import AdjustmentOptions, NoiseModel, noise_of_photographs
from raybundle.adjustment.pixel_shape import under_its_noise
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.under_noise import under_noise
from raybundle.block import Block, Camera, Role
from raybundle.block.boards import spline_camera
from raybundle.block.select import with_rows
from raybundle.errors import InputError, NotSolvable
from raybundle.io.photos.cameras import CameraGroup, camera_groups
from raybundle.io.photos.photo import Found, Photo, find_photos
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.sensors import sensor_models
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.marks import Marks, Target, target
from raybundle.targets.sidecar import PrintedSheet
from raybundle.workflows.board_start import board_oriented
from raybundle.workflows.calibration_defects import CANNOT, check_spline, explained, flat_only
from raybundle.workflows.camera_split import cameras_apart
from raybundle.workflows.final import independent_notices
from raybundle.workflows.model_choice import choose_models, with_model
from raybundle.workflows.recognise import Recognised, recognised
from raybundle.workflows.same_camera import shared_sensors
from raybundle.workflows.target_block import (
    FEWEST_TARGETS,
    TargetBlock,
    block_of_targets,
    completed,
    measure_all,
    oriented_part,
    reweighted,
    target_normals,
    target_radii,
    with_coordinates,
    with_dots,
    with_values,
)
from raybundle.workflows.told_positions import camera_notices

SETTLED_PX = 0.003
"""Change of a circle centre's correction below which it is not repeated."""
FEWEST_PHOTOGRAPHS = 3
STRANGE = 0.25
"""Share of a photograph's points that are rejected, from which on it does not belong to the others."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrateOptions:
    """How cameras are calibrated.  The defaults need no change."""

    targets: tuple[str | Target, ...] = ()
    """families of what was photographed, as "aicon14" or "chessboard-9x6", or targets of one's own; (): found out"""
    sheet: PrintedSheet | None = None
    """the sheet that was photographed, by the file beside it: its family, and where its targets are, as a start"""
    separate: tuple[str, ...] = ()
    """patterns of photographs' names, each a camera apart"""
    masks: Path | None = None
    """folder of masks for natural points, which are taken where there are no targets"""
    model: str = "auto"
    """distortion model; auto: brown, or what fits a wide lens better"""
    estimate: tuple[str, ...] = ()
    """parameters that are estimated, no more and no less; (): chosen by significance and determinability"""
    spacing: float = 1.0
    """distance of neighbouring points of a board [mm]"""
    jobs: int = 0
    """photographs worked on at the same time; 0 = processors"""
    dots: bool = False
    """use dots without a code, too, among coded targets"""
    eccentricity: bool = True
    """correct the centres of ellipses"""
    shear: bool = False
    """believe any affinity and shear, as of scanned pictures (`AdjustmentOptions.pixel_shape`)"""
    noise: NoiseModel = "auto"
    """errors of image coordinates: white; fields: smooth ones that differ from image to image, and a floor; auto:
    fields where there are five photographs or more"""
    split: bool = True
    """tell the photographs of two cameras apart where they cannot be of one"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Calibration:
    """What came of the photographs."""

    adjustment: Adjustment
    quality: tuple[CalibrationQuality, ...]
    photos: tuple[Photo, ...]
    groups: tuple[CameraGroup, ...]
    refused: tuple[tuple[str, str], ...]
    """files that are no usable photographs, and why"""
    not_used: tuple[tuple[str, str], ...]
    """photographs without a part in the result, and why"""
    marks: tuple[tuple[Marks, ...], ...]
    """of each photograph, one set for each family"""
    targets: tuple[Target, ...]
    completed: int
    """dots without a readable name that were used all the same"""
    dots: int
    """object points that are dots without a code"""
    largest_eccentricity_px: float
    radius: RadiusScale | None = None
    """What the eccentricities say of the targets' radii; None where nothing is round"""
    seconds: Mapping[str, float] = field(default_factory=dict[str, float])
    """what each stage took, in their order"""

    @property
    def used(self) -> int:
        """Number of photographs that take part."""
        return len(np.unique(self.adjustment.given.observations.image))


def calibrate(
    inputs: Sequence[Path], options: CalibrateOptions | None = None, progress: Progress = silent
) -> Calibration:
    """Calibrate the cameras of photographs of targets.

    inputs  folders and files; targets stand anywhere, flat or in depth, their places need not be known
    raises  InputError where too few targets are found; NotSolvable where they orient no photographs

    A name must occur once on the object.  What it does not tell: the calibration holds for the zoom and focus of the
    photographs, and for the part of the format in which targets were seen.
    """
    options = options or CalibrateOptions()
    clock = _Clock()
    _check_model(options.model)
    targets = tuple(target(given) if isinstance(given, str) else given for given in options.targets)
    found = find_photos(inputs, progress=progress)
    _enough(found, inputs)
    photos = found.photos
    if options.sheet is not None:
        targets = (options.sheet.target,)
    elif not targets:
        shown = recognised(photos, progress)
        targets = shown.targets
        if not targets:
            return _by_tie_points(inputs, found, options, shown, progress)
    clock.stop("photographs")
    groups = camera_groups(photos, (), options.separate)
    if options.dots:
        targets = tuple(replace(t, dots=True) if isinstance(t, Rings) else t for t in targets)
    marks = measure_all(photos, targets, options.jobs, progress)
    clock.stop("targets")
    given = block_of_targets(photos, groups, targets, marks, options.spacing, options.sheet)
    block, radius = _asked(given.block, options), given.radius_px
    if len(np.unique(block.observations.image)) < 2:
        raise InputError(_too_few(photos, marks, targets), file=", ".join(str(p) for p in inputs))
    try:
        return _calibrated(_Measured(given, block, radius, found, groups, marks, targets), options, clock, progress)
    except InputError as error:
        raise explained(error, block) from error
    except NotSolvable as error:
        raise explained(error, block) from error


@dataclass(frozen=True, slots=True)
class _Measured:
    """Photographs with their targets, nothing oriented yet."""

    given: TargetBlock
    block: Block
    radius: Array
    found: Found
    groups: tuple[CameraGroup, ...]
    marks: tuple[tuple[Marks, ...], ...]
    targets: tuple[Target, ...]


def _calibrated(m: _Measured, options: CalibrateOptions, clock: _Clock, progress: Progress) -> Calibration:
    """Orient, adjust, judge."""
    given, block, radius, found, groups, marks, targets = (
        m.given, m.block, m.radius, m.found, m.groups, m.marks, m.targets
    )  # fmt: skip
    photos = found.photos
    approximate, lost, told = _approximate(given, block, targets, options, progress)
    clock.stop("start")
    start, rows = oriented_part(approximate)
    notices = (*told, *_remarks(found, groups))
    threads = options.jobs or os.cpu_count() or 1
    settings = AdjustmentOptions(
        threads=threads, reject="snooping", robust_start=True, noise="white",
        pixel_shape="any" if options.shear else "sensor", weights="residuals",
    )  # fmt: skip
    start = _with_model(start, options.model)
    first = decide(start, settings, progress)
    block, radius, added = completed(block, radius, first.adjusted, targets, marks)
    linked = 0
    if options.dots:
        block, radius, linked = with_dots(block, radius, first.adjusted, marks)
    if added or linked:
        start, rows = oriented_part(with_coordinates(with_values(block, first.adjusted)))
        first = decide(start, settings, progress)
    start = reweighted(with_values(start, first.adjusted), first.sigma0)
    if options.split:
        start, first, split = cameras_apart(start, first, settings, progress)
        notices = (*notices, *split)
    shared = shared_sensors(first, groups, photos, reduced=False)  # of reduced ones the sizes of targets differ
    notices = (*notices, *shared.notices)
    if shared:
        start, groups = shared.applied(start), shared.grouped(groups)
        first = decide(start, settings, progress)
        start = reweighted(with_values(start, first.adjusted), first.sigma0)
    strange = _strange(first)
    if strange:
        lost = {**lost, **{first.given.images.ids[i]: why for i, why in strange.items()}}
        start, rows = _without_images(start, rows, tuple(strange))
        first = decide(start, settings, progress)
        start = reweighted(with_values(start, first.adjusted), first.sigma0)
    if options.model in {"auto", "spline"} and not options.estimate:
        start, chosen = choose_models(start, first, settings)
        notices = (*notices, *chosen)
    if options.model == "spline":  # its surfaces take up what the best of the others leaves
        start = replace(start, cameras=tuple(spline_camera(c) for c in start.cameras))
    result, largest, scale = _adjust(start, first, radius[rows], options, settings, notices, progress)
    if options.model == "spline":
        check_spline(first, result)
    images = len(np.unique(result.given.observations.image))
    chosen_noise = noise_of_photographs(options.noise, images)
    if chosen_noise == "fields":
        result = under_its_noise(under_noise(result))
    few = independent_notices(options.noise, chosen_noise, images)
    result = replace(result, notices=(*few, *result.notices))
    clock.stop("adjustment")
    quality = calibration_qualities(result, progress)
    clock.stop("verdict")
    if all(q.grade == "not determinable" for q in quality) and (why := flat_only(block)):
        raise NotSolvable(f"{CANNOT}: {why}")
    return Calibration(
        adjustment=result,
        quality=quality,
        photos=photos,
        groups=groups,
        refused=tuple((p.name, r) for p, r in found.refused),
        not_used=(*given.not_used, *_lost(lost, given.not_used)),
        marks=marks,
        targets=targets,
        completed=added,
        dots=linked,
        largest_eccentricity_px=largest,
        radius=scale,
        seconds=clock.seconds,
    )


def _check_model(name: str) -> None:
    """Raise InputError for what is not the interior orientation of a camera with a plane sensor."""
    known = f"known: auto, {', '.join(sorted(n for n, m in sensor_models.items() if m.one_exposure))}"
    if name != "auto" and name not in sensor_models:
        raise InputError(f"unknown sensor model {name!r}; {known}")
    if name != "auto" and not sensor_models[name].one_exposure:
        raise InputError(
            f"the sensor model {name} cannot be calibrated from photographs of targets: it is not that of a camera "
            f"that sees all at one instant from one place; {known}. Blocks that use {name} are for `raybundle adjust`"
        )


class _Clock:
    """What the stages of a run take."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._began = time.perf_counter()

    def stop(self, stage: str) -> None:
        """End a stage; the next one begins."""
        now = time.perf_counter()
        self.seconds[stage] = now - self._began
        self._began = now


def _by_tie_points(
    inputs: Sequence[Path], found: Found, options: CalibrateOptions, shown: Recognised, progress: Progress
) -> Calibration:
    """Calibration by the natural points of the object, where there are no targets."""
    from raybundle.workflows.marks import Given  # noqa: PLC0415  (loaded only where they are used, as features are)
    from raybundle.workflows.orient import OrientOptions, orient  # noqa: PLC0415

    with TemporaryDirectory() as folder:
        done = orient(
            inputs, Path(folder) / "calibration",
            OrientOptions(jobs=options.jobs, separate=options.separate, noise=options.noise, masks=options.masks),
            given=Given(gps=False), progress=progress,
        )  # fmt: skip
    told = Notice(code="no_targets", message=_no_targets(shown))
    adjustment = replace(done.adjustment, notices=(told, *done.adjustment.notices))
    return Calibration(
        adjustment=adjustment, quality=calibration_qualities(adjustment, progress), photos=found.photos,
        groups=done.groups, refused=done.refused, not_used=done.not_oriented, marks=(), targets=(), completed=0, dots=0,
        largest_eccentricity_px=0.0,
    )  # fmt: skip


def _no_targets(shown: Recognised) -> str:
    """Why natural points were taken, and what to do."""
    looked = f"{len(shown.looked_at)} photographs that were looked at ({', '.join(shown.looked_at)})"
    if shown.few:
        return (
            f"fewer than half of the {looked} show targets, of {', '.join(shown.few)}: calibrated by natural points, "
            "which are several times less precise. Put the photographs of targets into a folder of their own, or name "
            f"them: --target {shown.few[0]}"
        )
    return (
        f"no coded targets and no board are seen in the {looked}: calibrated by natural points, which are several "
        "times less precise. If others show some, name what was photographed, as --target chessboard-12x9 or --target "
        "aicon14, and put their photographs into a folder of their own"
    )


def _approximate(
    given: TargetBlock, block: Block, targets: Sequence[Target], options: CalibrateOptions, progress: Progress
) -> tuple[Block, dict[str, str], tuple[Notice, ...]]:
    """The block with approximate values, images that could not be oriented and why, and what there is to say."""
    if not given.places:
        from raybundle.orientation.assembly import possible_values  # noqa: PLC0415  (boards do without)
        from raybundle.orientation.camera_constant import checked_by_pairs  # noqa: PLC0415

        values = possible_values(checked_by_pairs(block), progress)
        return values.block, dict(values.not_oriented), values.notices
    model = "auto" if options.model == "spline" else options.model
    approximate, lost = board_oriented(block, given.places, model)
    alike = next((t for t in targets if t.turns > 1), None)
    if alike is None:
        return approximate, lost, ()
    told = Notice(
        code="board_alike",
        message=f"a {alike.title} looks the same when it is turned: its points are held as printed, flat. One that is "
        "not flat then moves the principal point; take one whose numbers of rows and columns are odd and even",
    )
    p = len(approximate.points)
    held = replace(approximate.points, role=np.full(p, Role.CONTROL, np.int32), sigma=np.zeros((p, 3)))
    return replace(approximate, points=held), lost, (told,)


def _with_model(block: Block, model: str) -> Block:
    """The block with a model that was asked for in place of that of the start."""
    if model in {"auto", "spline"}:
        return block
    for k, camera in enumerate(block.cameras):
        if camera.model == model:
            continue
        changed = with_model(block, k, model)
        if changed is None:
            raise InputError(f"camera {camera.id}: the model {model} cannot be fitted to the start; take another")
        block = changed
    return block


def _asked(block: Block, options: CalibrateOptions) -> Block:
    """The block with the model and the parameters that were asked for."""
    if not options.estimate:
        return block
    if options.model == "spline":
        raise InputError("the parameters of the model spline cannot be chosen; leave --estimate or --model away")
    known = sensor_models["brown" if options.model == "auto" else options.model].symbols
    unknown = [s for s in options.estimate if s not in known]
    if unknown:
        raise InputError(f"{unknown[0]!r} is no parameter of the model; known: {', '.join(known)}")
    return replace(block, cameras=tuple(replace(c, estimate=options.estimate) for c in block.cameras))


def _enough(found: Found, inputs: Sequence[Path]) -> None:
    n = len(found.photos)
    if n < FEWEST_PHOTOGRAPHS:
        first = (
            f"{n} usable photograph{'' if n == 1 else 's'}; a calibration needs at least {FEWEST_PHOTOGRAPHS}, better "
            "10 to 20 from different sides, some with the camera rolled by 90 degrees"
        )
        lines = [first]
        lines += [f"  {p.name}: {r}" for p, r in found.refused[:20]]
        lines += [f"  {r}" for r in found.remarks]  # as of sub-folders, which are not looked into
        raise InputError("\n".join(lines), file=", ".join(str(p) for p in inputs))


def _strange(result: Adjustment) -> dict[int, str]:
    """Photographs of which so many points are rejected that they cannot be of this camera and object, and why."""
    o = result.given.observations
    count = np.bincount(o.image, minlength=len(result.given.images))
    out = np.bincount(o.image[~result.image_observations.used], minlength=len(count))
    found = np.flatnonzero((out > STRANGE * count) & (out >= FEWEST_TARGETS))
    if len(found) > np.count_nonzero(count) / 3:  # then it is the others, or the model
        return {}
    return {
        int(i): f"{out[i]} of its {count[i]} points contradict the other photographs; is it mirrored, cropped or of "
        "another camera, or was the zoom moved, or the object?"
        for i in found
    }


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


def _too_few(photos: Sequence[Photo], marks: Sequence[Sequence[Marks]], targets: Sequence[Target]) -> str:
    named = [sum(int(m.named.sum()) for m in sets) for sets in marks]
    bare = sum(int((~m.named).sum()) for sets in marks for m in sets)
    what = ", ".join(t.title for t in targets)
    enough = sum(k >= FEWEST_TARGETS for k in named)
    first = (
        f"{enough} of {len(photos)} photographs show {FEWEST_TARGETS} points of {what} that others show too; at least "
        f"2 are needed ({sum(named)} named points, {bare} without a name). Name what was printed (--target), and "
        "photograph so that a dot or square is 10 px large"
    )
    remarks = [f"  {p.name}: {r}" for p, sets in zip(photos, marks, strict=True) for m in sets for r in m.remarks]
    return "\n".join([first, *remarks[:10]])


def _remarks(found: Found, groups: Sequence[CameraGroup]) -> list[Notice]:
    return [*(Notice(code="photographs", message=r) for r in found.remarks), *camera_notices(groups)]


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

    Radii are those that the images show; where the eccentricities tell them better, they are estimated.
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
        told = f"radii of the targets are {scale.value:.3f} ± {scale.std:.3f} times what their images show; estimated"
        notices = (*notices, Notice(code="target_radius", message=told))
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
