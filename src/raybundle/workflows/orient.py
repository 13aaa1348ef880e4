"""From photographs and satellite scenes to an oriented block with its report, in stages that can be stopped."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.adjustment.accuracy import accuracy
from raybundle.adjustment.options import NoiseModel
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.block import Camera
from raybundle.block.relative import relative_control
from raybundle.errors import InputError, NoOrientation, NotSolvable
from raybundle.io.coordinate_systems import LocalFrame
from raybundle.io.photos.cameras import CameraGroup
from raybundle.io.photos.photo import Found, Photo, find_photos
from raybundle.io.project import Project, Stage, StageRecord, key_of
from raybundle.io.trajectories import Trajectory, with_positions
from raybundle.matching.features import FeatureMethod, feature_method
from raybundle.matching.verify import VerifiedPair
from raybundle.numerics.counting import counted
from raybundle.numerics.progress import Progress, silent
from raybundle.scenes.bias import BiasKind
from raybundle.workflows.asked import check_asked
from raybundle.workflows.attitudes import Convention, find_attitudes
from raybundle.workflows.control_apart import check_apart
from raybundle.workflows.dropped import Dropped
from raybundle.workflows.final import adjusted_part, final_adjustment, left_out, undetermined_part
from raybundle.workflows.georeference import Georeferenced, frame_of
from raybundle.workflows.marks import Given, check_marks, check_names, under_kept_names
from raybundle.workflows.parts import Part, apart_notice, joined_notice, place_parts
from raybundle.workflows.photo_run import PhotoRun
from raybundle.workflows.positions import GPS_M, flight_lines, without_idle
from raybundle.workflows.precise import Weights
from raybundle.workflows.read_out import with_cause
from raybundle.workflows.same_camera import shared_sensors
from raybundle.workflows.scene_images import FoundScenes, SceneImage, find_scenes
from raybundle.workflows.scene_run import SceneRun
from raybundle.workflows.scene_ties import ScenePair
from raybundle.workflows.tie_block import image_sigma_px
from raybundle.workflows.told_positions import with_relative_precision
from raybundle.workflows.upright import Upright

STAGES = ("photographs", "features", "matching", "start", "precision", "adjustment", "report")


@dataclass(frozen=True, slots=True, kw_only=True)
class OrientOptions:
    """How photographs are oriented.  The defaults need no change."""

    features: str = "rootsift"
    """feature method"""
    feature_count: int = 10_000
    """features of a photograph, at most"""
    start: Literal["auto", "growing", "averaging"] = "auto"
    """growing: image by image; averaging: all pairs at once; auto: growing, averaging where that leaves images"""
    precise: bool = True
    """False leaves out least-squares matching: quick, and several times less precise"""
    jobs: int = 0
    """photographs or pairs worked on at the same time; 0 = processors"""
    memory_gb: float = 4.0
    """memory that image pixels may take while points are measured"""
    separate: tuple[str, ...] = ()
    """patterns of photographs' names, each a camera apart"""
    library: Path | None = None
    """camera library whose calibrations are held where none is given; None: none is used"""
    masks: Path | None = None
    """folder of masks, as COLMAP or Metashape name them: 0 where a photograph is not to be measured in"""
    scene_bias: BiasKind = "shift"
    """what is estimated of a satellite scene's RPC: none, shift, drift, affine"""
    crs: str | None = None
    """coordinate system of positions in a grid and, where there are scenes, of control files that name none"""
    attitudes: Convention = "auto"
    """attitudes that are observed, by their convention; auto: what there is with standard deviations"""
    attitude_sigma_deg: tuple[float, float] | None = None
    """about level axes and about the vertical, of attitudes that state none; also asks for those of the gimbal"""
    relative: Literal["", "shift", "drift"] = ""
    """relative aerial control: positions and attitudes of a flight line count by their differences alone, or also after
    a drift; "": they count as they are"""
    noise: NoiseModel = "auto"
    """errors of image coordinates: white; fields: smooth ones that differ from image to image, and a floor; auto:
    fields where there are five photographs or more"""
    redo_from: Literal["", "photographs", "features", "matching", "start", "precision", "adjustment", "report"] = ""
    """stage from which on everything is done again"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Orientation:
    """What came of the photographs."""

    adjustment: Adjustment
    photos: tuple[Photo, ...]
    groups: tuple[CameraGroup, ...]
    refused: tuple[tuple[str, str], ...]
    """files that are no usable photographs, and why"""
    not_oriented: tuple[tuple[str, str], ...]
    """photographs without orientation, and why"""
    pairs: tuple[VerifiedPair, ...]
    stages: tuple[StageRecord, ...]
    sigma_px: float
    """standard deviation of an image coordinate, from the residuals"""
    weights: Weights | None
    frame: LocalFrame | None
    """coordinate system of object space; None: a free system"""
    parts: tuple[Part, ...] = ()
    """further parts of the photographs that nothing joins to the first"""
    scenes: tuple[SceneImage, ...] = ()
    """satellite scenes that take part"""
    scene_pairs: tuple[ScenePair, ...] = ()
    remarks: tuple[str, ...] = field(default=())
    upright: Upright | None = None
    """how the vertical was found, where neither control nor positions tell it"""
    dropped: Dropped | None = None
    """what became of the photographs' features before the adjustment"""

    @property
    def oriented(self) -> int:
        """Number of photographs with an orientation, in whatever part."""
        photographs = {p.name for p in self.photos}
        return len(self.photos) - sum(1 for n, _ in self.not_oriented if n in photographs)

    @property
    def oriented_scenes(self) -> int:
        """Number of scenes in the adjustment."""
        lost = {n for n, _ in self.not_oriented}
        return sum(1 for s in self.scenes if s.name not in lost)

    @property
    def given(self) -> int:
        """Number of files that are photographs or scenes, refused ones included."""
        names = {p.name for p in self.photos} | {s.name for s in self.scenes} | {n for n, _ in self.not_oriented}
        return len(names) + len(self.refused)

    def additions(self) -> dict[str, object]:
        """What result.json says beside the adjustment."""
        lost = [{"file": f, "reason": r} for f, r in (*self.refused, *self.not_oriented)]
        return {
            "images": {
                "given": self.given,
                "oriented": self.oriented + self.oriented_scenes,
                "not_oriented": lost,
            },
            "components": 1 + len(self.parts),
            "stages": [
                {k: v for k, v in asdict(s).items() if k in _STAGE_FIELDS} for s in self.stages
            ],
            "image_sigma_px": self.sigma_px,
            **({} if self.frame is None else {"frame": self.frame.as_mapping()}),
            **({} if self.upright is None else {"upright": self.upright.as_mapping()}),
            **({} if self.dropped is None else {"measurements": self.dropped.as_mapping(self.adjustment)}),
            **accuracy(self.adjustment),
        }  # fmt: skip


