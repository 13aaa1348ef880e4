"""A depth map of one reference: depth and slopes of its pixels, each with variances in their parts.

Approximate depths of all levels, refined on a coarse grid, grown, and refined again at the density that is asked for
by the noise that was measured on the way.  Nothing here reads or writes files.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.depths import roughness
from raybundle.surfaces.depths.filters import DOUBTFUL, Flag, tested
from raybundle.surfaces.depths.levels import (
    Fine,
    Level,
    approximate,
    halved,
    holes_of,
    measured,
    nearest_of,
    on_level,
    rim_of,
    wanted_of,
)
from raybundle.surfaces.depths.normals import incidences, smoothed
from raybundle.surfaces.depths.orientation import ShiftCovariance
from raybundle.surfaces.depths.pairs import Sources
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid, RefineOptions, Source
from raybundle.surfaces.depths.region_pixels import Region, Shown, shown_part, swept_part, wanted_pixels
from raybundle.surfaces.depths.sweep import Start, moved_px, reduction_for, swept
from raybundle.surfaces.depths.transfer import Transfer, transfer

AROUND = 16
"""Pixels around what is wanted of a reference for which tables are made: windows, and what is reduced, reach so far."""
OUTER = 0.01
"""Tie points at either end that may be wrong, as a share of all."""
THINGS, RAYS = 3, 3
"""So many tie points of so many rays make a thing, however few of all they are: a chimney, a post, a roof"""
FEWEST_POINTS = 8
"""Tie points that show the range of depths."""
MAP_BYTES = 100.0
"""That a map and what it is made of take for a pixel of the reference, and as much costs of approximate depths may."""
LEAST_SWEEP_BYTES = 4e8
ROWS = 64
"""Of a map whose variances are made at once."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DepthOptions:
    """How dense, and by which means."""

    density: int = 1
    """every so many pixels: 1, 2 or 4"""
    threads: int = 1
    memory: float = 2e9
    """bytes that approximate depths may take: they are found by bands of rows where they would take more"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DepthMap:
    """Depths of a reference's pixels: arrays (rows, columns), float32 unless stated otherwise; NaN where there is none.

    Doubtful depths, whose neighbours speak against them, are among them (`doubtful`, `sure`).
    Limits: an error that all sources share, as a moving shadow or a reflection.
    """

    grid: PixelGrid
    sources: tuple[int, ...]
    t_range: tuple[float, float]
    """smallest and largest depth parameter that was looked for"""
    t: Array
    slopes: Array
    """(2, rows, columns) of t by column and row [1 / px]"""
    noise: Array
    """variance of t by the noise of grey values"""
    roughness: Array
    """variance of t by what the surface does within the window"""
    step: Array
    """variance of t of doubtful depths by steps: how far their neighbours stand apart; 0 elsewhere"""
    shift: Array
    """(rows, columns, sources, 2) change of t where a source's table states one pixel further [t / px]"""
    views: Index
    """int32, bit s: source s was used"""
    reason: Array
    """uint8 `Reason`"""
    flags: Array
    """uint8 `Flag`"""
    correlation: Array
    contrast: Array
    incidence: Array
    """cosine of the angle between ray and normal, of a pixel and its neighbours together"""
    grey: Array
    """(7, 7) autocovariance of the noise of grey values by lag, 1 in the middle"""
    correlation_px: float
    """distance at which the errors of two pixels by noise correlate by 1 / e"""

    @property
    def doubtful(self) -> Mask:
        """(rows, columns) depths that stand where other maps confirm them."""
        return doubtful_of(self.flags) & np.isfinite(self.t)

    def sure(self, confirmed: Index | None = None) -> DepthMap:
        """The same without doubtful depths but for pixels (n,), row by row, that others confirm."""
        lost, slopes = self.doubtful, self.slopes.copy()
        if confirmed is not None:
            lost.ravel()[confirmed] = False
        slopes[:, lost] = np.nan
        single = ("t", "noise", "roughness", "correlation", "contrast", "incidence")
        values = {name: np.where(lost, np.float32(np.nan), getattr(self, name)) for name in single}
        return replace(self, slopes=slopes, step=np.where(lost, np.float32(0), self.step), **values)

    def variance(self, shifts: ShiftCovariance | None = None) -> Array:
        """(rows, columns) of t: noise, roughness, steps and, with `shifts`, orientation and calibration."""
        found = self.noise.astype(float) + self.roughness + self.step
        if shifts is None:
            return found
        for k in range(0, self.grid.rows, ROWS):
            part = slice(k, k + ROWS)
            known = np.isfinite(self.t[part])
            if known.any():
                xy, t = self.grid.rows_of(k, ROWS).xy_px[known], self.t[part][known].astype(float)
                found[part][known] += shifts.of_depths(xy, t, self.shift[part][known])
        return found

    def points(self, block: Block, reference: int) -> Array:
        """(n, 3) object points of the pixels with a depth, row by row."""
        known = np.isfinite(self.t)
        return ReferenceRays.of(block, reference).points(self.grid.xy_px[known], self.t[known].astype(float))

    def smooth_slopes(self) -> Array:
        """(2, rows, columns) of t by column and row, means over a pixel and its neighbours [1 / px].

        Doubtful neighbours count for doubtful pixels alone.
        """
        doubtful = self.doubtful
        found = smoothed(self.slopes, np.isfinite(self.t) & ~doubtful, self.grid.stride)
        if doubtful.any():
            found[:, doubtful] = smoothed(self.slopes, np.isfinite(self.t), self.grid.stride)[:, doubtful]
        return found

    def correlation_between(self, distance_px: Array) -> Array:
        """Correlation (...) of the errors by noise and roughness of usual pixels so far apart.

        Windows share grey values as their weights overlap.  What the surface does within them is an increment, and
        forgets twice as fast.
        """
        with np.errstate(invalid="ignore"):
            share = self.noise / (self.noise + self.roughness)
        known = share[np.isfinite(share)]
        by_noise = float(np.median(known)) if len(known) else 1.0
        q = (np.asarray(distance_px, float) / self.correlation_px) ** 2
        return by_noise * np.exp(-q) + (1 - by_noise) * np.exp(-4 * q)

    def as_arrays(self) -> dict[str, Array]:
        """What a store keeps."""
        named = {name: getattr(self, name) for name in STORED}
        return {
            **named, "grid": self.grid.as_numbers(),
            "sources": np.array(self.sources, np.int32), "t_range": np.array(self.t_range),
            "correlation_px": np.array([self.correlation_px]),
        }  # fmt: skip

    @classmethod
    def of_arrays(cls, a: Mapping[str, Array]) -> DepthMap:
        """That of `as_arrays`."""
        low, high = a["t_range"].tolist()
        return cls(
            grid=PixelGrid.of_numbers(a["grid"]),
            sources=tuple(a["sources"].tolist()), t_range=(low, high), correlation_px=float(a["correlation_px"][0]),
            **{name: np.asarray(a[name]) for name in STORED},
        )  # fmt: skip


