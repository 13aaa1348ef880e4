"""A depth map of one reference: depth and slopes of its pixels, each with variances in their parts.

Approximate depths of all levels, refined on a coarse grid, grown, and refined again at the density that is asked for
by the noise that was measured on the way.  Nothing here reads or writes files.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntFlag

import cv2
import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces import planes, roughness
from raybundle.surfaces.noise import autocovariance, lost_freedom
from raybundle.surfaces.orientation import ShiftCovariance
from raybundle.surfaces.pairs import Sources
from raybundle.surfaces.refine import PixelGrid, Refined, RefineOptions, Source, grow, refine, used_sources
from raybundle.surfaces.region import Region, Shown, part_of_grid, shown_part, swept_part, wanted_pixels
from raybundle.surfaces.sweep import Start, moved_px, reduction_for, swept
from raybundle.surfaces.transfer import ReferenceRays, transfer

COARSE = 4
"""Pixels from one to the next of the grid that is refined first: windows of 7 px overlap there."""
OUTER, BEYOND = 0.01, 0.25
"""Tie points at either end that may be wrong, as a share of all, and by how much depths may lie beyond the others, as a
share of their range."""
FEWEST_POINTS = 8
"""Tie points that tell the range of depths."""
STRIP_BYTES = 64e6
"""Windows' responses that are in memory at once."""
SIGMAS = 3.0
"""Standard deviations of a difference up to which neighbours agree."""
AGREE, AGAINST = 5, 2
"""Of eight neighbours that have to, and that may speak against it: most of a straight edge of things stays, and what
juts out of it, where a window shows more of the other side, goes."""
HOLE_PX, RIM_PX = 9, 2
"""Holes larger than a window and a pixel on each side, and what is lost around them: of 3 px that half a window
reaches, the outer one has no weight."""
GRAZING = 0.3
"""Cosine between ray and normal below which a window shows hardly anything of the surface."""


class Flag(IntFlag):
    """What is to be known of a pixel."""

    GRAZING = 1
    STEP = 2
    """A neighbour stands on another depth"""
    FEW_SOURCES = 4
    """Seen by one source only, where there are several: nothing checks it"""
    LONELY = 8
    """Its neighbours do not agree with it: taken out"""
    EDGE = 16
    """Beside a hole that is larger than a window: something begins there that hides the rest, and windows show both:
    taken out"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DepthOptions:
    """How dense, and by which means."""

    density: int = 1
    """every so many pixels: 1, 2 or 4"""
    threads: int = 1
    memory: float = 2e9
    """bytes that approximate depths may take"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DepthMap:
    """Depths of a reference's pixels: arrays (rows, columns), float32 unless said otherwise; NaN where there is none.

    What it does not tell: an error that all sources share, as a moving shadow or a reflection.
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
    shift: Array
    """(rows, columns, sources, 2) change of t where a source's picture lies one pixel further [t / px]"""
    views: Index
    """int32, bit s: source s was used"""
    reason: Array
    """uint8 `Reason`"""
    flags: Array
    """uint8 `Flag`; also of pixels that were taken out"""
    correlation: Array
    contrast: Array
    incidence: Array
    """cosine of the angle between ray and normal, of a pixel and its neighbours together"""
    grey: Array
    """(7, 7) autocovariance of the noise of grey values by lag, 1 in the middle"""
    correlation_px: float
    """distance at which the errors of two pixels by noise correlate by 1 / e"""

    def variance(self, shifts: ShiftCovariance | None = None) -> Array:
        """(rows, columns) of t: noise, roughness and, with `shifts`, orientation and calibration."""
        found = self.noise.astype(float) + self.roughness
        known = np.isfinite(self.t)
        if shifts is not None and known.any():
            found[known] += shifts.of_depths(self.grid.xy_px[known], self.t[known].astype(float), self.shift[known])
        return found

    def points(self, block: Block, reference: int) -> Array:
        """(n, 3) object points of the pixels with a depth, row by row."""
        known = np.isfinite(self.t)
        return ReferenceRays.of(block, reference).points(self.grid.xy_px[known], self.t[known].astype(float))

    def smooth_slopes(self) -> Array:
        """(2, rows, columns) of t by column and row, means over a pixel and its neighbours [1 / px]."""
        return _smooth(self.slopes, np.isfinite(self.t), self.grid.stride)

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
        g = self.grid
        named = {name: getattr(self, name) for name in STORED}
        return {
            **named, "grid": np.array([g.x0, g.y0, g.stride, g.rows, g.columns]),
            "sources": np.array(self.sources, np.int32), "t_range": np.array(self.t_range),
            "correlation_px": np.array([self.correlation_px]),
        }  # fmt: skip

    @classmethod
    def of_arrays(cls, a: Mapping[str, Array]) -> DepthMap:
        """That of `as_arrays`."""
        x0, y0, stride, rows, columns = (int(n) for n in a["grid"])
        low, high = a["t_range"].tolist()
        return cls(
            grid=PixelGrid(x0=x0, y0=y0, stride=stride, rows=rows, columns=columns),
            sources=tuple(a["sources"].tolist()), t_range=(low, high), correlation_px=float(a["correlation_px"][0]),
            **{name: np.asarray(a[name]) for name in STORED},
        )  # fmt: skip


