"""Stage: maps against each other; each reference gives the cloud those points that it knows best."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.evaluation.queries import joint_orientation
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.io.block.arrays import block_of_arrays
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means, Stage
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.surfaces.depths.depth_map import DepthMap, doubtful_of
from raybundle.surfaces.depths.fusion import MapView, agreement, by_contrast
from raybundle.surfaces.depths.normals import planes_at
from raybundle.surfaces.depths.orientation import CommonRoot, ShiftCovariance, shift_covariance
from raybundle.surfaces.depths.pairs import Sources
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid, used_sources
from raybundle.surfaces.depths.transfer import Box, Projection, Transfer, places_in
from raybundle.surfaces.heights.heights import between_two
from raybundle.surfaces.region import SurfaceRegion
from raybundle.surfaces.state import SURFACE, Cloud
from raybundle.surfaces.tasks import (
    TOGETHER,
    adjustment_key,
    all_done,
    colours_of,
    stored_part,
    stored_together,
)

VERSION = 8
SHIFTS, SIGMA, CLOUD = "surface shifts", "surface sigma", "surface points"
"""First words of the keys of what is kept"""
MOST_MAPS = 8
"""Maps that a map is compared with, those that share most tie points: more cost time and confirm no better."""
PROBES = 200
"""Places at which it is seen by how much orientation lets two maps differ."""
CONFIRMED = 0.5
"""Share of its depths that other maps confirm below which a map has found chance likenesses, and none is given."""
CHUNK = 200_000
"""Points whose covariances are made at once."""
PIXEL_S = 4e-6
"""CPU seconds of a pixel and map, for the order and the time that is left."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the cloud depends on."""

    adjustment: Adjustment
    photos: Mapping[int, Photo]
    chosen: tuple[Sources, ...]
    maps: Mapping[int, str]
    region: SurfaceRegion | None


@dataclass(frozen=True, slots=True, kw_only=True)
class SigmaTask:
    """The standard deviations of a map, all parts together."""

    map: str
    shifts: str


