"""What moved between the dates of a block: one final adjustment, and displacements with all covariances."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.measuring.joint import Joint
from raybundle.metrology.congruence import SIGNIFICANCE, Congruence
from raybundle.metrology.congruence_model import POWER
from raybundle.metrology.trends import Trend
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.statistics import detectable_noncentrality, fisher_tail
from raybundle.workflows.epochs.cameras import cameras_by_dates
from raybundle.workflows.epochs.dated_points import Dated, Dates, adjusted_again, placed_by_dates
from raybundle.workflows.epochs.matching_errors import MatchingErrors
from raybundle.workflows.epochs.stability import Stability, spread_evenly, stability
from raybundle.workflows.epochs.trends import trends

MOVED, STABLE, IN_AREA, UNCLEAR, UNTESTED = "moved", "stable", "moved_area", "not_significant", "untested"
"""Verdicts: by its own test; one place; apart because the area around it moved; of a point that moved, a date at which
no displacement is significant; displaced, but a wrong image point explains it as well"""
NEIGHBOURS = 3
"""Tested points of which most moved where a point between them is taken to have moved"""
SINGLE = 1000
"""Points beside those of the joint test that are tested each for itself, spread evenly: two solutions of the normal
equations for each.  What lies between tested points follows these"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Displacements:
    """Displacements of points from one date to a later one; rows by point, then by date."""

    point: tuple[str, ...]
    """(r,) names without dates"""
    start: Index
    """(r,) position of the earlier date"""
    end: Index
    xyz: Array
    """(r, 3) at the earlier date [m]"""
    vector: Array
    """(r, 3) [m]"""
    covariance: Array
    """(r, 3, 3) [m^2]"""
    F: Array
    """(r,) of no displacement, 3 degrees of freedom"""
    p_value: Array
    verdict: tuple[str, ...]
    detectable: Array
    """(r,) length of the smallest displacement that is found with 80 % probability, in the direction known worst [m]"""
    detectable_before: Array
    """(r,) the same if no point had moved"""
    p_tested: Array
    """(r,) what the verdict on the point rests on, of all its dates: below `Movements.limit` it moved; NaN: it follows
    its neighbours"""

    def __len__(self) -> int:
        return len(self.point)

    @property
    def length(self) -> Array:
        """(r,) [m]."""
        return np.linalg.norm(self.vector, axis=1)

    @property
    def std(self) -> Array:
        """(r, 3) [m]."""
        return np.sqrt(np.maximum(np.diagonal(self.covariance, axis1=1, axis2=2), 0))

    def exceeds(self, limit: float) -> Array:
        """(r,) probability that a displacement is longer than a limit [m], along the direction that it was found in.

        Limits: what lies across that direction is not counted, so that it is a little too small near the limit.
        """
        return exceeding(self.vector, self.covariance, limit)


def exceeding(vector: Array, covariance: Array, limit: float) -> Array:
    """(r,) probability that displacements (r, 3) are longer than a limit, along their own directions."""
    from scipy.special import ndtr

    length = np.linalg.norm(vector, axis=1)
    way = vector / np.maximum(length, 1e-300)[:, None]
    sigma = np.sqrt(np.maximum(np.einsum("ri,rij,rj->r", way, covariance, way), 1e-300))
    return np.asarray(ndtr((length - limit) / sigma))


@dataclass(frozen=True, slots=True, kw_only=True)
class Movements:
    """What moved, and the adjustment of all dates."""

    dates: Dates
    stability: Stability
    dated: Dated
    """the block of the final adjustment"""
    adjustment: Adjustment
    displacements: Displacements
    limit: float
    """probability below which a single point or area has moved"""
    trends: tuple[Trend, ...]
    """of points and areas that moved, and of given areas; none of two dates"""
    single_rays: int
    """image points left out: the only ones of a point at a date, of points that are not one place"""