_STAGE_FIELDS = ("name", "seconds", "cpu_seconds", "peak_memory_mb", "from_cache")


def orient(
    inputs: Sequence[Path],
    folder: Path,
    options: OrientOptions | None = None,
    *,
    calibration: Sequence[Camera] = (),
    given: Given | None = None,
    positions: Trajectory | None = None,
    progress: Progress = silent,
) -> Orientation:
    """Orient photographs and satellite scenes within a project folder; finished stages are taken from there.

    inputs       folders and files
    folder       project folder; begun, or continued
    calibration  cameras whose interior orientation is known (`estimate` () holds it)
    given        control, check points, scale bars; GPS positions of the photographs place the block, or are observed
                 beside control
    positions    positions of the photographs from a file, in place of those that they state
    raises       InputError, NoOrientation

    What it does not tell: without control or scale bars the position, orientation and scale of the result are
    arbitrary; and a set of photographs whose parts look alike can be oriented wrongly with small residuals.
    """
    options = options or OrientOptions()
    jobs = options.jobs or os.cpu_count() or 1
    method = feature_method(options.features)
    given = given or Given()
    project = Project.open(folder)
    try:
        found, scenes_found, refused = _search(project, inputs, given, positions, options.crs, progress)
        given = replace(given, control=under_kept_names(given.control, found.copies))
        check_marks(found.photos, given)
        if not scenes_found.scenes:  # which have names and a frame of their own
            check_names(found.photos, given)
            check_apart(given)
            frame_of(found.photos, given)
        asked = check_asked(
            found.photos, given, positions=positions, crs=options.crs, relative=options.relative,
            scenes=bool(scenes_found.scenes),
        )  # fmt: skip
        given, told = _with_attitudes(found.photos, positions, given, options)
        _forget(project, options)
        photographs = PhotoRun(found.photos, jobs, progress, refused)
        photographs.masked(options.masks)
        scenes = SceneRun.of(scenes_found, options.scene_bias, options.crs) if scenes_found.scenes else None
        _features(project, photographs, scenes, options, method)
        refused += scenes_found.refused if scenes is None else scenes.refused
        _check_number(inputs, photographs.photos, 0 if scenes is None else len(scenes.images), refused)
        photographs.cameras(calibration, options.separate, options.library)
        photographs = _ties(project, photographs, scenes, given, options, method)
        remarks = (*found.remarks, *asked, *told, *scenes_found.remarks, *photographs.told)
        with project.stage("adjustment") as stage:
            blocks, photos = photographs.blocks, photographs.photos
            if scenes is None:
                placed, apart = place_parts(blocks, photos, given)
            else:
                assert photographs.store is not None
                placed, apart = scenes.place(blocks, photos, given, photographs.store, method)
            placed = _relative(placed, photos, options.relative)
            adjustment, parts, groups = _adjusted(
                stage, placed, apart, photographs.groups, photos, jobs, progress, remarks, options.noise,
                weights="residuals" if options.precise else "given",
            )  # fmt: skip
            photographs.groups = groups
            dropped = photographs.dropped
            given_rows = sum(len(a.given.observations) for a in (adjustment, *(p.adjustment for p in parts)))
            told = (*photographs.notices, *([] if dropped is None else [dropped.notice(given_rows)]))
            adjustment = replace(adjustment, notices=(*told, *adjustment.notices))
        return _orientation(project, photographs, scenes, adjustment, parts, placed, remarks)
    finally:
        project.close()