@dataclass(frozen=True, slots=True, kw_only=True)
class CloudTask:
    """What a reference gives to the cloud."""

    block: str
    """key of the part of the block with its image and those of the maps it is compared with"""
    photo: Photo
    image: int
    """its number in the block"""
    own: int
    """its row in the part"""
    others: tuple[int, ...]
    maps: tuple[str, ...]
    """keys of its map and of the others'"""
    sigmas: tuple[str, ...]
    shifts: tuple[str, ...]
    """of how orientation moves its map and the others'"""
    together: str
    correlations: tuple[float, ...]
    """of noise and roughness of the others' maps with those of its own"""
    region: SurfaceRegion | None = None
    """of which points are given; None: all"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Fused:
    """Keys by reference."""

    clouds: Mapping[int, str]
    """what it gives to the cloud"""
    shifts: Mapping[int, str]
    """how orientation moves what it shows"""
    sigmas: Mapping[int, str]
    """standard deviations of its map, all parts together"""


def fuse(i: Inputs, means: Means) -> Fused:
    """What each reference gives to the cloud."""
    of = {s.reference: s for s in i.chosen if s.reference in i.maps}
    shifts, sigma = dict[int, str](), list[Task]()
    about = adjustment_key(i.adjustment)
    for k, s in of.items():
        low, high = means.store.wanted(i.maps[k], ("t_range",))["t_range"].tolist()
        shifts[k] = _shifts(means, i.adjustment, about, s, (low, high))
        sigma.append(
            Task(
                key=key_of(SIGMA, VERSION, i.maps[k], shifts[k]), function=f"{__name__}:sigma_of",
                options=SigmaTask(map=i.maps[k], shifts=shifts[k]), inputs=(i.maps[k], shifts[k]),
                name=i.adjustment.adjusted.images.ids[k],
            )
        )  # fmt: skip
    all_done(means, sigma, "standard deviations of depths")
    sigmas = {k: t.key for k, t in zip(of, sigma, strict=True)}
    together = stored_together(i.adjustment, i.chosen, list(of), means, about)
    tasks = [_task(i, means, of[k], of, (shifts, sigmas, together)) for k in of]
    all_done(means, tasks, "maps against each other")
    return Fused(clouds={k: t.key for k, t in zip(of, tasks, strict=True)}, shifts=shifts, sigmas=sigmas)


def _shifts(means: Means, adjustment: Adjustment, about: str, s: Sources, t_range: tuple[float, float]) -> str:
    """The key of how sources and rays of a reference shift together; made where it is not kept.

    about  the key of the adjustment
    """
    key = key_of(SHIFTS, VERSION, about, s.reference, s.sources, t_range)
    if not means.store.has(key):
        joint = joint_orientation(adjustment, (s.reference, *s.sources))
        made = shift_covariance(adjustment.adjusted, joint, s.reference, s.sources, t_range)
        means.store.store(key, made.as_arrays())
    return key


def _task(
    i: Inputs, means: Means, s: Sources, of: Mapping[int, Sources],
    keys: tuple[Mapping[int, str], Mapping[int, str], str],
) -> Task:  # fmt: skip
    """The task of a reference.

    keys  of how orientation moves the maps, of their standard deviations, of the errors behind all orientations
    """
    shifts, sigmas, together = keys
    block, k = i.adjustment.adjusted, s.reference
    pairs = sorted((p for p in s.pairs if p.source in i.maps), key=lambda p: (-p.points, p.source))
    best = sorted(pairs[:MOST_MAPS], key=lambda p: p.source)
    others = [p.source for p in best]
    correlations = tuple(round(between_two(s, of[p.source], p.angle_deg), 3) for p in best)
    images = sorted([k, *others])
    own = stored_part(block, images, means.store)
    place = {image: n for n, image in enumerate(images)}
    maps, sigma, moved = (tuple(keys[j] for j in (k, *others)) for keys in (i.maps, sigmas, shifts))
    options = CloudTask(
        block=own, photo=i.photos[k], image=k, own=place[k], others=tuple(place[j] for j in others), maps=maps,
        sigmas=sigma, shifts=moved, together=together, correlations=correlations, region=i.region,
    )  # fmt: skip
    part = [] if i.region is None else [i.region]
    return Task(
        key=key_of(CLOUD, VERSION, own, i.photos[k].content, k, maps, sigma, moved, together, correlations, *part),
        function=f"{__name__}:cloud_of", options=options, inputs=(own, *maps, *sigma, *moved, together),
        name=block.images.ids[k],
        cost=(1 + len(others)) * i.photos[k].width_px * i.photos[k].height_px * PIXEL_S,
    )  # fmt: skip


def sigma_of(store: Folder, task: SigmaTask) -> Product:
    """The task: standard deviations (rows, columns) of the depth parameter, all parts together."""
    found = DepthMap.of_arrays(store.wanted(task.map))
    shifts = ShiftCovariance.of_arrays(store.wanted(task.shifts))
    return {"sigma": np.sqrt(found.variance(shifts)).astype(np.float32)}


def cloud_of(store: Folder, task: CloudTask) -> Product:
    """The task: the points of a reference that other maps confirm and none knows better."""
    block = block_of_arrays(store.wanted(task.block))
    kept = store.wanted(task.maps[0])
    found = DepthMap.of_arrays(kept)
    mine = _view(block, task.own, kept, store.wanted(task.sigmas[0])["sigma"])
    known = np.isfinite(mine.t)
    if not task.others or not known.any():
        none = _cloud(store, task, block, found, mine, np.zeros(0, int), (np.zeros(0, np.uint8), np.ones(0)))
        return {**none, **_counts(int(known.sum()), 0.0)}
    between = float(np.nanmin(mine.t)), float(np.nanmax(mine.t)) * (1 + 1e-6)
    box = None if task.region is None else _around(mine, known)
    tables = [places_in(block, mine.rays, j, between, box) for j in task.others]
    probes = _Probes.of(store, task, found, mine)
    agreed = agreement(mine, _others(store, task, block, probes, tables), tables, task.others, own=task.own)
    inside = np.ones(len(agreed.agree), bool)
    if task.region is not None:
        inside = task.region.holds(mine.rays.points(mine.grid.xy_px[known], np.asarray(mine.t, float)[known]))
    share = agreed.confirmed(inside)
    given = agreed.kept & inside & (share >= CONFIRMED)
    more = by_contrast(agreed.scatter, np.asarray(found.contrast)[known])[given]
    cloud = _cloud(store, task, block, found, mine, np.flatnonzero(known)[given], (agreed.confirming[given], more))
    return {**cloud, **_counts(int(inside.sum()), share)}


def _around(view: MapView, known: Mask) -> Box:
    """What of the reference's format the pixels of its map lie in that have a depth."""
    xy = view.grid.xy_px[known]
    (left, top), (right, bottom) = (xy.min(axis=0) - 1).tolist(), (xy.max(axis=0) + 1).tolist()
    return left, top, right, bottom


