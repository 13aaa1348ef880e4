"""From photographs and satellite scenes to an oriented block with its report, in stages that can be stopped."""

from __future__ import annotations

import os
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from threading import Lock
from typing import Literal

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.errors import InputError
from raybundle.io.block_arrays import arrays_of_block, block_of_arrays
from raybundle.io.camera_library import with_library
from raybundle.io.coordinate_systems import LocalFrame
from raybundle.io.photos.cameras import CameraGroup, camera_groups, camera_of
from raybundle.io.photos.photo import Found, Photo, find_photos
from raybundle.io.project import Project, Stage, StageRecord, key_of
from raybundle.io.trajectories import Trajectory, with_positions
from raybundle.matching.features import feature_method
from raybundle.matching.refine import smoothed
from raybundle.matching.tracks import tracks_of
from raybundle.matching.verify import VerifiedPair, trusted
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.progress import Progress, silent
from raybundle.scenes.bias import BiasKind
from raybundle.workflows.final import adjusted_part, final_adjustment, left_out
from raybundle.workflows.georeference import Georeferenced, accuracy
from raybundle.workflows.marks import Given
from raybundle.workflows.parts import Part, apart_notice, place_parts, start_parts
from raybundle.workflows.scene_images import FoundScenes, SceneImage, find_scenes
from raybundle.workflows.scene_run import SceneRun
from raybundle.workflows.scene_ties import ScenePair
from raybundle.workflows.tie_block import (
    PreciseBlock,
    TieBlock,
    Weights,
    block_of_tracks,
    image_sigma_px,
    refine,
)
from raybundle.workflows.tie_points import FeatureStore, find_features, grey_of, match_pairs, pairs_of

START, PRECISION = 7, 15
"""Versions of the stages' results."""
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
    scene_bias: BiasKind = "shift"
    """what is estimated of a satellite scene's RPC: none, shift, drift, affine"""
    crs: str | None = None
    """coordinate system of control files that name none, where there are scenes"""
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
    project = Project.open(folder)
    try:
        found, scenes_found, refused = _search(project, inputs, positions, progress)
        scenes = SceneRun.of(scenes_found, options.scene_bias, options.crs) if scenes_found.scenes else None
        photos = found.photos
        _forget(project, options)
        with project.stage("features") as stage:
            store, failed = find_features(project, stage, photos, method, options.feature_count, jobs, progress)
            if scenes is not None:
                scenes.features(project, stage, method, options.feature_count, jobs, progress)
        refused += scenes_found.refused if scenes is None else scenes.refused
        if failed:
            refused += [(photos[i].name, reason) for i, reason in failed.items()]
            kept = [i for i in range(len(photos)) if i not in failed]
            photos = tuple(photos[i] for i in kept)
            store = FeatureStore(project, tuple(store.keys[i] for i in kept))
        left = 0 if scenes is None else len(scenes.images)
        _check_number(inputs, photos, left, refused)
        alone = [(p.name, "one photograph alone cannot be oriented; at least 2 are needed") for p in photos[:1]]
        several = len(photos) > 1
        photos = photos if several else ()
        groups = camera_groups(photos, calibration, options.separate) if several or calibration else ()
        if options.library is not None and several:
            groups = with_library(photos, groups, options.library)
        pairs: list[VerifiedPair] = []
        with project.stage("matching") as stage:
            if several:
                chosen = pairs_of(photos, store, method, _positions(photos), progress)
                pairs = match_pairs(project, stage, photos, store, method, chosen, jobs, progress)
            if scenes is not None:
                scenes.matching(project, stage, method, jobs, progress)
        ties: tuple[TieBlock, ...] = ()
        with project.stage("start") as stage:
            if several:
                ties = _start(project, stage, folder.name, photos, groups, pairs, store, options.start, jobs, progress)
            if scenes is not None:
                scenes.start(project, stage, folder.name, given or Given(), len(photos), jobs, progress)
        weights: list[Weights] = []
        blocks = [tie.block for tie in ties]
        if options.precise:
            with project.stage("precision") as stage:
                if several:
                    blocks, weights = _precision(project, stage, ties, photos, options, jobs, progress)
                if scenes is not None:
                    scenes.precision(project, stage, jobs, progress)
        remarks = (*found.remarks, *scenes_found.remarks)
        with project.stage("adjustment") as stage:
            if scenes is None:
                placed, apart = place_parts(blocks, photos, given or Given())
            else:
                placed, apart = scenes.place(blocks, photos, given or Given(), store, method)
            adjustment, parts = _adjusted(stage, placed, apart, groups, jobs, progress, remarks)
        lost = [*(ties[0].not_oriented if ties else alone), *([] if scenes is None else scenes.lost)]
        of_scenes = [] if scenes is None or scenes.weights is None else [scenes.weights]
        return Orientation(
            adjustment=adjustment,
            photos=photos,
            groups=groups,
            refused=tuple(refused),
            not_oriented=(*lost, *left_out(adjustment, parts)),
            pairs=tuple(pairs),
            stages=tuple(project.records),
            sigma_px=image_sigma_px(adjustment),
            weights=next(iter((*weights, *of_scenes)), None),
            frame=placed.frame,
            parts=parts,
            scenes=() if scenes is None else scenes.images,
            scene_pairs=() if scenes is None else scenes.pairs,
            remarks=remarks,
        )
    finally:
        project.close()


