"""Redundancy numbers, test values and smallest detectable blunders (Baarda 1968; Förstner 1987)."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from functools import cache

import numpy as np

from raybundle.adjustment.records.figures import ObservationGroup, ObservationStatistics
from raybundle.adjustment.statistics.precision import Cofactors
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.normals import Linearised, Normals
from raybundle.block.rejection import Rejections
from raybundle.numerics import large
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import DELTA0

UNCONTROLLED = 1e-9
"""Redundancy numbers below this leave an observation without a test."""


def image_statistics(
    system: System, whitened: Array, found: Cofactors | None, sigma0: float, rejected: Rejections
) -> ObservationStatistics:
    """Residuals, redundancy numbers, w, t and smallest detectable blunders of the image observations.

    whitened  (m, 2) residuals of the used rows, whitened, image frame
    Correlated image coordinates: w = (P v) / sqrt(P Qvv P), which is v / (s sqrt r) where they are not.  Their
    redundancy numbers, the diagonal of Qvv P, may then lie outside 0 .. 1 (their sum over the point's two coordinates
    does not): the test is decided by P Qvv P alone.
    """
    count = len(system.block.observations)
    single = {"least_control", "rejected", "used"}
    pairs = [f.name for f in fields(ObservationStatistics) if f.name not in single]
    made = {name: large.full((count, 2), np.nan) for name in (pairs if found is not None else pairs[:1])}
    made["least_control"] = large.full(count, np.nan)
    for piece in large.pieces(len(system.rows)):
        for name, values in _of_piece(system, whitened[piece], found, sigma0, piece).items():
            made[name][system.rows[piece]] = values
    empty = large.full((count, 2), np.nan) if found is None else made["residuals_px"]
    return ObservationStatistics(**{**dict.fromkeys(pairs, empty), **made}, rejected=rejected)


def _of_piece(
    system: System, whitened: Array, found: Cofactors | None, sigma0: float, piece: slice
) -> dict[str, Array]:  # fmt: skip
    """The statistics of some of the used rows, by their names."""
    # whitening W = [[a, 0], [b, c]], its products written out: of a million such matrices numpy is slow
    a, b, c = system.whiten[piece].T
    first, second = whitened.T
    pixel_mm = system.pixel_mm[piece]
    residual = np.stack([first / a, (second - b / a * first) / c], axis=1) / pixel_mm
    if found is None:
        return {"residuals_px": residual}
    hat, effects = found.hat[piece], found.effect[piece]
    r_x, r_y, r_xy = 1 - hat[:, 0], 1 - hat[:, 1], -hat[:, 2]
    least = (r_x + r_y) / 2 - np.hypot((r_x - r_y) / 2, r_xy)
    redundancy = np.stack([r_x + r_xy * b / a, r_y - r_xy * b / a], axis=1)
    test = np.stack([r_x * a**2 + 2 * r_xy * a * b + r_y * b**2, r_y * c**2], axis=1)
    weighted = np.stack([a * first + b * second, c * second], axis=1)
    # the variance of P v over P is what the test rests on; where x and y are correlated a redundancy number may be
    # negative although both coordinates are controlled
    weight = np.stack([a**2 + b**2, c**2], axis=1)
    controlled = test > UNCONTROLLED * weight
    safe = np.sqrt(np.where(controlled, test, 1.0))
    w = np.where(controlled, weighted / safe, np.nan) * np.sign(pixel_mm)
    mdb_mm = np.where(controlled, DELTA0 / safe, np.nan)
    by_x = np.abs(effects[:, :, 0] * a[:, None] + effects[:, :, 1] * b[:, None]).max(axis=1)
    by_y = np.abs(effects[:, :, 1]).max(axis=1) * np.abs(c)
    effect = np.stack([by_x, by_y], axis=1) * mdb_mm
    return {
        "residuals_px": residual, "redundancy": redundancy, "w": w, "t": w / sigma0,
        "mdb_px": mdb_mm / np.abs(pixel_mm), "external": effect, "least_control": least,
    }  # fmt: skip


ASKED = 0.01
"""Redundancy numbers below which it is asked what rounding makes of them.

Rounding makes so much only where N_kk Q_kk sums to some 1e12, about what `defects.SHARE` lets pass.
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Tests:
    """What observations that may be correlated have instead of v / sigma and 1 - q / sigma^2 (Baarda 1968)."""

    redundancy: Array
    """(k,) diagonal of Q_vv P"""
    test: Array
    """(k,) diagonal of P Q_vv P, times sigma^2: the redundancy number of an uncorrelated one"""
    weight: Array
    """(k,) diagonal of P, times sigma^2"""
    weighted: Array
    """(k,) P v, times sigma"""

    def of(self, rows: Array) -> _Tests:
        """Those of some rows."""
        return _Tests(
            redundancy=self.redundancy[rows], test=self.test[rows], weight=self.weight[rows],
            weighted=self.weighted[rows],
        )  # fmt: skip


