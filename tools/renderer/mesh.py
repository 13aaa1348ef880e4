"""Rays cast on triangles."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .height_field import BLOCK

Array = NDArray[np.float64]
RIM = 1e-9
"""How far beyond its sides a triangle is met, in barycentric coordinates: no ray passes between two of them."""


class Mesh:
    """Triangles in space.

    triangles  (n, 3, 3)  corners [m]; counter-clockwise as seen from outside
    """

    def __init__(self, triangles: Array) -> None:
        self.triangles = np.asarray(triangles, dtype=float)
        a, b, c = np.moveaxis(self.triangles, 1, 0)
        normal = np.cross(b - a, c - a)
        self.normals = normal / np.linalg.norm(normal, axis=1, keepdims=True)
        self.middles = self.triangles.mean(axis=1)
        self.radii = np.linalg.norm(self.triangles - self.middles[:, None], axis=2).max(axis=1)
        # Barycentric coordinates of b and c of a point p in the plane are (p - a) @ dual.
        u, v = b - a, c - a
        uu, uv, vv = (np.einsum("ni,ni->n", p, q) for p, q in ((u, u), (u, v), (v, v)))
        d = uu * vv - uv * uv
        self._dual_u = (vv[:, None] * u - uv[:, None] * v) / d[:, None]
        self._dual_v = (uu[:, None] * v - uv[:, None] * u) / d[:, None]

    def meet(self, triangle: int, origins: Array, directions: Array) -> Array:
        """Multiples (...) of directions at which lines meet a triangle; NaN where they pass it."""
        normal, corner = self.normals[triangle], self.triangles[triangle, 0]
        slant = directions @ normal
        with np.errstate(divide="ignore", invalid="ignore"):
            t = ((corner - origins) @ normal) / slant
            place = origins + t[..., None] * directions - corner
            u, v = place @ self._dual_u[triangle], place @ self._dual_v[triangle]
        inside = (u >= -RIM) & (v >= -RIM) & (u + v <= 1 + RIM) & np.isfinite(t)
        return np.where(inside, t, np.nan)

    def near_lines(self, origins: Array, directions: Array) -> NDArray[np.intp]:
        """Triangles whose surrounding sphere meets one of the lines (n, 3) at least."""
        unit = directions / np.linalg.norm(directions, axis=1, keepdims=True)
        away = self.middles[None] - origins[:, None]
        along = np.einsum("nti,ni->nt", away, unit)
        beside2 = np.einsum("nti,nti->nt", away, away) - along**2
        return np.flatnonzero((beside2 <= self.radii**2 * (1 + 1e-9)).any(axis=0))

    def cast(self, origins: Array, directions: Array) -> tuple[Array, NDArray[np.intp]]:
        """Where rays (m, n, 3) first meet the mesh: multiples (m, n) of their directions and triangles (m, n).

        m and n are multiples of BLOCK, neighbours in the arrays are neighbours in the photograph. Rays that meet
        nothing have infinity and -1. Exact: each triangle is tried for the blocks of rays whose cone meets the sphere
        around it.
        """
        shape = directions.shape[:2]
        o, d = (_blocks(np.broadcast_to(part, directions.shape)) for part in (origins, directions))
        t, index = np.full(d.shape[:2], np.inf), np.full(d.shape[:2], -1, dtype=np.intp)
        blocks, triangles = self._candidates(o, d)
        for triangle in np.unique(triangles):
            chosen = blocks[triangles == triangle]
            new = self.meet(int(triangle), o[chosen], d[chosen])
            nearer = (new > 0) & (new < t[chosen])
            t[chosen] = np.where(nearer, new, t[chosen])
            index[chosen] = np.where(nearer, triangle, index[chosen])
        return _unblocked(t, shape), _unblocked(index, shape)

    def _candidates(self, o: Array, d: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Pairs of blocks and triangles: the cone around a block's rays meets the sphere around the triangle."""
        unit = d[:, [0, BLOCK - 1, -BLOCK, -1]]
        unit = unit / np.linalg.norm(unit, axis=2, keepdims=True)
        axis = unit.mean(axis=1)
        axis /= np.linalg.norm(axis, axis=1, keepdims=True)
        # The corner rays enclose the others but for the curvature of distortion, for which a tenth is added.
        opening = 1.1 * np.arccos(np.clip(np.einsum("bkc,bc->bk", unit, axis).min(axis=1), -1, 1))
        start = o[:, [0, BLOCK - 1, -BLOCK, -1]].mean(axis=1)
        spread = np.linalg.norm(o[:, [0, BLOCK - 1, -BLOCK, -1]] - start[:, None], axis=2).max(axis=1)
        along = axis @ self.middles.T - np.einsum("bc,bc->b", axis, start)[:, None]
        beside2 = (
            (start**2).sum(axis=1)[:, None] - 2 * start @ self.middles.T + (self.middles**2).sum(axis=1) - along**2
        )
        width = np.tan(opening)[:, None] * along + (self.radii + spread[:, None]) / np.cos(opening)[:, None]
        blocks, triangles = np.nonzero((width > 0) & (beside2 <= width**2 * (1 + 1e-9) + 1e-12))
        return blocks, triangles


def _blocks(part: Array) -> Array:
    """Vectors (m, n, 3) by block, (blocks, BLOCK^2, 3)."""
    m, n, k = part.shape
    return part.reshape(m // BLOCK, BLOCK, n // BLOCK, BLOCK, k).swapaxes(1, 2).reshape(-1, BLOCK * BLOCK, k)


def _unblocked(part: NDArray, shape: tuple[int, ...]) -> NDArray:
    m, n = shape
    return part.reshape(m // BLOCK, n // BLOCK, BLOCK, BLOCK).swapaxes(1, 2).reshape(m, n)


def rectangle(corner: Array, side: Array, other: Array) -> Array:
    """Two triangles (2, 3, 3) of a parallelogram; its outside is that of side x other."""
    a, b, c, d = corner, corner + side, corner + side + other, corner + other
    return np.array([[a, b, c], [a, c, d]])


def box(low: Array, high: Array) -> Array:
    """The triangles of a box without its floor (the side of least z)."""
    x, y, z = (np.array(axis, dtype=float) for axis in np.diag(np.asarray(high) - np.asarray(low)))
    low = np.asarray(low, dtype=float)
    faces = [(low + z, x, y), (low, x, z), (low + y, z, x), (low, z, y), (low + x, y, z)]
    return np.concatenate([rectangle(*face) for face in faces])


def sphere(middle: Array, radius: float, rings: int) -> Array:
    """Triangles with corners on a sphere, as many in a ring as rings are in twice a quarter."""
    polar = np.linspace(0, np.pi, rings + 1)
    around = np.linspace(0, 2 * np.pi, 2 * rings + 1)
    ring = np.stack(
        [
            np.outer(np.sin(polar), np.cos(around)),
            np.outer(np.sin(polar), np.sin(around)),
            np.outer(np.cos(polar), np.ones_like(around)),
        ],
        axis=-1,
    )
    a, b, c, d = ring[:-1, :-1], ring[1:, :-1], ring[1:, 1:], ring[:-1, 1:]
    first, second = np.stack([a, b, c], axis=2)[1:], np.stack([a, c, d], axis=2)[:-1]
    first = np.concatenate([first, np.stack([a, b, c], axis=2)[:1]])
    unit = np.concatenate([first.reshape(-1, 3, 3), second.reshape(-1, 3, 3)])
    area = np.linalg.norm(np.cross(unit[:, 1] - unit[:, 0], unit[:, 2] - unit[:, 0]), axis=1)
    return np.asarray(middle) + radius * unit[area > 1e-9]
