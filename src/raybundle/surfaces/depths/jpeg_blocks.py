"""Errors that photographs of JPEG have alike: their blocks of 8 x 8 pixels stand still while the object moves.

What a texture loses to quantisation depends on where in its block it lies.  So two photographs match best where their
blocks do, and a depth is drawn to the nearest parallax that is a multiple of 8 px.  All pixels of a place are drawn
the same way, as far as the parallax stays the same: means of many are no better than one.  The share of the variance
by noise that is of this kind grows with the step of quantisation against the texture in the window.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

import numpy as np
from scipy.spatial import KDTree

from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index

BLOCK_PX = 8.0
"""Side of a block of JPEG"""
SHARE = 0.06
"""Share of the variance of a depth that blocks have where the texture is far below quantisation: weak ground under
parallel cameras, quality 80 and 93 (benchmarks/surface_lattice.py): 0.04 and 0.09"""
SHORTEST_PX = 14.0
"""Two windows: what does not reach so far is noise as any other."""
FEWEST = 12
"""Common points of two photographs by which it is seen how their blocks lie"""


def quantisation_noise(tables: Sequence[Sequence[float]]) -> float:
    """Standard deviation of grey values by quantisation, of the table (64) of luminance; 0 where there is none.

    The transform is orthonormal: the mean of q^2 / 12 over all frequencies is the variance of a pixel.
    """
    return float(np.sqrt(np.mean(np.square(np.asarray(tables[0], float))) / 12)) if len(tables) else 0.0


def share_of_blocks(noise: float, contrast: Array) -> Array:
    """Share (...) of the variance of depths that blocks have, by the contrast in their windows, as grey values.

    noise  of grey values by quantisation
    """
    weak = np.square(noise / np.maximum(np.asarray(contrast, float), 1e-6))
    return np.where(np.isfinite(weak), SHARE * weak / (1 + weak), 0.0)


def reach_of_blocks(block: Block, reference: int, sources: Sequence[int]) -> tuple[float, float]:
    """Share of the sources whose blocks a depth is drawn to over more than windows, and how far it reaches [px].

    Blocks of a source move against those of the reference with the parallax, and where it is turned, nearer or
    further; a turn by 90 degrees changes nothing.  Over g px a pixel the drawing force, a wave of 8 px, has the
    correlation cos(2 pi g d / 8) at the distance d: to second order that of exp(-(d / reach)^2).
    """
    o = block.observations
    image, point, xy = np.asarray(o.image), np.asarray(o.point), np.asarray(o.xy_px, float)
    mine = np.flatnonzero(image == reference)
    reaches = list[float]()
    for source in sources:
        theirs = np.flatnonzero(image == source)
        _, a, b = np.intersect1d(point[mine], point[theirs], return_indices=True)
        if len(a) >= FEWEST:
            reaches.append(_reach(xy[mine[a]], xy[theirs[b]]))
    far = [r for r in reaches if r >= SHORTEST_PX]
    return len(far) / max(len(sources), 1), float(np.median(far)) if far else 0.0


def _reach(here: Array, there: Array) -> float:
    """How far [px] blocks of two photographs lie the same way, by places (n, 2) of the same points in both."""
    A = np.column_stack([np.ones(len(here)), here - here.mean(axis=0)])
    solved, *_ = np.linalg.lstsq(A, there, rcond=None)
    J = solved[1:].T
    turned = [np.array([[c, -s], [s, c]]) for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    whole = min(float(np.linalg.norm(J - R)) for R in turned) / np.sqrt(2)
    left = there - A @ solved
    distance, near = cast("tuple[Array, Index]", KDTree(here).query(here, k=2))
    apart = np.linalg.norm(left[near[:, 1]] - left, axis=1) / np.maximum(distance[:, 1], 1.0)
    return float(np.sqrt(2) * BLOCK_PX / (2 * np.pi) / max(np.hypot(whole, np.median(apart)), 1e-6))
