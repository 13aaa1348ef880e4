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

SMALLEST = 5
"""Points of the smallest patches; each further size has about twice as many, up to half of all"""


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
    joint: Array
    """(k - 1, 3, k - 1, 3) covariance of all of them [m^2]"""
    F: float
    p_value: float
    moved: bool
    detectable: float
    """length of the smallest mean displacement that is found with 80 % probability [m]"""
    detectable_before: float
    """the same if nothing else moved"""
    p_uniform: float
    """probability that its points have one displacement in common"""
    uneven: bool
    """whether they have not: the mean displacement is then that of no point"""
    shortest: Array
    """(k - 1,) length of the smallest displacement of a point, of each later epoch [m]"""
    longest: Array
    """(k - 1,) of the largest [m]"""

    @property
    def covariance(self) -> Array:
        """(k - 1, 3, 3) of each epoch [m^2]."""
        at = np.arange(len(self.joint))
        return self.joint[at, :, at, :]


def groups_of(ids: Sequence[str], groups: Mapping[str, Sequence[str]]) -> tuple[Hypothesis, ...]:
    """The groups of the user; raises InputError for a group without common points."""
    place = {name: k for k, name in enumerate(ids)}
    found: list[Hypothesis] = []
    for name, points in groups.items():
        at = np.array(sorted(place[p] for p in points if p in place), np.int64)
        if not len(at):
            raise InputError("epochs.group_empty", name=name)
        found.append(Hypothesis(name=name, points=at, given=True))
    return tuple(found)


def patches_of(xyz: Array) -> tuple[Hypothesis, ...]:
    """Patches around every point: its nearest neighbours, 5, 9, 17 ... of them, up to half of all points."""
    from scipy.spatial import KDTree

    n = len(xyz)
    sizes = [SMALLEST]
    while 2 * (2 * sizes[-1] - 1) <= n:
        sizes.append(2 * sizes[-1] - 1)
    if n < 2 * SMALLEST:
        return ()
    nearest = np.asarray(KDTree(xyz).query(xyz, k=sizes[-1])[1], np.int64)
    found = dict.fromkeys(tuple(sorted(row[:size])) for size in sizes for row in nearest.tolist())
    return tuple(Hypothesis(name=f"area {k + 1}", points=np.array(p)) for k, p in enumerate(found))


def sums_of(areas: Sequence[Hypothesis], points: int) -> Array:
    """(h, n) 1 where a point belongs to an area."""
    Z = np.zeros((len(areas), points))
    for k, a in enumerate(areas):
        Z[k, a.points] = 1.0
    return Z
