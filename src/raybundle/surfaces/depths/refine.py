"""Depth and slopes of every pixel of a reference by least-squares matching in several sources at once.

Unknowns of a pixel are the depth parameter t in the middle of a window and its slopes a and b; brightness and
contrast of every source; and the patch itself, which is the mean of all views, the reference included (Gruen and
Baltsavias 1988; Agouris and Schenk 1996).  Where a source shows the window is a matter of tables (`transfer`), so
sensors and platforms are all alike.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from enum import IntEnum
from functools import partial

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.depths.transfer import Transfer

LAG = 3
"""Pixels up to which grey values are correlated."""
MOST_SOURCES = 16
STRIP = 8
"""Rows of pixels that a thread does at a time; a result does not depend on it."""
PASSES = 8
"""Of growing: a pixel reaches so many rows up and down."""
AROUND = ((0, -1), (-1, 0), (0, 1), (1, 0), (-1, -1), (-1, 1), (1, -1), (1, 1))
"""Neighbours from which a pixel without a start takes its own, in this order: row, column."""
NUMBERS = ("t", "a", "b", "first_order", "noise", "inflation", "grey_variance", "correlation", "contrast")
"""In the order of the kernel."""


class Reason(IntEnum):
    """What became of a pixel."""

    REFINED = 0
    NO_START = 1
    NO_TEXTURE = 2
    """The window shows no more than noise, or does not separate depth from slopes"""
    LEFT_IMAGE = 3
    """The window leaves the reference or all sources, or the depth the range of the tables"""
    NO_CORRELATION = 4
    NO_CURVATURE = 5
    """The cost is flatter than its derivatives promise: they are made of noise"""
    NO_CONVERGENCE = 6
    MOVED_FAR = 7


@dataclass(frozen=True, slots=True, kw_only=True)
class RefineOptions:
    """The window and the iteration; shifts are those in the most sensitive source."""

    half: int = 3
    """window of (2 half + 1)^2 pixels of the reference"""
    sigma: float = 1.9
    """of its Gaussian weight [px]"""
    iterations: int = 6
    """what takes longer wanders along a valley of the cost: added noise moves such pixels by more than they state"""
    step: float = 0.05
    """shift below which the iteration ends [px]; the last step goes by the observed curvature, to a hundredth"""
    reach: float = 4.0
    """largest shift from the start [px]"""
    slope: float = 0.1
    """standard deviation of the given slopes, as shift per pixel of the reference: they are observations, too (as the
    affine map of least-squares matching is)"""
    correlation: float = 0.6
    """least correlation of a source with the reference"""
    contrast: float = 0.3
    """standard deviation of grey values in a window that is no texture: that of the rounding to whole numbers"""
    share: float = 1 / 3
    """least ratio of the observed curvature of the cost to that of the normal matrix: flatter ones are no parabola over
    the width of the noise"""
    apart: float = 0.4
    """half the distance over which curvature is observed [px]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Source:
    """A photograph that shows what the reference shows."""

    grey: Array
    """(h, w) float32 grey values"""
    transfer: Transfer


