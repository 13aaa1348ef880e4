"""How errors of orientation move heights, at nodes, from how they move points of a surface.

What moves a block of photographs moves the object it shows: points shift in plan and up.  A height of a cell moves up
as the points do, and by the slope of the surface where these shift in plan.  An error of scale moves what stands out
further.  Around each node, in the four blocks that touch it, planes are fitted by least squares to all three shifts and
to the heights themselves; what the heights leave of their plane shows how shifts upwards grow with the height.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.heights.nodes import CORNERS, from_nearest

UNEVEN = 1e-3 / 12
"""Variance of places, in squares of a block's side, below which they show no slope: a thousandth of that of a whole
block, that of a line of cells a thirtieth of a side wide.  Heights that scatter by less about their plane show nothing
of a change with the height."""
PARTS = 4
"""Up, by the height above the level, and in plan to the right and upwards"""
UP, RIGHT, ABOVE = slice(0, 4), slice(4, 7), slice(7, 10)
"""Rows of `Moments.sums` of shifts up, to the right and upwards in plan"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Moments:
    """Means of products over the points of blocks (...): what planes and their slopes follow from.

    With a = (1, column, row, height): places in sides of a block from its middle, heights above `base`.
    """

    products: Array
    """(..., 4, 4) a a'"""
    sums: Array
    """(..., 10, q) a times shifts up; (1, column, row) times those in plan to the right; and upwards"""
    base: Array
    """(...) from where heights count; NaN where there are no points"""

    def moved(self, by: Array) -> Moments:
        """Of the same points, where column, row and height (..., 3) count by so much more."""
        S = np.zeros((*self.base.shape, 4, 4)) + np.eye(4)
        S[..., 1:, 0] = by
        T, y = S[..., :3, :3], self.sums
        sums = np.concatenate([S @ y[..., UP, :], T @ y[..., RIGHT, :], T @ y[..., ABOVE, :]], axis=-2)
        products = S @ self.products @ S.swapaxes(-1, -2)
        return Moments(products=products, sums=sums.astype(y.dtype), base=self.base - by[..., 2])

    def times(self, share: Array) -> Moments:
        """Weighted by shares (...)."""
        w = share[..., None, None]
        return replace(self, products=w * self.products, sums=(w * self.sums).astype(self.sums.dtype))

    def at_base(self, base: Array) -> Moments:
        """Heights counted from another base (...); where there is none, NaN, nothing is changed."""
        up = np.nan_to_num(self.base - base)
        return self.moved(np.stack([0 * up, 0 * up, up], axis=-1))

    def plus(self, other: Moments) -> Moments:
        """Of the points of both, from the base of this; where it has none, NaN, from that of the other."""
        base = np.where(np.isnan(self.base), other.base, self.base)
        o = other.at_base(base)
        return Moments(products=self.products + o.products, sums=self.sums + o.sums, base=base)

    def solved(self, side: float) -> tuple[Array, Array]:
        """The parts (..., 4, q) at the place from where columns and rows count, and the plane (..., 3) of the heights.

        side  of a block, in the unit of the heights

        The plane is its height there, and by how much it rises over a block to the right and down.
        """
        n = np.maximum(self.products[..., 0, 0], 1e-300)[..., None, None]
        N, y = self.products / n, self.sums / n
        A = N[..., :3, :3].copy()
        A[..., 0, 0] = 1.0
        for k in (1, 2):
            A[..., k, k] += UNEVEN
        level = np.linalg.solve(A, N[..., :3, 3:])
        inverse = np.linalg.inv(A)
        slopes = inverse @ y[..., :3, :]
        # heights less their plane, and shifts upwards less theirs
        r = np.concatenate([-level, np.ones((*level.shape[:-2], 1, 1))], axis=-2).swapaxes(-1, -2)
        spread = r @ N @ r.swapaxes(-1, -2) + UNEVEN * side**2
        by_height = ((r @ y[..., UP, :] - r @ N[..., :3] @ slopes) / spread)[..., 0, :]
        right, above = ((inverse[..., :1, :] @ y[..., rows, :])[..., 0, :] for rows in (RIGHT, ABOVE))
        plane = level[..., 0].copy()
        plane[..., 0] += self.base
        return np.stack([slopes[..., 0, :], by_height, right, above], axis=-2), plane

    def of_surface(self, side: float) -> Array:
        """(..., q) how heights of the plane move there: up, less what it rises to where points shift in plan."""
        parts, plane = self.solved(side)
        right, down = (plane[..., k, None] / side for k in (1, 2))
        return parts[..., 0, :] - right * parts[..., 2, :] + down * parts[..., 3, :]


