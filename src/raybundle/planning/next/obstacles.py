"""What a surface of the object hides from stations, and how near to it one may go."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.objects.distance import Distances
from raybundle.objects.sight import Sight
from raybundle.objects.surface import Surface

ASIDE = 0.05
"""Share of the extent of the points or the object, whichever is less, by which half of the points may lie off its
surface: where they lie farther the two are not in one frame."""
OFF_SURFACE = 3.0
"""Times the distance from the surface that nine of ten points have: so far before a point the surface hides nothing."""


@dataclass(frozen=True, kw_only=True)
class Obstacles:
    """A surface in the frame of a block, and its points."""

    surface: Surface
    xyz: Array
    """(t, 3)"""
    sight: Sight
    distances: Distances
    before: float
    """Distance before a point from which on the surface hides"""

    @classmethod
    def of(cls, surface: Surface, xyz: Array) -> Obstacles:
        """Of a surface and points (t, 3) on it; raises InputError where they do not lie on it."""
        distances = Distances(surface)
        off = distances.of(xyz)
        extent = min(surface.extent, float(np.ptp(xyz, axis=0).max()))
        if np.median(off) > ASIDE * extent:
            raise InputError("plan.object_elsewhere", name=surface.name, off=np.median(off), limit=ASIDE * extent)
        sight = Sight(surface)
        before = max(OFF_SURFACE * float(np.quantile(off, 0.9)), sight.off)
        return cls(surface=surface, xyz=xyz, sight=sight, distances=distances, before=before)

    def visible(self, centre: Array, at: Index) -> Mask:
        """(k,) whether nothing stands between a station (3,) and points, by their places (k,)."""
        to = centre - self.xyz[at]
        ahead = to / np.maximum(np.linalg.norm(to, axis=1, keepdims=True), 1e-300)
        # rays begin so far before the point, along themselves: it may lie a little inside of the surface
        return self.sight.visible(centre, self.xyz[at], ahead * self.before / self.sight.off)

    def allowed(self, clearance: float) -> Callable[[Array], Mask]:
        """Which places (n, 3) are outside of the object and so far away from it."""
        low, high = self.surface.bounds
        closed = not self.surface.open_edges

        def places(centre: Array) -> Mask:
            good = np.asarray(self.distances.of(centre) >= clearance)
            rows = np.flatnonzero(good & ((centre > low) & (centre < high)).all(axis=1))
            if closed and len(rows):
                good[rows] = ~self.sight.inside(centre[rows])
            return good

        return places
