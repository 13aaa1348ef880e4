"""A surface as a whole: how complete and how precise it is, map by map, with small pictures of both."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array

QUANTILES = (0.5, 0.9, 0.99)
PICTURE_PX = 200
"""Longer side of the small pictures."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MapSummary:
    """Of one depth map."""

    name: str
    """of its reference"""
    sources: int
    pixels: int
    """that were tried"""
    measured: int
    """that have a depth"""
    given: int
    """points that it gives to the cloud"""
    sigma: float
    """median standard deviation along the ray [unit]; NaN without a depth"""
    picture: Array
    """(h, w) standard deviation along the ray [unit] of some of its pixels, NaN where there is no depth"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightSummary:
    """Of heights on a grid; pictures (h, w) of some cells."""

    height: Array
    sigma: Array
    cell: float
    """from cell to cell of the pictures"""
    left: float
    top: float
    share: float
    """of the cells that have a height"""
    profile: Array
    """(n, 3) place, height and standard deviation along the middle row"""
    in_map: bool = False
    """whether heights count as those of a map do, and not from a plane of the object"""


@dataclass(frozen=True, slots=True, kw_only=True)
class OrthophotoSummary:
    """Of an orthophoto."""

    picture: Array
    """(h, w, 4) uint8 red, green, blue, and 255 where there are any, of some pixels"""
    pixel: float
    """from pixel to pixel of the picture"""
    left: float
    top: float
    share: float
    """of the pixels that are seen"""
    sigma: float
    """median standard deviation of a place in plan; NaN where nothing is seen"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceSummary:
    """Of all of it."""

    points: int
    unit: str
    """of lengths; empty: none"""
    sigma: tuple[float, ...]
    """standard deviation along the ray: quantiles of all points"""
    position: tuple[float, ...]
    """standard deviation of a point's place in the datum, root of the sum of the squares of x, y, z: quantiles"""
    axes: Array
    """(3, quantiles) standard deviations of x, y, z"""
    parts: Array
    """(3, quantiles) the same of noise, roughness, orientation and calibration"""
    shares: tuple[float, float, float]
    """of noise, roughness and orientation in the variance along the ray, in the mean: their sum is 1"""
    rays: Array
    """(n,) points by the number of photographs that measured them, from 0"""
    incidence: float
    """share of points that were grazed: cosine below 0.3"""
    correlation: Array
    """(n, 2) distance in pixels and stated correlation of the errors by noise and roughness"""
    maps: tuple[MapSummary, ...]
    left_out: tuple[tuple[str, str], ...]
    of_part: bool = False
    """whether a part of the object was asked for: pixels around it show something else"""
    written: int = 0
    """points in the files, where they were thinned; 0: all"""
    heights: HeightSummary | None = None
    orthophoto: OrthophotoSummary | None = None


def reduced(values: Array, most: int = PICTURE_PX) -> tuple[Array, int]:
    """Every k-th of rows and columns (rows, columns), so that the longer side has at most so many, and k."""
    k = max(1, int(np.ceil(max(values.shape) / most)))
    return values[k // 2 :: k, k // 2 :: k], k