def _search(
    project: Project, inputs: Sequence[Path], positions: Trajectory | None, progress: Progress
) -> tuple[Found, FoundScenes, list[tuple[str, str]]]:
    """The photographs and scenes among the inputs, and photographs that are refused with the reason."""
    with project.stage("photographs") as stage:
        scenes = find_scenes(inputs)
        found = find_photos(inputs, leave=scenes.files, progress=progress)
        if positions is not None:
            placed, told = with_positions(found.photos, positions)
            found = replace(found, photos=placed, remarks=(*found.remarks, *told))
        refused = [(p.name, r) for p, r in found.refused]
        _check_number(inputs, found.photos, len(scenes.scenes), [*refused, *scenes.refused])
        stage.from_cache = False
        stage.key = key_of("photographs", [p.sha256 for p in found.photos], [s.sha256 for s in scenes.scenes])
        stage.summary = f"{len(found.photos)} photographs, {len(refused)} refused"
        if scenes.scenes or scenes.refused:
            stage.summary += f"; {len(scenes.scenes)} scenes, {len(scenes.refused)} refused"
    return found, scenes, refused


def _adjusted(
    stage: Stage, placed: Georeferenced, apart: Sequence[Georeferenced], groups: Sequence[CameraGroup], jobs: int,
    progress: Progress, remarks: Sequence[str],
) -> tuple[Adjustment, tuple[Part, ...]]:  # fmt: skip
    """The final adjustments of what is placed together and of the parts that nothing joins to it."""
    if apart:
        told = apart_notice(placed.block, apart, [part_folder(k) for k in range(len(apart))])
        placed = replace(placed, notices=(told, *placed.notices))
    adjustment = final_adjustment(placed, groups, jobs, progress, remarks)
    parts = tuple(adjusted_part(p, groups, jobs, progress) for p in apart)
    stage.from_cache = False
    stage.summary = f"sigma0 {adjustment.sigma0:.3f}"
    return adjustment, parts


def _check_number(
    inputs: Sequence[Path], photos: Sequence[Photo], scenes: int, refused: Sequence[tuple[str, str]]
) -> None:
    """Raise InputError where there are neither two photographs nor a scene."""
    if len(photos) >= 2 or scenes >= 2 or (scenes and photos):
        return
    if not scenes:
        raise _too_few(inputs, photos, refused)
    lines = ["1 satellite scene and no photograph; at least 2 images of the same ground are needed"]
    lines += [f"  {name}: {reason}" for name, reason in refused[:20]]
    raise InputError("\n".join(lines), file=", ".join(str(p) for p in inputs))


def _too_few(inputs: Sequence[Path], photos: Sequence[Photo], refused: Sequence[tuple[str, str]]) -> InputError:
    lines = [f"{len(photos)} usable photograph{'' if len(photos) == 1 else 's'}, at least 2 are needed"]
    lines += [f"  {name}: {reason}" for name, reason in refused[:20]]
    if len(refused) > 20:
        lines.append(f"  and {len(refused) - 20} more")
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


def _positions(photos: Sequence[Photo]) -> Array | None:
    """(n, 3) rough metres by GPS for the choice of pairs; None where fewer than two photographs have any."""
    result = np.full((len(photos), 3), np.nan)
    for i, photo in enumerate(photos):
        gps = photo.metadata.gps
        if gps is not None:
            result[i] = gps.latitude_deg, gps.longitude_deg, gps.altitude_m or 0.0
    known = np.isfinite(result[:, 0])
    if known.sum() < 2:
        return None
    result[:, 1] *= np.cos(np.radians(np.nanmean(result[:, 0])))
    result[:, :2] *= 111_000
    return result[:, [1, 0, 2]]


def _cameras(groups: Sequence[CameraGroup], count: int) -> tuple[tuple[Camera, ...], Index]:
    cameras: list[Camera] = []
    of_photo = np.zeros(count, np.int32)
    for k, group in enumerate(groups):
        camera = camera_of(group)
        cameras.append(camera if group.stored is not None else replace(camera, estimate="auto"))
        of_photo[list(group.photos)] = k
    return tuple(cameras), of_photo


