"""What neighbours of a map say of a pixel: flags, and which depths are taken out."""

from __future__ import annotations

from enum import IntFlag

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces import roughness

SIGMAS = 3.0
"""Standard deviations of a difference up to which neighbours agree."""
AGREE, AGAINST = 5, 2
"""Of eight neighbours that have to, and that may speak against it: most of a straight edge of things stays, and what
juts out of it, where a window shows more of the other side, goes."""
HOLE_PX, RIM_PX = 9, 2
"""Holes larger than a window and a pixel on each side, and what is lost around them: of 3 px that half a window
reaches, the outer one has no weight."""
GRAZING = 0.3
"""Cosine between ray and normal below which a window shows hardly anything of the surface."""
ROWS = 64
"""Of a map that are looked at together."""


class Flag(IntFlag):
    """What is to be known of a pixel."""

    GRAZING = 1
    STEP = 2
    """A neighbour stands on another depth"""
    FEW_SOURCES = 4
    """Seen by one source only, where there are several: nothing checks it"""
    LONELY = 8
    """Its neighbours do not agree with it: taken out"""
    EDGE = 16
    """Beside a hole that is larger than a window: something begins there that hides the rest, and windows show both:
    taken out"""


def flags_of(t: Array, slopes: Array, variance: Array, incidence: Array, few: Mask, stride: int) -> Array:
    """(rows, columns) uint8 `Flag` of the pixels of a map, by a test of the map against itself.

    t, slopes  NaN where there is no depth; slopes (2, rows, columns)
    few        seen by fewer sources than can check it
    """
    known = np.isfinite(t)
    own = np.where(known, variance, np.nan)
    agree, against = np.zeros(t.shape, np.uint8), np.zeros(t.shape, np.uint8)
    around = roughness.neighbours(stride)
    for first, begin, end, last in roughness.strips(len(t), ROWS, stride):
        here, there = slice(begin - first, end - first), slice(first, last)
        apart = roughness.misfits(t[there], slopes[:, there], stride)
        for misfit, (v, u) in zip(apart, around, strict=True):
            with np.errstate(invalid="ignore"):
                limit = SIGMAS * np.sqrt(own[there] + roughness.at_neighbour(own[there], v, u))
                agree[begin:end] += (np.abs(misfit) <= limit)[here]
                against[begin:end] += (np.abs(misfit) > limit)[here]
    kept: Mask = known & (agree >= AGREE) & (against <= AGAINST)
    edge = kept & _beside_holes(kept, stride)
    flags = np.zeros(t.shape, np.uint8)
    for flag, where in (
        (Flag.GRAZING, ~(incidence >= GRAZING)), (Flag.STEP, against > 0), (Flag.FEW_SOURCES, few),
        (Flag.LONELY, ~kept), (Flag.EDGE, edge),
    ):  # fmt: skip
        flags[known & where] |= np.uint8(flag)
    return flags


def _beside_holes(kept: Mask, stride: int) -> Mask:
    """Pixels beside what is missing over more than a window."""
    size, rim = 2 * round((HOLE_PX / stride - 1) / 2) + 1, max(1, round(RIM_PX / stride))
    missing = np.pad((~kept).astype(np.uint8), size, mode="edge")
    holes = cv2.morphologyEx(missing, cv2.MORPH_OPEN, np.ones((max(size, 3),) * 2, np.uint8))
    return cv2.dilate(holes, np.ones((2 * rim + 1,) * 2, np.uint8))[size:-size, size:-size] > 0
