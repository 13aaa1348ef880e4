"""The normal equations of a network in parts, as the iteration and the statistics take them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from raybundle.adjustment.assemble import State
from raybundle.adjustment.dense import one_thread
from raybundle.blocking import sweeps
from raybundle.blocking.network import Network, PartWork
from raybundle.blocking.sweeps import Iteration, Values
from raybundle.numerics.arrays import Array, Index, Mask


@dataclass(slots=True)
class PartsState(State):
    """Values of a network in parts: those of the skeleton, and the name under which those of the parts are kept."""

    key: str = ""
    """"": as given"""


class Runner(Protocol):
    """Does the tasks of a sweep and keeps their products."""

    def sweep(self, name: str, key: str, do: Callable[[int], dict[str, Array]], order: Sequence[int]) -> None:
        """Do a task for each tree node, in an order in which each stands behind those whose products it needs."""
        ...

    def product(self, name: str, key: str, t: int) -> Values:
        """What was kept of a tree node's task."""
        ...

    def forget(self, name: str, key: str) -> None:
        """Let the products of a sweep go."""
        ...


@dataclass(slots=True)
class Memory:
    """Does tasks one after the other; products stay in memory."""

    kept: dict[tuple[str, str, int], Values] = field(default_factory=dict[tuple[str, str, int], Values])

    def sweep(self, name: str, key: str, do: Callable[[int], dict[str, Array]], order: Sequence[int]) -> None:
        """Do a task for each tree node."""
        with one_thread():
            for t in order:
                self.kept[name, key, t] = do(t)

    def product(self, name: str, key: str, t: int) -> Values:
        """What was kept of a tree node's task."""
        return self.kept[name, key, t]

    def forget(self, name: str, key: str) -> None:
        """Let the products of a sweep go."""
        for k in [k for k in self.kept if k[:2] == (name, key)]:
            del self.kept[k]


