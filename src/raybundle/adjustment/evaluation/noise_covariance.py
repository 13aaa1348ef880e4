"""A finished adjustment whose standard deviations are to hold on real photographs: widened once, after convergence.

Estimates, residuals, redundancy numbers, tests and smallest detectable blunders stay as they are.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, ObservationGroup, ParameterResult, Precision
from raybundle.adjustment.result import WHITE, Adjustment, Handle, Noise
from raybundle.adjustment.statistics.interior import joint_tests
from raybundle.adjustment.statistics.network import with_std
from raybundle.adjustment.statistics.noise import noise_of
from raybundle.adjustment.statistics.precision import Cofactors, interior_unknowns, node_cofactor, precision
from raybundle.adjustment.statistics.reliability import observation_groups
from raybundle.adjustment.statistics.system_state import Work
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import correlation


def under_noise(result: Adjustment) -> Adjustment:
    """The result with covariances for smooth errors that differ from image to image, as its own residuals show them.

    result.noise states what was found, or why white noise was kept.
    """
    work: Work | None = result.handle.work
    white = result.precision
    if work is None or work.found is None or white is None:
        return replace(result, noise=replace(WHITE, reason=phrase("noise.no_statistics")))
    if result.redundancy <= 0:
        return replace(result, noise=replace(WHITE, reason=phrase("noise.no_redundancy")))
    variance = result.variance_factor
    noise, found, spread = noise_of(work.normals, work.state, work.found, work.datum, variance)
    if spread is None:
        return replace(result, noise=noise)
    widened = precision(work.normals, work.state, found, variance)
    noise = _with_ratios(noise, work, found, white, widened)
    return replace(
        result,
        precision=widened,
        interior=tuple(_interior(i, work, widened, result.redundancy) for i in result.interior),
        groups=_groups(result, work, found),
        network=None if result.network is None else with_std(result.network, widened.object_point_std),
        options=replace(result.options, noise="fields"),
        noise=noise,
        handle=Handle(replace(work, under_noise=found, spread=spread)),
    )


def _with_ratios(noise: Noise, work: Work, found: Cofactors, white: Precision, widened: Precision) -> Noise:
    """How much wider standard deviations are, and what of it the fields cause."""
    system, normals = work.system, work.normals
    assert work.found is not None
    before, after = list[Array](), list[Array]()
    for row in system.interior:
        if row.node >= 0:
            mine = interior_unknowns(system, row)
            before.append(np.diagonal(node_cofactor(normals, work.found, mine)))
            after.append(np.diagonal(node_cofactor(normals, found, mine)))
    images = _variances(white.images[:, :3, :3]), _variances(widened.images[:, :3, :3])
    points = _variances(white.object_points), _variances(widened.object_points)
    interior = (np.concatenate(before), np.concatenate(after)) if before else None
    q, c = interior or images
    good = (q > 0) & np.isfinite(c)
    share = float(np.mean(1 - noise.phi * q[good] / c[good])) if good.any() else 0.0
    return replace(
        noise, share=max(share, 0.0), ratio_interior=np.nan if interior is None else _ratio(*interior),
        ratio_images=_ratio(*images), ratio_points=_ratio(*points),
    )  # fmt: skip


def _variances(blocks: Array) -> Array:
    return np.diagonal(blocks, axis1=1, axis2=2).ravel()


def _ratio(before: Array, after: Array) -> float:
    good = (before > 0) & np.isfinite(after)
    return float(np.sqrt(np.median(after[good] / before[good]))) if good.any() else np.nan


def _interior(stated: InteriorResult, work: Work, widened: Precision, redundancy: int) -> InteriorResult:
    key = stated.camera if stated.image is None else f"{stated.camera}/{stated.image}"
    row = next(r for r in work.system.interior if r.key(work.system.block) == key)
    if row.node < 0:
        return stated
    C = widened.interior[key]
    std = dict(zip(stated.free, np.sqrt(np.diagonal(C)).tolist(), strict=True))
    values = np.array([stated.parameters[s].value if s in stated.parameters else 0.0 for s in row.model.symbols])
    parameters = {s: _parameter(p, std[s]) if s in std else p for s, p in stated.parameters.items()}
    return replace(
        stated, parameters=parameters, correlations=correlation(C), joint_tests=joint_tests(row, values, C, redundancy)
    )


def _parameter(p: ParameterResult, std: float) -> ParameterResult:
    wider = std / p.std if p.std else 1.0
    return replace(
        p, std=std, std_white=p.std, t=None if p.t is None else p.t / wider,
        effect_std_px=None if p.effect_std_px is None else p.effect_std_px * wider,
    )  # fmt: skip


def _groups(result: Adjustment, work: Work, found: Cofactors) -> tuple[ObservationGroup, ...]:
    """The observations outside the images; only the standard deviations of what is adjusted change."""
    groups = observation_groups(work.normals, work.state, found, result.sigma0, result.variance_factor)
    std = {
        (g.kind, *key): s for g in groups for *key, s in zip(g.ids, g.component, g.adjusted_std.tolist(), strict=True)
    }
    return tuple(
        replace(g, adjusted_std=np.array([std[g.kind, i, c] for i, c in zip(g.ids, g.component, strict=True)]))
        for g in result.groups
    )