def _with_attitudes(
    photos: Sequence[Photo], positions: Trajectory | None, given: Given, options: OrientOptions
) -> tuple[Given, tuple[str, ...]]:
    """What is known of object space with the attitudes of the photographs, and remarks."""
    found, told = find_attitudes(
        photos, positions, use=options.attitudes, sigma_deg=options.attitude_sigma_deg, crs=options.crs
    )
    return replace(given, attitudes=found), told


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
    used = f"{counted(len(block.stations), 'photograph')} on {counted(lines, 'flight line')}"
    told = f"relative aerial control: the positions of {used} are used "
    told += "by their differences" + (", after a drift of each line" if kind == "drift" else "")
    told += f"; {left} on no line are left out" if left else ""
    if not known.all():
        axes = ", ".join(a for a, k in zip("XYZ", known, strict=True) if not k)
        told += (
            f". No control tells the place in {axes}: there the shift of a line is taken to be good to {GPS_M[0]:g} m "
        )
        told += f"in plan and {GPS_M[2]:g} m in height"
    return replace(placed, block=block, notices=(*placed.notices, Notice(code="relative_control", message=told)))


def _features(
    project: Project, photographs: PhotoRun, scenes: SceneRun | None, options: OrientOptions, method: FeatureMethod
) -> None:
    """Features of photographs and scenes; what has none is refused."""
    with project.stage("features") as stage:
        photographs.features(project, stage, method, options.feature_count)
        if scenes is not None:
            scenes.features(project, stage, method, options.feature_count, photographs.jobs, photographs.progress)


