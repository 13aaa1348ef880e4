"""Planes through approximate or refined depths: what a refinement starts from."""

from __future__ import annotations

from itertools import product

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.surfaces.depths.refine import PixelGrid, Refined
from raybundle.surfaces.depths.sweep import Start

HALF = 2
"""Planes are fitted to (2 half + 1)^2 pixels."""
ROWS = 64
"""Of a picture that are done at once."""
FEWEST = 6
"""Of them that have to stand on the same thing: twice the unknowns of a plane."""


def fitted(t: Array, apart: float) -> Array:
    """(3, h, w) float32: depth parameter and its slopes by column and row [1 / px] of planes through (h, w) values.

    apart  difference of t from pixel to pixel above which they stand on different things: those take no part

    NaN where there is no value; slopes are NaN where fewer than six values take part.
    """
    h, w = t.shape
    padded = np.pad(t.astype(np.float32), HALF, constant_values=np.nan)
    found = np.empty((3, h, w), np.float32)
    for begin in range(0, h, ROWS):
        end = min(begin + ROWS, h)
        found[:, begin:end] = _fitted(padded[begin : end + 2 * HALF], apart)
    return found


def _fitted(padded: Array, apart: float) -> Array:
    """Those of some rows, padded with `HALF` pixels on all sides."""
    h, w = (n - 2 * HALF for n in padded.shape)
    t = padded[HALF:-HALF, HALF:-HALF]
    sums = np.zeros((9, h, w), np.float32)
    for v, u in product(range(-HALF, HALF + 1), repeat=2):
        d = padded[v + HALF : v + HALF + h, u + HALF : u + HALF + w] - t
        with np.errstate(invalid="ignore"):
            d = np.where(np.abs(d) <= apart * max(1, abs(u), abs(v)), d, np.nan)
        one = np.isfinite(d).astype(np.float32)
        d = np.where(one > 0, d, 0)
        for k, term in enumerate((one, u * one, v * one, u * u * one, u * v * one, v * v * one, d, u * d, v * d)):
            sums[k] += term
    n, su, sv, uu, uv, vv, st, ut, vt = sums
    few = n < FEWEST
    N = np.stack([n, su, sv, su, uu, uv, sv, uv, vv], axis=-1).reshape(h, w, 3, 3).astype(float)
    N[few] = np.eye(3)
    singular = np.linalg.det(N) < 1e-3
    N[singular] = np.eye(3)
    plane = np.linalg.solve(N, np.stack([st, ut, vt], axis=-1)[..., None])[..., 0]
    bad = few | singular
    plane[bad] = 0
    found = np.moveaxis(plane, -1, 0)
    found[1:, bad] = np.nan
    found[0] += t
    return found


def of_start(start: Start, grid: PixelGrid) -> Array:
    """(3, rows, columns) planes of approximate depths at the pixels of a grid."""
    planes = fitted(start.t, start.step_of_patch())
    planes[1:] /= start.scale
    xy = grid.xy_px
    at = np.floor(xy / start.scale).astype(int)
    i, j = np.minimum(at[..., 0], start.t.shape[1] - 1), np.minimum(at[..., 1], start.t.shape[0] - 1)
    du, dv = xy[..., 0] - (i + 0.5) * start.scale, xy[..., 1] - (j + 0.5) * start.scale
    t, a, b = planes[:, j, i]
    return np.stack([t + np.nan_to_num(a) * du + np.nan_to_num(b) * dv, a, b]).astype(np.float32)


def of_refined(found: Refined, coarse: PixelGrid, grid: PixelGrid) -> Array:
    """(3, rows, columns) at the pixels of a finer grid: the plane of the best of four refined pixels around each."""
    xy = grid.xy_px
    u, v = (xy[..., 0] - 0.5 - coarse.x0) / coarse.stride, (xy[..., 1] - 0.5 - coarse.y0) / coarse.stride
    left, top = np.floor(u).astype(int), np.floor(v).astype(int)
    best, plane = np.full(u.shape, -np.inf, np.float32), np.full((3, *u.shape), np.nan, np.float32)
    known = found.found
    for down, right in product((0, 1), repeat=2):
        j, i = np.clip(top + down, 0, coarse.rows - 1), np.clip(left + right, 0, coarse.columns - 1)
        du, dv = (u - i) * coarse.stride, (v - j) * coarse.stride
        # a pixel of the coarse grid itself has its own plane, however its neighbours correlate
        near = np.where(np.maximum(np.abs(du), np.abs(dv)) < 0.5, 2.0, found.correlation[j, i])
        near = np.where(known[j, i] & (np.maximum(np.abs(du), np.abs(dv)) < coarse.stride), near, -np.inf)
        better = near > best
        t, a, b = found.numbers[:3, j, i]
        candidate = np.stack([t + a * du + b * dv, a, b])
        best = np.where(better, near, best)
        plane = np.where(better, candidate, plane)
    return plane.astype(np.float32)
