"""Control that nothing fits: whether the photographs fit one another without it, and which point is wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from raybundle.adjustment.blunders.control_tests import ControlTests
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role, Stations
from raybundle.block.select import with_rows
from raybundle.errors import InputError, Message, NotSolvable, Value, message
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import robust_similarity, similarity
from raybundle.placing.mirror_mends import USUAL, mirror_causes, mirror_mends
from raybundle.placing.mirrored_images import hand_of_images

ROUNDS = 3
"""Points that are left out, one after the other; fewer than a third, or what is left explains as little."""
EXCHANGED = 10
"""Points, those that agree least with the others, of which each two are tried in each other's place."""
DECIDEDLY = 2.0
"""Ratio of the misfits of two exchanges from which the better one is worth an adjustment."""
FEWEST = 3
"""Points that show a contradiction, and not where it is."""
ROUGHLY = 0.01
"""Share of the extent of the control up to which points agree, to begin with those that do not."""

Adjust = Callable[[Block, AdjustmentOptions], Adjustment]


@dataclass(frozen=True, slots=True, kw_only=True)
class Doubt:
    """What control does to photographs that fit without it."""

    alone: float
    """sigma0 without any control"""
    wrong: tuple[str, ...]
    """Points without which the others fit; () where no few points explain it"""
    left: float
    """sigma0 without these"""
    names: tuple[str, ...]
    """All control points"""
    exchange: bool = False
    """Whether all fits with the two points of `wrong` exchanged"""
    mirror: tuple[str, ...] = ()
    """Single mends of control in a system of the other hand that fit the block's orientation, the likeliest first"""
    images: str | None = None
    """Mend of the image axes beside `mirror`: "" where the given orientation contradicts it, None where it is open"""
    apart: tuple[Array, Array] | None = None
    """Where the observed projection centres are what control contradicts: mean and standard deviation (3,) of the
    centres as observed minus as the photographs have them with control alone; NaN for an axis that was not observed"""

    @property
    def is_explained(self) -> bool:
        """Whether everything else fits, scale bars and positions included, once this control is mended or left out."""
        return bool(self.exchange or self.mirror or self.wrong)