def _ties(
    project: Project, photographs: PhotoRun, scenes: SceneRun | None, given: Given, options: OrientOptions,
    method: FeatureMethod,
) -> PhotoRun:  # fmt: skip
    """Tie points with approximate values, and measured precisely where that is asked for."""
    jobs, progress = photographs.jobs, photographs.progress
    name = project.folder.name
    try:
        with project.stage("matching") as stage:
            photographs.matching(project, stage, method)
            if scenes is not None:
                scenes.matching(project, stage, method, jobs, progress)
        with project.stage("start") as stage:
            photographs.start(project, stage, name, options.start)
            if scenes is not None:
                scenes.start(project, stage, name, given, len(photographs.photos), jobs, progress)
    except NoOrientation:
        photographs, first = _searched_again(project, photographs, scenes, options, method), photographs
        if photographs is first:
            raise
    else:
        photographs = _searched_again(project, photographs, scenes, options, method)
    if options.precise:
        with project.stage("precision") as stage:
            photographs.precision(project, stage, options.memory_gb)
            if scenes is not None:
                scenes.precision(project, stage, jobs, progress)
    return photographs


def _searched_again(
    project: Project, photographs: PhotoRun, scenes: SceneRun | None, options: OrientOptions, method: FeatureMethod
) -> PhotoRun:
    """The run with features of reduced photographs, where these orient more of them; with scenes the run as it is."""
    if scenes is not None:
        return photographs
    return photographs.searched_again(project, project.folder.name, options.start, method, options.feature_count)


def _orientation(
    project: Project, photographs: PhotoRun, scenes: SceneRun | None, adjustment: Adjustment,
    parts: tuple[Part, ...], placed: Georeferenced, remarks: tuple[str, ...],
) -> Orientation:  # fmt: skip
    """Everything together."""
    lost = [*photographs.lost, *([] if scenes is None else scenes.lost)]
    of_scenes = [] if scenes is None or scenes.weights is None else [scenes.weights]
    return Orientation(
        adjustment=adjustment,
        photos=photographs.photos,
        groups=photographs.groups,
        refused=tuple(photographs.refused),
        not_oriented=(*lost, *left_out(adjustment, parts)),
        pairs=tuple(photographs.pairs),
        stages=tuple(project.records),
        sigma_px=image_sigma_px(adjustment),
        weights=next(iter((*photographs.weights, *of_scenes)), None),
        frame=placed.frame,
        upright=placed.upright,
        dropped=photographs.dropped,
        parts=parts,
        scenes=() if scenes is None else scenes.images,
        scene_pairs=() if scenes is None else scenes.pairs,
        remarks=remarks,
    )


def _beside(inputs: Sequence[Path], files: Sequence[Path]) -> list[Path]:
    """Files as they are called in the folders that are looked into."""
    folders = [p for p in inputs if p.is_dir()]
    return [f / file.name for f in folders for file in files if file.resolve() == (f / file.name).resolve()]


def _search(
    project: Project, inputs: Sequence[Path], given: Given, positions: Trajectory | None, crs: str | None,
    progress: Progress,
) -> tuple[Found, FoundScenes, list[tuple[str, str]]]:  # fmt: skip
    """The photographs and scenes among the inputs, and photographs that are refused with the reason."""
    with project.stage("photographs") as stage:
        scenes = find_scenes(inputs)
        used = _beside(inputs, [*(c.path for c in given.control), *([] if positions is None else [positions.path])])
        found = find_photos(inputs, leave=[*scenes.files, *used], progress=progress)
        if positions is not None:
            placed, told = with_positions(found.photos, positions, crs)
            found = replace(found, photos=placed, remarks=(*found.remarks, *told))
        refused = [(p.name, r) for p, r in found.refused]
        _check_number(inputs, found.photos, len(scenes.scenes), [*refused, *scenes.refused], found.remarks)
        stage.from_cache = False
        stage.key = key_of("photographs", [p.sha256 for p in found.photos], [s.sha256 for s in scenes.scenes])
        stage.summary = f"{counted(len(found.photos), 'photograph')}, {len(refused)} refused"
        if scenes.scenes or scenes.refused:
            stage.summary += f"; {counted(len(scenes.scenes), 'scene')}, {len(scenes.refused)} refused"
    return found, scenes, refused


