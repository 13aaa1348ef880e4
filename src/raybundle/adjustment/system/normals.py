"""The normal equations of a system: native solver, observations outside the images, one interface."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.dense import as_many_threads_as_help, set_dense_kernels
from raybundle.adjustment.system.other_observations import Correlated
from raybundle.numerics import large, native
from raybundle.numerics.arrays import Array, Index, Mask

if TYPE_CHECKING:
    from raybundle.adjustment.system.datum import Transformation

_NONE = np.zeros(0)
SIDES = 16
"""Right sides that the kernels take at a time"""
LEAST_OBSERVATIONS = 2000
"""Image observations for each thread, below which it takes longer to start it than to work alone."""


@dataclass(slots=True)
class Linearised:
    """Linearised extra observations: residuals and sparse rows, in units of their standard deviations or whitened."""

    residual: Array
    row: Index
    unknown: Array
    value: Array


_NOTHING = Linearised(_NONE, np.zeros(0, np.int32), np.zeros(0, np.int64), _NONE)


@dataclass(slots=True)
class Normals:
    """Reduced normal equations of one system; the arrays are reused from step to step."""

    system: System
    solver: Any
    threads: int
    values: Array
    right: Array
    diagonal: Array
    pair_row: Index = field(default_factory=lambda: np.zeros(0, np.int32))
    pairs: tuple[Array, Array] = field(default_factory=lambda: (np.zeros(0, np.int64), np.zeros(0, np.int64)))
    pair_weight: Array | None = None
    """Of each pair, where rows are correlated; None: all 1"""
    pair_at: Array = field(default_factory=lambda: np.zeros(0, np.int64))
    external: Mask = field(default_factory=lambda: np.zeros(0, bool))
    evaluated: State | None = None
    """State of the last evaluation of models that are not compiled; a state is not changed once it is used."""

    @classmethod
    def of(cls, system: System, threads: int = 0, meeting: Sequence[tuple[int, int]] = ()) -> Normals:
        """Set up structure, ordering and buffers.

        meeting  nodes whose block the matrix has although no observation of this system ties them
        """
        count = threads or (len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)
        module = native.module()
        if module is None:
            from raybundle.adjustment.system.normals_numpy import Solver

            solver: Any = Solver(system.block, system)
        else:
            set_dense_kernels()
            solver = module.Solver()
        external = _fill(solver, system, frozenset() if module is None else native.sensor_models())
        normals = cls(
            system=system,
            solver=solver,
            threads=max(1, min(count, len(system.rows) // LEAST_OBSERVATIONS)),
            values=_NONE,
            right=_NONE,
            diagonal=_NONE,
            external=external,
        )
        entries = normals.standardised(system.initial_state())
        a, b = _pairs_of_rows(system.extra.group_of_row()[entries.row])
        node_a, node_b = normals._node(entries.unknown[a]), normals._node(entries.unknown[b])
        keep = node_a <= node_b
        a, b, node_a, node_b = a[keep], b[keep], node_a[keep], node_b[keep]
        alone = {(n, n) for n in range(len(system.sizes))}
        solver.set_nodes(
            system.sizes, sorted(alone | set(meeting) | set(zip(node_a.tolist(), node_b.tolist(), strict=True)))
        )
        normals.values = np.zeros(solver.values_size)
        normals.right, normals.diagonal = np.zeros(solver.unknowns), np.zeros(solver.unknowns)
        normals._place_extra(entries, a, b, node_a, node_b)
        return normals

    def _place_extra(self, entries: Linearised, a: Array, b: Array, node_a: Array, node_b: Array) -> None:
        """Where the products of the extra observations' rows stand in the flat normal matrix."""
        if not len(a):
            return
        local_a = entries.unknown[a] - self.system.offsets[node_a]
        local_b = entries.unknown[b] - self.system.offsets[node_b]
        blocks, which = np.unique(np.stack([node_a, node_b], axis=1), axis=0, return_inverse=True)
        starts = [self.solver.block_start(self.solver.block(i, j)) for i, j in blocks.tolist()]
        start = np.array(starts, np.int64)[which.ravel()]
        self.pairs = (a, b)
        if self.system.extra.correlated:
            self.pair_weight = self._weight(entries.row[a], entries.row[b])
        self.pair_at = start + local_a * self.system.sizes[node_b] + local_b

    def _weight(self, first: Index, second: Index) -> Array:
        """Weights (e,) of pairs of rows in units of their standard deviations."""
        found = (first == second).astype(float)
        correlated = self.system.extra.correlated
        place, _ = _places(correlated, len(self.system.extra))
        for joint, mine in zip(correlated, _entries_of(correlated, first, len(self.system.extra)), strict=True):
            found[mine] = joint.weight[place[first[mine]], place[second[mine]]]
        return found

    def _node(self, unknown: Array) -> Array:
        return np.searchsorted(self.system.offsets, unknown, side="right") - 1

    def standardised(self, state: State, held: Mask | None = None) -> Linearised:
        """Extra observations at a state, in units of their standard deviations: residual adjusted - observed.

        held  (p, 3) coordinates that are no unknowns; None: with those that the datum holds
        """
        system, extra = self.system, self.system.extra
        held = system.held if held is None else held
        if not len(extra):
            return _NOTHING
        residual = np.zeros(len(extra))
        rows, unknowns, values = [np.zeros(0, np.int64)], [np.zeros(0, np.int64)], [np.zeros(0)]
        for part in extra.parts:
            at = part.kind.observed(part.table, part.rows, extra.scope, state)
            residual[part.positions] = at.residual
            for partials in at.partials:
                columns = system.columns(part.kind, partials)
                free = columns >= 0
                value = partials.value
                if partials.of == "point":  # of what the datum holds the structure stays
                    value = value * ~held[partials.item, partials.component]
                rows.append(partials.row[free] + part.start)
                unknowns.append(columns[free])
                values.append(value[free])
        row = np.concatenate(rows)
        return Linearised(
            residual / extra.sigma,
            row.astype(np.int32),
            np.concatenate(unknowns).astype(np.int64),
            np.concatenate(values) / extra.sigma[row],
        )

    def extra(self, state: State) -> Linearised:
        """Extra observations at a state, whitened: rows independent of each other, each of standard deviation 1.

        Of correlated ones a row is a sum of those that were observed.
        """
        e = self.standardised(state)
        correlated = self.system.extra.correlated
        return _mixed(e, correlated) if correlated else e

    def rows_of(self, state: State, rows: Index) -> tuple[Array, Array]:
        """Whitened residuals (k,) of extra observations, and their rows of the design matrix by the nodes (N, k)."""
        e = self.extra(state)
        nodes = np.zeros((int(self.system.offsets[-1]), len(rows)))
        for k, row in enumerate(rows):
            mine = e.row == row
            np.add.at(nodes[:, k], e.unknown[mine], e.value[mine])
        return np.asarray(e.residual, float)[rows], nodes

    def refresh_external(self, state: State) -> None:
        """Evaluate models that are not compiled at a state and hand them to the native solver."""
        if not self.external.any() or self.evaluated is state:
            return
        from raybundle.adjustment.system.external import external_rows

        rows, touched = external_rows(self.system, state, self.external)
        self.solver.set_external(rows, touched, touched.shape[1])
        self.evaluated = state

    def arguments(self, state: State) -> tuple[Array, Array, Array, Array]:
        """The state as the solver takes it."""
        return (
            np.ascontiguousarray(state.rotation),
            np.ascontiguousarray(state.centre),
            np.ascontiguousarray(state.interior),
            np.ascontiguousarray(state.xyz),
        )

    def reduce(self, state: State, *, damping: float = 0.0, huber: float = 0.0) -> tuple[float, int, list[int]]:
        """Form the reduced normal equations; returns cost, observations behind the camera, weak points."""
        self.refresh_external(state)
        cost, behind, _, weak = self.solver.reduce(
            *self.arguments(state), huber, damping, self.threads, self.values, self.right, self.diagonal
        )
        e = self.standardised(state)
        weighted = self.system.extra.weighted(e.residual)
        if len(e.value):
            a, b = self.pairs
            products = e.value[a] * e.value[b]
            np.add.at(self.right, e.unknown, -e.value * weighted[e.row])
            if self.pair_weight is None:
                np.add.at(self.diagonal, e.unknown, e.value**2)
            else:
                products *= self.pair_weight
                alone = e.unknown[a] == e.unknown[b]
                np.add.at(self.diagonal, e.unknown[a[alone]], products[alone])
            np.add.at(self.values, self.pair_at, products)
        self._hold_retained()
        return float(cost) + 0.5 * float(e.residual @ weighted), int(behind), list(weak)

    def _hold_retained(self) -> None:
        """Held coordinates of retained points: one on the diagonal."""
        for node, axis in zip(*self._held_of_nodes(), strict=True):
            self.values[self.solver.block_start(self.solver.block(int(node), int(node))) + 4 * axis] = 1.0
        held = self.held_unknowns()
        self.diagonal[held], self.right[held] = 1.0, 0.0

    def _held_of_nodes(self) -> tuple[Index, Index]:
        """Nodes of retained points and their coordinates that are held."""
        system = self.system
        point, axis = np.nonzero(system.held & (system.point_node >= 0)[:, None])
        return system.point_node[point], axis.astype(np.int32)

    def held_unknowns(self) -> Index:
        """Unknowns of nodes that are held coordinates of retained points."""
        node, axis = self._held_of_nodes()
        return (self.system.offsets[node] + axis).astype(np.int64)

    def step(self, state: State, *, damping: float = 0.0, huber: float = 0.0) -> tuple[Array, Array, float] | int:
        """Solve for a step after `reduce`; returns nodes, points (p, 3) and the linearised cost.

        An integer names the unknown at which the matrix is not positive definite.
        """
        # an unknown that nothing touches stays where it is; the undamped factor then names it
        added = damping * np.where(self.diagonal > 0, self.diagonal, 1.0) if damping else _NONE
        failed = self.factorise(added)
        if failed:
            return failed - 1
        nodes = self.solved(self.right)
        points = np.zeros_like(state.xyz)
        cost = self.solver.back_substitute(*self.arguments(state), huber, damping, self.threads, nodes, points)
        e = self.standardised(state)
        moved = e.residual.copy()
        if len(moved):
            np.add.at(moved, e.row, e.value * nodes[e.unknown])
        return nodes, points, float(cost) + 0.5 * float(moved @ self.system.extra.weighted(moved))

    @property
    def unknowns(self) -> int:
        """Number of unknowns before a datum is chosen."""
        return self.system.unknowns

    @property
    def observations(self) -> int:
        """Number of observations."""
        return self.system.observations

    def trial(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, passing: bool = False
    ) -> tuple[State, float] | int:
        """The state after a step, after `reduce`, and its linearised cost; an integer as of `step`."""
        found = self.step(state, damping=damping, huber=huber)
        if isinstance(found, int):
            return found
        nodes, points, linear = found
        return self.system.updated(state, nodes, points, passing=passing), linear

    def excess(self, state: State, huber: float) -> float:
        """Huber's costs of long residuals, k (l - k / 2), over those of the weighted ones, k l / 2.

        A step minimises the latter; what it is to gain must be reckoned from there.
        """
        if huber <= 0:
            return 0.0
        length = np.linalg.norm(self.residuals(state)[0], axis=1)
        return float(0.5 * huber * np.maximum(length - huber, 0.0).sum())

    def beyond(self, state: State) -> Index:
        """Object points whose rays diverge (`far_points`)."""
        return self.system.beyond(state)

    def before(self, state: State) -> State:
        """The state with points before their cameras that all of these see behind; the same one where none is."""
        return self.system.before(state, (self.residuals(state)[1] & 1) > 0)

    def hold(self, held: Mask) -> None:
        """Hold these coordinates (p, 3), those of control among them."""
        self.system.held = held
        self.solver.set_held(held_bits(held))

    def statistics(
        self, state: State, inverse: Array, change: Transformation | None = None
    ) -> tuple[Array, Array, Array, Array]:
        """What an inverse of the reduced matrix states of object points and image points.

        returns  cofactors (p, 3, 3) of the object points, A Q A' (m, 3) of each whitened image point, effect (m, 3, 2)
                 of a blunder in it, and H (p, 3, d) of the object points where the datum changes
        """
        none, d = np.zeros(0), 0 if change is None else change.nodes.shape[1]
        return self.solver.statistics(
            *self.arguments(state), self.threads, np.ascontiguousarray(inverse), d,
            none if change is None else np.ascontiguousarray(change.nodes_h),
            none if change is None else change.given,
            none if change is None else change.points,
            none if change is None else np.ascontiguousarray(change.middle),
        )  # fmt: skip

    @property
    def smallest_pivot(self) -> float:
        """The smallest relative pivot of the last factor."""
        return float(self.solver.smallest_pivot)

    @property
    def meeting(self) -> int:
        """Unknowns that an unknown of the nodes meets in the normal matrix, on average: how large its dense parts are.

        The factor of a sparse matrix is made in small parts, where threads wait for each other: of 18 000 unknowns that
        meet 400 each, two take 0.76 of the time for 1.5 times the processor time, and much longer where processors are
        busy otherwise; full matrices of 2000 and more take 0.6 to 0.7 (benchmarks/factor_threads.py).
        """
        return 2 * len(self.values) // max(len(self.right), 1)

    def factorise(self, added: Array = _NONE) -> int:
        """Factor the matrix of the last `reduce` with this added to its diagonal; 0, or 1 + the unknown that fails.

        Where it fails there is no factor: `solved`, `selected_inverse` and `least_share` then raise ValueError.
        """
        with as_many_threads_as_help(self.meeting):
            return int(self.solver.factorise(self.values, added))

    def least_share(self) -> tuple[float, int]:
        """The least share of an unknown's information that the factor found left over, and the unknown.

        Of the information that the observations bring for it (the diagonal before object points are eliminated) what
        the unknowns eliminated before it have not taken.
        """
        if not len(self.right):
            return 1.0, -1
        pivots = np.empty(len(self.right))
        self.solver.pivots(pivots)
        share = pivots / np.maximum(self.diagonal, 1e-300)
        at = int(share.argmin())
        return float(share[at]), at

    def solved(self, right: Array) -> Array:
        """N^-1 applied to right sides (N,) or (N, k) of the nodes, with the last factor."""
        found = np.array(right, order="C")
        with as_many_threads_as_help(self.meeting):
            self.solver.solve(found, 1 if found.ndim == 1 else found.shape[1])
        return found

    def selected_inverse(self) -> Array:
        """The inverse at the entries of the normal matrix and in its layout, with the last factor."""
        inverse = np.zeros_like(self.values)
        with as_many_threads_as_help(self.meeting):
            self.solver.selected_inverse(inverse)
        return inverse

    def cost(self, state: State, *, huber: float = 0.0) -> tuple[float, int]:
        """Half the weighted square sum, and the observations behind the camera."""
        self.refresh_external(state)
        cost, behind, _ = self.solver.evaluate(
            *self.arguments(state), huber, self.threads, _NONE, np.zeros(0, np.uint8)
        )
        e = self.standardised(state).residual
        return float(cost) + 0.5 * float(e @ self.system.extra.weighted(e)), int(behind)

    def residuals(self, state: State) -> tuple[Array, Array]:
        """Whitened residuals (m, 2) and flags (m,): 1 behind the camera, 2 without a projection."""
        self.refresh_external(state)
        v = large.zeros((len(self.system.rows), 2))
        flags = np.zeros(len(self.system.rows), np.uint8)
        self.solver.evaluate(*self.arguments(state), 0.0, self.threads, v, flags)
        return v, flags

    def solve_nodes(self, state: State, nodes: Array, points: Array) -> Array:
        """The nodes' part (N, k) of N^-1 applied to right sides for nodes (N, k) and points (p, 3, k)."""
        return self.solved_nodes(nodes + self.condensed(state, self._free_rows(points)))

    def condensed(self, state: State, points: Array) -> Array:
        """What right sides (p, 3, k) of the points that are eliminated bring to the nodes (N, k)."""
        found = [
            self.solver.condense(*self.arguments(state), self.threads, np.ascontiguousarray(points[:, :, some]), count)
            for some, count in _together(points.shape[2])
        ]
        return np.concatenate(found, axis=1)

    def solved_nodes(self, nodes: Array) -> Array:
        """The nodes' part (N, k) of N^-1 applied to right sides for nodes (N, k) alone."""
        right = np.array(nodes)
        right[self.held_unknowns()] = 0.0  # what is held has no variance
        return self.solved(right)

    def solve_points(self, state: State, nodes: Array, points: Array) -> Array:
        """The points' part (p, 3, k) that belongs to the nodes' part (N, k) of a solution."""
        found = [
            self.solver.expand(
                *self.arguments(state), self.threads, np.ascontiguousarray(nodes[:, some]),
                self._free_rows(points[:, :, some]), count,
            )
            for some, count in _together(nodes.shape[1])
        ]  # fmt: skip
        return np.concatenate(found, axis=2)

    def solve(self, state: State, nodes: Array, points: Array) -> tuple[Array, Array]:
        """N^-1 applied to right sides for nodes (N, k) and points (p, 3, k), with the last factor."""
        right = self.solve_nodes(state, nodes, points)
        return right, self.solve_points(state, right, points)

    def _free_rows(self, points: Array) -> Array:
        held = self.system.held
        return np.ascontiguousarray(points * ~held[:, :, None] if held.any() else points)

    def node_block(self, inverse: Array, a: int, b: int) -> Array:
        """Block (a, b) of a matrix in the layout of the normal matrix."""
        sizes = self.system.sizes
        low, high = min(a, b), max(a, b)
        k = self.solver.block(low, high)
        if k < 0:
            raise KeyError((a, b))
        start = self.solver.block_start(k)
        block = inverse[start : start + int(sizes[low]) * int(sizes[high])].reshape(int(sizes[low]), int(sizes[high]))
        return block if a <= b else block.T