STORED = (
    "t", "slopes", "noise", "roughness", "step", "shift", "views", "reason", "flags", "correlation", "contrast",
    "incidence", "grey",
)  # fmt: skip
"""Arrays of a map that are kept as they are"""
FILLED = (
    "noise", "roughness", "step", "shift", "views", "reason", "flags", "correlation", "contrast", "incidence",
)  # fmt: skip
"""Of these what a hole takes from a coarser map as it is"""


def doubtful_of(flags: Array) -> Mask:
    """Which pixels (...) are doubtful, by their flags."""
    return np.asarray(flags & np.uint8(DOUBTFUL)) > 0


def depth_map(
    block: Block, chosen: Sources, greys: Callable[[int], Array], options: DepthOptions | None = None, *,
    free: Callable[[int], Mask | None] = lambda _: None, region: Region | None = None,
) -> DepthMap:  # fmt: skip
    """Measure the depths of a reference.

    block   oriented; `chosen` are rows of its images
    greys   gives the grey values (h, w) of an image as stored, uint8, or float32 of that range where they are finer
    free    gives the pixels (h, w) of an image that may be measured in; None: all of them
    region  part of the object that alone is wanted; around it more has a depth, and pixels further away have none

    A depth in a region is that of the whole map but for what is taken of all of it: where the approximate depths begin,
    the noise of grey values and the usual roughness.  Both agree within a small part of their standard deviations.
    Raises InputError for a reference without sources or tie points, or whose depths do not fit the memory, and for one
    that shows nothing of the region.
    """
    o = options or DepthOptions()
    if o.density not in (1, 2, 4):
        raise InputError("depth_map.density", density=o.density)
    if not chosen.sources:
        raise InputError("depth_map.no_source", image=block.images.ids[chosen.reference])
    rays = ReferenceRays.of(block, chosen.reference)
    t_range = depth_range(block, rays, chosen.reference)
    shown = None if region is None else shown_part(rays, t_range, region)
    if region is not None and shown is None:
        raise InputError("depth_map.outside_region", image=block.images.ids[chosen.reference])
    box = None if shown is None else shown.box_around(AROUND)
    tables = [transfer(block, rays, j, t_range, box) for j in chosen.sources]
    reference, photographs = greys(chosen.reference), [greys(j) for j in chosen.sources]
    masks = [free(j) for j in chosen.sources]
    start = _start(_bytes(reference), [_bytes(g) for g in photographs], masks, tables, (shown, o))
    sources = [
        Source(grey=_measurable(photographs.pop(0), mask), transfer=table)
        for mask, table in zip(masks, tables, strict=True)
    ]
    level = Level(
        rays=rays, reference=reference, grey=_measurable(reference, free(chosen.reference)), sources=sources,
        t_range=t_range, density=o.density, threads=o.threads, shown=shown,
    )  # fmt: skip
    if region is not None and shown is not None:
        level = level.only(wanted_pixels(rays, start, shown, region))
    return _of_levels(level, start, chosen.sources)


