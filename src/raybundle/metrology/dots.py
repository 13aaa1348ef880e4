"""Dots without a code in several measurements: numbered anew in each, they are taken as one by their place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block.points import dot_name, dot_number
from raybundle.errors import InputError
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.arrays import Array
from raybundle.numerics.transform import SimilarityTransform, robust_similarity

FEWEST = 3
"""Points with names of their own that bring one measurement onto another."""
AGREE = 0.02
"""Distance within which such a point agrees, as a share of their extent: before it is known what moved."""
WITHIN = 0.5
"""Share of the distance to the next dot within which a dot is the same: nearer to it than to the middle between both.

Limits: a dot that moved by more than half of that distance is another one, or none."""


@dataclass(slots=True)
class Dots:
    """Dots of the measurements so far, in the axes of the first, with the names that they have there."""

    ids: list[str]
    xyz: Array
    """(n, 3) of all points, dots and others"""
    highest: int = 0
    """number of the last dot"""
    by_place: set[str] = field(default_factory=set[str])
    """names of dots that two measurements or more have"""

    @classmethod
    def of(cls, ids: Sequence[str], xyz: Array) -> Dots:
        """Those of a first measurement; xyz (n, 3), NaN where a point has no place."""
        known = np.flatnonzero(np.isfinite(xyz).all(axis=1))
        names = [ids[k] for k in known.tolist()]
        return cls(ids=names, xyz=xyz[known], highest=max((dot_number(i) for i in ids), default=-1) + 1)

    def names(self, ids: Sequence[str], xyz: Array) -> dict[str, str]:
        """What the dots of a further measurement are called here: by their places, others by numbers of their own.

        ids, xyz  its points (n,), (n, 3) in its own axes and unit; others than dots are the same by their names
        """
        dots = [k for k, name in enumerate(ids) if dot_number(name) >= 0]
        placed = [k for k in dots if np.isfinite(xyz[k]).all()]
        onto = self._onto(ids, xyz)
        there = [k for k, name in enumerate(self.ids) if dot_number(name) >= 0]
        found: dict[str, str] = {}
        if onto is not None and placed:
            here = onto.points(xyz[placed])
            for i, j in _pairs(here, self.xyz[there]):
                found[ids[placed[i]]] = self.ids[there[j]]
            self.by_place |= set(found.values())
        for k in dots:
            if ids[k] not in found:
                found[ids[k]] = dot_name(self.highest)
                self.highest += 1
        if onto is not None:
            known = set(self.ids)
            more = [k for k, i in enumerate(ids) if found.get(i, i) not in known and np.isfinite(xyz[k]).all()]
            self.ids += [found.get(ids[k], ids[k]) for k in more]
            self.xyz = np.concatenate([self.xyz, onto.points(xyz[more])])
        return found

    def _onto(self, ids: Sequence[str], xyz: Array) -> SimilarityTransform | None:
        """What brings a measurement onto the first, by the points with names of their own; None where they are few."""
        place = {name: k for k, name in enumerate(self.ids) if dot_number(name) < 0}
        both = [(k, place[i]) for k, i in enumerate(ids) if i in place and np.isfinite(xyz[k]).all()]
        if len(both) < FEWEST:
            return None
        source, target = xyz[[a for a, _ in both]], self.xyz[[b for _, b in both]]
        extent = float(np.linalg.norm(np.ptp(target, axis=0)))
        try:
            return robust_similarity(source, target, AGREE * extent)[0]
        except InputError:  # points in a line
            return None


def _pairs(here: Array, there: Array) -> list[tuple[int, int]]:
    """Dots that are each other's nearest, nearer than half of the way to the next dot of either measurement."""
    from scipy.spatial import KDTree

    if not len(here) or not len(there):
        return []
    d, nearest = KDTree(there).query(here)
    at, back = np.asarray(nearest, np.int64), np.asarray(KDTree(here).query(there)[1], np.int64)
    own, other = _spacing(here), _spacing(there)
    mutual = back[at] == np.arange(len(here))
    near = mutual & (d < WITHIN * np.minimum(own, other[at]))
    return [(int(i), int(at[i])) for i in np.flatnonzero(near)]


def _spacing(xyz: Array) -> Array:
    """(n,) distance of each point to the nearest other; infinite for a single one."""
    from scipy.spatial import KDTree

    return KDTree(xyz).query(xyz, k=2)[0][:, 1] if len(xyz) > 1 else np.full(len(xyz), np.inf)


def dots_alike(sets: Sequence[PointSet]) -> tuple[list[PointSet], tuple[str, ...]]:
    """The measurements with their dots called alike where they are one by their place; the names of these."""
    if not sets or not any(dot_number(i) >= 0 for s in sets for i in s.ids):
        return list(sets), ()
    known = Dots.of(sets[0].ids, sets[0].xyz)
    found = [sets[0]]
    for each in sets[1:]:
        names = known.names(each.ids, each.xyz)
        found.append(replace(each, ids=tuple(names.get(i, i) for i in each.ids)))
    return found, tuple(sorted(known.by_place, key=dot_number))
