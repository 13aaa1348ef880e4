"""The block of satellite scenes: start, precise tie points, control, and the joint with photographs."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.scene_start import with_scene_points
from raybundle.block import Block, Camera, Role
from raybundle.block.select import with_rows
from raybundle.errors import NoOrientation, excluded, message, phrase
from raybundle.io.block.scenes import with_views
from raybundle.matching.refine import LEVELS, halved, match_candidates
from raybundle.matching.tracks import Tracks, tracks_of
from raybundle.numerics.arrays import Array
from raybundle.numerics.places import Local
from raybundle.numerics.progress import Progress
from raybundle.orientation.cleaning import clean
from raybundle.scenes.bias import BiasKind
from raybundle.ties.block import TieBlock, block_of_tracks, flat_points
from raybundle.ties.points import FeatureStore
from raybundle.ties.precise import PreciseBlock, refine
from raybundle.workflows.scenes.geometry import (
    camera_of_scene,
    kind_of_scene,
    middle_of_scene,
)
from raybundle.workflows.scenes.images import SceneImage, ScenePixels
from raybundle.workflows.scenes.ties import ScenePair

if TYPE_CHECKING:
    from raybundle.io.photos.photo import Photo

STRIP, STRIP_EDGE = 2048, 16
"""Rows of a pyramid's level that are made at once, and how far strips overlap [px]."""
FEWEST_POINTS = 6
"""Tie points below which a scene does not hang together with the others."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneSet:
    """The scenes of a project, and what is asked of them."""

    images: tuple[SceneImage, ...]
    place: Local
    bias: BiasKind

    def cameras(self, place: Local | None = None) -> tuple[Camera, ...]:
        """One for each scene."""
        return tuple(camera_of_scene(s, place or self.place, self.bias) for s in self.images)

    @property
    def content(self) -> tuple[object, ...]:
        """What they are known by."""
        return self.bias, self.place, self.images

    def notices(self) -> tuple[Notice, ...]:
        """What is assumed about them."""
        found: dict[str, tuple[Mapping[str, float], list[str]]] = {}
        for s in self.images:
            kind, model = kind_of_scene(s)
            if assumed := kind.assumed(model):
                found.setdefault(assumed[0], (assumed[1], []))[1].append(s.name)
        return tuple(Notice(code=code, values=dict(v), ids=tuple(names)) for code, (v, names) in found.items())


def with_cameras(block: Block, cameras: Sequence[Camera], place: Local) -> Block:
    """A block of scenes with these cameras, in the frame at `place`; what it stood in before is given by its place."""
    centre, rotation, is_scene = with_views(
        block.images.centre, block.images.rotation, tuple(cameras), block.images.camera
    )
    xyz = block.points.xyz
    if block.place is not None:
        xyz = np.full(xyz.shape, np.nan)
        known = np.isfinite(block.points.xyz).all(axis=1)
        xyz[known] = place.block_from_geographic(block.place.geographic_from_block(block.points.xyz[known]))
    return replace(
        block,
        cameras=tuple(cameras),
        place=place,
        images=replace(block.images, centre=centre, rotation=rotation, held=is_scene),
        points=replace(block.points, xyz=xyz),
    )


def plain(block: Block) -> Block:
    """The block without what cannot be kept as arrays: the sensors are made again from the scenes."""
    cameras = tuple(
        c if c.scene is None else replace(c, scene=None, relations=(), calibrated=None) for c in block.cameras
    )
    return replace(block, place=None, cameras=cameras)


def again(block: Block, scenes: SceneSet) -> Block:
    """A kept block with its sensors; adjusted parameters are those that were kept."""
    fresh = scenes.cameras()
    cameras = tuple(replace(c, values=k.values) for c, k in zip(fresh, block.cameras, strict=True))
    return with_cameras(block, cameras, scenes.place)


def started(
    scenes: SceneSet, store: FeatureStore, pairs: Sequence[ScenePair], jobs: int, progress: Progress
) -> TieBlock:
    """Tracks of the scenes with approximate coordinates, wrong ones left out."""
    n = len(scenes.images)
    tracks: Tracks = tracks_of([p.pair for p in pairs], store.xy_px())
    features = store.of_tracks(tracks)
    raw = block_of_tracks(
        cast("Sequence[Photo]", scenes.images), scenes.cameras(), np.arange(n, dtype=np.int32), features.xy_px, tracks
    )
    scale, angle = features.scale_px, features.angle
    seen = np.bincount(tracks.image, minlength=n)
    lost = tuple(
        (s.name, _why_alone(int(count), pairs, i))
        for i, (s, count) in enumerate(zip(scenes.images, seen.tolist(), strict=True))
        if count < FEWEST_POINTS
    )
    if not len(tracks.image):
        return TieBlock(
            block=with_cameras(raw, raw.cameras, scenes.place), scale_px=scale, angle=angle, not_oriented=lost
        )
    block = with_scene_points(with_cameras(raw, raw.cameras, scenes.place))
    free = {c.id: tuple(c.estimate) for c in block.parametrised}
    cleaned = clean(block, AdjustmentOptions(jobs=jobs, statistics=False), free, progress=progress)
    keep = ~cleaned.rejected & ~flat_points(cleaned.block)[cleaned.block.observations.point]
    block = weighed(with_rows(cleaned.block, keep), jobs)
    return TieBlock(block=block, scale_px=scale[keep], angle=angle[keep], not_oriented=lost)


def weighed(block: Block, threads: int) -> Block:
    """The block with image points as precise as their residuals say, so that stated priors keep their weight."""
    if len(block.observations) < FEWEST_POINTS:
        return block
    found = adjust_block(block, AdjustmentOptions(jobs=threads, statistics=False, tolerance=1e-2))
    if not found.sigma0 > 0:
        return block
    o = block.observations
    return replace(block, observations=replace(o, cov_px2=o.cov_px2 * found.sigma0**2))


def _why_alone(count: int, pairs: Sequence[ScenePair], i: int) -> str:
    mine = [p for p in pairs if i in (p.pair.first, p.pair.second)]
    if not mine:
        return phrase("scene.no_common_ground")
    return phrase("scene.few_common_points", n=count, needed=FEWEST_POINTS)


def refined(folder: Path, scenes: SceneSet, tie: TieBlock, jobs: int, progress: Progress) -> PreciseBlock:
    """The tie points measured by least-squares matching; pixels lie in files of this folder while that lasts."""
    (folder / "00").mkdir(parents=True, exist_ok=True)  # where a killed run may leave files: the next one sweeps it
    with tempfile.TemporaryDirectory(prefix=".pixels-", dir=folder / "00") as place:
        held = [_smoothed_files(s, Path(place) / f"{k}") for k, s in enumerate(scenes.images)]
        match = partial(match_candidates, image=lambda i, level: held[i][level], threads=jobs, progress=progress)
        precise = refine(tie, match, jobs, progress)
        del match
        held.clear()
    return replace(precise, block=weighed(precise.block, jobs))


def _smoothed_files(image: SceneImage, path: Path) -> tuple[Array, ...]:
    """The smoothed scene and its pyramid in files that are mapped into memory: only what is looked at is read."""
    target: Any = np.memmap(path, np.uint16, "w+", shape=(image.height_px, image.width_px))
    ScenePixels(image).smooth(target)
    levels = [_as_read(target, path)]
    while len(levels) < LEVELS:
        file = path.with_name(f"{path.name}-{len(levels)}")
        levels.append(_halved_file(levels[-1], file))
    return tuple(levels)


def _halved_file(fine: Array, path: Path) -> Array:
    """The next level of a pyramid, in strips."""
    shape = fine.shape[0] // 2, fine.shape[1] // 2
    if min(shape) == 0:
        return np.zeros(shape, np.uint16)
    target: Any = np.memmap(path, np.uint16, "w+", shape=shape)
    for y in range(0, shape[0], STRIP):
        top, end = max(y - STRIP_EDGE, 0), min(y + STRIP, shape[0])
        part = halved(np.asarray(fine[2 * top : 2 * (end + STRIP_EDGE)]))
        target[y:end] = part[y - top : end - top]
    return _as_read(target, path)


def _as_read(target: Any, path: Path) -> Array:
    """The same file, to be read only."""
    target.flush()
    return np.memmap(path, np.uint16, "r", shape=target.shape)


def joined(scenes: Block, photographs: Block | None) -> Block:
    """One block of scenes and photographs in one frame; points of the same name are one point."""
    if photographs is None:
        return scenes
    a, b = scenes, photographs
    position = {name: k for k, name in enumerate(a.points.ids)}
    shared = np.array([position.get(name, -1) for name in b.points.ids], np.int64)
    special = np.asarray(b.points.role) != Role.TIE
    same = (shared >= 0) & special
    new = np.where(same, shared, len(a.points) + np.cumsum(~same) - 1)
    ids = [f"p{name}" if not s and name in position else name for name, s in zip(b.points.ids, same, strict=True)]
    xyz = a.points.xyz.copy()
    # where a scene sees a point once, the photographs say where it is
    rays = a.ray_count
    for k in np.flatnonzero(same):
        if rays[shared[k]] < 2 and np.isfinite(b.points.xyz[k]).all() and not a.points.is_control[shared[k]].all():
            xyz[shared[k]] = b.points.xyz[k]
    instruments = len(a.instruments) + np.arange(len(b.instruments))
    images = len(a.images) + np.arange(len(b.images))
    return replace(
        b,
        name=a.name,
        place=a.place,
        rejected=(*a.rejected, *b.rejected),
        cameras=(*a.cameras, *b.cameras),
        instruments=(*a.instruments, *b.instruments),
        images=a.images.append(b.images.renumbered("camera", len(a.cameras) + np.arange(len(b.cameras)))),
        observations=a.observations.append(b.observations.renumbered("image", images).renumbered("point", new)),
        points=replace(a.points, xyz=xyz).append(replace(b.points, ids=tuple(ids)).rows(~same)),
        tables=a.tables,
    ).adding(
        *(t.renumbered("point", new).renumbered("image", images).renumbered("instrument", instruments)
          for t in b.tables.values())
    )  # fmt: skip


def refuse_nothing_common(
    scenes: SceneSet, pairs: Sequence[ScenePair], marks: int, photographs: int, refused: Sequence[tuple[str, str]]
) -> None:
    """Raise NoOrientation where scenes have neither tie points nor marks; `refused` files and reasons are reported."""
    if marks or photographs or any(len(p.pair.matches) for p in pairs):
        return
    middles = [(s.name, *middle_of_scene(s)[:2]) for s in scenes.images[:6]]
    places = [message("scene.middle", scene=name, longitude_deg=lon, latitude_deg=lat) for name, lon, lat in middles]
    raise NoOrientation(
        "scene.no_tie_points", n=len(scenes.images), pairs=len(pairs), details=[*places, *excluded(refused, most=10)]
    )
