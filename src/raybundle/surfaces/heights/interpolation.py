"""Heights between cells: small gaps closed from around, and heights at places between the middles."""

from __future__ import annotations

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Index

REACH = 2
"""Cells around a gap from which it is closed."""
LEAST = 0.5
"""Share of these that have to be known: gaps in a surface are closed, and nothing is put beyond its outline."""
STEEP = 2.0
"""Rise of neighbours, in sides of a cell, from which they are sides of a step (63 degrees): nothing lies between."""

OTHER_SIDE = 0.125
"""Share of a cell beside a step that lies on the other side: the edge is anywhere in the half next to it, and the cell
may lie beside it on either side."""


def closed(height: Array, local: Array, orientation: Array) -> tuple[Array, Array, Array]:
    """The same arrays (rows, columns) with small gaps closed by the mean of what is around.

    height       NaN in gaps
    local        standard deviations by noise and roughness: in a gap with the scatter of what is around
    orientation  standard deviations by orientation and calibration
    """
    known = np.isfinite(height)
    if known.all() or not known.any():
        return height, local, orientation
    side = 2 * REACH + 1
    mean_local, n = _mean(local, known, side)
    mean, _ = _mean(height, known, side)
    middle = float(np.mean(height[known]))  # squares of heights above the sea would lose their differences
    square, _ = _mean(np.square(height - middle), known, side)
    scatter = np.sqrt(np.maximum(square - np.square(mean - middle), 0))
    gap = ~known & (n >= LEAST * side**2)
    of_orientation, _ = _mean(orientation, known, side)
    return (
        np.where(gap, mean, height).astype(np.float32), np.where(gap, np.hypot(mean_local, scatter), local),
        np.where(gap, of_orientation, orientation),
    )  # fmt: skip


def _mean(values: Array, known: Array, side: int) -> tuple[Array, Array]:
    """Means of what is known around each cell, and how many these are."""

    def total(x: Array) -> Array:
        return cv2.boxFilter(x.astype(np.float64), -1, (side, side), normalize=False, borderType=cv2.BORDER_CONSTANT)

    n = total(known)
    return total(np.where(known, values, 0.0)) / np.maximum(n, 1), n


def slopes_of(height: Array, cell: float) -> tuple[Array, Array]:
    """Rise (rows, columns) to the right and upwards, by neighbours on both sides, or on the known one; else 0."""
    found = list[Array]()
    for axis, sign in ((1, 1.0), (0, -1.0)):
        ahead, behind = np.full(height.shape, np.nan), np.full(height.shape, np.nan)
        step = np.diff(height.astype(float), axis=axis)
        first, last = ([slice(None)] * 2 for _ in range(2))
        first[axis], last[axis] = slice(None, -1), slice(1, None)
        ahead[tuple(first)], behind[tuple(last)] = step, step
        both = np.where(np.isfinite(ahead), ahead, behind), np.where(np.isfinite(behind), behind, ahead)
        found.append(sign * np.nan_to_num((both[0] + both[1]) / 2) / cell)
    return found[0], found[1]


def beside_steps(height: Array, cell: float) -> Array:
    """(rows, columns) standard deviation of heights that may lie on the other side of a step; 0 where there is none."""
    found = np.zeros(height.shape)
    for axis in (0, 1):
        step = np.abs(np.nan_to_num(np.diff(height.astype(float), axis=axis)))
        first, last = ([slice(None)] * 2 for _ in range(2))
        first[axis], last[axis] = slice(None, -1), slice(1, None)
        for side in (tuple(first), tuple(last)):
            found[side] = np.maximum(found[side], step)
    return np.where(found > STEEP * cell, found, 0.0) * np.sqrt(OTHER_SIDE * (1 - OTHER_SIDE))


def bends_of(height: Array) -> Array:
    """(rows, columns) half of how far heights lie off the middle between neighbours, the larger of both directions.

    A height stands for a cell; by so much heights between cells may be off where the surface bends.
    """
    found = np.zeros(height.shape)
    z = height.astype(float)
    for axis in (0, 1):
        ends, middle = np.moveaxis(z, axis, 0), np.moveaxis(np.zeros(z.shape), axis, 0)
        middle[1:-1] = np.abs(np.nan_to_num(ends[2:] + ends[:-2] - 2 * ends[1:-1])) / 4
        found = np.maximum(found, np.moveaxis(middle, 0, axis))
    return found


def height_at(height: Array, column: Array, row: Array, cell: float) -> tuple[Array, Index, Index]:
    """Heights (...) at places between cells, and column and row of the cell in which each lies.

    height       (rows, columns), NaN where nothing is known
    column, row  (...) in cells, the middle of the first cell is 0.5; within the grid
    cell         side of a cell in the unit of the heights

    Linear between the middles of four cells; beside a step or an unknown one the height of the cell itself.
    """
    rows, columns = height.shape
    j, i = np.clip(row.astype(int), 0, rows - 1), np.clip(column.astype(int), 0, columns - 1)
    left, top = np.floor(column - 0.5).astype(int), np.floor(row - 0.5).astype(int)
    x, y = column - 0.5 - left, row - 0.5 - top
    four = np.stack([
        height[np.clip(top + b, 0, rows - 1), np.clip(left + a, 0, columns - 1)] for b in (0, 1) for a in (0, 1)
    ]).astype(float)  # fmt: skip
    w = np.stack([(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y])
    even = four.max(axis=0) - four.min(axis=0) <= STEEP * cell  # not where one is NaN
    return np.where(even, (w * four).sum(axis=0), height[j, i]), i, j
