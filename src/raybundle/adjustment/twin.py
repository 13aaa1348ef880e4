"""The NumPy twin of the compiled kernels: the same interface and the same numbers, slower.

It works where no compiler was there, and a test holds the kernels against it.  The reduced normal
matrix is dense here, so blocks of more than a few hundred images take their time.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.assemble import State, System
from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.sensors import SensorModel, sensor_models

SINGULAR = 1e-13
"""Pivot of a point's normal matrix, relative to its diagonal, below which the point counts as undetermined."""


def residuals_and_partials(
    model: SensorModel, xy: Array, points: Array, values: Array, *, corrected: bool
) -> tuple[Array, Array, Mask]:
    """V (n, 2) [mm], d v / d (point, parameters) (n, 2, 3 + k), and which observations have no projection (n,).

    xy (n, 2) measured, points (3, n) in the sensor frame, values (k, n)
    measured: v = projection - measured, D = -B^-1 dg at the projection; corrected: v = -g, D = -dg at the measured
    point.  Without a projection the corrected form stands in, as in the compiled kernels.
    """
    measured = xy.T
    g, J = model.condition_and_jacobian(*measured, *points, *values)
    v, D = -g, -J[:, 2:]
    lost = np.zeros(len(xy), bool)
    if not corrected:
        image = measured.copy()
        with np.errstate(all="ignore"):
            for _ in range(25):
                g, J = model.condition_and_jacobian(*image, *points, *values)
                det = J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0]
                dx = (J[1, 1] * g[0] - J[0, 1] * g[1]) / det
                dy = (J[0, 0] * g[1] - J[1, 0] * g[0]) / det
                size, scale = np.abs(dx) + np.abs(dy), np.abs(image).sum(axis=0) + 1
                lost |= ~(size < 1e3 * scale) | ~(det > 0)
                image = image - np.where(lost, 0.0, np.stack([dx, dy]))
                image[:, lost] = measured[:, lost]
                worst = np.max(np.where(lost, 0.0, size / scale), initial=0.0)
                if worst < 1e-14:
                    break
        _, J = model.condition_and_jacobian(*image, *points, *values)
        det = J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0]
        inverse = np.array([[J[1, 1], -J[0, 1]], [-J[1, 0], J[0, 0]]]) / det
        found = -np.einsum("abn,bcn->acn", inverse, J[:, 2:])
        v = np.where(lost, v, image - measured)
        D = np.where(lost, D, found)
    return np.ascontiguousarray(v.T), np.ascontiguousarray(np.moveaxis(D, 2, 0)), lost


def sensor_points(system: System, state: State, rows: Array) -> tuple[Array, Array, Array]:
    """Positions of image and point of used observations, and the points (3, n) in their sensor's frame."""
    o = system.block.observations
    image, point = o.image[system.rows[rows]], o.point[system.rows[rows]]
    P = np.einsum("nij,nj->in", state.rotation[image], state.xyz[point] - state.centre[image])
    return image, point, P


def external_rows(system: System, state: State, mask: Mask) -> Array:
    """Rows (k, 8 + 2 stride) for the observations in `mask`: v, d v / d point (2, 3), d v / d interior (2, stride)."""
    chosen = np.flatnonzero(mask)
    table = np.zeros((len(chosen), 8 + 2 * system.stride))
    image, _, P = sensor_points(system, state, chosen)
    row = system.interior_of_image[image]
    for r in np.unique(row):
        mine = np.flatnonzero(row == r)
        model = system.interior[r].model
        k = len(model.symbols)
        values = np.repeat(state.interior[r, :k, None], len(mine), axis=1)
        corrected = bool(system.corrected[system.interior[r].camera])
        v, D, _ = residuals_and_partials(model, system.xy_mm[chosen[mine]], P[:, mine], values, corrected=corrected)
        table[mine, :2] = v
        table[mine, 2:8] = D[:, :, :3].reshape(-1, 6)
        table[mine, 8 : 8 + k] = D[:, 0, 3:]
        table[mine, 8 + system.stride : 8 + system.stride + k] = D[:, 1, 3:]
    return table


@dataclass(slots=True)
class _Linear:
    """Linearised, whitened observations in the order of `System.rows`."""

    v: Array
    """(m, 2)"""
    nodes: Array
    """(2 m, N) sparse"""
    x: Array
    """(m, 2, 3)"""
    rho: Array
    behind: Mask
    lost: Mask


