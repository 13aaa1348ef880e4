"""The noise of grey values: how it is correlated from pixel to pixel, by what is left between photographs.

Patches of the reference are compared with what sources show there, on the refined surface, brightness and contrast
free. What is left is noise of both, and texture: where the surface is off by e pixels, the residual is e times the
gradient.  So the patches of the weakest texture show the noise.  A source's noise is smoothed by interpolation, as
is known, and the sum of both is solved for that of a single photograph.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.depths.refine import LAG, PixelGrid, Refined, RefineOptions, Source, cubic, interpolated_lags

PATCHES, HALF = 400, 12
"""Patches of 25 x 25 px: a lag of 3 px is then known to some 4 % of the variance from one of them, 0.2 % from all."""
FEWEST = 30
"""Patches that are needed; with fewer, noise is taken as white."""
SAME = 0.8
"""Share of refined pixels about a patch's middle: else it lies on an edge of things."""
WEAKEST = 0.2
"""Share of the patches, those of the weakest texture, that show the noise."""


def autocovariance(reference: Array, sources: Sequence[Source], grid: PixelGrid, found: Refined) -> Array:
    """(1 + sources, 7, 7) float32 by lag from -3 to 3 px in y and x, 1 in the middle; the same for all views.

    Limits: noise that goes with the brightness, or that a camera has smoothed over more than 3 px.
    """
    own = np.zeros((2 * LAG + 1, 2 * LAG + 1))
    own[LAG, LAG] = 1
    middles = _middles(reference, grid, found)
    products, textures = list[Array](), list[Array]()
    for s, source in enumerate(sources):
        seen = middles[(found.views[middles[:, 0], middles[:, 1]] >> s) & 1 == 1]
        residuals, gradients = _patches(reference, source, grid, found, seen)
        products.append(_by_lag(residuals))
        textures.append(_by_lag(gradients))
    if sum(len(p) for p in products) >= FEWEST:
        own = _without_interpolation(_of_weakest(np.concatenate(products), np.concatenate(textures)))
    return np.repeat(own[None], 1 + len(sources), axis=0).astype(np.float32)


def lost_freedom(table: Array, options: RefineOptions) -> float:
    """By how much fewer independent grey values a window has than one of white noise."""
    side = np.arange(-options.half, options.half + 1.0)
    w = np.exp(-(side**2) / (2 * options.sigma**2))
    overlap = np.correlate(w, w, "full")
    overlap = overlap[len(side) - 1 - LAG : len(side) + LAG] / overlap.max()
    return max(1.0, float(np.einsum("ji,j,i->", table.astype(float), overlap, overlap)))


