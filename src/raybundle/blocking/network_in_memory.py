"""A network in parts that lies in memory as a whole: what the adjustment takes for its normal equations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Self

import numpy as np

from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.datum import Transformation
from raybundle.adjustment.system.normals import Normals
from raybundle.blocking import answers, sweeps
from raybundle.blocking.network_store import from_lists, lists
from raybundle.blocking.normals import Parts, PartsNormals, PartsState
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index, Mask

NOTHING = np.zeros(0)


@dataclass(frozen=True, slots=True)
class Touched:
    """By tree node, which of the whole its part touches."""

    images: tuple[Index, ...]
    points: tuple[Index, ...]
    interior: tuple[Index, ...]
    rows: tuple[Index, ...]
    """Positions in `System.rows` of its image observations, in its order"""


@dataclass(slots=True)
class WholeNormals(Normals):
    """The normal equations of a system whose parts are reduced one by one; equal to those in one piece.

    `values` and `selected_inverse` hold the blocks that observations outside the images and statistics ask for, no
    others.  Whatever asks for a part is a task: who does the tasks may stand elsewhere.
    """

    parts: PartsNormals = field(kw_only=True)
    touched: Touched = field(kw_only=True)
    asked: PartsState | None = field(default=None, kw_only=True)
    """The last state that was asked for, as the parts have it"""
    scattered: tuple[State, PartsState] | None = field(default=None, kw_only=True)
    """The last one that was handed to the parts"""
    tried: list[tuple[State, PartsState]] = field(default_factory=list[tuple[State, PartsState]], kw_only=True)
    """Trials that the parts still have"""

    @classmethod
    def whole(cls, system: System, parts: Parts) -> Self:
        """Of a system and the network that its block was cut into."""
        own = parts.network.skeleton.normals
        found = cls(
            system=system, solver=own.solver, threads=1, values=np.zeros_like(own.values),
            right=np.zeros_like(own.right), diagonal=np.zeros_like(own.diagonal), external=np.zeros(0, bool),
            parts=PartsNormals(parts, system.observations, system.unknowns), touched=_touched(system, parts),
        )  # fmt: skip
        found.hold(system.held)
        return found

    # -- states

    def _scatter(self, state: State) -> PartsState:
        """A state as the parts keep it."""
        parts, touched = self.parts, self.touched
        keys = [""] * len(parts.network.tree)
        for t, (images, points) in enumerate(zip(touched.images, touched.points, strict=True)):
            if len(images):
                interior = state.interior[touched.interior[t]]
                mine = State(state.rotation[images], state.centre[images], interior, state.xyz[points])
                keys[t] = parts.parts.put("state", sweeps.kept_state(mine))
        at = parts.network.skeleton.points
        return PartsState(state.rotation, state.centre, state.interior, state.xyz[at], state.own, keys=tuple(keys))

    def _gathered(self, state: PartsState) -> State:
        """A trial of the parts as a whole."""

        def find() -> dict[str, Array]:
            xyz = np.zeros((len(self.system.block.points), 3))
            for points, f in zip(self.touched.points, self.of_each(state.keys, "xyz"), strict=True):
                if len(points):
                    xyz[points] = f["xyz"]
            return {"xyz": xyz}

        xyz = self.parts.parts.noted("moved", state.keys, find)["xyz"]
        skeleton = self.parts.network.skeleton
        with_node = skeleton.system.point_node >= 0
        xyz[skeleton.points[with_node]] = state.xyz[with_node]
        return State(state.rotation, state.centre, state.interior, xyz, state.own)

    def of_each(self, keys: Sequence[str], *names: str) -> list[dict[str, Array]]:
        """Arrays of planned products, of the tree nodes that have a part."""
        parts = self.parts.parts
        parts.do(keys)
        return [
            parts.store.lent(k, names) if len(points) else {}
            for k, points in zip(keys, self.touched.points, strict=True)
        ]

    def kept_state(self, state: State) -> PartsState:
        """The parts' state of a whole one; the last one that was handed to them and the last trials are known."""
        self.tried = [at for at in self.tried if at[1].keys in self.parts.trials]
        for at in (*self.tried, *([] if self.scattered is None else [self.scattered])):
            if at[0] is state:
                self.asked = at[1]
                return at[1]
        if self.scattered is not None:
            self.parts.parts.forget(self.scattered[1].keys)
        self.scattered = state, self._scatter(state)
        self.asked = self.scattered[1]
        return self.asked

    # -- the iteration

    def hold(self, held: Mask) -> None:
        """Hold these coordinates (p, 3), those of control among them."""
        self.system.held = held
        self.parts.hold(held)

    def reduce(self, state: State, *, damping: float = 0.0, huber: float = 0.0) -> tuple[float, int, list[int]]:
        """Reduce and eliminate the parts."""
        found = self.parts.reduce(self.kept_state(state), damping=damping, huber=huber)
        self.diagonal[:] = self.parts.diagonal()
        return found

    def trial(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, passing: bool = False
    ) -> tuple[State, float] | int:
        """The state after a step, after `reduce`, and its linearised cost."""
        found = self.parts.trial(self.kept_state(state), damping=damping, huber=huber, passing=passing)
        if isinstance(found, int):
            return found
        new, linear = found
        assert isinstance(new, PartsState)
        whole = self._gathered(new)
        self.tried.append((whole, new))
        return whole, linear

    def cost(self, state: State, *, huber: float = 0.0) -> tuple[float, int]:
        """Half the weighted square sum, and the observations behind the camera."""
        of = self.kept_state(state)
        if of.keys == self.parts.tried[0]:
            return self.parts.cost(of, huber=huber)
        keys = self.parts.parts.each("evaluate", lambda t: self._evaluated(t, of, huber), lambda o: (o.state,))

        def find() -> dict[str, Array]:
            found = self.parts.parts.made(keys)
            self.parts.parts.forget(keys)
            return {"numbers": np.array([f["numbers"] for f in found])}

        numbers = self.parts.parts.noted("evaluated", keys, find)["numbers"]
        total, behind = self.parts.network.skeleton.normals.cost(of)
        return total + float(numbers[:, 0].sum()), behind + int(numbers[:, 1].sum())

    def _evaluated(self, t: int, of: PartsState, huber: float = 0.0) -> answers.Evaluated:
        return answers.Evaluated(network=self.parts.network.key, node=t, state=of.keys[t], huber=huber)

    def residuals(self, state: State) -> tuple[Array, Array]:
        """Whitened residuals (m, 2) and flags (m,), as of one piece."""
        of, parts = self.kept_state(state), self.parts.parts
        keys = parts.each("residuals", lambda t: self._evaluated(t, of), lambda o: (o.state,))

        def find() -> dict[str, Array]:
            v = large.zeros((len(self.system.rows), 2))
            flags = np.zeros(len(self.system.rows), np.uint8)
            for rows, f in zip(self.touched.rows, self.of_each(keys), strict=True):
                if len(rows):
                    v[rows], flags[rows] = f["v"], f["flags"]
            parts.forget(keys)
            return {"v": v, "flags": flags}

        found = parts.noted("residuals", keys, find)
        return found["v"], found["flags"]

    # -- the factor

    def factorise(self, added: Array = NOTHING) -> int:
        """Whether the last `reduce` gave a factor: 0, or 1 + the unknown that fails.

        added  a share of the diagonal; the parts of the state that was last asked for are reduced once more with it
        """
        if len(added):
            assert self.asked is not None
            share = float((added / np.maximum(self.diagonal, 1e-300)).max())
            self.parts.reduce(self.asked, added=share)
        return self.parts.failed() + 1

    def least_share(self) -> tuple[float, int]:
        """The least share of an unknown's information that the factor found left over, and the unknown."""
        return self.parts.least_share()

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
        right[self.held_unknowns()] = 0.0

        # the factor is that of these values; under which keys they were kept when it was made, they may be gone
        self.parts.at = self.kept_state(state)
        keys = self.handed(points)
        found = self.parts.solved(right, keys)
        self.parts.parts.forget(keys)
        return found

    def handed(self, points: Array) -> list[str]:
        """Values (p, 3, k) of the object points as products of the parts; "" where there is none."""
        put = self.parts.parts.put
        return [put("points", {"points": points[mine]}) if len(mine) else "" for mine in self.touched.points]

    def solve_points(self, state: State, nodes: Array, points: Array) -> Array:
        """The points' part (p, 3, k) that belongs to the nodes' part (N, k) of a solution."""
        system, of, points, parts = self.system, self.kept_state(state), self._free_rows(points), self.parts.parts
        given, right = self.handed(points), parts.put("nodes", {"nodes": nodes})

        def options(t: int) -> answers.Expanded:
            return answers.Expanded(
                network=self.parts.network.key, node=t, state=of.keys[t], held=self.parts.held, nodes=right,
                points=given[t],
            )  # fmt: skip

        keys = parts.each("expand", options, lambda o: (o.state,))

        def find() -> dict[str, Array]:
            found = large.zeros(points.shape)
            for mine, f in zip(self.touched.points, self.of_each(keys), strict=True):
                if len(mine):
                    found[mine] = f["points"]
            parts.forget(keys)
            return {"points": found}

        found = parts.noted("expanded", keys, find)["points"]
        parts.forget([*given, right])
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
        of, parts, changes = self.kept_state(state), self.parts.parts, change is not None
        p, m, d = len(state.xyz), len(self.system.rows), 0 if change is None else change.nodes.shape[1]
        by, generators = "", [""] * len(self.touched.points)
        if change is not None:
            by = parts.put("change", {"nodes": change.nodes, "H": change.nodes_h, "middle": change.middle})
            generators = [
                parts.put("generators", {"G": change.points[mine], "points": change.given[mine]}) if len(mine) else ""
                for mine in self.touched.points
            ]

        def options(t: int) -> answers.StatisticsInput:
            return answers.StatisticsInput(
                network=self.parts.network.key, node=t, state=of.keys[t], held=self.parts.held, change=by,
                inverse=self.parts.inverses[t], generators=generators[t],
            )  # fmt: skip

        keys = parts.each("statistics", options, lambda o: (o.state, o.inverse))

        def find() -> dict[str, Array]:
            found = {
                "points": large.zeros((p, 3, 3)), "hat": large.zeros((m, 3)), "effect": large.zeros((m, 3, 2)),
                "H": large.zeros((p, 3, d)),
            }  # fmt: skip
            for at, rows, f in zip(self.touched.points, self.touched.rows, self.of_each(keys), strict=True):
                if len(at):
                    found["points"][at], found["hat"][rows], found["effect"][rows] = f["points"], f["hat"], f["effect"]
                if len(at) and changes:
                    found["H"][at] = f["H"]
            parts.forget(keys)
            return found

        found = parts.noted("statistics", keys, find)
        parts.forget([by, *generators])
        return found["points"], found["hat"], found["effect"], found["H"]


def _touched(system: System, parts: Parts) -> Touched:
    """What the parts touch; known without making them anew."""
    place = np.full(len(system.block.observations), -1, np.int32)
    place[system.rows] = np.arange(len(system.rows))
    keys = parts.each("touched", lambda t: answers.Described(network=parts.network.key, node=t, state=""), lambda _: ())

    def find() -> dict[str, Array]:
        found = parts.made(keys)
        return {n: v for name in ("images", "points", "interior", "rows")
                for n, v in lists(name, [f[name] for f in found]).items()}  # fmt: skip

    noted = parts.noted("touched", keys, find)
    images, points, interior, rows = (from_lists(name, noted) for name in ("images", "points", "interior", "rows"))
    return Touched(images, points, interior, tuple(place[r] for r in rows))
