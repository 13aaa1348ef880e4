"""The normal equations of a network in parts: which tasks there are, and what the iteration makes of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from raybundle.adjustment.system.assemble import State
from raybundle.blocking import sweeps, tasks
from raybundle.blocking.network import Network
from raybundle.blocking.store import VERSION, Store
from raybundle.blocking.tasks import Known, remember
from raybundle.errors import as_error
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.pipeline.executors import Executor
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.tasks import Task


@dataclass(slots=True)
class PartsState(State):
    """Values of a network in parts: those of the skeleton, and the products that hold those of the parts."""

    keys: tuple[str, ...] = ()
    """By tree node; "": as given"""


@dataclass(slots=True)
class Parts:
    """A network in parts and who does its tasks: one sweep after the other, each product kept by its key."""

    network: Network
    store: Store
    executor: Executor
    begin: Callable[[], None] = lambda: None
    """Called before tasks are done: puts the parts where tasks find them, if they are not there"""
    notes: Store | None = None
    """Where the numbers of each sweep stay by which a run that is started again need not do it once more; None:
    nowhere"""
    known: Known = field(init=False)
    """The network as tasks in this process find it, for as long as this is there"""
    planned: dict[str, Task] = field(default_factory=dict[str, Task])
    """How each product of this run is made"""

    def __post_init__(self) -> None:
        """Make the network known to tasks in this process."""
        self.known = remember(self.network)

    def plan(
        self, name: str, options: Callable[[int, dict[int, str]], Any], inputs: Callable[[Any], Sequence[str]],
        *, upwards: bool, module: str = "tasks", wider: float = 1.0,
    ) -> tuple[str, ...]:  # fmt: skip
        """A task for each tree node, children first or parents first; keys of their products by tree node.

        options  of a tree node's task, given the keys of those before
        inputs   products that its options name
        module   where the task's function stands
        """
        count = len(self.network.tree)
        keys = dict[int, str]()
        for t in range(count) if upwards else range(count - 1, -1, -1):
            o = options(t, keys)
            keys[t] = key_of(name, VERSION, o)
            front = self.network.fronts[t]
            task = Task(
                key=keys[t], function=f"raybundle.blocking.{module}:{name}", options=o,
                inputs=tuple(k for k in inputs(o) if k), cost=1e-9 * front.size**2 * max(front.columns, 1),
                memory=wider * (24.0 * front.size**2 + 250.0 * float(self.network.counts[t])), name=f"{name} {t}",
            )  # fmt: skip
            self.planned[task.key] = task
        return tuple(keys[t] for t in range(count))

    def each(
        self, name: str, options: Callable[[int], Any], inputs: Callable[[Any], Sequence[str]],
        module: str = "answers", *, wider: float = 1.0,
    ) -> tuple[str, ...]:  # fmt: skip
        """A task of a module for each tree node, none behind another; keys of their products.

        wider  memory that it needs, over that of a sweep
        """
        return self.plan(name, lambda t, _: options(t), inputs, upwards=True, module=module, wider=wider)

    def do(self, keys: Sequence[str]) -> tuple[str, ...]:
        """Do planned tasks whose products are not there."""
        self.make([self.planned[k] for k in keys if not self.store.has(k)])
        return tuple(keys)

    def made(self, keys: Sequence[str], *names: str) -> list[dict[str, Array]]:
        """Products of planned tasks, or some of their arrays; those that are not there are made."""
        return [self.store.wanted(key, names) for key in self.do(keys)]

    def noted(self, name: str, about: object, find: Callable[[], dict[str, Array]]) -> dict[str, Array]:
        """What was found about these products before, by this run or one that was cut short; else it is found and kept.

        Large arrays lie where large arrays do (`numerics.large`).
        """
        if self.notes is None:
            return find()
        key = key_of(name, VERSION, about)
        if self.notes.has(key):
            return {n: _own(values) for n, values in self.notes.lent(key).items()}
        found = find()
        self.notes.store(key, found)
        return found

    def make(self, wanted: Sequence[Task]) -> None:
        """Do tasks, and first those whose products they need and that are gone."""
        order = dict[str, Task]()

        def need(task: Task) -> None:
            for key in task.inputs:
                if key in self.planned and key not in order and not self.store.has(key):
                    need(self.planned[key])
            order[task.key] = task

        for task in wanted:
            if task.key not in order:
                need(task)
        if not order:
            return
        self.begin()
        for done in self.executor.run(list(order.values()), self.store):  # pyright: ignore[reportArgumentType]
            if done.failed:
                raise as_error(done.failed)

    def forget(self, keys: Sequence[str]) -> None:
        """Let products go."""
        for key in keys:
            self.store.forget(key)

    def put(self, name: str, product: dict[str, Array]) -> str:
        """Keep a product of the driver; its key."""
        key = key_of(name, product)
        if not self.store.has(key):
            self.store.store(key, product)
        return key


@dataclass(slots=True)
class PartsNormals:
    """Normal equations in parts (`adjustment.system.solve.Equations`)."""

    parts: Parts
    observations: int
    unknowns: int
    """Before a datum is chosen"""
    held: str = ""
    """Product with the coordinates that carry a minimal datum"""
    formed: tuple[str, ...] = ()
    """Products of the last sweep up"""
    reported: dict[str, Array] = field(default_factory=dict[str, Array])
    """What it stated: numbers, undamped diagonal, where it fails, which unknown has least left"""
    at: PartsState | None = None
    """Its state"""
    inverses: tuple[str, ...] = ()
    """Products of the last inverse"""
    tried: tuple[tuple[str, ...], float, int] = ((), 0.0, 0)
    """Products, cost and observations behind the camera of the last trial"""
    trials: list[tuple[str, ...]] = field(default_factory=list[tuple[str, ...]])
    """Products of trials that are kept: the last one, and the one from which it went"""

    @property
    def network(self) -> Network:
        """What is cut into parts."""
        return self.parts.network

    def initial_state(self) -> PartsState:
        """Values as given."""
        s = self.network.skeleton.system.initial_state()
        return PartsState(s.rotation, s.centre, s.interior, s.xyz, s.own, keys=("",) * len(self.network.tree))

    # -- one step

    def reduce(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, added: float = 0.0
    ) -> tuple[float, int, list[int]]:
        """Reduce and eliminate, from the leaves to the root; `added` as in `Iteration`."""
        assert isinstance(state, PartsState)
        network, normals = self.network, self.network.skeleton.normals
        outer, _, _ = normals.reduce(state)
        outside = [self.parts.put("outside", network.outside_of(t)) for t in range(len(network.tree))]

        def options(t: int, keys: dict[int, str]) -> tasks.Up:
            return tasks.Up(
                network=network.key, node=t, state=state.keys[t], held=self.held, outside=outside[t], damping=damping,
                children=tuple(keys[c] for c in network.tree.children[t]), huber=huber, added=added,
            )  # fmt: skip

        def inputs(o: tasks.Up) -> Sequence[str]:
            return (o.state, *o.children)

        before, self.formed = self.formed, self.parts.plan("up", options, inputs, upwards=True)
        self.reported = self.parts.noted("reduced", self.formed, self._reduced)
        self.at = state
        self.parts.forget([k for k in (*before, *self.inverses) if k not in self.formed])
        self.inverses = ()
        numbers, weak = self.reported["numbers"], self.reported["weak"]
        return outer + float(numbers[:, 0].sum()), int(numbers[:, 1].sum()), [int(p) for p in weak]

    def _reduced(self) -> dict[str, Array]:
        """What the sweep up states as a whole; the diagonal is that of all nodes before anything is eliminated."""
        found = self.parts.made(self.formed, "numbers", "weak", "touched", "failed")
        diagonal = np.zeros(int(self.network.skeleton.system.offsets[-1]))
        for front, f in zip(self.network.fronts, found, strict=True):
            diagonal[sweeps.rows_of(self.network, front.nodes)] += f["touched"]
        numbers = np.array([f["numbers"] for f in found])
        failed = found[-1]["failed"]
        at = int(np.argmin(numbers[:, 3]))
        least = np.array(-1) if failed >= 0 else self.parts.store.wanted(self.formed[at], ("least",))["least"]
        weak = np.concatenate([np.asarray(f["weak"], np.int64) for f in found])
        return {"numbers": numbers, "weak": weak, "touched": diagonal, "failed": failed, "least": least}

    def failed(self) -> int:
        """The unknown that stops the elimination of the last `reduce`, -1: none."""
        return int(self.reported["failed"])

    def excess(self, state: State, huber: float) -> float:
        """Huber's costs of long residuals over those of the weighted ones, of the last `reduce`."""
        del state
        return float(self.reported["numbers"][:, 2].sum()) if huber > 0 else 0.0

    def trial(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, passing: bool = False
    ) -> tuple[State, float] | int:
        """Solve from the root to the leaves, move and evaluate; or the unknown that stops the elimination."""
        assert isinstance(state, PartsState)
        if self.failed() >= 0:
            return self.failed()
        network = self.network
        parent = network.tree.parent.tolist()

        def options(t: int, keys: dict[int, str]) -> tasks.Down:
            return tasks.Down(
                network=network.key, node=t, state=state.keys[t], held=self.held, up=self.formed[t], huber=huber,
                above=keys[parent[t]] if parent[t] >= 0 else "", damping=damping, passing=passing,
            )  # fmt: skip

        def inputs(o: tasks.Down) -> Sequence[str]:
            return o.state, o.up, o.above

        for before in self.trials:
            if before != state.keys:
                self.parts.forget(before)
        keys = self.parts.plan("down", options, inputs, upwards=False)
        self.trials = [t for t in self.trials if t == state.keys] + [keys]
        found = self.parts.noted("tried", keys, lambda: self._stepped(keys))
        step, numbers = found["step"], found["numbers"]
        new, outer = self._outer_step(state, step, passing=passing)
        new.keys = keys
        outer_cost, _ = network.skeleton.normals.cost(new)
        self.tried = keys, outer_cost + float(numbers[:, 1].sum()), int(numbers[:, 2].sum())
        return new, outer + float(numbers[:, 0].sum())

    def _stepped(self, keys: tuple[str, ...]) -> dict[str, Array]:
        """Step (N,) of the nodes, and numbers of each tree node."""
        found = self.parts.made(keys, "step", "numbers")
        step = np.zeros(int(self.network.skeleton.system.offsets[-1]))
        for front, f in zip(self.network.fronts, found, strict=True):
            step[sweeps.rows_of(self.network, front.own)] = f["step"][: front.columns]
        return {"step": step, "numbers": np.array([f["numbers"] for f in found])}

    def _outer_step(self, state: PartsState, step: Array, *, passing: bool) -> tuple[PartsState, float]:
        """The skeleton's values after a step (N,), and the linearised cost of its observations."""
        skeleton = self.network.skeleton
        system = skeleton.system
        e = skeleton.normals.standardised(state)
        moved = e.residual.copy()
        if len(moved):
            np.add.at(moved, e.row, e.value * step[e.unknown])
        points = np.zeros_like(state.xyz)
        with_node = np.flatnonzero(system.point_node >= 0)
        points[with_node] = step[system.offsets[system.point_node[with_node]][:, None] + np.arange(3)]
        s = system.updated(state, step, points, passing=passing)
        new = PartsState(s.rotation, s.centre, s.interior, s.xyz, s.own)
        return new, 0.5 * float(moved @ system.extra.weighted(moved))

    def cost(self, state: State, *, huber: float = 0.0) -> tuple[float, int]:
        """Half the weighted square sum of the last trial, and the observations behind the camera."""
        del huber
        assert isinstance(state, PartsState)
        if state.keys != self.tried[0]:
            raise ValueError("the cost of a state that is not the last trial")
        return self.tried[1:]

    # -- the factor

    def hold(self, held: Mask) -> None:
        """Hold these coordinates (p, 3) of the whole network, beside those of control."""
        point, axis = np.nonzero(held)
        self.held = self.parts.put("held", {"point": point, "axis": axis}) if len(point) else ""
        skeleton = self.network.skeleton
        mine = held[skeleton.points] & (skeleton.system.point_node >= 0)[:, None]
        skeleton.normals.hold(skeleton.system.control_held | mine)

    def diagonal(self) -> Array:
        """(N,) undamped diagonal of the normal matrix of all nodes, before anything is eliminated."""
        return self.network.skeleton.normals.diagonal + self.reported["touched"]

    def least_share(self) -> tuple[float, int]:
        """The least share of an unknown's information that elimination left over, and the unknown."""
        return float(self.reported["numbers"][:, 3].min()), int(self.reported["least"])

    def solved(self, nodes: Array, points: Sequence[str] = ()) -> Array:
        """The nodes' part (N, k) of N^-1 applied to right sides, with the last factor.

        nodes   (N, k) of nodes
        points  by tree node, products with those (p, 3, k) of the object points that its part eliminates
        """
        network, state = self.network, self.at
        assert state is not None
        parent = network.tree.parent.tolist()
        given = [self.parts.put("given", {"nodes": nodes[sweeps.rows_of(network, f.own)]}) for f in network.fronts]

        def rising(t: int, keys: dict[int, str]) -> tasks.RightUp:
            return tasks.RightUp(
                network=network.key, node=t, state=state.keys[t], held=self.held, up=self.formed[t], nodes=given[t],
                points=points[t] if points else "", children=tuple(keys[c] for c in network.tree.children[t]),
            )  # fmt: skip

        def rising_inputs(o: tasks.RightUp) -> Sequence[str]:
            return o.state, o.up, o.points, *o.children

        halves = self.parts.plan("right_up", rising, rising_inputs, upwards=True)

        def falling(t: int, keys: dict[int, str]) -> tasks.RightDown:
            above = keys[parent[t]] if parent[t] >= 0 else ""
            return tasks.RightDown(network=network.key, node=t, up=self.formed[t], right=halves[t], above=above)

        def falling_inputs(o: tasks.RightDown) -> Sequence[str]:
            return o.up, o.right, o.above

        keys = self.parts.plan("right_down", falling, falling_inputs, upwards=False)

        def find() -> dict[str, Array]:
            found = np.zeros_like(nodes)
            for front, key in zip(network.fronts, self.parts.do(keys), strict=True):
                found[sweeps.rows_of(network, front.own)] = self.parts.store.lent(key, ("x",))["x"][: front.columns]
            return {"x": found}

        found = self.parts.noted("solved", keys, find)["x"]
        self.parts.forget([*halves, *keys, *given])
        return found

    def selected_inverse(self) -> Array:
        """The inverse at the skeleton's blocks; that of the parts' own is kept (`part_inverse`)."""
        network = self.network
        parent = network.tree.parent.tolist()

        def falling(t: int, keys: dict[int, str]) -> tasks.Inverse:
            above = keys[parent[t]] if parent[t] >= 0 else ""
            return tasks.Inverse(network=network.key, node=t, up=self.formed[t], above=above)

        def inputs(o: tasks.Inverse) -> Sequence[str]:
            return o.up, o.above

        keys = self.inverses = self.parts.plan("inverse", falling, inputs, upwards=False)

        def find() -> dict[str, Array]:
            found = np.zeros_like(network.skeleton.normals.values)
            for t, f in enumerate(self.parts.made(keys, "outside")):
                found[network.outside_places(t)[2]] = f["outside"]
            return {"outside": found}

        return self.parts.noted("outside", keys, find)["outside"]

    # -- points that go astray: they are reported to the caller (`stored`)

    def before(self, state: State) -> State:
        """The state as it is: points behind their cameras are not moved."""
        return state

    def beyond(self, state: State) -> Index:
        """Not looked for."""
        del state
        return np.zeros(0, np.int64)


def _own(values: Array) -> Array:
    """An array of one's own."""
    found = large.zeros(values.shape, values.dtype)
    found[...] = values
    return found
