"""How blurred photographs are, measured against the others of their set.

The mean square of the difference of grey values one pixel apart, by that four pixels apart, does not depend on the
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
NEAR, FAR = 1, 4
"""Differences over so many pixels are compared."""
LENGTHS = (1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0)
"""Motions [px] by which photographs are blurred for the scale."""
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
    """A square (side, side) smeared evenly over a length [px] of one axis; its borders are cut off."""
    whole = int(length) // 2 + 1
    offsets = np.arange(-whole, whole + 1)
    weight = np.clip(length / 2 - np.abs(offsets) + 0.5, 0, 1)
    weight = weight / weight.sum()
    size = tile.shape[axis] - 2 * whole
    moved = (np.take(tile, np.arange(whole + o, whole + o + size), axis=axis) for o in offsets.tolist())
    return np.sum([w * part for w, part in zip(weight.tolist(), moved, strict=True)], axis=0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Blur:
    """Blur of the photographs of a set, beyond that of their middle."""

    px: Array
    """(n,) length of an even motion that would do the same, the greater of both axes; NaN where not known"""
    other: Mask
    """(n,) whether it is beyond the scatter of the set"""


def blur_of(found: Sequence[Sharpness], samples: Sequence[Array]) -> Blur:
    """Blur of each photograph.

    found    of all
    samples  squares (k, side, side) of some photographs of the set, by which the scale is made
    What it does not tell: a blur that all photographs share, and blur of what has no texture.
    """
    ratio = np.array([f.ratio for f in found]).reshape(-1, 2)
    if not len(ratio) or not len(samples):
        return Blur(px=np.full(len(ratio), np.nan), other=np.zeros(len(ratio), bool))
    middle = np.nanmedian(ratio, axis=0)
    log = np.log(ratio / middle)
    scatter = 1.4826 * np.nanmedian(np.abs(log), axis=0)
    px = np.zeros(ratio.shape)
    for axis in (0, 1):
        scale = _scale(samples, 1 - axis, axis)
        px[:, axis] = np.interp(-log[:, axis], -scale, np.array(LENGTHS) - 1, left=0.0)
    other = log < -SURE * np.maximum(scatter, 1e-3)
    return Blur(
        px=np.where(np.isnan(ratio), np.nan, px).max(axis=1), other=np.asarray(np.any(other & (px > 0), axis=1))
    )


def _scale(samples: Sequence[Array], axis: int, column: int) -> Array:
    """Logarithms of the ratio by that without blur, (len(LENGTHS),), falling; a mean over the samples."""
    rows: list[Array] = []
    for chosen in samples:
        ratios = [sharpness(np.array([blurred(t, length, axis) for t in chosen])).ratio[column] for length in LENGTHS]
        rows.append(np.log(np.array(ratios) / ratios[0]))
    return np.minimum.accumulate(np.mean(rows, axis=0) - 1e-9 * np.arange(len(LENGTHS)))
