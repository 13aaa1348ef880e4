"""Tie points made clean: adjustment and rejection by residuals in turn, until nothing changes.

This is for the many tie points of automatic matching, before precision is asked for: limits follow the median of the
residuals, so neither the weights nor sigma0 need to be right, and thousands of wrong rays leave in a few rounds.  Data
snooping on redundancy numbers comes after it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.estimation import estimate_only
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.progress import Progress, silent

FIRST = 46.0
ROUNDS = 14
MEDIAN = 1 / 1.0518
"""Standard deviation of two normal variables by the median of the larger of their magnitudes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cleaned:
    """A block with adjusted approximate values and the rows that do not fit."""

    block: Block
    rejected: Mask
    """(m,)"""
    scale: float
    """Standard deviation of the residuals, in units of the stated ones, by their median"""
    rounds: int


def clean(
    block: Block,
    options: AdjustmentOptions,
    free: dict[str, tuple[str, ...]],
    *,
    rejected: Mask | None = None,
    limit: float = 7.0,
    first: float = FIRST,
    progress: Progress = silent,
) -> Cleaned:
    """Adjust and reject in turn.

    free      free parameters by camera id
    rejected  (m,) what is left out at the start; it may return
    limit     largest residual that stays at the end, in robust standard deviations of all residuals
    first     the same in the first round; halved from round to round
    Of one object point the worst ray leaves first, because it bends the others; points left with one ray leave.
    """
    m = len(block.observations)
    mask = np.zeros(m, bool) if rejected is None else rejected.copy()
    mask = _without_single_rays(block, mask)
    scale, k = 1.0, 0
    for k in range(ROUNDS):
        progress("cleaning", k / ROUNDS)
        settings = replace(options, robust_start=first / 2**k > 2 * limit, tolerance=1e-2, max_iterations=25)
        block, bad = estimate_only(block, settings, free, mask)
        size = sizes(block)
        size[bad] = np.inf
        scale = max(MEDIAN * float(np.median(size[~mask])), 1e-12)
        bound = scale * max(limit, first / 2**k)
        new = _rejected(block, size, bound, mask)
        changed = int((new != mask).sum())
        mask = new
        if changed <= m // 5000 and bound <= scale * limit * (1 + 1e-9):
            break
    progress("cleaning", 1.0)
    return Cleaned(block=block, rejected=mask, scale=scale, rounds=k + 1)


def sizes(block: Block) -> Array:
    """Larger of the two residuals of every image observation in units of its sigma (m,); inf where there is none."""
    v = residuals_px(block, np.arange(len(block.observations)))
    size = np.abs(v / np.sqrt(block.observations.cov_px2[:, :2])).max(axis=1)
    size[~np.isfinite(size)] = np.inf
    return size


def _rejected(block: Block, size: Array, bound: float, before: Mask) -> Mask:
    """Rows beyond the bound: of each point the worst and those far beyond; rejected ones that fit well return."""
    point = block.observations.point
    over = size > np.where(before, 0.8 * bound, bound)
    worst = np.zeros(len(block.points))
    np.maximum.at(worst, point[~before], size[~before])
    leave = over & ~before & ((size >= worst[point]) | (size > 4 * bound))
    return _without_single_rays(block, leave | (before & over))


def _without_single_rays(block: Block, mask: Mask) -> Mask:
    """Rows of tie points that are left with fewer than two rays leave as well."""
    point = block.observations.point
    rays = np.bincount(point[~mask], minlength=len(block.points))
    control = np.atleast_1d(block.points.is_control.any(axis=1))
    return mask | ((rays[point] < 2) & ~control[point])
