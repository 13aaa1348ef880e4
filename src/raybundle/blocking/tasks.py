"""The sweeps as tasks (`raybundle.pipeline.tasks`): what another process can do with nothing but the store.

Options name products by their keys, a network by that of its own: so a task's key is the hash of everything that its
product depends on, and whoever finds the product there need not make it.
"""

from __future__ import annotations

from collections import OrderedDict, deque
from dataclasses import dataclass, field
from threading import RLock
from typing import Protocol
from weakref import WeakValueDictionary

import numpy as np

from raybundle.adjustment.statistics.field_system import WideNormals
from raybundle.adjustment.system.assemble import State
from raybundle.blocking import sweeps
from raybundle.blocking.network import Network, PartWork
from raybundle.blocking.store import Store
from raybundle.blocking.sweeps import Iteration, Values
from raybundle.pipeline.place import Product


@dataclass(slots=True, weakref_slot=True)
class Known:
    """A network in this process, and its parts that are ready for use."""

    network: Network
    works: OrderedDict[int, PartWork | None] = field(default_factory=OrderedDict[int, "PartWork | None"])
    held: dict[int, str] = field(default_factory=dict[int, str])
    """By part, the product whose coordinates are held in it"""
    wide: dict[int, tuple[object, WideNormals]] = field(default_factory=dict[int, "tuple[object, WideNormals]"])
    """Parts with the columns of fields that are ready for use, and what they were made for (`fields.wide_of`)"""


_known: WeakValueDictionary[str, Known] = WeakValueDictionary()
_read: deque[Known] = deque(maxlen=2)
"""Networks that this process read from a store, the latest ones: what others know, they hold themselves"""
_lock = RLock()


def remember(network: Network) -> Known:
    """Make a network known to this process, for as long as what is returned is held."""
    at = Known(network)
    with _lock:
        _known[network.key] = at
    return at


def known(store: Store, key: str) -> Known:
    """A network that this process knows, or reads from the store."""
    with _lock:
        at = _known.get(key)
        if at is None:
            from raybundle.blocking.network_store import network_of

            at = remember(network_of(store, key))
            _read.append(at)
        return at


def work_of(at: Known, t: int) -> PartWork | None:
    """The part of a tree node, ready for use; the ones used last stay so, as many as the network states."""
    with _lock:
        if t in at.works:
            at.works.move_to_end(t)
            return at.works[t]
    work = at.network.work(t)
    with _lock:
        at.works[t] = work
        at.held.pop(t, None)
        while len(at.works) > at.network.keep:
            at.held.pop(at.works.popitem(last=False)[0], None)
    return work


def held_work(store: Store, at: Known, t: int, key: str) -> PartWork | None:
    """The part with these coordinates held for the datum, "" for none."""
    work = work_of(at, t)
    if work is None or at.held.get(t, "") == key:
        return work
    system = work.of.system
    held = system.control_held.copy()
    if key:
        found = store.lent(key)
        place = np.minimum(np.searchsorted(work.part.points, found["point"]), len(work.part.points) - 1)
        mine = work.part.points[place] == found["point"]
        held[place[mine], found["axis"][mine]] = True
        held &= system.points_used[:, None]
    work.normals.hold(held)
    at.held[t] = key
    return work


def values_of(store: Store, key: str, work: PartWork | None) -> Values | None:
    """The values of a part's unknowns; None where there is no part, or they are as given."""
    return store.lent(key, ("rotation", "centre", "interior", "xyz")) if key and work is not None else None


class AtState(Protocol):
    """Options of a task that works on a part at a state."""

    @property
    def network(self) -> str:
        """Key of the network."""
        ...

    @property
    def node(self) -> int:
        """Tree node."""
        ...

    @property
    def state(self) -> str:
        """Product with the values of the part; "": as given."""
        ...