def doubted_control(
    block: Block, failed: Adjustment | None, options: AdjustmentOptions, adjust: Adjust
) -> Doubt | None:
    """Whether control is what does not fit; None where the photographs contradict themselves, or nothing shows.

    failed  the adjustment with all control, which fits poorly; None where there is none
    adjust  of a block with the approximate values that it was given

    Likelihood ratio: leaving out a point of k coordinates, the square sum W falls to W', and with right coordinates
    F = ((W - W') / k) / (W' / r') is distributed as F(k, r') (k directions less where the point had part in the datum).
    Unlike the force on the held point (`adjustment.blunders.control_tests`) it does not rest on a solution that a
    large error has bent; it costs an adjustment a point, which is why the point goes first that agrees least with the
    others.
    """
    control = np.flatnonzero(block.points.is_control.any(axis=1))
    brief = replace(options, statistics=False, reject="none", estimate="given", datum="auto", noise="white")
    free = _tried(as_ties(block, control), brief, adjust)
    if free is None or free.sigma0 > POOR_FIT:
        return None
    names = tuple(block.points.ids[k] for k in control)
    if len(block.stations.image):
        by_control = _tried(block.having(Stations.empty()), brief, adjust)
        if by_control is not None and by_control.sigma0 <= POOR_FIT:
            gap = block.stations.xyz - by_control.adjusted.images.centre[block.stations.image]
            known = np.isfinite(gap).any(axis=0)
            apart = np.full(3, np.nan), np.full(3, np.nan)
            apart[0][known], apart[1][known] = np.nanmean(gap[:, known], axis=0), np.nanstd(gap[:, known], axis=0)
            return Doubt(alone=free.sigma0, wrong=(), left=by_control.sigma0, names=names, apart=apart)
    _, source, target = _known_control(block, free)
    if (mirror := mirror_mends(block, source, target, lambda b: _tried(b, brief, adjust))) is not None:
        hand = hand_of_images(block, free.adjusted)
        mends, images = (USUAL, None) if hand is None else (mirror[0], hand[0])
        return Doubt(alone=free.sigma0, wrong=(), left=mirror[1], names=names, mirror=mends, images=images)
    if (found := _exchanged(block, free, brief, adjust)) is not None:
        points, left = found
        return Doubt(alone=free.sigma0, wrong=points, left=left, names=names, exchange=True)
    out: list[int] = []
    before = failed
    for k in _by_misfit(block, free)[: min(ROUNDS, max(1, (len(control) - 1) // 3))]:
        out.append(k)
        tried = _tried(as_ties(block, np.array(out)), brief, adjust)
        if tried is None:
            continue
        count = int(block.points.is_control[k].sum())
        if before is not None and not _significant(before, tried, count, options.significance / len(control)):
            out.pop()
            continue
        before = tried
        if tried.sigma0 <= POOR_FIT:
            out, tried = _refined(block, out, tried, brief, adjust)
            wrong = tuple(block.points.ids[p] for p in out)
            return Doubt(alone=free.sigma0, wrong=wrong, left=tried.sigma0, names=names)
    return Doubt(alone=free.sigma0, wrong=(), left=float("nan"), names=names)


def doubt_message(doubt: Doubt, sigma0: float) -> Message:
    """What is wrong with the control; sigma0 NaN where the adjustment failed."""
    solved = bool(np.isfinite(sigma0))
    values: dict[str, Value] = {"solved": solved, "sigma0": sigma0 if solved else None, "limit": POOR_FIT}
    mended = {**values, "mended": doubt.left}
    if doubt.mirror:
        cause, mends = mirror_causes(doubt.mirror, doubt.images)
        mirrored: dict[str, Value] = {**mended, "cause": cause, "mends": [*doubt.mirror]}
        return Message(code="control_contradicts.mirrored", values=mirrored, details=mends)
    if doubt.exchange:
        return Message(code="control_contradicts.exchanged", values={**mended, "names": list(doubt.wrong)})
    if doubt.wrong:
        n = len(doubt.wrong)
        return Message(code="control_contradicts.points", values={**mended, "n": n, "names": list(doubt.wrong)})
    if doubt.apart is not None:
        each = zip("XYZ", *doubt.apart, strict=True)
        axes = [
            message("control_contradicts.axis", axis=axis, apart=float(m), sigma=float(s))
            for axis, m, s in each if np.isfinite(m)
        ]  # fmt: skip
        both = {**values, "centres": doubt.alone, "control": doubt.left}
        return Message(code="control_contradicts.centres", values=both, details=tuple(axes))
    alone = {**values, "alone": doubt.alone, "n": len(doubt.names), "names": list(doubt.names)}
    if len(doubt.names) == FEWEST:
        return Message(code="control_contradicts.one_of_few", values=alone)
    return Message(code="control_contradicts.unexplained", values=alone)


def notice(doubt: Doubt, sigma0: float) -> Notice:
    """The fault of a result."""
    m = doubt_message(doubt, sigma0)
    return Notice(
        code=m.code, values=m.values, details=m.details, ids=doubt.wrong or doubt.names[:100], measured=Severity.FAULT
    )


def _tried(block: Block, options: AdjustmentOptions, adjust: Adjust) -> Adjustment | None:
    try:
        return adjust(block, options)
    except (InputError, NotSolvable):
        return None


def _significant(before: Adjustment, after: Adjustment, count: int, level: float) -> bool:
    if after.redundancy < 1 or after.weighted_square_sum <= 0:
        return False
    gained = (before.weighted_square_sum - after.weighted_square_sum) / count
    F = gained / (after.weighted_square_sum / after.redundancy)
    return F > 0 and fisher_tail(F, count, after.redundancy) < level


def as_ties(block: Block, points: Index) -> Block:
    """The block in which these control points are tie points; those with a single ray are left out."""
    role, sigma, xyz = np.array(block.points.role), block.points.sigma.copy(), block.points.xyz.copy()
    role[points], sigma[points], xyz[points] = Role.TIE, np.nan, np.nan
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    lone = points[rays[points] < 2]
    loose = replace(block, points=replace(block.points, role=role, sigma=sigma, xyz=xyz))
    if not len(lone):
        return loose
    distances = np.isin(block.distances.start, lone) | np.isin(block.distances.end, lone)
    return loose if distances.any() else with_rows(loose, ~np.isin(block.observations.point, lone))


def _refined(
    block: Block, out: list[int], tried: Adjustment, options: AdjustmentOptions, adjust: Adjust
) -> tuple[list[int], Adjustment]:
    """The points that are left out so that control fits roughly: with those that still contradict, less the right ones.

    What fits roughly is near enough to the truth for tests of single points (`control_tests`); a point that without
    much contradiction can return beside those was left out for their sake.
    """
    found = list(out)
    for _ in range(ROUNDS):
        tested = _tried(as_ties(block, np.array(found)), replace(options, statistics=True), adjust)
        wrong = [] if tested is None else [p for p in ControlTests(tested).contradiction.wrong if not p.others]
        tried = tested or tried
        if not wrong:
            break
        found += [k for p in wrong if (k := block.points.ids.index(p.name)) not in found]
    else:
        tried = _tried(as_ties(block, np.array(found)), options, adjust) or tried
    level = options.significance / max(int(block.points.is_control.any(axis=1).sum()), 1)
    for k in out:
        rest = [p for p in found if p != k]
        again = _tried(as_ties(block, np.array(rest)), options, adjust) if rest else None
        if again is not None and not _significant(again, tried, int(block.points.is_control[k].sum()), level):
            found, tried = rest, again
    return found, tried


def _exchanged(
    block: Block, free: Adjustment, options: AdjustmentOptions, adjust: Adjust
) -> tuple[tuple[str, ...], float] | None:
    """Two control points with which in each other's place all fits; the points, and sigma0 then.

    None where no exchange does, or two do nearly alike.
    """
    rows, source, target = _known_control(block, free)
    if len(rows) < 3:
        return None
    extent = float(np.linalg.norm(np.ptp(target, axis=0)))

    def misfit(xyz: Array) -> float:
        try:
            return float(np.linalg.norm(similarity(source, xyz).points(source) - xyz))
        except InputError:
            return np.inf

    worst = _farthest(source, target, ROUGHLY * extent)[:EXCHANGED]
    tries: list[tuple[float, tuple[int, int]]] = []
    for i, j in combinations(worst, 2):
        other = target.copy()
        other[[i, j]] = target[[j, i]]
        tries.append((misfit(other), (i, j)))
    tries.sort()
    if not tries or DECIDEDLY * tries[0][0] > min(misfit(target), *(m for m, _ in tries[1:2])):
        return None
    points, pair = block.points, [int(rows[k]) for k in tries[0][1]]
    xyz, sigma = points.xyz.copy(), points.sigma.copy()
    xyz[pair], sigma[pair] = xyz[pair[::-1]], sigma[pair[::-1]]
    tried = _tried(replace(block, points=replace(points, xyz=xyz, sigma=sigma)), options, adjust)
    if tried is None or tried.sigma0 > POOR_FIT:
        return None
    names = tuple(points.ids[k] for k in pair)
    return names, tried.sigma0


def _known_control(block: Block, free: Adjustment) -> tuple[Index, Array, Array]:
    """Control points (k,) with three coordinates: where the photographs alone have them, and where they were given."""
    index = {name: k for k, name in enumerate(block.points.ids)}
    at = {index[name]: xyz for name, xyz in zip(free.adjusted.points.ids, free.adjusted.points.xyz, strict=True)}
    whole = block.points.is_control.all(axis=1)
    rows = np.array([k for k in np.flatnonzero(whole).tolist() if k in at and np.isfinite(at[k]).all()], int)
    return rows, np.array([at[k] for k in rows.tolist()]).reshape(-1, 3), block.points.xyz[rows]


def _by_misfit(block: Block, free: Adjustment) -> list[int]:
    """Control points in order of their distance from where the photographs alone have them, the farthest first."""
    rows, source, target = _known_control(block, free)
    if len(rows) < 4:
        return []
    extent = float(np.linalg.norm(np.ptp(target, axis=0)))
    return [int(rows[k]) for k in _farthest(source, target, ROUGHLY * extent)]


def _farthest(source: Array, target: Array, tolerance: float) -> list[int]:
    """Points (n, 3) in order of their distance from those (n, 3) that most of them agree with, the farthest first."""
    try:
        onto, _ = robust_similarity(source, target, tolerance)
    except InputError:
        return list(range(len(source)))
    gap = np.linalg.norm(onto.points(source) - target, axis=1)
    return np.argsort(-gap, kind="stable").tolist()
