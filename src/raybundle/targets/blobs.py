"""Candidates for dots: connected spots of a locally thresholded image whose moments are those of an ellipse.

The threshold lies half way between the darkest and the lightest grey value nearby, so that a narrow gap between a dot
and its ring stays open however the photograph is lit.  Spots of a few pixels are sought in the photograph itself,
larger ones in its halves, quarters and so on.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import cv2
import numpy as np

from raybundle.numerics.arrays import Array

NEARBY = 13
"""Side of the window of the threshold [px]."""
SMALLEST, LARGEST = 14, 400
"""Pixels of a spot on one level of the pyramid."""
WIDEST = 26
AGAIN = 2.8
"""Least mean radius of a spot on the higher levels: smaller ones were found on the level below [px]."""
LEAST_MAJOR = 2.6
"""Least semi-major axis [px]."""
FILLED = (0.3, 0.95)
"""Share of its bounding box that a spot fills."""
SLENDER = 0.24
"""Least ratio of the axes: a disc tilted by 76 degrees."""
LEAST_SIDE = 16


@dataclass(frozen=True, slots=True, kw_only=True)
class Blobs:
    """Elliptic spots, in the pixel frame of the whole photograph."""

    xy_px: Array
    """(n, 2)"""
    ellipse: Array
    """(n, 2, 2) C of (x - centre)' C^-1 (x - centre) = 1"""
    sign: Array
    """(n,) +1 light on dark, -1 dark on light"""


def find_blobs(image: Array, contrast: float, threads: int = 1) -> Blobs:
    """Elliptic spots, dark and light, of all sizes from a radius of about 2.5 px.

    image     (h, w) uint8
    contrast  least difference of grey values nearby
    """
    levels, scale = [(1, image)], 1
    while min(levels[-1][1].shape) >= 2 * LEAST_SIDE:
        scale, below = 2 * scale, levels[-1][1]
        # an odd last row or column is left out: the frame keeps its scale of exactly two
        below = below[: below.shape[0] // 2 * 2, : below.shape[1] // 2 * 2]
        half = (below.shape[1] // 2, below.shape[0] // 2)
        levels.append((scale, cv2.resize(below, half, interpolation=cv2.INTER_AREA)))
    tasks = [(level, sign, contrast, scale) for scale, level in levels for sign in (1, -1)]
    if threads > 1:
        with ThreadPoolExecutor(threads) as pool:
            found = list(pool.map(lambda t: _spots_of_level(*t), tasks))
    else:
        found = [_spots_of_level(*t) for t in tasks]
    return Blobs(
        xy_px=np.concatenate([xy for xy, _ in found]),
        ellipse=np.concatenate([C for _, C in found]),
        sign=np.concatenate([np.full(len(xy), sign) for (xy, _), (_, sign, _, _) in zip(found, tasks, strict=True)]),
    )


def _spots_of_level(image: Array, sign: int, contrast: float, scale: int) -> tuple[Array, Array]:
    """Spots of one colour on one level, in the frame of the whole photograph."""
    kernel = np.ones((NEARBY, NEARBY), np.uint8)
    low, high = cv2.erode(image, kernel), cv2.dilate(image, kernel)
    _, busy = cv2.threshold(cv2.subtract(high, low), np.ceil(contrast) - 1, 255, cv2.THRESH_BINARY)
    middle = cv2.addWeighted(low, 0.5, high, 0.5, 0)
    beyond = cv2.compare(image, middle, cv2.CMP_GT if sign > 0 else cv2.CMP_LT)
    xy, C = _spots(cv2.bitwise_and(beyond, busy), AGAIN if scale > 1 else 0.0)
    return xy * scale, C * scale**2


def _spots(mask: Array, least: float) -> tuple[Array, Array]:
    """Centres and C of elliptic components of at least this mean radius."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=4, ltype=cv2.CV_32S)
    left, top, w, h, area = (c.astype(np.int64) for c in stats.T)
    fill = area / (w * h)
    plausible = (area >= SMALLEST) & (area <= LARGEST) & (w <= WIDEST) & (h <= WIDEST)
    plausible &= (fill >= FILLED[0]) & (fill <= FILLED[1])
    plausible[0] = False
    which = np.flatnonzero(plausible)
    left, top, w, h, area = (c[which] for c in (left, top, w, h, area))
    size = w * h
    row = np.repeat(np.arange(len(which)), size)
    at = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
    y, x = at // w[row], at % w[row]
    within = labels[top[row] + y, left[row] + x] == which[row]
    row, x, y = row[within], x[within] + 0.5, y[within] + 0.5

    def total(value: Array) -> Array:
        return np.bincount(row, value, minlength=len(which)) / area

    cx, cy = total(x), total(y)
    # a pixel is not a point: its own extent belongs to the spot
    xx, xy, yy = total(x * x) - cx**2 + 1 / 12, total(x * y) - cx * cy, total(y * y) - cy**2 + 1 / 12
    det = xx * yy - xy**2
    roundness = 4 * np.pi * np.sqrt(np.maximum(det, 0)) / area
    half, root = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
    good = (abs(roundness - 1) < 0.06 + 0.6 / np.sqrt(area)) & (half - root > SLENDER**2 * (half + root))
    good &= (area >= np.pi * least**2) & (4 * (half + root) >= LEAST_MAJOR**2)
    C = 4 * np.stack([xx, xy, xy, yy], axis=1).reshape(-1, 2, 2)
    return np.stack([left + cx, top + cy], axis=1)[good], C[good]
