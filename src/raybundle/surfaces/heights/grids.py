"""Values on a grid (rows, columns), beside those of their neighbours."""

from __future__ import annotations

import cv2
import numpy as np

from raybundle.numerics.arrays import Array


def filtered(values: Array, kernel: Array) -> Array:
    """(rows, columns) sums of what lies around each, by a kernel along both axes; nothing lies beyond the grid."""
    return cv2.sepFilter2D(
        np.ascontiguousarray(values, np.float64), cv2.CV_64F, kernel, kernel, borderType=cv2.BORDER_CONSTANT
    )


def shifted(values: Array, by: int, axis: int, beyond: float = np.nan) -> Array:
    """(rows, columns) what lies so many cells further along an axis."""
    found = np.roll(values, -by, axis=axis).astype(float)
    if by:
        edge = [slice(None), slice(None)]
        edge[axis] = slice(-by, None) if by > 0 else slice(None, -by)
        found[tuple(edge)] = beyond
    return found
