"""Calibration of cameras from photographs of targets or boards: free network, circle centres, model, one camera or two.

The steps: targets are measured; a board, or pairs of photographs, give the start; dots whose code could not be read are
found where they must be; photographs of two cameras are told apart; the distortion model is chosen; the centres of
ellipses are corrected; parameters are chosen by significance and determinability, blunders rejected.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.calibration_quality import CalibrationQuality, calibration_qualities
from raybundle.adjustment.decide import decide
from raybundle.adjustment.eccentricity import eccentricity_px
from raybundle.adjustment.one_camera import Split, find_splits
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.block import Block, Camera
from raybundle.errors import InputError, NotSolvable
from raybundle.io.photos.cameras import CameraGroup, camera_groups
from raybundle.io.photos.photo import Found, Photo, find_photos
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.assembly import possible_values
from raybundle.orientation.camera_constant import checked_by_pairs
from raybundle.sensors import sensor_models
from raybundle.targets.kinds.rings import Rings
from raybundle.targets.marks import Marks, Target, target
from raybundle.workflows.board_start import board_oriented
from raybundle.workflows.model_choice import choose_models
from raybundle.workflows.recognise import recognised
from raybundle.workflows.target_block import (
    FEWEST_TARGETS,
    block_of_targets,
    completed,
    measure_all,
    oriented_part,
    reweighted,
    target_normals,
    target_radii,
    with_coordinates,
    with_dots,
)

SETTLED_PX = 0.003
"""Change of a circle centre's correction below which it is not repeated."""
FEWEST_PHOTOGRAPHS = 3
MOST_CAMERAS = 8
SHEAR = 1e-4
"""Shear that is believed: rows and columns of a sensor are at right angles by lithography."""
SHARE = 0.7
"""Share of sigma0 to which two cameras in place of one must bring it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrateOptions:
    """How cameras are calibrated.  The defaults need no change."""

    targets: tuple[str, ...] = ()
    """families of what was photographed, as "aicon14" or "chessboard-9x6"; (): found out"""
    separate: tuple[str, ...] = ()
    """patterns of photographs' names, each a camera apart"""
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
    """believe any shear S, as of scanned pictures; rows and columns of a sensor are at right angles by lithography, and
    a large shear is something else that the model lacks, which would move the principal point"""
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
    if options.model not in {"auto", *sensor_models}:
        raise InputError(f"unknown sensor model {options.model!r}; known: auto, {', '.join(sorted(sensor_models))}")
    targets = tuple(target(name) for name in options.targets)
    found = find_photos(inputs, progress=progress)
    _enough(found, inputs)
    photos = found.photos
    if not targets:
        targets = recognised(photos, progress)
    groups = camera_groups(photos, (), options.separate)
    if options.dots:
        targets = tuple(replace(t, dots=True) if isinstance(t, Rings) else t for t in targets)
    marks = measure_all(photos, targets, options.jobs, progress)
    given = block_of_targets(photos, groups, targets, marks, options.spacing)
    block, radius = _asked(given.block, options), given.radius_px
    if len(np.unique(block.observations.image)) < 2:
        raise InputError(_too_few(photos, marks, targets), file=", ".join(str(p) for p in inputs))
    if given.places:
        approximate, lost = board_oriented(block, given.places, options.model)
        told: tuple[Notice, ...] = ()
    else:
        values = possible_values(checked_by_pairs(block), progress)
        approximate, lost, told = values.block, dict(values.not_oriented), values.notices
    start, rows = oriented_part(approximate)
    notices = (*told, *_remarks(found, groups))
    settings = AdjustmentOptions(threads=options.jobs or os.cpu_count() or 1, reject="snooping", robust_start=True)
    first = decide(start, settings, progress)
    block, radius, added = completed(block, radius, first.adjusted, targets, marks)
    linked = 0
    if options.dots:
        block, radius, linked = with_dots(block, radius, first.adjusted, marks)
    if added or linked:
        start, rows = oriented_part(with_coordinates(_with_values(block, first.adjusted)))
        first = decide(start, settings, progress)
    start = reweighted(_with_values(start, first.adjusted), first.sigma0)
    if options.split:
        start, first, split = _split(start, first, settings, progress)
        notices = (*notices, *split)
    if options.model == "auto" and not options.estimate:
        start, chosen = choose_models(start, first, settings)
        notices = (*notices, *chosen)
    result, largest = _adjust(start, first, radius[rows], options, settings, notices, progress)
    return Calibration(
        adjustment=result,
        quality=calibration_qualities(result, progress),
        photos=photos,
        groups=groups,
        refused=tuple((p.name, r) for p, r in found.refused),
        not_used=(*given.not_used, *_lost(lost, given.not_used)),
        marks=marks,
        targets=targets,
        completed=added,
        dots=linked,
        largest_eccentricity_px=largest,
    )


