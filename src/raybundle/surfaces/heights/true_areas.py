"""Areas of the surface itself, of heights on a grid, with standard deviations.

The surface lies over the middles of cells, two triangles to a square of four, in the mean of both diagonals: each
quarter of a cell has the slopes to its two neighbours on that side.  What lies between cells, and what the means over
cells flatten, is judged by the same surface of cells twice as wide: edges lose in proportion to the width, curvature in
proportion to its square (Richardson 1911).  Half of the difference is added, and the other half is left uncertain.
Relief within the windows of matching, as of grass and rubble, shows in no height: where heights scatter beyond their
noise, all that it may add is left uncertain.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import cv2
import numpy as np
from scipy.signal import convolve2d

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.grids import shifted
from raybundle.surfaces.heights.height_model import REACH, HeightModel
from raybundle.surfaces.heights.heights import between
from raybundle.surfaces.heights.steps import WINDOW, edges, half_side, planes

FURTHER = 6
"""Cells beyond an outline whose heights slopes within are made of, at most."""
AT_ONCE = 200_000
"""Cells of a strip, which are computed together."""
SIDES = (1, -1)
LARGEST = 1.0
"""Variance of a slope by noise up to which what noise adds is known: beyond, half of what is seen may be noise."""
VARIANCES = 0.15
"""Share to which variances of heights are known, and with them what noise adds to an area: robust chi-squares of sums
beside an exact object (benchmarks/surface_heights.py)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TrueArea:
    """Area of the surface itself."""

    value: float
    by_noise: float
    """standard deviation by errors of the heights"""
    between: float
    """by what lies between cells, within windows and in holes, and by how well noise is known"""

    @property
    def sigma(self) -> float:
        """Standard deviation, all parts."""
        return float(np.hypot(self.by_noise, self.between))


