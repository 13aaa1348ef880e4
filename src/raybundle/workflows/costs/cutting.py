"""How a flight is cut into parts: sizes by the rules of `blocking.tree`, without its photographs.

A rectangle of images is cut across its longer side.  The separator is a band: an image on one side has an object point
in common with one on the other up to `reach` images away, so that a band of this width touches all of them.  Sizes are
those of a flight; where images crowd round an object, parts hang together more closely and separators are larger.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from raybundle.blocking.network import LEAF
from raybundle.blocking.tree import WORTH, multiplications

IMAGE, INTERIOR = 6, 8
"""Unknowns of an image, and of the interior orientation that all images share, as of Brown's model"""
BAND = 0.8
"""Width of a separator [images], over the square root of the overlap: flights of 1000 and 10 000 images, cut by
`blocking.tree` (benchmarks/scaling.py)"""
ALONE = 0.25
"""Of the image points of a separator's images those that none of a leaf shares: the same flights"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Size:
    """Parts of one size."""

    depth: int
    """steps to the root"""
    count: int
    """how many of them"""
    own: float
    """images that each eliminates"""
    boundary: float
    """images above that each touches"""
    halves: tuple[int, ...] = ()
    """positions among the sizes of the two parts below each; none of a leaf"""
    points: float = 0.0
    """image points that each reduces"""

    @property
    def leaf(self) -> bool:
        """Whether it is not cut."""
        return not self.halves

    @property
    def columns(self) -> float:
        """Unknowns that each eliminates."""
        return IMAGE * self.own + (0 if self.depth else INTERIOR)

    @property
    def rows(self) -> float:
        """Unknowns of the boundary of each."""
        return IMAGE * self.boundary + (INTERIOR if self.depth else 0)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Piece:
    """A rectangle of images, and which of its sides border on a separator."""

    width: float
    height: float
    sides: tuple[bool, bool, bool, bool]
    """left, right, below, above"""

    @property
    def turned(self) -> _Piece:
        """The same by a quarter turn."""
        left, right, below, above = self.sides
        return _Piece(width=self.height, height=self.width, sides=(below, above, left, right))

    def boundary(self, reach: float) -> float:
        """Images of the separators around that it touches, corners where two of them meet included."""
        left, right, below, above = self.sides
        across, along = left + right, below + above
        return reach * (across * self.height + along * self.width) + across * along * reach**2


def reach_of(overlap: float) -> float:
    """Width of a separator [images].

    overlap  photographs that show a place
    """
    return BAND * math.sqrt(overlap)


def cut_flight(images: int, overlap: float, points: float, *, leaf: int = LEAF, shape: float = 1.0) -> tuple[Size, ...]:
    """Parts of a flight, the root first.

    overlap  photographs that show a place
    points   image points of an image
    leaf     unknowns of a leaf at most
    shape    longer side of the ground over the shorter one, in images: 1, the longest separators
    """
    reach = reach_of(overlap)
    width, height = math.sqrt(images * shape), math.sqrt(images / shape)
    level: dict[_Piece, int] = {_Piece(width=width, height=height, sides=(False, False, False, False)): 1}
    found: list[Size] = []
    depth = 0
    while level:
        below: dict[_Piece, int] = {}
        begin = len(found) + len(level)
        for piece, count in level.items():
            p = piece if piece.width >= piece.height else piece.turned
            halves = _halves(p, reach, leaf)
            for half in halves:
                below[half] = below.get(half, 0) + count
            own = reach * p.height if halves else p.width * p.height
            places = list(below)
            at = tuple(begin + places.index(half) for half in halves)
            found.append(Size(depth=depth, count=count, own=own, boundary=p.boundary(reach), halves=at))
        level, depth = below, depth + 1
    return _with_points(found, images * points, points)


def _halves(p: _Piece, reach: float, leaf: int) -> tuple[_Piece, ...]:
    """The two sides of a cut across the width; none where it is small enough, or cutting gains nothing."""
    whole = IMAGE * p.width * p.height
    rest = (p.width - reach) / 2
    if whole <= leaf or rest <= 0:
        return ()
    separator, side = IMAGE * reach * p.height, IMAGE * rest * p.height
    pieces = 2 * multiplications(side, separator) + multiplications(separator, 0.0)
    if pieces >= WORTH * multiplications(whole, 0.0):
        return ()
    left, right, below, above = p.sides
    return (
        _Piece(width=rest, height=p.height, sides=(left, True, below, above)),
        _Piece(width=rest, height=p.height, sides=(True, right, below, above)),
    )


def _with_points(sizes: list[Size], total: float, each: float) -> tuple[Size, ...]:
    """With the image points of each: those of a separator that no leaf shares, the rest to the leaves."""
    alone = {k: ALONE * each * s.own for k, s in enumerate(sizes) if not s.leaf}
    of_leaves = total - sum(alone[k] * sizes[k].count for k in alone)
    in_leaves = sum(s.own * s.count for s in sizes if s.leaf)
    return tuple(
        replace(s, points=alone[k] if k in alone else of_leaves * s.own / in_leaves) for k, s in enumerate(sizes)
    )
