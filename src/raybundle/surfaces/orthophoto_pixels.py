"""The pixels that a photograph gives to an orthophoto, with the standard deviations of their places in plan."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block
from raybundle.io.block.arrays import block_of_arrays
from raybundle.io.photos.photo import Photo
from raybundle.io.pictures.resampling import sampled
from raybundle.numerics.arrays import Array, Index
from raybundle.pipeline.place import Product
from raybundle.pipeline.store import Folder
from raybundle.surfaces.depths.orientation import CommonRoot, ShiftCovariance
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.heights.interpolation import beside_steps, height_at, slopes_of
from raybundle.surfaces.heights.orthophoto_error import displacement, gram
from raybundle.surfaces.tasks import colours_of
from raybundle.surfaces.tiles import (
    BLOCK_CELLS,
    TILE_CELLS,
    Window,
    heights_in,
    moved_of,
    tile_of_number,
    tiles_across,
)
from raybundle.workflows.rectify import Grid

TILE_PX = 512
"""Side of a tile of an orthophoto: a multiple of what its file has."""
FEATHER = 2
"""Cells on each side of a seam over which two photographs are blended."""
ROW = 1024
"""Places that are looked up side by side."""
ROOM = 3
"""Cells around a window that are asked, too: blending, slopes and heights between cells."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PartTask:
    """What a photograph gives."""

    image: int
    block: str
    """key of a part of the block with its image alone"""
    photo: Photo
    map: str
    look: str
    shifts: str
    together: str
    gains: tuple[float, ...]
    mine: tuple[int, ...]
    """tiles of the heights in which cells take it"""
    choice: tuple[tuple[int, str], ...]
    """keys of what these and those around take, by tile"""
    heights: tuple[tuple[int, str], ...]
    above: tuple[tuple[int, str], ...]
    """keys of the points of references above the grid"""
    grid: HeightGrid
    pixels: Grid


def tiles_touched(grid: HeightGrid, tiles: Sequence[int]) -> list[int]:
    """Tiles of the heights that are read for pixels of these."""
    return sorted({t for tile in tiles for t in tile_of_number(grid, tile).grown(ROOM + 1 + FEATHER).tiles(grid)})


