"""The part of a run that belongs to photographs, stage by stage beside the satellite scenes."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from threading import Lock
from typing import Literal

import numpy as np

from raybundle.adjustment.result import Notice
from raybundle.adjustment.severity import Severity
from raybundle.block import Block, Camera
from raybundle.errors import NoOrientation
from raybundle.io.block_arrays import arrays_of_block, block_of_arrays
from raybundle.io.camera_library import with_library
from raybundle.io.photos.cameras import CameraGroup, camera_groups, camera_of, with_what_is_known
from raybundle.io.photos.masks import Masks, find_masks
from raybundle.io.photos.photo import Photo
from raybundle.io.project import Project, Stage, key_of
from raybundle.matching.features import FeatureMethod
from raybundle.matching.reduced import LONGEST_PX, WORTH, Reduced, reduction
from raybundle.matching.refine import pyramid, smoothed
from raybundle.matching.tracks import Tracks
from raybundle.matching.verify import VerifiedPair, trusted
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.counting import counted
from raybundle.numerics.progress import Progress
from raybundle.workflows.dropped import Dropped
from raybundle.workflows.missing import missing_notices
from raybundle.workflows.parts import start_parts
from raybundle.workflows.precise import PreciseBlock, Visible, Weights, refine
from raybundle.workflows.repeated import sound_pairs
from raybundle.workflows.same_picture import same_picture_notice, same_pictures
from raybundle.workflows.static_background import FEWEST_PHOTOGRAPHS, RING_PX, static_background
from raybundle.workflows.tie_block import TieBlock, block_of_tracks
from raybundle.workflows.tie_points import FeatureStore, find_features, grey_of, match_pairs, pairs_of
from raybundle.workflows.tie_start import LEFT

START, PRECISION = 15, 22
"""Versions of the stages' results."""
ALONE = "one photograph alone cannot be oriented; at least 2 are needed"


