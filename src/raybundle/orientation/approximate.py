"""Approximate values of a block, single images and rigs: orientations and coordinates from observations and control."""

from __future__ import annotations

import numpy as np

from raybundle.block import Block
from raybundle.block.rigs import has_rigs
from raybundle.errors import NoOrientation, excluded
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.assembly import ApproximateValues, image_values
from raybundle.orientation.rigs.approximate import rig_values


def approximate_values(block: Block, progress: Progress = silent) -> ApproximateValues:
    """Fill the missing exterior orientations and object coordinates of a block.

    What is given is used and kept (it is refined by the adjustment, not here).
    Raises NoOrientation, which names each image that could not be oriented, and why.
    """
    found = possible_values(block, progress)
    left = found.not_oriented
    if left:
        observed = len(np.unique(block.observations.image))
        raise NoOrientation(
            "orientation.not_found",
            details=excluded(list(left.items())),
            n=len(left),
            total=observed,
            images=left,
        )
    return found


def possible_values(block: Block, progress: Progress = silent) -> ApproximateValues:
    """Fill the orientations and coordinates that can be filled; like `approximate_values`, but without an error.

    Images that could not be oriented, and points that only they see, keep what was given, NaN for the most part.
    Images of rigs are oriented one by one first (`rigs`).
    """
    if not has_rigs(block):
        return image_values(block, progress)
    return rig_values(block, progress)
