"""The dense normal equations of one tree node: its own unknowns are eliminated, what is left goes to its parent.

With N = [[A, B], [B', C]] of own and boundary unknowns and A = L L' the parent receives C - W' W, W = L^-1 B (Helmert
1880; Wolf 1978).  Solutions and cofactors come back the same way: with those of the boundary, x_b and Q_bb,

    x_a = L'^-1 (L^-1 n_a - W x_b),   Q_ab = -G Q_bb,   Q_aa = A^-1 - Q_ab G',   G = L'^-1 W

so that every block of the inverse that statistics ask for is that of the whole network.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Index


@dataclass(frozen=True)
class Front:
    """Which unknowns a tree node's normal equations have, own ones first."""

    own: Index
    """Nodes of unknowns, ascending"""
    boundary: Index
    """Nodes of unknowns that tree nodes above have and this one's subtree touches, in the order of elimination"""
    sizes: Array
    """(nodes,) unknowns of all nodes of the network"""

    @cached_property
    def nodes(self) -> Index:
        """Own, then boundary."""
        return np.concatenate([self.own, self.boundary]).astype(np.int64)

    @cached_property
    def starts(self) -> Array:
        """(nodes + 1,) first unknown of each, in the front."""
        return np.concatenate([[0], np.cumsum(self.sizes[self.nodes])]).astype(np.int64)

    @property
    def columns(self) -> int:
        """Own unknowns."""
        return int(self.starts[len(self.own)])

    @property
    def size(self) -> int:
        """All of them."""
        return int(self.starts[-1])

    def places(self, nodes: Index) -> Index:
        """(k,) first unknown of nodes that it has."""
        order = np.argsort(self.nodes, kind="stable")
        at = order[np.searchsorted(self.nodes, nodes, sorter=order)]
        if not np.array_equal(self.nodes[at], nodes):
            raise KeyError("a node that the front does not have")
        return self.starts[at]

    def unknowns(self, nodes: Index) -> Index:
        """(u,) unknowns of nodes that it has, one node behind the other."""
        return spread(self.places(nodes), self.sizes[nodes])


def spread(start: Index, size: Array) -> Index:
    """start, start + 1, ... start + size - 1 of each, one behind the other."""
    total = np.cumsum(size)
    return np.arange(int(total[-1]) if len(total) else 0) + np.repeat(start - total + size, size)


def entries(first: Index, second: Index, sizes: Array) -> tuple[Index, Index, Index]:
    """Row and column of each element of blocks within them, and which block it is of.

    first, second  (b,) nodes of the rows and columns of blocks
    """
    count = sizes[first] * sizes[second]
    block = np.repeat(np.arange(len(first)), count)
    local = np.arange(int(count.sum())) - np.repeat(np.cumsum(count) - count, count)
    return local // sizes[second][block], local % sizes[second][block], block


@dataclass(slots=True)
class Equations:
    """Normal equations of a front: the lower triangles of A and C, all of B, right sides and undamped diagonal."""

    A: Array
    B: Array
    C: Array
    right: Array
    diagonal: Array

    @classmethod
    def empty(cls, front: Front) -> Equations:
        """Zeros."""
        o, n = front.columns, front.size
        return cls(
            np.zeros((o, o), order="F"), np.zeros((o, n - o), order="F"), np.zeros((n - o, n - o), order="F"),
            np.zeros(n), np.zeros(n),
        )  # fmt: skip

    def add(self, row: Index, col: Index, values: Array) -> None:
        """Add single elements, each of one triangle of the whole; none stands twice."""
        o = len(self.A)
        low, high = np.minimum(row, col), np.maximum(row, col)
        own, outer = high < o, low >= o
        mixed = ~own & ~outer
        self.A[high[own], low[own]] += values[own]
        self.B[low[mixed], high[mixed] - o] += values[mixed]
        self.C[high[outer] - o, low[outer] - o] += values[outer]

    def add_reduced(self, at: Index, lower: Array) -> None:
        """Add a child's reduced matrix (k, k), of which the lower triangle counts, at these unknowns (k,).

        Both are in the order of elimination: own unknowns come first, and no element changes its triangle.
        """
        o = len(self.A)
        k = int(np.searchsorted(at, o))
        a, b = at[:k], at[k:] - o
        self.A[np.ix_(a, a)] += lower[:k, :k]
        self.B[np.ix_(a, b)] += lower[k:, :k].T
        self.C[np.ix_(b, b)] += lower[k:, k:]