def _group(
    kind: str, ids: Sequence[str], component: Sequence[str], given: Array, sigma: Array, adjusted: Array,
    cofactor: Array, sigma0: float, variance: float, least: Callable[[], float], item: Index, quantity: Index,
    origin: tuple[str, ...] = (), tests: _Tests | None = None,
) -> ObservationGroup:  # fmt: skip
    """Statistics of observations of single quantities with these cofactors; uncorrelated where `tests` is None.

    least  what a redundancy number may be by rounding alone; one within that is 0, its observation uncontrolled
    """
    weighted = sigma > 0
    safe = np.where(weighted, sigma, 1.0)
    residual = adjusted - given
    if tests is None:
        own = np.where(weighted, 1 - cofactor / safe**2, 0.0)
        tests = _Tests(redundancy=own, test=own, weight=np.ones(len(own)), weighted=residual / safe)
    redundancy, test = tests.redundancy, tests.test
    if (np.minimum(redundancy, test)[weighted] < ASKED).any():
        redundancy = np.where(np.abs(redundancy) < least(), 0.0, redundancy)
        test = np.where(np.abs(test) < least() * tests.weight, 0.0, test)
    controlled = test > UNCONTROLLED * tests.weight
    root = np.sqrt(np.where(controlled, test, 1.0))
    w = np.where(controlled, tests.weighted / root, np.nan)
    return ObservationGroup(
        kind=kind, ids=tuple(ids), component=tuple(component), origin=origin,
        item=np.asarray(item, np.int32), quantity=np.asarray(quantity, np.int32), given=given, sigma=sigma,
        adjusted=adjusted,
        adjusted_std=np.sqrt(variance * np.maximum(cofactor, 0)), residual=residual, redundancy=redundancy,
        w=w, t=w / sigma0, mdb=np.where(controlled, DELTA0 * safe / root, np.nan),
        square=np.where(weighted, residual / safe * tests.weighted, 0.0),
    )  # fmt: skip


def observation_groups(
    normals: Normals, state: State, found: Cofactors | None, sigma0: float, variance: float
) -> tuple[ObservationGroup, ...]:
    """Control coordinates, distances, projection centres and observed parameters.

    variance  what covariances are cofactors times

    Redundancy numbers that are `rounding` are 0: their residual, rounding too, by their root would be any test value.
    """
    system, block = normals.system, normals.system.block

    @cache
    def least() -> float:
        return 0.0 if found is None else rounding(normals, state, found)

    groups: list[ObservationGroup] = []
    shift = system.shift
    control = system.control_held | system.prior
    if control.any():
        point, axis = np.argwhere(control).T
        cofactor = np.full(len(point), np.nan) if found is None else found.points_minimal[point, axis, axis]
        sigma = np.where(system.control_held[point, axis], 0.0, block.points.sigma[point, axis])
        groups.append(
            _group(
                "control", [block.points.ids[p] for p in point], ["XYZ"[a] for a in axis],
                block.points.xyz[point, axis], sigma, state.xyz[point, axis] + shift[axis],
                np.where(sigma == 0, 0.0, cofactor), sigma0, variance, least, point, axis,
            )
        )  # fmt: skip
    extra = system.extra
    entries = normals.standardised(state)
    hat, tests = _extra_tests(normals, found, entries)
    residual = entries.residual * extra.sigma
    for part in extra.parts:
        if part.kind.name == "control":
            continue  # above, with the coordinates of eliminated points and the held ones
        i, rows = part.positions, part.rows
        named = part.kind.named(part.table, rows, extra.scope)
        groups.append(
            _group(
                part.kind.name, named.ids, named.component, rows.value + rows.offset, rows.sigma,
                residual[i] + rows.value + rows.offset, hat[i] * rows.sigma**2, sigma0, variance, least, rows.item,
                rows.component, named.origin, tests.of(i) if rows.joint else None,
            )
        )  # fmt: skip
    return tuple(groups)


def _extra_tests(normals: Normals, found: Cofactors | None, entries: Linearised) -> tuple[Array, _Tests]:
    """Diagonal of A Q A' of the extra observations in units of their standard deviations, and what their tests ask.

    All is estimable, hence the same in every datum.  With H = A Q A' and the weights P of those that are correlated,
    Q_vv P = I - H P and P Q_vv P = P - P H P.
    """
    extra = normals.system.extra
    weighted = extra.weighted(entries.residual)
    if found is None:
        none = np.full(len(extra), np.nan)
        return none, _Tests(redundancy=none, test=none, weight=np.ones(len(extra)), weighted=weighted)
    hat, weight = np.zeros(len(extra)), np.ones(len(extra))
    order = np.argsort(entries.row, kind="stable")
    bounds = np.searchsorted(entries.row[order], np.arange(len(extra) + 1))
    together = np.zeros(len(extra), bool)
    for joint in extra.correlated:
        together[joint.rows] = True
    for r in np.flatnonzero(~together):
        mine = order[bounds[r] : bounds[r + 1]]
        unknown, value = entries.unknown[mine], entries.value[mine]
        hat[r] = value @ _cofactors_among(normals, found, unknown) @ value
    redundancy, test = 1 - hat, 1 - hat
    for joint in extra.correlated:
        mine = np.concatenate([order[bounds[r] : bounds[r + 1]] for r in joint.rows])
        unknown, column = np.unique(entries.unknown[mine], return_inverse=True)
        A = np.zeros((len(joint.rows), len(unknown)))
        np.add.at(A, (np.searchsorted(joint.rows, entries.row[mine]), column), entries.value[mine])
        H, P = A @ _cofactors_among(normals, found, unknown) @ A.T, joint.weight
        hat[joint.rows], weight[joint.rows] = np.diagonal(H), np.diagonal(P)
        redundancy[joint.rows] = 1 - np.einsum("ij,ji->i", H, P)
        test[joint.rows] = np.diagonal(P - P @ H @ P)
    return hat, _Tests(redundancy=redundancy, test=test, weight=weight, weighted=weighted)


