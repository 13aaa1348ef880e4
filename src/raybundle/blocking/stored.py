"""The adjustment of a network whose parts lie in a store: nothing of it is ever in memory as a whole."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.adjustment.estimation import UNENDING
from raybundle.adjustment.records.figures import ObservationGroup, Precision
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import variance_factor
from raybundle.adjustment.statistics.precision import Cofactors, precision
from raybundle.adjustment.statistics.reliability import observation_groups
from raybundle.adjustment.system import defects
from raybundle.adjustment.system.assemble import State
from raybundle.adjustment.system.datum import (
    Datum,
    Transformation,
    middle_and_extent,
    node_generators,
    well_spread,
    what_is_open,
)
from raybundle.adjustment.system.dense import one_thread
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.solve import HUBER, Solution, solve
from raybundle.adjustment.system.transformation import placed
from raybundle.blocking import answers
from raybundle.blocking.columns import Columns
from raybundle.blocking.network import LEAF, Network
from raybundle.blocking.network_store import cut_columns
from raybundle.blocking.normals import Parts, PartsNormals, PartsState
from raybundle.blocking.similarity import onto
from raybundle.blocking.store import Store
from raybundle.errors import NoConvergence, NotSolvable, RankDefect, TooFewObservations
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.executors import Executor


@dataclass(frozen=True, slots=True, kw_only=True)
class StoredAdjustment:
    """What came of an adjustment in a store: figures of the whole here, those of observations and points by parts."""

    network: Network
    store: Store
    options: AdjustmentOptions
    sigma0: float
    weighted_square_sum: float
    observations: int
    unknowns: int
    redundancy: int
    redundancy_sum: float
    """Of all observations; differs from the redundancy by rounding alone"""
    iterations: int
    converged: bool
    datum: Datum
    state: PartsState
    precision: Precision
    """Of images and interior orientations; object points are those of the skeleton"""
    groups: tuple[ObservationGroup, ...]
    """Observations outside the images"""
    reported: tuple[str, ...]
    """By tree node: residuals, A Q A' and effects (`answers.stated`)"""
    stated: tuple[str, ...]
    """By tree node: cofactors of the object points that it eliminates (`answers.stated`)"""


class Astray(NotSolvable):
    """Observations whose object point lies behind the camera, or has run away."""

    def __init__(self, behind: Index, gone: Index) -> None:
        rows = np.unique(np.concatenate([behind, gone]))
        super().__init__(
            "observations.astray", behind=len(behind), diverging=len(gone), rows=[int(r) + 1 for r in rows[:5]]
        )
        self.behind, self.gone = behind, gone


@dataclass(slots=True)
class _Run:
    """An adjustment under way."""

    normals: PartsNormals
    options: AdjustmentOptions
    progress: Progress
    held: Mask = field(default_factory=lambda: np.zeros((0, 3), bool))
    """(p, 3) coordinates that carry a minimal datum"""
    described: list[dict[str, Array]] = field(default_factory=list[dict[str, Array]])
    """What the parts stated of themselves last"""

    @property
    def parts(self) -> Parts:
        """Who does the tasks."""
        return self.normals.parts


def adjust_columns(
    columns: Columns, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], store: Store,
    executor: Executor, *, rejected: Mask | None = None, leaf: int = LEAF, keep: int = 4, progress: Progress = silent,
) -> StoredAdjustment:  # fmt: skip
    """Adjust a block that is read piece by piece: estimate, datum, covariances, redundancy numbers.

    free      camera or instrument id -> free parameters
    store     where parts and products are kept; a run that was cut short goes on there
    executor  who does the tasks
    rejected  (m,) image observations that take no part
    leaf      unknowns of a leaf at most
    keep      parts that a process holds ready for use
    raises    InputError, DatumDefect, RankDefect, NoConvergence

    What it does not do: reject blunders or choose parameters (`blocking.decision`), and find approximate values.
    """
    rejected = np.zeros(columns.observations, bool) if rejected is None else rejected
    cut = cut_columns(columns, options, free, rejected, store, leaf=leaf, keep=keep)
    parts = Parts(cut.network, store, executor, begin=cut.keep_parts, notes=store)
    run = _Run(PartsNormals(parts, 0, 0), options, progress)
    with one_thread():  # for tasks in this process: more would add up in another order
        return _adjusted(run)


