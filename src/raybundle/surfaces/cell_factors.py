"""How much of each part of `nodes` a height takes: by its level, and by the slope of the surface there.

Slopes are those of planes through heights nearby.  A plane across a step is no surface: a cell takes that of a square
beside it which the step leaves out.  Slopes of single cells are also of noise; by so much of their variance as noise
explains they are drawn to those of a wider plane, so that shifts in plan move a wall that is flat but for noise alike.
"""

from __future__ import annotations

import cv2
import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.surfaces.heights import STEEPEST
from raybundle.surfaces.nodes import at_cells
from raybundle.surfaces.relief import Planes, planes

NARROW, WIDE = 2, 8
"""Cells from the middle to the edge of the squares of planes"""
BAND, HALO = 512, 3 * WIDE
"""Rows that are done at once, and those around them that have a say"""
FEWEST = 6
"""Heights that tell a slope"""
STEP = 0.25
"""Scatter about a plane, in sides of a cell, up to which it is relief: a step of one side leaves so much"""
OTHER = 4.0
"""By how much variances about planes of 25 cells differ but once in a thousand: F of 22 and 22"""


def factors_of(height: Array, local: Array, levels: Array, block: int, cell: float, length: float) -> Array:
    """(rows, columns, 4) float32 factors of the parts of heights (rows, columns), NaN where there is none.

    local   standard deviations by noise and roughness
    levels  (node rows, node columns) from where nodes count heights
    cell    its side, in the unit of the heights
    length  at which the errors of two points correlate by 1 / e [cells]
    """
    shape = height.shape[0], height.shape[1]
    found = np.zeros((*shape, 4), np.float32)
    found[..., 0] = 1.0
    known = np.isfinite(height)
    if not known.any():
        return found
    above = height.astype(float) - at_cells(levels[..., None], block, shape)
    found[..., 1] = np.where(known, above, 0.0)
    for top in range(0, shape[0], BAND):
        first, last = max(top - HALO, 0), min(top + BAND + HALO, shape[0])
        right, up = slopes_of_surface(height[first:last], local[first:last], cell, length)
        own = slice(top - first, min(top + BAND, shape[0]) - first)
        mine = found[top : top + BAND]
        mine[..., 2], mine[..., 3] = -right[own], -up[own]
    return found


def slopes_of_surface(height: Array, local: Array, cell: float, length: float) -> tuple[Array, Array]:
    """Rise over run (rows, columns) of the surface to the right and upwards; 0 where nothing is known."""
    z = height.astype(float) / cell
    known = np.isfinite(z)
    noise = np.where(known, np.nan_to_num(local.astype(float)) / cell, 0.0) ** 2
    wide = planes(z, WIDE)
    fine = _beside_steps(z, noise, wide)
    # neighbours with common errors count once
    alike = min(1 + np.pi * length**2, (2.0 * NARROW + 1) ** 2)
    by_noise = 2 * alike * _mean(noise, known) / _squares(NARROW)
    apart = [a - b for a, b in zip(fine, (wide.right, wide.down), strict=True)]
    spread = _mean(np.where(known, apart[0] ** 2 + apart[1] ** 2, 0.0), known)
    share = np.clip(1 - by_noise / np.maximum(spread, 1e-300), 0.0, 1.0)
    steepest = np.sqrt(1 / STEEPEST**2 - 1)
    right, down = (
        np.where(known, np.clip(w + share * a, -steepest, steepest), 0.0)
        for w, a in zip((wide.right, wide.down), apart, strict=True)
    )
    return right, -down


def _squares(side: int) -> float:
    """The sum of squares of columns from the middle, over a square of cells."""
    return (2 * side + 1) * float((np.arange(-side, side + 1.0) ** 2).sum())


def _mean(values: Array, known: Array) -> Array:
    """Of what is known around."""
    box = (2 * WIDE + 1,) * 2
    n = cv2.blur(known.astype(float), box, borderType=cv2.BORDER_CONSTANT)
    return cv2.blur(values, box, borderType=cv2.BORDER_CONSTANT) / np.maximum(n, 1e-9)


def _beside_steps(z: Array, noise: Array, wide: Planes) -> tuple[Array, Array]:
    """Slopes (rows, columns) to the right and down of heights in sides of a cell."""
    p = planes(z, NARROW)
    good = p.count >= FEWEST
    scatter, right, down = np.where(good, p.scatter, np.inf), p.right, p.down
    best, best_right, best_down = (x.copy() for x in (scatter, right, down))
    for dy in (-NARROW, NARROW):
        for dx in (-NARROW, NARROW):
            there, r, d = (_shifted(x, dy, dx) for x in (scatter, right, down))
            better = there < best
            best, best_right, best_down = (
                np.where(better, a, b) for a, b in ((there, best), (r, best_right), (d, best_down))
            )
    step = np.isfinite(best) & (scatter > np.maximum(OTHER * np.maximum(best, noise), STEP**2))
    right, down = (
        np.where(step, beside, np.where(good, own, other))
        for beside, own, other in ((best_right, right, wide.right), (best_down, down, wide.down))
    )
    return right, down


def _shifted(values: Array, down: int, right: int) -> Array:
    """Those of cells so far down and to the right; beyond the grid they are infinite."""
    found = np.full(values.shape, np.inf)
    rows, columns = values.shape
    into = slice(max(-down, 0), rows - max(down, 0)), slice(max(-right, 0), columns - max(right, 0))
    of = slice(max(down, 0), rows + min(down, 0)), slice(max(right, 0), columns + min(right, 0))
    found[into] = values[of]
    return found