def pixel_tiles(pixels: Grid) -> int:
    """Tiles of an orthophoto in a row."""
    return -(-pixels.width // TILE_PX)


def tile_of_pixels(pixels: Grid, tile: int) -> Window:
    """The pixels of a tile of an orthophoto."""
    row, column = divmod(tile, pixel_tiles(pixels))
    x, y = column * TILE_PX, row * TILE_PX
    return Window(x=x, y=y, width=min(TILE_PX, pixels.width - x), height=min(TILE_PX, pixels.height - y))


def part_of_orthophoto(store: Folder, task: PartTask) -> Product:
    """The task: by tile of the orthophoto the numbers of pixels, their colours, weights and standard deviations.

    A pixel has a standard deviation (right, up) where its cell takes this photograph; elsewhere it is blended in.
    """
    work = _Work.of(store, task)
    tiles, parts = list[int](), list[_Pixels]()
    for tile in _tiles_of(task):
        found = work.pixels(tile_of_pixels(task.pixels, tile))
        if len(found.at):
            tiles.append(tile)
            parts.append(found)
    return {
        "tiles": np.array(tiles, int), "begin": np.cumsum([0, *(len(p.at) for p in parts)]),
        "at": np.concatenate([p.at for p in parts]) if parts else np.zeros(0, np.uint32),
        "colour": np.concatenate([p.colour for p in parts]) if parts else np.zeros((0, 3), np.uint8),
        "weight": np.concatenate([p.weight for p in parts]) if parts else np.zeros(0, np.float16),
        "sigma": np.concatenate([p.sigma for p in parts]) if parts else np.zeros((0, 2), np.float32),
    }  # fmt: skip


def _tiles_of(task: PartTask) -> list[int]:
    """Tiles of the orthophoto that lie on tiles of the heights, blended rims included."""
    ratio, found = task.grid.grid.pixel / task.pixels.pixel, set[int]()
    for tile in task.mine:
        w = tile_of_number(task.grid, tile).grown(FEATHER + 1).within(task.grid)
        rows = range(
            int(w.y * ratio) // TILE_PX, int(min((w.y + w.height) * ratio, task.pixels.height - 1)) // TILE_PX + 1
        )
        columns = range(
            int(w.x * ratio) // TILE_PX, int(min((w.x + w.width) * ratio, task.pixels.width - 1)) // TILE_PX + 1
        )
        found |= {r * pixel_tiles(task.pixels) + c for r in rows for c in columns}
    return sorted(found)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Pixels:
    at: Index
    colour: Array
    weight: Array
    sigma: Array


@dataclass(frozen=True, slots=True, kw_only=True)
class _Work:
    """What all tiles need."""

    store: Folder
    task: PartTask
    block: Block
    picture: Array
    """(h, w, 3) uint8, reduced where a pixel of the orthophoto is wider than two of it"""
    factor: Array
    """(2,) of this picture to the photograph"""
    viewer: Array
    shifts: ShiftCovariance
    choice: Mapping[int, str]
    heights: Mapping[int, str]
    grams: dict[int, Array]
    """of tiles, once they were needed"""

    @classmethod
    def of(cls, store: Folder, task: PartTask) -> _Work:
        block = block_of_arrays(store.wanted(task.block))
        px = float(store.wanted(task.look, ("px",))["px"]) * task.pixels.pixel / task.grid.grid.pixel
        picture, factor = colours_of(task.photo, block, 0, px)
        together = CommonRoot.of_arrays(store.wanted(task.together))
        return cls(
            store=store, task=task, block=block, picture=picture, factor=factor,
            viewer=ReferenceRays.of(block, 0).viewer(task.grid.plane.coordinates),
            shifts=ShiftCovariance.of_arrays(store.wanted(task.shifts)).among(together), choice=dict(task.choice),
            heights=dict(task.heights), grams={},
        )  # fmt: skip

    def pixels(self, tile: Window) -> _Pixels:
        """Those of a tile of the orthophoto."""
        t = self.task
        ratio = t.pixels.pixel / t.grid.grid.pixel
        first_x, first_y = int(tile.x * ratio), int(tile.y * ratio)
        last_x, last_y = int((tile.x + tile.width) * ratio), int((tile.y + tile.height) * ratio)
        inner = Window(x=first_x, y=first_y, width=last_x - first_x + 1, height=last_y - first_y + 1)
        window = inner.grown(ROOM)
        image, seen = self._choice_in(window)
        share = cv2.blur((image == t.image).astype(np.float32), (2 * FEATHER + 1, 2 * FEATHER + 1))
        share[~seen | (image < 0)] = 0
        height, local, _ = heights_in(self.store, self.heights, t.grid, window)
        y, x = np.mgrid[tile.y : tile.y + tile.height, tile.x : tile.x + tile.width]
        column, row = (x + 0.5) * ratio - window.x, (y + 0.5) * ratio - window.y
        there = (
            share[np.clip(row.astype(int), 0, share.shape[0] - 1), np.clip(column.astype(int), 0, share.shape[1] - 1)]
            > 0
        )
        column, row, at = column[there], row[there], np.flatnonzero(there)
        h, i, j = height_at(height, column, row, t.grid.grid.pixel)
        xyz = t.grid.points_at(window.x + column, window.y + row, h)
        xy = predicted_px(self.block, 0, xyz)
        colours, inside = (
            x.reshape(-1, *x.shape[2:])[: len(xy)] for x in sampled(self.picture, _in_rows(xy * self.factor))
        )
        inside = inside & np.isfinite(h)
        colours = np.clip(np.rint(colours * np.array(t.gains)), 0, 255).astype(np.uint8)
        sigma = np.full((len(at), 2), np.nan, np.float32)
        main = np.flatnonzero(inside & (image[j, i] == t.image))
        sigma[main] = self._sigma(window, height, local, (column[main], row[main], h[main]), (i[main], j[main]))
        return _Pixels(
            at=at[inside].astype(np.uint32), colour=colours[inside],
            weight=_smooth(share, column, row)[inside].astype(np.float16), sigma=sigma[inside],
        )  # fmt: skip

    def _choice_in(self, window: Window) -> tuple[Array, Array]:
        """The image that each cell takes, and whether this photograph sees it."""
        grid = self.task.grid
        image = np.full((window.height, window.width), -1, np.int32)
        cost = np.full((window.height, window.width), np.inf, np.float32)
        look = self.store.lent(self.task.look, ("tiles", "cost"))
        row_of = {t: k for k, t in enumerate(look["tiles"].tolist())}
        for tile in window.tiles(grid):
            own = tile_of_number(grid, tile)
            if tile in self.choice:
                window.take(image, own, self.store.lent(self.choice[tile], ("image",))["image"])
            if tile in row_of:
                window.take(cost, own, look["cost"][row_of[tile]][: own.height, : own.width])
        return image, np.isfinite(cost)

    def _sigma(
        self, window: Window, height: Array, local: Array, place: tuple[Array, Array, Array], cell: tuple[Index, Index]
    ) -> Array:
        """(n, 2) standard deviations to the right and upwards of pixels at columns, rows and heights."""
        (column, row, h), (i, j) = place, cell
        grid = self.task.grid
        away = self.viewer - np.column_stack([grid.places(window.x + column, window.y + row), h])
        tangent = away[:, :2] / away[:, 2:]
        right, up = slopes_of(height, grid.grid.pixel)
        slope = np.stack([right[j, i], up[j, i]], axis=1)
        G = np.zeros((len(h), 4, 4))
        x, y = window.x + i, window.y + j
        tile = (y // TILE_CELLS) * tiles_across(grid) + x // TILE_CELLS
        for number in np.unique(tile).tolist():
            own, mine = tile_of_number(grid, number), tile == number
            if number in self.heights:
                grams = self._grams(number)
                G[mine] = grams[(y[mine] - own.y) // BLOCK_CELLS, (x[mine] - own.x) // BLOCK_CELLS]
        beside = beside_steps(height, grid.grid.pixel)[j, i]
        return displacement(tangent, slope, np.hypot(local[j, i], beside), G).astype(np.float32)

    def _grams(self, tile: int) -> Array:
        """(rows, columns, 4, 4) of the parts of a tile: how ray and heights move together."""
        if tile in self.grams:
            return self.grams[tile]
        t = self.task
        own = tile_of_number(t.grid, tile)
        height, _, _ = heights_in(self.store, self.heights, t.grid, own)
        moved = moved_of(self.store, dict(t.above), t.grid, tile, self.heights[tile])
        rays = ReferenceRays.of(self.block, 0)
        surface = moved.of_surface(BLOCK_CELLS * t.grid.grid.pixel)
        rows, columns = surface.shape[:2]
        grams = np.zeros((rows, columns, 4, 4))
        for r in range(rows):
            for c in range(columns):
                part = height[r * BLOCK_CELLS : (r + 1) * BLOCK_CELLS, c * BLOCK_CELLS : (c + 1) * BLOCK_CELLS]
                known = np.argwhere(np.isfinite(part))
                if len(known):
                    middle = known[np.abs(known - known.mean(axis=0)).sum(axis=1).argmin()]
                    x, y = own.x + c * BLOCK_CELLS + middle[1] + 0.5, own.y + r * BLOCK_CELLS + middle[0] + 0.5
                    xyz = t.grid.points_at(np.array([x]), np.array([y]), part[tuple(middle)][None])
                    grams[r, c] = self._gram(rays, xyz, surface[r, c])
        self.grams[tile] = grams
        return grams

    def _gram(self, rays: ReferenceRays, xyz: Array, moved: Array) -> Array:
        xy = predicted_px(self.block, 0, xyz)
        if not np.isfinite(xy).all():
            return np.zeros((4, 4))
        sources = (self.shifts.partials.shape[3] - 3) // 2
        t = rays.parameter(xy, xyz)
        ((_, point),) = self.shifts.moved_points(xy, t, np.zeros((1, sources, 2)), np.zeros((1, 3)))
        return gram(self.task.grid.plane.jacobian(xyz[0]) @ point[0], moved)


def _in_rows(places: Array) -> Array:
    """Places (n, 2) as (rows, ROW, 2), as the resampler takes them: none longer than it can; the last is filled up."""
    rows = max(1, -(-len(places) // ROW))
    found = np.zeros((rows * ROW, 2))
    found[: len(places)] = places
    return found.reshape(rows, ROW, 2)


def _smooth(share: Array, column: Array, row: Array) -> Array:
    """Weights at places between cells; small where a cell itself has none."""
    at = _in_rows(np.column_stack([column, row]) - 0.5).astype(np.float32)
    found = cv2.remap(share, at[..., 0], at[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return np.maximum(found.ravel()[: len(column)], 1e-3)