def _adjusted(
    stage: Stage, placed: Georeferenced, apart: Sequence[Georeferenced], groups: tuple[CameraGroup, ...],
    photos: Sequence[Photo], jobs: int, progress: Progress, remarks: Sequence[str], noise: NoiseModel = "auto", *,
    weights: Literal["given", "residuals"] = "given",
) -> tuple[Adjustment, tuple[Part, ...], tuple[CameraGroup, ...]]:  # fmt: skip
    """The final adjustments of what is placed together and of the parts that nothing joins to it, and the cameras.

    Photographs that turn out to be of one sensor, stored differently, are adjusted once more as of one camera.
    """
    parts, kept, lost = list[Part](), list[Georeferenced](), list[Notice]()
    for part in apart:
        try:
            parts.append(adjusted_part(part, groups, jobs, progress, noise, weights=weights))
            kept.append(part)
        except NotSolvable as error:
            lost += undetermined_part(part, error)
    placed = replace(placed, notices=(*lost, *placed.notices))
    adjustment = final_adjustment(placed, groups, jobs, progress, remarks, noise, weights=weights)
    shared = shared_sensors(adjustment, groups, photos)
    if shared:
        groups = shared.grouped(groups)
        placed = replace(placed, block=shared.applied(placed.block))
        adjustment = final_adjustment(placed, groups, jobs, progress, remarks, noise, weights=weights)
    adjustment = with_relative_precision(with_cause(adjustment, photos))
    told = (*joined_notice(placed.joined, adjustment.given), *shared.notices)
    if kept:  # of what is left in the end: the adjustments leave photographs out
        left = [replace(k, block=p.adjustment.given) for k, p in zip(kept, parts, strict=True)]
        told = (apart_notice(adjustment.given, left, [part_folder(k) for k in range(len(kept))]), *told)
    adjustment = replace(adjustment, notices=(*told, *adjustment.notices))
    stage.from_cache = False
    stage.summary = f"sigma0 {adjustment.sigma0:.3f}"
    return adjustment, tuple(parts), groups


def _check_number(
    inputs: Sequence[Path], photos: Sequence[Photo], scenes: int, refused: Sequence[tuple[str, str]],
    remarks: Sequence[str] = (),
) -> None:  # fmt: skip
    """Raise InputError where there are neither two photographs nor a scene."""
    if len(photos) >= 2 or scenes >= 2 or (scenes and photos):
        return
    if not scenes:
        raise _too_few(inputs, photos, refused, remarks)
    lines = ["1 satellite scene and no photograph; at least 2 images of the same ground are needed"]
    lines += [f"  {name}: {reason}" for name, reason in refused[:20]]
    raise InputError("\n".join(lines), file=", ".join(str(p) for p in inputs))


def _too_few(
    inputs: Sequence[Path], photos: Sequence[Photo], refused: Sequence[tuple[str, str]], remarks: Sequence[str]
) -> InputError:
    lines = [f"{len(photos)} usable photograph{'' if len(photos) == 1 else 's'}, at least 2 are needed"]
    lines += [f"  {name}: {reason}" for name, reason in refused[:20]]
    if len(refused) > 20:
        lines.append(f"  and {len(refused) - 20} more")
    lines += [f"  {r}" for r in remarks]  # as of sub-folders, which are not looked into
    lines += [] if photos or refused or remarks else ["  give a folder of photographs, or their files"]
    return InputError("\n".join(lines), file=", ".join(str(p) for p in inputs))


def _forget(project: Project, options: OrientOptions) -> None:
    """Remove the products of the stages that are to be done again."""
    if not options.redo_from:
        return
    again = STAGES[STAGES.index(options.redo_from) :]
    if "matching" in again:
        project.forget_pairs()
    for name in ("features", "start", "precision"):
        if name in again:
            project.forget_kind(name)


def part_folder(k: int) -> str:
    """Folder of the result of the k-th further part."""
    return f"result-{k + 2}"
