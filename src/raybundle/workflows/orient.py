"""From photographs to an oriented block with its report: stages that can be stopped and continued at any time."""

from __future__ import annotations

import os
import re
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from threading import Lock
from typing import Literal

import numpy as np

from raybundle.adjustment.decide import decide
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.structure import structure_notice
from raybundle.block import Block, Camera
from raybundle.block.select import with_rows
from raybundle.errors import InputError, NoConvergence, RankDefect
from raybundle.io.block_arrays import arrays_of_block, block_of_arrays
from raybundle.io.camera_library import with_library
from raybundle.io.coordinate_systems import LocalFrame
from raybundle.io.photos.cameras import CameraGroup, camera_groups, camera_of
from raybundle.io.photos.photo import Photo, find_photos
from raybundle.io.project import Project, Stage, StageRecord, key_of
from raybundle.io.trajectories import Trajectory, with_positions
from raybundle.matching.features import feature_method
from raybundle.matching.refine import smoothed
from raybundle.matching.tracks import tracks_of
from raybundle.matching.verify import VerifiedPair, trusted
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.progress import Progress, silent
from raybundle.workflows.georeference import Georeferenced, accuracy, rejected_marks
from raybundle.workflows.marks import Given
from raybundle.workflows.parts import Part, apart_notice, place_parts, start_parts
from raybundle.workflows.tie_block import (
    PreciseBlock,
    TieBlock,
    Weights,
    block_of_tracks,
    flat_points,
    image_sigma_px,
    refine,
)
from raybundle.workflows.tie_points import FeatureStore, find_features, grey_of, match_pairs, pairs_of

START, PRECISION = 7, 15
"""Versions of the stages' results."""
FINAL = 1e-4
"""Last step of the final adjustment, in standard deviations of the unknowns."""
MOST_LEFT = 8
"""Photographs that the final adjustment may leave out one after the other."""
COARSE = 1e-2
"""The same where that is not reached: still far below what a standard deviation can tell."""
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
    remarks: tuple[str, ...] = field(default=())

    @property
    def oriented(self) -> int:
        """Number of photographs with an orientation, in whatever part."""
        return len(self.photos) - len(self.not_oriented)

    def additions(self) -> dict[str, object]:
        """What result.json says beside the adjustment."""
        lost = [{"file": f, "reason": r} for f, r in (*self.refused, *self.not_oriented)]
        return {
            "images": {
                "given": len(self.photos) + len(self.refused),
                "oriented": self.oriented,
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
    """Orient photographs within a project folder; finished stages are taken from there.

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
        with project.stage("photographs") as stage:
            found = find_photos(inputs, progress=progress)
            if positions is not None:
                placed_photos, told = with_positions(found.photos, positions)
                found = replace(found, photos=placed_photos, remarks=(*found.remarks, *told))
            if len(found.photos) < 2:
                raise _too_few(inputs, found.photos, [(p.name, r) for p, r in found.refused])
            stage.from_cache = False
            stage.key = key_of("photographs", [p.sha256 for p in found.photos])
            stage.summary = f"{len(found.photos)} photographs, {len(found.refused)} refused"
        photos, refused = found.photos, [(p.name, r) for p, r in found.refused]
        _forget(project, options)
        with project.stage("features") as stage:
            store, failed = find_features(project, stage, photos, method, options.feature_count, jobs, progress)
        if failed:
            refused += [(photos[i].name, reason) for i, reason in failed.items()]
            kept = [i for i in range(len(photos)) if i not in failed]
            photos = tuple(photos[i] for i in kept)
            store = FeatureStore(project, tuple(store.keys[i] for i in kept))
            if len(photos) < 2:
                raise _too_few(inputs, photos, refused)
        groups = camera_groups(photos, calibration, options.separate)
        if options.library is not None:
            groups = with_library(photos, groups, options.library)
        with project.stage("matching") as stage:
            pairs = match_pairs(
                project, stage, photos, store, method, pairs_of(photos, store, method, _positions(photos), progress),
                jobs, progress,
            )  # fmt: skip
        with project.stage("start") as stage:
            ties = _start(project, stage, folder.name, photos, groups, pairs, store, options.start, jobs, progress)
        weights: list[Weights] = []
        blocks = [tie.block for tie in ties]
        if options.precise:
            with project.stage("precision") as stage:
                blocks, weights = _precision(project, stage, ties, photos, options, jobs, progress)
        with project.stage("adjustment") as stage:
            placed, apart = place_parts(blocks, photos, given or Given())
            if apart:
                told = apart_notice(placed.block, apart, [part_folder(k) for k in range(len(apart))])
                placed = replace(placed, notices=(told, *placed.notices))
            adjustment = _adjust(placed, groups, jobs, progress, found.remarks)
            parts = tuple(_part(p, groups, jobs, progress) for p in apart)
            stage.from_cache = False
            stage.summary = f"sigma0 {adjustment.sigma0:.3f}"
        return Orientation(
            adjustment=adjustment,
            photos=photos,
            groups=groups,
            refused=tuple(refused),
            not_oriented=(*ties[0].not_oriented, *_left_out(adjustment, parts)),
            pairs=tuple(pairs),
            stages=tuple(project.records),
            sigma_px=image_sigma_px(adjustment),
            weights=weights[0] if weights else None,
            frame=placed.frame,
            parts=parts,
            remarks=tuple(found.remarks),
        )
    finally:
        project.close()


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


def _adjust(
    placed: Georeferenced, groups: Sequence[CameraGroup], jobs: int, progress: Progress, remarks: Sequence[str]
) -> Adjustment:
    """The final adjustment: parameters by significance and determinability, blunders by data snooping."""
    notices = [Notice(code="photographs", message=r) for r in remarks]
    notices += [Notice(code="camera", message=f"camera {g.id}: {r}", ids=(g.id,)) for g in groups for r in g.remarks]
    options = AdjustmentOptions(threads=jobs, reject="snooping", tolerance=FINAL)
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


def _left_out(adjustment: Adjustment, parts: Sequence[Part]) -> list[tuple[str, str]]:
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
    s = thin.stations
    stay = ~out[s.image]
    stations = replace(s, image=s.image[stay], xyz=s.xyz[stay], sigma=s.sigma[stay])
    marked = placed.marked[np.isin(block.points.ids, thin.points.ids)]
    return replace(placed, block=replace(thin, images=images, stations=stations), marked=marked)


def part_folder(k: int) -> str:
    """Folder of the result of the k-th further part."""
    return f"result-{k + 2}"


def _part(placed: Georeferenced, groups: Sequence[CameraGroup], jobs: int, progress: Progress) -> Part:
    """The adjustment of a part that nothing joins to the others."""
    images = placed.block.images
    names = tuple(n for n, o in zip(images.ids, images.oriented, strict=True) if o)
    return Part(adjustment=_adjust(placed, groups, jobs, progress, ()), photographs=names)
