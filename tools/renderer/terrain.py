"""A terrain of several classes of place, made from a seed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .classes import NAMES, RIDGE, SMOOTH, STEP
from .height_field import HeightField
from .random_fields import coarse_nodes, enlarged, power_law
from .texture import BRICK_CONTRAST, Patch, Texture, texture
from .tiles import TILES

Array = NDArray[np.float64]
PLANE = np.array([[1.0, 0.0, 0.4], [0.0, 1.0, 0.3]])
"""Texture of a wall is that of the ground beside it, seen along this slanted direction."""
SUN = np.array([0.45, -0.35, 0.82])
AMBIENT = 0.45


@dataclass(frozen=True, slots=True, kw_only=True)
class Terrain:
    """A height field with texture and classes.

    core     (2,)    half sides [m] of the rectangle that is judged
    classes  (p, q)  codes of `classes`, at every `class_step`-th node of the heights
    shade    (m, n)  light of each cell, 1 = level ground in the sun
    moved            heights by which the ground has moved since the first date, with its texture; none at that date
    """

    surface: HeightField
    texture: Texture
    classes: NDArray[np.int8]
    class_step: int
    core: Array
    gsd: float
    shade: NDArray[np.float32]
    moved: HeightField | None = None

    def seen(self, origins: Array, directions: Array) -> NDArray[np.float32]:
        """Light along rays (m, n, 3); see `exposure.Seen`."""
        bx, by = (directions[..., k] / directions[..., 2] for k in (0, 1))
        ax, ay = origins[..., 0] - origins[..., 2] * bx, origins[..., 1] - origins[..., 2] * by
        z = self.surface.cast(ax, ay, bx, by)
        x, y = ax + bx * z, ay + by * z
        light = self.texture.at(x, y, z if self.moved is None else z - self.moved.at(x, y))
        surface = self.surface
        i, j = (
            np.clip(((part - start) / surface.cell).astype(np.int32), 0, n - 1)
            for part, start, n in (
                (y, surface.origin[1], self.shade.shape[0]),
                (x, surface.origin[0], self.shade.shape[1]),
            )
        )
        light *= self.shade[i, j]
        return light

    @property
    def axes(self) -> Array:
        """Object axes (3, 3) of right, up and out as a camera sees them that looks down, as columns."""
        return np.eye(3)

    def hidden(self, points: Array, centre: Array) -> NDArray[np.bool_]:
        """Whether the ground stands between points (n, 3) on it and a projection centre."""
        share = np.linspace(0.001, 0.2, 800)[:, None]
        x, y, z = (points[:, k] + share * (centre[k] - points[:, k]) for k in range(3))
        return (self.surface.at(x, y) > z).any(axis=0)

    def control(self, places: Array, rng: np.random.Generator) -> Array:
        """Points (n, 3) of smooth ground near places (n, 2), in shares of the core."""
        found: list[Array] = []
        size = self.surface.cell * self.class_step
        margin = int(20 * self.gsd / size)
        for place in places:
            for spread in np.linspace(0, 0.4, 400):
                x, y = self.core * np.clip(place + spread * rng.uniform(-1, 1, 2), -1, 1)
                j, i = np.rint((np.array([x, y]) - self.surface.origin) / size).astype(int)
                if (self.classes[i - margin : i + margin + 1, j - margin : j + margin + 1] == SMOOTH).all():
                    found.append(np.array([x, y, self.surface.at(np.array([x]), np.array([y]))[0]]))
                    break
        return np.array(found).reshape(-1, 3)

    def write(self, path: Path) -> None:
        """Write heights, classes and the judged rectangle (`truth.read_surface` reads them)."""
        np.savez(
            path,
            heights=self.surface.heights,
            origin=self.surface.origin,
            cell=self.surface.cell,
            classes=self.classes,
            class_step=self.class_step,
            class_names=np.array(NAMES),
            core=self.core,
            gsd=self.gsd,
        )


def terrain(
    seed: int,
    width: float,
    gsd: float,
    kinds: tuple[str, ...] = tuple(TILES),
    date: int = 1,
    bricks: float = BRICK_CONTRAST,
) -> Terrain:
    """Smooth relief with a tile of each kind, in an order that is drawn.

    width  width of a photograph on the object [m]; the core is a rectangle of 1.0 by 0.8 of it
    date   1 for the first; at later ones parts of the ground have moved (`movement`)
    bricks  by how much bricks differ (`texture.Patch`)
    """
    rng = np.random.default_rng(seed)
    core = np.array([0.5, 0.4]) * width
    cell = gsd / 2
    half = core + 0.13 * width
    nx, ny = (int(2 * h / cell) + 1 for h in half)
    factor = round(15 * gsd / cell)
    coarse = power_law(coarse_nodes((ny, nx), factor), factor * cell, 500 * gsd, 120 * gsd, 1.5, rng)
    heights = enlarged(6 * gsd * coarse, factor, (ny, nx))
    codes = np.full(heights.shape, SMOOTH, dtype=np.int8)
    x, y = -half[0] + cell * np.arange(nx), -half[1] + cell * np.arange(ny)
    patches: list[Patch] = []
    slots = [(u, v) for v in (-0.5, 0.5) for u in (-2 / 3, 0.0, 2 / 3)]
    tile_half = (core[0] / 3 * 0.86, core[1] / 2 * 0.88)
    for kind, slot in zip(rng.permutation(np.array(kinds)), slots, strict=False):
        centre = (slot[0] * core[0], slot[1] * core[1])
        # A frame of two cells around the tile, so that walls on its rim are whole.
        j, i = (
            np.searchsorted(part, [c - h - 4 * cell, c + h + 4 * cell])
            for part, c, h in zip((x, y), centre, tile_half, strict=True)
        )
        window = (slice(*i), slice(*j))
        rise, code = TILES[str(kind)](
            x[None, window[1]] - centre[0], y[window[0], None] - centre[1], tile_half, gsd, rng
        )
        heights[window] += rise
        codes[window] = np.where(code >= 0, code, codes[window])
        if kind in {"weak", "pattern"}:
            patches.append(Patch(str(kind), centre, tile_half, bricks))
    moved = movement(x, y, core, gsd, date, np.random.default_rng([seed, 1])) if date > 1 else None
    if moved is not None:
        heights += moved
    surface = HeightField(heights, -half, cell)
    return Terrain(
        surface=surface,
        texture=texture((core[0] + 0.35 * width, core[1] + 0.35 * width), gsd, tuple(patches), PLANE, rng),
        classes=_coarser(codes, 2),
        class_step=2,
        core=core,
        gsd=gsd,
        shade=_shade(surface),
        moved=None if moved is None else HeightField(moved, -half, cell),
    )


def movement(x: Array, y: Array, core: Array, gsd: float, date: int, rng: np.random.Generator) -> NDArray[np.float32]:
    """Heights (m, n) [m] by which ground has moved at a date: a bowl that sinks, and a slab that rises.

    x, y  coordinates (n,) and (m,) [m]
    Both stand at places that are drawn, the slab with a sharp rim; they grow by 2 and by 3 pixels from date to date.
    """
    middles = rng.uniform(-0.6, 0.6, (2, 2)) * core
    while np.linalg.norm((middles[0] - middles[1]) / core) < 0.7:
        middles = rng.uniform(-0.6, 0.6, (2, 2)) * core
    r2 = ((x[None, :] - middles[0, 0]) / (0.18 * core[0])) ** 2 + ((y[:, None] - middles[0, 1]) / (0.18 * core[0])) ** 2
    bowl = -2 * gsd * (date - 1) * np.exp(-0.5 * r2)
    cell = x[1] - x[0]
    half = core * rng.uniform(0.12, 0.2, 2)
    depth = np.minimum(half[0] - np.abs(x[None, :] - middles[1, 0]), half[1] - np.abs(y[:, None] - middles[1, 1]))
    slab = 3 * gsd * (date - 1) * np.clip(depth / cell + 0.5, 0, 1)
    return (bowl + slab).astype(np.float32)


def _coarser(codes: NDArray[np.int8], step: int) -> NDArray[np.int8]:
    """Every `step`-th node; creases, which are a cell wide, are kept (ridge and step win over their neighbours)."""
    m, n = (part // step * step for part in codes.shape)
    squares = codes[:m, :n].reshape(m // step, step, n // step, step)
    found = np.ascontiguousarray(squares[:, 0, :, 0])
    for code in (RIDGE, STEP):
        found[(squares == code).any(axis=(1, 3))] = code
    return found


def _shade(surface: HeightField) -> NDArray[np.float32]:
    """Lambert's law for the plane of each cell; no cast shadows."""
    h = surface.heights
    dx = 0.5 * (np.diff(h[1:], axis=1) + np.diff(h[:-1], axis=1)) / surface.cell
    dy = 0.5 * (np.diff(h[:, 1:], axis=0) + np.diff(h[:, :-1], axis=0)) / surface.cell
    sun = SUN / np.linalg.norm(SUN)
    direct = (sun[2] - sun[0] * dx - sun[1] * dy) / np.sqrt(1 + dx * dx + dy * dy)
    return (AMBIENT + (1 - AMBIENT) * np.maximum(direct, 0) / sun[2]).astype(np.float32)