def _counts(depths: int, share: float) -> Product:
    """What is kept beside the points: depths in what is asked for, and the share of them that other maps confirm."""
    return {"depths": np.array(depths), "share": np.array(share)}


def _view(block: Block, image: int, kept: Product, whole: Array) -> MapView:
    """A map as others look into it."""
    return MapView(
        rays=ReferenceRays.of(block, image), grid=PixelGrid.of_numbers(kept["grid"]), t=kept["t"],
        slopes=kept["slopes"], sigma=np.sqrt(kept["noise"] + kept["roughness"]), doubtful=doubtful_of(kept["flags"]),
        whole=whole,
    )  # fmt: skip


def _others(
    store: Folder, task: CloudTask, block: Block, own: _Probes, tables: Sequence[Transfer | Projection]
) -> Iterator[MapView]:
    """The maps that a reference is compared with, one after the other."""
    for k, (j, table) in enumerate(zip(task.others, tables, strict=True), 1):
        kept = store.lent(task.maps[k], ("grid", "t", "slopes", "noise", "roughness", "shift", "flags"))
        view = _view(block, j, kept, store.wanted(task.sigmas[k])["sigma"])
        shifts = ShiftCovariance.of_arrays(store.wanted(task.shifts[k])).among(own.together)
        apart, correlation = own.apart(view, kept["shift"], shifts, table), task.correlations[k - 1]
        yield replace(view, apart=apart, correlation=correlation)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Probes:
    """Some points of a map, at which it is seen by how much orientation lets another map differ."""

    together: CommonRoot
    xy_px: Array
    t: Array
    normal: Array
    """(n, 3)"""
    moved: Array
    """(n, 3, q) with each independent error of orientation"""

    @classmethod
    def of(cls, store: Folder, task: CloudTask, found: DepthMap, mine: MapView) -> _Probes:
        together = CommonRoot.of_arrays(store.wanted(task.together))
        shifts = ShiftCovariance.of_arrays(store.wanted(task.shifts[0])).among(together)
        known = np.flatnonzero(np.isfinite(mine.t))
        at = known[np.unique(np.linspace(0, len(known) - 1, PROBES).astype(int))]
        xy, t = mine.grid.xy_px.reshape(-1, 2)[at], np.asarray(mine.t, float).ravel()[at]
        normal, _ = planes_at(mine.rays, xy, t, found.smooth_slopes().reshape(2, -1)[:, at].astype(float))
        return cls(together=together, xy_px=xy, t=t, normal=normal, moved=_moved(shifts, mine, found.shift, at))

    def apart(self, view: MapView, shift: Array, shifts: ShiftCovariance, table: Transfer | Projection) -> float:
        """By how much orientation lets the depth parameter of another map differ: the median over the points."""
        there = view.nearest(table.at(self.xy_px, self.t))
        both = np.flatnonzero((there >= 0) & np.isfinite(view.t.ravel()[there]))
        if not len(both):
            return 0.0
        place, n = there[both], self.normal[both]
        by = np.abs((n * view.rays.by_t(view.grid.xy_px.reshape(-1, 2)[place], view.t.ravel()[place])).sum(axis=1))
        off = np.einsum("ni,niq->nq", n, self.moved[both] - _moved(shifts, view, shift, place))
        return float(np.median(np.linalg.norm(off, axis=1) / by))


