"""Points that are tested together: groups that the user names, and patches of neighbours.

A slope moves as a piece.  The mean displacement of a patch of m points is known better by up to the root of m, and a
movement that no single point shows is found in it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index

PATCH = 8
"""Points of the smallest patches: their mean is three times as precise as a point, and few lie across an edge"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Hypothesis:
    """Points that may have moved as a piece."""

    name: str
    points: Index
    """positions among the common points"""
    given: bool = False
    """whether the user named them"""


@dataclass(frozen=True, slots=True, kw_only=True)
class AreaTest:
    """The test of points as a piece, against all others that stayed."""

    name: str
    given: bool
    points: Index
    displacement: Array
    """(k - 1, 3) mean displacement of each later epoch [m]"""
    covariance: Array
    """(k - 1, 3, 3) [m^2]"""
    F: float
    p_value: float
    moved: bool
    detectable: float
    """length of the smallest mean displacement that is found with 80 % probability [m]"""
    detectable_before: float
    """the same if nothing else moved"""


def areas_of(
    ids: Sequence[str], xyz: Array, groups: Mapping[str, Sequence[str]], *, patches: bool
) -> tuple[Hypothesis, ...]:  # fmt: skip
    """The groups of the user, then patches of neighbours: leaves of halved sets, and their parents up to a half.

    raises  InputError for a group without common points
    """
    place = {name: k for k, name in enumerate(ids)}
    found: list[Hypothesis] = []
    for name, points in groups.items():
        at = np.array(sorted(place[p] for p in points if p in place), np.int64)
        if not len(at):
            raise InputError("epochs.group_empty", name=name)
        found.append(Hypothesis(name=name, points=at, given=True))
    if patches:
        parts = [p for p in halved(xyz, np.arange(len(ids))) if 2 * len(p) <= len(ids)]
        found += [Hypothesis(name=f"area {k + 1}", points=p) for k, p in enumerate(parts)]
    return tuple(found)


def halved(xyz: Array, points: Index) -> list[Index]:
    """All sets that arise where points are halved along their longest axis until a patch is left; the smallest last."""
    if len(points) < PATCH:
        return []
    some = xyz[points] - xyz[points].mean(axis=0)
    along = some @ np.linalg.svd(some, full_matrices=False)[2][0]
    order = points[np.argsort(along, kind="stable")]
    middle = len(order) // 2
    parts = [halved(xyz, np.sort(half)) for half in (order[:middle], order[middle:])]
    return [np.sort(points), *(p for pair in parts for p in pair)]
