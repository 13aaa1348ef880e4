"""Matching of two images whose geometry is known: a feature is looked for along the image of its viewing ray."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from raybundle.matching.descriptors import mutual_matches
from raybundle.numerics.arrays import Array, Index, Mask

if TYPE_CHECKING:
    from scipy.spatial import KDTree

CHUNK = 512
RATIO = 0.85
"""Distance to the nearest descriptor over that to the second, within the strip, at most (Lowe 2004)."""
FARTHEST = 0.8
APART_PX = 4.0
"""Features nearer to each other than that are one place: they do not contest each other."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Strips:
    """Where the features of one image may lie in another: segments, and how far from them."""

    start: Array
    """(n, 2) [px] at the lowest height; NaN where a feature cannot be in the other image"""
    end: Array
    """(n, 2) at the highest"""
    tolerance_px: float

    def pairs(self, rows: Index, tree: KDTree, xy_px: Array) -> tuple[Index, Index]:
        """Rows (k,) and points (k,) that lie in their strips, in the order of the rows; tree: of the points (m, 2)."""
        known = rows[np.isfinite(self.start[rows]).all(axis=1) & np.isfinite(self.end[rows]).all(axis=1)]
        a, b, t = self.start[known], self.end[known], self.tolerance_px
        length = np.maximum(np.linalg.norm(b - a, axis=1), 1e-9)
        found = tree.query_ball_point((a + b) / 2, np.hypot(length / 2 + t, t))
        each = np.fromiter(map(len, found), np.int64, len(found))
        point = np.fromiter(chain.from_iterable(found), np.int64, int(each.sum()))
        k = np.repeat(np.arange(len(known)), each)
        u = ((b - a) / length[:, None])[k]
        apart = xy_px[point] - a[k]
        s = (apart * u).sum(axis=1)
        across = apart[:, 1] * u[:, 0] - apart[:, 0] * u[:, 1]
        inside = (np.abs(across) <= t) & (s >= -t) & (s <= length[k] + t)
        return known[k[inside]], point[inside]


def match_strips(first: Array, second: Array, xy1: Array, xy2: Array, there: Strips, back: Strips) -> Index:
    """Matches (k, 2): each other's nearest in description among those in each other's strip, and clearly so.

    first, second  (n, d), (m, d) unit vectors of the features at xy1 (n, 2), xy2 (m, 2)
    there, back    strips of the first image's features in the second, and of the second's in the first
    """
    forward = _nearest(first, second, xy2, there)
    backward = _nearest(second, first, xy1, back)
    rows = np.flatnonzero(forward >= 0)
    rows = rows[backward[forward[rows]] == rows]
    return np.column_stack([rows, forward[rows]]).astype(np.int32)


def _nearest(a: Array, b: Array, xy: Array, strips: Strips) -> Index:
    """(n,) position in b of the nearest within the strip, -1 where there is none or another is as near."""
    from scipy.spatial import KDTree

    found = np.full(len(a), -1)
    if not len(b):
        return found
    tree = KDTree(xy)
    for begin in range(0, len(a), CHUNK):
        row, point = strips.pairs(np.arange(begin, min(begin + CHUNK, len(a))), tree, xy)
        if not len(row):
            continue
        likeness = np.einsum("ki,ki->k", a[row], b[point])
        first = np.flatnonzero(np.diff(row, prepend=-1))
        best = _largest(likeness, first)
        group = np.repeat(np.arange(len(first)), np.diff(np.append(first, len(row))))
        near = np.abs(xy[point] - xy[point[best]][group]).max(axis=1) < APART_PX
        second = np.maximum.reduceat(np.where(near, -2.0, likeness), first)
        d1, d2 = (np.sqrt(np.maximum(2 - 2 * v, 0)) for v in (likeness[best], second))
        good = (d1 < FARTHEST) & ((second < -1) | (d1 < RATIO * d2))
        found[row[best[good]]] = point[best[good]]
    return found


def _largest(values: Array, first: Index) -> Index:
    """Position of the largest value of every group; `first` the groups' beginnings."""
    group = np.repeat(np.arange(len(first)), np.diff(np.append(first, len(values))))
    order = np.lexsort((-values, group))
    return order[first]


@dataclass(frozen=True, slots=True, kw_only=True)
class Agreement:
    """The value on which most of a set of numbers agree."""

    value: float
    scatter: float
    """Robust standard deviation of those that agree"""
    inside: Mask


def agreement(values: Array, width: float) -> Agreement:
    """The densest place of some numbers, the median there, and which of them lie within `width` of it.

    width  half the width of the place; what scatters more does not agree
    """
    good = np.isfinite(values)
    order = np.sort(values[good])
    if not len(order):
        return Agreement(value=np.nan, scatter=np.nan, inside=good)
    last = np.searchsorted(order, order + 2 * width, side="right")
    k = int(np.argmax(last - np.arange(len(order))))
    value = float(np.median(order[k : last[k]]))
    inside = good & (np.abs(values - value) <= width)
    for _ in range(5):
        value = float(np.median(values[inside]))
        inside = good & (np.abs(values - value) <= width)
    scatter = 1.4826 * float(np.median(np.abs(values[inside] - value)))
    return Agreement(value=value, scatter=scatter, inside=inside)


def by_appearance(first: Array, second: Array) -> Index:
    """Matches (k, 2) by description alone, wherever they lie."""
    return mutual_matches(first, second)[0]
