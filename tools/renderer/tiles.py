"""Tiles of ground: the height of each above the smooth relief, and its classes of place.

A tile is drawn on nodes x (1, n) and y (m, 1) [m] from its centre, out to `half` (x, y) [m]; it returns heights
(m, n) [m] and classes (m, n), -1 where the ground is not changed.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from .classes import BORDER, CLUTTER, PATTERN, RIDGE, SLOPE, SMOOTH, STEP, WEAK

Array = NDArray[np.float64]
Drawn = tuple[NDArray[np.float32], NDArray[np.int8]]
SLOPE_DEG = 33.0


def inside(x: Array, y: Array, half: tuple[float, float]) -> Array:
    """Distance (m, n) [m] to the rim of a rectangle, positive inside."""
    return np.minimum(half[0] - np.abs(x), half[1] - np.abs(y))


def slope(x: Array, y: Array, half: tuple[float, float], gsd: float, rng: np.random.Generator) -> Drawn:
    """A truncated pyramid with faces of 33 degrees, its edges rounded to radii of many pixels."""
    del rng
    cell = float(x[0, 1] - x[0, 0])
    tangent = np.tan(np.radians(SLOPE_DEG))
    rise = 0.36 * min(half)
    rim = 12 * gsd  # room for rounding
    height = np.clip(inside(x, y, half) - rim, 0, rise) * tangent
    factor = max(int(gsd / cell), 1) * 2
    coarse = np.asarray(ndimage.gaussian_filter(height[::factor, ::factor], 8 * gsd / (cell * factor)))
    ratio = [n / m for n, m in zip(height.shape, coarse.shape, strict=True)]
    height = np.asarray(ndimage.zoom(coarse, ratio, order=3))
    dy, dx = np.gradient(height, cell)
    steep = np.hypot(dx, dy)
    codes = np.full(height.shape, BORDER, dtype=np.int8)
    codes[np.abs(steep / tangent - 1) < 0.06] = SLOPE
    codes[steep < 0.1 * tangent] = SMOOTH
    return height.astype(np.float32), codes


def ridge(x: Array, y: Array, half: tuple[float, float], gsd: float, rng: np.random.Generator) -> Drawn:
    """Roofs side by side with faces of 33 degrees: sharp ridges, valleys, and eaves above the ground around them."""
    del rng
    tangent = np.tan(np.radians(SLOPE_DEG))
    count = max(round(2 * half[0] / (120 * gsd)), 2)
    period = 2 * half[0] / count
    phase = np.mod(x + half[0], period)
    cell = float(x[0, 1] - x[0, 0])
    within = np.clip(inside(x, y, half) / cell + 0.5, 0, 1)
    height = (20 * gsd + tangent * (period / 2 - np.abs(phase - period / 2))) * within
    crease = np.minimum(np.abs(phase - period / 2), np.minimum(phase, period - phase))
    codes = np.full(height.shape, -1, dtype=np.int8)
    codes[within > 0] = SLOPE
    codes[(within > 0) & (np.broadcast_to(crease, height.shape) < cell)] = RIDGE
    codes[np.abs(inside(x, y, half)) < 1.5 * cell] = RIDGE
    return height.astype(np.float32), codes


def step(x: Array, y: Array, half: tuple[float, float], gsd: float, rng: np.random.Generator) -> Drawn:
    """Blocks of several heights side by side, with vertical walls one cell wide."""
    cell = float(x[0, 1] - x[0, 0])
    counts = [max(round(2 * h / (100 * gsd)), 2) for h in half]
    heights = rng.choice(np.array([0, 8, 16, 30, 50]) * gsd, size=(counts[1] + 2, counts[0] + 2))
    heights[[0, -1]] = 0
    heights[:, [0, -1]] = 0
    weights, near = [], []
    for part, h, n in ((y.ravel(), half[1], counts[1]), (x.ravel(), half[0], counts[0])):
        walls = np.linspace(-h, h, n + 1)
        passed = np.clip((part[:, None] - walls) / cell + 0.5, 0, 1)
        weights.append(np.diff(np.pad(passed, ((0, 0), (1, 1)), constant_values=(1, 0)), axis=1) * -1)
        near.append(np.abs(part[:, None] - walls).min(axis=1) < 1.5 * cell)
    height = weights[0] @ heights @ weights[1].T
    rise = ndimage.maximum_filter(height, 3) - ndimage.minimum_filter(height, 3)
    codes = np.full(height.shape, -1, dtype=np.int8)
    codes[np.broadcast_to(inside(x, y, half), height.shape) > 0] = SMOOTH
    codes[(near[0][:, None] | near[1][None, :]) & (rise > 2 * gsd)] = STEP
    return height.astype(np.float32), codes


def clutter(x: Array, y: Array, half: tuple[float, float], gsd: float, rng: np.random.Generator) -> Drawn:
    """Bumps 3 to 15 pixels high and wide, as dense as grass: the highest of all domes at a place counts."""
    cell = float(x[0, 1] - x[0, 0])
    height = np.zeros((y.size, x.size), dtype=np.float32)
    area = 4 * half[0] * half[1]
    count = int(2.2 * area / (7 * gsd) ** 2)
    middles = rng.uniform(-1, 1, size=(count, 2)) * (np.array(half) - 8 * gsd)
    radii = rng.uniform(1.5, 7.5, count) * gsd
    tops = 2 * radii * rng.uniform(0.7, 1.3, count)
    tops = np.clip(tops, 3 * gsd, 15 * gsd)
    for (u, v), radius, top in zip(middles, radii, tops, strict=True):
        j0, j1 = np.searchsorted(x.ravel(), [u - radius, u + radius])
        i0, i1 = np.searchsorted(y.ravel(), [v - radius, v + radius])
        r2 = ((x[:, j0:j1] - u) ** 2 + (y[i0:i1] - v) ** 2) / radius**2
        dome = top * np.sqrt(np.maximum(1 - r2, 0))
        height[i0:i1, j0:j1] = np.maximum(height[i0:i1, j0:j1], dome)
    height = np.asarray(ndimage.gaussian_filter(height, 0.5 * gsd / cell, truncate=3), dtype=np.float32)
    depth = np.broadcast_to(inside(x, y, half), height.shape)
    codes = np.full(height.shape, -1, dtype=np.int8)
    codes[depth > 0] = BORDER
    codes[depth > 15 * gsd] = CLUTTER
    return height, codes


def weak(x: Array, y: Array, half: tuple[float, float], gsd: float, rng: np.random.Generator) -> Drawn:
    """Level ground, whose texture has little contrast (`texture.weak_share`)."""
    return _level(x, y, half, 35 * gsd, WEAK, rng)


def pattern(x: Array, y: Array, half: tuple[float, float], gsd: float, rng: np.random.Generator) -> Drawn:
    """Level ground, paved with bricks that are nearly equal (`texture.bricks`)."""
    return _level(x, y, half, 25 * gsd, PATTERN, rng)


def _level(x: Array, y: Array, half: tuple[float, float], rim: float, code: int, rng: np.random.Generator) -> Drawn:
    del rng
    depth = inside(x, y, half)
    codes = np.full(depth.shape, -1, dtype=np.int8)
    codes[depth > 0] = BORDER
    codes[depth > rim] = code
    return np.zeros(depth.shape, dtype=np.float32), codes


TILES: dict[str, Callable[[Array, Array, tuple[float, float], float, np.random.Generator], Drawn]] = {
    "slope": slope,
    "ridge": ridge,
    "step": step,
    "clutter": clutter,
    "weak": weak,
    "pattern": pattern,
}
"""Tiles by the class of place they are made for."""
