"""The estimate of a block and its factor: checks, iteration, lost points, datum, cofactors."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from raybundle.adjustment.blunders.behind_cameras import meeting_before_cameras
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import (
    cofactors,
)
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system import defects
from raybundle.adjustment.system.adjusted_values import adjusted_block, as_start
from raybundle.adjustment.system.assemble import State, assemble
from raybundle.adjustment.system.datum import Datum, analyse, hold_minimal, middle_and_extent, open_names, what_is_open
from raybundle.adjustment.system.factoring import around
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.solve import CAUTIOUS, FLOOR, HUBER, solve
from raybundle.adjustment.system.transformation import fit_to_given
from raybundle.block import Block
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.errors import DatumDefect
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.statistics import family_wise_normal

Start = Literal["approximate", "adjusted"]
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
    used = work.solution.state.xyz[work.system.points_used]
    left_open, _ = what_is_open(work.system, work.solution.state, options, *middle_and_extent(used))
    if left_open.shape[1] != work.datum.defect:
        work.datum = analyse(work.system, work.solution.state, options)
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

    parts = defects.check_components(block, mask, open_of) if datum.defect == 0 or len(block.images) > 1 else 1
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
