"""RootSIFT: scale-invariant features (Lowe 2004) with square-root descriptors (Arandjelović and Zisserman 2012)."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from raybundle.matching.features import FeatureMethod, Features, register, spread
from raybundle.numerics.arrays import Array

CONTRAST = 0.015
EDGE = 10.0
TILE_PX = 2048
OVERLAP_PX = 96
FEW = 0.6
"""Below this share of the wanted features the finest octave is searched as well."""


class RootSift(FeatureMethod):
    """OpenCV's detector, tile by tile, first without the octave of double size."""

    name = "rootsift"

    def detect(self, grey: Array, count: int) -> Features:
        """At most `count` features, spread over the format.

        The image is searched from half its size upwards, so that the first octave has the size of the image: a
        quarter of the work, and the points that are left out are the least repeatable ones.  Where that gives
        few points the octave of double size is searched too.
        """
        h, w = grey.shape
        found = _detect(grey, 2, count)
        if len(found) < FEW * count:
            found = _detect(grey, 1, count)
        chosen = spread(found.xy_px, found.response, count, w, h)
        return found.features(chosen)

    def vectors(self, descriptors: Array) -> Array:
        """Unit vectors (n, 128) of the stored bytes."""
        v = descriptors.astype(np.float32)
        return v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1)


class _Raw:
    """Everything that was found, in arrays."""

    def __init__(self, parts: list[tuple[Array, Array]]) -> None:
        table = np.vstack([p[0] for p in parts]) if parts else np.zeros((0, 5))
        self.xy_px, self.scale_px, self.angle, self.response = table[:, :2], table[:, 2], table[:, 3], table[:, 4]
        self.descriptors = np.vstack([p[1] for p in parts]) if parts else np.zeros((0, 128), np.uint8)

    def __len__(self) -> int:
        return len(self.xy_px)

    def features(self, index: Array) -> Features:
        return Features(
            xy_px=self.xy_px[index],
            scale_px=self.scale_px[index],
            angle=self.angle[index],
            descriptors=self.descriptors[index],
        )


def _detect(grey: Array, reduction: int, count: int) -> _Raw:
    """Features of the image reduced by a whole number, in the pixel frame of the full size."""
    h, w = grey.shape
    step = TILE_PX * reduction
    margin = OVERLAP_PX * reduction
    parts: list[tuple[Array, Array]] = []
    detector: Any = cv2.SIFT.create(0, 3, CONTRAST, EDGE, 1.6, enable_precise_upscale=True)  # pyright: ignore[reportAttributeAccessIssue]
    for y in range(0, h, step):
        for x in range(0, w, step):
            y0, x0 = max(0, y - margin), max(0, x - margin)
            y1, x1 = min(h, y + step + margin), min(w, x + step + margin)
            tile = np.ascontiguousarray(grey[y0:y1, x0:x1])
            if reduction > 1:
                size = (max(tile.shape[1] // reduction, 1), max(tile.shape[0] // reduction, 1))
                tile = tile[: size[1] * reduction, : size[0] * reduction]
                tile = cv2.resize(tile, size, interpolation=cv2.INTER_AREA)
            part = _tile(detector, tile, 4 * count)
            if part is None:
                continue
            table, descriptors = part
            table[:, :2] = (table[:, :2] + 0.5) * reduction + [x0, y0]
            table[:, 2] *= reduction
            inner = (table[:, 0] >= x) & (table[:, 0] < x + step) & (table[:, 1] >= y) & (table[:, 1] < y + step)
            parts.append((table[inner], descriptors[inner]))
    return _Raw(parts)


def _tile(detector: Any, tile: Array, most: int) -> tuple[Array, Array] | None:
    keypoints = detector.detect(tile, None)
    keypoints = sorted(keypoints, key=lambda k: -k.response)[:most]
    if not keypoints:
        return None
    keypoints, descriptors = detector.compute(tile, keypoints)
    table = np.array([(*k.pt, k.size / 2, np.radians(k.angle), k.response) for k in keypoints])
    root = np.sqrt(descriptors / np.maximum(descriptors.sum(axis=1, keepdims=True), 1e-9))
    return table, np.minimum(np.round(root * 512), 255).astype(np.uint8)


register(RootSift())