def _asked(block: Block, options: CalibrateOptions) -> Block:
    """The block with the model and the parameters that were asked for."""
    if not options.estimate:
        return block
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
        raise InputError("\n".join(lines), file=", ".join(str(p) for p in inputs))


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
    notices = [Notice(code="photographs", message=r) for r in found.remarks]
    return notices + [
        Notice(code="camera", message=f"camera {g.id}: {r}", ids=(g.id,)) for g in groups for r in g.remarks
    ]


def _with_values(block: Block, adjusted: Block) -> Block:
    """The block with orientations, coordinates and cameras of an adjusted one, by name; points without are NaN."""
    xyz = dict(zip(adjusted.points.ids, adjusted.points.xyz, strict=True))
    none = np.full(3, np.nan)
    return replace(
        block,
        images=replace(block.images, centre=adjusted.images.centre, rotation=adjusted.images.rotation),
        points=replace(
            block.points, xyz=np.array([xyz.get(name, none) for name in block.points.ids]).reshape(-1, 3)
        ),
        cameras=tuple(
            replace(c, model=a.model, values={**a.values, **{s: c.values[s] for s in c.sigma}})
            for c, a in zip(block.cameras, adjusted.cameras, strict=True)
        ),
    )  # fmt: skip


def _split(
    start: Block, first: Adjustment, settings: AdjustmentOptions, progress: Progress
) -> tuple[Block, Adjustment, tuple[Notice, ...]]:
    """Cameras that are two taken apart, as long as the adjustment gains by it."""
    told: list[Notice] = []
    tested: set[str] = set()
    given = len(start.cameras)
    scale = first.sigma0  # the start has standard deviations that are larger by it
    while len(start.cameras) < MOST_CAMERAS:
        k = next((k for k, c in enumerate(start.cameras) if c.id not in tested), None)
        if k is None:
            break
        camera = start.cameras[k]
        tested.add(camera.id)
        best: tuple[Adjustment, Block, Split] | None = None
        for split in find_splits(first, camera.id):
            trial = _taken_apart(start, k, split)
            try:
                after = decide(trial, settings, progress)
            except NotSolvable:
                continue
            if not _gained(first, after, scale) or after.sigma0 > SHARE * first.sigma0 / scale:
                continue
            if best is None or after.sigma0 < best[0].sigma0:
                best = after, trial, split
        if best is None:
            continue
        after, trial, split = best
        two = trial.cameras[-1]
        if split.sought:
            told.append(_unstable(camera, after.sigma0 * scale / first.sigma0, after, split))
            continue
        n = [len(g) for g in split.groups]
        by = split.words
        dc, dx, dy = split.difference
        told.append(
            Notice(
                code="two_cameras",
                message=f"camera {camera.id}: {n[0]} photographs ({by}) and {n[1]} others cannot have the same "
                f"interior orientation (c differs by {dc:+.1f} px, the principal point by {dx:+.1f}, {dy:+.1f} px); "
                f"they are calibrated apart, the others as {two.id}. Two cameras, or zoom or focus moved: say with "
                "--camera PATTERN which",
                ids=(camera.id, two.id),
            )
        )
        tested.discard(camera.id)
        start, first, scale = _with_values(trial, after.adjusted), after, 1.0
    if len(start.cameras) > given:
        start = reweighted(start, first.sigma0)
    return start, first, tuple(told)