def _together(columns: int) -> list[tuple[slice, int]]:
    """Right sides that the kernels take at a time, and how many these are."""
    return [(slice(k, k + SIDES), min(SIDES, columns - k)) for k in range(0, columns, SIDES)]


def _places(correlated: Sequence[Correlated], count: int) -> tuple[Index, Index]:
    """(count,) of rows: place in the group, and number of the group that they are correlated in; -1: in none."""
    place, group = np.full(count, -1), np.full(count, -1)
    for k, joint in enumerate(correlated):
        place[joint.rows], group[joint.rows] = np.arange(len(joint.rows)), k
    return place, group


def _entries_of(correlated: Sequence[Correlated], row: Index, count: int) -> list[Array]:
    """Positions of the entries whose rows (e,) are of each group, ascending."""
    group = _places(correlated, count)[1][row]
    order = np.argsort(group, kind="stable")
    bounds = np.searchsorted(group[order], np.arange(len(correlated) + 1))
    return [order[a:b] for a, b in pairwise(bounds.tolist())]


def _mixed(e: Linearised, correlated: Sequence[Correlated]) -> Linearised:
    """With the rows of each group whitened."""
    count = len(e.residual)
    place, group = _places(correlated, count)
    alone = group[e.row] < 0
    residual = e.residual.copy()
    rows, unknowns, values = [e.row[alone]], [e.unknown[alone]], [e.value[alone]]
    for joint, mine in zip(correlated, _entries_of(correlated, e.row, count), strict=True):
        unknown, column = np.unique(e.unknown[mine], return_inverse=True)
        dense = np.zeros((len(joint.rows), len(unknown)))
        np.add.at(dense, (place[e.row[mine]], column), e.value[mine])
        residual[joint.rows] = joint.root @ residual[joint.rows]
        rows.append(np.repeat(joint.rows, len(unknown)))
        unknowns.append(np.tile(unknown, len(joint.rows)))
        values.append((joint.root @ dense).ravel())
    row, unknown = np.concatenate(rows).astype(np.int32), np.concatenate(unknowns)
    return Linearised(residual, row, unknown, np.concatenate(values))