def _adjusted(run: _Run) -> StoredAdjustment:
    """Estimate, and what it gives."""
    normals, options, progress = run.normals, run.options, run.progress
    start: State = normals.initial_state()
    assert isinstance(start, PartsState)
    datum = _described(run, start)
    if normals.unknowns - datum.defect > normals.observations:
        unknowns = normals.unknowns - datum.defect
        raise TooFewObservations(
            "adjustment.too_few_observations", n=normals.observations, unknowns=unknowns,
            missing=unknowns - normals.observations, parameters=[], free=0,
        )  # fmt: skip
    if options.robust_start:
        start = solve(normals, start, options, huber=HUBER, tolerance=1e-2, approximate=True, progress=progress).state
    solution = solve(normals, start, options, progress=progress)
    if not solution.converged and not solution.step < UNENDING:
        raise NoConvergence(
            "adjustment.no_convergence", iterations=solution.iterations, step_sigmas=float(solution.step)
        )
    _refuse_astray(run, solution)
    return _stated(run, solution)


def _refuse_astray(run: _Run, solution: Solution) -> None:
    """Raise NotSolvable for observations whose object point lies behind the camera, or has run away."""
    state, network = solution.state, run.normals.network
    assert isinstance(state, PartsState)
    sample = np.vstack([f["sample"] for f in run.described])
    centres = state.centre[network.skeleton.system.images_used]
    typical = float(np.median(np.linalg.norm(sample - centres.mean(axis=0), axis=1))) if len(centres) else 1.0

    def options(t: int) -> answers.Astray:
        return answers.Astray(network=network.key, node=t, state=state.keys[t], held=run.normals.held, typical=typical)

    found = run.parts.made(run.parts.each("astray", options, lambda o: (o.state,)))
    behind, gone = (np.concatenate([f[name] for f in found]) for name in ("behind", "diverging"))
    if len(behind) or len(gone):
        raise Astray(behind, gone)


def _described(run: _Run, state: PartsState) -> Datum:
    """Counts, and the datum at a state; its minimal one is held."""
    normals, network = run.normals, run.normals.network

    def options(t: int) -> answers.Described:
        return answers.Described(network=network.key, node=t, state=state.keys[t])

    keys = run.parts.each("describe", options, lambda o: (o.state,))
    found = run.parts.made(keys)
    own = network.skeleton.system
    numbers = np.array([f["numbers"] for f in found]).sum(axis=0)
    normals.observations, normals.unknowns = own.observations + int(numbers[0]), own.unknowns + int(numbers[1])
    with_node = own.point_node >= 0
    centre, extent = middle_and_extent(np.vstack([state.xyz[with_node], *(f["sample"] for f in found)]))
    given = network.skeleton.given
    known = replace(state, xyz=given.initial_state().xyz)
    known.xyz[with_node] = state.xyz[with_node]
    basis, kind = what_is_open(given, known, run.options, centre, extent)
    carriers = np.ones(network.skeleton.count, bool)
    if run.options.datum_points:
        names = network.skeleton.block.points.ids
        carriers = np.zeros(network.skeleton.count, bool)
        carriers[network.skeleton.points[np.isin(np.array(names), run.options.datum_points)]] = True
    datum = Datum(kind=kind, basis=basis, centre=centre, extent=extent, carriers=carriers)
    held = np.zeros((network.skeleton.count, 3), bool)
    if datum.defect:
        xyz, rays = np.vstack([f["xyz"] for f in found]), np.concatenate([f["rays"] for f in found])
        which, axis, firm = well_spread(xyz, rays, np.zeros((len(xyz), 3), bool), datum)
        if firm < 1e-9:
            raise RankDefect("datum.points_in_line")
        held[np.concatenate([f["candidates"] for f in found])[which], axis] = True
    run.held, run.described = held, found
    return datum