def depth_range(block: Block, rays: ReferenceRays, reference: int) -> tuple[float, float]:
    """Depth parameters between which the object lies, by the tie points that the reference sees.

    What stands out has few of them, and so have mistakes; but these hardly agree in three rays.  Limits:
    a thing that has no tie points, and lies further off than a quarter of the range: it would get wrong depths.
    """
    o = block.observations
    placed: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    mine = np.flatnonzero((o.image == reference) & placed[o.point])
    t = rays.parameter(np.asarray(o.xy_px)[mine], block.points.xyz[np.asarray(o.point)[mine]])
    before = np.isfinite(t) & (t > 0)
    seen = np.bincount(np.asarray(o.point), minlength=len(block.points))[np.asarray(o.point)[mine]]
    sure, t = t[before & (seen >= RAYS)], t[before]
    if len(t) < FEWEST_POINTS:
        name = block.images.ids[reference]
        raise InputError("depth_map.too_few_points", image=name, n=len(t), least=FEWEST_POINTS)
    low, high = (float(q) for q in np.quantile(t, [OUTER, 1 - OUTER]))
    if len(sure) >= 2 * THINGS:
        ends = np.sort(sure)
        low, high = min(low, float(ends[THINGS - 1])), max(high, float(ends[-THINGS]))
    return rays.widened(low, high)


def _measurable(grey: Array, free: Mask | None) -> Array:
    """(h, w) float32 grey values; NaN where nothing may be measured."""
    found = np.ascontiguousarray(grey, np.float32)
    return found if free is None else np.where(free, found, np.float32(np.nan))


def _bytes(grey: Array) -> Array:
    """(h, w) uint8."""
    return grey if grey.dtype == np.uint8 else np.clip(grey, 0, 255).astype(np.uint8)


def bytes_needed(pixels: int, memory: float) -> float:
    """Memory that the map of a photograph takes while it is made, the photographs themselves included.

    memory  bytes that are there; approximate depths are found by bands of rows where they would take more
    """
    return _sweep_bytes(pixels, memory) + MAP_BYTES * pixels


def by_bands(pixels: int, memory: float) -> bool:
    """Whether approximate depths of a photograph are found by bands or coarser, so that they depend on the memory."""
    return _sweep_bytes(pixels, memory) < _sweep_bytes(pixels, np.inf)


