"""Heights on a grid as a whole, with what is needed for a true standard deviation of anything that is made of many.

A mean, a volume, the height of a profile are sums of heights with weights.  Their errors by noise and roughness
are correlated between cells nearby, those by orientation and calibration between all.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights import BETWEEN_MAPS, Heights, between

REACH = 3.0
"""Lengths of correlation up to which cells are taken as correlated: 1 / 8000 is left beyond."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SumOfHeights:
    """A sum of heights with weights."""

    value: float
    local: float
    """standard deviation by noise and roughness"""
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
class HeightModel:
    """Heights, their standard deviations, and how they are correlated.

    What it does not tell: what between the points was not measured; an error that all photographs share.
    """

    heights: Heights
    moved: Array
    """(block rows, block columns, q) how heights move with each of q independent errors of variance 1"""
    block: int
    """cells along the side of a block"""
    cell: float
    """side of a cell, in the unit of the heights"""
    length: float
    """distance in cells at which errors of two points by noise and roughness correlate by 1 / e"""

    @property
    def known(self) -> Mask:
        """Cells with a height."""
        return np.isfinite(self.heights.height)

    def sum_of(self, weights: Array) -> SumOfHeights:
        """The sum of heights times weights (rows, columns).

        raises  InputError where a weight stands at a cell without a height
        """
        h = self.heights
        used = weights != 0
        if (used & ~self.known).any():
            count = int((used & ~self.known).sum())
            raise InputError(f"{count} of {int(used.sum())} cells have no height; leave them out, or fill them")
        value = float((weights[used] * h.height[used].astype(float)).sum())
        return SumOfHeights(value=value, local=np.sqrt(self._local(weights, used)), moved=self._moved(weights))

    def _local(self, weights: Array, used: Mask) -> float:
        """Variance of a sum by noise and roughness."""
        h = self.heights
        own = float(((weights[used] * h.local[used].astype(float)) ** 2).sum())
        s = np.where(used, weights * np.nan_to_num(h.point.astype(float)), 0.0)
        every = BETWEEN_MAPS * self._with_neighbours(s)
        for image in np.unique(h.image[used]):
            part = np.where(h.image == image, s, 0.0)
            rows, columns = (np.flatnonzero(part.any(axis=axis)) for axis in (1, 0))
            if len(rows):
                window = part[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
                every += (1 - BETWEEN_MAPS) * self._with_neighbours(window)
        return own + every

    def _with_neighbours(self, s: Array) -> float:
        """The sum over all pairs of different cells of s_i s_j times their correlation."""
        n = int(np.ceil(REACH * self.length)) + 1
        steps = np.arange(-n, n + 1.0)
        kernel = between(steps, np.zeros(1), self.length) / np.sqrt(between(np.zeros(1), np.zeros(1), self.length))
        around = cv2.sepFilter2D(
            np.ascontiguousarray(s, np.float64), cv2.CV_64F, kernel, kernel, borderType=cv2.BORDER_CONSTANT
        )
        return float((s * around).sum() - kernel[n] ** 2 * (s**2).sum())

    def _moved(self, weights: Array) -> Array:
        """How a sum moves with each independent error of orientation."""
        rows, columns = self.moved.shape[:2]
        whole = np.zeros((rows * self.block, columns * self.block))
        whole[: weights.shape[0], : weights.shape[1]] = weights
        of_block = whole.reshape(rows, self.block, columns, self.block).sum(axis=(1, 3))
        return np.einsum("rc,rcq->q", of_block, self.moved, optimize=True)
