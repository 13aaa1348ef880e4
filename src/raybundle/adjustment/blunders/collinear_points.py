"""Images whose object points all lie on one straight line: each may stand anywhere on a circle round it."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import RankDefect, Undetermined
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rows import rows_of_each

THIN = 0.05
"""Spread beside a line, as a share of that along it, up to which points are asked whether they lie on it."""
BESIDE = 3.0
"""Deviations from a line, in their standard deviations, from which on they are there.

An image turns about the line of its points unless some lie beside it, and what lies beside it by errors alone
(whose root mean square is 1) shows a rotation that the errors made.
"""


def any_in_line(block: Block, used: Mask) -> bool:
    """Whether the points of an image may lie on a line: without that `check_turning` finds nothing."""
    rows = np.flatnonzero(used)
    points = (
        block.observations.point[rows[mine]] for mine in rows_of_each(block.observations.image[rows], len(block.images))
    )
    for xyz in (block.points.xyz[p] for p in points if len(p)):
        spread = np.linalg.eigvalsh(np.cov(_without_far(xyz)[0].T, bias=True))
        if spread[1] < (2 * THIN) ** 2 * spread[2]:
            return True
    return False


def check_turning(result: Adjustment) -> None:
    """Raise RankDefect for images that turn about a line; without covariances nothing is asked.

    Held images, scenes and images whose position or attitude is observed do not turn.
    """
    block = result.adjusted
    if result.precision is None:
        return
    fixed = block.images_named if block.images.held is None else block.images.held | block.images_named
    fixed |= np.array([c.is_scene for c in block.cameras])[block.images.camera]
    used, o = result.image_observations.used, block.observations
    lost: list[str] = []
    rows = np.flatnonzero(used & ~fixed[o.image])
    rows = rows[np.argsort(o.image[rows], kind="stable")]
    first = np.searchsorted(o.image[rows], np.arange(len(block.images) + 1))
    for image in np.flatnonzero(~fixed):
        points = np.unique(o.point[rows[first[image] : first[image + 1]]])
        if len(points) and _straight(block.points.xyz[points], result.precision.object_points[points]):
            lost.append(block.images.ids[image])
    if not lost:
        return
    raise RankDefect(
        "image.points_in_line", n=len(lost), images=lost, limit_sigmas=BESIDE,
        undetermined=[Undetermined(kind="image", name=name) for name in lost],
    )  # fmt: skip


def _straight(xyz: Array, covariance: Array) -> bool:
    """Whether points (n, 3) lie on a line as far as their covariances (n, 3, 3) show."""
    xyz, near = _without_far(xyz)
    covariance = covariance[near]
    d = xyz - xyz.mean(axis=0)
    _, size, axes = np.linalg.svd(d, full_matrices=False)
    if len(xyz) < 3 or not size[1] < THIN * size[0]:
        return False
    beside = d @ axes[1:].T
    C = axes[1:] @ np.nan_to_num(covariance) @ axes[1:].T
    rounding = (1e-12 * float(np.abs(xyz).max()) + 1e-9 * float(size[0])) ** 2  # held points have no covariance
    squares = np.einsum("ni,ni->n", beside, np.linalg.solve(C + rounding * np.eye(2), beside[:, :, None])[:, :, 0])
    return bool(squares.sum() < BESIDE**2 * 2 * len(xyz))


def _without_far(xyz: Array) -> tuple[Array, Mask]:
    """Points without those far off, and which remain: points at infinity make a line of any block."""
    away = np.linalg.norm(xyz - np.median(xyz, axis=0), axis=1)
    near = away <= 3 * np.median(away)
    return xyz[near], near
