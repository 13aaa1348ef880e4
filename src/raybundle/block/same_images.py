"""Images of two blocks whose image points are the same numbers: one photograph, measured once."""

from __future__ import annotations

import numpy as np

from raybundle.block.block import Block
from raybundle.numerics.arrays import Array, Index

SHARE = 0.5
"""Of its image points that an image has in common with another: each measurement of its own has other decimals"""


def images_measured_alike(block: Block, other: Block) -> tuple[str, ...]:
    """Ids of the images of a block most of whose image points are those of one image of another, to the last digit.

    Limits: photographs that were measured twice; their image points differ.
    """
    mine, theirs = _keys(block.observations.xy_px), _keys(other.observations.xy_px)
    order = np.argsort(theirs, kind="stable")
    low = np.searchsorted(theirs[order], mine, "left")
    each = np.searchsorted(theirs[order], mine, "right") - low
    row = np.repeat(np.arange(len(mine)), each)
    step = np.arange(len(row)) - np.repeat(np.cumsum(each) - each, each)
    match = order[low[row] + step]
    width = len(other.images)
    pair = block.observations.image[row].astype(np.int64) * width + other.observations.image[match]
    pairs, count = np.unique(pair, return_counts=True)
    images: Index = pairs // max(width, 1)
    points = np.bincount(block.observations.image, minlength=len(block.images))
    alike = np.unique(images[count > SHARE * points[images]])
    return tuple(block.images.ids[int(k)] for k in alike)


def _keys(xy: Array) -> Array:
    """(n,) one number for both coordinates."""
    return xy[:, 0] + 1j * xy[:, 1]
