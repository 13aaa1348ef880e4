"""Adjust a block with approximate values: estimate, datum, statistics.

What is free and what is rejected is decided by the caller (`decide`); here it is carried out.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from typing import Literal

import numpy as np

from raybundle.adjustment.blunders.behind_cameras import meeting_before_cameras
from raybundle.adjustment.blunders.collinear_points import check_turning
from raybundle.adjustment.blunders.control_notices import precise_control_notices
from raybundle.adjustment.blunders.image_fields import own_field_notices
from raybundle.adjustment.evaluation.cell_means import systematic_notices
from raybundle.adjustment.evaluation.held_interiors import determined_by_network, steadied, without_priors
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.evaluation.queries import suspects
from raybundle.adjustment.evaluation.tie_roughness import relief_notices, with_roughness
from raybundle.adjustment.evaluation.unusual_noise import unusual_noise_notices
from raybundle.adjustment.notices import notices_of, with_group_notices
from raybundle.adjustment.records.figures import (
    InteriorResult,
    NetworkFigures,
    ObservationGroup,
    ObservationStatistics,
    Precision,
)
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import EMPTY, Adjustment, Handle, variance_factor
from raybundle.adjustment.statistics.components import Found, settled_components, variance_components
from raybundle.adjustment.statistics.interior import interior_results
from raybundle.adjustment.statistics.network import network_figures
from raybundle.adjustment.statistics.precision import (
    cofactors,
    interior_precision,
    precision,
)
from raybundle.adjustment.statistics.reliability import (
    RedundancySum,
    image_statistics,
    observation_groups,
    redundancy_sum,
)
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system import defects
from raybundle.adjustment.system.assemble import State, System, assemble
from raybundle.adjustment.system.datum import NAMES, SHORT, Datum, analyse, hold_minimal, open_names
from raybundle.adjustment.system.factoring import around
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.solve import CAUTIOUS, FLOOR, HUBER, solve
from raybundle.adjustment.system.transformation import fit_to_given
from raybundle.block import Block, Camera, Instrument
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.block.rigs import at_stations_of
from raybundle.errors import DatumDefect, NoConvergence, RankDefect, Text, TooFewObservations, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.statistics import family_wise_normal, family_wise_tau, global_test

Extent = Literal["report", "decisions", "tests", "residuals"]
Start = Literal["approximate", "adjusted"]


def free_parameters(camera: Camera | Instrument) -> tuple[str, ...]:
    """The parameters that an `estimate` frees; "auto" starts with all but affinity and shear."""
    if camera.estimate == "auto":
        later = {"affinity", "harmonic", "read-out", "other"}
        return tuple(p.symbol for p in camera.sensor.parameters if p.kind not in later)
    return tuple(camera.estimate)


def adjust_block(
    block: Block,
    options: AdjustmentOptions | None = None,
    progress: Progress = silent,
    *,
    free: dict[str, tuple[str, ...]] | None = None,
    rejected: Rejections | None = None,
    notices: tuple[Notice, ...] = (),
    extent: Extent = "report",
    start: Start = "approximate",
) -> Adjustment:
    """Adjust a block whose images are oriented and whose points have coordinates, approximately.

    free      camera id -> free parameters; None: as the cameras' `estimate` states
    rejected  (m,) reason for each image observation, None = takes part; None: all take part
    notices   what earlier steps have to say; passed on
    extent    decisions: of the statistics only redundancy numbers, tests and the interior orientations' covariances;
              tests: without these and what is stated of the interior orientations, too
              residuals: without any statistics, and without a test of the rank
    start     adjusted: the values come from an adjustment of nearly the same; the first step is not damped
    raises    InputError, DatumDefect, RankDefect, NoConvergence

    The normal equations are made in one piece, or as `factoring.made_by` states, as in parts (`raybundle.blocking`).
    Camera parameters that the network leaves open are kept near what was given (`steady`), and called not determinable.

    What it does not do: find approximate values (`raybundle.orientation`), reject blunders or choose
    parameters (`raybundle.adjustment.decision.decide`).
    """
    began = time.perf_counter()
    options = options or AdjustmentOptions()
    free = free if free is not None else {c.id: free_parameters(c) for c in block.parametrised}
    reasons = rejected or (None,) * len(block.observations)
    try:
        rank = extent != "residuals"
        work, found = carry_out(block, options, free, reasons, progress, start=start, rank=rank)
        result = result_of(work, block, options, found, notices, time.perf_counter() - began, progress, extent)
        return _finished(_with_settled_components(result, block, options, free, found), extent, progress)
    except TooFewObservations:
        raise
    except (RankDefect, NoConvergence) as error:
        steady = steadied(block, free, error)
        if steady is None:
            raise
        work, found = carry_out(steady.block, options, free, reasons, progress, start=start)
        system = work.system
        if system.observations - len(steady.added) - system.unknowns + work.datum.defect < 0:
            raise  # fewer observations than unknowns: what is stated would be what was added
    seconds = time.perf_counter() - began
    result = result_of(work, steady.block, options, found, notices, seconds, progress, extent, steady.added)
    result = _with_settled_components(result, steady.block, options, free, found)
    result = without_priors(result, block, steady.added)
    return _finished(result, extent, progress)


def _finished(result: Adjustment, extent: Extent, progress: Progress) -> Adjustment:
    """The result under the noise that is asked for; RankDefect where images turn about a line."""
    if extent != "report":
        return result
    progress("statistics", 1.0)
    check_turning(result)
    result = under_noise(result) if result.options.noise == "fields" else result
    result = with_roughness(result)
    progress("statistics", 1.0)
    found = (
        *own_field_notices(result), *systematic_notices(result), *unusual_noise_notices(result),
        *relief_notices(result), *precise_control_notices(result),
    )  # fmt: skip
    return replace(result, notices=(*result.notices, *found))


def _with_settled_components(
    result: Adjustment, block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]],
    reasons: Rejections,
) -> Adjustment:  # fmt: skip
    """The result with variance components that are iterated where one step is not enough."""

    def adjusted(weighted: Block) -> Found:
        start = started(weighted, result.adjusted)
        brief = replace(
            options, tolerance=max(options.tolerance, 1e-3), robust_start=False,
            max_iterations=min(options.max_iterations, NEARBY),
        )  # fmt: skip
        work, now = carry_out(start, brief, free, reasons, start="adjusted")
        state = work.state
        whitened, _ = work.normals.residuals(state)
        statistics = image_statistics(work.system, whitened, work.found, 1.0, now)
        return work.system, whitened, statistics, observation_groups(work.normals, state, work.found, 1.0, 1.0)

    components = settled_components(block, result.variance_components, adjusted)
    if components is result.variance_components:
        return result
    result = replace(result, variance_components=components)
    return replace(result, notices=with_group_notices(result))


NEARBY = 25
"""Steps from an adjustment to that with other weights; where they do not end, one step of the components has to do."""
RETURNS = 2
"""Times that a point behind its cameras is placed before them: while the block is bent, and once it is not."""
UNENDING = 0.05
"""Steps, in standard deviations, that do not end but are so short that the standard deviations can be stated.

