"""A network that is cut: its skeleton, the tree, and which observations each tree node reduces."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from uuid import uuid4

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Block
from raybundle.blocking.cutting import cut_of
from raybundle.blocking.front import Equations, Front, Placement, entries, spread
from raybundle.blocking.part import Part, PartSystem, part_of, system_of_part
from raybundle.blocking.skeleton import Skeleton, skeleton_of
from raybundle.blocking.tree import WORTH, Tree
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each

BYTES = 350.0
"""Memory of a part that is ready for use, for each of its image observations: arrays and structure of its equations."""
LEAF = 1000
"""Unknowns of a leaf: larger ones make dense matrices of what is sparse, smaller ones more separators."""


@dataclass
class PartWork:
    """A part, its normal equations and where they stand in its front; those are made when they are first asked for."""

    part: Part
    of: PartSystem
    front: Front

    @cached_property
    def normals(self) -> Normals:
        """Its normal equations."""
        return Normals.of(self.of.system, 1)

    @cached_property
    def elements(self) -> tuple[Index, Index]:
        """(v,) row and column of each value of the normal matrix in the lower triangle of the front."""
        row, col, _ = self._elements()
        return np.maximum(row, col).astype(np.int32), np.minimum(row, col).astype(np.int32)

    @cached_property
    def into(self) -> Placement:
        """Where those stand that count, one of two equal ones."""
        row, col, across = self._elements()
        once = np.flatnonzero(across | (row >= col))
        return Placement.in_front(self.front, np.maximum(row, col)[once], np.minimum(row, col)[once], once)

    def _elements(self) -> tuple[Index, Index, Mask]:
        """(v,) row and column in the front, and whether the block of each is off the diagonal."""
        first, second, _ = self.normals.solver.blocks()
        row, col, block = entries(first, second, self.of.system.sizes.astype(np.int64))
        at = self.front.places(self.of.nodes)
        return row + at[first][block], col + at[second][block], first[block] != second[block]

    @cached_property
    def place(self) -> Index:
        """(u,) each unknown of the part in the front."""
        return self.front.unknowns(self.of.nodes)


@dataclass(frozen=True)
class Network:
    """A network that is cut."""

    key: str
    skeleton: Skeleton
    tree: Tree
    boundary: tuple[Index, ...]
    """Nodes of unknowns above each tree node that its subtree touches, in the order of their elimination"""
    counts: Index
    """(t,) image observations of each tree node"""
    part: Callable[[int], tuple[Part, Mask]]
    """The part of a tree node, and which of its image observations (m,) are rejected"""
    keep: int
    """Parts that a process holds ready for use"""

    @cached_property
    def fronts(self) -> tuple[Front, ...]:
        """Of each tree node."""
        sizes = self.skeleton.system.sizes.astype(np.int64)
        return tuple(Front(own, above, sizes) for own, above in zip(self.tree.own, self.boundary, strict=True))

    @cached_property
    def blocks(self) -> tuple[Index, Index, Array]:
        """Nodes of the rows and columns of the skeleton's blocks, and the first value of each."""
        return self.skeleton.normals.solver.blocks()

    @cached_property
    def outside(self) -> tuple[Index, ...]:
        """Blocks of the skeleton that stand in each tree node's front and in none below."""
        first, second, _ = self.blocks
        home, level = self.tree.home, self.tree.level
        a, b = home[first], home[second]
        at = np.where(level[a] >= level[b], a, b)
        return tuple(rows_of_each(at, len(self.tree)))

    def work(self, t: int) -> PartWork | None:
        """The part of a tree node as its front takes it; None where it has no observations."""
        if not self.counts[t]:
            return None
        part, rejected = self.part(t)
        return PartWork(part, system_of_part(self.skeleton, part, rejected), self.fronts[t])

    def outside_of(self, t: int) -> dict[str, Array]:
        """What the skeleton's normal equations, as they are now, bring to a front."""
        normals, own = self.skeleton.normals, self._own_unknowns(t)
        values = normals.values[self.outside_places(t)[2]]
        return {"values": values, "right": normals.right[own], "diagonal": normals.diagonal[own]}

    def add_outside(self, t: int, e: Equations, values: Array, right: Array, diagonal: Array) -> None:
        """Add what observations outside the images bring to a front, as `outside_of` states."""
        front, (row, col, _) = self.fronts[t], self.outside_places(t)
        o, once = front.columns, np.flatnonzero(row >= col)
        e.add(Placement.in_front(front, row[once], col[once], once), values)
        e.right[:o] += right
        e.diagonal[:o] += diagonal

    def _own_unknowns(self, t: int) -> Index:
        """Those of a tree node's own nodes, among all of the network."""
        front, system = self.fronts[t], self.skeleton.system
        return spread(system.offsets[front.own], system.sizes[front.own].astype(np.int64))

    def outside_places(self, t: int) -> tuple[Index, Index, Index]:
        """Row and column in a front of the skeleton's values that stand in it, and which of all values each is.

        Of equal ones both stand there: above and below the diagonal of blocks on the diagonal.  Elements of others are
        given below the diagonal of the front.
        """
        front, mine = self.fronts[t], self.outside[t]
        first, second, starts = (values[mine] for values in self.blocks)
        sizes = self.skeleton.system.sizes.astype(np.int64)
        local_row, local_col, block = entries(first, second, sizes)
        row = local_row + front.places(first)[block]
        col = local_col + front.places(second)[block]
        at = starts[block] + local_row * sizes[second][block] + local_col
        across = first[block] != second[block]
        return np.where(across, np.maximum(row, col), row), np.where(across, np.minimum(row, col), col), at


def parts_ready(counts: Index, ready: float) -> int:
    """How many parts stay ready for use within so many bytes, the largest first."""
    total = np.cumsum(np.sort(counts)[::-1]) * BYTES
    return max(1, int(np.searchsorted(total, ready, side="right")))


def cut(
    block: Block, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask, leaf: int = LEAF,
    shift: Array | None = None, worth: float = WORTH, ready: float = float("inf"),
) -> Network:  # fmt: skip
    """Cut a block that lies in memory.

    rejected  (m,) image observations that take no part
    leaf      unknowns of a leaf at most
    worth     as of `tree.dissect`
    shift     (3,) origin of the frame of the values; None: near the middle of the images
    ready     bytes of parts that stay ready for use, of which one is in any case
    """
    o = block.observations
    taken = np.flatnonzero(~rejected)
    images, points = np.zeros(len(block.images), bool), np.zeros(len(block.points), bool)
    images[o.image[taken]], points[o.point[taken]] = True, True
    skeleton = skeleton_of(block, options, free, images, points, shift)
    found = cut_of(skeleton, o.image[taken], o.point[taken], leaf, worth)
    of_node = [taken[rows] for rows in rows_of_each(found.at, len(found.tree))]
    counts = np.array([len(rows) for rows in of_node])

    def part(t: int) -> tuple[Part, Mask]:
        return part_of(block, of_node[t]), np.zeros(len(of_node[t]), bool)

    return Network(
        key=f"network-{uuid4().hex}", skeleton=skeleton, tree=found.tree, boundary=found.boundary,
        counts=counts, part=part, keep=parts_ready(counts, ready),
    )  # fmt: skip
