"""Coordinates of tie and check points that were given: approximate, and taken where their rays do no better.

A tie point metres beside its rays, or behind a camera, leads the iteration astray, and others with it.  Where the
images that see it are oriented, its rays show where it lies.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block, Role
from raybundle.block.rigs import without_rigs
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.orientation.rays import angular_residuals, intersect_linear, object_rays, rays_of

WORSE = 5.0
"""Times the angle that intersected points leave, from which on a given point is worse than its rays.

Orientations that are off by an angle s leave the true point a Rayleigh distributed angle of that scale, and the
intersected one of n rays sqrt(1 - 3 / 2n) of it, a half at least; medians are 1.18 s.  A true point is beyond the limit
in 1 of 80 cases where all points have two rays, and in 1 of ten million where they have many: it then takes the place
that fits its rays best.
"""
NARROW = 1e-4
"""Eigenvalue ratio of an intersection below which its depth is not believed: rays parallel to about 1.2 degrees."""
GROSS = 0.05
"""Angle [rad] between a given point and its rays from which on it is reported: 3 degrees, hundreds of pixels."""


@dataclass(frozen=True, slots=True, kw_only=True)
class GivenPoints:
    """A block whose tie points stand near their rays."""

    block: Block
    replaced: Index
    """Points that were intersected anew"""
    gross: Index
    """Those of them that were given more than `GROSS` beside their rays"""


def intersected_where_better(block: Block, roles: Sequence[Role] = (Role.TIE, Role.CHECK)) -> GivenPoints:
    """Intersect the given points anew that lie far beside their rays, as far as the images are oriented.

    Coordinates of check points are there to be compared, and may be in another system than a block of free datum: as
    approximate values they are no better than those of tie points.  A point is judged by the median over its rays, so
    that a wrong ray makes no given point wrong.  Satellite scenes and what is control in any coordinate are left alone.
    """
    nothing = GivenPoints(block=block, replaced=np.zeros(0, np.int64), gross=np.zeros(0, np.int64))
    o, points = block.observations, block.points
    ours = np.array([not c.is_scene and c.values.get(c.sensor.symbols[0], 0.0) != 0 for c in block.cameras], bool)
    given = np.isfinite(points.xyz).all(axis=1) & np.isin(points.role, roles)
    given &= ~np.asarray(points.is_control).any(axis=1)
    rows = np.flatnonzero(block.images.oriented[o.image] & ours[block.images.camera[o.image]] & given[o.point])
    if not len(rows):
        return nothing
    alone = without_rigs(block)
    found = [_beside_rays(alone, some) for some in _by_points(rows, o.point[rows])]
    number, xyz, rays, ratio, before, after = (np.concatenate(parts) for parts in zip(*found, strict=True))
    sound: Mask = (rays > 1) & (ratio > NARROW) & (after < np.pi / 2)
    if not sound.any():
        return nothing
    limit = WORSE * np.maximum(after, float(np.median(after[sound])))
    worse = sound & (before > limit)
    new = np.array(points.xyz)
    new[number[worse]] = xyz[worse]
    return GivenPoints(
        block=replace(block, points=replace(points, xyz=new)),
        replaced=number[worse],
        gross=number[worse & (before > GROSS) & (np.asarray(points.role)[number] == Role.TIE)],
    )


def _by_points(rows: Index, point: Index) -> list[Index]:
    """The rows as they are, or of many those of some points after the other, so many at once as `large` states."""
    if len(rows) <= large.PIECE:
        return [rows]
    order = np.argsort(point, kind="stable")
    at = np.unique(np.searchsorted(point[order], point[order[:: large.PIECE]]))
    return np.split(rows[order], at[1:])


def _beside_rays(block: Block, rows: Index) -> tuple[Index, Array, Index, Array, Array, Array]:
    """Of the points (k,) that these image observations see, all that see them.

    returns  positions; intersections (k, 3), rays, eigenvalue ratio; median angles from the rays of the given
             coordinates, and of the intersections
    """
    part = block.observations.rows(rows)
    sensor = rays_of(replace(block, observations=part)).direction
    rotation, centre = block.images.rotation[part.image], block.images.centre[part.image]
    number, index = np.unique(part.point, return_inverse=True)
    xyz, rays, ratio = intersect_linear(
        centre, object_rays(rotation, sensor), index.astype(np.int32), len(number)
    )  # fmt: skip
    given = angular_residuals(rotation, centre, block.points.xyz[part.point], sensor)
    own = angular_residuals(rotation, centre, xyz[index], sensor)
    return number, xyz, rays, ratio, _median(given, index, len(number)), _median(own, index, len(number))


def without_given_ties(block: Block) -> Block:
    """The block without the coordinates that tie points were given."""
    tie = (np.asarray(block.points.role) == Role.TIE) & ~np.asarray(block.points.is_control).any(axis=1)
    xyz = np.where(tie[:, None], np.nan, block.points.xyz)
    return replace(block, points=replace(block.points, xyz=xyz))


def _median(values: Array, group: Index, count: int) -> Array:
    """Upper medians (count,) of values by group; every group has some."""
    order = np.lexsort((values, group))
    number = np.bincount(group, minlength=count)
    start = np.cumsum(number) - number
    return values[order][start + number // 2]
