"""Whether an image is the one that an RPC describes, or a part that was cut out of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.scenes.rpc import Rpc

WIDER = 1.5
"""An image more than so many times the size of what an RPC covers does not belong to it."""


def rpc_of_image(rpc: Rpc, width_px: int, height_px: int, file: Path | str) -> Rpc:
    """The RPC with offsets and scales that are a range within the image: itself, but for images cut out of a scene.

    Tools that cut write offsets and scales of the part and leave the ground's range that of the scene.  Such an RPC
    sees the middle of the ground's range outside of its offsets' range; it belongs to the image where the image's
    own ground lies in that range.

    raises  InputError where the image cannot be the one that the RPC describes
    """
    if not rpc.middle_in_range() and _sees_range(rpc, np.array([width_px, height_px], float)):
        low, high = rpc.image_offset - rpc.image_scale, rpc.image_offset + rpc.image_scale
        if (high <= 0).any() or (low >= [width_px, height_px]).any():
            return rpc.spread_over(np.array([width_px, height_px]))
        return rpc
    check_image(rpc, width_px, height_px, file)
    return rpc


def _sees_range(rpc: Rpc, size: Array) -> bool:
    """Whether middle and corners of an image of size (2,) look at the RPC's range of ground, at its middle height."""
    grid = size * np.array([[0.5, 0.5], [0, 0], [1, 0], [0, 1], [1, 1]])
    ground = rpc.ground_where_any(grid, float(rpc.ground_offset[2]))
    return bool((rpc.ranges_away(ground) < WIDER).all())


def check_image(rpc: Rpc, width_px: int, height_px: int, file: Path | str) -> None:
    """Raise InputError where an image does not fit the range of an RPC's offsets; a part of it may."""
    size = np.array([width_px, height_px], float)
    low, high = rpc.image_offset - rpc.image_scale, rpc.image_offset + rpc.image_scale
    covered = np.minimum(high, size) - np.maximum(low, 0)
    if (size > WIDER * (high - low)).any() or (covered <= 0).any():
        raise InputError(
            "rpc.other_image",
            width_px=width_px,
            height_px=height_px,
            first_column=round(float(low[0])),
            last_column=round(float(high[0])),
            first_row=round(float(low[1])),
            last_row=round(float(high[1])),
            file=file,
        )
