"""What neighbours of a map say of a pixel: flags, and which depths are doubtful.

A doubtful depth is as a rule right, but a map alone cannot show: it stays where other maps confirm it.
"""

from __future__ import annotations

from enum import IntFlag

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.depths import roughness

SIGMAS = 3.0
"""Standard deviations of a difference up to which neighbours agree."""
AGREE, AGAINST = 6, 2
"""Of eight neighbours 4 px away that have to, and that may speak against it: a straight edge of things stays."""
NEAR_PX, NEAR_AGREE = 2, 6
"""Distance of eight nearer neighbours, and how many have to agree: what wanders off with its window does so alone.  A
coarser grid has none.  Of four maps of an exactly known object 0.2 to 0.3 % of what stays is then off by more than five
standard deviations (benchmarks/surface_truth.py); fewer would leave more and worse, and what other maps confirm stays
anyway."""
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
    """Its neighbours do not agree with it: doubtful"""
    EDGE = 16
    """Beside a hole that is larger than a window: something begins there that hides the rest, and windows show both; or
    beside what was measured in the photograph itself: doubtful"""
    COARSE = 32
    """Measured in photographs of half the size, where they themselves show too little: its window is twice as wide,
    and may show more than one thing: doubtful"""


DOUBTFUL = Flag.LONELY | Flag.EDGE | Flag.COARSE


def tested(
    t: Array, slopes: Array, variance: Array, incidence: Array, few: Mask, stride: int, rim: Mask | None
) -> tuple[Array, Array]:
    """Flags (rows, columns) uint8 of the pixels of a map, by a test of it against itself, and variances by steps.

    t, slopes  NaN where there is no depth; slopes (2, rows, columns)
    few        seen by fewer sources than can check it
    rim        known to lie beside other things; None: nothing is known

    A variance by a step is the largest square of what neighbours stand apart, of doubtful depths; else 0.
    """
    known = np.isfinite(t)
    own = np.where(known, variance, np.nan)
    agree, against, apart = _compared(t, slopes, own, stride, roughness.APART_PX)
    sure: Mask = known & (agree >= AGREE) & (against <= AGAINST)
    if stride <= NEAR_PX:
        sure &= _compared(t, slopes, own, stride, NEAR_PX)[0] >= NEAR_AGREE
    edge = sure & _beside_holes(sure, stride)
    if rim is not None:
        edge |= sure & rim
    flags = np.zeros(t.shape, np.uint8)
    for flag, where in (
        (Flag.GRAZING, ~(incidence >= GRAZING)), (Flag.STEP, against > 0), (Flag.FEW_SOURCES, few),
        (Flag.LONELY, ~sure), (Flag.EDGE, edge),
    ):  # fmt: skip
        flags[known & where] |= np.uint8(flag)
    return flags, np.where(known & (~sure | edge), apart, 0)


def _compared(t: Array, slopes: Array, own: Array, stride: int, distance_px: float) -> tuple[Array, Array, Array]:
    """How many of eight neighbours agree, how many do not (uint8), and the largest square of a misfit (float32)."""
    agree, against = np.zeros(t.shape, np.uint8), np.zeros(t.shape, np.uint8)
    apart = np.zeros(t.shape, np.float32)
    around = roughness.neighbours(stride, distance_px)
    for first, begin, end, last in roughness.strips(len(t), ROWS, stride):
        here, there = slice(begin - first, end - first), slice(first, last)
        misfits = roughness.misfits(t[there], slopes[:, there], stride, distance_px)
        for misfit, (v, u) in zip(misfits, around, strict=True):
            with np.errstate(invalid="ignore"):
                limit = SIGMAS * np.sqrt(own[there] + roughness.at_neighbour(own[there], v, u))
                agree[begin:end] += (np.abs(misfit) <= limit)[here]
                against[begin:end] += (np.abs(misfit) > limit)[here]
            apart[begin:end] = np.fmax(apart[begin:end], misfit[here] ** 2)
    return agree, against, apart


def _beside_holes(kept: Mask, stride: int) -> Mask:
    """Pixels beside what is missing over more than a window."""
    size, rim = 2 * round((HOLE_PX / stride - 1) / 2) + 1, max(1, round(RIM_PX / stride))
    missing = np.pad((~kept).astype(np.uint8), size, mode="edge")
    holes = cv2.morphologyEx(missing, cv2.MORPH_OPEN, np.ones((max(size, 3),) * 2, np.uint8))
    return cv2.dilate(holes, np.ones((2 * rim + 1,) * 2, np.uint8))[size:-size, size:-size] > 0
