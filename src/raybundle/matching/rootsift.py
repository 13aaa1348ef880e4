"""RootSIFT: scale-invariant features (Lowe 2004) with square-root descriptors (Arandjelović and Zisserman 2012)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from raybundle.matching.descriptors import RATIO, directions, mutual_matches, nearest_matches
from raybundle.matching.features import CLEAR, ENOUGH, Described, FeatureMethod, Features, register, spread
from raybundle.matching.signatures import widest
from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index

CONTRAST = 0.015
"""Least contrast of a feature, in grey levels of 255 and thirds of an octave, where there are enough of them."""
NOISE_GAIN, TIMES = 0.1, 4.0
"""Standard deviation of a difference of Gaussians (0.8 and 1.0 px, 0.102; 1.6 and 2.0 px, 0.051) by that of the grey
values, and the multiple of it from which a feature is more than noise (one false one in 16 000)."""
HALF = 128.0
"""Grey levels; the limit of contrast is meant for photographs that use more of their 255."""
NOISE_SAMPLE = 300_000
"""Pixels, in whole rows, that show the noise of a photograph"""
QUANTISED = 0.29
"""Standard deviation of the rounding to grey levels, below which no photograph has noise."""
EDGE = 10.0
TILE_PX = 2048
OVERLAP_PX = 96
FEW = 0.6
"""Below this share of the wanted features the finest octave is searched as well."""

LARGEST = 60e6
"""Pixels of a photograph that may be searched at double size; soft ones of more have features in wide octaves."""
LEVELS, FINEST = 10.5, 6.5
"""Bytes of memory for a pixel of a photograph by the compiled kernels: levels in 16 bits, three of each octave; and of
those of double size every second pixel (`benchmarks/features_memory.py`)"""
HELD, SEARCHED = 4.0, 236.0
"""The same by OpenCV, and for a pixel of the part that is searched at a time: 11 pictures in float32 of four times its
pixels and a third more for all octaves"""

LOOKED = 1250
"""Features of a photograph that a first look compares: the strongest and, where those say nothing, the widest."""
CLEAR_ONES, CLEAR_OF_ALL = 3, 5
"""Matches by `CLEAR` below which two photographs are not matched, by the first look; or verified, by all features."""

Found = tuple[Array, Callable[[Index], Features]]
"""Features (n, 4 or 5): place [px], scale [px], direction where it is known, contrast; and their descriptions."""


class RootSift(FeatureMethod):
    """By the compiled kernels, or without them by OpenCV's detector; first without the octave of double size."""

    name = "rootsift"
    version = 3
    looks = True
    codebook = "rootsift"

    @property
    def content(self) -> tuple[object, ...]:
        """With the detector: features by OpenCV are others than those by the compiled kernels."""
        return *super().content, detector()

    def detect(self, grey: Array, count: int) -> Features:
        """At most `count` features, spread over the format.

        The image is searched from its own size downwards.  Where that gives few points, features of dark and hazy
        photographs are taken down to their noise: they have no less of them, only weaker ones.  Where that does not
        help, or is not needed, the octave of double size is searched too.
        """
        search = _tiles if native.module() is None else _scale_space
        weak = min(noise_contrast(grey), CONTRAST) if low_contrast(grey) else CONTRAST
        table, described = search(grey, count, CONTRAST, doubled=False)
        for doubled in (False, True):
            if len(table) < FEW * count and (grey.size <= LARGEST if doubled else weak < CONTRAST):
                del described  # and what it holds
                table, described = search(grey, count, weak, doubled=doubled)
        h, w = grey.shape
        return described(spread(table[:, :2], table[:, -1], count, w, h))

    def bytes_needed(self, pixels: float) -> float:
        """At most: where the octave of double size is searched too."""
        if native.module() is not None:
            return max(LEVELS * pixels, (LEVELS + FINEST) * min(pixels, LARGEST))
        return HELD * pixels + SEARCHED * min(pixels, float(TILE_PX + 2 * OVERLAP_PX) ** 2)

    def vectors(self, descriptors: Array) -> Array:
        """Unit vectors (n, 128) of the stored bytes."""
        return directions(descriptors)

    def mirrored(self, descriptors: Array) -> Array:
        """Rows across the direction of the feature change places, and the directions of gradients their sign."""
        bins = descriptors.reshape(-1, 4, 4, 8)[:, ::-1, :, -np.arange(8)]
        return np.ascontiguousarray(bins.reshape(-1, 128))

    def match(self, first: Described, second: Described) -> Index:
        """Mutual nearest neighbours of the stored bytes."""
        return mutual_matches(first.descriptors, second.descriptors)[0]

    def likely_matches(self, first: Described, second: Described) -> Index:
        """Those of `match`; none where hardly one is clear, which of many features a part of them shows beforehand."""
        a, b, none = first.descriptors, second.descriptors, np.zeros((0, 2), np.int32)
        if min(len(a), len(b)) > ENOUGH:
            clear = self.shared(a[:LOOKED], b[:LOOKED])
            if clear < CLEAR_ONES:
                clear += self.shared(*(f.descriptors[widest(f, LOOKED)] for f in (first, second)))
            if clear < CLEAR_ONES:
                return none
        matches, distance, following = nearest_matches(a, b)
        clear = int((distance < CLEAR * following).sum())
        return matches[distance < RATIO * following] if clear >= CLEAR_OF_ALL else none

    def shared(self, first: Array, second: Array) -> int:
        """By the stored bytes."""
        return len(mutual_matches(first, second, CLEAR)[0])


