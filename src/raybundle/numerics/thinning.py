"""Points spread over an object: one of each cell of a regular grid."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Index

FINEST = 20
"""Halvings of the extent in which cells are looked for: three of them are distinguished in one 64-bit number"""


def one_of_each_cell(xyz: Array, room: int) -> tuple[Index, float]:
    """The first place (n, 3) in each occupied cell of the finest grid with at most `room` of them, and its edge."""
    low = xyz.min(axis=0)
    extent = float((xyz - low).max()) or 1.0
    coarse, fine = 0.0, float(FINEST)
    best, edge = np.zeros(0, np.int64), extent
    for _ in range(12):  # to a 200th of an octave
        halvings = (coarse + fine) / 2
        cell = extent / 2**halvings
        i, j, k = ((xyz - low) / cell).astype(np.int64).T
        _, first = np.unique((i << 42) | (j << 21) | k, return_index=True)
        if len(first) <= room:
            coarse, best, edge = halvings, first, cell
        else:
            fine = halvings
    return best, edge