def _middles(reference: Array, grid: PixelGrid, found: Refined) -> Array:
    """(n, 2) rows and columns of the grid at which patches are compared, evenly spread."""
    known = found.found
    reach = max(1, HALF // grid.stride)
    padded = np.pad(known, reach).astype(np.float64).cumsum(axis=0).cumsum(axis=1)
    padded = np.pad(padded, ((1, 0), (1, 0)))
    n = 2 * reach + 1
    around = padded[n:, n:] - padded[:-n, n:] - padded[n:, :-n] + padded[:-n, :-n]
    xy = grid.xy_px
    inside = (xy > HALF + 1).all(axis=-1) & (xy < np.array(reference.shape[::-1]) - HALF - 2).all(axis=-1)
    at = np.argwhere(known & inside & (around >= SAME * n * n))
    return at[np.linspace(0, len(at) - 1, min(PATCHES, len(at))).astype(int)] if len(at) else at.reshape(0, 2)


def _patches(reference: Array, source: Source, grid: PixelGrid, found: Refined, middles: Array) -> tuple[Array, Array]:
    """Residuals and gradients along the shift of depth (n, 25, 25) of patches, as grey values of the reference."""
    if not len(middles):
        none = np.zeros((0, 2 * HALF + 1, 2 * HALF + 1))
        return none, none
    side = np.arange(-HALF, HALF + 1)
    dv, du = np.meshgrid(side, side, indexing="ij")
    row, column = middles.T
    x = grid.x0 + grid.stride * column[:, None, None] + du
    y = grid.y0 + grid.stride * row[:, None, None] + dv
    j = np.clip(np.round((y - grid.y0) / grid.stride).astype(int), 0, grid.rows - 1)
    i = np.clip(np.round((x - grid.x0) / grid.stride).astype(int), 0, grid.columns - 1)
    t, a, b = found.numbers[:3, j, i].astype(float)
    t = t + a * (x - grid.x0 - grid.stride * i) + b * (y - grid.y0 - grid.stride * j)
    t[~found.found[j, i]] = np.nan
    xy = np.stack([x + 0.5, y + 0.5], axis=-1).reshape(-1, 2)
    step = source.transfer.dt * 1e-3
    place = source.transfer.at(xy, t.ravel())
    along = (source.transfer.at(xy, t.ravel() + step) - place) / step
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    g, gx, gy = (a.reshape(t.shape) for a in _sampled(source.grey, place))
    steep = gx * along[:, 0].reshape(t.shape) + gy * along[:, 1].reshape(t.shape)
    T = reference[y, x].astype(float)
    good: Mask = np.asarray(np.isfinite(g) & np.isfinite(steep) & np.isfinite(T))
    enough = good.mean(axis=(1, 2)) >= SAME
    good, T, g, steep = good[enough], T[enough], g[enough], steep[enough]
    n = good.sum(axis=(1, 2))[:, None, None]
    one, other = (a - np.where(good, a, 0).sum(axis=(1, 2), keepdims=True) / n for a in (T, np.where(good, g, 0)))
    square, product = (np.where(good, other * a, 0).sum(axis=(1, 2), keepdims=True) for a in (other, one))
    gain = product / np.maximum(square, 1e-12)
    return np.where(good, one - gain * other, np.nan), np.where(good, gain * steep, np.nan)


def _sampled(grey: Array, place: Array) -> tuple[Array, Array, Array]:
    """Grey values and gradients (n,) at places (n, 2), as the refinement takes them; NaN beyond the image."""
    h, w = grey.shape
    x, y = (place - 0.5).T
    with np.errstate(invalid="ignore"):
        inside = (x >= 1) & (y >= 1) & (x < w - 2) & (y < h - 2)
    x, y = np.where(inside, x, 1.0), np.where(inside, y, 1.0)
    i, j = x.astype(int), y.astype(int)
    (wx, sx), (wy, sy) = cubic(x - i), cubic(y - j)
    four = np.arange(-1, 3)
    c = grey[(j[:, None] + four)[:, :, None], (i[:, None] + four)[:, None, :]].astype(float)
    found = [np.einsum("nji,nj,ni->n", c, b, a) for a, b in ((wx, wy), (sx, wy), (wx, sy))]
    g, gx, gy = (np.where(inside, f, np.nan) for f in found)
    return g, gx, gy


def _by_lag(images: Array) -> Array:
    """(n, 7, 7) mean products of values of images (n, h, w) that lie so far apart; NaN take no part."""
    there = np.isfinite(images)
    values = np.where(there, images, 0)
    mean = values.sum(axis=(1, 2)) / np.maximum(there.sum(axis=(1, 2)), 1)
    values = np.where(there, values - mean[:, None, None], 0)
    size = tuple(n + LAG for n in images.shape[1:])

    def products(a: Array) -> Array:
        spectrum = np.fft.rfft2(a, size)
        return np.fft.irfft2(spectrum.real**2 + spectrum.imag**2, size)

    lags = np.arange(-LAG, LAG + 1)
    at = np.ix_(np.arange(len(images)), lags, lags)
    return products(values)[at] / np.maximum(np.round(products(there.astype(float))[at]), 1)


def _of_weakest(products: Array, textures: Array) -> Array:
    """(7, 7) products of lags, 1 in the middle, of the patches with the weakest gradients: medians over them."""
    steep = textures[:, LAG, LAG]
    weak = steep <= np.quantile(steep, WEAKEST)
    return np.median(products[weak] / products[weak, LAG, LAG][:, None, None], axis=0)


def _without_interpolation(both: Array) -> Array:
    """(7, 7) autocovariance of one photograph, 1 in the middle, by that of its difference to an interpolated one."""
    side = 2 * LAG + 1
    lags = interpolated_lags()
    smooth = np.zeros((side, side))
    for k in range(side):
        for m in range(side):
            if abs(k - m) <= LAG:
                smooth[k, m] = lags[k - m + LAG]
    own = np.linalg.solve(np.eye(side * side) + np.kron(smooth, smooth), both.ravel()).reshape(side, side)
    if not own[LAG, LAG] > 0:
        own = np.zeros((side, side))
        own[LAG, LAG] = 1
    return np.clip(own / own[LAG, LAG], -1, 1)
