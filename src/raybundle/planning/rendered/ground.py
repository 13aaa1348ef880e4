"""A piece of ground that nobody has seen: relief, colours, boards with crosses; and photographs of it from the air."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.planning.rendered.rendering import View, between, exposed, looked_up, noise_of_size, spread

ROUNDS = 8
"""Of finding where a ray meets the relief; slopes below 0.5 shrink the error by as much each"""
BOARD_M = 0.6
"""Side of a board: two black and two white squares, which meet in the point"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Ground:
    """Heights and colours on a grid of the local frame, its first cell in the south-west."""

    height: Array
    """(n, m) float32 [m]"""
    colour: Array
    """(n, m, 3) float32, 0 to 255, lit"""
    cell: float
    """[m]"""
    corner: tuple[float, float]
    """X, Y of the first cell's middle"""

    def points(self, xy: Array) -> Array:
        """Points (n, 3) of the surface at X, Y (n, 2)."""
        return np.column_stack([xy, self._heights(xy[:, 0], xy[:, 1])])

    @staticmethod
    def _met(centre: Array, d: Array, height: Array) -> Array:
        """X, Y (n, m, 2) at which rays reach heights (n, m)."""
        return centre[:2] + ((height - centre[2]) / d[..., 2])[..., None] * d[..., :2]

    def _heights(self, x: Array, y: Array) -> Array:
        return looked_up(self.height, (y - self.corner[1]) / self.cell, (x - self.corner[0]) / self.cell)

    def with_boards(self, xy: Array) -> Ground:
        """Boards laid out level with the ground; each point is where the four squares meet."""
        colour = self.colour.copy()
        n, m = self.height.shape
        half = int(np.ceil(0.5 * BOARD_M / self.cell)) + 1
        for x, y in xy:
            c, r = (x - self.corner[0]) / self.cell, (y - self.corner[1]) / self.cell
            rows = np.arange(max(int(r) - half, 0), min(int(r) + half + 2, n))
            columns = np.arange(max(int(c) - half, 0), min(int(c) + half + 2, m))
            v, u = np.meshgrid((rows - r) * self.cell, (columns - c) * self.cell, indexing="ij")
            # edges that do not fall between cells are shades of grey: the place stays true
            soft = (np.clip(t / self.cell, -0.5, 0.5) for t in (u, v))
            white = 0.5 - 2 * np.prod(list(soft), axis=0)
            on = np.clip((BOARD_M / 2 - np.maximum(np.abs(u), np.abs(v))) / self.cell + 0.5, 0, 1)[..., None]
            patch = colour[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
            patch += on * ((18 + 205 * white)[..., None] - patch)
        return Ground(height=self.height, colour=colour, cell=self.cell, corner=self.corner)

    def photograph(self, view: View, rng: np.random.Generator) -> Array:
        """Grey values (h, w, 3) uint8 of a photograph."""
        columns, rows, d = view.node_directions()
        place = self._met(view.centre, d, np.full(d.shape[:2], float(self.height.mean())))
        for _ in range(ROUNDS - 1):
            height = self._heights(place[..., 0].ravel(), place[..., 1].ravel()).reshape(d.shape[:2])
            place = self._met(view.centre, d, height)
        nodes = (place - self.corner) / self.cell
        across, down = (
            between(nodes_px, np.arange(size) + 0.5)
            for nodes_px, size in ((columns, view.camera.width_px), (rows, view.camera.height_px))
        )
        at = spread(nodes, down, across).astype(np.float32)
        seen = [looked_up(self.colour[..., k], at[..., 1], at[..., 0]) for k in range(3)]
        return exposed(np.stack(seen, axis=-1), rng)


def gravel_pit(size: tuple[float, float] = (120.0, 104.0), cell: float = 0.035, seed: int = 3) -> Ground:
    """Grass round a shallow pit with a heap and a track, about the origin of a local frame; 4 m of relief."""
    rng = np.random.default_rng(seed)
    shape = (int(size[1] / cell), int(size[0] / cell))
    corner = (-size[0] / 2, -size[1] / 2)
    x, y = np.meshgrid(
        corner[0] + cell * np.arange(shape[1], dtype=np.float32),
        corner[1] + cell * np.arange(shape[0], dtype=np.float32),
    )
    edge = np.hypot(x / 27, y / 21) + 0.07 * noise_of_size(rng, shape, 9 / cell)
    pit = 1 / (1 + np.exp((edge - 1) * 9))
    heap = np.exp(-(((x - 8) / 6.5) ** 2) - ((y + 4) / 5.0) ** 2)
    height = 0.5 * noise_of_size(rng, shape, 30 / cell) - 2.6 * pit + 2.4 * heap
    track = np.exp(-(((y - 0.25 * x - 2.5 * np.sin(x / 17)) / 2.0) ** 4))
    grain = np.zeros(shape, np.float32)
    for wide, weight in ((5.0, 0.3), (1.6, 0.35), (0.6, 0.6), (0.25, 0.8), (0.12, 0.8), (0.07, 0.6)):
        grain += weight * noise_of_size(rng, shape, wide / cell)
    grain /= grain.std()
    patches = 1 / (1 + np.exp(-3 * noise_of_size(rng, shape, 7 / cell)))
    bare = np.clip(pit + track, 0, 1)[..., None]
    grass = np.array([86, 112, 58], np.float32) + patches[..., None] * np.array([34, 12, 16], np.float32)
    gravel = np.array([168, 158, 140], np.float32)
    slope_y, slope_x = np.gradient(height, cell)
    light = np.clip(1 + 0.55 * slope_x - 0.35 * slope_y, 0.45, 1.5)
    colour = (bare * gravel + (1 - bare) * grass) * (light * (1 + 0.2 * grain))[..., None]
    return Ground(height=height, colour=np.clip(colour, 4, 250).astype(np.float32), cell=cell, corner=corner)