def part_at(store: Store, o: AtState, held: str | None = None) -> tuple[PartWork, State] | None:
    """The part of a task and its values; None where the tree node has no observations.

    held  product with the coordinates that carry a minimal datum; None: it does not matter
    """
    at = known(store, o.network)
    work = work_of(at, o.node) if held is None else held_work(store, at, o.node, held)
    return None if work is None else (work, sweeps.state_of(work, values_of(store, o.state, work)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Up:
    """What `sweeps.up` depends on."""

    network: str
    node: int
    """tree node"""
    state: str
    """"": as given"""
    held: str
    outside: str
    """What the skeleton's normal equations bring to the front"""
    children: tuple[str, ...]
    damping: float
    huber: float
    added: float


def _message(store: Store, key: str) -> Values:
    """What a parent needs of `up`: not the factor, which is larger."""
    failed = store.lent(key, ("failed",))
    return failed if int(failed["failed"]) >= 0 else {**failed, **store.lent(key, MESSAGE)}


def up(store: Store, o: Up) -> Product:
    """Reduce and eliminate."""
    at = known(store, o.network)
    children = at.network.tree.children[o.node]
    below = {c: _message(store, key) for c, key in zip(children, o.children, strict=True)}
    how = Iteration(damping=o.damping, huber=o.huber, added=o.added)
    work = held_work(store, at, o.node, o.held)
    return sweeps.up(at.network, o.node, work, values_of(store, o.state, work), how, store.lent(o.outside), below)


ELIMINATED = ("L", "V", "y")
"""What the way down needs of `up`."""
MESSAGE = ("reduced", "right", "diagonal")
"""What the parent needs of it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Down:
    """What `sweeps.down` depends on."""

    network: str
    node: int
    state: str
    held: str
    up: str
    above: str
    """Product of the parent; "": the root"""
    damping: float
    huber: float
    passing: bool


def down(store: Store, o: Down) -> Product:
    """Solve, move and evaluate."""
    at = known(store, o.network)
    how = Iteration(damping=o.damping, huber=o.huber, passing=o.passing)
    above = store.lent(o.above, ("step",)) if o.above else None
    own, work = store.lent(o.up, ELIMINATED), held_work(store, at, o.node, o.held)
    return sweeps.down(at.network, o.node, work, values_of(store, o.state, work), how, own, above)


@dataclass(frozen=True, slots=True, kw_only=True)
class RightUp:
    """What `sweeps.right_up` depends on."""

    network: str
    node: int
    state: str
    held: str
    up: str
    nodes: str
    """Right sides (u, k) of the own unknowns"""
    points: str
    """Those (p, 3, k) of the part's object points; "": none"""
    children: tuple[str, ...]


def right_up(store: Store, o: RightUp) -> Product:
    """Reduce right sides."""
    at = known(store, o.network)
    nodes, condensed = store.lent(o.nodes)["nodes"], None
    if o.points:
        mine = part_at(store, o, o.held)
        if mine is not None:
            condensed = mine[0], sweeps.condensed(*mine, store.lent(o.points, ("points",))["points"])
    children = at.network.tree.children[o.node]
    below = {c: store.lent(key, ("right",)) for c, key in zip(children, o.children, strict=True)}
    return sweeps.right_up(at.network, o.node, store.lent(o.up, ELIMINATED), nodes, condensed, below)


@dataclass(frozen=True, slots=True, kw_only=True)
class RightDown:
    """What `sweeps.right_down` depends on."""

    network: str
    node: int
    up: str
    right: str
    above: str


def right_down(store: Store, o: RightDown) -> Product:
    """The second half of a solution."""
    at = known(store, o.network)
    above = store.lent(o.above) if o.above else None
    return sweeps.right_down(at.network, o.node, store.lent(o.up, ELIMINATED), store.lent(o.right, ("y",)), above)


@dataclass(frozen=True, slots=True, kw_only=True)
class Inverse:
    """What `sweeps.inverse_down` depends on."""

    network: str
    node: int
    up: str
    above: str


def inverse(store: Store, o: Inverse) -> Product:
    """The inverse of a front."""
    at = known(store, o.network)
    mine = sweeps.below(o.node)
    boundary = store.lent(o.above, (mine,))[mine] if o.above else np.zeros(0)
    own = store.lent(o.up, ("L", "V"))
    return sweeps.inverse_down(at.network, o.node, work_of(at, o.node), own, boundary)
