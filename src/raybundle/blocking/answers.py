"""Tasks around the sweeps: what a part brings to counts and datum, and what comes of its observations and points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.statistics.precision import Cofactors
from raybundle.adjustment.statistics.reliability import image_statistics
from raybundle.adjustment.system import transformation
from raybundle.adjustment.system.assemble import State
from raybundle.adjustment.system.datum import Transformation, point_generators
from raybundle.adjustment.system.far_points import diverging
from raybundle.blocking import sweeps
from raybundle.blocking.network import PartWork
from raybundle.blocking.store import Store
from raybundle.blocking.tasks import known, part_at, work_of
from raybundle.numerics.arrays import Array, Mask
from raybundle.pipeline.place import Product

SAMPLE = 500
"""Object points of a part that stand for all of its own where the middle of the network is asked for."""
CANDIDATES = 60
"""Object points of a part that are offered to carry a minimal datum."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Described:
    """A part at a state."""

    network: str
    node: int
    state: str


def _mine(work: PartWork) -> Mask:
    """(p,) object points that the part eliminates."""
    system = work.of.system
    return system.points_used & (system.point_node < 0)


def describe(store: Store, o: Described) -> Product:
    """Counts of a part, points that stand for its own, and points that could carry a minimal datum."""
    found = part_at(store, o)
    if found is None:
        none = np.zeros((0, 3))
        return {
            "numbers": np.zeros(2), "sample": none, "candidates": np.zeros(0, np.int64), "xyz": none,
            "rays": np.zeros(0, np.int64),
        }  # fmt: skip
    work, now = found
    system = work.of.system
    mine = np.flatnonzero(_mine(work))
    free = int((~system.control_held[mine]).sum())
    rays = np.bincount(system.block.observations.point[system.rows], minlength=len(now.xyz))
    able = mine[~(system.control_held | system.prior)[mine].any(axis=1)]
    able = able[np.argsort(-rays[able], kind="stable")][:CANDIDATES]
    some = mine[:: max(1, len(mine) // SAMPLE)]
    return {
        "numbers": np.array([system.observations, free], float), "sample": now.xyz[some],
        "candidates": work.part.points[able], "xyz": now.xyz[able], "rays": rays[able],
    }  # fmt: skip


def touched(store: Store, o: Described) -> Product:
    """Images, object points and interior orientations that a part touches, and which image observations take part."""
    work = work_of(known(store, o.network), o.node)
    if work is None:
        none = np.zeros(0, np.int64)
        return {"images": none, "points": none, "interior": none, "rows": none}
    part, of = work.part, work.of
    return {"images": part.images, "points": part.points, "interior": of.interior, "rows": part.rows[of.system.rows]}


@dataclass(frozen=True, slots=True, kw_only=True)
class Evaluated:
    """A part's observations at a state."""

    network: str
    node: int
    state: str
    huber: float = 0.0


def evaluate(store: Store, o: Evaluated) -> Product:
    """Half the weighted square sum of a part, and its observations behind the camera."""
    found = part_at(store, o)
    return {"numbers": np.array((0.0, 0.0) if found is None else found[0].normals.cost(found[1], huber=o.huber))}


def residuals(store: Store, o: Evaluated) -> Product:
    """Whitened residuals (m, 2) and flags (m,) of a part's observations."""
    found = part_at(store, o)
    if found is None:
        return {"v": np.zeros((0, 2)), "flags": np.zeros(0, np.uint8)}
    v, flags = found[0].normals.residuals(found[1])
    return {"v": v, "flags": flags}


@dataclass(frozen=True, slots=True, kw_only=True)
class Expanded:
    """What the points' part of a solution depends on."""

    network: str
    node: int
    state: str
    held: str
    nodes: str
    """Product: the nodes' part (N, k)"""
    points: str
    """Product: right sides (p, 3, k) of the part's points"""


def expand(store: Store, o: Expanded) -> Product:
    """The points' part (p, 3, k) that belongs to the nodes' part of a solution."""
    found = part_at(store, o, o.held)
    if found is None:
        return {"points": np.zeros((0, 3, 0))}
    work, now = found
    at = sweeps.rows_of(known(store, o.network).network, work.of.nodes)
    nodes = np.ascontiguousarray(store.lent(o.nodes)["nodes"][at])
    return {"points": work.normals.solve_points(now, nodes, store.lent(o.points)["points"])}


@dataclass(frozen=True, slots=True, kw_only=True)
class Astray:
    """Which observations of a part have gone astray at a state."""

    network: str
    node: int
    state: str
    held: str
    typical: float
    """Distance of object points from projection centres, as of all"""


def astray(store: Store, o: Astray) -> Product:
    """Rows of observations behind the camera, and of those whose object point has run away."""
    none = np.zeros(0, np.int64)
    found = part_at(store, o, o.held)
    if found is None:
        return {"behind": none, "diverging": none}
    work, now = found
    system = work.of.system
    _, flags = work.normals.residuals(now)
    candidates = system.far_candidates
    ray = now.xyz[candidates] - now.centre[system.first_image[candidates]]
    gone = candidates[diverging(ray, o.typical)]
    rows = work.part.rows[system.rows]
    return {
        "behind": rows[(flags & 1) > 0],
        "diverging": rows[np.isin(system.block.observations.point[system.rows], gone)],
    }


@dataclass(frozen=True, slots=True, kw_only=True)
class Moments:
    """What a similarity of a part's points onto their given coordinates depends on."""

    network: str
    node: int
    state: str
    centre: tuple[float, float, float]
    carriers: str
    """Product with (p,) which object points of the whole carry the datum"""


def moments(store: Store, o: Moments) -> Product:
    """Sums over the carriers: (r, 1)(r, 1)' and g (r, 1)', r and g adjusted and given coordinates from the centre."""
    found = part_at(store, o)
    if found is None:
        return {"own": np.zeros((4, 4)), "given": np.zeros((3, 4))}
    work, now = found
    given = work.of.system.initial_state()
    mine = _mine(work) & store.lent(o.carriers)["carriers"][work.part.points]
    r = np.column_stack([now.xyz[mine] - o.centre, np.ones(int(mine.sum()))])
    return {"own": r.T @ r, "given": (given.xyz[mine] - o.centre).T @ r}


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """A part moved by a similarity."""

    network: str
    node: int
    state: str
    similarity: str
    """Product: T (4, 4) of coordinates from a centre (3,); what is held stays"""


def placed(store: Store, o: Placed) -> Product:
    """The state of a part after a similarity."""
    found = part_at(store, o)
    if found is None:
        return {}
    work, now = found
    by = store.lent(o.similarity)
    new = transformation.placed(work.of.system, now, by["T"], by["centre"])
    held = work.of.system.control_held
    new.xyz[held] = now.xyz[held]
    return sweeps.kept_state(new)


@dataclass(frozen=True, slots=True, kw_only=True)
class Generators:
    """The generators of an open datum at a part's points."""

    network: str
    node: int
    state: str
    datum: str
    """Product: basis, centre, extent, carriers"""


def generators(store: Store, o: Generators) -> Product:
    """G and B G (p, 3, d) of a part's points, and its share of G'BG."""
    found = part_at(store, o)
    if found is None:
        return {"numbers": np.zeros(0)}
    work, now = found
    datum, system = store.lent(o.datum), work.of.system
    G = point_generators(now.xyz, datum["centre"], float(datum["extent"])) @ datum["basis"]
    G[~system.points_used] = 0
    G[system.control_held] = 0
    mine = datum["carriers"][work.part.points] & (system.point_node < 0)
    BG, d = G * mine[:, None, None], G.shape[2]
    return {"G": G, "points": BG, "middle": BG.reshape(-1, d).T @ G.reshape(-1, d)}


@dataclass(frozen=True, slots=True, kw_only=True)
class StatisticsInput:
    """What a part's statistics depend on."""

    network: str
    node: int
    state: str
    held: str
    inverse: str
    generators: str
    """"": the datum is that of the factor"""
    change: str
    """Product: H (N, d) of the nodes and M (d, d)"""


def _statistics(store: Store, o: StatisticsInput, work: PartWork, now: State) -> tuple[Array, ...]:
    """Cofactors of points, A Q A', effects of blunders, H of the points and B G (p, 3, d), where the datum changes."""
    Q, change, given = store.lent(o.inverse, ("part",))["part"], None, np.zeros((len(now.xyz), 3, 0))
    if o.generators:
        G, by = store.lent(o.generators, ("G", "points")), store.lent(o.change)
        nodes, given = sweeps.rows_of(known(store, o.network).network, work.of.nodes), G["points"]
        change = Transformation(
            nodes=by["nodes"][nodes], points=G["G"], given=given, nodes_h=by["H"][nodes], middle=by["middle"],
            points_h=np.zeros((0, 3, 0)), inner=np.zeros_like(by["middle"]),
        )  # fmt: skip
    work.normals.refresh_external(now)
    return *work.normals.statistics(now, Q, change), given


def statistics(store: Store, o: StatisticsInput) -> Product:
    """Cofactors of a part's points in the datum of the factor, A Q A' and effects of its observations, H."""
    part = part_at(store, o, o.held)
    if part is None:
        return {"points": np.zeros((0, 3, 3)), "hat": np.zeros((0, 3)), "effect": np.zeros((0, 3, 2))}
    points, hat, effect, points_h, _ = _statistics(store, o, *part)
    return {"points": points, "hat": hat, "effect": effect, "H": points_h}


def reported(store: Store, o: StatisticsInput) -> Product:
    """The same of the points that a part eliminates, with what it adds to sums, and residuals."""
    part = part_at(store, o, o.held)
    if part is None:
        return {"inner": np.zeros((0, 0)), "numbers": np.zeros(2)}
    work, now = part
    points, hat, effect, points_h, given = _statistics(store, o, work, now)
    system, mine = work.of.system, _mine(work)
    points = points * ~system.held[:, :, None] * ~system.held[:, None, :]
    v, _ = work.normals.residuals(now)
    weighted = system.prior[mine]
    variance = system.block.points.sigma[mine][weighted] ** 2
    by_points = float((1 - np.diagonal(points[mine], axis1=1, axis2=2)[weighted] / variance).sum())
    redundancy = 2 * len(hat) - float(hat[:, :2].sum()) + by_points
    found = {"points": points[mine], "hat": hat, "effect": effect, "residuals": v, "mine": np.flatnonzero(mine)}
    if o.generators:
        H, BG = points_h[mine], given[mine]
        d = H.shape[2]
        found |= {"H": H, "inner": BG.reshape(-1, d).T @ H.reshape(-1, d)}
    return {**found, "numbers": np.array([redundancy, len(hat)])}


@dataclass(frozen=True, slots=True, kw_only=True)
class Stated:
    """What a part's covariances depend on."""

    network: str
    node: int
    reported: str
    generators: str
    middle: str
    """Product: M (d, d) and K (d, d) of all points; "": the datum is that of the factor"""


def stated(store: Store, o: Stated) -> Product:
    """Cofactors (p, 3, 3) of the points that a part eliminates, datum of the result."""
    at = known(store, o.network)
    work = work_of(at, o.node)
    if work is None:
        return {"cofactors": np.zeros((0, 3, 3)), "index": np.zeros(0, np.int64)}
    found = store.lent(o.reported, ("points", "mine", "H") if o.middle else ("points", "mine"))
    points, index = found["points"], work.part.points[found["mine"]]
    if o.middle:
        by, G = store.lent(o.middle), store.lent(o.generators, ("G",))["G"][found["mine"]]
        none = np.zeros((0, 3, 0))
        change = Transformation(
            nodes=none, points=G, given=none, nodes_h=none, points_h=found["H"], middle=by["M"], inner=by["K"]
        )
        points = change.apply_own(points)
    return {"cofactors": points, "index": index}


@dataclass(frozen=True, slots=True, kw_only=True)
class Tested:
    """What the tests of a part's observations depend on."""

    network: str
    node: int
    state: str
    reported: str
    sigma0: float


def tested(store: Store, o: Tested) -> Product:
    """T of a part's observations (NaN of rejected ones), and the adjusted points that it eliminates."""
    part = part_at(store, o)
    if part is None:
        none = np.zeros(0, np.int64)
        return {"rows": none, "t": np.zeros((0, 2)), "points": none, "xyz": np.zeros((0, 3))}
    work, now = part
    reported, system = store.lent(o.reported), work.of.system
    found = Cofactors(np.zeros(0), None, reported["points"], reported["points"], reported["hat"], reported["effect"])
    t = image_statistics(system, reported["residuals"], found, o.sigma0, ()).t
    mine = reported["mine"]
    return {"rows": work.part.rows, "t": t, "points": work.part.points[mine], "xyz": now.xyz[mine] + system.shift}
