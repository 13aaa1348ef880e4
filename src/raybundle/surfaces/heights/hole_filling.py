"""Holes between heights, filled by what lies around them, with a standard deviation that grows with the gap.

Within a hole the heights are those of a membrane that is spanned over its rim (a discrete Laplace equation).  What
the surface does in between is given by its own variogram, E (h(x + d) - h(x))^2 / 2 = c d^p, with p of the whole and c
of the surroundings, from second differences, which tilts do not touch (Matheron 1963).  Straight between two rims the
error of a place at the distance d from the nearest has the variance 2 c d^p (1 - d / D)^p, D being the width of the
gap.

A rim that falls into two levels has a step on it, and what a step hides lies below it: such a hole is spanned from its
lower side alone.  Where within the hole the step lies is not known; over all of it a height may be anything between the
two, which has the variance H^2 / 12 for a step of H.
"""

from __future__ import annotations

from dataclasses import replace
from typing import cast

import numpy as np
from scipy.ndimage import binary_dilation, distance_transform_edt, find_objects, gaussian_filter, label
from scipy.sparse import csr_array
from scipy.sparse.linalg import spsolve

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.heights.height_model import HeightModel, Holes
from raybundle.surfaces.heights.heights import Heights

LAGS = (2, 4)
"""Cells; windows that overlap do not reach so far"""
LEAST_POWER, MOST_POWER = 0.3, 1.9
AROUND = 8.0
"""Cells over which the roughness of the surroundings is averaged."""
EIGHT = np.ones((3, 3), int)
TWO_LEVELS = 5.0
"""Standard deviations within them that two levels of a rim lie apart; the halves of an even slope do by 3.5"""
LEAST_SIDE, LEAST_RIM = 0.15, 8
"""Share of a rim that is a side of it, and the cells that show any"""


def filled(model: HeightModel, limit: float, within: Mask | None = None) -> HeightModel:
    """The same with holes filled that heights enclose and whose cells lie no further than `limit` cells from one.

    within  (rows, columns) where cells so near are filled, too, that are of a wider hole, or of one that is open to
            the edge of the grid: an outline may cut them off

    Limits: what stands in a hole and shows nowhere around it.
    """
    unknown = ~model.known
    number, _ = parts_of(unknown)
    edge = np.unique(np.concatenate([number[0], number[-1], number[:, 0], number[:, -1]]))
    depth = depths(model)
    deepest = _largest(number, depth)
    small = deepest <= limit
    small[edge] = False
    small[0] = False
    wanted = small[number]
    if within is not None:
        wanted |= unknown & within & (depth <= limit)
    return spanned(model, wanted)


def depths(model: HeightModel) -> Array:
    """(rows, columns) how far each cell lies from the nearest one with a height [cells]."""
    return np.asarray(distance_transform_edt(~model.known))


def spanned(model: HeightModel, wanted: Mask) -> HeightModel:
    """The same with cells filled: unknown ones, or others whose heights are to be replaced.

    Cells that no known one can be reached from stay unknown.
    """
    if not wanted.any():
        return model
    h = model.heights
    known = model.known & ~wanted
    number, _ = parts_of(wanted)
    if not known.any():
        return model
    found = distance_transform_edt(~known, return_indices=True)
    depth, (row, column) = cast("tuple[Array, Array]", found)
    height = np.where(known, h.height, np.nan).astype(float)
    opened = _open(number, known)
    upper, step = _steps(height, number, np.where(known, h.local, np.nan))
    spanned_from = np.where(upper, np.nan, height)
    _span(spanned_from, wanted, number, _planes(spanned_from, number, opened))
    height = np.where(wanted, spanned_from, height)
    wanted = wanted & np.isfinite(height)
    number = np.where(wanted, number, 0)
    power, strength = _variogram(height, np.where(known, h.local, np.nan))
    deepest = np.where(opened[number], np.inf, _largest(number, depth)[number])
    gap = 2 * strength * depth**power * (1 - depth / np.maximum(2 * deepest, 1)) ** power
    gap += step[number] ** 2 / 12
    sigma = np.where(wanted, np.sqrt(np.maximum(gap, 0.0)), 0.0)
    near = {k: np.where(wanted, getattr(h, k)[row, column], getattr(h, k)) for k in NEAREST}
    heights = Heights(height=height.astype(np.float32), points=np.where(wanted, 0, h.points).astype(np.uint16), **near)
    before = model.holes
    if before is not None:
        sigma = np.hypot(sigma, np.where(wanted, 0.0, before.sigma))
        number = np.where((number == 0) & before.filled, before.number + number.max(), number)
    holes = Holes(number=number, sigma=sigma.astype(np.float32))
    if model.factors is not None and model.levels is None:
        model = replace(model, factors=np.where(wanted[..., None], model.factors[row, column], model.factors))
    return replace(model.as_heights(heights, wanted), holes=holes)


