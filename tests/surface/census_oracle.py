"""Census, costs and paths with NumPy, against which the kernels are held to the last bit."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.surfaces.depths.sweep import FRACTION, NOWHERE

ACROSS, DOWN = 4, 3
"""The window: 9 x 7 pixels."""
NOBODY, NEUTRAL, WALL = 255, 28, 200
WAYS = ((1, 0), (-1, 1), (0, 1), (1, 1), (-1, 0), (1, -1), (0, -1), (-1, -1))
"""Directions of the paths: columns, rows."""


def census_twin(image: Array) -> Array:
    """(height, width) uint64: 62 comparisons with neighbours; the highest bit alone where there is no room."""
    h, w = image.shape
    found = np.full((h, w), 1 << 63, np.uint64)
    if h <= 2 * DOWN or w <= 2 * ACROSS:
        return found
    middle = image[DOWN : h - DOWN, ACROSS : w - ACROSS]
    bits = np.zeros(middle.shape, np.uint64)
    for j, i in product(range(2 * DOWN + 1), range(2 * ACROSS + 1)):
        if (j, i) != (DOWN, ACROSS):
            bits = bits << np.uint64(1) | (image[j : j + len(middle), i : i + middle.shape[1]] < middle).astype(
                np.uint64
            )
    found[DOWN : h - DOWN, ACROSS : w - ACROSS] = bits
    return found


def costs_twin(reference: Array, sources: Sequence[Array], places: Sequence[Array], step: int) -> Array:
    """(height, width, levels) uint8: comparisons that differ, the mean of the two best sources.

    places  (levels, rows, columns, 2) in each source at every step-th pixel, as `fixed` makes them
    """
    h, w = reference.shape
    levels, rows, columns, _ = places[0].shape
    first = np.full((h, w, levels), NOBODY, np.uint8)
    second = first.copy()
    y, x = np.arange(h), np.arange(w)
    r, c = np.minimum(y // step, rows - 2), np.minimum(x // step, columns - 2)
    below = (y - r * step)[:, None, None]
    for census, table in zip(sources, places, strict=True):
        for level in range(levels):
            top, low = (table[level][rows_].astype(np.int64) for rows_ in (r, r + 1))
            near = ((top != NOWHERE) & (low != NOWHERE)).all(axis=2)  # (h, columns)
            from_left = top + _shared((low - top) * below, step)
            steps = _shared(np.diff(from_left, axis=1), step)
            at = (from_left[:, c] + steps[:, c] * (x - c * step)[None, :, None]) >> FRACTION
            inside = near[:, c] & near[:, c + 1] & (at >= 0).all(axis=2) & (at < census.shape[::-1]).all(axis=2)
            at = np.where(inside[:, :, None], at, 0)
            differ = reference ^ census[at[..., 1], at[..., 0]]
            known = inside & (differ >> np.uint64(63) == 0)
            cost = np.where(known, np.bitwise_count(differ), NOBODY).astype(np.uint8)
            worse = np.maximum(first[..., level], cost)
            first[..., level] = np.minimum(first[..., level], cost)
            second[..., level] = np.minimum(second[..., level], worse)
    mean = ((first.astype(np.int32) + second + 1) // 2).astype(np.uint8)
    return np.where(first == NOBODY, np.uint8(NEUTRAL), np.where(second == NOBODY, first, mean))


def _shared(a: Array, step: int) -> Array:
    """A / step without its remainder, towards zero."""
    return np.sign(a) * (np.abs(a) // step)


def aggregate_twin(image: Array, cost: Array, slope: int, jump: int, least: int) -> tuple[Array, Array]:
    """Level and margin (height, width) float32 of the smallest sum of costs along eight paths."""
    h, w, levels = cost.shape
    total = np.zeros(cost.shape, np.int64)
    grey = image.astype(np.int64)
    for dx, dy in WAYS:
        found = np.zeros(cost.shape, np.int64)
        rows = range(h) if dy >= 0 else range(h - 1, -1, -1)
        columns = range(w) if dx >= 0 else range(w - 1, -1, -1)
        for y, x in product(rows, columns):
            j, i = y - dy, x - dx
            if not (0 <= j < h and 0 <= i < w):
                found[y, x] = cost[y, x]
                continue
            before = np.pad(found[j, i], 1, constant_values=WALL)
            any_level = before[1:-1].min() + max(least, jump - abs(int(grey[y, x] - grey[j, i])))
            beside = np.minimum(before[:-2], before[2:]) + slope
            found[y, x] = np.minimum(np.minimum(before[1:-1], beside), any_level) - before[1:-1].min() + cost[y, x]
        total += found
    best = total.argmin(axis=2)
    level = best.astype(np.float32)
    here = np.take_along_axis(total, best[..., None], 2)[..., 0]
    inner = (best > 0) & (best + 1 < levels)
    before, behind = (
        np.take_along_axis(total, np.clip(best + k, 0, levels - 1)[..., None], 2)[..., 0] for k in (-1, 1)
    )
    bend = before + behind - 2 * here
    use = inner & (bend > 0)
    level[use] += (np.float32(0.5) * (before - behind).astype(np.float32) / np.maximum(bend, 1).astype(np.float32))[use]
    far = np.abs(np.arange(levels) - best[..., None]) > 2
    other = np.where(far, total, 65535).min(axis=2)
    return level, other.astype(np.float32) / np.maximum(here, 1).astype(np.float32)
