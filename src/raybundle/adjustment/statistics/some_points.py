"""The covariance of all nodes and of some object points: as of the whole block, without the work for other points.

A point that is eliminated is x = V^-1 (b - W' n), with V and W of its own rays alone: the covariances of some points
come from that of the nodes and the partial derivatives of their rays.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np

from raybundle.adjustment.statistics.field_system import FieldSystem, Wide, widened, widened_state
from raybundle.adjustment.statistics.fields import WithFields
from raybundle.adjustment.statistics.noise import Outside
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.images_numpy import image_residuals
from raybundle.adjustment.system.normals import Normals, point_prior
from raybundle.adjustment.system.normals_numpy import roots_of_points
from raybundle.numerics.arrays import Array, Index
from raybundle.platforms.station import station_partials

Solve = Callable[[Array, Array], tuple[Array, Array]]
"""The covariance, of unit weight and in the datum of the factor, applied to right sides for nodes (N, c) and points
(k, 3, c)"""


def solver_of(work: Work, points: Index) -> Solve:
    """What `Normals.solve` or `Spread.solve` make of right sides for nodes and these points, of these alone.

    points  ascending, with `needed(work)` among them
    """
    own = _NormalsOfPoints.among(work, points)
    state = replace(work.state, xyz=work.state.xyz[points])
    if work.spread is None:
        return partial(own.solve, state)
    whole = work.spread.fields
    wide, _, columns = widened(work.system, whole.images, WithFields)
    taken = _of_rays(wide, widened_state(work.system, wide, work.state), points)[1][:, columns]
    fields: Any = _WideOfPoints(whole.wide, state, own, taken)
    outside = work.spread.outside
    if outside is not None:
        outside = replace(outside, point=np.searchsorted(points, outside.point))
    system = FieldSystem(own, state, fields, whole.images, whole.size, whole.scores)
    return replace(work.spread, fields=system, own=work.spread.own[points], outside=outside).solve


def needed(work: Work) -> Index:
    """Points that covariances of any other ones rest on: those with coordinates that are observed."""
    outside: Outside | None = None if work.spread is None else work.spread.outside
    return np.zeros(0, np.int64) if outside is None else np.unique(outside.point).astype(np.int64)


@dataclass(slots=True)
class _NormalsOfPoints(Normals):
    """The normal equations of a block with its factor, and some of the points."""

    whole: Normals = field(kw_only=True)
    inverse: Array = field(kw_only=True)
    """(k, 3, 3) V^-1"""
    taken: Any = field(kw_only=True)
    """(3 k, N) sparse V^-1 W'"""

    @classmethod
    def among(cls, work: Work, points: Index) -> _NormalsOfPoints:
        """Of points of an adjusted block."""
        system, whole = work.system, work.normals
        inverse, taken = _of_rays(system, work.state, points)
        some = replace(system, point_node=system.point_node[points], held=system.held[points])
        return cls(
            system=some, solver=whole.solver, threads=whole.threads, values=whole.values, right=whole.right,
            diagonal=whole.diagonal, whole=whole, inverse=inverse, taken=taken,
        )  # fmt: skip

    def solved(self, right: Array) -> Array:
        """As of the whole."""
        return self.whole.solved(right)

    def solved_nodes(self, nodes: Array) -> Array:
        """As of the whole."""
        return self.whole.solved_nodes(nodes)

    def condensed(self, state: State, points: Array) -> Array:
        """What right sides (k, 3, c) of the points bring to the nodes (N, c)."""
        del state
        kept, at = self._kept()
        found = -(self.taken.T @ points.reshape(-1, points.shape[2]))
        found[at] += points[kept]
        return found

    def solve_points(self, state: State, nodes: Array, points: Array) -> Array:
        """The points' part (k, 3, c) that belongs to the nodes' part (N, c) of a solution."""
        del state
        kept, at = self._kept()
        found = self.inverse @ self._free_rows(points) - (self.taken @ nodes).reshape(points.shape)
        found[kept] = nodes[at]
        return found

    def _kept(self) -> tuple[Index, Index]:
        """Points that are not eliminated, and their unknowns (r, 3)."""
        node = self.system.point_node
        kept = np.flatnonzero(node >= 0)
        return kept, self.system.offsets[node[kept]][:, None] + np.arange(3)