def movements(
    block: Block, dates: Dates, *, significance: float = SIGNIFICANCE,
    groups: Mapping[str, Sequence[str]] | None = None,
    datum: Sequence[str] = (), options: AdjustmentOptions | None = None, same_cameras: bool | None = None,
    patches: bool = True, progress: Progress = silent, before: Adjustment | None = None,
) -> Movements:  # fmt: skip
    """Find what moved between the dates of an oriented block, and adjust it once with stable points as one place.

    Arguments and errors as those of `stability`.
    """
    options = options or AdjustmentOptions()
    s = stability(
        block, dates, significance=significance, groups=groups, datum=datum, options=options,
        same_cameras=same_cameras, patches=patches, progress=progress, before=before,
    )  # fmt: skip
    apart = [t.camera for t in s.cameras if not t.shared]
    if same_cameras is False:
        apart = [c.id for c in block.cameras]
    alpha = s.congruence.limit
    # image points that the test found wrong stay out of what it found stable
    stable = set(s.stayed)
    dated, result = _adjusted(block, dates, stable, apart, options, progress, s.result, snooping=False)
    every = _others(dated, s)
    others = spread_evenly(dated, every, np.ones(len(every)), SINGLE)
    found = _pairs(result, dated, others)
    others = np.array(list(dict.fromkeys(found.base.tolist())), np.int64)
    errors = None if s.errors is None else MatchingErrors.of(result, s.errors.shares, s.errors.variance)
    moved, doubtful, p = _by_point(found, dated, errors, alpha)
    near = _near_moved(dated, others, s.congruence.xyz, s.congruence.in_area)
    near = [n and not k for n, k in zip(near, _keep_their_place(found, dated, s.congruence, alpha), strict=True)]
    alike = _near_moved(dated, others, s.congruence.xyz, s.congruence.moved)
    doubtful = [d and not a for d, a in zip(doubtful, alike, strict=True)]
    moved = [m and not d for m, d in zip(moved, doubtful, strict=True)]
    between = every[~np.isin(every, others)]
    gone = np.concatenate([s.congruence.moved, np.array(moved, bool) | np.array(near, bool)])
    follows = _near_moved(dated, between, np.vstack([s.congruence.xyz, _places(dated, others)]), gone)
    more = [
        dated.bases[b]
        for b, m, d, a in zip(others.tolist(), moved, doubtful, near, strict=True)
        if not m and not d and not a
    ]
    more += [dated.bases[b] for b, a in zip(between.tolist(), follows, strict=True) if not a]
    final, last = _adjusted(block, dates, stable | set(more), apart, options, progress, result, snooping=True)
    if last.datum_defect:  # a free network: its datum is that of the points that stayed
        used = last.handle.work.system.points_used if last.handle.work is not None else np.zeros(0, bool)
        there = final.together & (final.at >= 0).any(axis=1)
        names = tuple(final.bases[k] for k in np.flatnonzero(there) if used[int(final.at[k].max())])
        own = replace(options, datum_points=names, reject="none")
        last = decide(replace(last.given, rejected=_rejected(last)), own, progress)
    rows = _all_rows(last, final, s, found, (moved, doubtful, near), p, alpha)
    place = {name: k for k, name in enumerate(final.bases)}
    went = {place[p] for p, v in zip(rows.point, rows.verdict, strict=True) if v in {MOVED, IN_AREA}}
    return Movements(
        dates=dates, stability=s, dated=final, adjustment=last, displacements=rows, limit=alpha,
        trends=trends(last, final, dates, np.array(sorted(went), np.int64), s.congruence.areas),
        single_rays=len(block.observations) - len(final.block.observations),
    )  # fmt: skip


def _rejected(result: Adjustment) -> tuple[tuple[str, str], ...]:
    from raybundle.block.rejection import found_wrong

    return found_wrong(result.given, result.image_observations.rejected)


def _adjusted(
    block: Block, dates: Dates, together: set[str], apart: Sequence[str], options: AdjustmentOptions,
    progress: Progress, before: Adjustment, *, snooping: bool,
) -> tuple[Dated, Adjustment]:  # fmt: skip
    """The adjustment of the block with these points as one place."""
    dated = placed_by_dates(block, dates, sorted(together))
    if apart:
        dated = replace(dated, block=cameras_by_dates(dated.block, dates, apart))
    return dated, adjusted_again(dated.block, dates, options, progress, before, snooping=snooping)


def _others(dated: Dated, s: Stability) -> Index:
    """Points with places at two dates or more that were not in the test."""
    tested = {s.dated.bases[k] for k in s.tested.tolist()}
    return np.array([k for k in np.flatnonzero(dated.spanning).tolist() if dated.bases[k] not in tested], np.int64)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Found:
    """Displacements of bases of a block against their first dates."""

    base: Index
    start: Index
    end: Index
    vector: Array
    covariance: Array
    freedom: float


