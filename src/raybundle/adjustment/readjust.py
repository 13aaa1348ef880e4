"""The block of a result, to be adjusted again."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera, Instrument
from raybundle.block.rejection import found_wrong

Parametrised = TypeVar("Parametrised", Camera, Instrument)


def block_again(adjustment: Adjustment) -> Block:
    """The given block with adjusted values as approximations; what was observed or held stays as it was given."""
    given, adjusted = adjustment.given, adjustment.adjusted
    stays = given.points.is_control | given.points.is_check
    xyz = np.where(stays, given.points.xyz, adjusted.points.xyz)
    cameras = [_with_values(b, a) for b, a in zip(given.cameras, adjusted.cameras, strict=True)]
    instruments = [_with_values(b, a) for b, a in zip(given.instruments, adjusted.instruments, strict=True)]
    return replace(
        given,
        free_scale=adjustment.free_scale,
        noise="" if adjustment.options.noise == "auto" else adjustment.options.noise,
        datum_over="" if adjustment.options.datum_over == "all" else adjustment.options.datum_over,
        rejected=found_wrong(given, adjustment.image_observations.rejected),
        cameras=tuple(cameras),
        instruments=tuple(instruments),
        images=replace(adjusted.images, held=given.images.held),
        points=replace(given.points, xyz=xyz),
    )


def _with_values(before: Parametrised, after: Parametrised) -> Parametrised:
    """With adjusted values, but for those that were observed."""
    observed = {s: before.values[s] for s in before.sigma if s in before.values}
    return replace(before, values={**after.values, **observed})
