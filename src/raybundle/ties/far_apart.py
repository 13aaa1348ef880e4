"""Photographs that hang on a few points which no other photograph sees from nearby: their matches are wrong."""

from __future__ import annotations

import numpy as np

from raybundle.block import Block
from raybundle.numerics.arrays import Array, Mask

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
    for i in np.flatnonzero((count > 0) & (count <= FEW) & block.images.oriented).tolist():
        angle = nearest_rays(block, i)
        median = float(np.median(angle)) if len(angle) else 0.0
        if median > APART:
            left[i] = True
            failed[block.images.ids[i]] = (
                f"its {len(angle)} points are seen from {np.degrees(median):.0f} degrees away by the next photograph "
                f"of them (median), where nothing looks alike (limit {np.degrees(APART):.0f}): such matches are "
                "wrong; add photographs from between"
            )
    return ~left[o.image]


def nearest_rays(block: Block, image: int) -> Array:
    """Angles [rad] at the points of an image between its ray and the nearest of another image's, by coordinates."""
    o = block.observations
    mine = o.point[o.image == image]
    rows = np.flatnonzero(np.isin(o.point, mine) & (o.image != image) & block.images.oriented[o.image])
    xyz = block.points.xyz

    def away(points: Array, centre: Array) -> Array:
        d = xyz[points] - centre
        return d / np.linalg.norm(d, axis=1, keepdims=True)

    point = o.point[rows]
    cosine = np.einsum(
        "ij,ij->i", away(point, block.images.centre[o.image[rows]]), away(point, block.images.centre[image])
    )
    nearest = np.full(len(block.points), -np.inf)
    np.maximum.at(nearest, point, cosine)
    found = nearest[np.unique(mine)]
    return np.arccos(np.clip(found[np.isfinite(found)], -1, 1))