def _pairs(result: Adjustment, dated: Dated, bases: Index) -> _Found:
    """Displacements of points against their first dates by the joint covariance of both places."""
    joint = Joint.of(result, dated.place)
    metres = 0.001 if result.adjusted.length_unit == "mm" else 1.0
    rows: list[tuple[int, int, int, int, int]] = []
    for b in bases.tolist():
        there = [k for k in np.flatnonzero(dated.at[b] >= 0).tolist() if joint.takes_part(int(dated.at[b, k]))]
        at = dated.at[b, there].tolist()
        rows += [(b, there[0], there[j], at[0], at[j]) for j in range(1, len(at)) if at[j] != at[0]]
    base, start, end, first, last = np.array(rows, np.int64).reshape(-1, 5).T
    xyz = result.adjusted.points.xyz
    freedom = float(result.redundancy) if result.redundancy > 0 else float("inf")
    return _Found(
        base=base, start=start, end=end, vector=metres * (xyz[last] - xyz[first]),
        covariance=metres**2 * joint.of_differences(first, last), freedom=freedom,
    )  # fmt: skip


def _tests(vector: Array, covariance: Array, freedom: float) -> tuple[Array, Array]:
    """F (r,) of no displacement, and its probability."""
    F = np.einsum("ri,rij,rj->r", vector, np.linalg.pinv(covariance, rcond=1e-12, hermitian=True), vector) / 3
    return F, np.array([fisher_tail(float(f), 3, freedom) for f in F])


def _by_point(
    found: _Found, dated: Dated, errors: MatchingErrors | None, alpha: float
) -> tuple[list[bool], list[bool], Array]:  # fmt: skip
    """Of each point by its first row, whether a displacement is significant, and wrong image points explain all.

    Last, the least probability of its displacements, wrong image points included, times their number.
    """
    _, p = _tests(found.vector, found.covariance, found.freedom)
    bases, place, count = np.unique(found.base, return_inverse=True, return_counts=True)
    level = alpha / count[place]
    alone, whole = p < level, p.copy()
    for k in np.flatnonzero(alone).tolist():
        if errors is None:
            break
        points = [int(dated.at[found.base[k], e]) for e in (found.start[k], found.end[k])]
        whole[k] = max(p[k], errors.probability(points, found.vector[k], found.covariance[k]))
    sure = whole < level
    least = np.ones(len(bases))
    np.minimum.at(least, place, whole * count[place])
    order = list(dict.fromkeys(found.base.tolist()))
    significant = [bool(alone[found.base == b].any()) for b in order]
    doubtful = [s and not sure[found.base == b].any() for s, b in zip(significant, order, strict=True)]
    return significant, doubtful, least[np.searchsorted(bases, order)]


def _places(dated: Dated, bases: Index) -> Array:
    """(b, 3) of points at their first dates [m]."""
    at = dated.at[bases]
    first = np.take_along_axis(at, (at >= 0).argmax(axis=1)[:, None], axis=1)[:, 0]
    metres = 0.001 if dated.block.length_unit == "mm" else 1.0
    return metres * dated.block.points.xyz[first]


def _near_moved(dated: Dated, bases: Index, xyz: Array, moved: Mask | None) -> list[bool]:
    """Whether most of the tested points (n, 3) around each of some points moved."""
    if moved is None or not moved.any() or not len(bases):
        return [False] * len(bases)
    from scipy.spatial import KDTree

    k = min(NEIGHBOURS, len(moved))
    nearest = np.asarray(KDTree(xyz).query(_places(dated, bases), k=k)[1]).reshape(len(bases), k)
    return (2 * moved[nearest].sum(axis=1) > k).tolist()


def _keep_their_place(found: _Found, dated: Dated, c: Congruence, alpha: float) -> list[bool]:
    """Whether points agree with no displacement, and not with the mean of the points of areas around each.

    Limits: covariances between a point and those around it are not counted; a point that is not displaced at one of its
    dates is judged by the others.
    """
    if c.in_area is None or not c.in_area.any():
        return [False] * len(dict.fromkeys(found.base.tolist()))
    from scipy.spatial import KDTree

    around = np.flatnonzero(c.in_area)
    order = np.array(list(dict.fromkeys(found.base.tolist())), np.int64)
    k = min(NEIGHBOURS, len(around))
    nearest = around[np.asarray(KDTree(c.xyz[around]).query(_places(dated, order), k=k)[1]).reshape(len(order), k)]
    row = np.searchsorted(np.sort(order), found.base)
    beside = nearest[np.argsort(order, kind="stable")][row]
    first = found.start == 0  # displacements of areas are against the first date
    later = np.maximum(found.end - 1, 0)
    mean = c.displacement[later[:, None], beside].mean(axis=1)
    C = found.covariance + c.covariance[later[:, None], beside].mean(axis=1)
    still = _tests(found.vector, found.covariance, found.freedom)[1] >= alpha
    other = first & (_tests(found.vector - mean, C, found.freedom)[1] < alpha)
    kept = np.array([still[found.base == b].all() and other[found.base == b].any() for b in order], bool)
    return kept.tolist()