@dataclass(frozen=True, slots=True, kw_only=True)
class _Noise:
    """Covariances of the slopes by noise of heights, from one node to a neighbour some cells further."""

    variance: Array
    """(rows, columns) of a slope"""
    both: Array
    """(rows, columns) covariance of the slopes to the right and downwards"""
    alike: float
    """sum of squared correlations of a slope with all slopes around it, itself included"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Faceted:
    """A surface of triangles over nodes."""

    density: Array
    """(rows, columns) area over that in plan, less what noise adds"""
    gradient: Array
    """(rows, columns) of the weighted sum by the heights of nodes"""
    square: float
    """variance of the weighted sum by squares of noise"""
    added: float
    """what noise adds to the weighted sum, which was taken off"""
    second: float
    """the part of that by fourth powers of noise"""
    doubted: float
    """taken off the weighted sum where slopes are noise: half of what lies above the area in plan"""


def true_area(model: HeightModel, covered: Array) -> TrueArea:
    """Area of the surface itself within shares of cells (rows, columns).

    What noise adds to the area is taken off.  In filled holes what the surface around does is added, and left
    uncertain.  Limits: what the surface does within cells, other than by what it does between them.
    """
    rows, columns = (np.flatnonzero((covered > 0).any(axis=axis)) for axis in (1, 0))
    across = slice(max(int(columns[0]) - FURTHER, 0), int(columns[-1]) + FURTHER + 1)
    least = _least(model)
    gradient = np.zeros(model.shape)
    sums = np.zeros(8)
    deep = max(FURTHER, AT_ONCE // (across.stop - across.start))
    for top in range(int(rows[0]), int(rows[-1]) + 1, deep):
        down = slice(max(top - FURTHER, 0), top + deep + FURTHER)
        w = np.zeros(covered[down].shape)
        w[top - down.start : top - down.start + deep] = covered[top : top + deep]
        sums += _strip(model, (down, across), w[:, across] * model.cell**2, least, gradient)
    area, lost, rough, square, second, added, doubted, hidden = sums.tolist()
    moved = model.sum_of(gradient)
    # slopes have their noise twice: a square has twice its mean as variance, its derivative four times that
    by_noise = np.hypot(np.sqrt(moved.local**2 - min(square, moved.local**2 / 2)), moved.orientation)
    return TrueArea(
        value=max(area + lost + rough, float(covered.sum()) * model.cell**2), by_noise=float(by_noise),
        between=float(np.linalg.norm([lost, rough, second, doubted, VARIANCES * added, hidden])),
    )  # fmt: skip


def _strip(model: HeightModel, box: tuple[slice, slice], w: Array, least: Array | None, gradient: Array) -> Array:
    """Area of a strip with weights of cells, what lies between and in holes, squares, fourth powers, noise, doubt.

    gradient  (rows, columns) to which its own is added
    """
    h = np.where(model.known[box], model.heights.height[box], np.nan).astype(float)
    wide = _of_squares(h)
    # a cell is of up to four squares of cells: they share its weight
    whole = np.isfinite(wide).astype(float)
    several = _on_cells(whole)
    double = _of_squares(np.where(several > 0, w / np.maximum(4 * several, 1e-300), 0.0)) * 4 * whole
    weighted = np.where(several > 0, w, 0.0)
    fine = _faceted(h, w + weighted / 2, model.cell, 1, _noise(model, box, w > 0, 1))
    coarse = _faceted(wide, double, model.cell, 2, _noise(model, box, w > 0, 2))
    gradient[box] += np.where(np.isfinite(h), fine.gradient - _on_cells(coarse.gradient) / 2, 0.0)
    lost = float((weighted * fine.density).sum() - (double * coarse.density).sum()) / 2
    rough = 0.0
    if least is not None:
        uneven = np.where(model.holes.filled[box], least[model.holes.number[box]], 0.0) if model.holes else 0.0
        root, uneven = np.maximum(fine.density, 1.0), uneven / model.cell**2
        # rises of much more than a cell add as much as they are
        rough = float((w * np.minimum(uneven * (1 + root**2) / root**3 / 2, np.sqrt(uneven))).sum())
    area = float((w * fine.density).sum())
    added = fine.added - coarse.added / 2
    hidden = float((w * _within_windows(model, box, fine.density)).sum())
    return np.array([area, lost, rough, fine.square, fine.second, added, fine.doubted, hidden])


def _within_windows(model: HeightModel, box: tuple[slice, slice], density: Array) -> Array:
    """(rows, columns) area over that in plan that relief within windows may add to a density, where there is any.

    Relief of the width of a window is what its depth shows nothing of: waves so long have slopes of pi s / rho, where
    s is how far heights scatter and rho half a window.  Steps add no more than their height, which is sqrt(12) s at
    most, once in each window.  Walls and creases are no such relief: facets have them.
    """
    side = min(half_side(model.length), FURTHER // 2)
    known = model.known[box]
    z = np.where(known, model.heights.height[box], np.inf).astype(float)
    noise = np.where(known, np.nan_to_num(model.heights.local[box].astype(float)), 0.0) ** 2
    there, beyond = (cv2.blur(v, (2 * side + 1,) * 2) for v in (known.astype(float), planes(z, side).scatter - noise))
    scatter = np.sqrt(np.maximum(beyond / np.maximum(there, 1e-9), 0.0)) / model.cell
    seen = np.maximum(density, 1.0)
    waves = np.hypot(seen, np.pi * scatter / (WINDOW * model.length)) - seen
    rough = 1 - edges(np.where(known, z, np.nan))
    return np.where(known, rough * np.minimum(waves, np.sqrt(12) * scatter / (2 * WINDOW * model.length)), 0.0)


def _of_squares(values: Array) -> Array:
    """(rows - 1, columns - 1) means of squares of four cells."""
    v = values
    return (v[:-1, :-1] + v[1:, :-1] + v[:-1, 1:] + v[1:, 1:]) / 4


def _on_cells(values: Array) -> Array:
    """(rows, columns) a quarter of what each of the squares has that a cell is of."""
    return _of_squares(np.pad(values, 1))


def _faceted(h: Array, w: Array, cell: float, apart: int, noise: _Noise) -> _Faceted:
    """The surface of triangles over nodes with heights (NaN: none), to neighbours so many cells apart."""
    span = apart * cell
    has, slope = dict[tuple[int, int], Mask](), dict[tuple[int, int], Array]()
    for axis, side in product((0, 1), SIDES):
        rise = side * (shifted(h, side * apart, axis) - h)
        has[axis, side] = np.isfinite(rise)
        slope[axis, side] = np.nan_to_num(rise) / span
    first, curved = ({k: np.zeros(h.shape) for k in has} for _ in range(2))
    density, added, second = (np.zeros(h.shape) for _ in range(3))
    used = {k: _of_either(has, slope, k) for k in has}
    V = np.minimum(noise.variance, LARGEST)
    for down, right in product(SIDES, SIDES):
        p, q = used[0, down], used[1, right]
        flat = 1 / np.sqrt(1 + p**2 + q**2)
        cubed = flat**2 * flat
        density += 1 / flat / 4
        # an eighth of what the Laplacian makes of its own: noise in what is taken off
        second -= V**2 * cubed * (1 + 6 * flat**2 - 15 * flat * cubed) / 32
        added -= down * right * noise.both * p * q * cubed / 4
        for k, one, other in (((0, down), p, q), ((1, right), q, p)):
            first[k] += w * one * flat / 4
            # half of the second derivative
            bent = V * (1 + other**2) * cubed / 8
            added += bent
            curved[k] += w * bent
    gradient, square = np.zeros(h.shape), 0.0
    for axis in (0, 1):
        rises, bends = (_by_edges(has, parts, axis, apart) for parts in (first, curved))
        gradient += (shifted(rises, -apart, axis, 0.0) - rises) / span
        square += 2 * noise.alike * float((bends**2).sum())
    density, added, second = (np.where(np.isfinite(h), v, 0.0) for v in (density, added + second, second))
    density -= added
    doubt = np.where(noise.variance > LARGEST, np.maximum(density - 1, 0.0) / 2, 0.0)
    return _Faceted(
        density=density - doubt, gradient=gradient, square=square, second=float((w * second).sum()),
        added=float((w * added).sum()), doubted=float((w * doubt).sum()),
    )  # fmt: skip


def _of_either(has: dict[tuple[int, int], Mask], values: dict[tuple[int, int], Array], k: tuple[int, int]) -> Array:
    """Slopes to one side, where there is no neighbour those to the other, where there is none either 0."""
    axis, side = k
    return np.where(has[k], values[k], np.where(has[axis, -side], values[axis, -side], 0.0))


def _by_edges(
    has: dict[tuple[int, int], Mask], parts: dict[tuple[int, int], Array], axis: int, apart: int
) -> Array:  # fmt: skip
    """(rows, columns) what nodes have by slopes to either side, for each edge from a node onwards along an axis."""
    on, back = (
        np.where(has[axis, side], parts[axis, side] + np.where(has[axis, -side], 0.0, parts[axis, -side]), 0.0)
        for side in SIDES
    )
    return on + shifted(back, apart, axis, 0.0)


def _noise(model: HeightModel, box: tuple[slice, ...], used: Mask, apart: int) -> _Noise:
    """Noise of slopes between nodes that are cells (1 apart) or means of squares of four (2 apart)."""
    h = model.heights
    local, point = (np.nan_to_num(v[box].astype(float)) ** 2 for v in (h.local, h.point))
    if model.holes is not None:
        # what spans a hole has no noise of its own
        local, point = (np.where(model.holes.filled[box], 0.0, v) for v in (local, point))
    image = h.image[box]
    near = used[:, 1:] & used[:, :-1]
    same = float((image[:, 1:] == image[:, :-1])[near].mean()) if near.any() else 1.0
    point *= same + (1 - same) * model.apart
    n = int(np.ceil(REACH * model.length)) + 1
    steps = np.arange(-n, n + 1.0)
    alike = between(steps[:, None], steps[None, :], model.length)
    alike[n, n] = 0.0
    alone = np.zeros(alike.shape)
    alone[n, n] = 1.0
    node = np.full((apart, apart), 1 / apart**2)
    right = np.concatenate([-node, node], axis=1)

    def covariances(other: Array) -> tuple[Array, Array]:
        """Of the slope to the right with others so far from it, by what cells have alone and with neighbours."""
        lags = convolve2d(right, other[::-1, ::-1])
        return convolve2d(alone, lags), convolve2d(alike, lags)

    own, shared = covariances(right)
    middle = own.shape[0] // 2, own.shape[1] // 2
    own_both, shared_both = covariances(right.T)
    # where both start from one node
    corner = n + apart - 1 + apart, n + apart - 1
    if apart > 1:
        local, point = _of_squares(local), _of_squares(point)
    span = (apart * model.cell) ** 2
    variance = np.maximum(own[middle] * local + shared[middle] * point, 0.0) / span
    both = (own_both[corner] * local + shared_both[corner] * point) / span
    weight = float(point.sum() / local.sum()) if local.any() else 0.0
    one, two = own + weight * shared, own_both + weight * shared_both
    squares = float((one**2).sum() + (two**2).sum()) / max(float(one[middle]) ** 2, 1e-300)
    return _Noise(variance=variance, both=both, alike=squares)


def _least(model: HeightModel) -> Array | None:
    """(holes + 1,) variance of a rise from cell to cell of what surfaces have in holes beside what spans them.

    What spans a hole differs from the surface by a variance of 2 c one cell from its rim, where it is least: for a
    variogram c d^p that is the variance of a rise from cell to cell.
    """
    if model.holes is None or not model.holes.filled.any():
        return None
    number, variance = model.holes.number, model.holes.sigma.astype(float) ** 2
    least = np.full(int(number.max()) + 1, np.inf)
    np.minimum.at(least, number.ravel(), variance.ravel())
    return least
