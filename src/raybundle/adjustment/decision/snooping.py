"""Steps of data snooping: which suspects leave in a round, which rejected image observations return."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from raybundle.adjustment.blunders.separability import unlocatable
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import DELTA0, axis_tests, axis_weights


def bent_by_distances(result: Adjustment, suspects: Array, size: Array) -> Mask:
    """(k,) which suspects are rays to ends of distances that are themselves more suspect than any of these rays.

    A bar that is wrong tears at the points at its ends, and at those of the others: without these rays it would stand
    unopposed.  A ray that is wrong shows more than the distance that it moves.
    """
    ends, worst = np.zeros(len(result.given.points), bool), 0.0
    for g in result.groups:
        if g.kind == "distance":
            worst = max(worst, float(np.nanmax(np.abs(g.t), initial=0.0)))
    if worst <= result.critical_tau:
        return np.zeros(len(suspects), bool)
    ends[result.given.distances.start] = ends[result.given.distances.end] = True
    mine = ends[result.given.observations.point[suspects]]
    return np.asarray(mine & (worst >= size[suspects][mine].max(initial=0.0)), bool)


def without_reasons(reasons: Rejections, rows: Collection[int]) -> Rejections:
    """The reasons without those of observations that return."""
    out = set(rows)
    return tuple(None if i in out else r for i, r in enumerate(reasons))


def with_rejected(result: Adjustment, reasons: Rejections, chosen: Array, size: Array) -> Rejections:
    """The reasons with those of these suspects, or of all rays of a point whose wrong one cannot be determined."""
    new = list(reasons)
    point = result.given.observations.point
    whole: dict[int, Rejection] = {}
    for i, lost in zip(chosen, unlocatable(result, chosen), strict=True):
        axis = int(np.nanargmax(np.abs(result.image_observations.t[i])))
        kind = RejectionKind.BLUNDER_NOT_LOCATED if lost else RejectionKind.BLUNDER
        why = Rejection(kind=kind, tau=float(size[i]), limit=result.critical_tau, axis="xy"[axis])
        if lost:
            whole[int(point[i])] = why
        else:
            new[i] = why
    for k in np.flatnonzero(np.isin(point, list(whole))):
        new[k] = new[k] or whole[int(point[k])]
    return tuple(new)


def apart(block: Block, size: Array, suspects: Array) -> list[int]:
    """Suspects in order of size, one for each object point and few for each image: one blunder's smear is spared.

    Of a point only its largest suspect is a candidate; where its image has enough of them, the point waits for the
    next round, as the smear on its other rays would take its place.
    """
    points: set[int] = set()
    images: dict[int, int] = {}
    chosen: list[int] = []
    counts = np.bincount(block.observations.image, minlength=len(block.images))
    for i in suspects[np.argsort(-size[suspects], kind="stable")]:
        image, point = int(block.observations.image[i]), int(block.observations.point[i])
        first = point not in points
        points.add(point)
        if not first or images.get(image, 0) >= max(1, counts[image] // 100):
            continue
        images[image] = images.get(image, 0) + 1
        chosen.append(int(i))
    return chosen


def is_spread(result: Adjustment, chosen: Sequence[int], suspects: Array) -> bool:
    """Whether suspects are single ones: all leave in one round, and nothing outside the images is suspect."""
    largest = max((float(np.nanmax(np.abs(g.t), initial=0.0)) for g in result.groups), default=0.0)
    return len(chosen) == len(suspects) and largest <= result.critical_tau


def tau_values(result: Adjustment, now: Adjustment) -> Array:
    """(m,) larger test value of an image observation by residuals of `now`, without statistics; 0: took no part.

    result  nearly the same with statistics: without a few observations a redundancy number is at most smaller, so that
            no test value here is too large
    """
    C = result.given.observations.cov_px2
    weighted = axis_tests(now.image_observations.residuals_px, C) * np.sqrt(axis_weights(C))
    t = weighted * result.image_observations.mdb_px / (DELTA0 * now.sigma0)
    return np.nan_to_num(np.abs(t).max(axis=1))


def is_blunder(reason: Rejection | None) -> bool:
    """Whether an image observation was rejected as a blunder of its own."""
    return reason is not None and reason.kind is RejectionKind.BLUNDER


def innocent(result: Adjustment) -> list[int]:
    """Rejected blunders whose residual against the present result is below the critical value."""
    from raybundle.adjustment.system.predict import residuals_px

    block = result.adjusted
    rows = np.array([i for i, r in enumerate(result.image_observations.rejected) if is_blunder(r)], int)
    if not len(rows):
        return []
    t = axis_tests(residuals_px(block, rows), block.observations.cov_px2[rows])
    size = np.abs(t).max(axis=1) / (result.sigma0 or 1.0)
    return [int(i) for i, s in zip(rows, size, strict=True) if s < result.critical_tau]
