"""One level of a reference's depth map: approximate depths refined on a coarse grid, grown, and refined again.

The first level is the photographs as they are; a further one is the same photographs at half the size (`halved`), where
a window shows four times as much of the object and the noise of grey values is averaged over.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.depths import planes, roughness
from raybundle.surfaces.depths.noise import autocovariance, lost_freedom
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import (
    PASSES,
    PixelGrid,
    Refined,
    RefineOptions,
    Source,
    grow,
    refine,
    used_sources,
)  # fmt: skip
from raybundle.surfaces.depths.region_pixels import Shown, part_of_grid
from raybundle.surfaces.depths.sweep import Start

HALF = 2
"""Pixels of the photograph from one to the next of a further level."""
COARSE = 4
"""Pixels from one to the next of the grid that is refined first: windows of 7 px overlap there."""
HOLE_PX, HOLE_SHARE = 8, 0.5
"""Side of the surroundings of a pixel without a depth, and the share of them without one that makes it part of a
hole"""
STRIP_BYTES = 48e6
"""Windows' responses that are in memory at once."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Level:
    """What all steps share."""

    rays: ReferenceRays
    reference: Array
    """(h, w)"""
    grey: Array
    """(h, w) the same as float32; NaN where nothing is measured"""
    sources: list[Source]
    """their grey values are NaN where nothing may be measured: windows that reach there have no texture"""
    t_range: tuple[float, float]
    density: int
    """every so many pixels of this level"""
    threads: int
    shown: Shown | None
    """where the reference may show what is wanted; None: everywhere"""
    within: PixelGrid | None = None
    """pixels of the photograph itself that this level is a half of; None: it is the photograph"""

    @property
    def scale(self) -> int:
        """Pixels of the photograph from one to the next of this level."""
        return 1 if self.within is None else HALF

    def only(self, wanted: Mask) -> Level:
        """The same where nothing else of the reference is measured."""
        return replace(self, grey=np.where(wanted, self.grey, np.float32(np.nan)))

    def grid(self, stride: int) -> PixelGrid:
        """Pixels that are measured, every so many."""
        if self.within is not None:
            g = self.within
            rows, columns = (-(-n // (2 * stride)) for n in (g.rows, g.columns))
            return PixelGrid(x0=g.x0 // 2, y0=g.y0 // 2, stride=stride, rows=rows, columns=columns)
        whole = PixelGrid.over(self.reference, stride, RefineOptions().half + 1)
        return whole if self.shown is None else part_of_grid(whole, self.shown, COARSE)

    def in_photograph(self, grid: PixelGrid) -> PixelGrid:
        """The same pixels of the photograph itself."""
        n = self.scale
        return replace(grid, x0=n * grid.x0, y0=n * grid.y0, stride=n * grid.stride)


def halved(level: Level) -> Level:
    """The photographs at half the size, smoothed by a binomial filter; what is not measured takes its surroundings too.

    Pixel i of a row is where pixel 2 i was.  The level itself is spent: its sources go, one after the other.
    """
    sources = list[Source]()
    while level.sources:
        one = level.sources.pop(0)
        t = one.transfer
        smaller = replace(
            t, places=(t.places + 0.5) / 2, u0_px=(t.u0_px + 0.5) / 2, v0_px=(t.v0_px + 0.5) / 2,
            step_px=t.step_px / 2, error_px=t.error_px / 2,
        )  # fmt: skip
        sources.append(Source(grey=cv2.pyrDown(one.grey), transfer=smaller))
    return replace(
        level, reference=cv2.pyrDown(np.ascontiguousarray(level.reference, np.float32)), grey=cv2.pyrDown(level.grey),
        sources=sources, density=max(1, level.density // 2), shown=None, within=level.grid(1),
    )  # fmt: skip


def holes_of(known: Mask, stride: int) -> Mask:
    """(rows, columns) surroundings in which most pixels have no depth: single ones are given by what is around them."""
    missing = (~known).astype(np.float32)
    side = 2 * max(1, round(HOLE_PX / stride / 2)) + 1
    return cv2.boxFilter(missing, -1, (side, side), borderType=cv2.BORDER_REPLICATE) >= HOLE_SHARE


def on_level(holes: Mask, grid: PixelGrid, place: PixelGrid) -> Mask:
    """(rows, columns) of a level, which of its pixels lie in holes, of a grid of the photograph.

    place  grid of the level in pixels of the photograph
    """
    n = place.stride // grid.stride  # one pixel for several of the photograph
    whole = holes if n == 1 else cv2.dilate(holes.astype(np.uint8), np.ones((n, n), np.uint8), anchor=(0, 0)) > 0
    at, _ = nearest_of(grid, place)
    return whole[at]


def wanted_of(holes: Mask, stride: int) -> Mask:
    """(rows, columns) of a level, its holes, and as far around them as the test against neighbours looks."""
    around = 2 * max(1, round(roughness.APART_PX / stride)) + 1
    return cv2.dilate(holes.astype(np.uint8), np.ones((around, around), np.uint8)) > 0


def rim_of(holes: Mask, stride: int) -> Mask:
    """(rows, columns) of a level, what of its holes is so near to their rims that windows show what lies around."""
    side = 2 * max(1, round((RefineOptions().half + 0.5) / stride)) + 1
    inner = cv2.erode(holes.astype(np.uint8), np.ones((side, side), np.uint8), borderType=cv2.BORDER_REPLICATE) > 0
    return holes & ~inner


def nearest_of(grid: PixelGrid, other: PixelGrid) -> tuple[tuple[Index, Index], tuple[Array, Array]]:
    """Row and column (rows, columns) of the pixel of a grid at which, or after which, those of another grid lie.

    And how far right and down of it they lie [px].  What lies beyond the grid has its first or last pixel.
    """
    at, off = list[Index](), list[Array]()
    for first, count, begin, n in (
        (other.y0, other.rows, grid.y0, grid.rows), (other.x0, other.columns, grid.x0, grid.columns),
    ):  # fmt: skip
        pixel = first + other.stride * np.arange(count)
        place = np.clip((pixel - begin) // grid.stride, 0, n - 1)
        at.append(place)
        off.append((pixel - begin - grid.stride * place).astype(np.float32))
    row, column = np.meshgrid(*at, indexing="ij")
    down, right = np.meshgrid(*off, indexing="ij")
    return (row, column), (right, down)


@dataclass(frozen=True, slots=True, kw_only=True)
class Fine:
    """What is kept of the refined pixels of a map: arrays (rows, columns), float32 unless stated otherwise.

    Lengths are pixels of the level.
    """

    t: Array
    slopes: Array
    """(2, rows, columns); NaN, as t, where a pixel was not refined"""
    noise: Array
    """variance of t by grey values"""
    theory: Array
    """that and the variance of a usual roughness"""
    residual: Array
    """variance of grey values"""
    correlation: Array
    contrast: Array
    shift: Array
    """(rows, columns, sources, 2)"""
    views: Index
    """int32"""
    reason: Array
    """uint8"""

    @classmethod
    def empty(cls, grid: PixelGrid, sources: int) -> Fine:
        """Of a grid."""
        shape = grid.rows, grid.columns
        return cls(
            **{
                name: np.empty(shape, np.float32)
                for name in ("t", "noise", "theory", "residual", "correlation", "contrast")
            },
            slopes=np.empty((2, *shape), np.float32), shift=np.empty((*shape, sources, 2), np.float32),
            views=np.empty(shape, np.int32), reason=np.empty(shape, np.uint8),
        )  # fmt: skip

    def take(self, rows: slice, part: Refined, noise: Array, window: Array) -> None:
        """Rows that were refined, their variances by noise, and those by windows on a usual roughness."""
        known = part.found
        by_noise = np.where(known, noise, np.nan)
        residual = part.grey_variance * part.contrast**2
        for own, values in (
            (self.t, part.t), (self.noise, by_noise), (self.theory, by_noise + window), (self.residual, residual),
            (self.correlation, part.correlation), (self.contrast, part.contrast),
        ):  # fmt: skip
            own[rows] = np.where(known, values, np.nan)
        self.slopes[:, rows] = np.where(known, part.slopes, np.nan)
        self.shift[rows], self.views[rows], self.reason[rows] = part.shift, part.views, part.reason


@dataclass(frozen=True, slots=True, kw_only=True)
class Approximate:
    """Refined pixels of a coarse grid, and what they show of all."""

    found: Refined
    grid: PixelGrid
    noise: Array
    """(1 + sources, 7, 7) autocovariances of grey values by lag"""


def approximate(level: Level, start: Start) -> Approximate:
    """Pixels of a coarse grid from approximate depths of the photograph."""
    coarse = level.grid(COARSE)
    first = planes.of_start(start, level.in_photograph(coarse))
    first[1:] *= level.scale
    found = refine(level.grey, level.sources, coarse, first, threads=level.threads)
    found = grow(level.grey, level.sources, coarse, found, threads=level.threads)
    noise = autocovariance(level.grey, level.sources, coarse, found)
    return Approximate(found=found, grid=coarse, noise=noise)


def measured(level: Level, grid: PixelGrid, a: Approximate, wanted: Mask | None = None) -> Fine:
    """Pixels of a grid, refined by the noise that was measured on the way.

    wanted  (rows, columns) which alone are measured; None: all
    """
    rough = roughness.local_roughness(
        np.where(a.found.found, a.found.t, np.nan), noise_of(a.found, a.noise, len(level.sources)), COARSE
    )
    (row, column), _ = nearest_of(a.grid, grid)
    fine = Fine.empty(grid, len(level.sources))
    for rows, part in _grown(level, grid, a, wanted):
        assert part.response is not None
        window = rough.variance((row[rows], column[rows]), part.response)
        fine.take(rows, part, noise_of(part, a.noise, len(level.sources)), window)
    return fine


def noise_of(found: Refined, noise: Array, sources: int) -> Array:
    """Variance of t by grey values, residuals of correlated ones being too small (fewer are independent)."""
    used = used_sources(found.views, sources).sum(axis=-1)
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


def _grown(level: Level, grid: PixelGrid, a: Approximate, wanted: Mask | None) -> Iterator[tuple[slice, Refined]]:
    """Refined pixels, strip by strip, with windows' responses; the same as of all rows at once.

    Growing carries planes over as many rows as it makes passes: so many are there on both sides of a strip.
    """
    side = (2 * RefineOptions().half + 1) ** 2
    at_once = max(2 * PASSES, int(STRIP_BYTES / (4.0 * side * max(grid.columns, 1))))
    there: Refined | None = None
    first = last = 0

    def among(begin: int, rows: int) -> Mask | None:
        return None if wanted is None else wanted[begin : begin + rows]

    for begin in range(0, grid.rows, at_once):
        end = min(begin + at_once, grid.rows)
        more = grid.rows_of(last, min(end + PASSES, grid.rows) - last)
        if more.rows:
            fresh = refine(
                level.grey, level.sources, more, planes.of_refined(a.found, a.grid, more), autocovariance=a.noise,
                response=True, threads=level.threads, wanted=among(last, more.rows),
            )  # fmt: skip
            there = fresh if there is None else _below_each_other(_rows(there, begin - PASSES - first), fresh)
            first, last = max(0, begin - PASSES), last + more.rows
        assert there is not None
        strip = grid.rows_of(first, last - first)
        grown = grow(
            level.grey, level.sources, strip, there, autocovariance=a.noise, threads=level.threads,
            wanted=among(first, strip.rows),
        )  # fmt: skip
        yield slice(begin, end), _rows(grown, begin - first, end - first)


def _rows(part: Refined, begin: int, end: int | None = None) -> Refined:
    """Rows of what was refined."""
    own = slice(max(0, begin), end)
    return replace(
        part, numbers=part.numbers[:, own], reason=part.reason[own], iterations=part.iterations[own],
        views=part.views[own], shift=part.shift[own], response=None if part.response is None else part.response[own],
    )  # fmt: skip


def _below_each_other(one: Refined, other: Refined) -> Refined:
    assert one.response is not None
    assert other.response is not None
    return replace(
        one, numbers=np.concatenate([one.numbers, other.numbers], axis=1),
        reason=np.concatenate([one.reason, other.reason]),
        iterations=np.concatenate([one.iterations, other.iterations]),
        views=np.concatenate([one.views, other.views]), shift=np.concatenate([one.shift, other.shift]),
        response=np.concatenate([one.response, other.response]),
    )  # fmt: skip
