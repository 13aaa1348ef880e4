"""Heights of the ground over a regular grid: where they are known, how they lie between, how steep they are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.objects.kinds.base import grid_triangles
from raybundle.objects.surface import Surface


@dataclass(frozen=True, slots=True, kw_only=True)
class Hole:
    """Cells without a height that hang together."""

    cells: int
    xy: tuple[float, float]
    """their mean place [m]"""
    size_m: tuple[float, float]
    """of the box that holds them, along x and y"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightGrid:
    """Heights over a grid of a plane coordinate system in metres."""

    heights: Array
    """(rows, columns) [m]; NaN where not known"""
    origin: tuple[float, float]
    """x, y of the centre of the first cell of the first row [m]"""
    column: tuple[float, float]
    """step in x and y from one column to the next [m]; (size, 0) for a grid along the axes"""
    row: tuple[float, float]
    """step in x and y from one row to the next [m]; (0, -size) where the first row is the northern one"""
    crs: str = ""
    """plane coordinate system, "" for a local one"""
    remarks: tuple[str, ...] = ()
    """what was assumed where it was read"""

    def __post_init__(self) -> None:
        """Refuse what is no grid."""
        if self.heights.ndim != 2 or min(self.heights.shape) < 2:
            raise InputError("height_grid.too_small", rows=self.heights.shape[0], columns=self.heights.shape[-1])
        area = self.column[0] * self.row[1] - self.column[1] * self.row[0]
        if not np.isfinite(area) or area == 0:
            raise InputError("height_grid.no_cell_area", across=self.column, down=self.row)
        if not np.isfinite(self.heights).any():
            raise InputError("height_grid.empty")

    @property
    def cell_m(self) -> float:
        """Side of a square of the area of a cell [m]."""
        return abs(self.column[0] * self.row[1] - self.column[1] * self.row[0]) ** 0.5

    @property
    def corners(self) -> Array:
        """(4, 2) outline of the area over which heights can be interpolated."""
        rows, columns = (n - 1 for n in self.heights.shape)
        return self.xy(np.array([[0, 0], [0, columns], [rows, columns], [rows, 0]]))

    def xy(self, place: Array) -> Array:
        """x, y (n, 2) of rows and columns (n, 2), which may lie between cells."""
        return np.array(self.origin) + np.asarray(place, float) @ np.array([self.row, self.column])

    def place(self, xy: Array) -> Array:
        """Rows and columns (n, 2), counted from the centre of the first cell, of x, y (n, 2)."""
        away = np.asarray(xy, float) - np.array(self.origin)
        return away @ np.linalg.inv(np.array([self.row, self.column]))

    def at(self, xy: Array) -> Array:
        """Heights (n,) at x, y (n, 2), bilinear between the centres of cells; NaN beyond them and at holes.

        A cell without a height spoils what is interpolated from it, and nothing that lies exactly on its neighbours.
        """
        place = self.place(xy)
        last = np.array(self.heights.shape) - 1
        place = np.where(np.abs(place - np.rint(place)) < 1e-9, np.rint(place), place)
        inside = ((place >= 0) & (place <= last)).all(axis=1)
        base = np.clip(np.floor(np.nan_to_num(place)), 0, last - 1).astype(int)
        part = place - base
        r, c = base.T
        h = self.heights
        total = np.zeros(len(place))
        for dr in (0, 1):
            for dc in (0, 1):
                weight = (part[:, 0] if dr else 1 - part[:, 0]) * (part[:, 1] if dc else 1 - part[:, 1])
                total += np.where(weight == 0, 0.0, weight * h[r + dr, c + dc])
        return np.where(inside, total, np.nan)

    def gradient(self, xy: Array) -> Array:
        """(n, 2) change of height by x and by y [m/m] at x, y (n, 2), over a cell to either side; NaN beside holes."""
        step = self.cell_m
        x, y = np.array([step, 0.0]), np.array([0.0, step])
        xy = np.asarray(xy, float)
        return np.stack([self.at(xy + d) - self.at(xy - d) for d in (x, y)], axis=1) / (2 * step)

    def slope(self, xy: Array) -> Array:
        """Slopes (n,) [rad] at x, y (n, 2), counted from the horizontal; NaN beside holes."""
        return np.arctan(np.linalg.norm(self.gradient(xy), axis=1))

    def centres(self) -> Array:
        """(rows, columns, 2) x, y of the centres of cells."""
        rows, columns = np.indices(self.heights.shape)
        return self.xy(np.stack([rows.ravel(), columns.ravel()], axis=1)).reshape(*self.heights.shape, 2)

    def holes(self, wanted: Mask | None = None) -> tuple[Hole, ...]:
        """Cells without a height, those that touch together, the largest first.

        wanted  (rows, columns) the cells that matter, as those of an area; None: all
        """
        from scipy.ndimage import label

        missing = ~np.isfinite(self.heights) & (True if wanted is None else wanted)
        found_labels: Any = label(missing, np.ones((3, 3)))
        labels, count = found_labels
        found: list[Hole] = []
        for k in range(1, count + 1):
            cells = np.argwhere(labels == k)
            xy = self.xy(cells)
            size = np.ptp(xy, axis=0) + np.abs(self.row) + np.abs(self.column)
            middle = xy.mean(axis=0)
            box = float(size[0]), float(size[1])
            found.append(Hole(cells=len(cells), xy=(float(middle[0]), float(middle[1])), size_m=box))
        return tuple(sorted(found, key=lambda h: -h.cells))


MOST_TRIANGLES = 60_000
"""Of a surface made of heights; of a finer grid every second, third ... cell is taken"""


def surface_of_heights(grid: HeightGrid, name: str = "ground") -> Surface:
    """The ground as triangles between the centres of cells; holes stay open.

    raises  InputError where fewer than four neighbouring cells have heights
    Limits: what lies between the cells that are taken, of more than 30 000.
    """
    rows, columns = grid.heights.shape
    step = max(1, int(np.ceil(np.sqrt(2 * rows * columns / MOST_TRIANGLES))))
    h = grid.heights[::step, ::step]
    r, c = np.indices(h.shape)
    xy = grid.xy(np.stack([r.ravel() * step, c.ravel() * step], axis=1))
    vertices = np.column_stack([xy, h.ravel()])
    triangles = grid_triangles(*h.shape)
    triangles = triangles[np.isfinite(vertices[triangles, 2]).all(axis=1)]
    if not len(triangles):
        raise InputError("height_grid.no_four_cells", name=name)
    if grid.column[0] * grid.row[1] - grid.column[1] * grid.row[0] < 0:
        triangles = triangles[:, ::-1]
    used, triangles = np.unique(triangles, return_inverse=True)
    w, l = np.ptp(vertices[used, :2], axis=0)
    return Surface(
        name=name, vertices=vertices[used], triangles=triangles.reshape(-1, 3),
        about=phrase("object_size.heights", width_m=w, length_m=l, cell_m=step * grid.cell_m),
    )  # fmt: skip