NEAREST = ("local", "step", "orientation", "point", "image")
"""What a filled cell has from the nearest known one"""


def parts_of(mask: Mask) -> tuple[Index, int]:
    """The number (rows, columns) of the connected part that a cell is of, 0 outside, and how many there are."""
    return cast("tuple[Index, int]", label(mask, EIGHT))


def _steps(height: Array, number: Index, local: Array) -> tuple[Mask, Array]:
    """Cells (rows, columns) of rims that stand above a step, and its height (holes + 1,), 0 where there is none.

    Two levels are those of least variance within (Otsu 1979).

    local  standard deviations (rows, columns) of what is known
    """
    upper, step = np.zeros(height.shape, bool), np.zeros(int(number.max()) + 1)
    noise = float(np.nanmedian(local)) if np.isfinite(local).any() else 0.0
    for k, box in enumerate(find_objects(number), 1):
        if box is None:
            continue
        around = tuple(slice(max(b.start - 1, 0), b.stop + 1) for b in box)
        hole, z = number[around] == k, height[around]
        rim = cast("Mask", binary_dilation(hole, EIGHT)) & ~hole & np.isfinite(z)
        values = np.sort(z[rim])
        n = len(values)
        if n < LEAST_RIM or not values[-1] - values[0] > TWO_LEVELS * noise:
            continue
        side = max(1, int(np.ceil(LEAST_SIDE * n)))
        of = np.arange(side, n - side + 1)
        below, squares = np.cumsum(values), np.cumsum((values - values[0]) ** 2)
        mean = below[of - 1] / of, (below[-1] - below[of - 1]) / (n - of)
        best = int(np.argmax(of * (n - of) * (mean[1] - mean[0]) ** 2))
        apart, low = float(mean[1][best] - mean[0][best]), int(of[best])
        total = squares[-1] - n * (below[-1] / n - values[0]) ** 2
        within = max(total - low * (n - low) / n * apart**2, 0.0) / n
        if apart > TWO_LEVELS * max(float(np.sqrt(within)), noise):
            step[k] = apart
            upper[around] |= rim & (z >= values[low])
    return upper, step


def _open(number: Index, known: Mask) -> Array:
    """(holes + 1,) whether a hole goes on, into what is not known or beyond the grid: it is spanned from one side."""
    found = np.zeros(int(number.max()) + 1, bool)
    around = np.pad((number == 0) & ~known, 1, constant_values=True)
    beside = cast("Mask", binary_dilation(around, EIGHT))[1:-1, 1:-1]
    found[np.unique(number[beside])] = True
    found[0] = False
    return found


def _planes(height: Array, number: Index, opened: Array) -> Array:
    """(holes + 1, 3) of holes that are open the plane through what is known around: height at cell (0, 0), slopes.

    A membrane that is held on one side alone would be level; the variogram does not know of tilts.
    """
    found = np.zeros((len(opened), 3))
    reach = int(AROUND)
    for k, box in enumerate(find_objects(number), 1):
        if box is None or not opened[k]:
            continue
        rows, columns = (slice(max(b.start - reach, 0), b.stop + reach) for b in box)
        near = cast("Array", distance_transform_edt(number[rows, columns] != k)) <= reach
        z = height[rows, columns]
        r, c = np.nonzero(near & np.isfinite(z))
        A = np.stack([np.ones(len(r)), r - r.mean(), c - c.mean()], axis=1)
        if len(r) < 3 or np.linalg.matrix_rank(A) < 3:
            continue
        level, down, right = np.linalg.lstsq(A, z[r, c], rcond=None)[0]
        corner = level - down * (rows.start + r.mean()) - right * (columns.start + c.mean())
        found[k] = corner, down, right
    return found


