"""Distances of points from a true surface of triangles, and the class of place that they stand in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from .classes import BORDER, STEP
from .mesh import Mesh

Array = NDArray[np.float64]
REACH = 0.1
"""Longest distance of a point from the surface that is searched [m]."""
CREASE_DEG = 20.0
"""Faces that differ by less are taken for one curved face."""
SAMPLES = 7


@dataclass(frozen=True, slots=True, kw_only=True)
class MeshSurface:
    """The true surface of a rendered mesh; the same questions as to `truth.Surface`.

    codes  (n,)  class of each triangle
    core   (2,)  half sides [m] along X and Z of what is judged
    """

    mesh: Mesh
    codes: NDArray[np.int8]
    core: Array
    gsd: float

    def in_core(self, points: Array) -> NDArray[np.bool_]:
        """Whether points (n, 3) stand in the rectangle that is judged."""
        return np.all(np.abs(points[:, [0, 2]]) <= self.core, axis=1)

    def normals(self, points: Array, half: float) -> Array:
        """Normals (n, 3) of the triangles nearest to points (n, 3)."""
        del half
        return self.mesh.normals[self._nearest(points)]

    def classes_at(self, points: Array, half: float) -> NDArray[np.int8]:
        """Class of place of points (n, 3): `step` where faces that differ are within `half` [m] of the point."""
        nearest = self._nearest(points)
        code, own = self.codes[nearest].copy(), self.mesh.normals[nearest]
        least = np.cos(np.radians(CREASE_DEG))
        crease = np.zeros(len(points), dtype=bool)
        for triangle, part in self._around(points, half):
            near = self._distance(triangle, points[part]) < half
            close = part[near]
            crease[close] |= own[close] @ self.mesh.normals[triangle] < least
            code[close] = np.where(code[close] == self.codes[triangle], code[close], BORDER)
        code[crease] = STEP
        return code

    def distances(self, points: Array, normals: Array, reach: float = REACH) -> Array:
        """Distances (n,) [m] of points (n, 3) from the surface along unit normals (n, 3), positive outside.

        Of several places where the line meets the surface the nearest counts. NaN where it meets none within `reach`.
        """
        found = np.full(len(points), np.nan)
        for triangle, part in self._around(points, reach):
            off = -self.mesh.meet(triangle, points[part], normals[part])
            nearer = np.abs(off) < np.where(np.isnan(found[part]), reach, np.abs(found[part]))
            found[part[nearer]] = off[nearer]
        return found

    def window_distances(self, points: Array, normals: Array, half: float) -> Array:
        """Distances (n,) [m] along normals from the surface averaged over a window in the tangent plane."""
        first = np.cross(normals, np.where(np.abs(normals[:, :1]) < 0.9, (1.0, 0, 0), (0, 1.0, 0)))
        first /= np.linalg.norm(first, axis=1, keepdims=True)
        second = np.cross(normals, first)
        steps = half * (np.arange(SAMPLES) + 0.5 - SAMPLES / 2) / (SAMPLES / 2)
        places = (
            points[:, None, None]
            + steps[:, None, None] * first[:, None, None]
            + steps[None, :, None] * second[:, None, None]
        )
        many = np.repeat(normals, SAMPLES**2, axis=0)
        found = self.distances(places.reshape(-1, 3), many).reshape(len(points), -1)
        count = np.isfinite(found).sum(axis=1)
        return np.where(count > 0, np.nansum(found, axis=1) / np.maximum(count, 1), np.nan)

    def _nearest(self, points: Array) -> NDArray[np.intp]:
        """The nearest triangle of each point."""
        least, nearest = np.full(len(points), np.inf), np.zeros(len(points), dtype=np.intp)
        for triangle, part in self._around(points, REACH):
            distance = self._distance(triangle, points[part])
            nearer = distance < least[part]
            least[part[nearer]], nearest[part[nearer]] = distance[nearer], triangle
        return nearest

    def _around(self, points: Array, reach: float) -> Iterator[tuple[int, NDArray[np.intp]]]:
        """Triangles and the points that may be within `reach` of each."""
        tree = KDTree(points)
        found = tree.query_ball_point(self.mesh.middles, self.mesh.radii + reach)
        for triangle, part in enumerate(found):
            if part:
                yield triangle, np.array(part)

    def _distance(self, triangle: int, points: Array) -> Array:
        """Distances (n,) of points from a triangle."""
        corners = self.mesh.triangles[triangle]
        normal = self.mesh.normals[triangle]
        sides: list[Array] = []
        for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            along = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
            sides.append(np.linalg.norm(points - a - along[:, None] * (b - a), axis=1))
        inside = np.isfinite(self.mesh.meet(triangle, points, np.broadcast_to(normal, points.shape)))
        return np.where(inside, np.abs((points - corners[0]) @ normal), np.min(sides, axis=0))