def _all_rows(
    result: Adjustment, dated: Dated, s: Stability, found: _Found, decided: tuple[Sequence[bool], ...],
    p_others: Array, alpha: float,
) -> Displacements:  # fmt: skip
    """All displacements: of points apart by the final adjustment, of stable ones as the test found them."""
    c = s.congruence
    place = {name: k for k, name in enumerate(dated.bases)}
    verdict: dict[int, str] = {}
    parts: list[_Found] = []
    sample = np.array([place[i] for i in c.ids], np.int64)
    for k, b in enumerate(sample.tolist()):
        verdict[b] = STABLE if c.stayed[k] else IN_AREA if c.in_area is not None and c.in_area[k] else MOVED
        if c.untested is not None and c.untested[k]:
            verdict[b] = UNTESTED
    bases = list(dict.fromkeys(found.base.tolist()))
    for b, m, d, a in zip(bases, *decided, strict=True):
        verdict[b] = MOVED if m else IN_AREA if a else UNTESTED if d else STABLE
    apart = np.array([b for b, v in verdict.items() if v != STABLE], np.int64)
    final = _pairs(result, dated, apart)
    parts.append(final)
    k = len(c.displacement)
    still = np.flatnonzero([verdict[b] == STABLE for b in sample.tolist()])
    parts.append(
        _Found(
            base=np.repeat(sample[still], k), start=np.zeros(k * len(still), np.int64),
            end=np.tile(np.arange(1, k + 1), len(still)),
            vector=c.displacement[:, still].transpose(1, 0, 2).reshape(-1, 3),
            covariance=c.covariance[:, still].transpose(1, 0, 2, 3).reshape(-1, 3, 3), freedom=final.freedom,
        )
    )  # fmt: skip
    stay = np.array([verdict[b] == STABLE for b in found.base.tolist()], bool)
    parts.append(
        _Found(
            base=found.base[stay], start=found.start[stay], end=found.end[stay], vector=found.vector[stay],
            covariance=found.covariance[stay], freedom=found.freedom,
        )
    )  # fmt: skip
    base, start, end, vector, C = (
        np.concatenate([getattr(p, name) for p in parts]) for name in ("base", "start", "end", "vector", "covariance")
    )
    order = np.lexsort((end, base))
    base, start, end, vector, C = base[order], start[order], end[order], vector[order], C[order]
    F, p = _tests(vector, C, final.freedom)
    words = [verdict[b] for b in base.tolist()]
    rows = np.bincount(base, minlength=len(dated.bases))[base]
    words = [UNCLEAR if w == MOVED and q * r >= 0.05 else w for w, q, r in zip(words, p.tolist(), rows, strict=True)]
    shift = np.sqrt(detectable_noncentrality(alpha, 3, POWER))
    least = shift * np.sqrt(np.maximum(np.linalg.eigvalsh(C)[:, -1], 0))
    if s.errors is not None:
        least = np.maximum(least, _explained(s.errors, s, dated, (base, start, end), C, alpha))
    tested = {b: j for j, b in enumerate(sample.tolist())}
    rests = dict(zip([*sample.tolist(), *bases], [*c.p_value.tolist(), *p_others.tolist()], strict=True))
    assert c.detectable_before is not None
    before = np.array([c.detectable_before[tested[b]] if b in tested else np.nan for b in base.tolist()])
    own = np.array([c.detectable[tested[b]] if b in tested else np.nan for b in base.tolist()])
    metres = 0.001 if result.adjusted.length_unit == "mm" else 1.0
    at = dated.at[base, start]
    xyz = np.where((at >= 0)[:, None], metres * result.adjusted.points.xyz[at], np.nan)
    return Displacements(
        point=tuple(dated.bases[b] for b in base.tolist()), start=start, end=end, xyz=xyz, vector=vector, covariance=C,
        F=F, p_value=p, verdict=tuple(words), detectable=np.where(np.isfinite(own), own, least),
        detectable_before=before, p_tested=np.array([rests.get(b, np.nan) for b in base.tolist()]),
    )  # fmt: skip


def _explained(
    errors: MatchingErrors, s: Stability, dated: Dated, rows: tuple[Index, Index, Index], C: Array, alpha: float
) -> Array:  # fmt: skip
    """(r,) smallest displacements that wrong image points do not explain [m]."""
    place = {name: k for k, name in enumerate(s.dated.bases)}
    at = s.dated.at[[place[dated.bases[b]] for b in rows[0].tolist()]]
    each = np.arange(len(at))
    pairs = np.column_stack([at[each, rows[1]], at[each, rows[2]]]).tolist()
    return np.array([errors.detectable(p, c, alpha) for p, c in zip(pairs, C, strict=True)])