def _stated(run: _Run, solution: Solution) -> StoredAdjustment:
    """Covariances and redundancy numbers at the solution, moved into the datum of the result."""
    normals, network, options = run.normals, run.normals.network, run.options
    state = solution.state
    assert isinstance(state, PartsState)
    datum = _described(run, state)
    state = _fitted(run, state, datum)
    normals.hold(run.held)
    _, _, weak = normals.reduce(state)
    if normals.failed() >= 0 or weak:
        raise RankDefect("rank.not_determined")
    share, _ = normals.least_share()
    if share < defects.SHARE:
        raise RankDefect("rank.not_determined")
    inverse = normals.selected_inverse()
    reported, stated, change, redundancy_sum = _cofactors(run, state, datum)
    redundancy = normals.observations - normals.unknowns + datum.defect
    sigma0 = float(np.sqrt(2 * solution.cost / redundancy)) if redundancy > 0 else float("nan")
    variance = variance_factor(options, sigma0, redundancy)
    own, skeleton = network.skeleton.normals, network.skeleton
    points = _skeleton_points(own, inverse)
    if change is not None:
        points = change.apply_own(points)
    found = Cofactors(inverse, change, points, points, np.zeros((0, 3)), np.zeros((0, 3, 2)))
    groups = observation_groups(
        own, state, replace(found, points_minimal=_skeleton_points(own, inverse)), sigma0, variance
    )
    extra = sum(float(np.nansum(g.redundancy)) for g in groups)
    return StoredAdjustment(
        network=network, store=run.parts.store, options=options, sigma0=sigma0, weighted_square_sum=2 * solution.cost,
        observations=normals.observations, unknowns=normals.unknowns, redundancy=redundancy,
        redundancy_sum=redundancy_sum + extra, iterations=solution.iterations, converged=solution.converged,
        datum=datum, state=state, precision=precision(skeleton.normals, state, found, variance), groups=groups,
        reported=reported, stated=stated,
    )  # fmt: skip


def _skeleton_points(normals: Normals, inverse: Array) -> Array:
    """Cofactors (k, 3, 3) of the object points that have a node, datum of the factor."""
    system = normals.system
    found = np.zeros((len(system.points_used), 3, 3))
    for p in np.flatnonzero(system.point_node >= 0).tolist():
        node = int(system.point_node[p])
        found[p] = normals.node_block(inverse, node, node)
    return found * ~system.held[:, :, None] * ~system.held[:, None, :]


def _cofactors(
    run: _Run, state: PartsState, datum: Datum
) -> tuple[tuple[str, ...], tuple[str, ...], Transformation | None, float]:
    """Statistics of the parts; what changes the datum of the skeleton's; sum of the redundancy numbers."""
    normals, network = run.normals, run.normals.network
    changes = datum.defect > 0 and datum.kind == "inner"
    generators: tuple[str, ...] = ("",) * len(network.tree)
    change, by = None, ""
    if changes:
        generators, change = _change(run, state, datum)
        by = run.parts.put("change", {"nodes": change.nodes, "H": change.nodes_h, "middle": change.middle})

    def statistics_of(t: int) -> answers.StatisticsInput:
        return answers.StatisticsInput(
            network=network.key, node=t, state=state.keys[t], held=normals.held, inverse=normals.inverses[t],
            generators=generators[t], change=by,
        )  # fmt: skip

    reported = run.parts.each("reported", statistics_of, lambda o: (o.state, o.inverse, o.generators))
    found = run.parts.made(reported, "numbers")
    middle = ""
    if change is not None:
        inner = change.given.reshape(-1, datum.defect).T @ change.points_h.reshape(-1, datum.defect)
        for f in run.parts.made(reported, "inner"):
            inner = inner + f["inner"] if f["inner"].size else inner
        change = replace(change, inner=(inner + inner.T) / 2)
        middle = run.parts.put("middle", {"M": change.middle, "K": change.inner})

    def stated_of(t: int) -> answers.Stated:
        return answers.Stated(
            network=network.key, node=t, reported=reported[t], generators=generators[t], middle=middle
        )

    stated = run.parts.do(run.parts.each("stated", stated_of, lambda o: (o.reported, o.generators)))
    return reported, stated, change, float(sum(f["numbers"][0] for f in found))


