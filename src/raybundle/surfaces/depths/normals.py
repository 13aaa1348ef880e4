"""Normals of the planes of a depth map, the object's area that a pixel shows, and incidences.

Rays change so smoothly over a picture that their directions and derivatives are reported between nodes a few pixels
apart; that is as good as a normal deserves, and a hundredth of the work.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid
from raybundle.surfaces.depths.roughness import APART_PX

STEP_PX = 16.0
"""From node to node: a direction of a fisheye with c = 500 px errs by 1e-4 between them, its derivatives by less."""
CHUNK = 50_000
"""Pixels at once."""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Directions:
    """Directions of rays, and how origins and directions change with the pixel."""

    nodes: Array
    """(rows, columns, 15) float32 direction; origin and direction by column; the same by row [1 / px]"""
    rays: ReferenceRays

    @classmethod
    def of(cls, rays: ReferenceRays) -> _Directions:
        columns, rows = (int(np.ceil(n / STEP_PX)) + 1 for n in (rays.camera.width_px, rays.camera.height_px))
        u, v = np.meshgrid(np.arange(columns) * STEP_PX, np.arange(rows) * STEP_PX)
        xy = np.stack([u.ravel(), v.ravel()], axis=1)
        found = [rays.rays(xy)[1]]
        for half in 0.5 * np.eye(2):
            (o0, d0), (o1, d1) = rays.rays(xy - half), rays.rays(xy + half)
            found += [o1 - o0, d1 - d0]
        return cls(nodes=np.concatenate(found, axis=1).reshape(rows, columns, 15).astype(np.float32), rays=rays)

    def at(self, xy_px: Array) -> tuple[Array, Array, Array]:
        """Directions (n, 3), and (n, 2, 3) each of origins and directions by column and row."""
        rows, columns = self.nodes.shape[:2]
        x, y = (xy_px / STEP_PX).astype(np.float32).T
        i, j = np.clip(x.astype(int), 0, columns - 2), np.clip(y.astype(int), 0, rows - 2)
        fx, fy = (x - i)[:, None], (y - j)[:, None]
        top, low = ((1 - fx) * self.nodes[j + k, i] + fx * self.nodes[j + k, i + 1] for k in (0, 1))
        both = (1 - fy) * top + fy * low
        by = both[:, 3:].reshape(-1, 2, 2, 3)
        return both[:, :3], by[:, :, 0], by[:, :, 1]


def smoothed(slopes: Array, known: Mask, stride: int) -> Array:
    """Means of slopes (2, rows, columns) over a pixel and neighbours; a window on an edge has a slope of no thing."""
    size = 2 * round(APART_PX / stride) + 1

    def total(values: Array) -> Array:
        return cv2.boxFilter(
            values.astype(np.float32), -1, (size, size), normalize=False, borderType=cv2.BORDER_CONSTANT
        )

    n = np.maximum(total(known), 1)
    return np.stack([total(np.where(known, s, 0)) / n for s in slopes])


def planes_at(rays: ReferenceRays, xy_px: Array, t: Array, slopes: Array) -> tuple[Array, Array]:
    """Normals (n, 3) towards the viewer of planes of t at pixels, and the object's area (n,) that a pixel shows.

    slopes  (2, n) of t along the columns and rows [1 / px]
    """
    field = _Directions.of(rays)
    normal, area = np.empty((len(t), 3)), np.empty(len(t))
    for begin in range(0, len(t), CHUNK):
        part = slice(begin, begin + CHUNK)
        normal[part], area[part], _ = _planes(field, xy_px[part], t[part], slopes[:, part])
    return normal, area


def incidences(rays: ReferenceRays, grid: PixelGrid, t: Array, slopes: Array) -> Array:
    """(rows, columns) cosine of the angle between rays and the normals of planes of t."""
    found = np.full(t.shape, np.nan, np.float32)
    field = _Directions.of(rays)
    rows = max(1, CHUNK // max(grid.columns, 1))
    for begin in range(0, grid.rows, rows):
        part = slice(begin, begin + rows)
        known = np.isfinite(t[part])
        xy, tk = grid.rows_of(begin, rows).xy_px[known], t[part][known].astype(float)
        normal, _, d = _planes(field, xy, tk, slopes[:, part][:, known].astype(float))
        found[part][known] = -(normal * d).sum(axis=1) / np.linalg.norm(d, axis=1)
    return found


def _planes(field: _Directions, xy_px: Array, t: Array, slopes: Array) -> tuple[Array, Array, Array]:
    """Normals, areas, and directions of rays away from the sensor."""
    d, origin_by, d_by = field.at(xy_px)
    s, by_t = field.rays.along(t)
    across, down = (origin_by[:, k] + d_by[:, k] * s[:, None] + d * (slopes[k] * by_t)[:, None] for k in (0, 1))
    d = d * -np.sign(by_t)[:, None]
    normal = np.cross(across, down)
    area = np.linalg.norm(normal, axis=1)
    normal /= np.maximum(area, 1e-300)[:, None]
    normal[(normal * d).sum(axis=1) > 0] *= -1
    return normal, area, d