class Solver:
    """Reduced normal equations of one system, as `raybundle._native.Solver`."""

    def __init__(self, block: Block, system: System) -> None:
        """Keep the system; the `set_...` calls hand over the same arrays as to the compiled solver."""
        self.block_data, self.system = block, system
        self.smallest_pivot, self.smallest_pivot_at = 1.0, -1

    def set_observations(self, image: Index, point: Index, xy: Array, whiten: Array, external_row: Index) -> None:
        """Observations, sorted by point."""
        del external_row
        self.image, self.point, self.xy = image, point, xy
        self.W = np.zeros((len(image), 2, 2))
        self.W[:, 0, 0], self.W[:, 1, 0], self.W[:, 1, 1] = whiten.T

    def set_images(
        self, model: Index, corrected: Index, interior: Index, pattern: Index, own: Index, shared: Index,
        parameters: Index, stride: int,
    ) -> None:  # fmt: skip
        """Images: residual form, interior orientation, free columns and their nodes."""
        del model, parameters
        self.corrected, self.interior, self.pattern = corrected, interior, pattern
        self.own, self.shared, self.stride = own, shared, stride

    def set_patterns(self, patterns: list[tuple[list[int], list[int]]]) -> None:
        """Lists of free local columns of the own and the shared node."""
        self.patterns = patterns

    def set_points(self, first: Array, node: Index, held: Array, weight: Array, value: Array) -> None:
        """Object points: node of retained ones, held coordinates, observed coordinates."""
        del first
        self.node, self.weight, self.value = node, weight, value
        self.set_held(held)

    def set_held(self, held: Array) -> None:
        """Held coordinates as bits."""
        self.held = (held[:, None] & np.array([1, 2, 4], np.uint8)) > 0

    def set_nodes(self, sizes: Array, extra: list[tuple[int, int]]) -> None:
        """Nodes; every pair has a block here."""
        del extra
        self.sizes = np.asarray(sizes, np.int64)
        self.offsets = np.concatenate([[0], np.cumsum(self.sizes)])
        self.unknowns = int(self.offsets[-1])
        n = len(self.sizes)
        upper = np.triu(np.outer(self.sizes, self.sizes)).ravel()
        self.start = np.concatenate([[0], np.cumsum(upper)])
        self.values_size = int(self.start[-1])
        self.factor_entries = self.unknowns * (self.unknowns + 1) // 2
        self.factor_operations = self.unknowns**3 / 3
        del n

    def set_external(self, rows: Array) -> None:
        """Nothing to do: every model is evaluated here."""

    def block(self, a: int, b: int) -> int:
        """Number of the block of two nodes."""
        return min(a, b) * len(self.sizes) + max(a, b)

    def block_start(self, k: int) -> int:
        """First value of a block."""
        return int(self.start[k])

    def _to_blocks(self, dense: Array, values: Array) -> None:
        for a in range(len(self.sizes)):
            for b in range(a, len(self.sizes)):
                k = self.start[self.block(a, b)]
                part = dense[self.offsets[a] : self.offsets[a + 1], self.offsets[b] : self.offsets[b + 1]]
                values[k : k + part.size] = part.ravel()

    def _to_dense(self, values: Array) -> Array:
        dense = np.zeros((self.unknowns, self.unknowns))
        for a in range(len(self.sizes)):
            for b in range(a, len(self.sizes)):
                k, size = self.start[self.block(a, b)], self.sizes[a] * self.sizes[b]
                part = values[k : k + size].reshape(self.sizes[a], self.sizes[b])
                dense[self.offsets[a] : self.offsets[a + 1], self.offsets[b] : self.offsets[b + 1]] = part
                dense[self.offsets[b] : self.offsets[b + 1], self.offsets[a] : self.offsets[a + 1]] = part.T
        return dense

    def _linearise(self, R: Array, C: Array, I: Array, X: Array, huber: float) -> _Linear:
        from scipy.sparse import csr_matrix  # noqa: PLC0415

        m = len(self.image)
        v, full = np.zeros((m, 2)), np.zeros((m, 2, 6 + self.stride))
        x, behind, lost = np.zeros((m, 2, 3)), np.zeros(m, bool), np.zeros(m, bool)
        P = np.einsum("nij,nj->in", R[self.image], X[self.point] - C[self.image])
        models = [row.model for row in self.system.interior]
        kinds = [(models[i].name, int(c)) for i, c in zip(self.interior, self.corrected, strict=True)]
        names = sorted(set(kinds))
        kind = np.array([names.index(k) for k in kinds])[self.image]
        for code, (name, corrected) in enumerate(names):
            mine = np.flatnonzero(kind == code)
            if not len(mine):
                continue
            model = (
                models[int(self.interior[self.image[mine[0]]])] if name not in sensor_models else sensor_models[name]
            )
            k = len(model.symbols)
            values = I[self.interior[self.image[mine]], :k].T
            v[mine], D, lost[mine] = residuals_and_partials(
                model, self.xy[mine], P[:, mine], values, corrected=bool(corrected)
            )
            D = self.W[mine] @ D
            x[mine] = D[:, :, :3] @ R[self.image[mine]]
            full[mine, :, :3] = -x[mine]
            full[mine, :, 3:6] = np.cross(P.T[mine][:, None], D[:, :, :3])
            full[mine, :, 6 : 6 + k] = D[:, :, 3:]
            if type(model).in_front is SensorModel.in_front:
                behind[mine] = ~(P[2, mine] < 0)
        v = np.einsum("nij,nj->ni", self.W, v)
        length = np.linalg.norm(v, axis=1)
        rho = 0.5 * length**2
        if huber > 0:
            large = length > huber
            weight = np.sqrt(np.where(large, huber / np.maximum(length, 1e-300), 1.0))
            rho = np.where(large, huber * (length - 0.5 * huber), rho)
            v, x, full = v * weight[:, None], x * weight[:, None, None], full * weight[:, None, None]
        x = x * ~self.held[self.point][:, None]
        rows, columns, entries = [], [], []
        for code, (own, shared) in enumerate(self.patterns):
            mine = np.flatnonzero(self.pattern[self.image] == code)
            for local, node in ((own, self.own), (shared, self.shared)):
                if not local or not len(mine):
                    continue
                at = self.offsets[node[self.image[mine]]][:, None] + np.arange(len(local))
                for axis in range(2):
                    rows.append(np.repeat(2 * mine + axis, len(local)))
                    columns.append(at.ravel())
                    entries.append(full[mine, axis][:, local].ravel())
        kept = np.flatnonzero(self.node[self.point] >= 0)
        for axis in range(2):
            rows.append(np.repeat(2 * kept + axis, 3))
            columns.append((self.offsets[self.node[self.point[kept]]][:, None] + np.arange(3)).ravel())
            entries.append(x[kept, axis].ravel())
        A = csr_matrix(
            (np.concatenate(entries), (np.concatenate(rows), np.concatenate(columns))), shape=(2 * m, self.unknowns)
        )
        return _Linear(v, A, x, rho, behind, lost)

    def _points(self, s: tuple[Array, ...], linear: _Linear, v: Array, damping: float) -> tuple[Array, Array, Array]:
        """Inverse normal matrices (p, 3, 3), right sides (p, 3) and weak points of the eliminated points."""
        _, C, _, X = s
        p = len(X)
        V, b = np.zeros((p, 3, 3)), np.zeros((p, 3))
        np.add.at(V, self.point, np.einsum("nki,nkj->nij", linear.x, linear.x))
        np.add.at(b, self.point, np.einsum("nki,nk->ni", linear.x, v))
        e = np.arange(3)
        V[:, e, e] += self.weight
        b += self.weight * (X - self.value)
        used = np.bincount(self.point, minlength=p) > 0
        eliminated = used & (self.node < 0)
        V[:, e, e] = np.where(self.held, 1.0, V[:, e, e])
        b = np.where(self.held, 0.0, b)
        if damping > 0:
            first = np.full(p, -1)
            first[self.point[::-1]] = self.image[::-1]
            u = X - C[np.maximum(first, 0)]
            u = u / np.maximum(np.linalg.norm(u, axis=1), 1e-300)[:, None]
            along = np.einsum("pi,pij,pj->p", u, V, u)
            across = 0.5 * (np.trace(V, axis1=1, axis2=2) - along)
            D = (np.maximum(along, 0) - across)[:, None, None] * u[:, :, None] * u[:, None, :]
            D = D + across[:, None, None] * np.eye(3)
            plain = self.held.any(axis=1)
            D[plain] = V[plain] * np.eye(3)
            V = V + damping * D
        V[~eliminated], b[~eliminated] = np.eye(3), 0
        scale = 1 / np.sqrt(np.maximum(V[:, e, e], 1e-300))
        smallest = np.linalg.eigvalsh(V * scale[:, :, None] * scale[:, None, :])[:, 0]
        weak = eliminated & ~(smallest > SINGULAR)
        V[weak] += np.maximum(np.trace(V[weak], axis1=1, axis2=2), 1e-300)[:, None, None] * 1e-12 * np.eye(3)
        return np.linalg.inv(V), b, np.flatnonzero(weak)

    def _couplings(self, linear: _Linear) -> Array:
        """W (N, 3 p) sparse: couplings of nodes with eliminated points."""
        from scipy.sparse import csr_matrix  # noqa: PLC0415

        m, p = len(self.image), len(self.node)
        x = linear.x * (self.node[self.point] < 0)[:, None, None]
        rows = np.repeat(np.arange(2 * m), 3)
        columns = (3 * self.point[:, None, None] + np.arange(3) + np.zeros((1, 2, 1), int)).ravel()
        return linear.nodes.T @ csr_matrix((x.ravel(), (rows, columns)), shape=(2 * m, 3 * p))

    def reduce(
        self, R: Array, C: Array, I: Array, X: Array, huber: float, damping: float, threads: int, values: Array,
        right: Array, diagonal: Array,
    ) -> tuple[float, int, int, list[int]]:  # fmt: skip
        """Form the reduced normal matrix; returns cost, behind, without projection, weak points."""
        del threads
        linear = self._linearise(R, C, I, X, huber)
        inverse, b, weak = self._points((R, C, I, X), linear, linear.v, damping)
        W = self._couplings(linear)
        S = (linear.nodes.T @ linear.nodes).toarray()
        diagonal[:] = np.diagonal(S)
        Y = W @ _block_diagonal(inverse)
        self._to_blocks(S - (Y @ W.T).toarray(), values)
        right[:] = -(linear.nodes.T @ linear.v.ravel()) + Y @ b.ravel()
        return self._cost(linear, X), int(linear.behind.sum()), int(linear.lost.sum()), [int(p) for p in weak]

    def _cost(self, linear: _Linear, X: Array) -> float:
        mine = (self.node < 0)[:, None]
        return float(linear.rho.sum() + 0.5 * np.sum(mine * self.weight * (X - self.value) ** 2))

    def back_substitute(
        self, R: Array, C: Array, I: Array, X: Array, huber: float, damping: float, threads: int, step: Array,
        points: Array,
    ) -> float:  # fmt: skip
        """Step of the points; returns the linearised cost."""
        del threads
        linear = self._linearise(R, C, I, X, huber)
        v = linear.v + (linear.nodes @ step).reshape(-1, 2)
        inverse, b, _ = self._points((R, C, I, X), linear, v, damping)
        points[:] = -np.einsum("pij,pj->pi", inverse, b)
        kept = np.flatnonzero(self.node >= 0)
        points[kept] = 0
        v = v + np.einsum("nki,ni->nk", linear.x, points[self.point])
        mine = (self.node < 0)[:, None]
        cost = 0.5 * float(np.sum(v * v)) + 0.5 * float(np.sum(mine * self.weight * (X + points - self.value) ** 2))
        points[kept] = step[self.offsets[self.node[kept]][:, None] + np.arange(3)]
        return cost

    def evaluate(
        self, R: Array, C: Array, I: Array, X: Array, huber: float, threads: int, residuals: Array, behind: Array
    ) -> tuple[float, int, int]:
        """Cost; whitened residuals and flags where arrays are given for them."""
        del threads
        linear = self._linearise(R, C, I, X, huber)
        if residuals.size:
            residuals[:] = linear.v
        if behind.size:
            behind[:] = linear.behind + 2 * linear.lost
        return self._cost(linear, X), int(linear.behind.sum()), int(linear.lost.sum())

    def factorise(self, values: Array, added: Array) -> int:
        """Cholesky factor of the scaled matrix; 0, or 1 + the unknown at which it stops."""
        from scipy.linalg.lapack import dpotrf  # noqa: PLC0415

        S = self._to_dense(values)
        if added.size:
            S[np.diag_indices_from(S)] += added
        d = np.diagonal(S)
        if not (d > 0).all():
            return int(np.flatnonzero(~(d > 0))[0]) + 1
        self.scale = 1 / np.sqrt(d)
        L, info = dpotrf(S * np.outer(self.scale, self.scale), lower=1)
        if info:
            return int(info)
        self.L = np.tril(L)
        pivots = np.diagonal(self.L) ** 2
        self.smallest_pivot_at = int(pivots.argmin()) if len(pivots) else -1
        self.smallest_pivot = float(pivots.min(initial=1.0))
        return 0

    def solve(self, x: Array, columns: int) -> None:
        """Solve in place for right sides (N, columns)."""
        from scipy.linalg import cho_solve  # noqa: PLC0415

        right = x.reshape(self.unknowns, columns) * self.scale[:, None]
        x[...] = (cho_solve((self.L, True), right) * self.scale[:, None]).reshape(x.shape)

    def selected_inverse(self, values: Array) -> None:
        """The inverse, in the layout of the matrix."""
        inverse = np.eye(self.unknowns)
        self.solve(inverse, self.unknowns)
        self._to_blocks((inverse + inverse.T) / 2, values)

    def condense(self, R: Array, C: Array, I: Array, X: Array, threads: int, given: Array, columns: int) -> Array:
        """Reduced right sides (N, columns) of right sides (p, 3, columns) for the points."""
        del threads
        linear = self._linearise(R, C, I, X, 0.0)
        inverse, _, _ = self._points((R, C, I, X), linear, linear.v, 0.0)
        mine = (self.node < 0)[:, None, None]
        right = -(self._couplings(linear) @ (inverse @ (given * mine)).reshape(-1, columns))
        kept = np.flatnonzero(self.node >= 0)
        right[(self.offsets[self.node[kept]][:, None] + np.arange(3)).ravel()] += given[kept].reshape(-1, columns)
        return right

    def expand(
        self, R: Array, C: Array, I: Array, X: Array, threads: int, nodes: Array, given: Array, columns: int
    ) -> Array:
        """Points (p, 3, columns) that belong to solutions (N, columns) for the nodes."""
        del threads
        linear = self._linearise(R, C, I, X, 0.0)
        inverse, _, _ = self._points((R, C, I, X), linear, linear.v, 0.0)
        right = -(self._couplings(linear).T @ nodes).reshape(-1, 3, columns)
        if given.size:
            right = right + given
        points = inverse @ (right * ~self.held[:, :, None])
        kept = np.flatnonzero(self.node >= 0)
        points[kept] = nodes[self.offsets[self.node[kept]][:, None] + np.arange(3)]
        points[(np.bincount(self.point, minlength=len(X)) == 0) & (self.node < 0)] = 0
        return points

    def statistics(
        self, R: Array, C: Array, I: Array, X: Array, threads: int, inverse: Array, datum: int, gauge_nodes: Array,
        gauge_points: Array, gauge_middle: Array, point_gauge: Array,
    ) -> tuple[Array, Array, Array]:  # fmt: skip
        """Point cofactors (p, 3, 3), diagonal blocks of A Q A' (m, 3) and effects of unit blunders (m, 3, 2)."""
        del threads
        linear = self._linearise(R, C, I, X, 0.0)
        Vi, _, _ = self._points((R, C, I, X), linear, linear.v, 0.0)
        Z = self._to_dense(inverse)
        Y = np.asarray((self._couplings(linear) @ _block_diagonal(Vi)).toarray())
        T = Z @ Y
        p, m = len(X), len(self.image)
        cofactor = np.zeros((p, 3, 3))
        for k in range(p):
            at = slice(3 * k, 3 * k + 3)
            cofactor[k] = Vi[k] + Y[:, at].T @ T[:, at]
            if self.node[k] >= 0:
                o = self.offsets[self.node[k]]
                cofactor[k] = Z[o : o + 3, o : o + 3]
        cofactor *= ~self.held[:, :, None] * ~self.held[:, None, :]
        A = linear.nodes
        x = linear.x * (self.node[self.point] < 0)[:, None, None]
        QA = Z @ A.T.toarray()  # (N, 2 m)
        hat, effect = np.zeros((m, 3)), np.zeros((m, 3, 2))
        dense = A.toarray().reshape(m, 2, -1)
        for i in range(m):
            at = slice(3 * self.point[i], 3 * self.point[i] + 3)
            CP = -T[:, at]  # cov(nodes, point)
            Qx = cofactor[self.point[i]] @ x[i].T + CP.T @ dense[i].T
            Qn = QA[:, 2 * i : 2 * i + 2] + CP @ x[i].T
            H = dense[i] @ Qn + x[i] @ Qx
            hat[i] = H[0, 0], H[1, 1], (H[0, 1] + H[1, 0]) / 2
            if self.node[self.point[i]] >= 0:
                o = self.offsets[self.node[self.point[i]]]
                Qx = Qn[o : o + 3]
            effect[i] = Qx
            if datum:
                u = dense[i] @ gauge_nodes + x[i] @ gauge_points[self.point[i]]
                effect[i] -= point_gauge[self.point[i]] @ gauge_middle @ u.T
        return cofactor, hat, effect


def _block_diagonal(blocks: Array) -> Array:
    """Sparse block diagonal matrix (3 p, 3 p) of blocks (p, 3, 3)."""
    from scipy.sparse import bsr_matrix  # noqa: PLC0415

    p = len(blocks)
    return bsr_matrix((blocks, np.arange(p), np.arange(p + 1)), shape=(3 * p, 3 * p)).tocsr()
