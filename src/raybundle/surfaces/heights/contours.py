"""Contour lines of heights, without the wiggles that are noise.

Lines follow the heights at the least resolution that their standard deviations ask for: each cell takes the widest of
several smoothings that none of the narrower ones contradicts (intersection of confidence intervals: Goldenshluger and
Nemirovski 1997; Katkovnik 1999).  Edges and reliefs stay sharp, noise on even ground is averaged out.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.surfaces.heights.grids import filtered
from raybundle.surfaces.heights.height_model import HeightModel

WIDTHS = (0.7, 1.0, 1.4, 2.0, 2.8, 4.0)
"""Standard deviations of the Gaussian smoothings [cells]"""
CONFIDENCE = 2.0
"""Standard deviations to either side of an estimate in which the surface is taken to lie"""
FEWEST = 3
"""Places of a line; shorter ones are dots"""
MOST_LEVELS = 2000


@dataclass(frozen=True, slots=True, kw_only=True)
class Contour:
    """Lines of one height."""

    height: float
    lines: tuple[Array, ...]
    """(n, 2) columns and rows each; the first place is the last one of a closed line"""


def contours(height: Array, interval: float) -> tuple[Contour, ...]:
    """Lines of all multiples of an interval, by marching squares through the middles of cells.

    height  (rows, columns), NaN where there is none: lines end there
    raises  InputError where contourpy is not installed, or for more levels than can be read
    """
    library = _contourpy()
    known = np.isfinite(height)
    if min(height.shape) < 2 or not known.any():
        return ()
    first, last = (int(f(v / interval)) for f, v in ((np.ceil, height[known].min()), (np.floor, height[known].max())))
    if last - first + 1 > MOST_LEVELS:
        raise InputError("contour.too_many_levels", n=last - first + 1, most=MOST_LEVELS)
    made = library.contour_generator(z=np.ma.masked_invalid(height.astype(float)), name="serial")
    found = list[Contour]()
    for k in range(first, last + 1):
        lines = tuple(np.asarray(line) + 0.5 for line in made.lines(k * interval) if len(line) >= FEWEST)
        if lines:
            found.append(Contour(height=k * interval, lines=lines))
    return tuple(found)


def ring_lines(mask: Array) -> tuple[Array, ...]:
    """Closed outlines (n, 2), columns and rows, of the cells of a mask, through the middles of their sides."""
    padded = np.pad(mask.astype(float), 1)
    made = _contourpy().contour_generator(z=padded, name="serial")
    return tuple(np.asarray(line) - 0.5 for line in made.lines(0.5))


def smoothed(model: HeightModel) -> Array:
    """(rows, columns) heights whose wiggles are larger than their noise; NaN where there is none.

    What is smoothed away is what single heights cannot show: orientation, which moves neighbours alike, plays no part.
    """
    known = model.known
    height = np.where(known, model.heights.height, 0.0).astype(float)
    # steps count as resolution, not as noise: they are not to be smoothed
    noise = np.where(known, np.nan_to_num(model.heights.local.astype(float)) ** 2, 0.0)
    best, low, high = height, *(height + s * CONFIDENCE * np.sqrt(noise) for s in (-1, 1))
    going = known.copy()
    correlated = max(1.0, np.pi * model.length**2)
    for width in WIDTHS:
        n = int(np.ceil(3 * width))
        kernel = np.exp(-(np.arange(-n, n + 1.0) ** 2) / (2 * width**2))
        total = np.maximum(filtered(known.astype(float), kernel), 1e-12)
        estimate = filtered(height, kernel) / total
        # neighbours whose errors are one count once
        variance = filtered(noise, kernel**2) / total**2 * correlated
        sigma = np.sqrt(np.minimum(variance, noise))
        low, high = np.maximum(low, estimate - CONFIDENCE * sigma), np.minimum(high, estimate + CONFIDENCE * sigma)
        going &= low <= high
        best = np.where(going, estimate, best)
    return np.where(known, best, np.nan)


def _contourpy() -> Any:
    try:
        return import_module("contourpy")
    except ImportError:
        raise InputError("package.contourpy_missing") from None