STORED = (
    "t", "slopes", "noise", "roughness", "shift", "views", "reason", "flags", "correlation", "contrast", "incidence",
    "grey",
)  # fmt: skip
"""Arrays of a map that are kept as they are"""


def depth_map(
    block: Block, chosen: Sources, greys: Callable[[int], Array], options: DepthOptions | None = None, *,
    free: Callable[[int], Mask | None] = lambda _: None, region: Region | None = None,
) -> DepthMap:  # fmt: skip
    """Measure the depths of a reference.

    block   oriented; `chosen` are rows of its images
    greys   gives the grey values (h, w) uint8 of an image as stored
    free    gives the pixels (h, w) of an image that may be measured in; None: all of them
    region  part of the object that alone is wanted; around it more has a depth, and pixels further away have none

    A depth in a region is that of the whole map but for what is taken of all of it: where the approximate depths begin,
    the noise of grey values and the usual roughness.  Both agree within a small part of their standard deviations.
    Raises InputError for a reference without sources or tie points, or whose depths do not fit the memory, and for one
    that shows nothing of the region.
    """
    o = options or DepthOptions()
    if o.density not in (1, 2, 4):
        raise InputError(f"density {o.density}: a depth at every pixel, every second or every fourth: 1, 2 or 4")
    rays = ReferenceRays.of(block, chosen.reference)
    t_range = depth_range(block, rays, chosen.reference)
    shown = None if region is None else shown_part(rays, t_range, region)
    if region is not None and shown is None:
        raise InputError(f"image {block.images.ids[chosen.reference]}: shows nothing of the region")
    work = _Work.of(block, rays, chosen, greys, free, t_range, o, shown)
    start = _start(work)
    if region is not None and shown is not None:
        work = work.only(wanted_pixels(rays, start, shown, region))
    found, coarse, noise = _approximate(work, start)
    return _measured(work, found, coarse, noise)


def depth_range(block: Block, rays: ReferenceRays, reference: int) -> tuple[float, float]:
    """Depth parameters between which the object lies, by the tie points that the reference sees."""
    o = block.observations
    placed: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    mine = np.flatnonzero((o.image == reference) & placed[o.point])
    t = rays.parameter(np.asarray(o.xy_px)[mine], block.points.xyz[np.asarray(o.point)[mine]])
    t = t[np.isfinite(t) & (t > 0)]
    if len(t) < FEWEST_POINTS:
        name = block.images.ids[reference]
        raise InputError(f"image {name}: {len(t)} tie points tell no range of depths, {FEWEST_POINTS} are needed")
    low, high = (float(q) for q in np.quantile(t, [OUTER, 1 - OUTER]))
    more = BEYOND * max(high - low, 0.05 * high)
    return max(low - more, 0.5 * low), high + more