@dataclass(slots=True)
class _WideOfPoints:
    """Normal equations with the columns of fields, and some of the points (`field_system.Wide`)."""

    whole: Wide
    state: State
    own: _NormalsOfPoints
    taken: Any
    """(3 k, 10 f) sparse V^-1 W' of the fields"""

    def times(self, coefficients: Any) -> Array:
        """As of the whole."""
        return self.whole.times(coefficients)

    def transposed(self, nodes: Array) -> Array:
        """As of the whole."""
        return self.whole.transposed(nodes)

    def expand(self, nodes: Array, coefficients: Array) -> Array:
        """J c of the points (k, 3, c)."""
        shape = len(self.own.inverse), 3, nodes.shape[1]
        moved = self.own.solve_points(self.state, nodes, np.zeros(shape))
        return moved + np.asarray(self.taken @ coefficients).reshape(shape)

    def condense(self, points: Array) -> Array:
        """What right sides (k, 3, c) of the points bring to the fields."""
        free = points * ~self.own.system.held[:, :, None]
        return -(self.taken.T @ free.reshape(-1, points.shape[2]))


def _of_rays(system: System, state: State, points: Index) -> tuple[Array, Any]:
    """V^-1 (k, 3, 3) and V^-1 W' (3 k, N) sparse of some points; nothing of those that are not eliminated."""
    from scipy.sparse import bsr_matrix, csr_matrix

    o, k = system.block.observations, len(points)
    place = np.full(len(system.point_node), -1)
    place[points] = np.where(system.point_node[points] < 0, np.arange(k), -1)
    rows = np.flatnonzero(place[o.point[system.rows]] >= 0)
    image, point = o.image[system.rows[rows]], o.point[system.rows[rows]]
    _, D, P, _ = image_residuals(system, state, image, point, system.xy_mm[rows])
    W = np.zeros((len(rows), 2, 2))
    W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = system.whiten[rows].T
    by_station, x = station_partials(state.rotation[image], P[:, None], (W @ D[:, :, :3]))
    x = x * ~system.held[point, None]
    mine, e = place[point], np.arange(3)
    V = np.zeros((k, 3, 3))
    np.add.at(V, mine, np.swapaxes(x, 1, 2) @ x)
    V[:, e, e] = np.where(system.held[points], 1.0, V[:, e, e] + point_prior(system)[0][points])
    V[system.point_node[points] >= 0] = np.eye(3)
    root, _ = roots_of_points(V)
    inverse = np.swapaxes(root, 1, 2) @ root
    at, values = _of_nodes(system, image, by_station, W @ D[:, :, 3:])
    couplings = np.einsum("mji,mjc->mic", x, values)
    line = np.broadcast_to((3 * mine[:, None] + e)[:, :, None], couplings.shape)
    column = np.broadcast_to(np.maximum(at, 0)[:, None], couplings.shape)
    there = np.broadcast_to((at >= 0)[:, None], couplings.shape)
    coupled: Any = csr_matrix((couplings[there], (line[there], column[there])), shape=(3 * k, int(system.offsets[-1])))
    each: Any = bsr_matrix((inverse, np.arange(k), np.arange(k + 1)), shape=(3 * k, 3 * k))
    return inverse, (each @ coupled).tocsr()


def _of_nodes(system: System, image: Index, by_station: Array, by_interior: Array) -> tuple[Index, Array]:
    """Unknowns (m, c) that image points depend on, -1: none, and the partial derivatives (m, 2, c) by them."""
    width = by_interior.shape[2]
    at = np.full((len(image), 6 + width), -1, np.int64)
    free = system.exterior_free[image]
    at[free, :6] = system.offsets[system.image_node[image[free]]][:, None] + np.arange(6)
    for r in np.unique(system.interior_of_image[image]).tolist():
        for source, positions in system.sources(r):
            row = system.interior[source]
            if row.node >= 0 and positions:
                start = int(system.offsets[row.node]) + row.start
                mine = np.flatnonzero(system.interior_of_image[image] == r)
                at[np.ix_(mine, 6 + np.array(positions))] = start + np.arange(len(positions))
    return at, np.concatenate([by_station, by_interior], axis=2)
