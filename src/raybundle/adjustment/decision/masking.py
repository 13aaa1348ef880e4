"""Gross errors that mask one another, found by a robust estimate and its median.

Pope's test divides by sigma0, which gross errors themselves enlarge: a share e of them of equal size has test values
of about 1 / sqrt(e), so that none passes a critical value of 4.4 where e > 1 / 4.4^2 = 5 % (with errors of different
sizes a little later).  The median of the residuals of a robust estimate stays: it breaks down at one half.
Rousseeuw and Leroy 1987, chapters 1 and 5; Huber 1981.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.blunders.separability import FEWEST
from raybundle.adjustment.estimation import estimate_only
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import POOR_FIT
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.errors import NotSolvable
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import axis_tests, family_wise_normal

MEDIAN = 0.6745
"""Median of the absolute value of a standard normal variable."""
MASKED = 2.0
"""Ratio of rms to median-based scale from which gross errors mask one another: three quarters of the variance.

Student's t with three degrees of freedom has 1.5."""
UNCLEAN = 1.5
"""sigma0 after a robust estimate from which more of them are likely: what it leaves is clean, with sigma0 about 1."""
LEAST_SHARE = 0.2
"""Smallest redundancy number of an observation whose residual enters the scale."""
FINITE = 0.5
"""Share of the points that must have a place for an estimate to be one."""
PASSES = 12
"""Estimates of the observations that remain; the set settles in three to six."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Unmasked:
    """What a robust estimate finds in a block whose gross errors mask one another."""

    block: Block
    reasons: Rejections
    rejected: int
    ratio: float
    """sigma0 over the median-based scale, before"""


def is_suspect(result: Adjustment) -> bool:
    """Whether residuals are far larger than stated: reason enough for a robust estimate."""
    return result.sigma0 >= POOR_FIT


def ratio_of(result: Adjustment) -> float:
    """sigma0 over the median-based scale of the image residuals; 1 for normal errors, NaN without redundancy."""
    t = np.abs(result.image_observations.t)
    t = t[np.isfinite(t) & (t > 0)]
    return MEDIAN / float(np.median(t)) if len(t) else float("nan")


def unmasked(
    block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], reasons: Rejections, spared: Mask,
    redundancy: Array | None = None,
) -> Unmasked | None:  # fmt: skip
    """The block without the observations that a robust estimate finds wrong; None where nothing is masked.

    spared      (m,) observations that stay in any case
    redundancy  (m, 2) of an adjustment of the block, by which residuals are standardised; None: all alike
    """
    given = np.array([r is not None and r.kind is not RejectionKind.BLUNDER for r in reasons], bool)
    robust = replace(options, robust_start=True, statistics=False)
    found = _estimated(block, robust, free, given)
    if found is None:
        return None
    start, bad = found
    if (given | bad).all():
        return None
    size, scale = _sizes(start, ~given & ~bad, redundancy)
    whole = float(np.sqrt(np.mean(size[~given & ~bad] ** 2)))
    limit = family_wise_normal(options.significance, 2 * int((~given).sum()))
    out = given | bad | ((size > limit * scale) & ~spared)
    brief = replace(options, robust_start=False, statistics=False, tolerance=max(options.tolerance, 1e-3))
    for _ in range(PASSES):
        lone = _too_few(start, out)
        found = _estimated(start, brief, free, out | lone)
        if found is None:
            return None
        start, bad = found
        inside = ~out & ~lone & ~bad
        if not inside.any():
            return None
        size, scale = _sizes(start, inside, redundancy)
        new = given | bad | ((size > limit * scale) & ~spared)
        if np.array_equal(new, out):
            break
        out = new
    if not whole >= MASKED * scale or _whole_images(block, out & ~given, ~given):
        return None
    out = given | _wrong(start, out & ~given)
    new_reasons = list(reasons)
    for i in np.flatnonzero(out & ~given):
        kept = new_reasons[i]
        tau = min(float(size[i] / scale), 1e6)
        new_reasons[i] = kept or Rejection(
            kind=RejectionKind.BLUNDER, tau=tau, limit=limit, axis="xy"[_axis(start, int(i))]
        )
    for i in np.flatnonzero(~out & ~given):
        new_reasons[i] = None
    _leave_unlocated(start, new_reasons, limit)
    return Unmasked(block=start, reasons=tuple(new_reasons), rejected=int((out & ~given).sum()), ratio=whole / scale)


def _estimated(
    block: Block, options: AdjustmentOptions, free: dict[str, tuple[str, ...]], mask: Mask
) -> tuple[Block, Mask] | None:
    """`estimate_only`; None where there is no solution, or one that is nowhere."""
    try:
        with np.errstate(all="ignore"):  # gross errors may bring points into one place on the way
            start, bad = estimate_only(block, options, free, mask)
    except (NotSolvable, np.linalg.LinAlgError):
        return None
    used = np.unique(block.observations.point[~mask])
    return (start, bad) if np.isfinite(start.points.xyz[used]).all(axis=1).mean() > FINITE else None


def masked_notices(result: Adjustment, found: Unmasked | None) -> list[Notice]:
    """What a reader must know of gross errors that masked one another, or still do."""
    ratio, sigma0 = ratio_of(result), result.sigma0
    if sigma0 >= (POOR_FIT if found is None else UNCLEAN):
        count = sum(r is not None for r in result.image_observations.rejected)
        return [
            Notice(
                code="snooping_masked",
                values={"rejected": count, "sigma0": sigma0, "ratio": ratio},
            )
        ]
    if found is None:
        return []
    return [
        Notice(
            code="snooping_robust",
            values={"rejected": found.rejected, "ratio": found.ratio},
        )
    ]


def _sizes(block: Block, inside: Mask, redundancy: Array | None) -> tuple[Array, float]:
    """Largest standardised residual (m,) of each observation, and the scale from the median of those inside."""
    rows = np.arange(len(block.observations))
    with np.errstate(all="ignore"):
        try:
            w = np.abs(axis_tests(residuals_px(block, rows), block.observations.cov_px2))
        except np.linalg.LinAlgError:
            return np.full(len(rows), np.inf), 1.0
    w = np.where(np.isfinite(w), w, 1e12)
    if redundancy is not None:
        share = np.where(np.isfinite(redundancy), redundancy, 1.0)
        controlled = share[inside] >= LEAST_SHARE
        w = w / np.sqrt(np.maximum(share, LEAST_SHARE))
        if controlled.any():
            return w.max(axis=1), float(np.median(w[inside][controlled])) / MEDIAN or 1.0
    scale = float(np.median(w[inside])) / MEDIAN
    free = 1 - _unknowns(block, inside) / max(2 * int(inside.sum()), 1)
    return w.max(axis=1), scale / np.sqrt(max(free, 0.05)) or 1.0


def _unknowns(block: Block, inside: Mask) -> int:
    o = block.observations
    points = len(np.unique(o.point[inside]))
    return 3 * points + 6 * len(np.unique(o.image[inside]))


def _whole_images(block: Block, out: Mask, asked: Mask) -> bool:
    """Whether images lose most of their observations while others do not: no gross errors, but images or a model."""
    image, n = block.observations.image, len(block.images)
    count = np.bincount(image[asked], minlength=n)
    share = np.bincount(image[out], minlength=n) / np.maximum(count, 1)
    return bool(((count >= FEWEST) & (share > 0.5) & (share > 2 * np.median(share[count > 0]))).any())


def _wrong(block: Block, suspects: Mask) -> Mask:
    """(m,) suspects without those of control points and ends of distances most rays of which are suspect.

    There it is the coordinates or the length that contradict the photographs, and their own tests name them.
    """
    o = block.observations
    given = np.any(block.points.is_control, axis=1) | block.points_named
    rays = np.bincount(o.point, minlength=len(given))
    mostly = given & (2 * np.bincount(o.point[suspects], minlength=len(given)) >= rays)
    return suspects & ~mostly[o.point]


def _too_few(block: Block, out: Mask) -> Mask:
    """(m,) remaining rays of tie points that have no second one."""
    o = block.observations
    left = np.bincount(o.point[~out], minlength=len(block.points))
    control = np.any(block.points.is_control, axis=1)
    return ~out & (left[o.point] == 1) & ~control[o.point]


def _leave_unlocated(block: Block, reasons: list[Rejection | None], limit: float) -> None:
    """Reject all rays of tie points of which fewer than three are left: the wrong one cannot be located."""
    o = block.observations
    wrong = [i for i, r in enumerate(reasons) if r is not None and r.kind is RejectionKind.BLUNDER]
    left = np.bincount(
        np.asarray(o.point)[[i for i, r in enumerate(reasons) if r is None]], minlength=len(block.points)
    )
    touched = np.bincount(o.point[wrong], minlength=len(block.points)) > 0
    lost = touched & (left < FEWEST) & ~block.points.is_control.any(axis=1) & ~block.points_named
    for i in np.flatnonzero(lost[o.point]):
        was = reasons[i]
        tau, axis = (was.tau, was.axis) if was is not None else (float("nan"), "")
        reasons[i] = Rejection(kind=RejectionKind.BLUNDER_NOT_LOCATED, tau=tau, limit=limit, axis=axis)


def _axis(block: Block, row: int) -> int:
    with np.errstate(all="ignore"):
        v = axis_tests(residuals_px(block, np.array([row])), block.observations.cov_px2[[row]])[0]
    return int(np.argmax(np.abs(np.nan_to_num(v))))
