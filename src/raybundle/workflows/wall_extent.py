"""The part of a plane that a wall covers, with its relief, from the object points around the plane."""

from __future__ import annotations

from typing import cast

import numpy as np
from scipy.ndimage import binary_dilation, label

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.workflows.object_plane import Plane

DEPTH = 0.2
"""Of what belongs to a wall, in front of its plane and behind, as a share of its longer side: wings stand further out
than its relief (`numerics.planes.RELIEF`)"""
CELLS = 16
"""Of the longer side of the points in the plane: points in cells that touch belong together"""
STRAY = 0.002
"""Share of the points beyond each edge: matches that are wrong"""
MARGIN = 0.02
"""Added at each edge, as a share of the longer side: points end before the wall does"""
LEAST = 20
"""Points from which on strays are left out"""


def wall_extent(plane: Plane, xyz: Array) -> tuple[Array, tuple[float, float]]:
    """Left, bottom, right, top (4,) of a wall, and the depths between which its points lie.

    xyz  (n, 3) object points, in the frame of the block
    Points count that lie near the plane (`DEPTH`) and in the largest group of occupied cells that touch.
    Limits: parts of the wall beyond a gap that is wider than three cells, as behind a tree.
    """
    at = plane.coordinates(xyz[np.isfinite(xyz).all(axis=1)])
    left, bottom, right, top = plane.extent
    longer = max(right - left, top - bottom)
    at = at[np.abs(at[:, 2]) <= DEPTH * longer]
    if len(at) < LEAST:
        return plane.extent, (float(at[:, 2].min(initial=0.0)), float(at[:, 2].max(initial=0.0)))
    at = at[_together(at[:, :2], longer / CELLS)]
    low, high = np.quantile(at, [STRAY, 1 - STRAY], axis=0)
    margin = MARGIN * float((high - low)[:2].max())
    extent = np.concatenate([low[:2] - margin, high[:2] + margin])
    return extent, (float(low[2]), float(high[2]))


def _together(at: Array, cell: float) -> Mask:
    """(n,) places in the largest group: that of most places, of cells with at most two empty ones between."""
    low = at.min(axis=0)
    column, row = ((at - low) / cell).astype(int).T
    shape = int(row.max()) + 1, int(column.max()) + 1
    if shape[0] * shape[1] > CELLS**5:  # one stray point far away
        return np.ones(len(at), bool)
    occupied = np.zeros(shape, bool)
    occupied[row, column] = True
    wider = binary_dilation(occupied, np.ones((3, 3)))
    groups = cast("tuple[Index, int]", label(wider, np.ones((3, 3))))[0]
    mine = groups[row, column]
    return mine == np.bincount(mine).argmax()
