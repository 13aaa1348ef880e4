"""Where a network is cut, given by its incidences alone: image and object point of each image observation."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from raybundle.blocking.graph import meeting
from raybundle.blocking.skeleton import Skeleton
from raybundle.blocking.tree import WORTH, Tree, dissect
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rows import distinct

PIECE = 700_000
"""Image observations that are looked at together: what bounds the memory."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cut:
    """A tree, and where each image observation is reduced."""

    tree: Tree
    boundary: tuple[Index, ...]
    """Nodes of unknowns above each tree node that its subtree touches, in the order of their elimination"""
    at: Index
    """(m,) tree node of each image observation"""


def cut_of(skeleton: Skeleton, image: Index, point: Index, leaf: int, worth: float = WORTH) -> Cut:
    """Cut a network.

    image, point  (m,) of the image observations that take part: positions in the whole block
    leaf          unknowns of a leaf at most
    worth         as of `tree.dissect`
    """
    order = np.argsort(point, kind="stable")
    count = len(skeleton.system.sizes)
    retained = skeleton.node_of_point >= 0

    def pieces() -> Iterator[tuple[Index, Index, Index, Index]]:
        for mine in _pieces(point, order):
            row = np.where(retained[point[mine]], skeleton.count + mine, point[mine])
            yield mine, row, *skeleton.incidences(image[mine], point[mine], row)

    pairs = skeleton.pairs()
    graph = meeting(((rows, nodes) for _, _, rows, nodes in pieces()), count, pairs)
    tree = dissect(graph, skeleton.system.sizes, skeleton.places, leaf, worth)
    leaves = np.flatnonzero(np.array([not c for c in tree.children]))
    # what touches no unknown but those of its own point may stand anywhere
    at = leaves[point % len(leaves)].astype(np.int32)
    home, level = tree.home, tree.level
    first, second = home[pairs[:, 0]], home[pairs[:, 1]]
    deeper = np.where(level[first] >= level[second], first, second)
    touched = _keys(np.concatenate([deeper, deeper]), np.concatenate([pairs[:, 0], pairs[:, 1]]), count)
    for mine, row, rows, nodes in pieces():
        named, where = tree.homes(rows, nodes)
        if not len(named):
            continue
        place = np.minimum(np.searchsorted(named, row), len(named) - 1)
        at[mine] = np.where(named[place] == row, where[place], at[mine])
        here = _keys(where[np.searchsorted(named, rows)], nodes, count)
        touched = distinct(np.concatenate([touched, here]))
    return Cut(tree=tree, boundary=_boundaries(tree, touched // count, touched % count), at=at)


def _pieces(point: Index, order: Index) -> Iterator[Index]:
    """Positions of observations by object point, those of one together."""
    begin = 0
    while begin < len(order):
        end = min(begin + PIECE, len(order))
        while end < len(order) and point[order[end]] == point[order[end - 1]]:
            end += 1
        yield order[begin:end]
        begin = end


def _keys(where: Index, what: Index, count: int) -> Array:
    return distinct(where.astype(np.int64) * count + what)


def _boundaries(tree: Tree, where: Index, what: Index) -> tuple[Index, ...]:
    """Nodes of unknowns above each tree node that its subtree touches; where, what: touched in each, ascending."""
    home = tree.home
    bounds = np.searchsorted(where, np.arange(len(tree) + 1))
    found: list[Index] = []
    for t, children in enumerate(tree.children):
        touched = [what[bounds[t] : bounds[t + 1]], *(found[c] for c in children)]
        found.append(np.setdiff1d(np.concatenate(touched), tree.own[t]))
    if len(found[-1]):
        raise ValueError("observations touch unknowns of two branches")
    return tuple(nodes[np.argsort(home[nodes], kind="stable")] for nodes in found)