def _change(run: _Run, state: PartsState, datum: Datum) -> tuple[tuple[str, ...], Transformation]:
    """The generators at the parts' points, and the S-transformation as far as the skeleton has it."""
    normals, network = run.normals, run.normals.network
    system, d = network.skeleton.system, datum.defect
    key = run.parts.put(
        "datum", {"basis": datum.basis, "centre": datum.centre, "extent": np.array(datum.extent),
                  "carriers": datum.carriers},
    )  # fmt: skip

    def options(t: int) -> answers.Generators:
        return answers.Generators(network=network.key, node=t, state=state.keys[t], datum=key)

    generators = run.parts.each("generators", options, lambda o: (o.state,))
    nodes = node_generators(system, state, datum)
    with_node = np.flatnonzero(system.point_node >= 0)
    at = system.offsets[system.point_node[with_node]][:, None] + np.arange(3)
    G = np.zeros((len(system.points_used), 3, d))
    G[with_node] = nodes[at]
    BG = G * datum.carriers[network.skeleton.points][:, None, None]
    middle = BG.reshape(-1, d).T @ G.reshape(-1, d)
    for f in run.parts.made(generators):
        middle = middle + f["middle"] if "middle" in f else middle
    right = np.zeros_like(nodes)
    right[at] = BG[with_node] * ~system.held[with_node][:, :, None]
    H = normals.solved(right, generators)
    points_h = np.zeros_like(G)
    points_h[with_node] = H[at]
    return generators, Transformation(
        nodes=nodes, points=G, given=BG, nodes_h=H, points_h=points_h, middle=np.linalg.inv(middle),
        inner=np.zeros((d, d)),
    )  # fmt: skip


def _fitted(run: _Run, state: PartsState, datum: Datum) -> PartsState:
    """The state moved, within the open datum, onto the given coordinates of the carriers."""
    if datum.defect == 0 or datum.kind != "inner":
        return state
    network = run.normals.network
    system = network.skeleton.system
    carriers = run.parts.put("carriers", {"carriers": datum.carriers})
    x, y, z = (float(v) for v in datum.centre)

    def options(t: int) -> answers.Moments:
        return answers.Moments(network=network.key, node=t, state=state.keys[t], centre=(x, y, z), carriers=carriers)

    found = run.parts.made(run.parts.each("moments", options, lambda o: (o.state,)), "own", "given")
    given = system.initial_state()
    mine = (system.point_node >= 0) & datum.carriers[network.skeleton.points]
    r = np.column_stack([state.xyz[mine] - datum.centre, np.ones(int(mine.sum()))])
    own, other = r.T @ r, (given.xyz[mine] - datum.centre).T @ r
    for f in found:
        own, other = own + f["own"], other + f["given"]
    return _placed(run, state, onto(own, other, datum), datum.centre)


def _placed(run: _Run, state: PartsState, T: Array, centre: Array) -> PartsState:
    """The state of all parts and of the skeleton after a similarity."""
    network, system = run.normals.network, run.normals.network.skeleton.system
    key = run.parts.put("similarity", {"T": T, "centre": centre})

    def options(t: int) -> answers.Placed:
        return answers.Placed(network=network.key, node=t, state=state.keys[t], similarity=key)

    keys = run.parts.each("placed", options, lambda o: (o.state,))
    new = placed(system, state, T, centre)
    new.xyz[system.control_held] = state.xyz[system.control_held]
    return PartsState(new.rotation, new.centre, new.interior, new.xyz, new.own, keys=keys)
