"""What lies within the resolution of heights: steps, of which a height may be on either side.

A window of the photographs has an extent, and an edge may lie anywhere in it.  How high steps are follows from the
heights themselves: they scatter about the plane of their neighbours by more than their noise lets them.  An edge that
is displaced by up to rho cells to either side moves the mean over a cell that it crosses by a share of the step,
whose variance is rho^2 / 3 of its square; a plane through three cells on either side leaves 1 / 12 of it.  That holds
for steps that are high against the pixels.  Of low ones windows show the mean of both sides, rightly weighted, and
little is wrong: the share of the variance grows as q / (q + 4) with the scatter q in widths of a pixel, as it does
against the exact geometry of a rendered wall (benchmarks/surface_heights.py) with cells of 4.6 pixels and, in the
differences of two halves of its photographs, of 9.  Beside a hole the surface may lie as low as it does beyond it:
steps hide what is below them.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from scipy.special import fdtri

from raybundle.numerics.arrays import Array
from raybundle.surfaces.heights.grids import filtered

PIXEL = 1 / 3.8
"""Width of a pixel in lengths of correlation, which are twice the 1.9 px of a window's weights"""
WINDOW = 3 * PIXEL
"""Half a window of 7 px in lengths of correlation"""
HIGH = 4.0
"""Scatter in widths of a pixel at which half of the variance of a high step is reached"""
NEAR, FAR, FARTHER = 0.2, 0.3, 8.0
"""Shares of the variance of errors by steps that cells have in common: over the length of a window, and over so many of
these.  Windows put all of a straight edge off to one side, and what stands before another thing hides it all along
(benchmarks/surface_heights.py, its part about steps: correlations from cell to cell and over 24 cells).  Both are of
straight edges.  In clutter steps go up and down on all sides, and errors by them have nothing in common (rendered
terrains: correlations of -0.03 to 0.01 at two to eight cells)."""
REACH, FINE = 3.0, 12.0
"""Distances of correlation up to which cells are taken as correlated; cells or squares in one of them"""
MOST_CELLS = 64
"""Half the side of the square that a plane is laid through, at most."""
REACH_CELLS = 32
"""How far holes are looked across."""
STEEP = 0.9
"""Quantile of differences of neighbours that a slope is taken for where it goes on into a hole."""
EDGE = 3
"""Cells from the middle to the side of the square in which an edge is looked for"""
AROUND_EDGE = EDGE + 2
"""Cells around one that its edge depends on"""
BY_CHANCE = 0.06
"""Mean square of the coherence of heights that have nothing in common, in that square (drawn heights: 0.059)"""
CHANCE = 1e-3
"""Share of cells without a step whose neighbours scatter by more than is allowed to noise."""


def half_side(length: float) -> int:
    """Cells from the middle to the edge of the square within which a step counts.

    length  at which the errors of two points correlate by 1 / e [cells]
    """
    return int(np.clip(np.ceil(WINDOW * length), 1, MOST_CELLS))


def step_length(length: float) -> float:
    """Distance in cells at which errors that one window gives to neighbours correlate by 1 / e: that square's side."""
    return 2.0 * half_side(length) + 1


def alike(length: float) -> tuple[tuple[float, float], ...]:
    """Shares of the variance by steps that cells of an edge have in common, and distances of correlation by 1 / e.

    Distances are in cells.  The rest of the variance is each cell's own.
    """
    near = step_length(length)
    return (NEAR, near), (FAR, FARTHER * near)


def variance_by_steps(s: Array, length: float, along: Array) -> float:
    """Variance of a sum of errors by steps, of the products (rows, columns) of weights and standard deviations.

    along  (rows, columns) 0 to 1, how far each lies on an edge (`along_edges`): there alone errors are alike
    """
    if not s.any():
        return 0.0
    part = s * along
    found = float((s**2).sum()) - (NEAR + FAR) * float((part**2).sum())
    return found + sum(share * variance_of_alike(part, distance) for share, distance in alike(length))


