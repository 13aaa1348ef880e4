"""The joint cofactor matrix of chosen object points and all shared interior orientations, from a finished factor.

What the selected inverse does not hold: points that no image shows together, points with the interior orientation.
With V_p the normal matrix of a point by its own rays and W_p how it meets the nodes,

    Q_pq = delta_pq V_p^-1 + F_p Q_nn F_q',    F_p = -V_p^-1 W_p',

so that one solution of the nodes for each chosen coordinate is all that is needed (Brown 1958; Triggs et al. 2000,
section 6).  Then the S-transformation (Baarda 1973) to the datum of the result.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.precision import Cofactors, cofactors
from raybundle.adjustment.system import defects
from raybundle.adjustment.system.assemble import State, System, assemble
from raybundle.adjustment.system.datum import Datum, analyse, hold_minimal
from raybundle.adjustment.system.external import external_rows
from raybundle.adjustment.system.images_numpy import image_residuals
from raybundle.adjustment.system.normals import Normals, point_prior
from raybundle.block import Block
from raybundle.block.rejection import Rejections
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.platforms.station import sensor_from_object

TOGETHER = 512
"""Right sides that are solved at once."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Factored:
    """Normal equations with their undamped factor at the values of the block, and its cofactors for white noise."""

    normals: Normals
    state: State
    datum: Datum
    found: Cofactors

    @property
    def system(self) -> System:
        """Which unknowns there are."""
        return self.normals.system

    @classmethod
    def of(cls, result: Adjustment) -> Factored:
        """Of a finished adjustment; raises InputError for one without statistics, or a copy."""
        work = result.handle.work
        if work is None or work.found is None:
            raise InputError("adjustment.no_statistics")
        return cls(normals=work.normals, state=work.state, datum=work.datum, found=work.found)

    @classmethod
    def at(
        cls, block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], rejected: Rejections,
        like: Factored | None = None,
    ) -> Factored:  # fmt: skip
        """Of a block as it stands, nothing being adjusted: what its observations promise at these values.

        like    of a block with the same points: coordinates that a minimal datum holds, and what carries the datum
        raises  InputError, DatumDefect, RankDefect
        """
        mask = np.array([bool(r) for r in rejected], bool)
        defects.check_images(block, mask, free)
        system = assemble(block, options, mask, free)
        state = system.initial_state()
        datum = analyse(system, state, options)
        normals = Normals.of(system, options.jobs)
        if like is not None and like.datum.defect == datum.defect:
            datum = replace(like.datum, centre=like.datum.centre + like.system.shift - system.shift)
            normals.hold(like.system.held.copy())
        else:
            normals.hold(system.control_held | hold_minimal(system, state, datum))
        weak = normals.reduce(state)[2]
        failed = normals.factorise()
        share, at = (0.0, failed - 1) if failed or weak else normals.least_share()
        if share < defects.SHARE:
            raise defects.explain(normals, state, weak, at)
        return cls(normals=normals, state=state, datum=datum, found=cofactors(normals, state, datum))


@dataclass(frozen=True, slots=True, kw_only=True)
class JointCofactors:
    """Cofactors, sigma0 apart, of all coordinates of chosen points and of all shared interior orientations."""

    points: Index
    """(t,) chosen object points, ascending; their coordinates come first, X Y Z of one after the other"""
    columns: Index
    """(N,) place of each unknown of the nodes behind them; -1 of those that are none of an interior orientation"""
    matrix: Array
    """(n, n), datum of the result"""

    def place(self, points: Index) -> Index:
        """(k,) places among the chosen points; -1 of others."""
        at = np.searchsorted(self.points, points)
        at = np.minimum(at, len(self.points) - 1)
        return np.where(self.points[at] == points, at, -1)

    def of_unknowns(self, unknowns: Index) -> Array:
        """Cofactor (u, u) of unknowns of interior orientations."""
        at = self.columns[unknowns]
        return self.matrix[np.ix_(at, at)]

    def variances(self) -> Array:
        """(t, 3) of the coordinates."""
        return np.diagonal(self.matrix)[: 3 * len(self.points)].reshape(-1, 3)


def joint_cofactors(factored: Factored, points: Index) -> JointCofactors:
    """The joint cofactor matrix of chosen object points, ascending, and all interior orientations that images share.

    Its size is (3 t + u)^2: a thousand points take 72 MB and the solution of three thousand right sides.
    """
    system, normals = factored.system, factored.normals
    rows = [r for r in system.interior if r.node >= 0 and r.image < 0 and r.camera >= 0]
    shared = np.array([system.offsets[r.node] + r.start + k for r in rows for k in range(len(r.free))], np.int64)
    own, F = conditionals(factored, points)
    t, N = len(points), int(system.offsets[-1])
    F = _with_selected(F, shared, N)
    dense, n = F.toarray(), F.shape[0]
    Q = np.empty((n, n))
    for first in range(0, n, TOGETHER):
        part = slice(first, first + TOGETHER)
        Q[:, part] = F @ normals.solved(np.ascontiguousarray(dense[part].T))
    at = 3 * np.arange(t)[:, None, None]
    Q[at + np.arange(3)[:, None], at + np.arange(3)] += own
    Q = _in_datum(factored, (Q + Q.T) / 2, points, shared)
    columns = np.full(N, -1)
    columns[shared] = 3 * t + np.arange(len(shared))
    return JointCofactors(points=points, columns=columns, matrix=Q)


