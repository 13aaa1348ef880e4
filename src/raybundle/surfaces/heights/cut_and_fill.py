"""Cut and fill: sums over cells by the sign of their change.

The sign by a cell itself would make both too large by 0.4 of its standard deviation wherever nothing changed.  It is
that of the mean around the cell, without those whose noise it shares, unless the change of the cell alone is beyond
doubt.  Neither is negative: where chance makes one so, it is 0 and the other the net change.

Signs that noise decides make both less precise: the error of a cell is in the signs of its m surroundings, and theirs
in its own, each with the weight phi(0) / sqrt(m) in its standard deviation.  The products add phi(0)^2 of a cell's
variance, beside the half of it that a sum over the half of all cells has: a share of 1 / pi.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.height_model import SumOfHeights

APART, AROUND = 2.0, 4
"""Lengths of correlation within which cells share noise, and cells beyond that whose mean shows a sign"""
CERTAIN = 4.0
"""Standard deviations from which a cell shows its sign: chance leaves 1 of 16 000 beyond"""
DOUBTFUL = 3.0
"""Standard deviations of the mean around a cell below which noise may have decided its sign: 99.7 % by chance"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Signs:
    """Which cells rose; the others fell."""

    risen: Mask
    certain: Array
    """change of each cell in its standard deviations"""
    doubtful: Mask
    """whose sign noise may have decided"""

    @classmethod
    def of(cls, difference: Array, sigma: Array, length: float) -> Signs:
        """By differences, NaN where there is none.

        length  distance in cells at which errors correlate by 1 / e
        """
        finite = np.isfinite(difference)
        known, d = finite & (sigma > 0), np.where(finite, difference, 0.0)
        each = np.where(known, sigma, 1.0)
        w = known / each**2
        inner = int(np.ceil(APART * length))

        def around(v: Array) -> Array:
            outer, within = (
                cv2.boxFilter(v, -1, (2 * reach + 1,) * 2, normalize=False, borderType=cv2.BORDER_CONSTANT)
                for reach in (inner + AROUND, inner)
            )
            return outer - within

        # what has no error shows its sign
        alone = np.where(known, d / each, np.where(d == 0, 0.0, np.copysign(np.inf, d)))
        mean = around(w * d)
        steps = np.arange(-inner, inner + 1.0)
        alike = float(np.sum(np.exp(-((steps / length) ** 2)))) ** 2
        sure = np.abs(alone) > CERTAIN
        return cls(
            risen=np.where(sure, d, mean) > 0, certain=alone,
            doubtful=known & ~sure & (np.abs(mean) < DOUBTFUL * np.sqrt(alike * np.maximum(around(w), 0.0))),
        )  # fmt: skip

    def cut_and_fill(
        self, w: Array, summed: Callable[[Array], SumOfHeights]
    ) -> tuple[SumOfHeights, SumOfHeights, SumOfHeights]:
        """The net change, fill and cut, which is positive, of cells with weights.

        summed  the sum of changes with weights
        """
        net, fill = summed(w), self._part(w, self.risen, summed, 1.0)
        cut = self._part(w, ~self.risen, summed, -1.0)
        if min(fill.value, cut.value) >= 0:
            return net, fill, cut
        if net.value >= 0:
            return net, net, replace(cut, value=0.0)
        return net, replace(fill, value=0.0), replace(net, value=-net.value, moved=-net.moved)

    def _part(self, w: Array, which: Mask, summed: Callable[[Array], SumOfHeights], sign: float) -> SumOfHeights:
        """Of cells of one sign; if there are none, 0 with the precision of those that could have it."""
        used = (w > 0) & which
        if used.any():
            found, doubtful = summed(np.where(used, sign * w, 0.0)), used & self.doubtful
            if not doubtful.any():
                return found
            more = found if (doubtful == used).all() else summed(np.where(doubtful, sign * w, 0.0))
            return replace(found, local=float(np.sqrt(found.local**2 + more.local**2 / np.pi)))
        z = np.where(w > 0, sign * self.certain, -np.inf)
        could = z >= min(-CERTAIN, float(z.max()))
        return replace(summed(np.where(could & (w > 0), sign * w, 0.0)), value=0.0)