def _largest(number: Index, values: Array) -> Array:
    """(holes + 1,) the largest value of each."""
    found = np.zeros(int(number.max()) + 1)
    np.maximum.at(found, number.ravel(), values.ravel())
    return found


def _span(height: Array, wanted: Mask, number: Index, planes: Array) -> None:
    """Fill heights in place: each is the mean of its known or wanted neighbours above, below, left and right.

    number, planes  the hole that a cell is of, and the plane above which its heights are meant
    """
    # by sides alone: what touches a height at a corner only is the mean of none
    reachable = cast("tuple[Index, int]", label(wanted | np.isfinite(height)))[0]
    touched = np.unique(reachable[np.isfinite(height)])
    wanted = wanted & np.isin(reachable, touched)
    at = np.flatnonzero(wanted.ravel())
    if not len(at):
        return
    rows, columns = height.shape
    order = np.full(height.size, -1)
    order[at] = np.arange(len(at))
    r, c = np.divmod(at, columns)
    count, right, plane = np.zeros(len(at)), np.zeros(len(at)), planes[number.flat[at]]
    entries = list[tuple[Array, Array]]()
    for dr, dc in ((-1, 0), (1, 0), (0, -1), (0, 1)):
        inside = (r + dr >= 0) & (r + dr < rows) & (c + dc >= 0) & (c + dc < columns)
        to = np.where(inside, (r + dr) * columns + c + dc, 0)
        value, inner = height.flat[to], order[to]
        there = inside & np.isfinite(value) & (inner < 0)
        among = inside & (inner >= 0)
        count += there | among
        base = plane[:, 0] + plane[:, 1] * (r + dr) + plane[:, 2] * (c + dc)
        right += np.where(there, np.nan_to_num(value) - base, 0.0)
        entries.append((np.flatnonzero(among), inner[among]))
    i = np.concatenate([np.arange(len(at)), *(e[0] for e in entries)])
    j = np.concatenate([np.arange(len(at)), *(e[1] for e in entries)])
    values = np.concatenate([count, -np.ones(len(i) - len(at))])
    matrix = csr_array((values, (i, j)), shape=(len(at), len(at)))
    height.flat[at] = spsolve(matrix.tocsc(), right) + plane[:, 0] + plane[:, 1] * r + plane[:, 2] * c


def _variogram(height: Array, local: Array) -> tuple[float, Array]:
    """Power, and the strength (rows, columns) of the surroundings of each cell [square of the unit / cell^power]."""
    noise = float(np.nanmedian(local)) ** 2
    means, squares = list[float](), list[Array]()
    for lag in LAGS:
        parts = [np.full(height.shape, np.nan) for _ in range(2)]
        if height.shape[1] > 2 * lag:
            parts[0][:, lag:-lag] = height[:, 2 * lag :] + height[:, : -2 * lag] - 2 * height[:, lag:-lag]
        if height.shape[0] > 2 * lag:
            parts[1][lag:-lag] = height[2 * lag :] + height[: -2 * lag] - 2 * height[lag:-lag]
        both = np.stack(parts) ** 2
        there = np.isfinite(both)
        total, n = np.where(there, both, 0.0).sum(axis=0), there.sum(axis=0).astype(float)
        means.append(max(float(total.sum() / max(n.sum(), 1)) - 6 * noise, 0.05 * noise))
        if not squares:
            squares = [gaussian_filter(total, AROUND), gaussian_filter(n, AROUND)]
    if not min(means) > 0:
        return 1.0, np.zeros(height.shape)
    power = float(np.clip(np.log(means[1] / means[0]) / np.log(LAGS[1] / LAGS[0]), LEAST_POWER, MOST_POWER))
    mean = np.where(squares[1] > 1e-3, squares[0] / np.maximum(squares[1], 1e-3), means[0] + 6 * noise)
    lag = LAGS[0]
    # of what is left where noise was more than expected, a tenth of the whole is the least
    return power, np.maximum(mean - 6 * noise, 0.1 * means[0]) / (8 * lag**power - 2 * (2 * lag) ** power)
