"""The part of an object that a surface is measured of: areas in plan of a plane or a map, whatever the height."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.missions.polygons import inside
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.grid import HeightPlane

Ring = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceRegion:
    """Areas of a plane; plain data, so that tasks in other processes know the same."""

    plane: HeightPlane
    areas: tuple[tuple[Ring, ...], ...]
    """of each its rings, the outer one and holes, with their corners in coordinates of the plane"""

    @classmethod
    def of(cls, plane: HeightPlane, areas: Sequence[Sequence[Array]]) -> SurfaceRegion:
        """That of rings (k, 2)."""
        plain = tuple(tuple(tuple(map(tuple, np.asarray(r, float).tolist())) for r in rings) for rings in areas)
        return cls(plane=plane, areas=plain)

    @property
    def extent(self) -> Array:
        """(4,) left, bottom, right, top."""
        corners = np.array([corner for rings in self.areas for corner in rings[0]])
        return np.concatenate([corners.min(axis=0), corners.max(axis=0)])

    def holds(self, xyz: Array) -> Mask:
        """Which points (n, 3) of the block lie above or below the areas."""
        return self._within(self.plane.coordinates(xyz)[:, :2])

    def meets(self, one: Array, other: Array) -> Mask:
        """Which straight lines (n,) between points (n, 3) of the block pass above or below the areas."""
        a, b = (self.plane.coordinates(x)[:, :2] for x in (one, other))
        found = self._within(a) | self._within(b)
        for rings in self.areas:
            for ring in rings:
                corners = np.array(ring)
                for c, d in zip(corners, np.roll(corners, -1, axis=0), strict=True):
                    apart = _side(c, d, a) * _side(c, d, b) <= 0
                    found |= apart & (_side(a, b, c) * _side(a, b, d) <= 0)
        return found

    def _within(self, uv: Array) -> Mask:
        """Which places (n, 2) lie in an area; holes do not."""
        found = np.zeros(len(uv), bool)
        for rings in self.areas:
            mine = np.zeros(len(uv), bool)
            for ring in rings:
                mine ^= inside(np.array(ring), uv)
            found |= mine
        return found


def _side(a: Array, b: Array, p: Array) -> Array:
    """On which side of the line from a to b points lie, by its sign; (..., 2) each."""
    d, q = b - a, p - a
    return np.sign(d[..., 0] * q[..., 1] - d[..., 1] * q[..., 0])
