"""How small a movement could have been and still be found: of squares of some sizes, by the test that looks for them.

A square that has moved by an amount raises the means of the windows over it: by the sum of the amount over the standard
deviations of the cells that both have, each limited as the test limits single differences, less what the estimate of
the errors of orientation takes of it for its own.  It is found where the largest of these means lies beyond the limit;
with a chance of 80 % the mean is to be 0.84 of its standard deviations above that, and with one a little larger, since
other windows over it have a chance of their own.  Squares lie anywhere on the surface, and not where a window happens
to be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from scipy.special import ndtr, ndtri

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.nodes import splat

FOUND = 0.8
"""Chance with which a movement of the smallest amount is found."""
ROUND = (1.0, 2.0, 5.0)
"""Sides of squares, times powers of ten"""
FEWEST_CELLS, MOST_CELLS = 3, 129
"""Along the side of a square"""
PLACES, CELLS, SEED = (48, 128), 1 << 17, 1
"""Squares of one size that are looked at: fewest and most, cells of all; what they are drawn by"""
ALIKE = 2.5
"""How much larger or smaller than a square its windows are at most."""
MAPPED, FEWEST_SQUARES, MOST_SQUARES, HALVINGS = 1 << 18, 64, 600, 7
"""Of a map: cells of all squares of a size, fewest and most squares, halvings of the range of amounts: to 6 %"""
LEAST, TRIED = 1e-3, 18
"""Of the largest amount that can matter, the smallest that is tried; how many are, each by the same factor larger"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Windows:
    """Windows of one size that were looked at."""

    side: int
    """cells"""
    rows: Array
    """of their upper left cells"""
    columns: Array
    mean: Array
    """(rows, columns) sums of normalised differences over their standard deviations; NaN where too few are known"""
    spread: Array
    """(rows, columns) standard deviations of these sums"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SmallestMovement:
    """What of a square would have been found."""

    side: float
    """of the square, in the unit of the heights"""
    amount: float
    """in the median over the surface, found with a chance of 80 % at least; NaN: not known, since single differences
    count no more than some of their standard deviations, and what windows of other sizes find is not computed"""
    best: float
    """that of a quarter of the surface, where it is known best"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DetectionMap:
    """What of a square would have been found at each place."""

    side: float
    """of the square, in the unit of the heights"""
    amount: Array
    """(rows, columns) of a square with its middle there, found with a chance of 80 %; infinite: not known, as of
    `SmallestMovement`; NaN: less than half of the square can be tested, or the cell has no height"""


@dataclass(frozen=True, slots=True, kw_only=True)
class OrientationFit:
    """How the errors of orientation were estimated."""

    covariance: Array
    """(q, q)"""
    alike: float
    """cells that count once"""
    huber: float
    """standard deviations beyond which a difference counts less"""


def smallest_movements(
    model: HeightModel, most: Array, windows: Sequence[Windows], limit: float, fit: OrientationFit
) -> tuple[SmallestMovement, ...]:
    """Of squares of some round sides, the smallest first.

    most     (rows, columns) standard deviations that a single difference counts at most; 0: it is not tested
    windows  of all sizes
    limit    of the absolute value of their means
    """
    rng = np.random.default_rng(SEED)
    found = list[SmallestMovement]()
    for side in _sides(model):
        places = _places(most > 0, side, rng)
        squares = [q for r, c in places if len((q := _square(model, most, windows, fit, (r, c, side))).spread)]
        if squares:
            wanted = limit + float(ndtri(FOUND))
            half, quarter = _amounts(squares, (0.5, 0.25), wanted, fit.huber).tolist()
            found.append(SmallestMovement(side=side * model.cell, amount=half, best=quarter))
    return tuple(found)