Where a network hardly determines something, rounding keeps the iteration moving along it; its standard deviation then
states more than an error would.
"""


def carry_out(
    block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], reasons: Rejections,
    progress: Progress = silent, *, start: Start = "approximate", rank: bool = True,
) -> tuple[Work, Rejections]:  # fmt: skip
    """Estimate and cofactors; observations whose point ends behind the camera or at infinity leave, then once more.

    rank  whether it is tested that the observations determine everything; only without statistics may it not be
    """
    mask = np.array([bool(r) for r in reasons], bool)
    defects.check_observed(block, mask)
    defects.check_cameras(block, free)
    defects.check_rays(block, mask)
    reasons, mask = reject_single_rays(block, reasons, mask)
    defects.check_images(block, mask, free)
    work = _estimate(block, options, free, mask, start, progress)
    defects.check_scatter(work.system, work.normals.residuals(work.solution.state)[0])
    work, reasons = _without_lost(work, block, options, free, reasons, mask, start, progress)
    weak = not work.solution.step < UNENDING or defects.without_base(work.system, work.solution.state)
    # an iteration that creeps off with all points ends anywhere
    share = defects.NO_BASE if not work.solution.converged and weak else defects.NOWHERE
    defects.check_base(work.system, work.solution.state, share)
    if not work.solution.converged and weak:
        _in_minimal_datum(work.normals, work.solution.state, work.datum)
        raise defects.no_convergence(work.normals, work.solution.state, work.solution.iterations, work.solution.step)
    # what observations fix is asked where they lead: a run that starts there must find the same
    settled = analyse(work.system, work.solution.state, options)
    if settled.defect != work.datum.defect:
        work.datum = settled
    # residuals do not change within the open datum: moved first, the block is factored once, where it will stand
    work.state = fit_to_given(work.system, work.solution.state, work.system.initial_state(), work.datum)
    if rank or options.statistics:
        _factor(work.normals, work.state, work.datum)
    if options.statistics:
        progress("statistics", 0.0)
        work.found = cofactors(work.normals, work.state, work.datum)
        progress("statistics", 1.0)
    return work, reasons


def _without_lost(
    work: Work, block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], reasons: Rejections,
    mask: Mask, start: Start, progress: Progress,
) -> tuple[Work, Rejections]:  # fmt: skip
    """The solution without observations whose point is behind the camera or at infinity, and their rejections.

    Points whose rays meet before the cameras are placed there first, also those that left while the block was bent.
    """
    given: Mask = mask
    returned = np.where(block.points.is_control.any(axis=1), RETURNS, 0)
    for _ in range(5):
        behind, diverging = _lost(work)
        gone = (mask & ~given) | _of_rows(block, work.system.rows[behind | diverging])
        near, back = _with_points_before(work, gone, given, returned, options)
        if back.any():
            reasons = tuple(None if again else r for r, again in zip(reasons, back.tolist(), strict=True))
            mask = mask & ~back
            work = _estimate(block, options, free, mask, "approximate", progress, near)
            behind, diverging = _lost(work)
        if not (behind | diverging).any():
            if back.any():  # others may meet now
                continue
            break
        new, rows = list(reasons), work.system.rows
        for i in rows[diverging]:
            new[i] = Rejection(kind=RejectionKind.RAYS_DIVERGE)
        for i in rows[behind]:
            new[i] = Rejection(kind=RejectionKind.BEHIND_CAMERA)
        reasons, mask = reject_single_rays(block, tuple(new), np.array([bool(r) for r in new], bool))
        defects.check_images(block, mask, free)
        work = _estimate(block, options, free, mask, start, progress)
    # those that were placed in vain while the block was bent
    returned = np.where(block.points.is_control.any(axis=1), RETURNS, 0)
    near, back = _with_points_before(work, mask & ~given, given, returned, options)
    if back.any():
        last = _estimate(block, options, free, mask & ~back, "approximate", progress, near)
        if not np.any(_lost(last)):
            work = last
            reasons = tuple(None if again else r for r, again in zip(reasons, back.tolist(), strict=True))
    return work, reasons


def _lost(work: Work) -> tuple[Mask, Mask]:
    """(m,) used image observations whose point a solution has behind the camera, and at infinity."""
    _, flags = work.normals.residuals(work.solution.state)
    point = work.system.block.observations.point[work.system.rows]
    return (flags & 1) > 0, np.isin(point, work.solution.beyond)


def _of_rows(block: Block, rows: Array) -> Mask:
    """(m,) these image observations."""
    found = np.zeros(len(block.observations), bool)
    found[rows] = True
    return found


def _with_points_before(
    work: Work, gone: Mask, given: Mask, returned: Array, options: AdjustmentOptions
) -> tuple[Block, Mask]:
    """The block with a solution and points that are lost or left it where their rays meet, and their observations (m,).

    gone      (m,) image observations behind their cameras, at infinity, or rejected for that before
    given     (m,) those that take no part in any case
    returned  (p,) how often a point was placed where its rays meet; those that are now are counted
    The rays of a point meet where all residuals are within the critical value of data snooping at the sigma0 there is.
    """
    system, solution, o = work.system, work.solution, work.system.block.observations
    asked = np.zeros(len(returned), bool)
    asked[o.point[gone]] = True
    asked &= returned < RETURNS
    back = np.zeros(len(o), bool)
    if not asked.any():
        return system.block, back
    redundancy = max(system.observations - system.unknowns, 1)
    limit = family_wise_normal(options.significance, 2 * len(o)) * max(np.sqrt(2 * solution.cost / redundancy), 1.0)
    near = adjusted_block(system, solution.state)
    points, places = meeting_before_cameras(near, np.flatnonzero(asked[o.point] & ~given), float(limit))
    back[np.isin(o.point, points)] = True
    returned[points] += 1
    xyz = near.points.xyz.copy()
    xyz[points] = places
    return replace(near, points=replace(near.points, xyz=xyz)), back & ~given


def estimate_only(
    block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], mask: Mask
) -> tuple[Block, Mask]:
    """Adjusted values without statistics, rank test or error: a step towards approximate values.

    mask     (m,) observations that take no part; images and points without others keep their values
    returns  the block, and the rows (m,) whose point ended behind the camera or has no projection
    """
    system = assemble(block, options, mask, free)
    normals = around()(system, options, free, mask)
    state = system.initial_state()
    if options.robust_start:
        found = solve(normals, state, options, huber=HUBER, tolerance=1e-1, approximate=True)
    else:
        found = solve(normals, state, options, approximate=True)
    state = found.state
    bad = np.zeros(len(block.observations), bool)
    bad[system.rows] = normals.residuals(state)[1] > 0
    return as_start(block, adjusted_block(system, state)), bad


def open_datum(
    block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], reasons: Rejections
) -> tuple[str, ...]:
    """Names of what control, distances and projection centres leave open of the datum, at the values of the block."""
    system = assemble(block, options, np.array([bool(r) for r in reasons], bool), free)
    try:
        return open_names(analyse(system, system.initial_state(), replace(options, datum="auto")).basis)
    except DatumDefect as error:  # instruments that need it show what would be open
        return error.open_names


def reject_single_rays(block: Block, reasons: Rejections, mask: Mask) -> tuple[Rejections, Mask]:
    """Reject the last ray of tie points whose others were rejected, and that of check points."""
    left = np.bincount(block.observations.point[~mask], minlength=len(block.points))
    control = np.any(block.points.is_control, axis=1)
    lone = ~mask & (left[block.observations.point] == 1) & ~control[block.observations.point]
    if not lone.any():
        return reasons, mask
    new = list(reasons)
    for i in np.flatnonzero(lone):
        new[i] = Rejection(kind=RejectionKind.SINGLE_RAY)
    return tuple(new), mask | lone


def _estimate(
    block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], mask: Mask, start: Start,
    progress: Progress, near: Block | None = None,
) -> Work:  # fmt: skip
    """The solution from the approximate values of the block, or from those of `near`, the same block elsewhere."""
    system = assemble(block, options, mask, free)
    state = system.initial_state()
    datum = analyse(system, state, options)
    defects.check_count(system, datum.defect)

    def open_of(rows: Mask) -> tuple[str, ...]:
        if options.datum in {"auto", "control"} and defects.held_by_points(block, rows):
            return ()
        part = assemble(block, options, ~rows, free)
        return open_names(analyse(part, part.initial_state(), replace(options, datum="auto")).basis)

    parts = defects.check_components(block, mask, open_of) if datum.defect == 0 or _may_fall_apart(block, mask) else 1
    normals = around()(system, options, free, mask)
    if near is not None:
        state = replace(system, block=near).initial_state()
    elif options.robust_start:
        state = solve(normals, state, options, huber=HUBER, tolerance=1e-2, approximate=True, progress=progress).state
    damping = FLOOR if start == "adjusted" else CAUTIOUS
    solution = solve(normals, state, options, damping=damping, progress=progress)
    return Work(
        system=system, normals=normals, datum=datum, solution=solution, found=None, parts=parts, state=solution.state
    )  # fmt: skip


def _may_fall_apart(block: Block, mask: Mask) -> bool:
    del mask
    return len(block.images) > 1


def _in_minimal_datum(normals: Normals, state: State, datum: Datum) -> list[int]:
    """Form the undamped normal equations in a minimal datum at a state; returns points without an intersection."""
    system = normals.system
    normals.hold(system.control_held | hold_minimal(system, state, datum))
    return normals.reduce(state)[2]


def _factor(normals: Normals, state: State, datum: Datum) -> None:
    """Undamped factor in a minimal datum at a state; RankDefect where there is none."""
    weak = _in_minimal_datum(normals, state, datum)
    failed = normals.factorise()
    if failed or weak:
        defects.check_base(normals.system, state)
        raise defects.explain(normals, state, weak, failed - 1)
    share, at = normals.least_share()
    if share < defects.SHARE:
        raise defects.explain(normals, state, weak, at)


def result_of(
    work: Work, block: Block, options: AdjustmentOptions, reasons: Rejections, notices: tuple[Notice, ...],
    seconds: float, progress: Progress = silent, extent: Extent = "report",
    added: Mapping[tuple[str, str], float] | None = None,
) -> Adjustment:  # fmt: skip
    """Everything a report needs from an adjusted system, or what decisions need; `added` as in `steady`."""
    brief = extent != "report"
    began = time.perf_counter()
    system, normals, datum, solution = work.system, work.normals, work.datum, work.solution
    state, found = work.state, work.found
    redundancy = system.observations - system.unknowns + datum.defect
    square_sum = 2 * solution.cost
    sigma0 = float(np.sqrt(square_sum / redundancy)) if redundancy > 0 else float("nan")
    whitened, _ = normals.residuals(solution.state)
    variance = variance_factor(options, sigma0, redundancy)
    covariances = _covariances(work, variance, extent)
    progress("statistics", 1.0)
    observations = image_statistics(system, whitened, found, sigma0, reasons)
    groups = observation_groups(normals, state, found, sigma0, variance)
    interior = (
        () if extent in {"tests", "residuals"} else interior_results(normals, state, covariances, variance, redundancy)
    )
    if added:
        interior = tuple(determined_by_network(i, added, variance) for i in interior)
    tests = 2 * len(system.rows) + sum(int((g.sigma > 0).sum()) for g in groups)
    limit = family_wise_tau(options.significance, tests, redundancy)
    explained = found is not None and not brief
    if not solution.converged:
        ended = {"step_sigmas": float(solution.step), "iterations": solution.iterations}
        notices = (Notice(code="weak_convergence", values=ended), *notices)
    adjustment = Adjustment(
        given=block,
        adjusted=adjusted_block(system, state),
        options=options,
        sigma0=sigma0,
        weighted_square_sum=square_sum,
        redundancy=redundancy,
        observations=system.observations,
        unknowns=system.unknowns,
        constraints=datum.defect,
        datum=_datum_words(datum, options),
        datum_defect=datum.open_names,
        converged=solution.converged,
        iterations=solution.iterations,
        seconds=0.0,
        global_test=global_test(square_sum, redundancy),
        image_observations=observations,
        groups=groups,
        precision=covariances,
        interior=interior,
        variance_components=variance_components((system, whitened, observations, groups)) if explained else (),
        network=None if brief or not options.statistics else _network(work, covariances),
        not_determinable=_not_determinable(interior),
        not_significant=(),
        critical_w=family_wise_normal(options.significance, tests),
        critical_tau=limit,
        suspects=suspects(work, state, observations, limit) if explained else (),
        notices=notices,
        condition=1 / max(normals.smallest_pivot, 1e-300),
        handle=Handle(work) if found is not None else EMPTY,
    )
    own = () if brief else notices_of(adjustment, _sum_of(work, adjustment, observations, groups))
    return replace(adjustment, notices=notices + own, seconds=seconds + time.perf_counter() - began)


def _covariances(work: Work, variance: float, extent: Extent) -> Precision | None:
    """What the inverse states, times the variance factor, as far as it is asked for."""
    if work.found is None or extent in {"tests", "residuals"}:
        return None
    take = precision if extent == "report" else interior_precision
    return take(work.normals, work.state, work.found, variance)


def _network(work: Work, covariances: Precision | None) -> NetworkFigures:
    """Figures of the network, with the points' standard deviations where there are some."""
    std = None if covariances is None else covariances.object_point_std
    unit_mm = 1000.0 if work.system.block.length_unit == "m" else 1.0
    return network_figures(work.system, work.state, std, work.parts, unit_mm)


