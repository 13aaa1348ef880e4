"""Tie points that an earlier run of the project had keep their names: whoever named one means it still."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import KDTree

from raybundle.block import Block
from raybundle.block.points import NEAR_PX, automatic, automatic_name, automatic_number
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each


@dataclass(frozen=True, slots=True, kw_only=True)
class Earlier:
    """What the run before left."""

    block: Block
    taken: frozenset[str] = frozenset()
    """names that were used beside, which no other point may get"""


def named_as_before(block: Block, earlier: Earlier | None, own: Mask) -> Block:
    """The block with the tie points of an earlier run under the names that they had, and new names for the others.

    own  (p,) points whose names somebody gave, which stay

    Two points are the same where more of their image points lie within `NEAR_PX` of each other than of any other two,
    and at least two do.
    """
    if earlier is None or not len(earlier.block.points):
        return block
    ids, before = list(block.points.ids), earlier.block.points.ids
    mine = automatic(ids) & ~own
    others = {n for n, m in zip(ids, mine, strict=True) if not m}
    theirs = automatic(before) & ~np.array([n in others for n in before], bool)
    used = {*earlier.taken, *before, *others}
    named = np.full(len(ids), False)
    for p, q in _same(block, earlier.block):
        if mine[p] and theirs[q]:
            ids[p], named[p] = before[q], True
    number = max((automatic_number(n) for n in used), default=-1) + 1
    for p in np.flatnonzero(mine & ~named):
        ids[p], number = automatic_name(number), number + 1
    return replace(block, points=replace(block.points, ids=tuple(ids)))


def _same(block: Block, earlier: Block) -> list[tuple[int, int]]:
    """Points of one block and of the other that are the same, each once."""
    at = {name: k for k, name in enumerate(earlier.images.ids)}
    pairs: list[Array] = []
    own = rows_of_each(block.observations.image, len(block.images))
    theirs = rows_of_each(earlier.observations.image, len(earlier.images))
    for name, rows in zip(block.images.ids, own, strict=True):
        others = theirs[at[name]] if name in at else rows[:0]
        if len(rows) and len(others):
            nearest = KDTree(earlier.observations.xy_px[others]).query(block.observations.xy_px[rows])
            distance, k = (np.asarray(a) for a in nearest)
            near = distance <= NEAR_PX
            both = block.observations.point[rows[near]], earlier.observations.point[others[k[near]]]
            pairs.append(np.stack(both, axis=1))
    if not pairs:
        return []
    found, votes = np.unique(np.concatenate(pairs), axis=0, return_counts=True)
    return _one_each(found[votes >= 2], votes[votes >= 2])


def _one_each(pairs: Index, votes: Index) -> list[tuple[int, int]]:
    """Those with the most votes of which neither is taken."""
    mine, theirs, found = set[int](), set[int](), list[tuple[int, int]]()
    for p, q in pairs[np.argsort(-votes, kind="stable")].tolist():
        if p not in mine and q not in theirs:
            mine.add(p)
            theirs.add(q)
            found.append((p, q))
    return found