@dataclass(slots=True)
class PhotoRun:
    """The photographs of a project on their way to a block."""

    photos: tuple[Photo, ...]
    jobs: int
    progress: Progress
    refused: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    lost: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    """Photographs that take no part, and why"""
    store: FeatureStore | None = None
    groups: tuple[CameraGroup, ...] = ()
    pairs: list[VerifiedPair] = field(default_factory=list[VerifiedPair])
    repeats: dict[int, int] = field(default_factory=dict[int, int])
    """Photographs that show the same picture as another"""
    ties: tuple[TieBlock, ...] = ()
    blocks: list[Block] = field(default_factory=list[Block])
    weights: list[Weights] = field(default_factory=list[Weights])
    told: list[str] = field(default_factory=list[str])
    """what the result is to say of the photographs"""
    notices: list[Notice] = field(default_factory=list[Notice])
    """the same with a code of its own"""
    given_notices: tuple[Notice, ...] = ()
    """those of what was given, before anything was matched"""
    masks: Masks | None = None
    dropped: Dropped | None = None
    """how many features came how far"""

    def masked(self, folder: Path | None) -> None:
        """The masks of the photographs, where a folder of them is given."""
        if folder is not None and self.photos:
            self.masks = find_masks(folder, self.photos)
            self.notices += mask_notices(self.masks)

    def features(self, project: Project, stage: Stage, method: FeatureMethod, most: int) -> None:
        """Features of the photographs."""
        self.store, failed = find_features(
            project, stage, self.photos, method, most, self.jobs, self.progress, self.masks
        )
        if failed:
            self.refused += [(self.photos[i].name, reason) for i, reason in failed.items()]
            kept = [i for i in range(len(self.photos)) if i not in failed]
            self.photos = tuple(self.photos[i] for i in kept)
            self.store = FeatureStore(project, tuple(self.store.keys[i] for i in kept))

    def cameras(self, calibration: Sequence[Camera], separate: Sequence[str], library: Path | None) -> None:
        """Which photographs are of one camera; one photograph alone takes no part."""
        if len(self.photos) < 2:
            self.lost = [(p.name, ALONE) for p in self.photos]
            self.photos = ()
            self.groups = camera_groups((), calibration, separate) if calibration else ()
            return
        self.groups = camera_groups(self.photos, calibration, separate)
        if library is not None:
            self.groups = with_library(self.photos, self.groups, library)

    def matching(self, project: Project, stage: Stage, method: FeatureMethod) -> None:
        """Pairs of photographs."""
        assert self.store is not None
        self.given_notices = tuple(self.notices)
        if self.photos:
            chosen = pairs_of(self.photos, self.store, method, _positions(self.photos), self.progress)
            try:
                self.pairs = match_pairs(
                    project, stage, self.photos, self.store, method, chosen, self.jobs, self.progress
                )
            except NoOrientation as error:
                still = static_background(self.photos, self.store, method)
                if still is None:
                    raise
                told = still.notice(masked=self.masks is not None).message
                raise NoOrientation(
                    f"{error}\n  Or: {told}", images=error.images, undetermined=error.undetermined
                ) from error
            if _stands_still(self.pairs):
                still = static_background(self.photos, self.store, method)
                self.notices += [] if still is None else [still.notice(masked=self.masks is not None)]
            self._without_repeats(method)

    def _without_repeats(self, method: FeatureMethod) -> None:
        """Leave what repeats another photograph without matches."""
        assert self.store is not None
        self.repeats = same_pictures(self.pairs, self.photos, self.store, method)
        if self.repeats:
            self.notices.append(same_picture_notice(self.repeats, self.photos))
            self.pairs = [
                replace(p, matches=p.matches[:0]) if {p.first, p.second} & self.repeats.keys() else p
                for p in self.pairs
            ]

    def start(self, project: Project, stage: Stage, name: str, method: Literal["auto", "growing", "averaging"]) -> None:
        """Approximate values of every part."""
        assert self.store is not None
        if self.photos:
            self.ties, self.dropped, told = _start(
                project, stage, name, self.photos, self.groups, self.pairs, self.store, method, self.jobs, self.progress
            )
            self.notices += told
            same = {self.photos[i].name: f"the same picture as {self.photos[k].name}" for i, k in self.repeats.items()}
            self.lost = [(name, same.get(name, why)) for name, why in self.ties[0].not_oriented]
            self.blocks = [tie.block for tie in self.ties]

    def searched_again(
        self, project: Project, name: str, start: Literal["auto", "growing", "averaging"], method: FeatureMethod,
        most: int,
    ) -> PhotoRun:  # fmt: skip
        """This run, or one with features of reduced copies, where this start leaves photographs and that leaves fewer.

        Photographs that are soft, noisy or heavily compressed tell nothing at the size of their pixels.
        """
        oriented = self._oriented()
        large = [reduction(p.width_px, p.height_px) >= WORTH for p in self.photos]
        if isinstance(method, Reduced) or oriented >= (1 - LEFT) * len(self.photos) or not all(large):
            return self
        coarse, other = Reduced(method), replace(self, refused=list(self.refused), notices=list(self.given_notices))
        try:
            with project.stage("features") as stage:
                other.features(project, stage, coarse, most)
            if len(other.photos) < len(self.photos):
                return self
            with project.stage("matching") as stage:
                other.matching(project, stage, coarse)
            with project.stage("start") as stage:
                other.start(project, stage, name, start)
        except NoOrientation:
            return self
        if other._oriented() <= oriented:  # noqa: SLF001  (the same class)
            return self
        message = (
            f"features are those of copies of {LONGEST_PX} px: {other._oriented()} of {len(self.photos)} photographs "  # noqa: SLF001
            f"hang together by them, {oriented} by features of the whole size. These photographs tell little at the "
            "size of their pixels (soft, noisy or heavily compressed)"
        )
        other.notices.append(Notice(code="reduced_features", message=message))
        return other

    def _oriented(self) -> int:
        """Photographs of the largest part."""
        return int(self.ties[0].block.images.oriented.sum()) if self.ties else 0

    def precision(self, project: Project, stage: Stage, memory_gb: float) -> None:
        """Least-squares matching of their tie points."""
        if self.photos:
            found = _precision(project, stage, self.ties, self.photos, memory_gb, self.jobs, self.progress, self.masks)
            self.blocks, self.weights = found.blocks, found.weights
            if self.dropped is not None:
                self.dropped = replace(
                    self.dropped, measured=found.measured, added=found.added, features_kept=found.features_kept,
                    adjusted=sum(len(b.observations) for b in self.blocks),
                )  # fmt: skip
            self.lost += found.left_out
            if found.by_features:
                self.told.append(_by_features_words(found.by_features))


