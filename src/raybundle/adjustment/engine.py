"""Adjust a block with approximate values: estimate, datum, statistics.

What is free and what is rejected is decided by the caller (`decide`); here it is carried out.
"""

from __future__ import annotations

import time
from dataclasses import replace

from raybundle.adjustment.blunders.collinear_points import check_turning
from raybundle.adjustment.blunders.control_notices import precise_control_notices
from raybundle.adjustment.blunders.image_fields import own_field_notices
from raybundle.adjustment.estimation import Start, carry_out
from raybundle.adjustment.evaluation.cell_means import systematic_notices
from raybundle.adjustment.evaluation.held_interiors import steadied, without_priors
from raybundle.adjustment.evaluation.noise_covariance import under_noise
from raybundle.adjustment.evaluation.tie_roughness import relief_notices, with_roughness
from raybundle.adjustment.evaluation.unusual_noise import unusual_noise_notices
from raybundle.adjustment.notices import with_group_notices
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.result_figures import Extent, result_of
from raybundle.adjustment.statistics.components import Found, settled_components
from raybundle.adjustment.statistics.reliability import (
    image_statistics,
    observation_groups,
)
from raybundle.adjustment.system.adjusted_values import started
from raybundle.block import Block, Camera, Instrument
from raybundle.block.rejection import Rejections
from raybundle.errors import NoConvergence, RankDefect, TooFewObservations
from raybundle.numerics.progress import Progress, silent


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