def _not_determinable(interior: tuple[InteriorResult, ...]) -> tuple[str, ...]:
    """Parameters that the observations do not determine, with their camera."""
    return tuple(
        f"{p.symbol} ({_name(r.camera, r.image)})"
        for r in interior
        for p in r.parameters.values()
        if p.status == "not determinable"
    )


def _sum_of(
    work: Work, adjustment: Adjustment, observations: ObservationStatistics, groups: tuple[ObservationGroup, ...]
) -> RedundancySum | None:
    if work.found is None:
        return None
    return redundancy_sum(work, work.state, work.found, observations, groups, adjustment.redundancy)


def _name(camera: str, image: str | None) -> str:
    return f"camera {camera}" if image is None else f"camera {camera}, image {image}"


def _datum_words(datum: Datum, options: AdjustmentOptions) -> Text:
    if datum.defect == 0:
        return phrase("datum.control")
    parts = "all" if datum.defect == 7 else "some"
    names = [SHORT[NAMES.index(name)] if name in NAMES else name for name in datum.open_names]
    if datum.kind == "minimal":
        return phrase("datum.minimal", n=datum.defect, names=names)
    over, n = "all", 0
    if options.datum_points:
        over, n = "chosen", len(options.datum_points)
    elif options.datum_over == "good":
        over, n = "good", int(datum.carriers.sum())
    return phrase("datum.inner", over=over, n=n, parts=parts, names=names)


