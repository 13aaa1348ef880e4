"""A sample of a point cloud, for views."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.numerics.arrays import Array, Index


@dataclass(frozen=True, slots=True, kw_only=True)
class CloudSample:
    """Some of the points of a surface, spread over it; arrays (n, ...)."""

    xyz: Array
    """(n, 3) in the block's frame"""
    colour: Array
    """(n, 3) uint8"""
    sigma: Array
    """(n,) standard deviation along the ray, all parts"""
    image: Index
    """(n,) position of its reference in `names`"""
    names: tuple[str, ...]
    cell: float
    """edge of the cells of which each gives one point; 0: all are there"""