def _unstable(camera: Camera, share: float, after: Adjustment, split: Split) -> Notice:
    """A notice that photographs differ in their interior orientation though neither names nor order tell them apart."""
    dc, dx, dy = split.difference
    names = [after.given.images.ids[i] for i in split.groups[1]]
    return Notice(
        code="unstable_camera",
        message=f"camera {camera.id}: its interior orientation was not the same in all photographs. Two groups would "
        f"reduce the residuals to {share:.2f} of theirs (c differs by {dc:+.1f} px, the principal point by {dx:+.1f}, "
        f"{dy:+.1f} px; the one are {', '.join(names[:8])}{' ...' if len(names) > 8 else ''}); the "
        "calibration is their mean, its standard deviations are too small. Switch autofocus, zoom and stabilisation "
        "off, or tell cameras apart (--camera)",
        ids=(camera.id, *names),
    )


def _taken_apart(block: Block, k: int, split: Split) -> Block:
    """The block with a camera of its own for the second group of photographs of camera k."""
    camera = block.cameras[k]
    two = replace(camera, id=f"{camera.id}-{_number(block.cameras, camera.id)}")
    of_image = block.images.camera.copy()
    of_image[split.groups[1]] = len(block.cameras)
    return replace(block, cameras=(*block.cameras, two), images=replace(block.images, camera=of_image))


def _number(cameras: Sequence[Camera], id_: str) -> int:
    number = 2
    while any(c.id == f"{id_}-{number}" for c in cameras):
        number += 1
    return number


def _gained(before: Adjustment, after: Adjustment, scale: float) -> bool:
    """Whether more cameras explain the observations better by the Bayesian information criterion (Schwarz 1978).

    scale  standard deviations of the observations after, in those before
    """
    m = before.observations
    lost = 2 * sum(1 for r in before.image_observations.rejected if r) - 2 * sum(
        1 for r in after.image_observations.rejected if r
    )
    # a rejected coordinate that returns is worth at least what the critical value allows
    old = before.weighted_square_sum + max(lost, 0) * (before.critical_tau * before.sigma0) ** 2
    gain = m * np.log(old / scale**2 / after.weighted_square_sum)
    return bool(gain > (after.unknowns - before.unknowns) * np.log(m) + 10)


def _sheared(result: Adjustment) -> list[Notice]:
    """A notice for each camera whose shear is larger than that of any sensor."""
    found: list[Notice] = []
    for i in result.interior:
        p = i.parameters.get("S")
        if p is None or not p.std or abs(p.value) < SHEAR:
            continue
        found.append(
            Notice(
                code="shear",
                message=f"camera {i.camera}: the residuals ask for a shear S of {p.value:.1e} ± {p.std:.0e}, which no "
                f"sensor has (limit {SHEAR:.0e}); it is held at 0. Something else is not in the model, as motion "
                "during the read-out or uneven light on the targets; standard deviations may be too small. For scanned "
                "pictures: --shear",
                ids=(i.camera,),
            )
        )
    return found


def _adjust(
    start: Block,
    first: Adjustment,
    radius_px: Array,
    options: CalibrateOptions,
    settings: AdjustmentOptions,
    notices: Sequence[Notice],
    progress: Progress,
) -> tuple[Adjustment, float]:
    """The free network, ellipse centres corrected with the orientations of the adjustment before."""
    shift = _eccentricity(start, first, radius_px, options)
    result = decide(_moved(start, shift), settings, progress, notices=tuple(notices))
    sheared = [] if options.shear else _sheared(result)
    if sheared:
        notices = (*notices, *sheared)
        settings = replace(settings, never=("S",))
        flat = tuple(replace(c, values={**c.values, "S": 0.0}) if "S" in c.values else c for c in start.cameras)
        start = replace(start, cameras=flat)
        result = decide(_moved(start, shift), settings, progress, notices=tuple(notices))
    again = _eccentricity(start, result, radius_px, options)
    used = result.image_observations.used
    if np.abs(again - shift)[used].max(initial=0.0) > SETTLED_PX:
        shift = again
        here = reweighted(_moved(_with_values(start, result.adjusted), shift), result.sigma0)
        result = decide(here, settings, progress, notices=tuple(notices))
    return result, float(np.linalg.norm(shift[used], axis=1).max(initial=0.0))


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
