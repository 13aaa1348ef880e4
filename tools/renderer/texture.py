"""What the ground looks like: albedo that is fixed to the object."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from .random_fields import coarse_nodes, power_law
from .tiles import inside

Array = NDArray[np.float64]
CONTRAST = 0.4
"""Standard deviation of the logarithm of albedo on usual ground."""
WEAK_CONTRAST = 0.087
"""The same on weak ground; 6 % of it are left within a matching window of 13 pixels."""
BRICK_CONTRAST = 0.1
"""The same of what makes the bricks of a pattern differ, unless a set asks for less."""
MEAN = 0.25
FULL = 65535


@dataclass(frozen=True, slots=True, kw_only=True)
class Texture:
    """Albedo on a plane; object points are brought to it along a direction that no wall is parallel to.

    albedo     (m, n)     of green light, 1 = FULL; mirrored beyond its rim
    tint       (2, p, q)  albedo of red and of blue light over that of green light
    origin     (2,)       plane coordinates of the first node [m]
    cell                  distance between nodes of `albedo` [m]
    tint_cell             distance between nodes of `tint` [m]
    plane      (2, 3)     plane coordinates of object points: plane @ (X, Y, Z)
    """

    albedo: NDArray[np.uint16]
    tint: NDArray[np.float32]
    origin: Array
    cell: float
    tint_cell: float
    plane: Array

    def at(self, x: Array, y: Array, z: Array) -> NDArray[np.float32]:
        """Albedo of red, green and blue light, (3, ...), at object points [m]."""
        u, v = (
            row[0] * x + row[1] * y + row[2] * z - start for row, start in zip(self.plane, self.origin, strict=True)
        )
        grid = np.stack([v, u])
        green = self._between(self.albedo, grid / self.cell)
        green *= 1 / FULL
        grid /= self.tint_cell
        return np.stack([green * self._between(self.tint[0], grid), green, green * self._between(self.tint[1], grid)])

    def _between(self, field: NDArray, grid: Array) -> NDArray[np.float32]:
        light = ndimage.map_coordinates(field, grid, np.float32, order=1, mode="mirror", prefilter=False)
        return np.asarray(light, dtype=np.float32)


@dataclass(frozen=True, slots=True)
class Patch:
    """A rectangle of weak texture or of bricks: centre and half sides in plane coordinates [m].

    contrast  standard deviation of the logarithm of albedo by which bricks differ
    """

    kind: str
    centre: tuple[float, float]
    half: tuple[float, float]
    contrast: float = BRICK_CONTRAST


def texture(
    half: tuple[float, float], gsd: float, patches: tuple[Patch, ...], plane: Array, rng: np.random.Generator
) -> Texture:
    """A random texture of a natural spectrum (amplitude over frequency), with its patches, nodes a quarter pixel apart.

    half  half sides [m] of the textured rectangle around the origin
    gsd   size of a pixel on the object [m]
    """
    cell = gsd / 4
    nx, ny = (int(2 * h / cell) + 1 for h in half)
    log = power_law((ny, nx), cell, 200 * gsd, 0.9 * gsd, 1.0, rng)
    log *= CONTRAST
    x, y = (-h + cell * np.arange(n, dtype=float) for h, n in zip(half, (nx, ny), strict=True))
    for patch in patches:
        _draw(log, patch, x[None, :], y[:, None], gsd)
    albedo = np.empty(log.shape, dtype=np.uint16)
    for i in range(0, ny, 512):
        albedo[i : i + 512] = np.clip(MEAN * np.exp(log[i : i + 512]), 0.01, 1) * FULL
    tint_cell = 2 * gsd
    factor = round(tint_cell / cell)
    shape = coarse_nodes((ny, nx), factor)
    tint = np.stack([np.exp(0.08 * power_law(shape, tint_cell, 300 * gsd, 4 * gsd, 1.2, rng)) for _ in range(2)])
    return Texture(
        albedo=albedo,
        tint=tint.astype(np.float32),
        origin=np.array([-half[0], -half[1]]),
        cell=cell,
        tint_cell=tint_cell,
        plane=plane,
    )


def _draw(log: NDArray[np.float32], patch: Patch, x: Array, y: Array, gsd: float) -> None:
    """Change the logarithm of albedo within a patch, over a soft rim of 20 pixels."""
    j = np.searchsorted(x[0], [patch.centre[0] - patch.half[0], patch.centre[0] + patch.half[0]])
    i = np.searchsorted(y[:, 0], [patch.centre[1] - patch.half[1], patch.centre[1] + patch.half[1]])
    part = log[i[0] : i[1], j[0] : j[1]]
    u, v = x[:, j[0] : j[1]] - patch.centre[0], y[i[0] : i[1]] - patch.centre[1]
    depth = inside(u, v, patch.half)
    if patch.kind == "weak":
        share = np.clip(depth / (20 * gsd), 0, 1)
        part *= 1 - share * (1 - WEAK_CONTRAST / CONTRAST)
        return
    share = np.clip(depth / gsd + 0.5, 0, 1)
    part *= 1 - share * (1 - patch.contrast / CONTRAST)
    part += share * _bricks(u, v, gsd)


def _bricks(u: Array, v: Array, gsd: float) -> Array:
    """Logarithm of albedo of running bond: bricks of 60 x 30 pixels with light joints of 5 pixels."""
    long, high, joint = 60 * gsd, 30 * gsd, 5 * gsd
    course = np.floor(v / high)
    along = np.mod(u + 0.5 * long * np.mod(course, 2), long)
    up = np.mod(v, high) * np.ones_like(u)
    depth = np.minimum(np.minimum(along, long - along), np.minimum(up, high - up)) - joint / 2
    return 0.7 * np.clip(0.5 - depth / (0.5 * gsd), 0, 1) - 0.15