@dataclass(frozen=True, slots=True, kw_only=True)
class _Work:
    """What all steps share."""

    rays: ReferenceRays
    reference: Array
    """(h, w) uint8"""
    grey: Array
    """(h, w) float32 of the reference; NaN where nothing is measured"""
    photographs: Sequence[Array]
    """(h, w) uint8 of each source"""
    free: Sequence[Mask | None]
    """(h, w) of each source where it may be measured in; None: everywhere"""
    sources: Sequence[Source]
    """their grey values are NaN where nothing may be measured: windows that reach there have no texture"""
    chosen: Sources
    t_range: tuple[float, float]
    options: DepthOptions
    shown: Shown | None
    """where the reference may show what is wanted; None: everywhere"""

    @classmethod
    def of(
        cls, block: Block, rays: ReferenceRays, chosen: Sources, greys: Callable[[int], Array],
        free: Callable[[int], Mask | None], t_range: tuple[float, float], options: DepthOptions, shown: Shown | None,
    ) -> _Work:  # fmt: skip
        if not chosen.sources:
            raise InputError(f"image {block.images.ids[chosen.reference]}: no other photograph is of use with it")
        photographs, masks = [greys(j) for j in chosen.sources], [free(j) for j in chosen.sources]
        sources = [
            Source(grey=_measurable(g, m), transfer=transfer(block, rays, j, t_range))
            for j, g, m in zip(chosen.sources, photographs, masks, strict=True)
        ]
        reference = greys(chosen.reference)
        return cls(
            rays=rays, reference=reference, grey=_measurable(reference, free(chosen.reference)),
            photographs=photographs, free=masks, sources=sources, chosen=chosen, t_range=t_range, options=options,
            shown=shown,
        )  # fmt: skip

    def only(self, wanted: Mask) -> _Work:
        """The same where nothing else of the reference is measured."""
        return replace(self, grey=np.where(wanted, self.grey, np.float32(np.nan)))

    def grid(self, stride: int) -> PixelGrid:
        """Pixels that are measured, every so many."""
        whole = PixelGrid.over(self.reference, stride, RefineOptions().half)
        return whole if self.shown is None else part_of_grid(whole, self.shown, COARSE)


def _measurable(grey: Array, free: Mask | None) -> Array:
    """(h, w) float32 grey values; NaN where nothing may be measured."""
    found = np.ascontiguousarray(grey, np.float32)
    return found if free is None else np.where(free, found, np.float32(np.nan))


def _start(work: _Work) -> Start:
    """Approximate depths of the reference, or of what is wanted of it."""
    height, width = work.reference.shape
    tables = [s.transfer for s in work.sources]
    scale = reduction_for(width, height, moved_px(tables, width, height), work.options.memory)
    if work.shown is None:
        return swept(work.reference, work.photographs, tables, scale=scale, free=work.free)
    return swept_part(work.reference, work.photographs, tables, work.shown, scale=scale, free=work.free)


def _approximate(work: _Work, start: Start) -> tuple[Refined, PixelGrid, Array]:
    """Refined pixels of a coarse grid, and the autocovariances of the noise."""
    coarse = work.grid(COARSE)
    grey, threads = work.grey, work.options.threads
    found = refine(grey, work.sources, coarse, planes.of_start(start, coarse), threads=threads)
    found = grow(grey, work.sources, coarse, found, threads=threads)
    return found, coarse, autocovariance(grey, work.sources, coarse, found)


def _measured(work: _Work, found: Refined, coarse: PixelGrid, noise: Array) -> DepthMap:
    """The map at the density that is asked for."""
    grey, threads, stride = work.grey, work.options.threads, work.options.density
    grid = work.grid(stride)
    whole = roughness.variogram(np.where(found.found, found.t, np.nan), _noise_of(found, noise, work), COARSE)
    start = planes.of_refined(found, coarse, grid)
    fine, window = _in_strips(work, grid, start, noise, whole.power)
    grown = grow(grey, work.sources, grid, fine, autocovariance=noise, threads=threads)
    more = grown.found & ~fine.found
    if more.any():
        again = np.where(more, grown.numbers[:3], np.nan).astype(np.float32)
        rest, at_rest = _in_strips(work, grid, again, noise, whole.power)
        fine = _joined(fine, rest)
        window = np.where(rest.found, at_rest, window)
    by_noise = np.where(fine.found, _noise_of(fine, noise, work), np.nan)
    theory = by_noise + whole.strength * window
    return _map(work, grid, fine, by_noise, theory, noise[0])


