"""Depth maps of several references against each other: what agrees, what one map sees through, which estimate is best.

A point of a map is looked up in the other maps that see its place.  It agrees with one whose depth there differs by no
more than both standard deviations allow; one that sees through it, to something behind, speaks against it; one in which
something else stands before it is silent.  Of estimates that agree the best stands for all: a mean would have to know
how they are correlated, and gains little, since they share photographs, orientation and texture.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.refine import PixelGrid
from raybundle.surfaces.transfer import ReferenceRays, Transfer

SIGMAS = 3.0
"""Standard deviations of a difference up to which two maps agree."""
CHUNK = 200_000
"""Points that are looked up at once."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MapView:
    """A depth map as others look into it: arrays (rows, columns), NaN where there is no depth."""

    rays: ReferenceRays
    grid: PixelGrid
    t: Array
    slopes: Array
    """(2, rows, columns) of t by column and row [1 / px]"""
    sigma: Array
    """of t, all parts"""

    def shows(self, xy_px: Array) -> Mask:
        """Which places (n, 2) lie among its pixels, with a depth or without."""
        g = self.grid
        low, size = np.array([g.x0, g.y0]), g.stride * np.array([g.columns, g.rows])
        return np.asarray(((xy_px >= low) & (xy_px < low + size)).all(axis=1))

    def looked_up(self, xy_px: Array) -> tuple[Array, Array, Array]:
        """Depth parameter at places (n, 2), its standard deviation, and that of the nearest pixel as a length.

        A depth goes on from the nearest pixel along its slopes; NaN where that one has none.
        """
        g = self.grid
        column = np.round((xy_px[:, 0] - g.x0 - 0.5) / g.stride)
        row = np.round((xy_px[:, 1] - g.y0 - 0.5) / g.stride)
        with np.errstate(invalid="ignore"):
            inside = (row >= 0) & (row < self.t.shape[0]) & (column >= 0) & (column < self.t.shape[1])
        j, i = (np.where(inside, x, 0).astype(int) for x in (row, column))
        du = xy_px[:, 0] - (g.x0 + 0.5 + g.stride * i)
        dv = xy_px[:, 1] - (g.y0 + 0.5 + g.stride * j)
        t = self.t[j, i] + self.slopes[0, j, i] * du + self.slopes[1, j, i] * dv
        lost = ~inside
        sigma = np.where(lost, np.nan, self.sigma[j, i])
        with np.errstate(divide="ignore", invalid="ignore"):
            length = sigma / np.square(self.t[j, i])
        return np.where(lost, np.nan, t), sigma, length


@dataclass(frozen=True, slots=True, kw_only=True)
class Agreement:
    """What other maps say of each point of one: arrays (n,) of its pixels with a depth, row by row."""

    agree: Array
    """uint8, maps that see the same"""
    against: Array
    """uint8, maps that see through it"""
    behind: Array
    """uint8, maps in which something else stands before it"""
    shown: Array
    """uint8, maps among whose pixels its place lies, with a depth there or without"""
    best: Mask
    """no map that agrees knows the place better"""

    def confirmed(self, among: Mask) -> float:
        """Share of what other maps may show, of some points (n,), that one of them confirms.

        On a surface it is the completeness of the others there.  Where grey values resemble each other by chance, as on
        water, leaves in the wind and noise, depths are found here and there, and hardly any twice.
        """
        return float((among & (self.agree > 0)).sum() / max(int((among & (self.shown > 0)).sum()), 1))

    @property
    def kept(self) -> Mask:
        """Points that go into the cloud: confirmed by more maps than see through them, and the best of those."""
        return (self.agree > self.against) & self.best


def agreement(
    mine: MapView, others: Sequence[MapView], tables: Sequence[Transfer], order: Sequence[int], *, own: int
) -> Agreement:
    """Compare the points of a map with other maps.

    mine    the map whose points are looked at
    others  maps that may see them
    tables  where each of the others sees what `mine` sees
    order   (k,) a number of each of the others, `own` of this one: of equally good estimates the lower is kept

    What it does not tell: an error that all maps share, as one of orientation.
    """
    known = np.isfinite(mine.t)
    xy, t, sigma = mine.grid.xy_px[known], np.asarray(mine.t[known], float), np.asarray(mine.sigma[known], float)
    count = len(t)
    agree, against, behind, shown = (np.zeros(count, np.uint8) for _ in range(4))
    best = np.ones(count, bool)
    for begin in range(0, count, CHUNK):
        part = slice(begin, begin + CHUNK)
        xyz = mine.rays.points(xy[part], t[part])
        length = sigma[part] / t[part] ** 2
        step = mine.rays.points(xy[part], t[part] + sigma[part])
        for other, table, number in zip(others, tables, order, strict=True):
            place = table.at(xy[part], t[part])
            seen = np.flatnonzero(np.isfinite(place).all(axis=1))
            shown[part][seen] += other.shows(place[seen])
            there, theirs, their_length = other.looked_up(place[seen])
            told = np.isfinite(there)
            seen, there, theirs, their_length = seen[told], there[told], theirs[told], their_length[told]
            at = place[seen]
            mine_there = other.rays.parameter(at, xyz[seen])
            # how far my standard deviation moves the point along the other's ray
            by_mine = other.rays.parameter(at, step[seen]) - mine_there
            difference = mine_there - there
            limit = SIGMAS * np.hypot(by_mine, theirs)
            same, front = np.abs(difference) <= limit, difference > limit
            agree[part][seen[same]] += 1
            against[part][seen[front]] += 1
            behind[part][seen[~same & ~front]] += 1
            with np.errstate(invalid="ignore"):
                better = (their_length < length[seen]) | ((their_length == length[seen]) & (number < own))
            best[part][seen[same & better]] = False
    return Agreement(agree=agree, against=against, behind=behind, shown=shown, best=best)