def _by_features_words(names: Sequence[str]) -> str:
    shown = ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")
    one = len(names) == 1
    return (
        f"{shown} keep{'s' * one} the positions of {'its' if one else 'their'} features, with a standard deviation of "
        "their own: least-squares matching measures too few of the points there (a soft or very different photograph)"
    )


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
        if group.stored is None:
            camera = with_what_is_known(replace(camera, estimate="auto"), group)
        cameras.append(camera)
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
) -> tuple[tuple[TieBlock, ...], Dropped, tuple[Notice, ...]]:
    cameras, of_photo = _cameras(groups, len(photos))
    # names are part of the block
    stage.key = key_of(
        "start", START, method, store.keys, [(p.first, p.second, len(p.matches)) for p in pairs],
        [p.name for p in photos], [asdict(c) for c in cameras], of_photo,
    )  # fmt: skip
    kept = project.load(stage.key)
    if kept is not None:
        told = _notices_of_arrays(kept)
        parts = _unpacked(kept)
        ties = tuple(_tie_of_arrays(a) for a in parts)
        counts = parts[0]["raw_counts"]
    else:
        stage.from_cache = False
        features = [store.places(i) for i in range(len(photos))]
        places = [f.xy_px for f in features]

        def oriented_by(tracks: Tracks) -> tuple[TieBlock, ...]:
            raw = block_of_tracks(name, photos, cameras, of_photo, places, tracks)
            scale, angle = np.empty(len(tracks.image)), np.empty(len(tracks.image))
            for i, f in enumerate(features):
                mine = tracks.image == i
                scale[mine], angle[mine] = f.scale_px[tracks.feature[mine]], f.angle[tracks.feature[mine]]
            return start_parts(raw, scale, angle, jobs, progress, method)

        diagonals = np.array([float(np.hypot(p.width_px, p.height_px)) for p in photos])
        sound = sound_pairs(trusted(pairs, len(photos)), places, [p.name for p in photos], diagonals, oriented_by)
        ties, told = oriented_by(sound.tracks), sound.notices
        counts = np.array([sum(len(f) for f in features), len(sound.tracks.image)])
        packed = _packed([{**_arrays_of_tie(t), "raw_counts": counts} for t in ties])
        project.store(stage.key, {**packed, **_arrays_of_notices(told)})
    told = (*told, *(n for t in ties for n in missing_notices(t.block)))
    oriented = sum(int(t.block.images.oriented.sum()) for t in ties)
    split = f" in {len(ties)} parts" if len(ties) > 1 else ""
    points = sum(len(t.block.points) for t in ties)
    stage.summary = f"{oriented} of {len(photos)} photographs{split}, {points} points"
    started = sum(len(t.block.observations) for t in ties)
    return ties, Dropped(features=int(counts[0]), matched=int(counts[1]), started=started, adjusted=started), told


def _arrays_of_notices(notices: Sequence[Notice]) -> dict[str, Array]:
    rows = [(n.code, n.message, str(n.severity.value)) for n in notices]
    return {"notices": np.array(rows, dtype=np.str_).reshape(-1, 3)}


def _notices_of_arrays(arrays: Mapping[str, Array]) -> tuple[Notice, ...]:
    return tuple(Notice(code=c, message=m, measured=Severity(s)) for c, m, s in arrays["notices"].tolist())


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
        k, _, name = key.partition(":")
        if not name:
            continue
        found.setdefault(int(k), {})[name] = values
    return [found[k] for k in sorted(found)]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Precise:
    blocks: list[Block]
    weights: list[Weights]
    measured: int
    added: int
    features_kept: int
    by_features: list[str]
    left_out: list[tuple[str, str]]


def _precision(
    project: Project,
    stage: Stage,
    ties: Sequence[TieBlock],
    photos: Sequence[Photo],
    memory_gb: float,
    jobs: int,
    progress: Progress,
    masks: Masks | None = None,
) -> _Precise:
    worn = [] if masks is None else [[masks.key(p) for p in photos]]
    stage.key = key_of("precision", PRECISION, *((arrays_of_block(t.block), t.scale_px, t.angle) for t in ties), *worn)
    kept = project.load(stage.key)
    if kept is None:
        stage.from_cache = False
        cache = _GreyCache(photos, memory_gb)
        arrays: list[dict[str, Array]] = []
        for tie in ties:
            precise: PreciseBlock = refine(
                tie, cache.of, jobs, progress, None if masks is None else _visible(masks, photos)
            )
            arrays.append(
                {
                    **arrays_of_block(precise.block),
                    "weights": precise.weights.array(),
                    "counts": np.array([precise.offered, precise.measured, precise.added, precise.features_kept]),
                    "by_features": np.array(precise.by_features, dtype=np.str_),
                    "left_out": np.array(precise.left_out, dtype=np.str_).reshape(-1, 2),
                }
            )
        kept = _packed(arrays)
        project.store(stage.key, kept)
    parts = _unpacked(kept)
    blocks = [block_of_arrays(a) for a in parts]
    weights = [Weights.of(a["weights"]) for a in parts]
    offered, measured, added, features_kept = np.sum([a["counts"] for a in parts], axis=0).tolist()
    used = sum(len(b.observations) for b in blocks)
    stage.summary = f"{measured} of {offered} features measured again, {added} rays added, {used} used"
    return _Precise(
        blocks=blocks,
        weights=weights,
        measured=measured,
        added=added,
        features_kept=features_kept,
        by_features=[n for a in parts for n in a["by_features"].tolist()],
        left_out=[(n, r) for a in parts for n, r in a["left_out"].tolist()],
    )


