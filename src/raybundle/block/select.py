"""Parts of a block."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block.block import Block, Role
from raybundle.numerics.arrays import Array, Index, Mask


def with_rows(block: Block, keep: Mask) -> Block:
    """The block with these image observations (m,) only; tie points left without any leave it.

    Control points, check points and points that other observations name stay, images stay.
    """
    o = block.observations
    seen = np.bincount(o.point[keep], minlength=len(block.points)) > 0
    seen |= np.asarray(block.points.role) != Role.TIE
    for t in block.tables.values():
        seen[t.refers("point")] = True
    rows = replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep])
    return with_points(replace(block, observations=rows), seen)


def with_points(block: Block, keep: Mask) -> Block:
    """The block with these object points (p,) only, which are all that its image observations name.

    Other observations of points that leave go with them.
    """
    new: Index = np.where(keep, np.cumsum(keep) - 1, -1).astype(np.int32)
    p = block.points
    return replace(
        block,
        observations=replace(block.observations, point=new[block.observations.point]),
        points=replace(
            p,
            ids=tuple(name for name, k in zip(p.ids, keep, strict=True) if k),
            role=p.role[keep],
            xyz=p.xyz[keep],
            sigma=p.sigma[keep],
        ),
    ).of_tables(lambda t: t.renumbered("point", new))


def without_images(block: Block, out: Mask) -> Block:
    """The block without the image points, orientation, position and attitude of these images (n,).

    The images stay by name; tie points left with one ray leave.
    """
    if not out.any():
        return block
    o = block.observations
    keep = ~out[o.image]
    rays = np.bincount(o.point[keep], minlength=len(block.points))
    fixed = block.points.is_control.any(axis=1)
    thin = with_rows(block, keep & ((rays > 1) | fixed)[o.point])
    images = replace(
        thin.images,
        centre=np.where(out[:, None], np.nan, thin.images.centre),
        rotation=np.where(out[:, None, None], np.nan, thin.images.rotation),
    )
    left: Index = np.where(out, -1, np.arange(len(out))).astype(np.int32)
    return replace(thin, images=images).of_tables(lambda t: t.renumbered("image", left))


def transformed(block: Block, scale: float, R: Array, t: Array) -> Block:
    """The block after X -> scale R X + t: coordinates of points and centres, rotations; control, too."""
    images, points = block.images, block.points
    return replace(
        block,
        images=replace(images, centre=scale * images.centre @ R.T + t, rotation=images.rotation @ R.T),
        points=replace(points, xyz=scale * points.xyz @ R.T + t),
    )
