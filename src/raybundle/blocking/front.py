"""The dense normal equations of one tree node: its own unknowns are eliminated, what is left goes to its parent.

With N = [[A, B'], [B, C]] of own and boundary unknowns and A = L L' the parent receives C - V V', V = B L'^-1 (Helmert
1880; Wolf 1978).  Solutions and cofactors come back the same way: with those of the boundary, x_b and Q_bb,

    x_a = L'^-1 (L^-1 n_a - V' x_b),   Q_ba = -Q_bb G,   Q_aa = A^-1 - G' Q_ba,   G = V L^-1

so that every block of the inverse that statistics ask for is that of the whole network.

Of symmetric and triangular matrices the lower triangle counts, and it alone is handed on: packed, column behind column
(`packed`), which is half of what a store keeps and a line carries.
"""

from __future__ import annotations

import math
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


@dataclass(frozen=True, slots=True)
class Placement:
    """Where single elements of a front stand in its equations: of A, of B, of C which of them, and the place of each.

    Places count down the columns, of which each is contiguous.
    """

    of: tuple[Index, Index, Index]
    at: tuple[Index, Index, Index]

    @classmethod
    def in_front(cls, front: Front, row: Index, col: Index, which: Index) -> Placement:
        """Of elements below the diagonal or on it, at rows and columns (k,); which (k,) they are of all given."""
        o, b = front.columns, front.size - front.columns
        own, outer = row < o, col >= o
        inside = (own, ~own & ~outer, outer)
        at = row + col * o, row - o + col * b, row - o + (col - o) * b
        return cls(
            tuple(which[m].astype(np.int32) for m in inside),  # pyright: ignore[reportArgumentType]
            tuple(a[m] for a, m in zip(at, inside, strict=True)),  # pyright: ignore[reportArgumentType]
        )


@dataclass(slots=True)
class Equations:
    """Normal equations of a front: the lower triangles of A and C, all of B, right sides and undamped diagonal."""

    A: Array
    """(o, o)"""
    B: Array
    """(b, o)"""
    C: Array
    """(b, b)"""
    right: Array
    diagonal: Array

    @classmethod
    def empty(cls, front: Front) -> Equations:
        """Zeros."""
        o, n = front.columns, front.size
        return cls(
            np.zeros((o, o), order="F"), np.zeros((n - o, o), order="F"), np.zeros((n - o, n - o), order="F"),
            np.zeros(n), np.zeros(n),
        )  # fmt: skip

    def add(self, where: Placement, values: Array) -> None:
        """Add single elements; none stands twice."""
        for matrix, of, at in zip((self.A, self.B, self.C), where.of, where.at, strict=True):
            if len(at):
                matrix.reshape(-1, order="F")[at] += values[of]

    def add_reduced(self, at: Index, reduced: Array) -> None:
        """Add a child's reduced matrix, packed (k (k + 1) / 2,), at these unknowns (k,).

        Both are in the order of elimination: own unknowns come first, and no element changes its triangle.
        """
        o = len(self.A)
        k = int(np.searchsorted(at, o))
        own, outer = at[:k], at[k:] - o
        rest, begin = len(outer), 0
        for j, column in enumerate(own.tolist()):
            self.A[own[j:], column] += reduced[begin : begin + k - j]
            self.B[outer, column] += reduced[begin + k - j : begin + k - j + rest]
            begin += k - j + rest
        for j, column in enumerate(outer.tolist()):
            self.C[outer[j:], column] += reduced[begin : begin + rest - j]
            begin += rest - j


def packed(lower: Array) -> Array:
    """The lower triangle (k (k + 1) / 2,) of a matrix (k, k), column behind column, as LAPACK packs it."""
    return _blas()[1].dtrttp(lower, uplo="L")[0] if len(lower) else np.zeros(0)


def packed_at(lower: Array, at: Index) -> Array:
    """That of the rows and columns (k,), ascending, of a symmetric matrix of which the lower triangle counts."""
    return np.concatenate([np.zeros(0), *(lower[at[j:], column] for j, column in enumerate(at.tolist()))])


def unpacked(triangle: Array) -> Array:
    """The matrix (k, k) again; above the diagonal it states nothing."""
    k = (math.isqrt(8 * len(triangle) + 1) - 1) // 2
    return _blas()[1].dtpttr(k, triangle, uplo="L")[0] if k else np.zeros((0, 0))


@dataclass(slots=True)
class Eliminated:
    """What elimination leaves of a front."""

    L: Array
    """(o, o) lower"""
    V: Array
    """(b, o) B L'^-1"""
    y: Array
    """(o,) L^-1 n"""
    reduced: Array
    """(b, b) of the boundary, lower triangle"""
    right: Array
    """(b,)"""
    failed: int
    """Own unknown at which the matrix is not positive definite, -1: none"""


def _blas() -> tuple[Any, Any]:
    from scipy.linalg import blas, lapack

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
    L, failed = lapack.dpotrf(e.A, lower=1, overwrite_a=1, clean=0)
    if failed:
        return Eliminated(L, e.B, e.right[:o], e.C, right, int(failed) - 1)
    y = blas.dtrsv(L, e.right[:o], lower=1)
    if not len(e.B):
        return Eliminated(L, e.B, y, e.C, right, -1)
    V = blas.dtrsm(1.0, L, e.B, side=1, lower=1, trans_a=1, overwrite_b=1)
    C = blas.dsyrk(-1.0, V, beta=1.0, c=e.C, lower=1, overwrite_c=1)
    return Eliminated(L, V, y, C, right - V @ y, -1)


def solved(L: Array, V: Array, y: Array, boundary: Array) -> Array:
    """x_a (o,) or (o, k) of the own unknowns, with those of the boundary."""
    blas, _ = _blas()
    right = y - V.T @ boundary if len(V) else y
    if not len(right):
        return right
    whole = right if right.ndim == 2 else right[:, None]
    found = blas.dtrsm(1.0, L, np.asfortranarray(whole), lower=1, trans_a=1)
    return found if right.ndim == 2 else found[:, 0]


def forward(L: Array, right: Array) -> Array:
    """L^-1 n (o, k)."""
    blas, _ = _blas()
    return blas.dtrsm(1.0, L, np.asfortranarray(right), lower=1) if len(right) else right


def cofactors(L: Array, V: Array, boundary: Array) -> Array:
    """Q (n, n) of the front with that of its boundary (b, b): of both the lower triangle counts."""
    blas, lapack = _blas()
    b, o = V.shape
    Q = np.empty((o + b, o + b), order="F")
    Q[o:, o:] = boundary
    if not o:
        return Q
    Q[:o, :o] = lapack.dpotri(L, lower=1)[0]
    if b:
        G = blas.dtrsm(1.0, L, V, side=1, lower=1)
        across = blas.dsymm(1.0, boundary, G, lower=1)
        Q[o:, :o] = -across
        Q[:o, :o] += G.T @ across
    return Q