def _pairs_of_rows(row: Index) -> tuple[Array, Array]:
    """Positions of all pairs of entries that stand in one row (or group), each with itself and both ways."""
    order = np.argsort(row, kind="stable")
    count = np.bincount(row)[row[order]] if len(row) else np.zeros(0, np.int64)
    first = np.searchsorted(row[order], row[order])
    a = np.repeat(np.arange(len(row)), count)
    within = np.arange(len(a)) - np.repeat(np.cumsum(count) - count, count)
    return order[a], order[first[a] + within]


def _fill(solver: Any, system: System, compiled: frozenset[str]) -> Mask:
    """Hand the arrays to the solver; returns which observations need external evaluation."""
    block = system.block
    observations = block.observations
    image = observations.image[system.rows].astype(np.int32)
    point = observations.point[system.rows].astype(np.int32)
    names = sorted(compiled)
    models = [row.sensor if row.camera >= 0 else None for row in system.interior]
    code_of_row = np.array([names.index(m.name) if m is not None and m.native else -1 for m in models], np.int32)
    model = code_of_row[system.interior_of_image]
    external = model[image] < 0
    external_row = np.where(external, np.cumsum(external) - 1, -1).astype(np.int32)
    solver.set_observations(image, point, system.xy_mm, system.whiten, external_row)
    patterns: list[tuple[list[int], list[int]]] = []
    known: dict[tuple[tuple[int, ...], tuple[int, ...]], int] = {}
    pattern = np.zeros(len(block.images), np.int32)
    for i in range(len(block.images)):
        row = system.interior[int(system.interior_of_image[i])]
        interior = tuple(6 + k for k in row.free)
        own = tuple(range(6)) if system.exterior_free[i] else ()
        shared: tuple[int, ...] = ()
        if row.node >= 0 and row.node == system.image_node[i]:
            own += interior
        elif row.node >= 0 and system.images_used[i]:
            shared = interior
        if row.parent >= 0 and system.interior[row.parent].node >= 0:
            shared = tuple(6 + k for k in system.interior[row.parent].free)
        if row.links:
            shared = tuple(
                6 + k for k in np.flatnonzero(system.node_columns(int(system.interior_of_image[i])) >= 0).tolist()
            )
        key = (own, shared)
        if key not in known:
            known[key] = len(patterns)
            patterns.append((list(own), list(shared)))
        pattern[i] = known[key]
    solver.set_images(
        model.astype(np.int32),
        system.corrected[block.images.camera].astype(np.int32),
        system.interior_of_image,
        pattern,
        system.image_node,
        system.shared_node,
        np.array([0 if m is None else m.local_width or len(m.symbols) for m in models], np.int32)[
            system.interior_of_image
        ],
        system.stride,
    )
    solver.set_patterns(patterns)
    counts = np.bincount(point, minlength=len(block.points))
    first = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    weight, value = point_prior(system)
    solver.set_points(first, system.point_node, held_bits(system.held), weight, value)
    return external


def point_prior(system: System) -> tuple[Array, Array]:
    """Weights and values (p, 3) of observed coordinates of eliminated points."""
    points = system.block.points
    mine = system.prior & (system.point_node < 0)[:, None]
    weight = np.zeros_like(points.xyz)
    weight[mine] = 1 / points.sigma[mine] ** 2
    value = np.where(mine, points.xyz - system.shift, 0.0)
    return np.ascontiguousarray(weight), np.ascontiguousarray(value)


def held_bits(held: Mask) -> Array:
    """Held coordinates (p, 3) of points as the solver takes them: (p,) bits."""
    return (held * np.array([1, 2, 4])).sum(axis=1).astype(np.uint8)