def _start(
    project: Project,
    stage: Stage,
    name: str,
    photos: Sequence[Photo],
    groups: Sequence[CameraGroup],
    pairs: Sequence[VerifiedPair],
    store: FeatureStore,
    method: Literal["auto", "growing", "averaging"],
    jobs: int,
    progress: Progress,
) -> tuple[TieBlock, ...]:
    cameras, of_photo = _cameras(groups, len(photos))
    # names are part of the block
    stage.key = key_of(
        "start", START, method, store.keys, [(p.first, p.second) for p in pairs], [p.name for p in photos],
        [asdict(c) for c in cameras], of_photo,
    )  # fmt: skip
    kept = project.load(stage.key)
    if kept is not None:
        ties = tuple(_tie_of_arrays(a) for a in _unpacked(kept))
    else:
        stage.from_cache = False
        features = [store.places(i) for i in range(len(photos))]
        tracks = tracks_of(trusted(pairs, len(photos)), [f.xy_px for f in features])
        raw = block_of_tracks(name, photos, cameras, of_photo, [f.xy_px for f in features], tracks)
        scale, angle = np.empty(len(tracks.image)), np.empty(len(tracks.image))
        for i, f in enumerate(features):
            mine = tracks.image == i
            scale[mine], angle[mine] = f.scale_px[tracks.feature[mine]], f.angle[tracks.feature[mine]]
        ties = start_parts(raw, scale, angle, jobs, progress, method)
        project.store(stage.key, _packed([_arrays_of_tie(t) for t in ties]))
    oriented = sum(int(t.block.images.oriented.sum()) for t in ties)
    split = f" in {len(ties)} parts" if len(ties) > 1 else ""
    points = sum(len(t.block.points) for t in ties)
    stage.summary = f"{oriented} of {len(photos)} photographs{split}, {points} points"
    return ties


def _arrays_of_tie(tie: TieBlock) -> dict[str, Array]:
    lost = tie.not_oriented
    return {
        **arrays_of_block(tie.block), "scale_px": tie.scale_px, "angle": tie.angle,
        "lost": np.array([n for n, _ in lost], dtype=np.str_),
        "reasons": np.array([r for _, r in lost], dtype=np.str_),
    }  # fmt: skip


def _tie_of_arrays(a: dict[str, Array]) -> TieBlock:
    lost = tuple(zip(a["lost"].tolist(), a["reasons"].tolist(), strict=True))
    return TieBlock(block=block_of_arrays(a), scale_px=a["scale_px"], angle=a["angle"], not_oriented=lost)


def _packed(parts: Sequence[dict[str, Array]]) -> dict[str, Array]:
    """The arrays of some parts under names of their own."""
    return {f"{k}:{name}": values for k, part in enumerate(parts) for name, values in part.items()}


def _unpacked(arrays: Mapping[str, Array]) -> list[dict[str, Array]]:
    found: dict[int, dict[str, Array]] = {}
    for key, values in arrays.items():
        k, name = key.split(":", 1)
        found.setdefault(int(k), {})[name] = values
    return [found[k] for k in sorted(found)]


def _precision(
    project: Project,
    stage: Stage,
    ties: Sequence[TieBlock],
    photos: Sequence[Photo],
    options: OrientOptions,
    jobs: int,
    progress: Progress,
) -> tuple[list[Block], list[Weights]]:
    stage.key = key_of("precision", PRECISION, *((arrays_of_block(t.block), t.scale_px, t.angle) for t in ties))
    kept = project.load(stage.key)
    if kept is None:
        stage.from_cache = False
        cache = _GreyCache(photos, options.memory_gb)
        arrays: list[dict[str, Array]] = []
        for tie in ties:
            precise: PreciseBlock = refine(tie, cache.of, jobs, progress)
            w = precise.weights
            arrays.append(
                {
                    **arrays_of_block(precise.block),
                    "weights": np.array([w.factor, w.floor_px2, w.reference_px2]),
                    "counts": np.array([precise.offered, precise.measured, precise.added]),
                }
            )
        kept = _packed(arrays)
        project.store(stage.key, kept)
    parts = _unpacked(kept)
    blocks = [block_of_arrays(a) for a in parts]
    weights = [Weights(factor=w[0], floor_px2=w[1], reference_px2=w[2]) for w in (a["weights"].tolist() for a in parts)]
    offered, measured, added = np.sum([a["counts"] for a in parts], axis=0).tolist()
    used = sum(len(b.observations) for b in blocks)
    stage.summary = f"{measured} of {offered} features measured again, {added} rays added, {used} used"
    return blocks, weights


class _GreyCache:
    """Smoothed photographs, the latest used ones within a limit of memory."""

    def __init__(self, photos: Sequence[Photo], limit_gb: float) -> None:
        self.photos = photos
        self.limit = limit_gb * 1e9
        self.held: OrderedDict[int, Array] = OrderedDict()
        self.lock = Lock()

    def of(self, i: int) -> Array:
        """Photograph i, (h, w) uint16."""
        with self.lock:
            if i in self.held:
                self.held.move_to_end(i)
                return self.held[i]
        image = smoothed(grey_of(self.photos[i]))
        with self.lock:
            self.held[i] = image
            while len(self.held) > 2 and sum(a.nbytes for a in self.held.values()) > self.limit:
                self.held.popitem(last=False)
        return image


def part_folder(k: int) -> str:
    """Folder of the result of the k-th further part."""
    return f"result-{k + 2}"