def _moved(shifts: ShiftCovariance, view: MapView, shift: Array, at: Index) -> Array:
    """How the points of a map at some of its pixels move (n, 3, q) with each independent error of orientation."""
    xy, t = view.grid.xy_px.reshape(-1, 2)[at], np.asarray(view.t, float).ravel()[at]
    return shifts.moved(xy, t, shift.reshape(-1, shift.shape[2], 2)[at], view.rays.by_t(xy, t))


def _cloud(
    store: Folder, task: CloudTask, block: Block, found: DepthMap, mine: MapView, at: Array, by: tuple[Array, Array]
) -> Product:  # fmt: skip
    """Points of a map by their places in it.

    by  (n,) other maps that confirm each; factors of its variance by noise and roughness
    """
    confirmed, more = by
    xy, t = mine.grid.xy_px.reshape(-1, 2)[at], np.asarray(found.t, float).ravel()[at]
    by_t, xyz = mine.rays.by_t(xy, t), mine.rays.points(xy, t)
    length = np.linalg.norm(by_t, axis=1)
    normal, area = planes_at(mine.rays, xy, t, found.smooth_slopes().reshape(2, -1)[:, at].astype(float))
    shifts = ShiftCovariance.of_arrays(store.wanted(task.shifts[0]))
    sensitivity = found.shift.reshape(-1, found.shift.shape[2], 2)[at]
    noise, rough = (more * np.asarray(v, float).ravel()[at] for v in (found.noise, found.roughness))
    rough += np.asarray(found.step, float).ravel()[at]
    sigma, along, across = np.zeros((len(at), 3)), np.zeros(len(at)), np.zeros((len(at), 2))
    for begin in range(0, len(at), CHUNK):
        part = slice(begin, begin + CHUNK)
        C = shifts.of_points(xy[part], t[part], sensitivity[part], by_t[part])
        own = (noise + rough)[part, None] * by_t[part] ** 2
        sigma[part] = np.sqrt(np.diagonal(C, axis1=1, axis2=2) + own)
        along[part] = np.sqrt(shifts.of_depths(xy[part], t[part], sensitivity[part]))
        n = normal[part]
        towards = (n * by_t[part]).sum(axis=1) ** 2
        across[part] = np.stack([(noise + rough)[part] * towards, np.einsum("ni,nij,nj->n", n, C, n)], axis=1)
    used = used_sources(found.views.ravel()[at], found.shift.shape[2])
    pixels, _ = colours_of(task.photo, block, task.own)
    colour = pixels[np.floor(xy[:, 1]).astype(int), np.floor(xy[:, 0]).astype(int)]
    parts = np.stack([np.sqrt(noise) * length, np.sqrt(rough) * length, along * length], axis=1)
    return Cloud(
        xyz=xyz, sigma=sigma.astype(np.float32), parts=parts.astype(np.float32),
        views=(1 + used.sum(axis=1)).astype(np.uint8), confirmed=confirmed.astype(np.uint8),
        incidence=np.asarray(found.incidence, np.float32).ravel()[at], colour=colour,
        image=np.full(len(at), task.image, np.int32), normal=normal.astype(np.float32),
        across=np.sqrt(np.maximum(across, 0.0)).astype(np.float32), size=np.sqrt(area).astype(np.float32),
        place=at.astype(np.int64),
    ).as_arrays()  # fmt: skip


STAGE = SURFACE.register(
    Stage(
        name="fusion", after=("depth maps",), function=fuse, kinds=(SHIFTS, SIGMA, TOGETHER, CLOUD),
        put=lambda s, found: replace(s, clouds=found.clouds, shifts=found.shifts, sigmas=found.sigmas),
        inputs=lambda s: Inputs(
            adjustment=s.adjustment, photos=s.photos, chosen=s.chosen, maps=s.maps, region=s.options.region
        ),
    )
)  # fmt: skip
