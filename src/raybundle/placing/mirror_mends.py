"""Which single mend turns mirrored control into that of the object: two axes exchanged, or one of the wrong sign."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.severity import POOR_FIT
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError, Message, message
from raybundle.numerics.arrays import Array
from raybundle.numerics.transform import similarity

DECIDEDLY = 2.0
"""Ratio of misfits from which the better one is worth an adjustment, or the better mend is named alone."""
ORIENTED = 0.25
"""Misfit without any rotation, as a share of the extent, up to which the block's own orientation is that of control."""
FEWEST = 4
"""Points; three fit a mirror image as well as themselves."""
MENDS: dict[str, tuple[tuple[int, int, int], tuple[float, float, float]]] = {
    "xy": ((1, 0, 2), (1, 1, 1)),
    "yz": ((0, 2, 1), (1, 1, 1)),
    "xz": ((2, 1, 0), (1, 1, 1)),
    "z": ((0, 1, 2), (1, 1, -1)),
    "x": ((0, 1, 2), (-1, 1, 1)),
    "y": ((0, 1, 2), (1, -1, 1)),
}
"""Two axes exchanged, or one of the wrong sign: an order of the axes and their signs.  All are mirror images, which a
rotation makes equal to one another."""
USUAL = ("xy", "z")
"""Those that occur: easting and northing in the other order, depths for heights."""


def mirror_mends(
    block: Block, source: Array, target: Array, solved: Callable[[Block], Adjustment | None]
) -> tuple[tuple[str, ...], float] | None:
    """Mends with which the photographs fit control, the likeliest first, and sigma0 then; None where none does.

    source, target  (n, 3) control points as the photographs alone have them, in the frame that the block's approximate
                    orientation has, and as given
    solved          adjusts a block; None where there is no solution

    Control alone does not distinguish the mends; the given orientation of the block does.
    """
    if len(source) < FEWEST:
        return None
    extent = float(np.linalg.norm(np.ptp(target, axis=0)))
    as_given, mirrored = _misfit(source, target), _misfit(source, target * [1, 1, -1])
    if not DECIDEDLY * mirrored < as_given:
        return None
    size = {name: _unrotated(source, _mended(target, name)) / extent for name in MENDS}
    order = sorted(MENDS, key=lambda name: size[name])
    first, second = size[order[0]], size[order[1]]
    likely = tuple(order[:1]) if first < ORIENTED and DECIDEDLY * first < second else USUAL
    result = solved(_with_mend(block, likely[0]))
    return None if result is None or result.sigma0 > POOR_FIT else (likely, result.sigma0)


def mirror_causes(mends: tuple[str, ...], images: str | None) -> tuple[str, tuple[Message, ...]]:
    """Where the cause lies ("images", "control", "open"), and a message for each likely cause.

    images  mend of the image axes by the orientation that was given; "" where it fits as it is, None where it is open
    """
    if images:
        return "images", (message("images_mirrored.mend", mend=images),)
    causes = tuple(message("control_contradicts.mend", mend=m) for m in mends)
    if images is None:
        return "open", (*causes, *(message("images_mirrored.mend", mend=m) for m in ("y_up", "xy")))
    return "control", causes


def _mended(xyz: Array, name: str) -> Array:
    axes, signs = MENDS[name]
    return xyz[:, list(axes)] * np.array(signs)


def _with_mend(block: Block, name: str) -> Block:
    points, control = block.points, block.points.is_control.any(axis=1)
    xyz, sigma = points.xyz.copy(), points.sigma.copy()
    xyz[control], sigma[control] = _mended(xyz[control], name), sigma[control][:, list(MENDS[name][0])]
    return replace(block, points=replace(points, xyz=xyz, sigma=sigma))


def _misfit(source: Array, target: Array) -> float:
    try:
        return float(np.linalg.norm(similarity(source, target).points(source) - target))
    except InputError:
        return np.inf


def _unrotated(source: Array, target: Array) -> float:
    """Misfit after a shift and a scale alone."""
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    scale = max(float(np.sum(a * b)) / max(float(np.sum(a * a)), 1e-300), 0.0)
    return float(np.linalg.norm(scale * a - b)) / np.sqrt(len(a))
