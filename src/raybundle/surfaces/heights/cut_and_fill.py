"""Cut and fill: sums over cells by the sign of their change.

The sign by a cell itself would make both too large by 0.4 of its standard deviation wherever nothing changed.  It is
that of the mean around the cell, without those whose noise it shares, unless the change of the cell alone is beyond
doubt.  Neither is negative: where chance makes one so, it is 0 and the other the net change.
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Signs:
    """Which cells rose; the others fell."""

    risen: Mask
    certain: Array
    """change of each cell in its standard deviations"""

    @classmethod
    def of(cls, difference: Array, sigma: Array, length: float) -> Signs:
        """By differences, NaN where there is none.

        length  distance in cells at which errors correlate by 1 / e
        """
        known = np.isfinite(difference) & (sigma > 0)
        each = np.where(known, sigma, 1.0)
        w, d = known / each**2, np.where(known, difference, 0.0)
        inner = int(np.ceil(APART * length))

        def total(reach: int) -> Array:
            return cv2.boxFilter(w * d, -1, (2 * reach + 1,) * 2, normalize=False, borderType=cv2.BORDER_CONSTANT)

        alone = d / each
        around = total(inner + AROUND) - total(inner)
        return cls(risen=np.where(np.abs(alone) > CERTAIN, d, around) > 0, certain=alone)

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
            return summed(np.where(used, sign * w, 0.0))
        z = np.where(w > 0, sign * self.certain, -np.inf)
        could = z >= min(-CERTAIN, float(z.max()))
        return replace(summed(np.where(could & (w > 0), sign * w, 0.0)), value=0.0)
