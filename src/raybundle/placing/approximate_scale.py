"""Scale of the approximate values against that of scale bars: a common factor is a unit, where one explains it."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError, Value
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import factor_unit
from raybundle.numerics.transform import similarity

SURE = 3.0
"""Standard deviations of a factor within which a unit explains it."""
WIDEST, NARROWEST = 0.05, 0.002
"""Relative distances from a unit's factor: the largest one that names a unit, and what is allowed in any case.

Approximate values in a unit of their own have any factor: that it is within 0.05 of one of the eight that are named,
among six orders of magnitude, has the probability 8 * 2 * 0.05 / ln(1e6) = 5.8 %; as a rule the distance is smaller."""


def scale_of_start(block: Block, adjusted: Block) -> tuple[float, float]:
    """Factor from adjusted to approximate lengths, and its relative standard deviation; NaN where nothing was given.

    Of the stations and of the points, the one of smaller standard deviation.
    """
    index = {name: k for k, name in enumerate(adjusted.images.ids)}
    rows = [(k, index[name]) for k, name in enumerate(block.images.ids) if name in index and block.images.oriented[k]]
    found = [_factor(block.images.centre[[a for a, _ in rows]], adjusted.images.centre[[b for _, b in rows]])]
    index = {name: k for k, name in enumerate(adjusted.points.ids)}
    rows = [(k, index[name]) for k, name in enumerate(block.points.ids) if name in index]
    found.append(_factor(block.points.xyz[[a for a, _ in rows]], adjusted.points.xyz[[b for _, b in rows]]))
    return min(found, key=lambda f: f[1] if np.isfinite(f[1]) else np.inf)


def _factor(given: Array, own: Array) -> tuple[float, float]:
    """Factor from own to given places (n, 3) and its relative standard deviation, by a similarity transform."""
    there = np.isfinite(given).all(axis=1) & np.isfinite(own).all(axis=1)
    given, own = given[there], own[there]
    try:
        onto = similarity(own, given)
    except InputError:  # too few, or in a line
        return float("nan"), float("nan")
    redundancy = 3 * len(own) - 7
    if redundancy < 1:
        return float("nan"), float("nan")
    sigma = np.sqrt(np.sum(onto.residuals**2) / redundancy)
    return onto.scale, float(sigma / np.linalg.norm(own - own.mean(axis=0)) / onto.scale)


def start_scale_notices(block: Block, result: Adjustment) -> list[Notice]:
    """A caution where bars alone fix the scale, and a unit explains how the approximate values differ from it."""
    scale_is_given = np.any(block.points.is_control) or len(block.stations.image)
    if not len(block.distances) or scale_is_given or "scale" in result.datum_defect:
        return []
    factor, std = scale_of_start(block, result.adjusted)
    near = max(SURE * std, NARROWEST)
    if not near < WIDEST:
        return []
    own = block.length_unit
    bars = factor_unit(1 / factor, own, near)
    start = factor_unit(factor, own, near)
    if not (bars or start):
        return []
    values: dict[str, Value] = {
        "factor": 1 / factor, "std": std, "of": "bars" if bars else "start", "likely": bars or start, "unit": own,
    }  # fmt: skip
    return [Notice(code="approximate_scale", values=values)]
