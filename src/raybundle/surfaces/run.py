"""The surface of an oriented block: dense points from its photographs, each with its standard deviations.

The steps: tie points say which photographs measure the surface together; each reference gets a depth map; the maps are
compared, and of what agrees the best estimate of each place goes into the cloud.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError, message_of_text, phrase
from raybundle.io.photos.masks import Masks, find_masks
from raybundle.measuring.session import adjusted_again
from raybundle.numerics import native
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.choosing import executor_for
from raybundle.pipeline.place import kind_of
from raybundle.pipeline.project import Project, StageRecord
from raybundle.pipeline.stage import Run
from raybundle.pipeline.store import Folder
from raybundle.surfaces.depths.depth_map import LEAST_SWEEP_BYTES, bytes_needed
from raybundle.surfaces.photographs import Lost, photographs_there
from raybundle.surfaces.stages import SURFACE
from raybundle.surfaces.state import Cloud, MadeOrthophoto, MeasuredHeights, SurfaceOptions, SurfaceState
from raybundle.surfaces.without_points import pointless
from raybundle.workflows.mask_notices import mask_notices
from raybundle.workflows.photograph_contents import contents_of, other_contents


@dataclass(frozen=True, slots=True, kw_only=True)
class Surface:
    """What was measured; the points are read one reference after the other."""

    adjustment: Adjustment
    """that it rests on"""
    store: Folder
    clouds: tuple[tuple[int, str], ...]
    """references, rows of the block's images, and the keys of their points"""
    counts: tuple[int, ...]
    """points of each"""
    options: SurfaceOptions
    maps: Mapping[int, str]
    """keys of the depth maps, by reference"""
    sigmas: Mapping[int, str]
    """keys of their standard deviations"""
    heights: MeasuredHeights | None
    """on the grid that was asked for"""
    orthophoto: MadeOrthophoto | None
    """of that grid, where it was asked for"""
    left_out: tuple[tuple[str, str], ...]
    """photographs and pairs without a part in it, and why"""
    lost: tuple[Lost, ...] = ()
    """the first of these: photographs that were adjusted, and are not there or do not fit"""
    others: str = ""
    """that photographs are not those that were oriented, in words; empty: nothing states it"""
    pointless: tuple[tuple[str, str], ...] = ()
    """photographs whose depths give no point, and why, where that is not because others know their places better"""
    remarks: tuple[str, ...] = ()
    """of masks, of memory, and of products that were made again"""
    records: tuple[StageRecord, ...] = field(default=(), repr=False)

    @property
    def block(self) -> Block:
        """With adjusted values."""
        return self.adjustment.adjusted

    @property
    def free_scale(self) -> bool:
        """Whether nothing that was adjusted fixes the scale: lengths are in no unit."""
        return self.block.free_scale

    def __len__(self) -> int:
        """How many points."""
        return sum(self.counts)

    def parts(self) -> Iterator[Cloud]:
        """The points of one reference after the other."""
        for _, key in self.clouds:
            kept = self.store.wanted(key, tuple(Cloud.__slots__))
            yield Cloud(**{name: np.asarray(values) for name, values in kept.items()})


