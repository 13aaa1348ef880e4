"""What all parts of a network share: the nodes of unknowns, and the observations outside the images.

The skeleton is a block like any other, with all images, cameras, instruments and tables, the object points that these
name or that are given, and no image observation.  Its layout states which unknowns there are; the parts (`part`) have
none of their own but the object points that they eliminate.  What kinds of observation there are it need not know.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import System, system_of
from raybundle.adjustment.system.layout import used_of
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.other_observations import carried_points
from raybundle.block import Block
from raybundle.block.select import select_block
from raybundle.numerics.arrays import Array, Index, Mask


@dataclass(frozen=True, slots=True, kw_only=True)
class Skeleton:
    """Unknowns and observations outside the images of a network that is cut into parts."""

    block: Block
    """Without image observations"""
    points: Index
    """(k,) positions of its object points in the whole block, ascending"""
    count: int
    """Object points of the whole block"""
    system: System
    """Of the object points only those that have a node"""
    given: System
    """The same with the other object points that are given: what fixes the datum"""
    normals: Normals
    options: AdjustmentOptions
    free: Mapping[str, tuple[str, ...]]

    @property
    def node_of_point(self) -> Index:
        """(p,) node of each object point of the whole block, -1 where it is eliminated."""
        found = np.full(self.count, -1, np.int32)
        found[self.points] = self.system.point_node
        return found

    @property
    def places(self) -> Array:
        """(nodes, 3) where the unknowns of each node stand; NaN where they have no place."""
        system, state = self.system, self.system.initial_state()
        found = np.full((len(system.sizes), 3), np.nan)
        images = np.flatnonzero(system.image_node >= 0)
        found[system.image_node[images]] = state.centre[images]
        points = np.flatnonzero(system.point_node >= 0)
        found[system.point_node[points]] = state.xyz[points]
        return found

    def incidences(self, image: Index, point: Index, row: Index) -> tuple[Index, Index]:
        """The nodes that stand in image observations: rows (k,) ascending, and nodes (k,).

        image, point  (m,) positions in the whole block
        row           (m,) what is eliminated together: one number for the observations of an eliminated object point
        """
        system = self.system
        nodes = np.stack([system.image_node[image], system.shared_node[image], self.node_of_point[point]], axis=1)
        rows = np.repeat(row, nodes.shape[1])
        flat = nodes.ravel()
        order = np.argsort(rows[flat >= 0], kind="stable")
        return rows[flat >= 0][order], flat[flat >= 0][order]

    def pairs(self) -> Array:
        """(e, 2) nodes that meet in observations outside the images."""
        first, second, _ = self.normals.solver.blocks()
        return np.stack([first, second], axis=1)


def skeleton_of(
    block: Block, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], images: Mask, points: Mask,
    shift: Array | None = None,
) -> Skeleton:  # fmt: skip
    """The skeleton of a block that lies in memory.

    images  (n,) that take part by image observations
    points  (p,) object points that do
    shift   (3,) origin of the frame of the values; None: near the middle of the images
    """
    at = np.flatnonzero(block.points_named | block.points.is_control.any(axis=1))
    bare = select_block(replace(block, observations=block.observations.empty(), rejected=()), "point", at)
    return skeleton_from(bare, at, len(block.points), options, free, images, points[at], shift)


def skeleton_from(
    bare: Block, at: Index, count: int, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], images: Mask,
    points: Mask, shift: Array | None = None,
) -> Skeleton:  # fmt: skip
    """The skeleton of a block of which the object points that it needs are known already.

    bare    without image observations, and of the object points only those that are named or given
    at      (k,) their positions in the whole block, ascending
    count   object points of the whole block
    images  (n,) that take part by image observations
    points  (k,) of these object points that do
    """
    chosen = options.datum in {"inner", "minimal"}
    used = used_of(bare, options, np.zeros(0, np.int64), images, points | carried_points(bare, datum_is_chosen=chosen))
    given = system_of(bare, options, used, dict(free), shift)
    kept = given.point_node >= 0
    system = replace(
        given, points_used=given.points_used & kept, held=given.held & kept[:, None],
        control_held=given.control_held & kept[:, None], prior=given.prior & kept[:, None],
        far_candidates=np.zeros(0, np.int64),
    )  # fmt: skip
    # statistics ask how the interior orientation and the images that share it are correlated
    own, shared = system.image_node, system.shared_node
    both = (own >= 0) & (shared >= 0)
    together = {(int(a), int(b)) for a, b in zip(own[both], shared[both], strict=True)}
    return Skeleton(
        block=bare, points=at, count=count, system=system, given=given,
        normals=Normals.of(system, 1, sorted(together)), options=options, free=dict(free),
    )  # fmt: skip
