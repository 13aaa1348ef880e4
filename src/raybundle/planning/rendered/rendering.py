"""Photographs of made-up surfaces: each pixel looks along the ray that the camera's own sensor model gives it.

Nothing is resampled through a distortion: a made photograph is as true as the rays, which are Newton's to 1e-14 at
nodes of a grid and splines between them (below 1e-5 px for lenses of the Brown model).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter, map_coordinates, zoom

from raybundle.block import Camera
from raybundle.numerics.arrays import Array, Mask

NODES_PX = 20
"""Between the nodes of the grid of rays"""


@dataclass(frozen=True, slots=True, kw_only=True)
class View:
    """A photograph that is to be made."""

    name: str
    camera: Camera
    """with its true values"""
    centre: Array
    """(3,) projection centre"""
    rotation: Array
    """(3, 3) object axes to image axes"""

    def node_directions(self) -> tuple[Array, Array, Array]:
        """Columns (m,) and rows (n,) of nodes [px], and directions (n, m, 3) there in object axes, 1 along the axis."""
        columns, rows = (_nodes(s) for s in (self.camera.width_px, self.camera.height_px))
        x, y = np.meshgrid(columns, rows)
        xy = np.stack([x.ravel(), y.ravel()], axis=1)
        values = np.array([self.camera.values[s] for s in self.camera.sensor.symbols])
        d = self.camera.sensor.ray(self.camera.image_from_pixel(xy).T, values)
        return columns, rows, ((d / -d[2]).T @ self.rotation).reshape(len(rows), len(columns), 3)

    def pixels_of(self, xyz: Array) -> Array:
        """Pixel frame (n, 2) of object points (n, 3), which must lie in front of the camera."""
        values = np.array([self.camera.values[s] for s in self.camera.sensor.symbols])
        local = (xyz - self.centre) @ self.rotation.T
        return self.camera.pixel_from_image(self.camera.sensor.project(local.T, values)[0].T)

    def inside(self, xy: Array, margin_px: float = 0.0) -> Mask:
        """Which image points (n, 2) lie within the format, so far from its edge."""
        size = np.array([self.camera.width_px, self.camera.height_px])
        return np.asarray(((xy > margin_px) & (xy < size - margin_px)).all(axis=1), bool)


def between(nodes: Array, at: Array) -> Array:
    """Weights (n, m) of values at nodes (m,) for places (n,): a cubic spline."""
    return CubicSpline(nodes, np.eye(len(nodes)))(at)


def spread(values: Array, rows: Array, columns: Array) -> Array:
    """Values (n, m, k) of a grid of nodes at all places of rows (h, n) and columns (w, m) of weights: (h, w, k)."""
    layers = (np.ascontiguousarray(values[..., k]) for k in range(values.shape[-1]))
    return np.stack([rows @ layer @ columns.T for layer in layers], axis=-1)


def noise_of_size(rng: np.random.Generator, shape: tuple[int, int], size: float) -> Array:
    """Smooth noise (h, w) float32 of features so many cells wide, with a standard deviation of about 0.7."""
    small = tuple(int(n / size) + 4 for n in shape)
    large: Array = np.asarray(zoom(rng.normal(0, 1, small).astype(np.float32), size, order=1 if size < 4 else 3))
    shift = int(size)
    return large[shift : shift + shape[0], shift : shift + shape[1]]


def looked_up(layer: Array, row: Array, column: Array) -> Array:
    """Values of a grid at places in cells, bilinear; beyond the edge those of the edge."""
    return np.asarray(map_coordinates(layer, [row, column], order=1, mode="nearest", output=np.float32))


def exposed(linear: Array, rng: np.random.Generator, *, blur_px: float = 0.55, noise: float = 1.2) -> Array:
    """Grey values (h, w, 3) uint8 of linear ones 0 to 255: optics, vignetting, noise."""
    h, w = linear.shape[:2]
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    r2 = ((x - w / 2) ** 2 + (y - h / 2) ** 2) / ((w / 2) ** 2 + (h / 2) ** 2)
    sharp = np.stack([gaussian_filter(linear[..., k], blur_px, mode="nearest") for k in range(3)], axis=-1)
    grain = noise * rng.standard_normal(sharp.shape, dtype=np.float32)
    return np.clip(np.round(sharp * (1 - 0.2 * r2[..., None]) + grain), 0, 255).astype(np.uint8)


def _nodes(size_px: int) -> Array:
    """Evenly spread from edge to edge of the format."""
    return np.linspace(0.0, size_px, int(np.ceil(size_px / NODES_PX)) + 1)
