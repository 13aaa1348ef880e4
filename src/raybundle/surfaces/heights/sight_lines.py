"""What of heights on a grid a photograph sees: lines of sight from cells to its projection centre."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

SIGMAS = 3.0
"""Standard deviations of a height by which something has to stand above a line of sight to hide what lies on it."""


def seen_from(height: Array, sigma: Array, viewer: Array, cells: Index) -> Mask:
    """Whether lines of sight (n,) from cells to a viewer pass above all others.

    height  (rows, columns) in the unit of the viewer's third coordinate; NaN: nothing known, which hides nothing
    sigma   (rows, columns) standard deviations of the heights
    viewer  (3,) column, row, height; columns and rows in cells, the middle of the first cell is 0.5
    cells   (n,) numbers of cells with a height, row by row

    Lines are followed from cell to cell along the longer of their two directions, as long as anything stands as high.
    What stands above a line by less than three standard deviations or half of what the line rises in a cell, is taken
    for the surface itself.  Limits: what hangs over the grid, whose undersides are no heights.
    """
    rows, columns = height.shape
    highest = float(np.nanmax(height)) if np.isfinite(height).any() else -np.inf
    known = np.where(np.isfinite(height), height, -np.inf)
    seen = np.ones(len(cells), bool)
    row, column = np.divmod(cells, columns)
    start = known[row, column].astype(float)
    away = np.stack([viewer[0] - column - 0.5, viewer[1] - row - 0.5], axis=1)
    longer = np.maximum(np.abs(away).max(axis=1), 1.0)
    step, rise = away / longer[:, None], (viewer[2] - start) / longer
    room = SIGMAS * sigma[row, column] + 0.5 * np.abs(rise)
    active = np.flatnonzero(rise > 0)
    seen[rise <= 0] = False  # from behind
    k = 0
    while len(active):
        k += 1
        at = start[active] + k * rise[active]
        i = np.floor(column[active] + 0.5 + k * step[active, 0]).astype(int)
        j = np.floor(row[active] + 0.5 + k * step[active, 1]).astype(int)
        going = (at < highest) & (k < longer[active]) & (i >= 0) & (i < columns) & (j >= 0) & (j < rows)
        there = known[np.where(going, j, 0), np.where(going, i, 0)]
        hidden = going & (there > at + room[active])
        seen[active[hidden]] = False
        active = active[going & ~hidden]
    return seen
