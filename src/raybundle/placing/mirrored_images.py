"""Image axes of the other hand: y upward, x and y exchanged.  Every such block fits, as a mirror image of the object.

A central projection has no hand of its own: with mirrored image points all residuals are as before, and all points
before their cameras.  Only what is known otherwise contradicts: control, or the orientation that was given.
"""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block
from raybundle.errors import InputError, message
from raybundle.numerics.arrays import Array
from raybundle.numerics.transform import similarity

MENDS = {
    "y_up": np.diag([1.0, -1.0, 1.0]),
    "x_left": np.diag([-1.0, 1.0, 1.0]),
    "xy": np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, 1]]),
    "xy_negative": np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, 1]]),
}
"""Right axes of the sensor (y up) from those of the observations, which are named as pixels count (y down)"""
HAND = np.array([1.0, 1.0, -1.0])
DECIDEDLY = 2.0
"""Ratio of the misfits as given and mirrored from which the orientation is that of a mirror image."""
NEAR_DEG = 30.0
"""Angle between given and mended rotations up to which a mend explains them; mends differ by 90 degrees and more."""
FEWEST = 3
"""Images"""


def hand_of_images(block: Block, adjusted: Block) -> tuple[str, float] | None:
    """The mend of the image axes with which the given orientation fits, and its misfit as a share of the extent.

    "" where it fits as it is; None where no orientation was given or it fits neither way.

    block     with the orientation that was given
    adjusted  from observations alone

    Places are the projection centres and a point on the axis of each image, at the distance of the middle of the
    object: stations in a plane, as of a flight, fit either way without their axes.
    """
    index = {name: k for k, name in enumerate(adjusted.images.ids)}
    rows = [(k, index[n]) for k, n in enumerate(block.images.ids) if n in index and block.images.oriented[k]]
    rows = [(a, b) for a, b in rows if adjusted.images.oriented[b]]
    if len(rows) < FEWEST:
        return None
    given, own = np.array(rows).T
    middle = np.nanmedian(adjusted.points.xyz, axis=0)
    depth = np.linalg.norm(adjusted.images.centre[own] - middle, axis=1)
    try:
        plain = similarity(adjusted.images.centre[own], block.images.centre[given])
        source, target = _places(adjusted, own, depth), _places(block, given, depth * plain.scale)
        as_given, mirrored = similarity(source, target), similarity(source * HAND, target)
    except InputError:
        return None
    size = np.array([np.sum(s.residuals**2) for s in (as_given, mirrored)])
    share = np.sqrt(size / np.sum((target - target.mean(axis=0)) ** 2))
    if DECIDEDLY * share[0] < share[1]:
        return "", float(share[0])
    if not DECIDEDLY * share[1] < share[0]:
        return None
    turned = adjusted.images.rotation[own] @ (mirrored.rotation * HAND).T
    angle = {name: _angle(mend @ turned, block.images.rotation[given]) for name, mend in MENDS.items()}
    best = min(angle, key=lambda name: angle[name])
    return (best, float(share[1])) if angle[best] < NEAR_DEG else None


def mirrored_image_notices(block: Block, adjusted: Block) -> list[Notice]:
    """The fault of a result that is a mirror image of the orientation that was given."""
    found = hand_of_images(block, adjusted)
    if found is None or not found[0]:
        return []
    mend, share = found
    return [
        Notice(
            code="images_mirrored", values={"mend": mend, "misfit": share},
            details=(message("images_mirrored.mend", mend=mend),),
        )
    ]  # fmt: skip


def _places(block: Block, images: Array, depth: Array) -> Array:
    """Projection centres and points on the axes, (2 n, 3); the camera looks along -Z."""
    centre, axis = block.images.centre[images], -block.images.rotation[images][:, 2]
    return np.vstack([centre, centre + depth[:, None] * axis])


def _angle(own: Array, given: Array) -> float:
    """Median angle [degrees] between rotations (n, 3, 3)."""
    trace = np.einsum("nij,nij->n", own, given)
    return float(np.degrees(np.median(np.arccos(np.clip((trace - 1) / 2, -1, 1)))))