def _with_selected(F: Any, unknowns: Index, N: int) -> Any:
    from scipy.sparse import csr_matrix, vstack

    k = len(unknowns)
    chosen = csr_matrix((np.ones(k), (np.arange(k), unknowns)), shape=(k, N))
    return vstack([F, chosen]).tocsr()


def _in_datum(factored: Factored, Q: Array, points: Index, shared: Index) -> Array:
    """From the minimal datum of the factor to that of the result: Q - G M H' - H M' G' + G M K M' G'."""
    t = factored.found.transformation
    if t is None:
        return Q
    d = len(t.middle)
    G = np.vstack([t.points[points].reshape(-1, d), t.nodes[shared]])
    H = np.vstack([t.points_h[points].reshape(-1, d), t.nodes_h[shared]])
    half = H @ t.middle.T - G @ (t.middle @ t.inner @ t.middle.T) / 2
    change = G @ half.T
    return Q - change - change.T


def conditionals(factored: Factored, points: Index) -> tuple[Array, Any]:
    """What points have for themselves and how they follow the nodes: V^-1 (t, 3, 3) and F (3 t, N), sparse.

    Of a point that has a node of its own V^-1 is zero and F chooses its unknowns; so are held coordinates.
    """
    from scipy.sparse import coo_matrix

    system, state = factored.system, factored.state
    place = np.full(len(system.points_used), -1)
    place[points] = np.arange(len(points))
    of_row = system.block.observations.point[system.rows]
    rows = np.flatnonzero((place[of_row] >= 0) & (system.point_node[of_row] < 0))
    at = place[of_row[rows]]
    A, columns, B = design_rows(system, state, rows)
    free = ~system.held[points]
    A = A * free[at][:, None, :]
    V = np.zeros((len(points), 3, 3))
    np.add.at(V, at, np.swapaxes(A, 1, 2) @ A)
    diagonal = V[:, np.arange(3), np.arange(3)]
    retained = system.point_node[points] >= 0
    diagonal += np.where(free, point_prior(system)[0][points], 1.0)
    diagonal[retained] = 1.0
    V[:, np.arange(3), np.arange(3)] = diagonal
    own = np.linalg.inv(V) * (free & ~retained[:, None])[:, :, None] * free[:, None, :]
    F = -own[at] @ (np.swapaxes(A, 1, 2) @ B)
    row = np.broadcast_to(3 * at[:, None, None] + np.arange(3)[:, None], F.shape)
    column = np.broadcast_to(columns[:, None, :], F.shape)
    keep = column >= 0
    kept, axis = np.nonzero(free & retained[:, None])
    own_row, own_column = 3 * kept + axis, system.offsets[system.point_node[points[kept]]] + axis
    entries = (
        np.concatenate([F[keep], np.ones(len(kept))]),
        (np.concatenate([row[keep], own_row]), np.concatenate([column[keep], own_column])),
    )
    return own, coo_matrix(entries, shape=(3 * len(points), int(system.offsets[-1]))).tocsr()


def design_rows(system: System, state: State, rows: Index) -> tuple[Array, Array, Array]:
    """Whitened rows of the design matrix of image observations (k,), positions among `System.rows`.

    returns  derivatives by the object point (k, 2, 3); unknowns of nodes (k, w), -1 where there is none; by these
             (k, 2, w)
    """
    o, used = system.block.observations, system.rows[rows]
    image, point, xy = o.image[used], o.point[used], system.xy_mm[rows]
    of_image = system.interior_of_image[image]
    local = np.array([r.camera >= 0 and r.sensor.local_width > 0 for r in system.interior])[of_image]
    w = system.stride
    D, touched = np.zeros((len(rows), 2, 3 + w)), np.full((len(rows), w), -1, np.int64)
    P = sensor_from_object(state.rotation[image], state.centre[image], state.xyz[point]).T
    mine = np.flatnonzero(~local)
    D[mine] = image_residuals(system, state, image[mine], point[mine], xy[mine])[1]
    parents = system.parents[of_image[mine]]
    shared = np.where(parents[:, None] >= 0, system.interior_columns[np.maximum(parents, 0)], -1)
    touched[mine] = np.maximum(system.interior_columns[of_image[mine]], shared)
    mine = np.flatnonzero(local)
    if len(mine):
        mask = np.zeros(len(system.rows), bool)
        mask[rows[mine]] = True
        reported, at = external_rows(system, state, mask)
        order = np.argsort(np.argsort(rows[mine]))
        reported, at = reported[order], at[order]
        k = at.shape[1]
        D[mine, :, :3] = reported[:, 2:8].reshape(-1, 2, 3)
        D[mine, :, 3 : 3 + k] = reported[:, 8 : 8 + 2 * k].reshape(-1, 2, k)
        starts = system.offsets[[r.node for r in system.interior]]  # of what is held `at` is -1
        touched[mine, :k] = np.where(at >= 0, starts[of_image[mine]][:, None] + at, -1)
    R = state.rotation[image]
    by_object = D[:, :, :3] @ R
    station = np.concatenate([-by_object, np.cross(P[:, None], D[:, :, :3])], axis=2)
    node, free = system.image_node[image], system.exterior_free[image]
    own = np.where(free[:, None], system.offsets[np.maximum(node, 0)][:, None] + np.arange(6), -1)
    W = whitening(system.whiten[rows])
    columns = np.concatenate([own, touched], axis=1)
    return W @ by_object, columns, W @ np.concatenate([station, D[:, :, 3:]], axis=2)


def whitening(packed: Array) -> Array:
    """(k, 2, 2) lower triangles of packed ones (k, 3)."""
    W = np.zeros((len(packed), 2, 2))
    W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = packed.T
    return W