def _cofactors_among(normals: Normals, found: Cofactors, unknown: Array) -> Array:
    """(u, u) cofactors of unknowns that stand in one row, or in rows that are correlated."""
    offsets = normals.system.offsets
    nodes = np.searchsorted(offsets, unknown, side="right") - 1
    within = unknown - offsets[nodes]
    Q = np.zeros((len(unknown), len(unknown)))
    at = {n: np.flatnonzero(nodes == n) for n in dict.fromkeys(nodes.tolist())}
    for a, i in at.items():
        for b, j in at.items():
            Q[i[:, None], j] = normals.node_block(found.inverse, a, b)[within[i][:, None], within[j]]
    return Q


@dataclass(frozen=True, slots=True, kw_only=True)
class RedundancySum:
    """The sum of all redundancy numbers, which equals the redundancy, and what rounding may make of it."""

    sum: float
    limit: float
    """Of its difference from the redundancy."""


def redundancy_sum(
    work: Work, state: State, found: Cofactors, statistics: ObservationStatistics,
    groups: tuple[ObservationGroup, ...], redundancy: int,
) -> RedundancySum:  # fmt: skip
    """The sum of all redundancy numbers and the limit of its difference from the redundancy.

    The sum is m - tr(N Q).  Forming N rounds each of its elements by some e = 2.2e-16 of what was summed up,
    sqrt(N_ii N_jj) at most, and Q = N^-1 changes by Q dN Q: tr(N Q) by tr(dN Q), e times the sum of N_ii Q_ii over all
    unknowns, N_ii before anything is eliminated.  N_ii Q_ii is the reciprocal of the share of an unknown's information
    that is its own: some 10 in a good network, up to 1e13 where `defects.SHARE` just lets it pass.  Measured on
    degenerate networks with four BLAS kernels the difference is up to 3 times e times that sum; ROUNDINGS is more.
    """
    total = float(np.nansum(statistics.redundancy)) + sum(float(np.nansum(g.redundancy)) for g in groups)
    limit = 1e-6 * max(redundancy, 1)
    if abs(total - redundancy) > limit:  # what rounding explains is looked for only where it is needed
        limit += ROUNDINGS * EPSILON * _information_shares(work.normals, state, found)
    return RedundancySum(sum=total, limit=limit)


ROUNDINGS = 20
"""Units of rounding that a redundancy number, or the sum of all, may be off."""
EPSILON = float(np.finfo(float).eps)
TOGETHER = 20_000
"""Image observations whose partial derivatives are in memory at once: half a kilobyte each."""


def rounding(normals: Normals, state: State, found: Cofactors) -> float:
    """What the redundancy number of a single quantity may be by rounding alone.

    r = 1 - Q_ii / s^2 is a difference.  As in `redundancy_sum`, forming N rounds N_kk by some e of it, and Q_ii changes
    by the sum of Q_ik^2 e N_kk, as Q_ik^2 <= Q_ii Q_kk by no more than e Q_ii sum N_kk Q_kk: r by e times that sum.
    """
    return ROUNDINGS * EPSILON * _information_shares(normals, state, found)


def _information_shares(normals: Normals, state: State, found: Cofactors) -> float:
    """Sum of N_ii Q_ii over all unknowns: of the nodes, and of the object points that are eliminated."""
    from raybundle.adjustment.system.images_numpy import image_residuals

    system = normals.system
    nodes = 0.0
    for k, (a, b) in enumerate(itertools.pairwise(system.offsets.tolist())):
        nodes += float(np.diagonal(normals.node_block(found.inverse, k, k)) @ normals.diagonal[a:b])
    o, N = system.block.observations, np.zeros_like(state.xyz)
    for begin in range(0, len(system.rows), TOGETHER):
        some = slice(begin, begin + TOGETHER)
        image, point = o.image[system.rows[some]], o.point[system.rows[some]]
        partials = image_residuals(system, state, image, point, system.xy_mm[some])[1][:, :, :3] @ state.rotation[image]
        W = np.zeros((len(image), 2, 2))
        W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = system.whiten[some].T
        np.add.at(N, point, ((W @ partials) ** 2).sum(axis=1))
    N[system.prior] += 1 / system.block.points.sigma[system.prior] ** 2
    mine = system.points_used[:, None] & ~system.held & (system.point_node < 0)[:, None]
    return nodes + float((N * np.diagonal(found.points_minimal, axis1=1, axis2=2))[mine].sum())
