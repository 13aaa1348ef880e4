"""Check points: what the adjustment makes of points whose coordinates it did not use, and whether that is as stated."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from scipy.special import chdtri

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.datum import open_values, point_generators
from raybundle.block import Role
from raybundle.errors import Message, Value, message
from raybundle.numerics.arrays import Array, Index, Mask

LEVEL = 1e-3
"""Probability with which differences that are as stated are reported, at most."""
STILL = 0.1
"""Standard deviations that a coordinate may move with an open rotation: half a turn moves it by twice as much."""

NAMED = 5
"""Check points that a message names."""


def used_rays(a: Adjustment) -> Array:
    """Image observations of each object point (p,) that took part."""
    used = a.image_observations.used
    return np.bincount(a.given.observations.point[used], minlength=len(a.given.points)).astype(float)


def check_differences(a: Adjustment) -> tuple[Index, Array]:
    """Positions (k,) of the check points, and adjusted minus given (k, 3); NaN where no ray or no coordinate is.

    Not compared, and NaN: what was filled in to begin with, as a height that nobody measured, and coordinates that the
    observations leave open, which are arbitrary.
    """
    rows = np.flatnonzero(np.asarray(a.given.points.role) == Role.CHECK).astype(np.int32)
    difference = a.adjusted.points.xyz[rows] - a.given.points.xyz[rows]
    if not len(rows):
        return rows, difference
    known = a.given.points.is_check[rows] & (used_rays(a)[rows, None] > 0) & _determined(a, rows)
    return rows, np.where(known, difference, np.nan)


def _determined(a: Adjustment, rows: Index) -> Mask:
    """(k, 3) coordinates of these points that no open part of the datum moves beyond STILL of their std in a radian."""
    if not a.datum_defect:
        return np.ones((len(rows), 3), bool)
    if a.handle.work is None or a.precision is None:
        return np.zeros((len(rows), 3), bool)
    datum, xyz = a.handle.work.datum, a.handle.work.state.xyz[rows]
    moves = np.linalg.norm(point_generators(xyz, datum.centre, datum.extent) @ datum.basis, axis=2)
    return np.isfinite(moves) & (moves <= STILL * np.nan_to_num(a.precision.object_point_std[rows]))


def with_check_notice(a: Adjustment) -> Adjustment:
    """The result as it was given, with what its check points say."""
    found = tuple(n for n in (check_notice(a), open_notice(a)) if n is not None)
    return replace(a, notices=(*found, *a.notices)) if found else a


def open_notice(a: Adjustment) -> Notice | None:
    """Which coordinates of check points are not compared, as the datum leaves them open; None where all are."""
    rows = np.flatnonzero(np.asarray(a.given.points.role) == Role.CHECK)
    seen = a.given.points.is_check[rows] & (used_rays(a)[rows, None] > 0)
    lost = (seen & ~_determined(a, rows)).sum(axis=0)
    if not lost.any():
        return None
    axes = [axis for axis, gone in zip("XYZ", lost, strict=True) if gone]
    part, each = open_values(a.datum_defect)
    values: dict[str, Value] = {"points": len(rows), "axes": axes, "n": len(a.datum_defect), "part": part}
    ids = tuple(a.given.points.ids[k] for k in rows[:100])
    return Notice(code="check_points_open", values=values, ids=ids, details=each)


def check_notice(a: Adjustment) -> Notice | None:
    """What is to be stated of differences at check points that are larger than stated; None where there is nothing.

    Each axis is tested by the mean square of differences over their standard deviations (those of the adjusted and of
    the given coordinates).  Differences of one block are correlated, by its datum above all.  A caution where the mean
    square is beyond chi-square of as many degrees of freedom as there are values, over their number, which holds for
    uncorrelated ones; a fault where it is beyond chi-square of a single one, as if all were one and the same error:
    no correlation explains more.  What an open part of the datum moves is not compared.
    """
    if a.precision is None:
        return None
    rows, difference = check_differences(a)
    if not np.isfinite(difference).any():
        return None
    given = np.nan_to_num(a.given.points.sigma[rows])
    with np.errstate(all="ignore"):
        ratio = difference / np.hypot(a.precision.object_point_std[rows], given)
    found: list[Message] = []
    limits = np.full(3, np.nan)
    severity = Severity.NOTE
    level = LEVEL / 3
    for k, (axis, column) in enumerate(zip("XYZ", ratio.T, strict=True)):
        known = column[np.isfinite(column)]
        if not len(known):
            continue
        square = float(np.mean(known**2))
        apart = float(chdtri(len(known), level)) / len(known)
        if square <= apart:
            continue
        certain = square > float(chdtri(1, level))
        severity = Severity.FAULT if certain else Severity.WARNING if severity is Severity.NOTE else severity
        limits[k] = math.sqrt(float(chdtri(1, level / len(known))))
        found.append(message("check_points_apart.axis", axis=axis, factor=math.sqrt(square), limit=math.sqrt(apart)))
    if not found:
        return None
    beyond = _beyond(ratio, limits)
    ids = a.given.points.ids
    named = [
        message("check_points_apart.point", point=ids[rows[k]], axis="XYZ"[c], factor=size, limit=float(limits[c]))
        for k, c, size in beyond[:NAMED]
    ]
    values: dict[str, Value] = {"n": len(rows), "beyond": len(beyond), "axes": [str(t.values["axis"]) for t in found]}
    return Notice(
        code="check_points_apart", values=values, measured=severity,
        ids=tuple(ids[rows[k]] for k, _, _ in beyond[:NAMED]),
        details=(*found, *(named or [message("check_points_apart.no_single_point")])),
    )  # fmt: skip


def _beyond(ratio: Array, limits: Array) -> list[tuple[int, int, float]]:
    """Check points with a difference beyond its limit, the largest first: row, axis and |ratio| of its worst axis.

    ratio   (k, 3)  differences over their standard deviations, NaN where none is
    limits  (3,)    for the largest of all values of an axis, NaN of an axis that is as stated
    """
    size = np.abs(ratio)
    over = np.where(np.isfinite(size / limits), size / limits, 0.0)
    axis = over.argmax(axis=1)
    largest = over.max(axis=1)
    order = [int(k) for k in np.argsort(-largest) if largest[k] > 1]
    return [(k, int(axis[k]), float(size[k, axis[k]])) for k in order]
