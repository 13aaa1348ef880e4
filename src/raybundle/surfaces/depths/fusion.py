"""Depth maps of several references against each other: what agrees, what one map sees through, which estimate is best.

A point of a map is looked up in the other maps that see its place.  It agrees with one whose depth there differs by no
more than noise and roughness of both allow, and what orientation lets them differ by: an error that it gives to both
maps alike excuses nothing; one that sees through it, to something behind, speaks against it; one in which
something else stands before it is silent.  Of estimates that agree the best stands for all: a mean would have to know
how they are correlated, and gains little, since they share photographs, orientation and texture.

A depth that is doubtful in its own map states nothing of sure ones.  It stays where two other maps see the same, surely
or not, and none sees through it.  Its standard deviation counts how far its neighbours stand apart: of an exactly known
object 0.4 to 0.9 % of such depths are then off by more than five of them (benchmarks/surface_truth.py, its union).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid
from raybundle.surfaces.depths.transfer import Projection, Transfer

SIGMAS = 3.0
"""Standard deviations of a difference up to which two maps agree."""
FAR = 10.0
"""Standard deviations of a difference beyond which two maps see other things"""
CLASSES, FEWEST = 10, 100
"""Classes of contrast in which maps are compared, the weakest halved again and again, and points in each at least."""
NORMAL = 0.4549
"""Median of a chi-square of one degree of freedom"""
WITNESSES = 2
"""Maps that have to see the same as a doubtful depth."""
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
    """of t by noise and roughness"""
    doubtful: Mask | None = None
    """depths that their own map does not trust; None: none"""
    whole: Array | None = None
    """of t, all parts, by which the best is chosen; None: `sigma`"""
    apart: float = 0.0
    """of t by orientation, against the map whose points are looked up in this one"""
    correlation: float = 0.0
    """of noise and roughness with those of that map"""

    @property
    def all_parts(self) -> Array:
        """Standard deviations of t, all parts."""
        return self.sigma if self.whole is None else self.whole

    def shows(self, xy_px: Array) -> Mask:
        """Which places (n, 2) lie among its pixels, with a depth or without."""
        g = self.grid
        low, size = np.array([g.x0, g.y0]), g.stride * np.array([g.columns, g.rows])
        return np.asarray(((xy_px >= low) & (xy_px < low + size)).all(axis=1))

    def nearest(self, xy_px: Array) -> Index:
        """The nearest pixel (n,) of the map to places (n, 2), row by row; -1 beyond it."""
        g, (rows, columns) = self.grid, self.t.shape
        column = np.round((xy_px[:, 0] - g.x0 - 0.5) / g.stride)
        row = np.round((xy_px[:, 1] - g.y0 - 0.5) / g.stride)
        with np.errstate(invalid="ignore"):
            inside = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
        return np.where(inside, np.where(inside, row, 0) * columns + np.where(inside, column, 0), -1).astype(int)

    def trusted(self, at: Index) -> Mask:
        """Whether pixels (n,), row by row, are not doubtful."""
        return np.ones(len(at), bool) if self.doubtful is None else ~self.doubtful.ravel()[at]

    def looked_up(self, xy_px: Array) -> tuple[Array, Array, Array]:
        """Depth parameter at places (n, 2), its standard deviation, and all of it of the nearest pixel as a length.

        A depth goes on from the nearest pixel along its slopes; NaN where that one has none.
        """
        g, at = self.grid, self.nearest(xy_px)
        lost = at < 0
        j, i = np.divmod(np.where(lost, 0, at), self.t.shape[1])
        du = xy_px[:, 0] - (g.x0 + 0.5 + g.stride * i)
        dv = xy_px[:, 1] - (g.y0 + 0.5 + g.stride * j)
        t = self.t[j, i] + self.slopes[0, j, i] * du + self.slopes[1, j, i] * dv
        sigma = np.where(lost, np.nan, self.sigma[j, i])
        length = self.rays.lengths(self.t[j, i], np.where(lost, np.nan, self.all_parts[j, i]))
        return np.where(lost, np.nan, t), sigma, length


@dataclass(frozen=True, slots=True, kw_only=True)
class Agreement:
    """What other maps say of each point of one: arrays (n,) of its pixels with a depth, row by row."""

    sure: Mask
    """its own map trusts it"""
    agree: Array
    """uint8, maps that surely see the same"""
    against: Array
    """uint8, maps that surely see through it"""
    perhaps_agree: Array
    """uint8, maps that see the same, doubtfully"""
    perhaps_against: Array
    """uint8, maps that see through it, doubtfully"""
    behind: Array
    """uint8, maps in which something else stands before it"""
    shown: Array
    """uint8, maps among whose pixels its place lies, with a depth there or without"""
    best: Mask
    """no map that agrees knows the place better"""
    scatter: Array
    """float32, difference to the first map that surely knows the place, in its standard deviations; NaN where none
    does, or something else stands there"""

    def confirmed(self, among: Mask) -> float:
        """Share of what other maps may show, of some points (n,), that one of them confirms.

        On a surface it is the completeness of the others there.  Where grey values resemble each other by chance, as on
        water, leaves in the wind and noise, depths are found here and there, and hardly any twice.
        """
        among = among & self.sure
        return float((among & (self.agree > 0)).sum() / max(int((among & (self.shown > 0)).sum()), 1))

    @property
    def confirming(self) -> Array:
        """(n,) uint8, maps that confirm it: sure ones of a sure point, all of a doubtful one."""
        return np.where(self.sure, self.agree, self.agree + self.perhaps_agree).astype(np.uint8)

    @property
    def kept(self) -> Mask:
        """Points that go into the cloud: confirmed by more maps than see through them, and the best of those."""
        doubtful = (self.confirming >= WITNESSES) & (self.against + self.perhaps_against == 0)
        return np.where(self.sure, self.agree > self.against, doubtful) & self.best


def agreement(
    mine: MapView, others: Iterable[MapView], tables: Iterable[Transfer | Projection], order: Sequence[int], *, own: int
) -> Agreement:
    """Compare the points of a map with other maps.

    mine    the map whose points are looked at
    others  maps that may see them; they are asked for one after the other
    tables  where each of the others sees what `mine` sees
    order   (k,) a number of each of the others, `own` of this one: of equally good estimates the lower is kept

    Limits: an error that all maps share, as one of orientation.
    """
    points = _Points.of(mine)
    count = len(points.t)
    behind, shown = (np.zeros(count, np.uint8) for _ in range(2))
    agree, against = (np.zeros((2, count), np.uint8) for _ in range(2))
    best = np.ones(count, bool)
    scatter = np.full(count, np.nan, np.float32)
    for other, table, number in zip(others, tables, order, strict=True):
        for begin in range(0, count, CHUNK):
            part = slice(begin, begin + CHUNK)
            place = table.at(points.xy_px[part], points.t[part])
            there = np.flatnonzero(np.isfinite(place).all(axis=1))
            shown[part][there] += other.shows(place[there])
            seen, difference, sigma, (length, trusted) = points.beside(part, other, there, place[there])
            limit = SIGMAS * np.hypot(sigma, other.apart)
            first = seen[trusted & np.isnan(scatter[part][seen])]
            normal = difference / np.hypot(sigma * np.sqrt(1 - other.correlation), other.apart)
            normal = normal[trusted & np.isnan(scatter[part][seen])]
            scatter[part][first] = np.where(np.abs(normal) < FAR, normal, np.nan)
            same, front = np.abs(difference) <= limit, difference > limit
            for k, mine_of in enumerate((trusted, ~trusted)):
                agree[k, part][seen[same & mine_of]] += 1
                against[k, part][seen[front & mine_of]] += 1
            behind[part][seen[~same & ~front]] += 1
            ours = points.length[part][seen]
            with np.errstate(invalid="ignore"):
                better = (length < ours) | ((length == ours) & (number < own))
            best[part][seen[same & better & (trusted | ~points.sure[part][seen])]] = False
    return Agreement(
        sure=points.sure, agree=agree[0], against=against[0], perhaps_agree=agree[1], perhaps_against=against[1],
        behind=behind, shown=shown, best=best, scatter=scatter,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class _Points:
    """Points (n,) of a map."""

    xy_px: Array
    t: Array
    xyz: Array
    step: Array
    """(n, 3) float32 to where a point lies whose t is larger by its standard deviation"""
    length: Array
    """standard deviation, all parts, as a length"""
    sure: Mask
    """their own map trusts them"""

    @classmethod
    def of(cls, mine: MapView) -> _Points:
        known = np.isfinite(mine.t)
        xy, t, sigma = mine.grid.xy_px[known], np.asarray(mine.t[known], float), np.asarray(mine.sigma[known], float)
        xyz, step = np.empty((len(t), 3)), np.empty((len(t), 3), np.float32)
        for begin in range(0, len(t), CHUNK):
            part = slice(begin, begin + CHUNK)
            xyz[part], step[part] = mine.rays.steps(xy[part], t[part], sigma[part])
        length = mine.rays.lengths(t, np.asarray(mine.all_parts[known], float))
        sure = mine.trusted(np.flatnonzero(known))
        return cls(xy_px=xy, t=t, xyz=xyz, step=step, length=length, sure=sure)

    def beside(
        self, part: slice, other: MapView, seen: Index, place: Array
    ) -> tuple[Array, Array, Array, tuple[Array, Mask]]:
        """Of some points those that another map knows: numbers, differences of t, standard deviations, lengths, trust.

        Standard deviations are of differences, by noise and roughness, as if the maps had nothing in common.

        seen, place  numbers in the part and places (n, 2) of those that it may see
        """
        there, theirs, length = other.looked_up(place)
        finite = np.isfinite(there)
        seen, at, there, theirs, length = seen[finite], place[finite], there[finite], theirs[finite], length[finite]
        xyz = self.xyz[part][seen]
        mine_there = other.rays.parameter(at, xyz)
        # how far my standard deviation moves the point along the other's ray
        by_mine = other.rays.parameter(at, xyz + self.step[part][seen]) - mine_there
        trusted = other.trusted(other.nearest(at))
        return seen, mine_there - there, np.hypot(by_mine, theirs), (length, trusted)


def by_contrast(scatter: Array, contrast: Array) -> Array:
    """Factors (n,) of 1 or more by which variances of noise and roughness are too small, by what maps differ.

    scatter   (n,) of `agreement`
    contrast  (n,) of the points

    By class of contrast the median square of what maps differ in their standard deviations; between classes linear.
    Weak texture may be a small part of what is seen: the lower half of the weakest class is one of its own, and so on.
    Where texture is weak, noise is not what it is elsewhere: a camera and its compression have smoothed it.  It does
    not show what all maps have alike.
    """
    known = np.flatnonzero(np.isfinite(scatter) & np.isfinite(contrast))
    classes = min(CLASSES, len(known) // FEWEST)
    if classes < 1:
        return np.ones(len(contrast))
    ends = [len(known) * (k + 1) // classes for k in range(classes - 1)]
    while (end := ends[0] if ends else len(known)) >= 2 * FEWEST:
        ends.insert(0, end // 2)
    parts = np.split(known[np.argsort(contrast[known], kind="stable")], ends)
    middle = np.array([np.median(contrast[p]) for p in parts])
    ratio = np.array([np.median(np.square(scatter[p], dtype=float)) / NORMAL for p in parts])
    found = np.interp(contrast, middle, np.maximum(ratio, 1.0))
    return np.where(np.isfinite(found), found, 1.0)
