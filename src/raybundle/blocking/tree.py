"""Nested dissection: a graph of nodes cut into leaves and separators (George 1973; Lipton, Rose and Tarjan 1979).

A separator is a smallest set of nodes that touches every edge which a bisection cuts (Koenig 1931: in a bipartite graph
it is as large as the largest matching).  So all nodes that stand in one observation lie on one path from a leaf to the
root, and each object point is eliminated in one part alone.  A node that meets very many others, as an interior
orientation that all images share, covers more cut edges than any other: it comes to stand at the root by itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

WORTH = 0.9
"""Of the multiplications of a part in one piece that its pieces may take; beyond, cutting is no gain."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Tree:
    """Leaves and separators; children stand before their parents, the root last."""

    own: tuple[Index, ...]
    """Nodes of unknowns of each tree node, ascending"""
    parent: Index
    """(t,) -1: the root"""
    level: Index
    """(t,) steps to the root"""

    def __len__(self) -> int:
        return len(self.own)

    @property
    def children(self) -> tuple[tuple[int, ...], ...]:
        """Of each tree node."""
        found: list[list[int]] = [[] for _ in self.own]
        for t, q in enumerate(self.parent.tolist()):
            if q >= 0:
                found[q].append(t)
        return tuple(map(tuple, found))

    @property
    def home(self) -> Index:
        """(nodes,) tree node of each node of unknowns."""
        found = np.zeros(sum(map(len, self.own)), np.int32)
        for t, own in enumerate(self.own):
            found[own] = t
        return found

    def homes(self, rows: Index, nodes: Index) -> tuple[Index, Index]:
        """Rows of incidences, each once and ascending, and the tree node of each: the deepest of its nodes'."""
        at = self.home[nodes]
        order = np.lexsort((self.level[at], rows))
        rows, at = rows[order], at[order]
        last = np.flatnonzero(np.append(rows[1:] != rows[:-1], len(rows) > 0))
        return rows[last], at[last]


def dissect(graph: Any, sizes: Array, places: Array, most: int, worth: float = WORTH) -> Tree:
    """Cut a graph into leaves of at most `most` unknowns, where cutting gains something.

    graph   (n, n) symmetric, CSR, `graph.meeting`
    sizes   (n,) unknowns of each node
    places  (n, d) where each stands; NaN where it has no place
    worth   `WORTH`; larger where memory is what is short
    """
    places = _placed(graph, places)
    own, parent, level = list[Index](), list[int](), list[int]()

    def cut(ids: Index, depth: int) -> int:
        parts = _parts(graph, sizes, places, ids, worth) if sizes[ids].sum() > most and len(ids) > 1 else None
        below = [] if parts is None else [cut(part, depth + 1) for part in parts[1:] if len(part)]
        own.append(np.sort(ids if parts is None else parts[0]))
        parent.append(-1)
        level.append(depth)
        for child in below:
            parent[child] = len(own) - 1
        return len(own) - 1

    cut(np.arange(len(sizes)), 0)
    return Tree(own=tuple(own), parent=np.array(parent, np.int32), level=np.array(level, np.int32))


def _parts(graph: Any, sizes: Array, places: Array, ids: Index, worth: float) -> tuple[Index, Index, Index] | None:
    """Separator and the two sides of some nodes; None where the separator would be most of them."""
    side = _bisected(places[ids], sizes[ids])
    part = graph[ids][:, ids]
    between = np.zeros(len(ids), bool)
    between[_cover(part, side)] = True
    found = ids[between], ids[~between & ~side], ids[~between & side]
    separator, first, second = (float(sizes[x].sum()) for x in found)
    pieces = multiplications(first, separator) + multiplications(second, separator) + multiplications(separator, 0.0)
    return found if pieces < worth * multiplications(separator + first + second, 0.0) else None


def multiplications(own: float, boundary: float) -> float:
    """That eliminate own unknowns of a front with a boundary."""
    return own**3 / 3 + own**2 * boundary + own * boundary**2


def _bisected(places: Array, sizes: Array) -> Mask:
    """(n,) two sides of about equal sizes along the longest axis of the places."""
    away = places - places.mean(axis=0)
    axis = np.linalg.svd(away.T @ away)[0][:, 0]
    order = np.argsort(away @ axis, kind="stable")
    side = np.zeros(len(places), bool)
    half = np.cumsum(sizes[order]) > sizes.sum() / 2
    half[-1] = True
    side[order[half]] = True
    return side


def _cover(graph: Any, side: Mask) -> Index:
    """A smallest set of nodes that touches every edge between the sides (Koenig)."""
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import maximum_bipartite_matching

    edges = graph.tocoo()
    cut = ~side[edges.row] & side[edges.col]
    if not cut.any():
        return np.zeros(0, np.int64)
    n = len(side)
    across = csr_matrix((np.ones(int(cut.sum()), np.int8), (edges.row[cut], edges.col[cut])), shape=(n, n))
    mate = maximum_bipartite_matching(across, perm_type="column")
    matched = np.full(n, -1)
    with_mate = np.flatnonzero(mate >= 0)
    matched[mate[with_mate]] = with_mate
    left = np.unique(edges.row[cut])
    reached, reached_across = np.zeros(n, bool), np.zeros(n, bool)
    stack = [a for a in left.tolist() if mate[a] < 0]
    reached[stack] = True
    while stack:  # alternating paths from nodes without a mate
        a = stack.pop()
        for b in across.indices[across.indptr[a] : across.indptr[a + 1]].tolist():
            if reached_across[b]:
                continue
            reached_across[b] = True
            if matched[b] >= 0 and not reached[matched[b]]:
                reached[matched[b]] = True
                stack.append(int(matched[b]))
    return np.concatenate([left[~reached[left]], np.flatnonzero(reached_across)])


def _placed(graph: Any, places: Array) -> Array:
    """Places (n, d) of all: those without one stand in the middle of their neighbours that have one, or of all."""
    found = np.array(places, float)
    lost: Mask = np.logical_not(np.isfinite(found).all(axis=1))
    if not lost.any():
        return found
    known = np.where(lost[:, None], 0.0, found)
    middle = known[~lost].mean(axis=0) if not lost.all() else np.zeros(found.shape[1])
    sums, counts = graph[lost] @ known, graph[lost] @ (~lost).astype(float)
    near = sums / np.maximum(counts, 1)[:, None]
    found[lost] = np.where(counts[:, None] > 0, near, middle)
    return found
