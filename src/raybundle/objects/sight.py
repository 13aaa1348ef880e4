"""Which points of an object a station sees: rays against its triangles.

Rays are cast by trimesh, through Embree where there is a wheel of it and by its own code elsewhere (decision 0023).
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.objects.surface import Surface

OFF = 1e-4
"""By how much of the object's extent rays begin off its surface: 100 times the rounding of single precision."""

Visible = Callable[[Array, Array, Array], Mask]
"""Of the centre (3,) of a station, points (n, 3) and their outward normals (n, 3): which (n,) it sees"""


class Sight:
    """Rays against one surface."""

    def __init__(self, surface: Surface, *, embree: bool | None = None) -> None:
        """Build the tree; embree states by what rays are cast, None: by Embree where it is installed."""
        logging.getLogger("trimesh").setLevel(logging.ERROR)
        import trimesh
        from trimesh import ray

        self.middle = (surface.bounds[0] + surface.bounds[1]) / 2
        self.off = max(OFF * float((surface.bounds[1] - surface.bounds[0]).max()), surface.thickness)
        mesh = trimesh.Trimesh(surface.vertices - self.middle, surface.triangles, process=False, validate=False)
        self.by_embree = bool(ray.has_embree) if embree is None else embree
        # coordinates about the middle: single precision
        tree: Any = ray.ray_pyembree if self.by_embree else ray.ray_triangle
        self.rays = tree.RayMeshIntersector(mesh)

    def visible(self, centre: Array, xyz: Array, normal: Array, beside: float = 0.0) -> Mask:
        """(n,) whether nothing stands between a station and the outer side of points.

        centre  (3,) of the station, or (n, 3) of each point's
        xyz     (n, 3) points on the surface, `normal` (n, 3) their outward normals
        beside  how far the object must be beside a ray at the station, as a share of its length: three rays are cast
                round it then
        """
        if not len(xyz):
            return np.zeros(0, bool)
        to = centre - xyz
        distance = np.linalg.norm(to, axis=1)
        outer = np.einsum("ni,ni->n", to, normal) > 0
        seen = outer & (distance > 0)
        rows = np.flatnonzero(seen)
        if not len(rows):
            return seen
        to = np.broadcast_to(centre, xyz.shape)[rows]
        seen[rows] = self._clear(to, xyz[rows], normal[rows])
        if beside > 0:
            ray = to - xyz[rows]
            across = np.cross(ray, np.eye(3)[np.abs(ray).argmin(axis=1)])
            across *= (
                beside * np.linalg.norm(ray, axis=1, keepdims=True) / np.linalg.norm(across, axis=1, keepdims=True)
            )
            third = np.cross(ray, across) / np.linalg.norm(ray, axis=1, keepdims=True)
            for turn in 2 * np.pi * np.arange(3) / 3:
                left = np.flatnonzero(seen[rows])
                shifted = to[left] + np.cos(turn) * across[left] + np.sin(turn) * third[left]
                seen[rows[left]] = self._clear(shifted, xyz[rows[left]], normal[rows[left]])
        return seen

    def _clear(self, to: Array, xyz: Array, normal: Array) -> Mask:
        """(k,) whether nothing stands between places (k, 3) and points (k, 3)."""
        origin = xyz + self.off * normal - self.middle
        ahead = to - self.middle - origin
        length = np.linalg.norm(ahead, axis=1)
        ahead = ahead / length[:, None]
        hit = np.asarray(self.rays.intersects_any(origin, ahead), bool)
        # what is hit may stand behind the station
        far = np.flatnonzero(hit)
        if len(far):
            _, ray, place = _hits(self.rays, origin[far], ahead[far])
            nearest = np.full(len(far), np.inf)
            np.minimum.at(nearest, ray, np.linalg.norm(place - origin[far][ray], axis=1))
            hit[far] = nearest < length[far]
        return ~hit

    def inside(self, xyz: Array) -> Mask:
        """(n,) whether points (n, 3) lie within a closed surface: a ray upwards leaves it an odd number of times.

        Of a surface that is not closed it states nothing sensible.
        """
        up = np.tile([0.001234, 0.000917, 1.0], (len(xyz), 1))
        _, ray, _ = _hits(self.rays, xyz - self.middle, up / np.linalg.norm(up[0]))
        return np.bincount(ray, minlength=len(xyz)) % 2 == 1


def _hits(rays: Any, origin: Array, ahead: Array) -> tuple[Array, Array, Array]:
    """Triangles, rays and places (k, 3) of all hits."""
    place, ray, triangle = rays.intersects_location(origin, ahead, multiple_hits=True)
    return np.asarray(triangle), np.asarray(ray, int), np.asarray(place, float).reshape(-1, 3)
