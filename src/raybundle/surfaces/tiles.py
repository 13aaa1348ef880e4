"""Parts of what is kept tile by tile on the grid of heights, put together for a window of cells."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.pipeline.store import Folder
from raybundle.surfaces.grid import HeightGrid
from raybundle.surfaces.heights.interpolation import REACH, closed
from raybundle.surfaces.heights.node_sums import Moments

TILE_CELLS = 256
"""Side of a tile: what is done, read and written at once."""
BLOCK_CELLS = 32
"""Side of a part of a tile over which what orientation does to a map is linear."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Window:
    """Cells of a grid, some of which may lie beyond it."""

    x: int
    y: int
    width: int
    height: int

    def grown(self, by: int) -> Window:
        """With so many cells more on each side."""
        return Window(x=self.x - by, y=self.y - by, width=self.width + 2 * by, height=self.height + 2 * by)

    def within(self, grid: HeightGrid) -> Window:
        """What of it lies in the grid."""
        x, y = max(self.x, 0), max(self.y, 0)
        right, below = min(self.x + self.width, grid.grid.width), min(self.y + self.height, grid.grid.height)
        return Window(x=x, y=y, width=max(right - x, 0), height=max(below - y, 0))

    def tiles(self, grid: HeightGrid) -> list[int]:
        """Numbers of the tiles that have cells in it."""
        w = self.within(grid)
        if not (w.width and w.height):
            return []
        across = tiles_across(grid)
        return [
            r * across + c
            for r in range(w.y // TILE_CELLS, (w.y + w.height - 1) // TILE_CELLS + 1)
            for c in range(w.x // TILE_CELLS, (w.x + w.width - 1) // TILE_CELLS + 1)
        ]

    def take(self, into: Array, tile: Window, values: Array) -> None:
        """Put values (h, w, ...) of a tile where they lie in it."""
        left, top = max(self.x, tile.x), max(self.y, tile.y)
        right, below = min(self.x + self.width, tile.x + tile.width), min(self.y + self.height, tile.y + tile.height)
        if right > left and below > top:
            into[top - self.y : below - self.y, left - self.x : right - self.x] = values[
                top - tile.y : below - tile.y, left - tile.x : right - tile.x
            ]


def tiles_across(grid: HeightGrid) -> int:
    """Tiles of a row."""
    return -(-grid.grid.width // TILE_CELLS)


def tile_of_number(grid: HeightGrid, tile: int) -> Window:
    """The cells of a tile."""
    row, column = divmod(tile, tiles_across(grid))
    x, y = column * TILE_CELLS, row * TILE_CELLS
    width, height = min(TILE_CELLS, grid.grid.width - x), min(TILE_CELLS, grid.grid.height - y)
    return Window(x=x, y=y, width=width, height=height)


def around(tiles: Sequence[int], grid: HeightGrid) -> Window:
    """The window that holds some tiles."""
    each = [tile_of_number(grid, t) for t in tiles]
    x, y = min(w.x for w in each), min(w.y for w in each)
    right, below = max(w.x + w.width for w in each), max(w.y + w.height for w in each)
    return Window(x=x, y=y, width=right - x, height=below - y)


def heights_in(store: Folder, tiles: Mapping[int, str], grid: HeightGrid, window: Window) -> tuple[Array, Array, Array]:
    """Heights of a window, and their standard deviations, local and by orientation, with small gaps closed.

    tiles  keys of the heights, by number; those that are not there have none
    """
    wide = window.grown(REACH)
    found = tuple(np.full((wide.height, wide.width), np.nan, np.float32) for _ in range(3))
    for tile in wide.tiles(grid):
        if tile in tiles:
            a = store.lent(tiles[tile], ("height", "local", "orientation"))
            for into, name in zip(found, ("height", "local", "orientation"), strict=True):
                wide.take(into, tile_of_number(grid, tile), a[name])
    inner = slice(REACH, REACH + window.height), slice(REACH, REACH + window.width)
    height, local, orientation = (x[inner] for x in closed(*found))
    return height, local, orientation


def moved_of(store: Folder, above: Mapping[int, str], grid: HeightGrid, tile: int, key: str) -> Moments:
    """How parts (rows, columns) of a tile move with each independent error: each reference's points, by its share.

    above  keys of the points of the references above the grid
    key    of the heights of the tile
    """
    a = store.lent(key, ("images", "share"))
    w = tile_of_number(grid, tile)
    rows, columns = -(-w.height // BLOCK_CELLS), -(-w.width // BLOCK_CELLS)
    across = -(-grid.grid.width // BLOCK_CELLS)
    j, i = np.divmod(np.arange(rows * columns), columns)
    number = (w.y // BLOCK_CELLS + j) * across + w.x // BLOCK_CELLS + i
    found = None
    for image, share in zip(a["images"].tolist(), a["share"], strict=True):
        own = store.lent(above[image], ("blocks", "products", "sums", "base"))
        order = np.argsort(own["blocks"])
        at = np.searchsorted(own["blocks"], number, sorter=order).clip(max=len(order) - 1)
        row = order[at]
        there = own["blocks"][row] == number
        part = Moments(
            products=own["products"][row], sums=own["sums"][row], base=np.where(there, own["base"][row], np.nan)
        ).times(np.where(there, share, 0.0))
        found = part if found is None else found.plus(part)
    assert found is not None
    return Moments(
        products=found.products.reshape(rows, columns, 4, 4), base=np.nan_to_num(found.base).reshape(rows, columns),
        sums=found.sums.reshape(rows, columns, *found.sums.shape[1:]),
    )  # fmt: skip
