"""Stage: a depth map of each reference, and what orientation and calibration do to it; each map is a task."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.errors import InputError, message_of_text
from raybundle.io.block.arrays import block_of_arrays
from raybundle.io.photos.framed import in_camera_frame
from raybundle.io.photos.masks import MaskFile, Masks
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Mask
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means, Stage
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.surfaces.depths.depth_map import DepthOptions, by_bands, bytes_needed, depth_map
from raybundle.surfaces.depths.pairs import Sources
from raybundle.surfaces.region import SurfaceRegion
from raybundle.surfaces.state import SURFACE, SurfaceOptions, SurfaceState
from raybundle.surfaces.tasks import PART, free_of, stored_part
from raybundle.ties.points import exact_grey_of

VERSION = 7
OF_PART = 3
"""The same of maps of a region"""
MAP = "depth map"
"""First word of the keys of what is kept"""
PIXEL_S = 2e-5
"""CPU seconds of a pixel of a map, for the order and the time that is left."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What depth maps depend on."""

    adjustment: Adjustment
    photos: Mapping[int, Photo]
    chosen: tuple[Sources, ...]
    shares: Mapping[int, float]
    masks: Masks | None
    options: SurfaceOptions


@dataclass(frozen=True, slots=True, kw_only=True)
class MapTask:
    """The depth map of a reference."""

    block: str
    """key of the part of the block that shows it: its own image and its sources"""
    photos: tuple[Photo, ...]
    """of these, in the order of the part's images"""
    reference: int
    """row of the part's images"""
    sources: tuple[int, ...]
    density: int
    threads: int
    """what is found does not depend on them"""
    memory: float
    masks: tuple[MaskFile | None, ...] = ()
    """of the photographs; (): none has one"""
    region: SurfaceRegion | None = None
    """what alone is measured; None: all"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Maps:
    """Keys of the maps that could be made, and why others could not."""

    keys: Mapping[int, str]
    failed: tuple[tuple[int, str], ...]


def measure(i: Inputs, means: Means) -> Maps:
    """All maps by tasks; raises InputError where none can be made."""
    here = isinstance(means.executor, Threads)
    block = i.adjustment.adjusted
    tasks = list[Task]()
    for s in i.chosen:
        images = np.sort(np.array([s.reference, *s.sources]))
        own = stored_part(block, images.tolist(), means.store)
        place = {int(image): k for k, image in enumerate(images)}
        photos = tuple(i.photos[int(image)] for image in images)
        options = MapTask(
            block=own, photos=photos, reference=place[s.reference], sources=tuple(place[j] for j in s.sources),
            density=i.options.density, threads=max(1, means.jobs // len(i.chosen)) if here else 1, memory=means.memory,
            masks=() if i.masks is None else tuple(i.masks.files.get(p.name) for p in photos), region=i.options.region,
        )  # fmt: skip
        pixels = block.cameras[int(block.images.camera[s.reference])]
        size = pixels.width_px * pixels.height_px * i.shares.get(s.reference, 1.0)
        # without masks and region as ever: what is there stays
        more = [] if i.masks is None else [[i.masks.key(p) for p in photos]]
        more += [] if i.options.region is None else [OF_PART, i.options.region]
        more += [means.memory] if by_bands(int(size), means.memory) else []
        tasks.append(
            Task(
                key=key_of(
                    MAP, VERSION, own, [p.content for p in photos], s.reference, s.sources, i.options.density, *more
                ),
                function=f"{__name__}:map_of", options=options, inputs=(own,), name=block.images.ids[s.reference],
                cost=size * PIXEL_S / i.options.density**2, memory=bytes_needed(int(size), means.memory),
            )
        )  # fmt: skip
    failed = means.do(tasks, "depth maps", apart=True)
    made = {s.reference: t.key for s, t in zip(i.chosen, tasks, strict=True) if t.key not in failed}
    if not made:
        raise InputError("surface.no_depth_map", details=[message_of_text(next(iter(failed.values())))])
    lost = tuple((s.reference, failed[t.key]) for s, t in zip(i.chosen, tasks, strict=True) if t.key in failed)
    return Maps(keys=made, failed=lost)


def map_of(store: Folder, task: MapTask) -> Product:
    """The task: a depth map as arrays."""
    block = block_of_arrays(store.wanted(task.block))
    chosen = Sources(reference=task.reference, sources=task.sources, pairs=(), seen=0.0)
    options = DepthOptions(density=task.density, threads=task.threads, memory=task.memory)

    def greys(image: int) -> Array:
        return in_camera_frame(exact_grey_of(task.photos[image]), block, image)

    def free(image: int) -> Mask | None:
        return free_of(task.photos[image], task.masks[image] if task.masks else None, block, image)

    return depth_map(block, chosen, greys, options, free=free, region=task.region).as_arrays()


def _put(state: SurfaceState, found: Maps) -> SurfaceState:
    ids = state.block.images.ids
    lost = tuple((ids[k], why) for k, why in found.failed)
    return replace(state, maps=found.keys, left_out=(*state.left_out, *lost))


STAGE = SURFACE.register(
    Stage(
        name="depth maps", after=("sources",), function=measure, put=_put, kinds=(PART, MAP),
        reported=lambda s: f"{len(s.maps)} of {len(s.chosen)}",
        inputs=lambda s: Inputs(
            adjustment=s.adjustment, photos=s.photos, chosen=s.chosen, shares=s.shares, masks=s.masks,
            options=s.options,
        ),
    )
)  # fmt: skip