def detector() -> str:
    """What finds the features here."""
    return "OpenCV" if native.module() is None else "compiled kernels"


@dataclass(frozen=True, slots=True)
class _Tile:
    """What was found in a part of an image."""

    grey: Array
    """as it was searched"""
    keypoints: list[Any]
    table: Array
    """(n, 5) place in the image of full size, scale, angle, response"""


def low_contrast(grey: Array) -> bool:
    """Whether 98 % of the grey values of an image (h, w) lie within half of the range, as of dark and hazy ones."""
    low, high = np.percentile(grey[:: max(len(grey) // 500, 1), :: max(len(grey[0]) // 500, 1)], (1, 99))
    return bool(high - low < HALF)


def noise_contrast(grey: Array) -> float:
    """Contrast from which a feature of an image (h, w) of grey values is more than noise.

    The noise is that of the differences of second differences (Immerkaer 1996) by their median, which edges do not
    raise.
    """
    kernel = np.array([[1.0, -2.0, 1.0], [-2.0, 4.0, -2.0], [1.0, -2.0, 1.0]])
    step = max(int(np.sqrt(grey.size / NOISE_SAMPLE)), 1)
    rows = [cv2.filter2D(grey[y : y + 3].astype(np.float32), -1, kernel)[1] for y in range(0, len(grey) - 2, step)]
    lit = [np.abs(r[1:-1]) for r in rows]
    sigma = float(np.median(np.concatenate(lit))) / (0.6745 * 6.0) if lit else 0.0
    return 3 * TIMES * NOISE_GAIN * max(sigma, QUANTISED) / 255


def _scale_space(grey: Array, count: int, contrast: float, *, doubled: bool) -> Found:
    """By the compiled kernels: extrema are oriented and described from the levels where they were found."""
    space = native.required().search_features(np.ascontiguousarray(grey), contrast * 255 / 3, doubled)
    table = space.table() * np.array([1, 1, 1, 3 / 255])

    def described(chosen: Index) -> Features:
        owner, angle = space.orient(chosen)  # further directions of an extremum come after those of all
        order = np.argsort(owner[:count], kind="stable")
        rows, angle = chosen[owner[order]], angle[order]
        return Features(
            xy_px=table[rows, :2], scale_px=table[rows, 2], angle=angle, descriptors=space.describe(rows, angle)
        )

    return table, described


def _tiles(grey: Array, count: int, contrast: float, *, doubled: bool) -> Found:
    """By OpenCV, tile by tile, of the image itself or of one of half its size: OpenCV begins at double size."""
    h, w = grey.shape
    reduction = 1 if doubled else 2
    step = TILE_PX * reduction
    margin = OVERLAP_PX * reduction
    tiles: list[_Tile] = []
    for y in range(0, h, step):
        for x in range(0, w, step):
            y0, x0 = max(0, y - margin), max(0, x - margin)
            y1, x1 = min(h, y + step + margin), min(w, x + step + margin)
            tile = np.ascontiguousarray(grey[y0:y1, x0:x1])
            if reduction > 1:
                size = (max(tile.shape[1] // reduction, 1), max(tile.shape[0] // reduction, 1))
                tile = tile[: size[1] * reduction, : size[0] * reduction]
                tile = cv2.resize(tile, size, interpolation=cv2.INTER_AREA)
            found = sorted(_sift(contrast).detect(tile, None), key=lambda k: -k.response)[: 4 * count]
            if not found:
                continue
            table = np.array([(*k.pt, k.size / 2, np.radians(k.angle), 3 * k.response) for k in found])
            table[:, :2] = (table[:, :2] + 0.5) * reduction + [x0, y0]
            table[:, 2] *= reduction
            inner = (table[:, 0] >= x) & (table[:, 0] < x + step) & (table[:, 1] >= y) & (table[:, 1] < y + step)
            tiles.append(_Tile(tile, [found[k] for k in np.flatnonzero(inner)], table[inner]))
    table = np.vstack([np.zeros((0, 5)), *(t.table for t in tiles)])

    def described(chosen: Index) -> Features:
        return Features(
            xy_px=table[chosen, :2],
            scale_px=table[chosen, 2],
            angle=table[chosen, 3],
            descriptors=_descriptors(tiles, chosen),
        )

    return table, described


def _descriptors(tiles: Sequence[_Tile], chosen: Index) -> Array:
    """Descriptors (n, 128) uint8 of the chosen ones of the points of all tiles: one in two is dropped undescribed."""
    result = np.zeros((len(chosen), 128), np.uint8)
    begin = 0
    for tile in tiles:
        mine = np.flatnonzero((chosen >= begin) & (chosen < begin + len(tile.keypoints)))
        own = chosen[mine] - begin
        begin += len(tile.keypoints)
        if not len(mine):
            continue
        _, values = _sift().compute(tile.grey, [tile.keypoints[k] for k in own])
        root = np.sqrt(values / np.maximum(values.sum(axis=1, keepdims=True), 1e-9))
        result[mine] = np.minimum(np.round(root * 512), 255).astype(np.uint8)
    return result


def _sift(contrast: float = CONTRAST) -> Any:
    return cv2.SIFT.create(0, 3, contrast, EDGE, 1.6, enable_precise_upscale=True)  # pyright: ignore[reportAttributeAccessIssue]


register(RootSift())
