"""Heights on a grid as a whole, with what is needed for a true standard deviation of anything that is made of many.

A mean, a volume, the height of a profile are sums of heights with weights.  Their errors by noise and roughness
are correlated between cells nearby, those by steps along their edges, those of a hole that was filled over all of it,
and those by orientation and calibration between all.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.heights.cell_factors import factors_of
from raybundle.surfaces.heights.grids import filtered
from raybundle.surfaces.heights.heights import BETWEEN_MAPS, Heights, between
from raybundle.surfaces.heights.nodes import covariances, splat
from raybundle.surfaces.heights.steps import AROUND_EDGE, alike, along_edges, variance_by_steps, variance_of_alike

REACH = 3.0
"""Lengths of correlation up to which cells are taken as correlated: 1 / 8000 is left beyond."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SumOfHeights:
    """A sum of heights with weights."""

    value: float
    local: float
    """standard deviation by noise, roughness, steps and filled holes"""
    moved: Array
    """(q,) how it moves with each of the independent errors of orientation and calibration"""

    @property
    def orientation(self) -> float:
        """Standard deviation by orientation and calibration."""
        return float(np.linalg.norm(self.moved))

    @property
    def sigma(self) -> float:
        """Standard deviation, all parts."""
        return float(np.hypot(self.local, self.orientation))