def variance_of_alike(s: Array, distance: float) -> float:
    """Variance of a sum of errors that correlate by exp(-(d / distance)^2), of weights times standard deviations.

    s         (rows, columns)
    distance  in cells
    """
    # what reaches far is the same of sums over small squares
    side = max(1, int(distance / FINE))
    rows, columns = (-(-n // side) * side for n in s.shape)
    t = np.zeros((rows, columns))
    t[: s.shape[0], : s.shape[1]] = s
    t = t.reshape(rows // side, side, columns // side, side).sum(axis=(1, 3))
    n = int(np.ceil(REACH * distance / side))
    around = filtered(t, np.exp(-((np.arange(-n, n + 1.0) * side / distance) ** 2)))
    return max(float((t * around).sum()), 0.0)


def halo(length: float) -> int:
    """Cells around a part that have a say in it."""
    return REACH_CELLS + half_side(length)


def steps_of(height: Array, local: Array, length: float, cell: float) -> Array:
    """(rows, columns) float32 standard deviation of heights by steps of the surface; 0 where there is none.

    height  NaN where there is none
    local   standard deviations by noise and roughness
    length  at which the errors of two points correlate by 1 / e [cells]
    cell    its side, in the unit of the heights
    """
    known = np.isfinite(height)
    if known.sum() < 4:
        return np.zeros(height.shape, np.float32)
    side = half_side(length)
    whole = _across_holes(height, known)
    p = planes(whole, side)
    scatter, freedom = p.scatter, p.freedom
    box = (2 * side + 1,) * 2
    noise = cv2.blur(np.where(known, np.square(local, dtype=float), 0.0), box)
    noise /= np.maximum(cv2.blur(known.astype(float), box), 1e-9)
    usual = fdtri(np.arange(1, box[0] ** 2 - 2), 1e6, 1 - CHANCE)
    beyond = scatter > usual[np.clip(freedom.astype(int), 1, len(usual)) - 1] * noise
    root = np.sqrt(np.maximum(scatter - noise, 0.0))
    share = root / (root + HIGH * PIXEL * length * cell) * 4 * min(WINDOW * length, 1.0) ** 2
    return np.where(known & beyond, root * np.sqrt(share), 0.0).astype(np.float32)


def edges(height: Array) -> Array:
    """(rows, columns) 0 to 1: how far what heights leave of their means nearby runs along one line; NaN: none.

    1 of walls and creases, whose errors are alike along them, and of a plane; small where ground is rough on all sides.
    It is the coherence of the structure tensor (Bigun and Granlund 1987) of three by three cells less their mean.
    """
    known = np.isfinite(height)
    z = np.where(known, height, 0.0).astype(float)
    there = cv2.blur(known.astype(float), (3, 3))
    left = np.where(known, z - cv2.blur(z, (3, 3)) / np.maximum(there, 1e-9), 0.0)
    right, down = (cv2.Sobel(left, cv2.CV_64F, *axis, ksize=3) for axis in ((1, 0), (0, 1)))
    box = (2 * EDGE + 1,) * 2
    xx, yy, xy = (cv2.blur(v, box) for v in (right**2, down**2, right * down))
    return np.where(xx + yy > 0, np.hypot(xx - yy, 2 * xy) / np.maximum(xx + yy, 1e-300), 1.0)


def along_edges(height: Array) -> Array:
    """(rows, columns) 0 to 1: the square of `edges` as far as it is beyond chance; NaN: none."""
    return np.maximum(edges(height) ** 2 - BY_CHANCE, 0.0) / (1 - BY_CHANCE)


def _across_holes(height: Array, known: Array) -> Array:
    """Heights, and in holes the lowest surface that those around let expect, of a usual slope; infinite far away."""
    apart = np.concatenate([np.abs(np.diff(height, axis=k)).ravel() for k in (0, 1)])
    apart = apart[np.isfinite(apart)]
    slope = float(np.quantile(apart, STEEP)) if len(apart) else 0.0
    found = np.where(known, height, np.inf)
    cross = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))
    for _ in range(REACH_CELLS):
        lower = cv2.erode(found, cross, borderType=cv2.BORDER_CONSTANT, borderValue=float("inf")) + slope
        found = np.where(known, height, np.minimum(found, lower))
    return found


@dataclass(frozen=True, slots=True, kw_only=True)
class Planes:
    """Planes through heights in squares about each cell; arrays (rows, columns)."""

    scatter: Array
    """mean square of what they leave"""
    freedom: Array
    """degrees of freedom"""
    right: Array
    down: Array
    """rise from cell to cell; 0 where the heights show none"""
    count: Array
    """of heights"""


def planes(height: Array, side: int) -> Planes:
    """Planes by least squares in squares that reach so many cells to each side; unknown heights are not finite."""
    there = np.isfinite(height)
    z = np.where(there, height - np.median(height[there]), 0.0)
    one, along = np.ones(2 * side + 1), np.arange(-side, side + 1.0)

    def sums(values: Array, across: Array, down: Array) -> Array:
        return cv2.sepFilter2D(values, cv2.CV_64F, across, down, borderType=cv2.BORDER_CONSTANT)

    w = there.astype(float)
    n, x, y = sums(w, one, one), sums(w, along, one), sums(w, one, along)
    xx, xy, yy = sums(w, along**2, one), sums(w, along, along), sums(w, one, along**2)
    s, sx, sy, ss = sums(z, one, one), sums(z, along, one), sums(z, one, along), sums(z * z, one, one)
    n = np.maximum(n, 1.0)
    # about their means, the equations of two slopes remain
    cxx, cxy, cyy = xx - x * x / n, xy - x * y / n, yy - y * y / n
    bx, by = sx - s * x / n, sy - s * y / n
    determinant = cxx * cyy - cxy**2
    good = determinant > 1e-9 * np.maximum(cxx * cyy, 1e-300)
    d = np.where(good, determinant, 1.0)
    right, down = (np.where(good, v, 0.0) / d for v in (cyy * bx - cxy * by, cxx * by - cxy * bx))
    freedom = np.maximum(n - 3, 1.0)
    scatter = np.maximum(ss - s * s / n - right * bx - down * by, 0.0) / freedom
    return Planes(scatter=scatter, freedom=freedom, right=right, down=down, count=n)