def _in_strips(work: _Work, grid: PixelGrid, start: Array, noise: Array, power: float) -> tuple[Refined, Array]:
    """Refined pixels, and the variance of each for a roughness of 1; windows' responses stand in memory by strips."""
    side = (2 * RefineOptions().half + 1) ** 2
    rows = max(1, int(STRIP_BYTES / (4.0 * side * max(grid.columns, 1))))
    parts, window = list[Refined](), np.zeros((grid.rows, grid.columns), np.float32)
    for begin in range(0, grid.rows, rows):
        n = min(rows, grid.rows - begin)
        strip = PixelGrid(
            x0=grid.x0, y0=grid.y0 + begin * grid.stride, stride=grid.stride, rows=n, columns=grid.columns
        )
        part = refine(
            work.grey, work.sources, strip, start[:, begin : begin + n], autocovariance=noise, response=True,
            threads=work.options.threads,
        )  # fmt: skip
        assert part.response is not None
        window[begin : begin + n] = roughness.of_window(part.response, power)
        parts.append(replace(part, response=None))
    return _below_each_other(parts), window


def _below_each_other(parts: Sequence[Refined]) -> Refined:
    return replace(
        parts[0], numbers=np.concatenate([p.numbers for p in parts], axis=1),
        reason=np.concatenate([p.reason for p in parts]), iterations=np.concatenate([p.iterations for p in parts]),
        views=np.concatenate([p.views for p in parts]), shift=np.concatenate([p.shift for p in parts]),
    )  # fmt: skip


def _joined(first: Refined, second: Refined) -> Refined:
    """The second where it was refined, else the first."""
    new = second.found
    return replace(
        first, numbers=np.where(new, second.numbers, first.numbers), reason=np.where(new, second.reason, first.reason),
        iterations=np.where(new, second.iterations, first.iterations),
        views=np.where(new, second.views, first.views), shift=np.where(new[..., None, None], second.shift, first.shift),
    )  # fmt: skip


def _noise_of(found: Refined, noise: Array, work: _Work) -> Array:
    """Variance of t by grey values, residuals of correlated ones being too small (fewer are independent)."""
    used = used_sources(found.views, len(work.sources)).sum(axis=-1)
    o = RefineOptions()
    side = np.arange(-o.half, o.half + 1.0)
    w = np.exp(-(side**2) / (2 * o.sigma**2))
    effective = (w.sum() ** 2 / (w**2).sum()) ** 2
    spent = 2 * used + 3
    white = used * effective
    lost = lost_freedom(noise[0], o)
    correlated = white / lost
    more = np.maximum(white - spent, 1) / np.maximum(correlated - spent, 1) / lost
    variance = found.variance * more
    # where no noise was found, its autocovariance may be that of anything: such a pixel agrees with no neighbour
    return np.where(variance > 0, variance, np.nan)


def _map(work: _Work, grid: PixelGrid, fine: Refined, by_noise: Array, theory: Array, grey: Array) -> DepthMap:
    """Local variances, and what neighbours say of a pixel."""
    known = fine.found
    t, slopes = np.where(known, fine.t, np.nan), np.where(known, fine.slopes, np.nan)
    residual = fine.grey_variance * fine.contrast**2
    apart = roughness.misfits(t, slopes, grid.stride)
    factor = roughness.local_factor(
        theory, roughness.of_neighbours(apart), residual, grid.of(work.reference).astype(float), grid.stride
    )
    variance = theory * factor
    incidence = incidences(work.rays, grid, t, _smooth(slopes, known, grid.stride))
    flags = _flags(work, fine, apart, variance, incidence, grid.stride)
    kept = known & (flags & np.uint8(Flag.LONELY | Flag.EDGE) == 0)

    def of_kept(values: Array) -> Array:
        return np.where(kept, values, np.nan).astype(np.float32)

    noise = np.minimum(by_noise, variance)
    o = RefineOptions()
    return DepthMap(
        grid=grid, sources=work.chosen.sources, t_range=work.t_range, t=of_kept(t), slopes=of_kept(slopes),
        noise=of_kept(noise), roughness=of_kept(variance - noise), shift=fine.shift, views=fine.views,
        reason=fine.reason, flags=flags, correlation=of_kept(fine.correlation), contrast=of_kept(fine.contrast),
        incidence=of_kept(incidence), grey=grey, correlation_px=2 * o.sigma,
    )  # fmt: skip