def moments(column: Array, row: Array, height: Array, shifts: Iterable[Array], begin: Index) -> Moments:
    """Of blocks.

    column, row  (n,) from the middle of its block, in sides of it; a block's places one after the other
    height       (n,)
    shifts       three of (n, q): up, to the right, and upwards in plan
    begin        (blocks,) where each begins
    """
    count = np.diff(np.append(begin, len(column)))
    base = np.add.reduceat(height, begin) / count if len(begin) else np.zeros(0)
    A = np.stack([np.ones(len(column)), column, row, height - np.repeat(base, count)], axis=1)
    if not len(begin):
        q = next(iter(shifts)).shape[1]
        return Moments(products=np.zeros((0, 4, 4)), sums=np.zeros((0, 10, q), np.float32), base=base)
    A /= np.sqrt(np.repeat(count, count))[:, None]
    products = np.add.reduceat(A[:, :, None] * A[:, None, :], begin, axis=0)
    A /= np.sqrt(np.repeat(count, count))[:, None]
    each = [
        np.add.reduceat(A[:, k, None] * values, begin, axis=0)
        for values, columns in zip(shifts, (4, 3, 3), strict=True)
        for k in range(columns)
    ]
    return Moments(products=products, sums=np.stack(each, axis=1).astype(np.float32), base=base)


@dataclass(slots=True, kw_only=True)
class NodeSums:
    """Nodes by the points of blocks around them, tile by tile: each block counts by its cells with a height."""

    products: Array
    sums: Array
    base: Array = field(init=False)
    """of each node, that of the first block; NaN: none was added"""

    def __post_init__(self) -> None:
        """Nothing is known yet."""
        self.base = np.full(self.products.shape[:2], np.nan)

    @classmethod
    def of(cls, shape: tuple[int, int], block: int, q: int) -> NodeSums:
        """For a grid of so many rows and columns."""
        rows, columns = (-(-n // block) + 1 for n in shape)
        return cls(products=np.zeros((rows, columns, 4, 4)), sums=np.zeros((rows, columns, 10, q), np.float32))

    def add(self, first: tuple[int, int], found: Moments, known: Mask, block: int) -> None:
        """Blocks (rows, columns) of a tile, whose first one is given, and which of its cells have a height."""
        rows, columns = found.base.shape
        there = np.zeros((rows * block, columns * block))
        there[: known.shape[0], : known.shape[1]] = known
        n = there.reshape(rows, block, columns, block).sum(axis=(1, 3))
        each = found.times(n)
        some = each.products[..., 0, 0] > 0
        for y, x in CORNERS:
            mine = tuple(slice(f + k, f + k + m) for f, k, m in zip(first, (y, x), (rows, columns), strict=True))
            base = self.base[mine]
            base[:] = np.where(np.isnan(base) & some, found.base, base)
            up = np.where(some, found.base - base, 0.0)
            apart = np.stack([np.full(n.shape, 0.5 - x), np.full(n.shape, 0.5 - y), up], axis=-1)
            at_node = each.moved(apart)
            self.products[mine] += at_node.products
            self.sums[mine] += at_node.sums

    def solved(self, side: float) -> tuple[Array, Array]:
        """Parts of nodes (node rows, node columns, 4, q) float32 and their levels (node rows, node columns).

        side  of a block, in the unit of the heights

        Those that no height is near to are as the nearest other.
        """
        shape, q = self.base.shape, self.sums.shape[3]
        parts, level = np.zeros((*shape, PARTS, q), np.float32), np.zeros(shape)
        known = np.isfinite(self.base)
        for row in np.flatnonzero(known.any(axis=1)).tolist():
            at = known[row]
            m = Moments(products=self.products[row, at], sums=self.sums[row, at], base=self.base[row, at])
            parts[row, at], plane = m.solved(side)
            level[row, at] = plane[:, 0]
        if not known.any() or known.all():
            return parts, level
        return from_nearest(parts, known), from_nearest(level, known)
