"""The NumPy twin of the compiled kernels: the same interface and the same numbers, slower.

It works where no compiler was there, and tests hold the kernels against it.  Read it for what the
kernels compute: residuals and partial derivatives of the image observations, the object points
eliminated from the normal equations, the factor, and the statistics from its inverse.  The reduced
normal matrix is dense here, so blocks of more than a few hundred images take their time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.images_numpy import BEHIND, LOST, image_residuals
from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.platforms.station import station_partials

SINGULAR = 1e-13
"""Pivot of a point's normal matrix, relative to its diagonal, below which the point counts as undetermined."""
_CHUNK = 400
"""Object points whose statistics are formed together."""


@dataclass(slots=True)
class _Linear:
    """Linearised, whitened observations in the order of `System.rows`."""

    v: Array
    """(m, 2)"""
    J: Array
    """(m, 2, k) by the unknowns `Solver.columns` of the nodes"""
    A: Any
    """(2 m, N) sparse, the same"""
    x: Array
    """(m, 2, 3) by the object point"""
    rho: Array
    """(m,) half the square sum, robust if asked"""
    flags: Array
    """(m,)"""


class Solver:
    """Reduced normal equations of one system, as `raybundle._native.Solver`."""

    def __init__(self, block: Block, system: System) -> None:
        """Keep the system; the `set_...` calls hand over the same arrays as to the compiled solver."""
        del block
        self.system = system
        self.factorised = False
        self.smallest_pivot, self.smallest_pivot_at = 1.0, -1
        self.own_pivots = np.ones(0)

    def set_observations(self, image: Index, point: Index, xy: Array, whiten: Array, external_row: Index) -> None:
        """Observations, sorted by point: xy (m, 2) [mm]; lower triangle (m, 3) of the whitening matrices."""
        del external_row
        self.image, self.point, self.xy = image, point, xy
        self.whiten = np.zeros((len(image), 2, 2))
        self.whiten[:, 0, 0], self.whiten[:, 1, 0], self.whiten[:, 1, 1] = whiten.T

    def set_images(
        self, model: Index, corrected: Index, interior: Index, pattern: Index, own: Index, shared: Index,
        parameters: Index, stride: int,
    ) -> None:  # fmt: skip
        """Images: free columns and the nodes that carry them; the rest the system knows."""
        del model, corrected, interior, parameters
        self.pattern, self.own, self.shared, self.stride = pattern, own, shared, stride

    def set_patterns(self, patterns: list[tuple[list[int], list[int]]]) -> None:
        """Lists of free local columns (X0 Y0 Z0, rotation, interior) of the own and the shared node."""
        self.patterns = patterns

    def set_points(self, first: Array, node: Index, held: Array, weight: Array, value: Array) -> None:
        """Object points: first observation (p + 1,), node of retained ones, held and observed coordinates."""
        self.first, self.node, self.weight, self.value = first, node, weight, value
        self.eliminated = node < 0
        self.set_held(held)

    def set_held(self, held: Array) -> None:
        """Held coordinates (p,) as bits."""
        self.held = (held[:, None] & np.array([1, 2, 4], np.uint8)) > 0

    def set_external(self, rows: Array, touched: Index, width: int) -> None:
        """Nothing to do: every model is evaluated here."""

    def set_nodes(self, sizes: Array, extra: list[tuple[int, int]]) -> None:
        """Sizes of the nodes; those that meet, by observations or as is stated, have a block."""
        self.sizes = np.asarray(sizes, np.int64)
        self.offsets = np.concatenate([[0], np.cumsum(self.sizes)])
        self.unknowns = N = int(self.offsets[-1])
        self.first_node, self.second_node = first, second = self._meeting(extra)
        count = self.sizes[first] * self.sizes[second]
        self.start = np.concatenate([[0], np.cumsum(count)])
        self.values_size = int(self.start[-1])
        self.factor_entries, self.factor_operations = N * (N + 1) // 2, N**3 / 3
        # where the values of the blocks stand in the whole matrix
        local = np.arange(self.values_size) - self.start[:-1].repeat(count)
        columns = self.sizes[second].repeat(count)
        row = self.offsets[first].repeat(count) + local // columns
        col = self.offsets[second].repeat(count) + local % columns
        self.place = row * N + col
        self._place_columns()

    def _meeting(self, extra: list[tuple[int, int]]) -> tuple[Array, Array]:
        """Nodes that meet in an object point, or beside, each pair once, in the order of the compiled solver."""
        from scipy.sparse import csr_matrix

        p, n = len(self.first) - 1, len(self.sizes)
        nodes = np.stack([self.own[self.image], self.shared[self.image], self.node[self.point]], axis=1)
        point = np.repeat(self.point, nodes.shape[1])
        there = nodes.ravel() >= 0
        stands = csr_matrix((np.ones(int(there.sum()), np.int32), (point[there], nodes.ravel()[there])), shape=(p, n))
        met = (stands.T @ stands).tocoo()
        beside = np.array(extra, np.int64).reshape(-1, 2)
        low, high = beside.min(axis=1), beside.max(axis=1)
        upper = met.row <= met.col
        keys = np.concatenate([met.row[upper].astype(np.int64) * n + met.col[upper], low * n + high])
        first, second = np.divmod(np.unique(keys), n)
        return first, second

    def _place_columns(self) -> None:
        """Unknowns (m, k) that each observation touches, and its local columns (m, k); padded by a column of zeros."""
        nothing, m = 9 + self.stride, len(self.image)
        kept = np.flatnonzero(~self.eliminated[self.point])
        width = max((len(own) + len(shared) for own, shared in self.patterns), default=0) + 3 * (len(kept) > 0)
        self.columns, self.local = np.zeros((m, width), np.int64), np.full((m, width), nothing)
        for code, (own, shared) in enumerate(self.patterns):
            mine = np.flatnonzero(self.pattern[self.image] == code)
            a, b = len(own), len(own) + len(shared)
            self.local[mine, :b] = own + shared
            self.columns[mine, :a] = self.offsets[self.own[self.image[mine]], None] + np.arange(a)
            self.columns[mine, a:b] = self.offsets[self.shared[self.image[mine]], None] + np.arange(b - a)
        for r in (r for r, row in enumerate(self.system.interior) if row.links):
            mine = np.flatnonzero(self.system.interior_of_image[self.image] == r)
            free = np.flatnonzero(self.system.interior_columns[r] >= 0)
            self.local[mine, : len(free)] = 6 + free
            self.columns[mine, : len(free)] = self.system.interior_columns[r, free]
        if len(kept):
            self.local[kept, -3:] = 6 + self.stride + np.arange(3)
            self.columns[kept, -3:] = self._retained(self.point[kept])

    def _retained(self, points: Array) -> Array:
        """Unknowns (n, 3) of retained points."""
        return self.offsets[self.node[points], None] + np.arange(3)

    def block(self, a: int, b: int) -> int:
        """Number of the block of two nodes; -1: they do not meet."""
        low, high = min(a, b), max(a, b)
        begin, end = np.searchsorted(self.first_node, [low, low + 1]).tolist()
        k = begin + int(np.searchsorted(self.second_node[begin:end], high))
        return k if k < end and self.second_node[k] == high else -1

    def blocks(self) -> tuple[Array, Array, Array]:
        """Nodes of the rows and of the columns of the blocks, and the first value of each."""
        return self.first_node, self.second_node, self.start[:-1]

    def block_start(self, k: int) -> int:
        """First value of a block."""
        return int(self.start[k])

    def _dense(self, values: Array) -> Array:
        """The symmetric matrix (N, N) whose blocks are given."""
        S = np.zeros(self.unknowns**2)
        S[self.place] = values
        S = np.triu(S.reshape(self.unknowns, self.unknowns))
        return S + np.triu(S, 1).T

    def _linearise(self, R: Array, C: Array, I: Array, X: Array, huber: float) -> _Linear:
        from scipy.sparse import csr_matrix

        m = len(self.image)
        state = State(R, C, I, X)
        v, D, P, flags = image_residuals(self.system, state, self.image, self.point, self.xy)
        v, D = np.einsum("nij,nj->ni", self.whiten, v), self.whiten @ D
        length = np.linalg.norm(v, axis=1)
        rho = 0.5 * length**2
        if huber > 0:
            large = length > huber
            weight = np.sqrt(np.where(large, huber / np.maximum(length, 1e-300), 1.0))
            rho = np.where(large, huber * (length - 0.5 * huber), rho)
            v, D = v * weight[:, None], D * weight[:, None, None]
        by_station, x = station_partials(R[self.image], P[:, None], D[:, :, :3])
        x = x * ~self.held[self.point, None]
        full = np.concatenate([by_station, D[:, :, 3:], x, np.zeros((m, 2, 1))], axis=2)
        J = np.take_along_axis(full, self.local[:, None], axis=2)
        rows = np.repeat(np.arange(2 * m), J.shape[2])
        A = csr_matrix((J.ravel(), (rows, np.repeat(self.columns, 2, axis=0).ravel())), shape=(2 * m, self.unknowns))
        return _Linear(v, J, A, x, rho, flags)

    def _points(
        self, C: Array, X: Array, linear: _Linear, v: Array, damping: float, *, root: bool = False
    ) -> tuple[Array, Array, Array]:
        """Inverse normal matrices (p, 3, 3) or their roots, right sides (p, 3), weak ones of the eliminated points."""
        p, e = len(X), np.arange(3)
        V, b = np.zeros((p, 3, 3)), np.zeros((p, 3))
        np.add.at(V, self.point, np.einsum("nki,nkj->nij", linear.x, linear.x))
        np.add.at(b, self.point, np.einsum("nki,nk->ni", linear.x, v))
        V[:, e, e] = np.where(self.held, 1.0, V[:, e, e] + self.weight)
        b = np.where(self.held, 0.0, b + self.weight * (X - self.value))
        if damping > 0:
            V = V + damping * self._point_damping(C, X, V)
        solved = self.eliminated & (np.diff(self.first) > 0)
        V[~solved], b[~solved] = np.eye(3), 0
        found, weak = roots_of_points(V)
        return found if root else np.swapaxes(found, 1, 2) @ found, b, np.flatnonzero(weak & solved)

    def _point_damping(self, C: Array, X: Array, V: Array) -> Array:
        """Along and across the ray of the point's first image: (p, 3, 3)."""
        seen = np.diff(self.first) > 0
        D = V * np.eye(3)
        mine = np.flatnonzero(seen & ~self.held.any(axis=1))
        u = X[mine] - C[self.image[self.first[mine]]]
        u = u / np.maximum(np.linalg.norm(u, axis=1), 1e-300)[:, None]
        along = np.einsum("pi,pij,pj->p", u, V[mine], u)
        across = 0.5 * (np.trace(V[mine], axis1=1, axis2=2) - along)
        D[mine] = (np.maximum(along, 0) - across)[:, None, None] * u[:, :, None] * u[:, None, :]
        D[mine] += across[:, None, None] * np.eye(3)
        return D

    def _couplings(self, linear: _Linear) -> Any:
        """W (N, 3 p) sparse: couplings of the nodes with the eliminated points."""
        from scipy.sparse import csr_matrix

        m, p = len(self.image), len(self.node)
        x = linear.x * self.eliminated[self.point, None, None]
        columns = np.broadcast_to(3 * self.point[:, None, None] + np.arange(3), (m, 2, 3))
        return linear.A.T @ csr_matrix(
            (x.ravel(), (np.repeat(np.arange(2 * m), 3), columns.ravel())), shape=(2 * m, 3 * p)
        )

    def _totals(self, linear: _Linear, X: Array) -> tuple[float, int, int]:
        """Half the weighted square sum, observations behind the sensor, observations without a projection."""
        prior = self.eliminated[:, None] * self.weight * (X - self.value) ** 2
        behind, lost = (int(np.count_nonzero(linear.flags & flag)) for flag in (BEHIND, LOST))
        return float(linear.rho.sum() + 0.5 * prior.sum()), behind, lost

    def reduce(
        self, R: Array, C: Array, I: Array, X: Array, huber: float, damping: float, threads: int, values: Array,
        right: Array, diagonal: Array,
    ) -> tuple[float, int, int, list[int]]:  # fmt: skip
        """Form the reduced normal equations; returns cost, behind, without projection, weak points."""
        del threads
        linear = self._linearise(R, C, I, X, huber)
        root, b, weak = self._points(C, X, linear, linear.v, damping, root=True)
        # W V^-1 W' by the root of V^-1: its rounding stays that of the matrix itself where V is nearly singular
        U = self._couplings(linear) @ _block_diagonal(np.swapaxes(root, 1, 2))
        S = (linear.A.T @ linear.A).toarray()
        diagonal[:] = np.diagonal(S)
        values[:] = (S - (U @ U.T).toarray()).ravel()[self.place]
        right[:] = U @ np.einsum("pij,pj->pi", root, b).ravel() - linear.A.T @ linear.v.ravel()
        return *self._totals(linear, X), [int(p) for p in weak]

    def back_substitute(
        self, R: Array, C: Array, I: Array, X: Array, huber: float, damping: float, threads: int, step: Array,
        points: Array,
    ) -> float:  # fmt: skip
        """Step of the points (p, 3) that belongs to a step of the nodes (N,); returns the linearised cost."""
        del threads
        linear = self._linearise(R, C, I, X, huber)
        v = linear.v + (linear.A @ step).reshape(-1, 2)
        inverse, b, _ = self._points(C, X, linear, v, damping)
        points[:] = -np.einsum("pij,pj->pi", inverse, b)
        v = v + np.einsum("nki,ni->nk", linear.x, points[self.point] * self.eliminated[self.point, None])
        prior = self.eliminated[:, None] * self.weight * (X + points - self.value) ** 2
        kept = np.flatnonzero(~self.eliminated)
        points[kept] = step[self._retained(kept)]
        return 0.5 * float(np.sum(v * v) + prior.sum())

    def evaluate(
        self, R: Array, C: Array, I: Array, X: Array, huber: float, threads: int, residuals: Array, behind: Array
    ) -> tuple[float, int, int]:
        """Cost, behind, without projection; whitened residuals and flags where arrays are given for them."""
        del threads
        linear = self._linearise(R, C, I, X, huber)
        if residuals.size:
            residuals[:] = linear.v
        if behind.size:
            behind[:] = linear.flags
        return self._totals(linear, X)

    def factorise(self, values: Array, added: Array) -> int:
        """Cholesky factor of the matrix scaled to a unit diagonal; 0, or 1 + the unknown at which it stops.

        Unknowns stand in the system's order here and are reordered in the compiled factor, so the two may stop at
        different unknowns and their smallest pivots differ.
        """
        from scipy.linalg import get_lapack_funcs

        self.factorised = False
        S = self._dense(values)
        if added.size:
            S[np.diag_indices_from(S)] += added
        d = np.diagonal(S)
        if not (d > 0).all():
            return int(np.flatnonzero(~(d > 0))[0]) + 1
        self.scale = 1 / np.sqrt(d)
        potrf: Any = get_lapack_funcs(("potrf",), (S,))[0]
        self.L, info = potrf(S * np.outer(self.scale, self.scale), lower=1, clean=1)
        if info:
            return int(info)
        pivots = np.diagonal(self.L) ** 2
        if not np.isfinite(pivots).all():
            return int(np.flatnonzero(~np.isfinite(pivots))[0]) + 1
        self.factorised = True
        self.own_pivots = pivots / self.scale**2
        self.smallest_pivot_at = int(pivots.argmin()) if len(pivots) else -1
        self.smallest_pivot = float(pivots.min(initial=1.0))
        return 0

    def pivots(self, out: Array) -> None:
        """Pivots (N,) of the matrix itself, in the order of the unknowns."""
        self._check_factor()
        out[:] = self.own_pivots

    def _check_factor(self) -> None:
        if not self.factorised:
            raise ValueError("the matrix is not factorised: call factorise first, and solve only where it returns 0")

    def solve(self, x: Array, columns: int) -> None:
        """Solve in place for right sides (N, columns)."""
        from scipy.linalg import cho_solve

        self._check_factor()
        if not self.unknowns:  # SciPy before 1.14 refuses matrices without rows
            return
        right = x.reshape(self.unknowns, columns) * self.scale[:, None]
        x[...] = (cho_solve((self.L, True), right) * self.scale[:, None]).reshape(x.shape)

    def selected_inverse(self, values: Array) -> None:
        """The inverse, in the layout of the matrix."""
        inverse = np.eye(self.unknowns)
        self.solve(inverse, self.unknowns)
        values[:] = ((inverse + inverse.T) / 2).ravel()[self.place]

    def condense(self, R: Array, C: Array, I: Array, X: Array, threads: int, given: Array, columns: int) -> Array:
        """Reduced right sides (N, columns) of right sides (p, 3, columns) for the points."""
        del threads
        linear = self._linearise(R, C, I, X, 0.0)
        inverse, _, _ = self._points(C, X, linear, linear.v, 0.0)
        mine = given * self.eliminated[:, None, None]
        right = np.asarray(-(self._couplings(linear) @ (inverse @ mine).reshape(-1, columns)))
        kept = np.flatnonzero(~self.eliminated)
        right[self._retained(kept).ravel()] += given[kept].reshape(-1, columns)
        return right

    def expand(
        self, R: Array, C: Array, I: Array, X: Array, threads: int, nodes: Array, given: Array, columns: int
    ) -> Array:
        """Points (p, 3, columns) that belong to solutions (N, columns) for the nodes."""
        del threads
        linear = self._linearise(R, C, I, X, 0.0)
        inverse, _, _ = self._points(C, X, linear, linear.v, 0.0)
        right = -(self._couplings(linear).T @ nodes).reshape(-1, 3, columns)
        points = inverse @ (right + given if given.size else right) * ~self.held[:, :, None]
        kept = np.flatnonzero(~self.eliminated)
        points[kept] = nodes[self._retained(kept)]
        return points

    def statistics(
        self, R: Array, C: Array, I: Array, X: Array, threads: int, inverse: Array, datum: int, gauge_nodes: Array,
        gauge_given: Array, gauge_points: Array, gauge_middle: Array,
    ) -> tuple[Array, Array, Array, Array]:  # fmt: skip
        """Point cofactors (p, 3, 3), A Q A' (m: 00, 11, 01), effects of unit blunders (m, 3, 2) and H (p, 3, d).

        inverse   (values,) of the reduced normal matrix
        gauge_..  of the S-transformation by `datum` columns: H = Q B G for the nodes (N, d), B G and G for the
                  points (p, 3, d), and the middle (d, d); nothing is transformed where datum is 0
        returns   the effects are those on the observation's own point; H = Q B G for the points
        """
        del threads
        linear = self._linearise(R, C, I, X, 0.0)
        Vi, _, _ = self._points(C, X, linear, linear.v, 0.0)
        Z, Y = self._dense(inverse), (self._couplings(linear) @ _block_diagonal(Vi)).tocsc()
        p, m = len(X), len(self.image)
        cofactor, hat, effect = np.zeros((p, 3, 3)), np.zeros((m, 3)), np.zeros((m, 3, 2))
        for begin in range(0, p, _CHUNK):
            mine = np.arange(begin, min(begin + _CHUNK, p))
            y = Y[:, 3 * mine[0] : 3 * mine[-1] + 3].toarray()
            T = Z @ y  # minus the cofactors between nodes and points
            Q = Vi[mine] + np.einsum("npi,npj->pij", *(a.reshape(-1, len(mine), 3) for a in (y, T)))
            kept = np.flatnonzero(~self.eliminated[mine])
            at = self._retained(mine[kept])
            Q[kept] = Z[at[:, :, None], at[:, None]]
            cofactor[mine] = Q * ~self.held[mine, :, None] * ~self.held[mine, None]
            rows = slice(self.first[mine[0]], self.first[mine[-1] + 1])
            local = self.point[rows] - begin
            hat[rows], effect[rows] = self._redundancy(linear, rows, Z, T, cofactor[self.point[rows]], local)
        if not datum:
            return cofactor, hat, effect, np.zeros((p, 3, 0))
        point_h = self.expand(R, C, I, X, 1, gauge_nodes, gauge_given * ~self.held[:, :, None], datum)
        point_h[self.held] = 0
        u = np.einsum("mrk,mkd->mrd", linear.J, gauge_nodes[self.columns])
        u += linear.x @ (point_h[self.point] * self.eliminated[self.point, None, None])
        effect -= gauge_points[self.point] @ gauge_middle @ np.swapaxes(u, 1, 2)
        return cofactor, hat, effect, point_h

    def _redundancy(
        self, linear: _Linear, rows: slice, Z: Array, T: Array, Q: Array, local: Array
    ) -> tuple[Array, Array]:
        """A Q A' (n, 3) and the effect on the point (n, 3, 2) of consecutive observations.

        Z (N, N) inverse, T (N, 3 c) minus the cofactors of nodes and points, Q (n, 3, 3) of each observation's
        point, local (n,) its position among the c points.
        """
        J, columns = linear.J[rows], self.columns[rows]
        kept = ~self.eliminated[self.point[rows]]
        x = linear.x[rows] * ~kept[:, None, None]
        nodes_points = -T.reshape(len(T), T.shape[1] // 3, 3)[columns, local[:, None]]
        to_nodes = Z[columns[:, :, None], columns[:, None]] @ np.swapaxes(J, 1, 2) + nodes_points @ np.swapaxes(x, 1, 2)
        to_point = Q @ np.swapaxes(x, 1, 2) + np.swapaxes(J @ nodes_points, 1, 2)
        H = J @ to_nodes + x @ to_point
        hat = np.stack([H[:, 0, 0], H[:, 1, 1], (H[:, 0, 1] + H[:, 1, 0]) / 2], axis=1)
        if kept.any():
            to_point[kept] = to_nodes[kept, -3:]
        return hat, to_point


def roots_of_points(V: Array) -> tuple[Array, Mask]:
    """Inverse Cholesky factors T (p, 3, 3), V^-1 = T' T, of normal matrices, and which of them are singular (p,).

    A vanishing pivot gives way to the diagonal itself, so that a point without depth stays where it is.
    """
    L, weak = np.zeros_like(V), np.zeros(len(V), bool)
    for i in range(3):
        for j in range(i):
            L[:, i, j] = (V[:, i, j] - np.einsum("pk,pk->p", L[:, i, :j], L[:, j, :j])) / L[:, j, j]
        whole = V[:, i, i]
        pivot = whole - np.einsum("pk,pk->p", L[:, i, :i], L[:, i, :i])
        fine = (pivot > SINGULAR * whole) & (pivot > 0)
        weak |= ~fine
        L[:, i, i] = np.sqrt(np.where(fine, pivot, np.where(whole > 0, whole, 1.0)))
    return np.linalg.inv(L), weak


def _block_diagonal(blocks: Array) -> Any:
    """Sparse block diagonal matrix (3 p, 3 p) of blocks (p, 3, 3)."""
    from scipy.sparse import bsr_matrix

    p = len(blocks)
    return bsr_matrix((blocks, np.arange(p), np.arange(p + 1)), shape=(3 * p, 3 * p)).tocsr()
