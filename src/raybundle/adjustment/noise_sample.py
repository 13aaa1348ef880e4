"""What errors that image points share make of standard deviations, given by some neighbouring images of a block.

Where nobody asks for noise fields and a block is large, a part of it is adjusted once more by itself: how much wider
its standard deviations get under fields is reported of the whole.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.factoring import in_one_piece, made_by
from raybundle.block import Block
from raybundle.block.select import select_block
from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.arrays import Mask

IMAGES = 40
"""Of a sample: fields of a tenth of a pixel are given by them as well as by any number (docs/explanation/noise-of-
photographs.md), and their adjustment takes seconds."""


def sample_under_noise(result: Adjustment) -> Adjustment | None:
    """Some neighbouring images of a result adjusted by themselves, with noise fields; None where that cannot be.

    They begin with the adjusted values, without what was rejected.  Limits: whether other parts of the
    block are as these.
    """
    block = _part(result)
    options = AdjustmentOptions(jobs=result.options.jobs, noise="fields", residuals=result.options.residuals)
    try:
        with made_by(in_one_piece):  # it is small
            found = adjust_block(block, options)
    except (InputError, NotSolvable):
        return None
    return found if found.noise.kind == "fields" else None


def _part(result: Adjustment) -> Block:
    """Adjusted values of the images of a sample, and the points that two of them see."""
    block, used = result.adjusted, result.image_observations.used
    block = replace(block, observations=block.observations.rows(used), noise="")
    block = select_block(block, "image", _neighbouring(block))
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    return select_block(block, "point", rays > 1)


def _neighbouring(block: Block) -> Mask:
    """Images (n,) that grow from the one with most image points, each the one that shares most with those before."""
    from scipy.sparse import csr_matrix

    o, n = block.observations, len(block.images)
    sees = csr_matrix((np.ones(len(o)), (o.image, o.point)), shape=(n, len(block.points)))
    count = np.bincount(o.image, minlength=n)
    chosen = np.zeros(n, bool)
    chosen[int(count.argmax())] = True
    shared = np.asarray((sees @ sees[int(count.argmax())].T).todense()).ravel()
    while chosen.sum() < IMAGES:
        following = int(np.where(chosen, -1.0, shared).argmax())
        if chosen[following] or shared[following] <= 0:
            break
        chosen[following] = True
        shared = shared + np.asarray((sees @ sees[following].T).todense()).ravel()
    return chosen