@dataclass(frozen=True, slots=True, kw_only=True)
class PixelGrid:
    """Pixels of the reference that are asked for: columns x0, x0 + stride, ... and rows y0, y0 + stride, ..."""

    x0: int
    y0: int
    stride: int
    rows: int
    columns: int

    @classmethod
    def over(cls, grey: Array, stride: int = 1, margin: int = 4) -> PixelGrid:
        """All of an image (h, w) but a margin, every so many pixels."""
        rows, columns = (max(0, -(-(n - 2 * margin) // stride)) for n in grey.shape)
        return cls(x0=margin, y0=margin, stride=stride, rows=rows, columns=columns)

    @classmethod
    def of_numbers(cls, numbers: Array) -> PixelGrid:
        """That of `as_numbers`."""
        x0, y0, stride, rows, columns = (int(n) for n in numbers)
        return cls(x0=x0, y0=y0, stride=stride, rows=rows, columns=columns)

    def as_numbers(self) -> Array:
        """What a store keeps."""
        return np.array([self.x0, self.y0, self.stride, self.rows, self.columns])

    @property
    def xy_px(self) -> Array:
        """(rows, columns, 2) centres of the pixels."""
        x = self.x0 + self.stride * np.arange(self.columns) + 0.5
        y = self.y0 + self.stride * np.arange(self.rows) + 0.5
        return np.stack(np.meshgrid(x, y), axis=-1)

    def rows_of(self, begin: int, rows: int) -> PixelGrid:
        """So many of its rows from one on, or those that are left."""
        return replace(self, y0=self.y0 + begin * self.stride, rows=min(rows, self.rows - begin))

    def of(self, image: Array) -> Array:
        """Values (rows, columns, ...) of an image (h, w, ...) at the pixels."""
        y = self.y0 + self.stride * np.arange(self.rows)
        return image[y[:, None], self.x0 + self.stride * np.arange(self.columns)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Refined:
    """Refined pixels, arrays (rows, columns); where `reason` is not REFINED numbers are those of the start or NaN.

    What the variances do not show: that the surface is not plane within the window (`response` states what it does),
    that orientation and calibration are uncertain (`shift`), and that grey values hold more than surface and noise.
    """

    numbers: Array
    """(9, rows, columns) float32 in the order of NUMBERS"""
    reason: Array
    """uint8 `Reason`"""
    iterations: Array
    """uint8"""
    views: Index
    """int32, bit s: source s was used"""
    shift: Array
    """(rows, columns, sources, 2) change of t where a source's table states one pixel further [t / px]: where those of
    all sources shift as by a larger t, it is smaller by as much"""
    left: Array
    """(1 + sources,) share of the variance of a view's grey values that is left when they are interpolated, by their
    autocovariance, on average over the places between pixels; 1 of the reference"""
    response: Array | None
    """(rows, columns, side^2) change of t where the surface alone changes by 1 at a pixel of the window, row by row: a
    plane comes out as it is, so they sum to 1; None where it was not asked for"""

    @property
    def found(self) -> Mask:
        """Pixels that were refined."""
        return self.reason == Reason.REFINED

    @property
    def t(self) -> Array:
        """Depth parameter."""
        return self.numbers[0]

    @property
    def slopes(self) -> Array:
        """(2, rows, columns) of t by column and row [1 / px]."""
        return self.numbers[1:3]

    @property
    def first_order(self) -> Array:
        """Cofactor of t by the normal matrix, for normalised grey values of weight 1."""
        return self.numbers[3]

    @property
    def noise(self) -> Array:
        """Cofactor of t by the noise of grey values: of normalised ones of variance 1, correlated as was given.

        Not yet with the observed curvature: see `variance`.
        """
        return self.numbers[4]

    @property
    def inflation(self) -> Array:
        """Curvature of the cost that the normal matrix promises over that observed; noise in gradients makes it > 1."""
        return self.numbers[5]

    @property
    def grey_variance(self) -> Array:
        """Variance of a normalised grey value of a pixel by the residuals, which are those of interpolated ones."""
        used = used_sources(self.views, len(self.left) - 1)
        return self.numbers[6] * (1 + used.sum(axis=-1)) / (self.left[0] + used @ self.left[1:])

    @property
    def correlation(self) -> Array:
        """Mean correlation of the sources used with the reference."""
        return self.numbers[7]

    @property
    def contrast(self) -> Array:
        """Standard deviation of the reference's grey values in the window, weighted."""
        return self.numbers[8]

    @property
    def variance(self) -> Array:
        """Variance of t by the noise of grey values, with the observed curvature."""
        return self.grey_variance * self.noise * self.inflation**2


def refine(
    reference: Array,
    sources: Sequence[Source],
    grid: PixelGrid,
    start: Array,
    options: RefineOptions | None = None,
    *,
    autocovariance: Array | None = None,
    response: bool = False,
    threads: int = 1,
    wanted: Mask | None = None,
) -> Refined:
    """Refine the depths of a grid of pixels.

    reference       (h, w) grey values
    start           (3, rows, columns) t, a, b; t NaN where there is none, slopes NaN where they are not known
    autocovariance  (1 + sources, 7, 7) of grey values by lag from -3 to 3 px in y and x, 1 in the middle, of the
                    reference and each source; None: white noise
    response        whether the windows' responses are wanted: 4 side^2 bytes a pixel
    wanted          (rows, columns) pixels that alone are refined, by `refine` and `grow`; None: all

    The same to the last bit for any number of threads.  Raises InputError where arrays do not fit each other.
    """
    work = _Work.of(reference, sources, grid, options, autocovariance, threads)
    found = _empty(work, start, response=response)
    todo = np.ones((grid.rows, grid.columns), np.uint8) if wanted is None else wanted.astype(np.uint8)
    _run(work, found, todo, 0)
    return found


def grow(
    reference: Array,
    sources: Sequence[Source],
    grid: PixelGrid,
    found: Refined,
    options: RefineOptions | None = None,
    *,
    autocovariance: Array | None = None,
    passes: int = PASSES,
    threads: int = 1,
    wanted: Mask | None = None,
) -> Refined:
    """Refine pixels without a start, or whose start led nowhere, from the planes of refined neighbours.

    A pass takes the neighbour of largest correlation of eight, then goes along the rows, forth and back in turn.  A
    pixel is tried once more only where a neighbour is new.  Deterministic, and the same for any number of threads.
    """
    work = _Work.of(reference, sources, grid, options, autocovariance, threads)
    grown = replace(
        found, numbers=found.numbers.copy(), reason=found.reason.copy(), iterations=found.iterations.copy(),
        views=found.views.copy(), shift=found.shift.copy(),
        response=None if found.response is None else found.response.copy(),
    )  # fmt: skip
    fresh = grown.found.copy()
    for k in range(passes):
        todo = _beside(grown, fresh, grid.stride)
        before = grown.found.copy()
        # rows that no neighbour reaches have nothing to go on from
        waiting = ~before & np.isnan(grown.t) & (grown.reason == Reason.NO_START)
        tried = todo | waiting if wanted is None else (todo | waiting) & wanted
        _run(work, grown, tried.astype(np.uint8), 1 if k % 2 == 0 else -1)
        fresh = grown.found & ~before
        if k and not fresh.any():  # one pass goes forth along the rows, the next one back
            break
    return grown


def _beside(grown: Refined, fresh: Mask, stride: int) -> Mask:
    """Pixels that are not refined beside fresh ones, with the planes of their best neighbours as starts."""
    rows, columns = fresh.shape
    near = np.zeros((rows + 2, columns + 2), bool)
    for dy, dx in AROUND:
        near[1 - dy : rows + 1 - dy, 1 - dx : columns + 1 - dx] |= fresh
    todo: Mask = near[1:-1, 1:-1] & ~grown.found
    row, column = np.nonzero(todo)
    best, starts = np.full(len(row), -np.inf, np.float32), np.empty((3, len(row)), np.float32)
    for dy, dx in AROUND:
        j, i = row + dy, column + dx
        inside = (j >= 0) & (j < rows) & (i >= 0) & (i < columns)
        j, i = np.where(inside, j, 0), np.where(inside, i, 0)
        correlation = grown.correlation[j, i]
        better = np.flatnonzero(inside & fresh[j, i] & (correlation > best))
        j, i = j[better], i[better]
        t, (a, b) = grown.t[j, i], grown.slopes[:, j, i]
        best[better] = correlation[better]
        starts[:, better] = t - stride * (dx * a + dy * b), a, b
    grown.numbers[:3, row, column] = starts
    return todo


@dataclass(frozen=True, slots=True, kw_only=True)
class _Work:
    """What all pixels share."""

    reference: Array
    sources: Sequence[Source]
    grid: PixelGrid
    options: RefineOptions
    autocovariance: Array | None
    threads: int

    @classmethod
    def of(
        cls,
        reference: Array,
        sources: Sequence[Source],
        grid: PixelGrid,
        options: RefineOptions | None,
        autocovariance: Array | None,
        threads: int,
    ) -> _Work:
        side = 2 * LAG + 1
        if not 1 <= len(sources) <= MOST_SOURCES:
            raise InputError("depth_map.source_count", n=len(sources), most=MOST_SOURCES)
        if autocovariance is not None and autocovariance.shape != (len(sources) + 1, side, side):
            raise InputError(
                "depth_map.array_shape",
                array="autocovariances",
                shape=list(autocovariance.shape),
                needed=[len(sources) + 1, side, side],
            )
        last = grid.y0 + (grid.rows - 1) * grid.stride, grid.x0 + (grid.columns - 1) * grid.stride
        if min(grid.x0, grid.y0) < 0 or last[0] >= reference.shape[0] or last[1] >= reference.shape[1]:
            raise InputError(
                "depth_map.grid_outside",
                x_px=last[1],
                y_px=last[0],
                width_px=reference.shape[1],
                height_px=reference.shape[0],
            )
        plain = [Source(grey=np.ascontiguousarray(s.grey, np.float32), transfer=s.transfer) for s in sources]
        cov = None if autocovariance is None else np.ascontiguousarray(autocovariance, np.float32)
        grey = np.ascontiguousarray(reference, np.float32)
        return cls(
            reference=grey, sources=plain, grid=grid, options=options or RefineOptions(), autocovariance=cov,
            threads=max(1, threads),
        )  # fmt: skip


def _empty(work: _Work, start: Array, *, response: bool) -> Refined:
    sources = work.sources
    shape = (work.grid.rows, work.grid.columns)
    if start.shape != (3, *shape):
        raise InputError("depth_map.array_shape", array="starts", shape=list(start.shape), needed=[3, *shape])
    numbers = np.full((len(NUMBERS), *shape), np.nan, np.float32)
    numbers[:3] = start
    side = 2 * work.options.half + 1
    return Refined(
        numbers=numbers, reason=np.full(shape, Reason.NO_START, np.uint8), iterations=np.zeros(shape, np.uint8),
        views=np.zeros(shape, np.int32), shift=np.zeros((*shape, len(sources), 2), np.float32),
        left=left_by_interpolation(work.autocovariance, len(sources) + 1),
        response=np.zeros((*shape, side * side), np.float32) if response else None,
    )  # fmt: skip


def used_sources(views: Index, count: int) -> Index:
    """(..., count) 1 where a pixel was measured with a source, by its bits."""
    return (np.asarray(views)[..., None] >> np.arange(count)) & 1


def cubic(f: Array) -> tuple[Array, Array]:
    """Weights (..., 4) of the four neighbours for fractions (...), and of the derivative (Keys 1981, a = -1/2)."""
    f2, f3 = f**2, f**3
    w = [-0.5 * f3 + f2 - 0.5 * f, 1.5 * f3 - 2.5 * f2 + 1, -1.5 * f3 + 2 * f2 + 0.5 * f, 0.5 * f3 - 0.5 * f2]
    d = [-1.5 * f2 + 2 * f - 0.5, 4.5 * f2 - 5 * f, -4.5 * f2 + 4 * f + 0.5, 1.5 * f2 - f]
    return np.stack(w, axis=-1), np.stack(d, axis=-1)


def interpolated_lags() -> Array:
    """(7,) autocovariance of interpolated white noise of variance 1, by lag from -3 to 3 px, on average over places."""
    f = (np.arange(64) + 0.5) / 64
    w = np.pad(cubic(f)[0], ((0, 0), (LAG, LAG)))
    return np.array([np.mean(np.sum(w * np.roll(w, k, axis=1), axis=1)) for k in range(-LAG, LAG + 1)])


def left_by_interpolation(autocovariance: Array | None, views: int) -> Array:
    """(views,) mean variance of interpolated grey values, that of grey values being 1; the first view stays as it is.

    autocovariance  (views, 7, 7) by lag; None: white
    """
    lags = interpolated_lags()
    if autocovariance is None:
        return np.append(1.0, np.full(views - 1, lags[LAG] ** 2))
    return np.append(1.0, np.einsum("vji,j,i->v", autocovariance[1:].astype(float), lags, lags))


def _run(work: _Work, found: Refined, todo: Array, chain: int) -> None:
    """Refine in place; chain 1 or -1: a pixel without a start goes on from its left or right neighbour."""
    module = native.required()
    o, grid = work.options, work.grid
    fit = (o.half, o.sigma, o.iterations, o.step, o.reach, o.slope, o.correlation, o.contrast, o.share, o.apart)
    tables = [(t.u0_px, t.v0_px, t.step_px, t.t0, t.dt) for t in (s.transfer for s in work.sources)]

    def strip(begin: int) -> None:
        module.refine_surface(
            work.reference, [s.grey for s in work.sources], [s.transfer.places for s in work.sources], tables, fit,
            (grid.x0, grid.y0, grid.stride), begin, min(begin + STRIP, grid.rows), chain, work.autocovariance,
            found.numbers, todo, found.reason, found.iterations, found.views, found.shift, found.response,
        )  # fmt: skip

    begins = range(0, grid.rows, STRIP)
    if work.threads == 1:
        for begin in begins:
            strip(begin)
    else:
        with ThreadPoolExecutor(work.threads) as pool:
            list(pool.map(partial(strip), begins))