def _flags(work: _Work, fine: Refined, apart: Array, variance: Array, incidence: Array, stride: int) -> Array:
    """uint8 `Flag` of each pixel, by a test of the map against itself."""
    known = fine.found
    few = (used_sources(fine.views, len(work.sources)).sum(axis=-1) < 2) & (len(work.sources) > 1)
    own = np.where(known, variance, np.nan)
    agree, against = np.zeros(known.shape, np.uint8), np.zeros(known.shape, np.uint8)
    for misfit, (v, u) in zip(apart, roughness.neighbours(stride), strict=True):
        with np.errstate(invalid="ignore"):
            limit = SIGMAS * np.sqrt(own + roughness.at_neighbour(own, v, u))
            agree += np.abs(misfit) <= limit
            against += np.abs(misfit) > limit
    kept: Mask = known & (agree >= AGREE) & (against <= AGAINST)
    edge = kept & _beside_holes(kept, stride)
    flags = np.zeros(known.shape, np.uint8)
    for flag, where in (
        (Flag.GRAZING, ~(incidence >= GRAZING)), (Flag.STEP, against > 0), (Flag.FEW_SOURCES, few),
        (Flag.LONELY, ~kept), (Flag.EDGE, edge),
    ):  # fmt: skip
        flags[known & where] |= np.uint8(flag)
    return flags


def _beside_holes(kept: Mask, stride: int) -> Mask:
    """Pixels beside what is missing over more than a window."""
    size, rim = 2 * round((HOLE_PX / stride - 1) / 2) + 1, max(1, round(RIM_PX / stride))
    missing = np.pad((~kept).astype(np.uint8), size, mode="edge")
    holes = cv2.morphologyEx(missing, cv2.MORPH_OPEN, np.ones((max(size, 3),) * 2, np.uint8))
    return cv2.dilate(holes, np.ones((2 * rim + 1,) * 2, np.uint8))[size:-size, size:-size] > 0


def _smooth(slopes: Array, known: Mask, stride: int) -> Array:
    """Means of slopes (2, rows, columns) over a pixel and neighbours; a window on an edge has a slope of no thing."""
    size = 2 * round(roughness.APART_PX / stride) + 1

    def total(values: Array) -> Array:
        return cv2.boxFilter(
            values.astype(np.float64), -1, (size, size), normalize=False, borderType=cv2.BORDER_CONSTANT
        )

    n = np.maximum(total(known), 1)
    return np.stack([total(np.where(known, s, 0)) / n for s in slopes])


def incidences(rays: ReferenceRays, grid: PixelGrid, t: Array, slopes: Array) -> Array:
    """(rows, columns) cosine of the angle between rays and the normals of planes of t."""
    found = np.full(t.shape, np.nan, np.float32)
    known = np.isfinite(t)
    xy, tk = grid.xy_px[known], t[known].astype(float)
    if not len(tk):
        return found
    normal, _ = planes_at(rays, xy, tk, slopes[:, known].astype(float))
    d = rays.rays(xy)[1]
    found[known] = -(normal * d).sum(axis=1) / np.linalg.norm(d, axis=1)
    return found


def planes_at(rays: ReferenceRays, xy_px: Array, t: Array, slopes: Array) -> tuple[Array, Array]:
    """Normals (n, 3) towards the viewer of planes of t at pixels, and the object's area (n,) that a pixel shows.

    slopes  (2, n) of t along the columns and rows [1 / px]
    """
    middle = rays.points(xy_px, t)
    across, down = (
        (rays.points(xy_px + 0.5 * axis, t + 0.5 * slope) - middle) * 2.0
        for axis, slope in zip(np.eye(2), slopes, strict=True)
    )
    normal = np.cross(across, down)
    area = np.linalg.norm(normal, axis=1)
    normal /= np.maximum(area, 1e-300)[:, None]
    away = (normal * rays.rays(xy_px)[1]).sum(axis=1) > 0
    normal[away] *= -1
    return normal, area
