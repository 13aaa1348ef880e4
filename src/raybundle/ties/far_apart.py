"""Photographs that hang on a few points which no other photograph sees from nearby: their matches are wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from raybundle.block import Block
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each

FEW = 100
"""Points up to which a photograph is asked: many that fit one geometry are no chance."""
APART = np.radians(65.0)
"""Median angle of its rays to the nearest other ray of their points from which on it leaves.

Features of one place cease to look alike between 40 and 60 degrees (Moreels and Perona 2007).  Of 584 photographs of
36 public sets (`benchmarks/nearest_rays.py`) the largest medians are 54 degrees with 741 points, and of 36 with `FEW`
or fewer 58, 66 (of a set with a fault) and 84, whose 27 points lie at other places of a carpet.  The margin is thin.
"""


def not_too_far(block: Block, failed: dict[str, str]) -> Mask:
    """(m,) rows of all images but those that hang on few points seen from far apart; names the images that are left."""
    o = block.observations
    count = np.bincount(o.image, minlength=len(block.images))
    left = np.zeros(len(block.images), bool)
    few = np.flatnonzero((count > 0) & (count <= FEW) & block.images.oriented).tolist()
    for i, angle in zip(few, nearest_rays(block, few), strict=True):
        median = float(np.median(angle)) if len(angle) else 0.0
        if median > APART:
            left[i] = True
            failed[block.images.ids[i]] = phrase(
                "not_oriented.wide_baseline", n=len(angle), angle_deg=np.degrees(median), limit_deg=np.degrees(APART)
            )
    return ~left[o.image]


def nearest_rays(block: Block, images: Sequence[int]) -> Iterator[Array]:
    """Of each image the angles [rad] at its points between its ray and the nearest of another, by coordinates."""
    o = block.observations
    rows_of = rows_of_each(o.image, len(block.images))
    by_point = np.argsort(o.point, kind="stable")
    by_point = by_point[block.images.oriented[o.image[by_point]]]
    first = np.searchsorted(o.point[by_point], np.arange(len(block.points) + 1))
    for i in images:
        mine = np.unique(o.point[rows_of[i]])
        rows = np.concatenate([by_point[:0], *(by_point[first[p] : first[p + 1]] for p in mine.tolist())])
        yield _nearest(block, i, mine, rows[o.image[rows] != i])


def _nearest(block: Block, image: int, mine: Index, rows: Index) -> Array:
    """The angles of one image at its points (k,), by the rows of other images that see them."""
    o = block.observations
    xyz = block.points.xyz

    def away(points: Array, centre: Array) -> Array:
        d = xyz[points] - centre
        return d / np.linalg.norm(d, axis=1, keepdims=True)

    point = o.point[rows]
    cosine = np.einsum(
        "ij,ij->i", away(point, block.images.centre[o.image[rows]]), away(point, block.images.centre[image])
    )
    nearest = np.full(len(mine), -np.inf)
    np.maximum.at(nearest, np.searchsorted(mine, point), cosine)
    return np.arccos(np.clip(nearest[np.isfinite(nearest)], -1, 1))
