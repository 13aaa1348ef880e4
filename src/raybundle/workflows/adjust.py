"""Adjust any block: approximate values where they are missing, then the adjustment with its decisions."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from raybundle.adjustment import defects
from raybundle.adjustment.decide import decide
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.block import Block
from raybundle.numerics.progress import Progress, silent


def adjust(block: Block, options: AdjustmentOptions | None = None, progress: Progress = silent) -> Adjustment:
    """Adjust a block, from nothing but observations and control if need be.

    Returns the adjusted block with precision, reliability and everything a report needs; raises InputError
    (bad input) or NotSolvable (no orientation found, datum or rank defect, no convergence).
    """
    began = time.perf_counter()
    options = options or AdjustmentOptions()
    defects.check_rays(block, np.zeros(len(block.observations), bool))
    start, notices = block, list[Notice]()
    observed = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    seen = np.bincount(block.observations.point, minlength=len(block.points)) > 0
    if (observed & ~block.images.oriented).any() or (seen & ~np.isfinite(block.points.xyz).all(axis=1)).any():
        from raybundle.orientation.assembly import approximate_values  # noqa: PLC0415

        approximate = approximate_values(block, progress)
        start = approximate.block
        notices += approximate.notices
    result = decide(start, options, progress, notices=tuple(notices))
    return replace(result, given=block, seconds=time.perf_counter() - began)