def surface(
    source: Path,
    folder: Path,
    options: SurfaceOptions,
    *,
    photos: Sequence[Path],
    masks: Path | None = None,
    free_scale: bool = False,
    jobs: int = 0,
    memory: float = 2e9,
    cluster: str = "",
    store: str = "",
    progress: Progress = silent,
    adjusted: Callable[[], Adjustment] | None = None,
) -> Surface:
    """Measure the surface that the photographs of a result show.

    source  result folder: its block is adjusted once more for all covariances
    folder  project folder, where finished maps are kept and taken from
    photos  folders in which the photographs are looked for
    masks   folder of masks, as COLMAP or Metashape name them; None: photographs are measured whole
    free_scale  also where nothing that is adjusted fixes the scale
    cluster, store  where tasks are done and products lie, as `executor_for` and `Project.open` take it
    memory  bytes that depth maps in work may take together
    adjusted  gives the adjustment of the result, where that is at hand; None: its block is adjusted once more
    raises  InputError where no two photographs show the same part, where none is found, and for a free scale

    Limits: errors that all photographs of a place share, as of reflections, water and moving shadows.
    """
    native.required()
    jobs = jobs or os.cpu_count() or 1
    made = adjusted_again(source, progress) if adjusted is None else adjusted()
    adjustment = _checked(made, source, free_scale=free_scale)
    found, lost = photographs_there(adjustment.adjusted, photos)
    others = other_contents(found.values(), contents_of(source))
    worn = None if masks is None else find_masks(masks, tuple(found.values()))
    project = Project.open(folder, store=store)
    try:
        run = Run(
            project=project, executor=executor_for(cluster, jobs, memory, progress), progress=progress, jobs=jobs,
            memory=max(memory, LEAST_SWEEP_BYTES),
        )  # fmt: skip
        begin = SurfaceState(adjustment=adjustment, photos=found, options=options, masks=worn, lost=lost)
        state = run.workflow(SURFACE, begin)
        clouds = tuple(sorted(state.clouds.items()))
        counts = tuple(len(project.products.wanted(key, ("image",))["image"]) for _, key in clouds)
        if not sum(counts):
            raise _nothing(state, project.products, others)
        return Surface(
            adjustment=adjustment, store=project.products, clouds=clouds, counts=counts, options=options,
            maps=state.maps, sigmas=state.sigmas, heights=state.heights, orthophoto=state.orthophoto,
            left_out=(*(one.reported for one in lost), *state.left_out), lost=lost, others=others,
            remarks=(*_remarks(worn), *_beyond(state, memory)),
            pointless=pointless(state.block, state.clouds, project.products, region=options.region is not None),
            records=tuple(project.records),
        )  # fmt: skip
    finally:
        project.close()


def _checked(made: Adjustment, source: Path, *, free_scale: bool) -> Adjustment:
    """An adjustment whose block states whether its scale is free; raises InputError where that is not wanted.

    Whatever a folder states of it: a block states nothing, and observations of a result may be gone.
    """
    free = made.free_scale
    if free and not free_scale:
        raise InputError(
            "surface.scale_free",
            file=source,
        )
    return replace(made, adjusted=replace(made.adjusted, free_scale=free))


def mended_words(keys: Collection[str]) -> tuple[str, ...]:
    """That products were damaged or gone which had been kept, by their keys, and were made again."""
    kinds = Counter(kind_of(key) for key in keys)
    if not kinds:
        return ()
    made = [f"{n} {kind}" for kind, n in sorted(kinds.items())]
    return (phrase("surface_remark.remade", n=len(keys), kinds=made),)


def _nothing(state: SurfaceState, store: Folder, others: str) -> InputError:
    """Why a surface has no point; first that photographs are not those that were oriented."""
    depths, pixels = 0, 0
    for key in state.maps.values():
        t = store.wanted(key, ("t",))["t"]
        depths, pixels = depths + int(np.isfinite(t).sum()), pixels + t.size
    share, region = depths / max(pixels, 1), state.options.region is not None
    if others:
        return InputError(
            "surface.other_photographs", share=share, pixels=pixels, region=region, details=[message_of_text(others)]
        )
    return InputError("surface.nothing_measured", share=share, pixels=pixels, region=region)


def _remarks(masks: Masks | None) -> tuple[str, ...]:
    return () if masks is None else tuple(n.text for n in mask_notices(masks, "depths"))


def _beyond(state: SurfaceState, memory: float) -> tuple[str, ...]:
    """That a depth map takes more memory than is allowed, where that is so."""
    sizes = list[tuple[float, int]]()
    for k in state.maps:
        camera = state.block.cameras[int(state.block.images.camera[k])]
        pixels = int(camera.width_px * camera.height_px * state.shares.get(k, 1.0))
        sizes.append((max(LEAST_SWEEP_BYTES, bytes_needed(pixels, 0.0)), k))
    most, largest = max(sizes, default=(0.0, -1))
    if most <= memory:
        return ()
    name = state.block.images.ids[largest]
    return (phrase("surface_remark.memory", memory_gb=memory / 1e9, name=name, needed_gb=most / 1e9),)