def _sweep_bytes(pixels: int, memory: float) -> float:
    return min(memory, max(LEAST_SWEEP_BYTES, MAP_BYTES * pixels))


def _start(
    reference: Array, photographs: Sequence[Array], free: Sequence[Mask | None], tables: Sequence[Transfer],
    asked: tuple[Shown | None, DepthOptions],
) -> Start:  # fmt: skip
    """Approximate depths of the reference, or of what is wanted of it, in no more memory than the map takes later."""
    shown, options = asked
    height, width = reference.shape
    memory = _sweep_bytes(width * height, options.memory)
    box = (0, 0, width, height) if shown is None else shown.box
    scale = reduction_for(width, height, moved_px(tables, box), memory)
    if shown is None:
        return swept(reference, photographs, tables, scale=scale, memory=memory, free=free)
    return swept_part(reference, photographs, tables, shown, scale=scale, memory=memory, free=free)


def _of_levels(level: Level, start: Start, sources: tuple[int, ...]) -> DepthMap:
    """The map of the photographs as they are; where it has holes, that of their halves."""
    first = approximate(level, start)
    grid = level.grid(level.density)
    found = _map(level, grid, measured(level, grid, first), first.noise[0], sources)
    holes = holes_of(np.isfinite(found.t), grid.stride)
    del first
    if not holes.any():
        return found
    half = halved(level)
    own = half.grid(half.density)
    mine = on_level(holes, grid, half.in_photograph(own))
    again = approximate(half, start)
    fine = measured(half, own, again, wanted_of(mine, own.stride))
    return _filled(found, _map(half, own, fine, again.noise[0], sources, rim_of(mine, own.stride)), holes)


def _filled(found: DepthMap, half: DepthMap, holes: Mask) -> DepthMap:
    """A map that was just made, and whose holes take the depths of a coarser one, along the planes of its pixels.

    holes  (rows, columns) where few have a depth: one that is doubtful takes what its coarser neighbours agree in
    """
    (row, column), (right, down) = nearest_of(half.grid, found.grid)
    better = np.isnan(found.t) | (found.doubtful & ~half.doubtful[row, column])
    there = holes & better & np.isfinite(half.t)[row, column]
    row, column = row[there], column[there]
    a, b = half.slopes[:, row, column]
    found.t[there] = half.t[row, column] + a * right[there] + b * down[there]
    found.slopes[:, there] = a, b
    for name in FILLED:
        getattr(found, name)[there] = getattr(half, name)[row, column]
    found.flags[there] |= np.uint8(Flag.COARSE)
    return found


def _map(
    level: Level, grid: PixelGrid, fine: Fine, grey: Array, sources: tuple[int, ...], rim: Mask | None = None
) -> DepthMap:
    """Local variances, and what neighbours say of a pixel; lengths are pixels of the photograph.

    rim  (rows, columns) pixels whose windows show other things, too; None: none is known
    """
    t, slopes, known = fine.t, fine.slopes, np.isfinite(fine.t)
    shown = roughness.witnesses(t, slopes, grid.stride)
    factor = roughness.local_factor(fine.theory, shown, fine.residual, grid.of(level.reference))
    variance = fine.theory * factor
    del shown, factor
    place, scale = level.in_photograph(grid), np.float32(level.scale)
    incidence = incidences(level.rays, place, t, smoothed(slopes, known, grid.stride) / scale)
    several = len(level.sources) > 1
    few: Mask = np.asarray((fine.views & (fine.views - 1) == 0) & several)  # a single bit
    flags, step = tested(t, slopes, variance, incidence, few, grid.stride, rim)
    noise = np.minimum(fine.noise, variance)
    variance -= noise
    incidence[~known] = np.nan
    return DepthMap(
        grid=place, sources=sources, t_range=level.t_range, t=t, slopes=slopes / scale, noise=noise,
        roughness=variance, step=step, shift=fine.shift / scale, views=fine.views, reason=fine.reason, flags=flags,
        correlation=fine.correlation, contrast=fine.contrast, incidence=incidence, grey=grey,
        correlation_px=2 * RefineOptions().sigma * level.scale,
    )  # fmt: skip