@dataclass(frozen=True, slots=True, kw_only=True)
class Holes:
    """Cells whose heights were interpolated."""

    number: Index
    """(rows, columns) of the hole that a cell is of; 0: it was measured"""
    sigma: Array
    """(rows, columns) standard deviation by what the surface does between its neighbours"""

    @property
    def filled(self) -> Mask:
        """Which cells were."""
        return self.number > 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Blocks:
    """Errors of heights that blocks of compression give to all of a place alike (`lattice`)."""

    sigma: Array
    """(rows, columns) standard deviations; 0 where there is no height"""
    reach: float
    """distance in cells at which they correlate by 1 / e"""

    def variance_of(self, weights: Array) -> float:
        """Variance of a sum of heights with weights (rows, columns)."""
        return variance_of_alike(weights * self.sigma, self.reach)


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightModel:
    """Heights, their standard deviations, and how they are correlated.

    Limits: what between the points was not measured; an error that all photographs share.
    """

    heights: Heights
    moved: Array
    """(node rows, node columns, K, q) how heights move with each of q independent errors of variance 1: parts at the
    corners of blocks of cells, linear between them (`nodes`)"""
    block: int
    """cells along the side of a block"""
    cell: float
    """side of a cell, in the unit of the heights"""
    length: float
    """distance in cells at which errors of two points by noise and roughness correlate by 1 / e"""
    apart: float = BETWEEN_MAPS
    """their correlation at one place where they are of two maps"""
    holes: Holes | None = None
    """None: all heights were measured"""
    errors: str = ""
    """what the independent errors are known by: heights of another surface that names the same move by the same"""
    adjustment: str = ""
    """what the adjustment is known by that they are of"""
    factors: Array | None = None
    """(rows, columns, K) how often each part counts in a height (`cell_factors`); None: there is one, and it counts
    once"""
    levels: Array | None = None
    """(node rows, node columns) from where these count heights; None: they are not of one surface"""
    blocks: Blocks | None = None
    """None: photographs had no blocks that count"""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        rows, columns = self.heights.height.shape
        return rows, columns

    @property
    def known(self) -> Mask:
        """Cells with a height."""
        return np.isfinite(self.heights.height)

    @property
    def sigma(self) -> Array:
        """(rows, columns) standard deviations of single heights, all parts."""
        s = self.heights.sigma
        s = s if self.blocks is None else np.hypot(s, self.blocks.sigma)
        return s if self.holes is None else np.hypot(s, self.holes.sigma)

    @property
    def local(self) -> Array:
        """(rows, columns) standard deviations of single heights by all but orientation and calibration."""
        s = np.hypot(self.heights.local, self.heights.step)
        s = s if self.blocks is None else np.hypot(s, self.blocks.sigma)
        return s if self.holes is None else np.hypot(s, self.holes.sigma)

    def sum_of(self, weights: Array) -> SumOfHeights:
        """The sum of heights times weights (rows, columns).

        raises  InputError where a weight stands at a cell without a height
        """
        h = self.heights
        used = weights != 0
        if (used & ~self.known).any():
            count = int((used & ~self.known).sum())
            raise InputError("height_grid.void_cells", n=count, total=int(used.sum()))
        value = float((weights[used] * h.height[used].astype(float)).sum())
        return SumOfHeights(value=value, local=np.sqrt(self._local(weights, used)), moved=self._moved(weights))

    def _local(self, weights: Array, used: Mask) -> float:
        """Variance of a sum by all but orientation."""
        rows, columns = (np.flatnonzero(used.any(axis=axis)) for axis in (1, 0))
        if not len(rows):
            return 0.0
        box = slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)
        w, there, h = weights[box], used[box], self.heights
        image = h.image[box]
        own = float(((w[there] * h.local[box][there].astype(float)) ** 2).sum())
        s = np.where(there, w * np.nan_to_num(h.point[box].astype(float)), 0.0)
        found = own + self.apart * self._with_neighbours(s)
        for one in np.unique(image[there]):
            part = np.where(image == one, s, 0.0)
            r, c = (np.flatnonzero(part.any(axis=axis)) for axis in (1, 0))
            if len(r):
                found += (1 - self.apart) * self._with_neighbours(part[r[0] : r[-1] + 1, c[0] : c[-1] + 1])
        # differences of neighbours may all but cancel: rounding leaves no negative variance
        found = max(found, 0.0)
        step = np.where(there, w * h.step[box].astype(float), 0.0)
        if step.any():
            found += variance_by_steps(step, self.length, along_edges(h.height[box]))
        if self.blocks is not None:
            found += variance_of_alike(w * self.blocks.sigma[box], self.blocks.reach)
        if self.holes is None:
            return found
        number = self.holes.number[box]
        gap = np.where(there, w * self.holes.sigma[box], 0.0)
        return found + float((np.bincount(number.ravel(), gap.ravel())[1:] ** 2).sum())

    def _with_neighbours(self, s: Array) -> float:
        """The sum over all pairs of different cells of s_i s_j times their correlation."""
        n = int(np.ceil(REACH * self.length)) + 1
        steps = np.arange(-n, n + 1.0)
        kernel = between(steps, np.zeros(1), self.length) / np.sqrt(between(np.zeros(1), np.zeros(1), self.length))
        around = filtered(s, kernel)
        return float((s * around).sum() - kernel[n] ** 2 * (s**2).sum())

    def _moved(self, weights: Array) -> Array:
        """How a sum moves with each independent error of orientation."""
        return np.einsum("rck,rckq->q", splat(weights, self.moved, self.block, self.factors), self.moved, optimize=True)

    def as_heights(self, heights: Heights, new: Mask) -> HeightModel:
        """With other heights, of which some cells are new: these take their own factors, all others keep theirs."""
        if self.factors is None or self.levels is None:
            return replace(self, heights=heights)
        h = heights.height
        fresh = factors_of(h, heights.local, self.levels, self.block, self.cell)
        return replace(self, heights=heights, factors=np.where(new[..., None], fresh, self.factors))

    def covariance(self, one: Index, other: Index) -> Array:
        """Covariances (...) of the heights of pairs of cells, all parts; cells by their numbers, row by row."""
        columns = self.shape[1]
        (r, c), (r2, c2) = np.divmod(one, columns), np.divmod(other, columns)
        h, apart = self.heights, (r - r2, c - c2)
        same = h.image.flat[one] == h.image.flat[other]
        share = np.where(same, 1.0, self.apart) * between(apart[1], apart[0], self.length)
        found = share * h.point.flat[one].astype(float) * h.point.flat[other]
        found = np.where(one == other, h.local.flat[one].astype(float) ** 2, found)
        if h.step.any():
            near, far = (
                share * np.exp(-(apart[0] ** 2 + apart[1] ** 2) / distance**2) for share, distance in alike(self.length)
            )
            top, left = (max(int(min(a.min(), b.min())) - AROUND_EDGE, 0) for a, b in ((r, r2), (c, c2)))
            down, right = (int(max(a.max(), b.max())) + AROUND_EDGE + 1 for a, b in ((r, r2), (c, c2)))
            along = along_edges(h.height[top:down, left:right])
            common = (near + far) * along[r - top, c - left] * along[r2 - top, c2 - left]
            found += np.where(one == other, 1.0, common) * h.step.flat[one].astype(float) * h.step.flat[other]
        if self.blocks is not None:
            alike_there = np.exp(-(apart[0] ** 2 + apart[1] ** 2) / self.blocks.reach**2)
            found += alike_there * self.blocks.sigma.flat[one].astype(float) * self.blocks.sigma.flat[other]
        if self.holes is not None:
            number = self.holes.number
            both = number.flat[one] == number.flat[other]
            found += np.where(both, self.holes.sigma.flat[one] * self.holes.sigma.flat[other], 0.0)
        by_orientation = covariances(
            self.moved, self.block, (r.ravel(), c.ravel()), (r2.ravel(), c2.ravel()), self.factors
        )  # fmt: skip
        return found + by_orientation.reshape(found.shape)