def _stands_still(pairs: Sequence[VerifiedPair]) -> bool:
    """Whether verified pairs show that something may stand still, so that it is worth while to look."""
    still = (p for p in pairs if len(p.matches) or p.geometry == "watermark")
    return sum(p.displacement_px < RING_PX for p in still) >= FEWEST_PHOTOGRAPHS - 1


def _visible(masks: Masks, photos: Sequence[Photo]) -> Visible:
    """Where the photographs show what may be measured."""

    def visible(image: Index, xy_px: Array, radius_px: Array) -> Mask:
        found = np.ones(len(image), bool)
        for i in np.unique(image):
            rows = np.flatnonzero(image == i)
            found[rows] = masks.visible(photos[i], xy_px[rows], radius_px[rows])
        return found

    return visible


def mask_notices(masks: Masks) -> list[Notice]:
    """What there is to say of masks."""
    n, missing = len(masks.photos), masks.missing
    message = f"{len(masks.files)} of {n} photographs have a mask; features are taken only where it is not black"
    if missing:
        message += f"; {len(missing)} without a mask are used whole ({_first_names(missing)})"
    told = [Notice(code="masks", message=message, ids=missing)]
    if masks.refused:
        names = tuple(name for name, _ in masks.refused)
        first, why = next(iter(masks.refused))
        more = f" and {len(names) - 1} more" if len(names) > 1 else ""
        told.append(Notice(code="mask_refused", message=f"{first}{more} used whole: {why}", ids=names))
    if doubtful := masks.doubtful:
        names = tuple(p.name for p in doubtful)
        kinds = ", ".join(str(o) for o in sorted({p.orientation for p in doubtful}))
        theirs = "its mask is" if len(names) == 1 else f"the masks of these {len(names)} are"
        message = (
            f"{_first_names(names)}: shown turned or mirrored (EXIF orientation {kinds}), and nothing tells whether "
            f"{theirs} so, too. Masks are laid on the pixels as stored, as by COLMAP and Metashape. If they were drawn "
            "over the upright picture they hide the wrong part: turn them back, or save them with EXIF orientation 1"
        )
        told.append(Notice(code="mask_orientation", message=message, ids=names))
    for share, what in ((0.0, "everything: no feature is taken there"), (1.0, "nothing")):
        if names := masks.with_free(share):
            message = (
                f"{_first_names(names)}: the mask of {counted(len(names), 'photograph')} hides {what}. Where every "
                "channel is 0, or alpha that differs from place to place is, a photograph is masked out"
            )
            told.append(Notice(code="mask_uniform", message=message, ids=names))
    return told


def _first_names(names: Sequence[str]) -> str:
    return ", ".join(names[:3]) + (" ..." if len(names) > 3 else "")


class _GreyCache:
    """Smoothed photographs with their pyramids, the latest used ones within a limit of memory."""

    def __init__(self, photos: Sequence[Photo], limit_gb: float) -> None:
        self.photos = photos
        self.limit = limit_gb * 1e9
        self.held: OrderedDict[int, tuple[Array, ...]] = OrderedDict()
        self.lock = Lock()

    def of(self, i: int, level: int) -> Array:
        """Photograph i at a level of its pyramid, uint16."""
        with self.lock:
            if i in self.held:
                self.held.move_to_end(i)
                return self.held[i][level]
        levels = pyramid(smoothed(grey_of(self.photos[i])))
        with self.lock:
            self.held[i] = levels
            while len(self.held) > 2 and sum(a.nbytes for p in self.held.values() for a in p) > self.limit:
                self.held.popitem(last=False)
        return levels[level]