@dataclass(slots=True)
class Eliminated:
    """What elimination leaves of a front."""

    L: Array
    """(o, o) lower"""
    W: Array
    """(o, b) L^-1 B"""
    y: Array
    """(o,) L^-1 n"""
    reduced: Array
    """(b, b) of the boundary, lower triangle"""
    right: Array
    """(b,)"""
    failed: int
    """Own unknown at which the matrix is not positive definite, -1: none"""


def _blas() -> tuple[Any, Any]:
    from scipy.linalg import blas, lapack  # noqa: PLC0415

    return blas, lapack


def eliminate(e: Equations, damping: float) -> Eliminated:
    """Eliminate the own unknowns; the matrices are used up."""
    blas, lapack = _blas()
    o = len(e.A)
    if damping:
        # an unknown that nothing touches stays where it is; the undamped factor then names it
        e.A[np.arange(o), np.arange(o)] += damping * np.where(e.diagonal[:o] > 0, e.diagonal[:o], 1.0)
    right = e.right[o:].copy()
    if not o:
        return Eliminated(e.A, e.B, e.right[:0], e.C, right, -1)
    diagonal = np.diagonal(e.A)
    if not (diagonal > 0).all():
        return Eliminated(e.A, e.B, e.right[:o], e.C, right, int(np.flatnonzero(~(diagonal > 0))[0]))
    L, failed = lapack.dpotrf(e.A, lower=1, overwrite_a=1, clean=1)
    if failed:
        return Eliminated(L, e.B, e.right[:o], e.C, right, int(failed) - 1)
    y = blas.dtrsv(L, e.right[:o], lower=1)
    if not e.B.shape[1]:
        return Eliminated(L, e.B, y, e.C, right, -1)
    W = blas.dtrsm(1.0, L, e.B, lower=1, overwrite_b=1)
    C = blas.dsyrk(-1.0, W, beta=1.0, c=e.C, trans=1, lower=1, overwrite_c=1)
    return Eliminated(L, W, y, C, right - W.T @ y, -1)


def solved(L: Array, W: Array, y: Array, boundary: Array) -> Array:
    """x_a (o,) or (o, k) of the own unknowns, with those of the boundary."""
    blas, _ = _blas()
    right = y - W @ boundary if W.shape[1] else y
    if not len(right):
        return right
    whole = right if right.ndim == 2 else right[:, None]
    found = blas.dtrsm(1.0, L, np.asfortranarray(whole), lower=1, trans_a=1)
    return found if right.ndim == 2 else found[:, 0]


def forward(L: Array, right: Array) -> Array:
    """L^-1 n (o, k)."""
    blas, _ = _blas()
    return blas.dtrsm(1.0, L, np.asfortranarray(right), lower=1) if len(right) else right


def cofactors(L: Array, W: Array, boundary: Array) -> Array:
    """Q (n, n) of the front with that of its boundary (b, b)."""
    blas, lapack = _blas()
    o, b = W.shape
    Q = np.empty((o + b, o + b))
    if o:
        inverse = lapack.dpotri(L, lower=1)[0]
        inverse = np.tril(inverse) + np.tril(inverse, -1).T
    else:
        inverse = np.zeros((0, 0))
    if not b:
        Q[:] = inverse
        return Q
    G = blas.dtrsm(1.0, L, W, lower=1, trans_a=1) if o else W
    across = G @ boundary
    Q[o:, o:] = boundary
    Q[:o, o:], Q[o:, :o] = -across, -across.T
    own = across @ G.T
    Q[:o, :o] = inverse + (own + own.T) / 2
    return Q