def detection_maps(
    model: HeightModel, most: Array, windows: Sequence[Windows], limit: float, fit: OrientationFit
) -> tuple[DetectionMap, ...]:
    """Of squares of the sides of `smallest_movements`, with the same arguments; between squares linear."""
    wanted, known, found = limit + float(ndtri(FOUND)), most > 0, list[DetectionMap]()
    for side in _sides(model):
        count = int(np.clip(MAPPED // side**2, FEWEST_SQUARES, MOST_SQUARES))
        free = [n - side + 1 for n in model.shape]
        step = max(1.0, np.sqrt(free[0] * free[1] / count))
        rows, columns = (np.unique(np.linspace(0, n - 1, max(2, round(n / step))).astype(int)) for n in free)
        total = cv2.integral(known.astype(np.uint8))
        amount = np.full((len(rows), len(columns)), np.nan)
        for i, r in enumerate(rows.tolist()):
            for j, c in enumerate(columns.tolist()):
                n = total[r + side, c + side] - total[r, c + side] - total[r + side, c] + total[r, c]
                if n >= side**2 / 2 and len((q := _square(model, most, windows, fit, (r, c, side))).spread):
                    amount[i, j] = _least(q, wanted, fit.huber)
        # steps between numbers and none are no slopes: there the nearest counts
        at = [(np.arange(n) + 0.5 - side / 2) for n in model.shape]
        whole = _interpolated(
            amount, [np.interp(a, k, np.arange(len(k))) for a, k in zip(at, (rows, columns), strict=True)]
        )
        found.append(DetectionMap(side=side * model.cell, amount=np.where(known, whole, np.nan)))
    return tuple(found)


def _interpolated(values: Array, at: Sequence[Array]) -> Array:
    """(rows, columns) linear at places along both axes; beside what is not finite the nearest."""
    x, y = (a.astype(np.float32) for a in np.meshgrid(at[1], at[0]))
    # how a square lies to the windows, which differs from one to the next, is no matter of its place
    finite = np.isfinite(values)
    mean, n = (
        cv2.blur(v, (3, 3), borderType=cv2.BORDER_REPLICATE) for v in (np.where(finite, values, 0.0), finite * 1.0)
    )
    values = np.where(finite, mean / np.maximum(n, 1e-9), values)
    linear = cv2.remap(np.where(np.isfinite(values), values, 0.0), x, y, cv2.INTER_LINEAR)
    share = cv2.remap(np.isfinite(values).astype(float), x, y, cv2.INTER_LINEAR)
    nearest = values[np.round(y).astype(int), np.round(x).astype(int)]
    return np.where(share > 1 - 1e-6, linear, nearest)


def _least(q: _Square, wanted: float, huber: float) -> float:
    """The amount at which the mean of a window is what is wanted; infinite: not known."""
    high = 2 * float(q.most.max()) * q.usual
    if q.best(high, huber) < wanted:
        return float("inf")
    low = LEAST * high
    for _ in range(HALVINGS):
        middle = float(np.sqrt(low * high))
        low, high = (low, middle) if q.best(middle, huber) >= wanted else (middle, high)
    return high


def _sides(model: HeightModel) -> list[int]:
    """Cells along the sides of squares whose sides are round, or nearly so."""
    most = min(MOST_CELLS, min(model.shape) // 2)
    low = int(np.floor(np.log10(model.cell)))
    sides = {round(k * 10.0**p / model.cell) for p in range(low, low + 5) for k in ROUND}
    return sorted(n for n in sides if FEWEST_CELLS <= n <= most)


def _places(known: Mask, side: int, rng: np.random.Generator) -> list[tuple[int, int]]:
    """Upper left cells of squares of which nearly all cells are tested, or else of those of which most are."""
    total = cv2.integral(known.astype(np.uint8))
    count = total[side:, side:] - total[:-side, side:] - total[side:, :-side] + total[:-side, :-side]
    for share in (0.9, 0.5):
        good = np.flatnonzero(count >= share * side**2)
        if len(good):
            count_of = int(np.clip(CELLS // side**2, *PLACES))
            chosen = good if len(good) <= count_of else rng.choice(good, count_of, replace=False)
            return [(int(k) // count.shape[1], int(k) % count.shape[1]) for k in chosen]
    return []


@dataclass(frozen=True, slots=True, kw_only=True)
class _Square:
    """One place that may have moved."""

    inverse: Array
    """(side, side) 1 / standard deviation; 0: not tested"""
    most: Array
    """(side, side)"""
    boxes: Array
    """(n, 4) upper and lower row, left and right column that windows have of it"""
    spread: Array
    """(n,) of these"""
    pull: float
    """sum of normalised differences that the errors of orientation would take, were no difference limited, by amount"""
    usual: float
    """standard deviation of a cell, in the median"""

    def best(self, amount: float, huber: float) -> float:
        """The largest mean of a window over its standard deviation, to be expected."""
        sums = cv2.integral(_limited(amount * self.inverse, self.most))
        top, bottom, left, right = self.boxes.T
        own = sums[bottom, right] - sums[top, right] - sums[bottom, left] + sums[top, left]
        share = (bottom - top) * (right - left) / self.inverse.size
        taken = self.pull * amount * min(1.0, huber * self.usual / max(amount, 1e-300))
        return float(((own - taken * share) / self.spread).max())


def _square(
    model: HeightModel, most: Array, windows: Sequence[Windows], fit: OrientationFit, at: tuple[int, int, int]
) -> _Square:
    """That at a row and column, of so many cells along its side."""
    r, c, side = at
    box = slice(r, r + side), slice(c, c + side)
    s = np.where(most[box] > 0, model.local[box], np.inf).astype(float)
    boxes, spreads = list[Array](), list[Array]()
    for w in windows:
        if not side / ALIKE <= w.side <= ALIKE * side:
            continue
        i, j = (np.flatnonzero((k > low - w.side) & (k < low + side)) for k, low in ((w.rows, r), (w.columns, c)))
        spread = w.spread[np.ix_(i, j)]
        good = np.isfinite(w.mean[np.ix_(i, j)]) & (spread > 0)
        (top, bottom), (left, right) = (
            (np.clip(k - low, 0, side), np.clip(k + w.side - low, 0, side))
            for k, low in ((w.rows[i], r), (w.columns[j], c))
        )
        each = np.broadcast_arrays(top[:, None], bottom[:, None], left, right)
        boxes.append(np.stack(each, axis=-1)[good])
        spreads.append(spread[good])
    return _Square(
        inverse=1 / s, most=most[box], boxes=np.concatenate([*boxes, np.zeros((0, 4), int)]).astype(int),
        spread=np.concatenate([*spreads, np.zeros(0)]), pull=_pull(model, 1 / s, fit, at),
        usual=float(np.median(s[np.isfinite(s)])),
    )  # fmt: skip


def _pull(model: HeightModel, inverse: Array, fit: OrientationFit, at: tuple[int, int, int]) -> float:
    """By how much errors of orientation that are estimated with a square take off its normalised differences."""
    if not len(fit.covariance):
        return 0.0
    r, c, side = at
    k = model.block
    (r0, r1), (c0, c1) = ((low // k, -(-(low + side) // k)) for low in (r, c))
    cells = slice(r0 * k, r1 * k), slice(c0 * k, c1 * k)
    nodes = model.moved[r0 : r1 + 1, c0 : c1 + 1]
    factors = None if model.factors is None else model.factors[cells]
    values = np.zeros(tuple(len(range(*s.indices(n))) for s, n in zip(cells, model.shape, strict=True)))
    moves = list[Array]()
    for power in (1, 2):
        values[r - r0 * k : r - r0 * k + side, c - c0 * k : c - c0 * k + side] = inverse**power
        shares = splat(values, nodes, k, factors)
        moves.append(np.einsum("rck,rckq->q", shares, nodes.astype(float), optimize=True))
    return float(moves[0] @ fit.covariance @ moves[1]) / fit.alike


def _limited(by: Array, most: Array) -> Array:
    """What is to be expected of normally distributed differences of variance 1 about some value, each limited."""
    low, high = -most - by, most - by
    density = (np.exp(-(low**2) / 2) - np.exp(-(high**2) / 2)) / np.sqrt(2 * np.pi)
    return most * (ndtr(-high) - ndtr(low)) + by * (ndtr(high) - ndtr(low)) + density


def _amounts(squares: Sequence[_Square], shares: Sequence[float], wanted: float, huber: float) -> Array:
    """At which such shares of the squares have a mean of a window of so many of its standard deviations."""
    largest = (
        2 * max(float(q.most.max()) for q in squares) * float(np.quantile([q.usual for q in squares], max(shares)))
    )
    tried = largest * np.geomspace(LEAST, 1, TRIED)
    means = np.array([[q.best(a, huber) for q in squares] for a in tried.tolist()])
    return np.array([_reached(tried, np.quantile(means, 1 - share, axis=1), wanted) for share in shares])


def _reached(tried: Array, means: Array, wanted: float) -> float:
    """At which amount means reach what is wanted, linear between those that were tried; NaN: at none."""
    means = np.maximum.accumulate(np.concatenate([[0.0], means]))
    k = int(np.searchsorted(means, wanted))
    if k == len(means):
        return float("nan")
    before, after = (0.0 if k == 1 else float(tried[k - 2])), float(tried[k - 1])
    return before + (after - before) * float((wanted - means[k - 1]) / (means[k] - means[k - 1]))
