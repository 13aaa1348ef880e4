"""Sweeps over the tree, a task for each of its nodes: up, down, cofactors.

Each is a function of a network, a tree node and products, by name, of others; it writes nothing, its product is kept by
whoever runs it.  Sums over tree nodes are the driver's, in the order of the nodes: so all is the same to the last bit,
whoever does which task when.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.system.assemble import State
from raybundle.blocking import front as fronts
from raybundle.blocking.front import Equations
from raybundle.blocking.network import Network, PartWork
from raybundle.numerics.arrays import Array, Index

Values = Mapping[str, Array]
"""Product of a task."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Iteration:
    """How a step is taken."""

    damping: float = 0.0
    huber: float = 0.0
    passing: bool = False
    added: float = 0.0
    """Share of the diagonal that is added to that of the nodes alone, in place of a damping"""


def state_of(work: PartWork, kept: Values | None) -> State:
    """Values of a part's unknowns, as a task kept them; None: those that were given."""
    if kept is None:
        return work.of.system.initial_state()
    return State(kept["rotation"], kept["centre"], kept["interior"], kept["xyz"])


def kept_state(state: State) -> dict[str, Array]:
    """A state as a task keeps it."""
    return {"rotation": state.rotation, "centre": state.centre, "interior": state.interior, "xyz": state.xyz}


def up(
    network: Network, t: int, work: PartWork | None, state: Values | None, how: Iteration, outside: Values,
    children: Mapping[int, Values],
) -> dict[str, Array]:  # fmt: skip
    """Reduce the part, eliminate the tree node's own unknowns.

    What gives no factor states at which unknown of the network (`failed`, else -1).

    state     of the part; None: as given
    outside   what the skeleton's normal equations bring to the front (`Network.outside_of`)
    children  what this gave of the tree nodes below
    """
    front = network.fronts[t]
    e, numbers, weak = Equations.empty(front), np.array([0.0, 0.0, 0.0, 1.0]), np.zeros(0, np.int64)
    if work is not None:
        normals, now = work.normals, state_of(work, state)
        cost, behind, alone = normals.reduce(now, damping=how.damping, huber=how.huber)
        numbers[:3] = cost, behind, normals.excess(now, how.huber)
        weak = work.part.points[alone]
        _unheld(work)
        e.add(work.into, normals.values)
        e.right[work.place] += normals.right
        e.diagonal[work.place] += normals.diagonal
    reported = {"numbers": numbers, "weak": weak, "touched": e.diagonal.copy()}
    failed = max((int(c["failed"]) for c in children.values()), default=-1)
    if failed >= 0:
        return {"failed": np.array(failed), **reported}
    network.add_outside(t, e, outside["values"], outside["right"], outside["diagonal"])
    for c, below in children.items():
        at = front.unknowns(network.boundary[c])
        e.add_reduced(at, below["reduced"])
        e.right[at] += below["right"]
        e.diagonal[at] += below["diagonal"]
    o = front.columns
    found = fronts.eliminate(e, how.added or how.damping)
    if found.failed >= 0:
        return {"failed": np.array(_global(network, t, found.failed)), **reported}
    share = np.diagonal(found.L) ** 2 / np.maximum(e.diagonal[:o], 1e-300)
    least = int(share.argmin()) if o else -1
    numbers[3] = share[least] if o else 1.0
    return {
        "L": fronts.packed(found.L), "V": found.V, "y": found.y, "reduced": fronts.packed(found.reduced),
        "right": found.right,
        "diagonal": e.diagonal[o:].copy(), "failed": np.array(-1),
        "least": np.array(_global(network, t, least) if o else -1), **reported,
    }  # fmt: skip


def _global(network: Network, t: int, unknown: int) -> int:
    """Unknown of the network that one of a front is."""
    front = network.fronts[t]
    k = int(np.searchsorted(front.starts, unknown, side="right")) - 1
    return int(network.skeleton.system.offsets[front.nodes[k]] + unknown - front.starts[k])


def _unheld(work: PartWork) -> None:
    """Take the ones off the diagonal that stand for held coordinates: the skeleton brings them."""
    normals, system = work.normals, work.of.system
    point, axis = np.nonzero(system.held & (system.point_node >= 0)[:, None])
    for node, a in zip(system.point_node[point].tolist(), axis.tolist(), strict=True):
        normals.values[normals.solver.block_start(normals.solver.block(node, node)) + 4 * a] = 0.0


