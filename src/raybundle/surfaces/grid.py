"""The grid on which heights of a surface are given: cells of a plane of the object, or of level ground in its map.

It is plain data, so that tasks in other processes count with the same.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.io.geo.coordinate_systems import LocalFrame, local_frame
from raybundle.numerics.arrays import Array
from raybundle.workflows.object_plane import MapLevel, Plane
from raybundle.workflows.rectify import Grid


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightPlane:
    """From what heights count, and where its axes go."""

    origin: tuple[float, ...]
    axes: tuple[tuple[float, ...], ...]
    """right, up, normal, in the block's frame"""
    system: str = ""
    """coordinate system of a map, in which heights count as its own do; empty: heights count from the plane"""
    system_origin: tuple[float, ...] = ()
    undulation_m: float | None = None
    metres: float = 1.0
    """in a unit of the block"""

    @classmethod
    def of(cls, plane: Plane) -> HeightPlane:
        """That of a plane of the object."""
        origin, axes = tuple(plane.origin.tolist()), tuple(tuple(row) for row in plane.axes.tolist())
        if not isinstance(plane, MapLevel):
            return cls(origin=origin, axes=axes)
        f = plane.frame
        return cls(
            origin=origin, axes=axes, system=f.crs, system_origin=tuple(f.origin), undulation_m=f.undulation_m,
            metres=plane.metres,
        )  # fmt: skip

    def coordinates(self, xyz: Array) -> Array:
        """(n, 3) right, up and height of points (n, 3) of the block; east, north and height of a map."""
        if not self.system:
            return (xyz - np.array(self.origin)) @ np.array(self.axes).T
        return self._frame().crs_from_local(xyz * self.metres)

    def points(self, uvh: Array) -> Array:
        """The inverse of `coordinates`."""
        if not self.system:
            return uvh @ np.array(self.axes) + np.array(self.origin)
        return self._frame().local_from_crs(uvh) / self.metres

    def jacobian(self, xyz: Array) -> Array:
        """(3, 3) of `coordinates` at a point (3,) of the block."""
        if not self.system:
            return np.array(self.axes)
        uvh = self.coordinates(xyz[None])
        return np.linalg.inv(self._frame().jacobian(uvh)[0]) * self.metres

    def _frame(self) -> LocalFrame:
        return local_frame(self.system, np.array(self.system_origin), undulation_m=self.undulation_m)


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightGrid:
    """Cells above a plane."""

    plane: HeightPlane
    grid: Grid

    def cells(self, uv: Array) -> Array:
        """(n, 2) columns and rows, from the upper left corner, of places (n, 2)."""
        return self.grid.cells(uv)

    def places(self, column: Array, row: Array) -> Array:
        """(n, 2) of the plane: the inverse of `cells`."""
        return self.grid.places(np.stack([column, row], axis=1))

    def points_at(self, column: Array, row: Array, height: Array) -> Array:
        """(n, 3) of the block, of columns and rows (n,) and heights (n,)."""
        return self.plane.points(np.column_stack([self.places(column, row), height]))

    @property
    def unit(self) -> float:
        """Units of the plane in one of the block."""
        return abs(float(np.linalg.det(self.plane.jacobian(np.zeros(3))))) ** (1 / 3)
