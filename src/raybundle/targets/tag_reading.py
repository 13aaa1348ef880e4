"""Small square tags, read from their modules: which number a quadrangle bears that OpenCV could not read.

OpenCV cuts a quadrangle into modules of whole pixels and thresholds them; of modules of 1 to 2 px it reads as many as
its version can.  Here the grey values at the modules are correlated with every tag of the dictionary in every turn.
"""

from __future__ import annotations

import functools
from typing import Any

import cv2
import numpy as np
from scipy.special import bdtr

from raybundle.numerics.arrays import Array, Index

FALSE = 1e-3
"""Probability that a square with a dark rim and modules at random is read as a tag."""
WITHIN = 0.25
"""Of a module, on either side of its middle, over which its grey value is taken."""


def bits_of(tags: Any, number: int) -> Array:
    """(m, m) modules of a tag, rim included: 1 light, 0 dark."""
    side = tags.markerSize + 2
    return (cv2.aruco.generateImageMarker(tags, number, side) > 127).astype(float)


def least_correlation(modules: int, patterns: int) -> float:
    """Correlation of n modules with the best of k patterns that modules at random exceed with probability < FALSE.

    d or fewer of n random modules differ from one of k patterns with probability k sum_(i<=d) C(n, i) / 2^n; d wrong
    modules leave a correlation of about 1 - 2 d / n.  36h11: d = 3, which OpenCV allows, too; above 1 where the
    patterns are so short that nothing could be read.
    """
    allowed = np.flatnonzero(patterns * bdtr(np.arange(modules), modules, 0.5) < FALSE)
    return 1 - (2 * len(allowed) - 1) / modules


def read_modules(image: Array, corners: Array, tags: Any) -> tuple[Index, Array]:
    """Numbers (n,), -1 for none, of quadrangles and their corners (n, 4, 2), the tag's first one first.

    image    (h, w) uint8
    corners  (n, 4, 2) pixel frame, clockwise
    Read is what correlates by more than chance (`least_correlation`) and has a dark rim.
    """
    m = tags.markerSize
    if not len(corners):
        return np.zeros(0, int), corners
    grey = _modules(image, corners, m + 2)
    inner = grey[:, 1:-1, 1:-1].reshape(len(corners), -1)
    rim = np.ones((m + 2, m + 2), bool)
    rim[1:-1, 1:-1] = False
    codes = _turned(tags.bytesList.tobytes(), m)
    level, spread = inner.mean(axis=1), inner.std(axis=1)
    unit = (inner - level[:, None]) / np.maximum(spread, 1e-9)[:, None]
    share = codes.mean(axis=1)
    deviation = np.sqrt(np.maximum(share * (1 - share), 1e-9))
    r = unit @ ((codes - share[:, None]) / deviation[:, None]).T / codes.shape[1]
    best = r.argmax(axis=1)
    rows = np.arange(len(corners))
    step = r[rows, best] * spread / deviation[best]  # from dark to light
    dark = level - step * share[best]
    good = (r[rows, best] > least_correlation(codes.shape[1], len(codes))) & (
        np.abs(grey[:, rim].mean(axis=1) - dark) < step / 2
    )
    number, turn = best // 4, best % 4
    order = (np.arange(4) + turn[:, None]) % 4
    return np.where(good, number, -1), corners[rows[:, None], order]


def _modules(image: Array, corners: Array, side: int) -> Array:
    """(n, side, side) mean grey values of the modules of quadrangles."""
    steps = np.arange(side)[:, None] + 0.5 + np.array([-WITHIN, 0.0, WITHIN])
    u, v = np.meshgrid(steps.ravel(), steps.ravel())
    grid = np.column_stack([u.ravel(), v.ravel(), np.ones(u.size)])
    square = np.array([[0, 0], [side, 0], [side, side], [0, side]], np.float32)
    found = np.zeros((len(corners), side, side))
    for k, quadrangle in enumerate(corners):
        H = cv2.getPerspectiveTransform(square, quadrangle.astype(np.float32))
        p = grid @ H.T
        xy = (p[:, :2] / p[:, 2:] - 0.5).astype(np.float32)
        values = cv2.remap(image, xy[:, :1], xy[:, 1:], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE).reshape(
            side, 3, side, 3
        )
        found[k] = values.mean(axis=(1, 3))
    return found


@functools.lru_cache(maxsize=4)
def _turned(packed: bytes, side: int) -> Array:
    """(4 k, side^2) inner modules of all tags of a dictionary, as a quadrangle beginning at each corner shows them."""
    tags = cv2.aruco.Dictionary(np.frombuffer(packed, np.uint8).reshape(-1, -(-side * side // 8), 4), side)
    inner = np.stack([bits_of(tags, i)[1:-1, 1:-1] for i in range(len(tags.bytesList))])
    return np.stack([np.rot90(inner, -turn, axes=(1, 2)) for turn in range(4)], axis=1).reshape(-1, side * side)