def adjusted_block(system: System, state: State) -> Block:
    """The block with adjusted values; points and images that took no part keep theirs, or have their station's."""
    block = system.block
    xyz = np.where(system.points_used[:, None], state.xyz + system.shift, block.points.xyz)
    centre = np.where(system.images_used[:, None], state.centre + system.shift, block.images.centre)
    rotation = np.where(system.images_used[:, None, None], state.rotation, block.images.rotation)
    values_of = {c.id: dict(c.values) for c in block.parametrised}
    per_image = dict(block.images.interior)
    for r, row in enumerate(system.interior):
        values = {row.model.symbols[k]: float(state.interior[r, k]) for k in row.carries}
        if row.image >= 0:
            per_image[row.image] = values
        else:
            values_of[row.owner(block).id] |= values
    return replace(
        block,
        cameras=tuple(replace(c, values=values_of[c.id]) for c in block.cameras),
        instruments=tuple(replace(i, values=values_of[i.id]) for i in block.instruments),
        images=at_stations_of(
            replace(block.images, centre=centre, rotation=rotation, interior=per_image), system.images_used
        ),
        points=replace(block.points, xyz=xyz),
    )


def as_start(given: Block, adjusted: Block) -> Block:
    """Adjusted values as approximate values: what is observed (control, parameters with a sigma) stays as given."""
    xyz = np.where(given.points.is_control, given.points.xyz, adjusted.points.xyz)
    observed = {g.id: {symbol: g.values[symbol] for symbol in g.sigma} for g in given.parametrised}
    cameras = tuple(replace(c, values={**c.values, **observed[c.id]}) for c in adjusted.cameras)
    instruments = tuple(replace(i, values={**i.values, **observed[i.id]}) for i in adjusted.instruments)
    interior = {i: {**values, **_observed_own(given, i, values)} for i, values in adjusted.images.interior.items()}
    images = replace(adjusted.images, interior=interior)
    points = replace(adjusted.points, xyz=xyz)
    return replace(adjusted, cameras=cameras, instruments=instruments, images=images, points=points)


def started(block: Block, adjusted: Block) -> Block:
    """The block with adjusted values as approximate ones: of other weights, otherwise the same."""
    near = as_start(block, adjusted)
    cameras = tuple(replace(c, values=n.values) for c, n in zip(block.cameras, near.cameras, strict=True))
    instruments = tuple(replace(i, values=n.values) for i, n in zip(block.instruments, near.instruments, strict=True))
    points = replace(block.points, xyz=near.points.xyz)
    return replace(block, cameras=cameras, instruments=instruments, images=near.images, points=points)


def _observed_own(given: Block, image: int, values: Mapping[str, float]) -> dict[str, float]:
    """The given values of an image's own parameters that are observed."""
    camera = given.cameras[int(given.images.camera[image])]
    own = given.images.interior.get(image, {})
    return {s: own.get(s, camera.values[s]) for s in camera.sigma if s in values}
