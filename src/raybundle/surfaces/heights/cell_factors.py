"""How much of each part of `nodes` a height takes: by its level, and by the slope of the surface there.

Slopes are those of planes through heights nearby: of the widest square whose plane leaves no more than noise does, else
of three by three cells.  A plane across a step is no surface: there a cell takes that of a square beside it which the
step leaves out; what a step does to heights is counted for itself (`relief`).
"""

from __future__ import annotations

from itertools import product

import cv2
import numpy as np
from scipy.special import fdtri

from raybundle.numerics.arrays import Array
from raybundle.surfaces.heights.grids import shifted
from raybundle.surfaces.heights.heights import STEEPEST
from raybundle.surfaces.heights.nodes import at_cells
from raybundle.surfaces.heights.steps import CHANCE, Planes, planes

SIDES = (1, 2, 4)
"""Cells from the middle to the edge of the squares of planes"""
BAND, HALO = 512, 2 * SIDES[-1]
"""Rows that are done at once, and those around them that have a say"""
FEWEST = 5
"""Heights that show a slope"""
STEP = 0.25
"""Scatter about a plane, in sides of a cell, up to which it is relief: a step of one side leaves so much"""
OTHER = 8.5
"""By how much variances about planes of 9 cells differ but once in a hundred: F of 6 and 6"""


def factors_of(height: Array, local: Array, levels: Array, block: int, cell: float) -> Array:
    """(rows, columns, 4) float32 factors of the parts of heights (rows, columns), NaN where there is none.

    local   standard deviations by noise and roughness
    levels  (node rows, node columns) from where nodes count heights
    cell    its side, in the unit of the heights
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
        right, up = slopes_of_surface(height[first:last], local[first:last], cell)
        own = slice(top - first, min(top + BAND, shape[0]) - first)
        mine = found[top : top + BAND]
        mine[..., 2], mine[..., 3] = -right[own], -up[own]
    return found


def slopes_of_surface(height: Array, local: Array, cell: float) -> tuple[Array, Array]:
    """Rise over run (rows, columns) of the surface to the right and upwards; 0 where nothing is known.

    height  NaN where there is none
    local   standard deviations by noise and roughness
    cell    its side, in the unit of the heights
    """
    z = height.astype(float) / cell
    known = np.isfinite(z)
    if not known.any():
        return np.zeros(z.shape), np.zeros(z.shape)
    noise = np.where(known, np.nan_to_num(local.astype(float)) / cell, 0.0) ** 2
    right, down = _beside_steps(planes(z, SIDES[0]), noise)
    for side in SIDES[1:]:
        p, box = planes(z, side), (2 * side + 1,) * 2
        n = np.maximum(cv2.blur(known.astype(float), box, borderType=cv2.BORDER_CONSTANT), 1e-9)
        usual = fdtri(np.arange(1, box[0] ** 2), 1e6, 1 - CHANCE)[
            np.clip(p.freedom.astype(int), 1, box[0] ** 2 - 1) - 1
        ]
        even = p.scatter <= usual * cv2.blur(noise, box, borderType=cv2.BORDER_CONSTANT) / n
        even &= p.count >= FEWEST
        right, down = (np.where(even, a, b) for a, b in ((p.right, right), (p.down, down)))
    steepest = np.sqrt(1 / STEEPEST**2 - 1)
    right, down = (np.where(known, np.clip(x, -steepest, steepest), 0.0) for x in (right, down))
    return right, -down


def _beside_steps(p: Planes, noise: Array) -> tuple[Array, Array]:
    """Slopes (rows, columns) to the right and down by the smallest squares, at steps by those beside them.

    noise  variances of heights, which are in sides of a cell
    """
    scatter = np.where(p.count >= FEWEST, p.scatter, np.inf)
    best, best_right, best_down = scatter, p.right, p.down
    for dy, dx in product((-SIDES[0], 0, SIDES[0]), repeat=2):
        there, right, down = (shifted(shifted(x, dy, 0, np.inf), dx, 1, np.inf) for x in (scatter, p.right, p.down))
        better = there < best
        best, best_right, best_down = (
            np.where(better, a, b) for a, b in ((there, best), (right, best_right), (down, best_down))
        )
    step = np.isfinite(best) & (scatter > np.maximum(OTHER * np.maximum(best, noise), STEP**2))
    return np.where(step, best_right, p.right), np.where(step, best_down, p.down)
