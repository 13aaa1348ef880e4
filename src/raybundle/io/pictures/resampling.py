"""One resampler for all pictures that are made of others: values at places between pixels.

Weights are those of the exact places: of the two pixels to a side linearly, of four by the cubic of Keys (1981) with
a = -1/2, which is exact for polynomials up to the second degree, so that it moves nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np

from raybundle.numerics.arrays import Array, Mask

Kernel = Literal["nearest", "bilinear", "cubic"]
REACH: dict[Kernel, int] = {"nearest": 1, "bilinear": 2, "cubic": 4}
"""Pixels to a side from which a value is made."""
BANDS = 4
"""That the library takes at once."""
TYPES = ("uint8", "uint16", "int16", "float32", "float64")
"""Of values that it takes; others go through double precision."""


def sampled(pixels: Array, xy: Array, kernel: Kernel = "cubic", known: Mask | None = None) -> tuple[Array, Mask]:
    """Values (m, n[, bands]) of a picture (h, w[, bands]) at places (m, n, 2) [px], and where there are any (m, n).

    xy      from the outer corner of the first pixel; NaN, or beside the picture: no value there
    known   (h, w) pixels that mean something; a value that would be made of another one is none
    Beyond the centres of the outer pixels these are repeated.
    """
    height, width = pixels.shape[:2]
    x, y = xy[..., 0], xy[..., 1]
    seen: Mask = (x >= 0) & (x <= width) & (y >= 0) & (y <= height)  # NaN is not
    reach = REACH[kernel]
    at = np.where(seen[..., None], xy, 0.0)
    if kernel != "nearest":
        at -= 0.5  # from the centre of the first pixel
    base = np.floor(at)
    first = base - (reach - 1) // 2
    bands = 1 if pixels.ndim == 2 else pixels.shape[2]
    flat = pixels.reshape(height, width, bands)
    parts = [_weighted(flat[..., k : k + BANDS], first, at - base, kernel) for k in range(0, bands, BANDS)]
    values = parts[0] if len(parts) == 1 else np.concatenate(parts, axis=2)
    if known is not None and not known.all():
        seen &= _of_known(known, first, reach)
    return values.reshape(*seen.shape, *pixels.shape[2:]), seen


def _weighted(pixels: Array, first: Array, share: Array, kernel: Kernel) -> Array:
    """Weighted sums (m, n, bands) of pixels, of which the first stands at columns and rows (m, n, 2)."""
    import cv2

    kind = pixels.dtype
    taken = np.ascontiguousarray(pixels if kind.name in TYPES else pixels.astype(np.float64))
    column, row = (np.ascontiguousarray(first[..., k], np.float32) for k in (0, 1))

    def pixel(i: int, j: int) -> Array:
        found = cv2.remap(taken, column + i, row + j, cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE)
        return np.asarray(found).reshape(*column.shape, -1)

    if kernel == "nearest":
        return pixel(0, 0).astype(kind)
    precise = np.float64 if taken.dtype.itemsize > 2 else np.float32
    weights = [[w.astype(precise)[..., None] for w in WEIGHTS[kernel](share[..., k])] for k in (0, 1)]
    total = np.zeros((*column.shape, taken.shape[2]), precise)
    for j, down in enumerate(weights[1]):
        line = np.zeros_like(total)
        for i, across in enumerate(weights[0]):
            line += across * pixel(i, j)
        total += down * line
    if kind.kind in "iu":
        info = np.iinfo(kind)
        total = np.clip(np.rint(total), info.min, info.max)
    return total.astype(kind)


def _linear(t: Array) -> list[Array]:
    return [1 - t, t]


def _cubic(t: Array) -> list[Array]:
    """Keys 1981, equation 4 with a = -1/2; the distance to the second pixel is t."""
    return [
        t * (t * (2 - t) - 1) / 2,
        (t * t * (3 * t - 5) + 2) / 2,
        t * (t * (4 - 3 * t) + 1) / 2,
        t * t * (t - 1) / 2,
    ]


WEIGHTS: dict[Kernel, Callable[[Array], list[Array]]] = {"bilinear": _linear, "cubic": _cubic}


def _of_known(known: Mask, first: Array, reach: int) -> Mask:
    """(m, n) whether all pixels from which a value is made mean something; beyond the picture all do."""
    import cv2

    height, width = known.shape
    room = reach
    wide = cv2.copyMakeBorder(known.astype(np.uint8), room, room, room, room, cv2.BORDER_REPLICATE)
    whole = cv2.erode(
        wide, np.ones((reach, reach), np.uint8), anchor=(0, 0), borderType=cv2.BORDER_CONSTANT, borderValue=1
    )
    column, row = (np.clip(first[..., k] + room, 0, n + 2 * room - 1).astype(int) for k, n in ((0, width), (1, height)))
    return np.asarray(whole)[row, column] > 0


def between(at: Array, step: int) -> Array:
    """Values at every pixel of cells, linear between their corners (m + 1, n + 1, k)."""
    m, n = at.shape[0] - 1, at.shape[1] - 1
    share = (np.arange(step) / step).astype(at.dtype)
    lines = at[:, :-1, None] * (1 - share)[:, None] + at[:, 1:, None] * share[:, None]
    lines = lines.reshape(m + 1, n * step, at.shape[2])
    whole = lines[:-1, None] * (1 - share)[:, None, None] + lines[1:, None] * share[:, None, None]
    return whole.reshape(m * step, n * step, at.shape[2])
