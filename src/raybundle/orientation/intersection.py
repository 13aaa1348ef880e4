"""Spatial intersection: object points from oriented images."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role
from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Array
from raybundle.orientation.rays import intersect_linear, object_rays, rays_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Intersection:
    """Object points with their precision; the orientations count as free of error."""

    xyz: Array
    """(p, 3)"""
    covariance: Array
    """(p, 3, 3) a-posteriori sigma0 where there is redundancy"""
    adjustment: Adjustment


def intersection(block: Block) -> Intersection:
    """Intersect all points of a block whose images are oriented, orientations and cameras held.

    raises  NoOrientation where an image is not oriented; InputError for points with fewer than two rays

    The covariances hold the orientations fixed: they say how well the rays meet, not how well the block stands
    in space; `raybundle.adjust` gives that.
    """
    used = np.unique(block.observations.image)
    missing = [block.images.ids[i] for i in used if not block.images.oriented[i]]
    if missing:
        raise NoOrientation("orientation.images_missing", names=missing)
    rays = rays_of(block)
    rotation, centre = block.images.rotation[rays.image], block.images.centre[rays.image]
    xyz, _, _ = intersect_linear(centre, object_rays(rotation, rays.direction), rays.point, len(block.points))
    fixed = replace(
        block,
        cameras=tuple(replace(c, estimate=()) for c in block.cameras),
        images=replace(block.images, held=np.ones(len(block.images), bool)),
        points=replace(
            block.points,
            xyz=xyz,
            role=np.full(len(block.points), Role.TIE, np.int32),
            sigma=np.full((len(block.points), 3), np.nan),
        ),
    )
    result = adjust_block(fixed, AdjustmentOptions())
    assert result.precision is not None
    return Intersection(xyz=result.adjusted.points.xyz, covariance=result.precision.object_points, adjustment=result)
