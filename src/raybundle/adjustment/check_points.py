"""Check points: what the adjustment makes of points whose coordinates it did not use, and whether that is as stated."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from scipy.special import chdtri

from raybundle.adjustment.result import Adjustment, Notice
from raybundle.adjustment.severity import Severity
from raybundle.block import Role
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.counting import counted

LEVEL = 1e-3
"""Probability with which differences that are as stated are told, at most."""


def used_rays(a: Adjustment) -> Array:
    """Image observations of each object point (p,) that took part."""
    used = a.image_observations.used
    return np.bincount(a.given.observations.point[used], minlength=len(a.given.points)).astype(float)


def check_differences(a: Adjustment) -> tuple[Index, Array]:
    """Positions (k,) of the check points, and adjusted minus given (k, 3); NaN where no ray or no coordinate is.

    What was filled in to begin with, as a height that nobody measured, is not compared.
    """
    rows = np.flatnonzero(np.asarray(a.given.points.role) == Role.CHECK).astype(np.int32)
    difference = a.adjusted.points.xyz[rows] - a.given.points.xyz[rows]
    known = a.given.points.is_check[rows] & (used_rays(a)[rows, None] > 0)
    return rows, np.where(known, difference, np.nan)


def with_check_notice(a: Adjustment) -> Adjustment:
    """The result as it was given, with what its check points say."""
    told = check_notice(a)
    return a if told is None else replace(a, notices=(told, *a.notices))


def check_notice(a: Adjustment) -> Notice | None:
    """What is to be said of differences at check points that are larger than stated; None where there is nothing.

    Each axis is tested by the mean square of differences over their standard deviations (those of the adjusted and of
    the given coordinates).  Differences of one block are correlated, by its datum above all.  A caution where the mean
    square is beyond chi-square of as many degrees of freedom as there are values, over their number, which holds for
    uncorrelated ones; a fault where it is beyond chi-square of a single one, as if all were one and the same error:
    no correlation explains more.  Where part of the datum is arbitrary nothing is compared.
    """
    if a.precision is None or a.datum_defect:
        return None
    rows, difference = check_differences(a)
    if not np.isfinite(difference).any():
        return None
    given = np.nan_to_num(a.given.points.sigma[rows])
    with np.errstate(all="ignore"):
        ratio = difference / np.hypot(a.precision.object_point_std[rows], given)
    told: list[str] = []
    severity = Severity.REMARK
    level = LEVEL / 3
    for axis, column in zip("XYZ", ratio.T, strict=True):
        known = column[np.isfinite(column)]
        if not len(known):
            continue
        square = float(np.mean(known**2))
        apart = float(chdtri(len(known), level)) / len(known)
        if square <= apart:
            continue
        certain = square > float(chdtri(1, level))
        severity = Severity.FAULT if certain else Severity.CAUTION if severity is Severity.REMARK else severity
        told.append(f"{axis} {math.sqrt(square):.2g} times (limit {math.sqrt(apart):.2g})")
    if not told:
        return None
    size = np.nan_to_num(np.abs(ratio)).max(axis=1)
    worst = [a.given.points.ids[rows[k]] for k in np.argsort(-size)[:5] if size[k] > 0]
    return Notice(
        code="check_points_apart",
        message=f"{counted(len(rows), 'check point')}: differences are larger than the standard deviations of the "
        f"result and of the given coordinates predict, in {', '.join(told)}; largest at {', '.join(worst)}. "
        "The result is wrong, or the coordinates given are, or their names, axes, unit or system; the standard "
        "deviations of the result are not to be relied upon until this is explained",
        ids=tuple(worst), measured=severity,
    )  # fmt: skip