@dataclass(slots=True)
class PartsNormals:
    """Normal equations in parts (`adjustment.solve.Equations`)."""

    network: Network
    runner: Runner
    works: dict[int, PartWork | None] = field(default_factory=dict[int, PartWork | None])
    count: int = 0
    """States so far"""
    ready: tuple[str, float, int] = ("", 0.0, 0)
    """Key, cost and observations behind the camera of the last trial"""
    formed: str = ""
    """Key of the last sweep up"""

    # -- counts

    @property
    def observations(self) -> int:
        """Number of observations."""
        return self.network.skeleton.system.observations + sum(w.of.system.observations for w in self._works())

    @property
    def unknowns(self) -> int:
        """Number of unknowns before a datum is chosen."""
        found = self.network.skeleton.system.unknowns
        for w in self._works():
            system = w.of.system
            mine = system.points_used & (system.point_node < 0)
            found += int((~system.control_held[mine]).sum())
        return found

    def _works(self) -> Iterator[PartWork]:
        for t in range(len(self.network.tree)):
            w = self.work(t)
            if w is not None:
                yield w

    def work(self, t: int) -> PartWork | None:
        """The part of a tree node."""
        if t not in self.works:
            self.works[t] = self.network.work(t)
        return self.works[t]

    def initial_state(self) -> PartsState:
        """Values as given."""
        s = self.network.skeleton.system.initial_state()
        return PartsState(s.rotation, s.centre, s.interior, s.xyz, s.own, key="")

    def part_state(self, state: State, t: int) -> Values | None:
        """Values of a part; None: as given."""
        assert isinstance(state, PartsState)
        return self.runner.product("state", state.key, t) if state.key else None

    # -- one step

    def reduce(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, added: float = 0.0
    ) -> tuple[float, int, list[int]]:
        """Reduce and eliminate, from the leaves to the root; `added` as in `Iteration`."""
        assert isinstance(state, PartsState)
        network, how = self.network, Iteration(damping=damping, huber=huber, added=added)
        normals = network.skeleton.normals
        outer, _, _ = normals.reduce(state)
        outside = {"values": normals.values, "right": normals.right, "diagonal": normals.diagonal}
        children = network.tree.children
        key = f"{state.key}/{damping!r}/{huber!r}/{added!r}"
        if self.formed:
            self.runner.forget("up", self.formed)

        def task(t: int) -> dict[str, Array]:
            below = {c: self.runner.product("up", key, c) for c in children[t]}
            return sweeps.up(network, t, self.work(t), self.part_state(state, t), how, outside, below)

        self.runner.sweep("up", key, task, range(len(network.tree)))
        self.formed = key
        found = [self.runner.product("up", key, t) for t in range(len(network.tree))]
        numbers = np.array([f["numbers"] for f in found])
        weak = [int(p) for f in found for p in f["weak"]]
        return outer + float(numbers[:, 0].sum()), int(numbers[:, 1].sum()), weak

    def failed(self) -> int:
        """The unknown that stops the elimination of the last `reduce`, -1: none."""
        return int(self.runner.product("up", self.formed, len(self.network.tree) - 1)["failed"])

    def excess(self, state: State, huber: float) -> float:
        """Huber's costs of long residuals over those of the weighted ones, of the last `reduce`."""
        del state
        if huber <= 0:
            return 0.0
        return float(sum(self.runner.product("up", self.formed, t)["numbers"][2] for t in range(len(self.network.tree))))

    def trial(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, passing: bool = False
    ) -> tuple[State, float] | int:
        """Solve from the root to the leaves, move and evaluate; or the unknown that stops the elimination."""
        assert isinstance(state, PartsState)
        if self.failed() >= 0:
            return self.failed()
        network, how = self.network, Iteration(damping=damping, huber=huber, passing=passing)
        key, formed, parent = self.new_key(), self.formed, network.tree.parent.tolist()

        def task(t: int) -> dict[str, Array]:
            above = self.runner.product("state", key, parent[t]) if parent[t] >= 0 else None
            own = self.runner.product("up", formed, t)
            return sweeps.down(network, t, self.work(t), self.part_state(state, t), how, own, above)

        order = range(len(network.tree) - 1, -1, -1)
        self.runner.sweep("state", key, task, order)
        found = [self.runner.product("state", key, t) for t in range(len(network.tree))]
        step = np.zeros(int(network.skeleton.system.offsets[-1]))
        for t, f in enumerate(found):
            front = network.fronts[t]
            step[sweeps.rows_of(network, front.own)] = f["step"][: front.columns]
        skeleton = network.skeleton
        e = skeleton.normals.standardised(state)
        moved = e.residual.copy()
        if len(moved):
            np.add.at(moved, e.row, e.value * step[e.unknown])
        outer = 0.5 * float(moved @ skeleton.system.extra.weighted(moved))
        points = np.zeros_like(state.xyz)
        with_node = np.flatnonzero(skeleton.system.point_node >= 0)
        at = skeleton.system.offsets[skeleton.system.point_node[with_node]][:, None] + np.arange(3)
        points[with_node] = step[at]
        s = skeleton.system.updated(state, step, points, passing=passing)
        new = PartsState(s.rotation, s.centre, s.interior, s.xyz, s.own, key=key)
        numbers = np.array([f["numbers"] for f in found])
        outer_cost, _ = skeleton.normals.cost(new)
        self.ready = key, outer_cost + float(numbers[:, 1].sum()), int(numbers[:, 2].sum())
        return new, outer + float(numbers[:, 0].sum())

    def cost(self, state: State, *, huber: float = 0.0) -> tuple[float, int]:
        """Half the weighted square sum of the last trial, and the observations behind the camera."""
        del huber
        assert isinstance(state, PartsState)
        if state.key != self.ready[0]:
            raise ValueError("the cost of a state that is not the last trial")
        return self.ready[1:]

    def evaluated(self, state: PartsState, huber: float) -> tuple[float, int]:
        """Half the weighted square sum at any state, and the observations behind the camera."""
        total, behind = self.network.skeleton.normals.cost(state)
        for t in range(len(self.network.tree)):
            work = self.work(t)
            if work is not None:
                cost, wrong = work.normals.cost(sweeps.state_of(work, self.part_state(state, t)), huber=huber)
                total, behind = total + cost, behind + wrong
        return total, behind

    # -- the factor

    def new_key(self) -> str:
        """The name of a new state."""
        self.count += 1
        return str(self.count)

    def hold(self, held: Mask) -> None:
        """Hold these coordinates (p, 3) of the whole network, those of control among them."""
        for work in self._works():
            work.normals.hold(held[work.part.points] & work.of.system.points_used[:, None])
        skeleton = self.network.skeleton
        skeleton.normals.hold(held[skeleton.points] & (skeleton.system.point_node >= 0)[:, None])

    def diagonal(self) -> Array:
        """(N,) undamped diagonal of the normal matrix of all nodes, before anything is eliminated."""
        found = self.network.skeleton.normals.diagonal.copy()
        for t, front in enumerate(self.network.fronts):
            touched = self.runner.product("up", self.formed, t)["touched"]
            found[sweeps.rows_of(self.network, front.nodes)] += touched
        return found

    def least_share(self) -> tuple[float, int]:
        """The least share of an unknown's information that elimination left over, and the unknown."""
        found = [self.runner.product("up", self.formed, t) for t in range(len(self.network.tree))]
        shares = [float(f["numbers"][3]) for f in found]
        at = int(np.argmin(shares))
        return shares[at], int(found[at]["least"])

    def solved(
        self, nodes: Array, points: Callable[[PartWork], Array] | None = None, state: PartsState | None = None
    ) -> Array:
        """The nodes' part (N, k) of N^-1 applied to right sides, with the last factor.

        nodes   (N, k) of nodes
        points  of a part: (p, 3, k) of the object points that it eliminates, at a state
        """
        network, formed, tree = self.network, self.formed, self.network.tree
        parent = tree.parent.tolist()

        def rising(t: int) -> dict[str, Array]:
            work = self.work(t)
            condensed = None
            if work is not None and points is not None and state is not None:
                now = sweeps.state_of(work, self.part_state(state, t))
                work.normals.refresh_external(now)
                condensed = work.normals.solver.condense(
                    *work.normals.arguments(now), 1, points(work), nodes.shape[1]
                )
            below = {c: self.runner.product("right", formed, c) for c in tree.children[t]}
            own = self.runner.product("up", formed, t)
            return sweeps.right_up(network, t, own, nodes, None if condensed is None else (work, condensed), below)

        def falling(t: int) -> dict[str, Array]:
            above = self.runner.product("solution", formed, parent[t]) if parent[t] >= 0 else None
            own, mine = self.runner.product("up", formed, t), self.runner.product("right", formed, t)
            return sweeps.right_down(network, t, own, mine, above)

        self.runner.sweep("right", formed, rising, range(len(tree)))
        self.runner.sweep("solution", formed, falling, range(len(tree) - 1, -1, -1))
        found = np.zeros_like(nodes)
        for t, front in enumerate(network.fronts):
            x = self.runner.product("solution", formed, t)["x"]
            found[sweeps.rows_of(network, front.own)] = x[: front.columns]
        self.runner.forget("right", formed)
        self.runner.forget("solution", formed)
        return found

    def selected_inverse(self) -> Array:
        """The inverse at the skeleton's blocks; that of the parts' own is kept (`part_inverse`)."""
        network, formed, parent = self.network, self.formed, self.network.tree.parent.tolist()

        def falling(t: int) -> dict[str, Array]:
            above = self.runner.product("inverse", formed, parent[t]) if parent[t] >= 0 else None
            return sweeps.inverse_down(network, t, self.work(t), self.runner.product("up", formed, t), above)

        self.runner.sweep("inverse", formed, falling, range(len(network.tree) - 1, -1, -1))
        found = np.zeros_like(network.skeleton.normals.values)
        for t in range(len(network.tree)):
            f = self.runner.product("inverse", formed, t)
            found[network.outside_places(t)[2]] = f["outside"]
        return found

    def part_inverse(self, t: int) -> Array:
        """The inverse in the layout of a part's normal matrix, of the last `selected_inverse`."""
        return self.runner.product("inverse", self.formed, t)["part"]

    # -- points that go astray

    def before(self, state: State) -> State:
        """The state with points before their cameras that all of these see behind; the same one where none is."""
        raise NotImplementedError

    def beyond(self, state: State) -> Index:
        """Object points whose rays diverge."""
        raise NotImplementedError
