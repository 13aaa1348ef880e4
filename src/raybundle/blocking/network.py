"""A network that is cut: its skeleton, the tree, and which observations each tree node reduces."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from uuid import uuid4

import numpy as np

from raybundle.adjustment.normals import Normals
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block import Block
from raybundle.blocking.front import Equations, Front, entries
from raybundle.blocking.graph import in_pieces, meeting
from raybundle.blocking.part import Part, PartSystem, part_of, system_of_part
from raybundle.blocking.skeleton import Skeleton, skeleton_of
from raybundle.blocking.tree import Tree, dissect
from raybundle.numerics.arrays import Array, Index, Mask

LEAF = 1000
"""Unknowns of a leaf: larger ones make dense matrices of what is sparse, smaller ones more separators."""


@dataclass(slots=True)
class PartWork:
    """A part with its normal equations and where they stand in its front."""

    part: Part
    of: PartSystem
    normals: Normals
    front: Front
    row: Index
    """(v,) row of each value of the normal matrix in the front"""
    col: Index
    once: Mask
    """(v,) whether it is the one of two equal ones that counts"""
    place: Index
    """(u,) each unknown of the part in the front"""


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
        order = np.argsort(at, kind="stable")
        bounds = np.searchsorted(at[order], np.arange(len(self.tree) + 1))
        return tuple(order[bounds[t] : bounds[t + 1]] for t in range(len(self.tree)))

    def work(self, t: int) -> PartWork | None:
        """The part of a tree node as its front takes it; None where it has no observations."""
        if not self.counts[t]:
            return None
        part, rejected = self.part(t)
        of = system_of_part(self.skeleton, part, rejected)
        normals, front = Normals.of(of.system, 1), self.fronts[t]
        first, second, _ = normals.solver.blocks()
        sizes = of.system.sizes.astype(np.int64)
        row, col, block = entries(first, second, sizes)
        at = front.places(of.nodes)
        row, col = row + at[first][block], col + at[second][block]
        once = (first[block] != second[block]) | (row >= col)
        place = front.unknowns(of.nodes)
        return PartWork(part, of, normals, front, row, col, once, place)

    def add_outside(self, t: int, e: Equations, values: Array, right: Array, diagonal: Array) -> None:
        """Add what observations outside the images bring to a front; `values` and others as of the skeleton."""
        front, system = self.fronts[t], self.skeleton.system
        row, col, at = self.outside_places(t)
        once = row >= col
        e.add(row[once], col[once], values[at[once]])
        own = _unknowns(system.offsets, front.own)
        e.right[: front.columns] += right[own]
        e.diagonal[: front.columns] += diagonal[own]

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


def _unknowns(offsets: Array, nodes: Index) -> Index:
    """Unknowns of nodes, one node behind the other."""
    return np.concatenate([np.arange(offsets[n], offsets[n + 1]) for n in nodes.tolist()] or [np.zeros(0, np.int64)])


def cut(
    block: Block, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask, leaf: int = LEAF,
    shift: Array | None = None,
) -> Network:  # fmt: skip
    """Cut a block that lies in memory.

    rejected  (m,) image observations that take no part
    leaf      unknowns of a leaf at most
    shift     (3,) origin of the frame of the values; None: near the middle of the images
    """
    o = block.observations
    taken = np.flatnonzero(~rejected)
    images, points = np.zeros(len(block.images), bool), np.zeros(len(block.points), bool)
    images[o.image[taken]], points[o.point[taken]] = True, True
    skeleton = skeleton_of(block, options, free, images, points, shift)
    count = len(skeleton.system.sizes)
    eliminated = skeleton.node_of_point[o.point[taken]] < 0
    row = np.where(eliminated, o.point[taken], len(block.points) + taken)
    rows, nodes = skeleton.incidences(o.image[taken], o.point[taken], row)
    graph = meeting(in_pieces(rows, nodes), count, skeleton.pairs())
    tree = dissect(graph, skeleton.system.sizes, skeleton.places, leaf)
    named, home = tree.homes(rows, nodes)
    # what touches no unknown but its own point may stand anywhere
    place = np.minimum(np.searchsorted(named, row), max(len(named) - 1, 0))
    found = named[place] == row if len(named) else np.zeros(len(row), bool)
    leaves = np.flatnonzero(np.array([not c for c in tree.children]))
    at = np.where(found, home[place] if len(named) else 0, leaves[row % len(leaves)])
    order = np.argsort(at, kind="stable")
    bounds = np.searchsorted(at[order], np.arange(len(tree) + 1))
    of_node = [np.sort(taken[order[bounds[t] : bounds[t + 1]]]) for t in range(len(tree))]

    def part(t: int) -> tuple[Part, Mask]:
        return part_of(block, of_node[t]), np.zeros(len(of_node[t]), bool)

    return Network(
        key=f"network-{uuid4().hex}", skeleton=skeleton, tree=tree, boundary=_boundaries(tree, rows, nodes, named, home, skeleton.pairs()),
        counts=np.diff(bounds), part=part, keep=len(tree),
    )  # fmt: skip


def _boundaries(
    tree: Tree, rows: Index, nodes: Index, named: Index, home: Index, pairs: Array
) -> tuple[Index, ...]:
    """Nodes of unknowns above each tree node that its subtree touches."""
    of_node = tree.home
    at = home[np.searchsorted(named, rows)]
    a, b = of_node[pairs[:, 0]], of_node[pairs[:, 1]]
    deeper = np.where(tree.level[a] >= tree.level[b], a, b)
    where = np.concatenate([at, deeper, deeper]).astype(np.int64)
    what = np.concatenate([nodes, pairs[:, 0], pairs[:, 1]]).astype(np.int64)
    keys = np.unique(where * len(of_node) + what)
    where, what = keys // len(of_node), keys % len(of_node)
    bounds = np.searchsorted(where, np.arange(len(tree) + 1))
    found: list[Index] = []
    for t, children in enumerate(tree.children):
        touched = [what[bounds[t] : bounds[t + 1]], *(found[c] for c in children)]
        found.append(np.setdiff1d(np.concatenate(touched), tree.own[t]))
    if len(found[-1]):
        raise ValueError("observations touch unknowns of two branches")
    return tuple(nodes[np.argsort(of_node[nodes], kind="stable")] for nodes in found)
