"""A printed chessboard that is not quite flat, and photographs of it on a desk."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from threadpoolctl import threadpool_limits

from raybundle.numerics.arrays import Array
from raybundle.planning.rendered.rendering import View, between, exposed, spread

FINE = 4
"""Samples along a pixel where the board is"""
BAND_PX = 40
"""Rows that are drawn together: samples of a whole photograph would be a gigabyte"""
ROUNDS = 4
"""Steps of a ray onto the bent surface: each takes the error down by the slope of the board, some thousandths"""
PAPER, INK, DESK = 222.0, 26.0, 92.0


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedBoard:
    """Squares of a chessboard on card; the middle of the inner corners is the origin, X to the right, Y up."""

    columns: int
    """of squares"""
    rows: int
    square: float
    bow: float
    """Height of the middle over the ends of the longer side"""
    margin: float
    """of white paper round the squares"""

    @property
    def half(self) -> tuple[float, float]:
        """Half of width and height of the squares together."""
        return self.columns * self.square / 2, self.rows * self.square / 2

    def height(self, x: Array) -> Array:
        """Of the surface, bent as a parabola along X."""
        return self.bow * (1 - (x / self.half[0]) ** 2)

    @property
    def corners(self) -> Array:
        """Inner corners (n, 3), row by row from the lower left."""
        x = (np.arange(1, self.columns) - self.columns / 2) * self.square
        y = (np.arange(1, self.rows) - self.rows / 2) * self.square
        plan = np.stack([a.ravel() for a in np.meshgrid(x, y)], axis=1)
        return np.column_stack([plan, self.height(plan[:, 0])])

    def outline(self, margin: float) -> Array:
        """Corners and middles of the sides (8, 3), so far outside the squares."""
        w, h = self.half[0] + margin, self.half[1] + margin
        plan = np.array([(x, y) for x in (-w, 0, w) for y in (-h, 0, h) if (x, y) != (0, 0)], float)
        return np.column_stack([plan, self.height(plan[:, 0])])

    def grey(self, x: Array, y: Array) -> Array:
        """Linear grey values (h, w) of a raster of places on the board; the desk beside it.

        Edges that do not fall between samples are covered in part.
        """
        wide = [np.maximum(np.linalg.norm(np.gradient(a), axis=0), 1e-12) for a in (x, y)]
        squares, paper, dark = np.ones(x.shape), np.ones(x.shape), np.ones(x.shape)
        for a, half, w in zip((x, y), self.half, wide, strict=True):
            squares *= np.clip((half - np.abs(a)) / w + 0.5, 0, 1)
            paper *= np.clip((half + self.margin - np.abs(a)) / w + 0.5, 0, 1)
            cell = (a + half) / self.square
            line = np.abs(cell - np.round(cell)) * self.square
            dark *= (1 - 2 * (np.floor(cell) % 2)) * np.clip(2 * line / w, 0, 1)
        ink = squares * (1 + dark) / 2
        return DESK + paper * (PAPER - DESK + ink * (INK - PAPER))

    def photograph(self, view: View, rng: np.random.Generator) -> Array:
        """Grey values (h, w, 3) uint8."""
        columns, rows, nodes = view.node_directions()
        size = np.array([view.camera.width_px, view.camera.height_px])
        seen = np.full((size[1], size[0]), DESK)
        xy = view.pixels_of(self.outline(self.margin))
        low = np.clip(np.floor(xy.min(axis=0)).astype(int) - 3, 0, size)
        high = np.clip(np.ceil(xy.max(axis=0)).astype(int) + 4, 0, size)
        across, down = (
            between(n, low[a] + (np.arange((high[a] - low[a]) * FINE) + 0.5) / FINE)
            for a, n in ((0, columns), (1, rows))
        )
        with threadpool_limits(1):  # many small products
            for top in range(low[1], high[1], BAND_PX):
                end = min(top + BAND_PX, high[1])
                d = spread(nodes, down[(top - low[1]) * FINE : (end - low[1]) * FINE], across)
                grey = self.grey(*self._met(view.centre, d))
                seen[top:end, low[0] : high[0]] = grey.reshape(end - top, FINE, -1, FINE).mean(axis=(1, 3))
        return exposed(np.repeat(seen[..., None], 3, axis=2).astype(np.float32), rng, blur_px=0.8, noise=2.5)

    def _met(self, centre: Array, d: Array) -> tuple[Array, Array]:
        """X, Y (h, w) where rays of the directions d (h, w, 3) from a centre meet the bent surface."""
        reach = -centre[2] / d[..., 2]
        for _ in range(ROUNDS):
            reach = (self.height(centre[0] + reach * d[..., 0]) - centre[2]) / d[..., 2]
        return centre[0] + reach * d[..., 0], centre[1] + reach * d[..., 1]
