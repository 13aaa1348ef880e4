"""From an adjusted system to what is returned: residuals, tests, precision, interior orientation, notices."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from typing import Literal

import numpy as np

from raybundle.adjustment.evaluation.held_interiors import determined_by_network
from raybundle.adjustment.evaluation.queries import suspects
from raybundle.adjustment.notices import notices_of
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
from raybundle.adjustment.statistics.components import variance_components
from raybundle.adjustment.statistics.interior import interior_results
from raybundle.adjustment.statistics.network import network_figures
from raybundle.adjustment.statistics.precision import (
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
from raybundle.adjustment.system.adjusted_values import adjusted_block
from raybundle.adjustment.system.datum import NAMES, SHORT, Datum
from raybundle.block import Block
from raybundle.block.rejection import Rejections
from raybundle.errors import Text, phrase
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.statistics import family_wise_normal, family_wise_tau, global_test

Extent = Literal["report", "decisions", "tests", "residuals"]


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