def down(
    network: Network, t: int, work: PartWork | None, state: Values | None, how: Iteration, own: Values,
    above: Values | None,
) -> dict[str, Array]:  # fmt: skip
    """Solve for the own unknowns and the part's object points, move, and evaluate the new state.

    own    what `up` gave of this tree node
    above  what this gave of its parent; None: the root
    """
    step = _with_boundary(network, t, own, None if above is None else above["step"], own["y"])
    if work is None:
        return {"step": step, "numbers": np.zeros(3)}
    now, normals = state_of(work, state), work.normals
    mine = np.ascontiguousarray(step[work.place])
    points = np.zeros_like(now.xyz)
    normals.refresh_external(now)
    linear = normals.solver.back_substitute(*normals.arguments(now), how.huber, how.damping, 1, mine, points)
    moved = work.of.system.updated(now, mine, points, passing=how.passing)
    cost, behind = normals.cost(moved, huber=how.huber)
    return {"step": step, "numbers": np.array([float(linear), cost, behind]), **kept_state(moved)}


def _with_boundary(network: Network, t: int, own: Values, above: Array | None, y: Array) -> Array:
    """A solution (n,) or (n, k) of a front with that of its parent's."""
    if above is None:
        return fronts.solved(fronts.unpacked(own["L"]), own["V"], y, y[:0])
    parent = network.fronts[int(network.tree.parent[t])]
    boundary = above[parent.unknowns(network.boundary[t])]
    return np.concatenate([fronts.solved(fronts.unpacked(own["L"]), own["V"], y, boundary), boundary])


def condensed(work: PartWork, state: State, points: Array) -> Array:
    """What right sides (p, 3, k) of a part's eliminated object points bring to its unknowns (u, k)."""
    system = work.of.system
    points = points * ((system.point_node < 0)[:, None] & ~system.held)[:, :, None]
    work.normals.refresh_external(state)
    return work.normals.condensed(state, points)


def right_up(
    network: Network, t: int, own: Values, nodes: Array, condensed: tuple[PartWork | None, Array] | None,
    children: Mapping[int, Values],
) -> dict[str, Array]:  # fmt: skip
    """Right sides (u, k) of the own unknowns, reduced: the first half of a solution.

    own        what `up` gave of this tree node
    condensed  the part, and what right sides of its object points bring to its nodes
    children   what this gave of the tree nodes below
    """
    front = network.fronts[t]
    right = np.zeros((front.size, nodes.shape[1]))
    right[: front.columns] += nodes
    if condensed is not None and condensed[0] is not None:
        right[condensed[0].place] += condensed[1]
    for c, below in children.items():
        right[front.unknowns(network.boundary[c])] += below["right"]
    y = fronts.forward(fronts.unpacked(own["L"]), right[: front.columns])
    return {"y": y, "right": right[front.columns :] - own["V"] @ y}


def right_down(network: Network, t: int, own: Values, mine: Values, above: Values | None) -> dict[str, Array]:
    """The second half; mine: what `right_up` gave of this tree node."""
    return {"x": _with_boundary(network, t, own, None if above is None else above["x"], mine["y"])}


def rows_of(network: Network, nodes: Index) -> Index:
    """Unknowns of nodes among all of the network, one node behind the other."""
    offsets = network.skeleton.system.offsets
    return fronts.spread(offsets[nodes], network.skeleton.system.sizes[nodes].astype(np.int64))


def inverse_down(
    network: Network, t: int, work: PartWork | None, own: Values, boundary: Array
) -> dict[str, Array]:  # fmt: skip
    """The inverse of a front, as far as it is asked for: by the skeleton, the part, the tree nodes below.

    own       what `up` gave of this tree node
    boundary  what this gave of the parent for this tree node (`below`); empty: the root
    """
    front = network.fronts[t]
    Q = fronts.cofactors(fronts.unpacked(own["L"]), own["V"], fronts.unpacked(boundary))
    row, col, _ = network.outside_places(t)
    found = {"outside": _lower(Q, row, col)}
    for c in network.tree.children[t]:
        found[below(c)] = fronts.packed_at(Q, front.unknowns(network.boundary[c]))
    if work is not None:
        found["part"] = Q[work.elements]
    return found


def below(t: int) -> str:
    """Name of the array with the inverse of a tree node's boundary, packed, in its parent's product."""
    return f"Q {t}"


def _lower(Q: Array, row: Index, col: Index) -> Array:
    """Elements of a symmetric matrix of which the lower triangle counts."""
    return Q[np.maximum(row, col), np.minimum(row, col)]
