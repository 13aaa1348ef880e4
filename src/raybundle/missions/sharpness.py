"""How blurred photographs are, measured against the others of their set.

The mean square of the difference of grey values one pixel apart, by that eight pixels apart, does not depend on the
contrast of what is photographed and falls with every blur: the structure function of a blurred image begins as a
parabola.  What a fall means in pixels is found by blurring photographs of the set itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Mask

TILE = 192
"""Side of the squares that are looked at [px]."""
TILES = (5, 5)
NEAR, FAR = 1, 8
"""Differences over so many pixels are compared."""
LENGTHS = (0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0)
"""Motions [px] by which photographs are blurred for the scale."""
NEIGHBOURS = 9
"""Photographs in the order of their time with which one is compared first."""
SURE = 4.0
"""Robust standard deviations of the set from which on a photograph counts as other than the rest."""
ROUGH = 0.5
"""Share of the tiles that are used: those with the most texture."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sharpness:
    """Of one photograph."""

    ratio: Array
    """(2,) of mean squares near by far, along rows and along columns; NaN where there is no texture"""


def tiles(grey: Array) -> Array:
    """(k, side, side) squares spread over a photograph, those with the most texture."""
    side = min(TILE, *grey.shape)
    rows, columns = (
        np.linspace(0.1, 0.9, n) * (size - side) for n, size in zip(TILES, grey.shape, strict=True)
    )  # fmt: skip
    found = np.array([grey[int(r) : int(r) + side, int(c) : int(c) + side] for r in rows for c in columns], np.float32)
    texture = np.array([min(_mean_square(t, FAR)) for t in found])
    return found[np.argsort(-texture)[: max(1, int(len(found) * ROUGH))]]


def _mean_square(tile: Array, lag: int) -> tuple[float, float]:
    """Of differences along rows and along columns."""
    along, down = tile[:, lag:] - tile[:, :-lag], tile[lag:] - tile[:-lag]
    return float(np.mean(along * along)), float(np.mean(down * down))


def sharpness(chosen: Array) -> Sharpness:
    """Of the squares (k, side, side) of a photograph."""
    near = np.sum([_mean_square(t, NEAR) for t in chosen], axis=0)
    far = np.sum([_mean_square(t, FAR) for t in chosen], axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        return Sharpness(ratio=np.where(far > 0, near / far, np.nan))


def blurred(tile: Array, length: float, axis: int) -> Array:
    """A square (side, side) as an even motion of a length [px] along an axis smears it; its borders are cut off.

    Between pixels grey values are linear, so that a pixel weighs as its tent's part within the motion.
    """
    whole = int(np.ceil(length / 2)) + 1
    offsets = np.arange(-whole, whole + 1)
    weight = _tent(offsets + length / 2) - _tent(offsets - length / 2) if length > 0 else (offsets == 0).astype(float)
    weight = weight / weight.sum()
    size = tile.shape[axis] - 2 * whole
    moved = (np.take(tile, np.arange(whole + o, whole + o + size), axis=axis) for o in offsets.tolist())
    return np.sum([w * part for w, part in zip(weight.tolist(), moved, strict=True)], axis=0)


def _tent(x: Array) -> Array:
    """The integral of 1 - |x| from -1 on."""
    x = np.clip(x, -1.0, 1.0)
    return np.where(x < 0, (x + 1) ** 2 / 2, 1 - (1 - x) ** 2 / 2)


@dataclass(frozen=True, slots=True, kw_only=True)
class Blur:
    """Blur of the photographs of a set, beyond that of their middle."""

    px: Array
    """(n,) length of an even motion during the exposure that would do the same, the greater of both axes; NaN where not
    known"""
    other: Mask
    """(n,) whether it is beyond the scatter of the set"""


def blur_of(found: Sequence[Sharpness], samples: Sequence[Array]) -> Blur:
    """Blur of each photograph.

    found    of all, in the order of their time: those taken one after the other see much the same
    samples  squares (k, side, side) of some photographs of the set, by which the scale is made
    Limits: a blur that all photographs share, and blur of what has no texture.
    """
    ratio = np.array([f.ratio for f in found]).reshape(-1, 2)
    if not len(samples) or not np.isfinite(ratio).all(axis=1).any():
        return Blur(px=np.full(len(ratio), np.nan), other=np.zeros(len(ratio), bool))
    log = np.log(ratio)
    known: Mask = np.asarray(np.isfinite(log).all(axis=1))
    scale = [_scale(samples, 1 - axis, axis) for axis in (0, 1)]
    px, other = np.zeros(len(ratio)), np.zeros(len(ratio), bool)
    for usual in (_running_median(log, known), np.median(log[known], axis=0)):
        fall = log - usual
        each = np.stack(
            [np.interp(-fall[:, k], -scale[k], np.array(LENGTHS), left=0.0) for k in (0, 1)], axis=1
        )  # fmt: skip
        apart = fall[:, :1] - fall[:, 1:]  # motion takes from one axis what the scene has along both
        beyond = np.any((_beyond(fall, known) | _beyond(np.hstack([apart, -apart]), known)) & (each > 0), axis=1)
        px = np.where(beyond | ~other, np.maximum(px * other, each.max(axis=1)), px)
        other |= beyond
    return Blur(px=np.where(known, px, np.nan), other=other & known)


def _running_median(values: Array, known: Mask) -> Array:
    """Medians (n, 2) over each photograph and those taken next to it, which see much the same."""
    rows = np.flatnonzero(known)
    n = len(rows)
    window = min(NEIGHBOURS, n)
    first = np.clip(np.arange(n) - window // 2, 0, n - window)
    result = np.full(values.shape, np.nan)
    result[rows] = [np.median(values[rows[k : k + window]], axis=0) for k in first]
    return result


def _beyond(values: Array, known: Mask) -> Mask:
    """Which values (n, 2) lie below the scatter of their column."""
    away = values - np.median(values[known], axis=0)
    return away < -SURE * np.maximum(1.4826 * np.median(np.abs(away[known]), axis=0), 1e-3)


def _scale(samples: Sequence[Array], axis: int, column: int) -> Array:
    """Logarithms of the ratio by that without blur, (len(LENGTHS),), falling; a mean over the samples."""
    rows: list[Array] = []
    for chosen in samples:
        ratios = [sharpness(np.array([blurred(t, length, axis) for t in chosen])).ratio[column] for length in LENGTHS]
        rows.append(np.log(np.array(ratios) / ratios[0]))
    return np.minimum.accumulate(np.mean(rows, axis=0) - 1e-9 * np.arange(len(LENGTHS)))
