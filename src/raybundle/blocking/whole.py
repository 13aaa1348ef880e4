"""A network in parts that lies in memory as a whole: what the adjustment takes for its normal equations."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from raybundle.adjustment.assemble import State, System
from raybundle.adjustment.normals import Normals
from raybundle.adjustment.transformation import Transformation
from raybundle.blocking import sweeps, tasks
from raybundle.blocking.network import Network, PartWork
from raybundle.blocking.normals import Parts, PartsNormals, PartsState, unique
from raybundle.blocking.tasks import Store
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.pipeline.executors import Executor

NOTHING = np.zeros(0)


@dataclass(slots=True)
class WholeNormals(Normals):
    """The normal equations of a system whose parts are reduced one by one; equal to those in one piece.

    `values` and `selected_inverse` hold the blocks that observations outside the images and statistics ask for, no
    others.
    """

    parts: PartsNormals = field(kw_only=True)
    place: Index = field(kw_only=True)
    """(m,) position in `System.rows` of each image observation of the block, -1 of those that take no part"""

    known: tuple[State, PartsState] | None = field(default=None, kw_only=True)
    """The last state that was asked for, and what the parts have of it"""
    tried: tuple[State, PartsState] | None = field(default=None, kw_only=True)
    """The last trial"""
    touched: dict[int, tuple[Index, Index, Index]] = field(
        default_factory=dict[int, tuple[Index, Index, Index]], kw_only=True
    )

    @classmethod
    def whole(cls, system: System, network: Network, store: Store, executor: Executor) -> WholeNormals:
        """Of a system and the network that its block was cut into."""
        own = network.skeleton.normals
        place = np.full(len(system.block.observations), -1, np.int64)
        place[system.rows] = np.arange(len(system.rows))
        found = cls(
            system=system, solver=own.solver, threads=1, values=np.zeros_like(own.values),
            right=np.zeros_like(own.right), diagonal=np.zeros_like(own.diagonal), external=np.zeros(0, bool),
            parts=PartsNormals(Parts(network, store, executor), system.observations, system.unknowns), place=place,
        )  # fmt: skip
        found.hold(system.held)
        return found

    # -- states

    def scattered(self, state: State) -> PartsState:
        """A state as the parts keep it."""
        parts = self.parts
        keys = [""] * len(parts.network.tree)
        for t, (images, points, interior) in self._touched().items():
            keys[t] = unique("state")
            mine = State(state.rotation[images], state.centre[images], state.interior[interior], state.xyz[points])
            parts.parts.store.store(keys[t], sweeps.kept_state(mine))
        at = parts.network.skeleton.points
        return PartsState(state.rotation, state.centre, state.interior, state.xyz[at], state.own, keys=tuple(keys))

    def gathered(self, state: PartsState) -> State:
        """A state of the parts as a whole."""
        xyz = np.zeros((len(self.system.block.points), 3))
        for t, (_, points, _) in self._touched().items():
            xyz[points] = self.parts.parts.store.wanted(state.keys[t], ("xyz",))["xyz"]
        with_node = self.parts.network.skeleton.system.point_node >= 0
        xyz[self.parts.network.skeleton.points[with_node]] = state.xyz[with_node]
        return State(state.rotation, state.centre, state.interior, xyz, state.own)

    def _touched(self) -> dict[int, tuple[Index, Index, Index]]:
        """By part, which images, object points and interior orientations it touches; known without making it anew."""
        if not self.touched:
            self.touched = {t: (w.part.images, w.part.points, w.of.interior) for t, w in self._works()}
        return self.touched

    def _works(self) -> Iterator[tuple[int, PartWork]]:
        """The parts with observations, one after the other: no more are ready at once than the network says."""
        parts = self.parts.parts
        for t in range(len(parts.network.tree)):
            work = tasks.held_work(parts.store, parts.known, t, self.parts.held)
            if work is not None:
                yield t, work

    def _state(self, work: PartWork, of: PartsState, t: int) -> State:
        """Values of a part."""
        return sweeps.state_of(work, self.parts.parts.store.wanted(of.keys[t]) if of.keys[t] else None)

    def _of(self, state: State) -> PartsState:
        """The parts' state of a whole one; the last one that was asked for and the last trial are known."""
        store = self.parts.parts.store
        for at in (self.known, self.tried):
            if at is not None and at[0] is state and all(store.has(k) for k in at[1].keys if k):
                self.known = at
                return at[1]
        if self.known is not None and self.known is not self.tried:
            self.parts.parts.forget(self.known[1].keys)
        found = self.scattered(state)
        self.known = (state, found)
        return found

    # -- the iteration

    def hold(self, held: Mask) -> None:
        """Hold these coordinates (p, 3), those of control among them."""
        self.system.held = held
        self.parts.hold(held)

    def reduce(self, state: State, *, damping: float = 0.0, huber: float = 0.0) -> tuple[float, int, list[int]]:
        """Reduce and eliminate the parts."""
        found = self.parts.reduce(self._of(state), damping=damping, huber=huber)
        self.diagonal[:] = self.parts.diagonal()
        return found

    def trial(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, passing: bool = False
    ) -> tuple[State, float] | int:
        """The state after a step, after `reduce`, and its linearised cost."""
        found = self.parts.trial(self._of(state), damping=damping, huber=huber, passing=passing)
        if isinstance(found, int):
            return found
        new, linear = found
        assert isinstance(new, PartsState)
        whole = self.gathered(new)
        self.tried = (whole, new)
        return whole, linear

    def cost(self, state: State, *, huber: float = 0.0) -> tuple[float, int]:
        """Half the weighted square sum, and the observations behind the camera."""
        if self.tried is not None and self.tried[0] is state:
            return self.parts.cost(self.tried[1], huber=huber)
        of = self._of(state)
        total, behind = self.parts.network.skeleton.normals.cost(of)
        for t, work in self._works():
            cost, wrong = work.normals.cost(self._state(work, of, t), huber=huber)
            total, behind = total + cost, behind + wrong
        return total, behind

    def residuals(self, state: State) -> tuple[Array, Array]:
        """Whitened residuals (m, 2) and flags (m,), as of one piece."""
        of = self._of(state)
        v = large.zeros((len(self.system.rows), 2))
        flags = np.zeros(len(self.system.rows), np.uint8)
        for t, work in self._works():
            rows = self._rows(work)
            v[rows], flags[rows] = work.normals.residuals(self._state(work, of, t))
        return v, flags

    def _rows(self, work: PartWork) -> Index:
        """Positions in `System.rows` of a part's image observations, in its order."""
        return self.place[work.part.rows[work.of.system.rows]]

    # -- the factor

    def factorise(self, added: Array = NOTHING) -> int:
        """Whether the last `reduce` gave a factor: 0, or 1 + the unknown that fails.

        added  a share of the diagonal; the parts of the state that was last asked for are reduced once more with it
        """
        if len(added):
            assert self.known is not None
            share = float((added / np.maximum(self.diagonal, 1e-300)).max())
            self.parts.reduce(self.known[1], added=share)
        return self.parts.failed() + 1

    def least_share(self) -> tuple[float, int]:
        """The least share of an unknown's information that the factor found left over, and the unknown."""
        return self.parts.least_share()

    @property
    def one_piece(self) -> bool:
        """Not as a whole: blocks of the skeleton alone."""
        return False

    @property
    def smallest_pivot(self) -> float:
        """The smallest share that elimination left of an unknown's information."""
        return self.parts.least_share()[0]

    def solved(self, right: Array) -> Array:
        """N^-1 applied to right sides (N,) or (N, k) of the nodes."""
        whole = right if right.ndim == 2 else right[:, None]
        found = self.parts.solved(np.asarray(whole, float))
        return found if right.ndim == 2 else found[:, 0]

    def solve_nodes(self, state: State, nodes: Array, points: Array) -> Array:
        """The nodes' part (N, k) of N^-1 applied to right sides for nodes (N, k) and points (p, 3, k)."""
        system = self.system
        right, points = nodes.copy(), self._free_rows(points)
        kept = np.flatnonzero(system.point_node >= 0)
        at = system.offsets[system.point_node[kept]][:, None] + np.arange(3)
        right[at] += points[kept]
        right[self._held_unknowns()] = 0.0

        keys = [""] * len(self.parts.network.tree)
        for t, (_, mine, _) in self._touched().items():
            keys[t] = unique("points")
            self.parts.parts.store.store(keys[t], {"points": points[mine]})
        # the factor is that of these values; under which keys they were kept when it was made, they may be gone
        self.parts.at = self._of(state)
        found = self.parts.solved(right, keys)
        self.parts.parts.forget(keys)
        return found

    def solve_points(self, state: State, nodes: Array, points: Array) -> Array:
        """The points' part (p, 3, k) that belongs to the nodes' part (N, k) of a solution."""
        system, of, points = self.system, self._of(state), self._free_rows(points)
        found = np.zeros_like(points)
        for t, work in self._works():
            now = self._state(work, of, t)
            mine = np.ascontiguousarray(nodes[sweeps.rows_of(self.parts.network, work.of.nodes)])
            given = np.ascontiguousarray(points[work.part.points])
            found[work.part.points] = work.normals.solve_points(now, mine, given)
        kept = np.flatnonzero(system.point_node >= 0)
        found[kept] = nodes[system.offsets[system.point_node[kept]][:, None] + np.arange(3)]
        return found

    def selected_inverse(self) -> Array:
        """The inverse at the blocks that there are."""
        return self.parts.selected_inverse()

    def statistics(
        self, state: State, inverse: Array, change: Transformation | None = None
    ) -> tuple[Array, Array, Array, Array]:
        """Cofactors of points, A Q A', effects of blunders and H of the points, as of one piece."""
        del inverse  # the parts' own, of the last `selected_inverse`
        system, of = self.system, self._of(state)
        p, m, d = len(state.xyz), len(system.rows), 0 if change is None else change.nodes.shape[1]
        points, hat = large.zeros((p, 3, 3)), large.zeros((m, 3))
        effect, points_h = large.zeros((m, 3, 2)), large.zeros((p, 3, d))
        for t, work in self._works():
            now = self._state(work, of, t)
            mine = None if change is None else _restricted(change, self.parts.network, work)
            Q = self.parts.parts.store.wanted(self.parts.inverses[t], ("part",))["part"]
            work.normals.refresh_external(now)
            found = work.normals.statistics(now, Q, mine)
            at, rows = work.part.points, self._rows(work)
            points[at], hat[rows], effect[rows] = found[0], found[1], found[2]
            if d:
                points_h[at] = found[3]
        return points, hat, effect, points_h


def _restricted(change: Transformation, network: Network, work: PartWork) -> Transformation:
    """What an S-transformation needs of a part."""
    nodes, at = sweeps.rows_of(network, work.of.nodes), work.part.points
    return Transformation(
        nodes=change.nodes[nodes], points=np.ascontiguousarray(change.points[at]),
        given=np.ascontiguousarray(change.given[at]), nodes_h=change.nodes_h[nodes], points_h=np.zeros((0, 3, 0)),
        middle=change.middle, inner=change.inner,
    )  # fmt: skip
