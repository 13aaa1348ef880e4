"""Heights of a surface above a plane, on a grid: of each cell the layer that lies on top, with its standard deviations.

Points of a cell are parted into layers where they stand apart, and those of the uppermost layer are combined by their
weights and brought to its middle by their mean slope: the height of a cell is the mean of its uppermost layer over the
cell, not that of its middle.  What the points share (windows that overlap, photographs, orientation) does not get
better with their number, and the standard deviations say so.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields

import numpy as np
from scipy.special import erf

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.depths.pairs import Sources

APART = 3.0
"""Standard deviations of a difference beyond which two points do not lie on one layer."""
LEAST_SHARE = 0.25
"""Of a cell's points that make a layer: fewer above the others are blunders, or little of what is there."""
STEEPEST = 0.1
"""Cosine between normal and plumb line below which a point shows nothing of a height: 84 degrees."""
BETWEEN_MAPS = 0.35
"""Correlation of what two maps have as noise and roughness at one place, where it is not known which maps they are."""
SHARED_PHOTOGRAPHS, SHARED_SURFACE = 0.31, 0.23
"""What photographs that both use add to it, as a share of all, and what one surface does to both, by the cosine of the
angle between their rays.  By least squares of 91 pairs of maps of an exactly known object, every second pixel; of
every fourth pixel 80 % of them lie within 0.1 of it (benchmarks/surface_truth.py, its part between maps)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PointsOfCells:
    """Points above a grid; arrays (n, ...)."""

    column: Array
    row: Array
    """in cells from the upper left corner, rows downwards"""
    height: Array
    slope: Array
    """(n, 2) of the height by column and row [1 / cell]"""
    local: Array
    """standard deviation of the height by noise and roughness"""
    orientation: Array
    """by orientation and calibration"""
    image: Index
    """reference"""

    def __len__(self) -> int:
        """How many."""
        return len(self.height)

    def rows(self, which: Index) -> PointsOfCells:
        """Some of them."""
        return PointsOfCells(**{f.name: getattr(self, f.name)[which] for f in fields(self)})

    @classmethod
    def joined(cls, parts: Sequence[PointsOfCells]) -> PointsOfCells:
        """All of them."""
        return cls(**{f.name: np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(cls)})


@dataclass(frozen=True, slots=True, kw_only=True)
class Heights:
    """Heights on a grid: arrays (rows, columns) float32, NaN where nothing was measured."""

    height: Array
    local: Array
    """standard deviation by noise and roughness"""
    step: Array
    """standard deviation by steps of the surface within the resolution (`relief`); `on_grid` leaves it at 0"""
    orientation: Array
    """standard deviation by orientation and calibration"""
    point: Array
    """standard deviation by noise and roughness of a single point of the cell, in the mean"""
    points: Array
    """uint16, that a height was made of"""
    image: Array
    """int32, reference with the largest weight; -1: none"""

    def as_arrays(self) -> dict[str, Array]:
        """What a store keeps."""
        return {f.name: getattr(self, f.name) for f in fields(self)}

    @classmethod
    def of_arrays(cls, a: Mapping[str, Array]) -> Heights:
        """That of `as_arrays`."""
        return cls(**{f.name: np.asarray(a[f.name]) for f in fields(cls)})

    @property
    def sigma(self) -> Array:
        """Standard deviation (rows, columns), all parts."""
        return np.hypot(np.hypot(self.local, self.step), self.orientation)


def between_maps(chosen: Sequence[Sources]) -> float:
    """Correlation of noise and roughness of two maps of a surface at one place, the mean of all pairs by tie points.

    Their photographs' noise is in both as far as they share photographs; what the surface does within the windows is
    alike as far as they look from alike directions.
    """
    of = {s.reference: s for s in chosen if s.sources}
    total = weight = 0.0
    for s in of.values():
        for pair in s.pairs:
            if pair.source in of and np.isfinite(pair.angle_deg):
                total += pair.points * between_two(s, of[pair.source], pair.angle_deg)
                weight += pair.points
    return round(total / weight, 3) if weight else BETWEEN_MAPS


def between_two(one: Sources, other: Sources, angle_deg: float) -> float:
    """Correlation of noise and roughness of two maps at one place, their references' rays so far apart."""
    a, b = ({s.reference, *s.sources} for s in (one, other))
    shared = len(a & b) / float(np.sqrt(len(a) * len(b)))
    return SHARED_PHOTOGRAPHS * shared + SHARED_SURFACE * max(float(np.cos(np.radians(angle_deg))), 0.0)


def on_grid(
    points: PointsOfCells, shape: tuple[int, int], length: float, apart: float = BETWEEN_MAPS
) -> tuple[Heights, Array]:
    """The uppermost layer in each cell, and the weight (n,) that each point has in it, 0 where it has none.

    shape   rows, columns
    length  distance at which the errors of two points of a map by noise and roughness correlate by 1 / e [cells]
    apart   their correlation where they are of two maps (`between_maps`)
    """
    rows, columns = shape
    empty = np.full(shape, np.nan, np.float32)
    found = {name: empty.copy() for name in ("height", "local", "orientation", "point")}
    found |= {
        "step": np.zeros(shape, np.float32),
        "points": np.zeros(shape, np.uint16),
        "image": np.full(shape, -1, np.int32),
    }
    weights = np.zeros(len(points))
    i, j = np.floor(points.column).astype(int), np.floor(points.row).astype(int)
    inside = np.flatnonzero((i >= 0) & (i < columns) & (j >= 0) & (j < rows))
    if not len(inside):
        return Heights(**found), weights
    cell = j[inside] * columns + i[inside]
    middle = points.height[inside] + (
        points.slope[inside, 0] * (i[inside] + 0.5 - points.column[inside])
        + points.slope[inside, 1] * (j[inside] + 0.5 - points.row[inside])
    )
    order = np.lexsort((-middle, cell))
    mine, cell, middle = inside[order], cell[order], middle[order]
    p = points.rows(mine)
    top = _uppermost(cell, middle, p)
    mine, cell, middle, p = mine[top], cell[top], middle[top], p.rows(np.flatnonzero(top))
    new = np.flatnonzero(np.concatenate([[True], cell[1:] != cell[:-1]]))
    at, count = cell[new], np.diff(np.append(new, len(cell)))
    w = 1.0 / np.maximum(p.local, 1e-300) ** 2
    w /= np.repeat(np.add.reduceat(w, new), count)
    weights[mine] = w
    alone = np.add.reduceat((w * p.local) ** 2, new)
    together = np.add.reduceat(w * p.local, new) ** 2
    same = _share_of_one_map(p.image, w, new, count)
    shared = within(length) * (same + (1 - same) * apart)
    flat = {name: values.reshape(-1) for name, values in found.items()}
    height, off = _at_middles(p, w, new, columns, at)
    flat["height"][at] = height
    # a slope is as uncertain as a height is over the length of correlation
    flat["local"][at] = np.sqrt((alone * (1 - shared) + together * shared) * (1 + off / length**2))
    flat["point"][at] = np.sqrt(together)
    flat["orientation"][at] = np.add.reduceat(w * p.orientation, new)
    flat["points"][at] = np.minimum(count, np.iinfo(np.uint16).max)
    flat["image"][at] = p.image[_largest(w, new, count)]
    return Heights(**found), weights


def _at_middles(p: PointsOfCells, w: Array, new: Index, columns: int, at: Index) -> tuple[Array, Array]:
    """(cells,) heights by points, a cell's one after the other, and squares of how far these lie off its middle.

    All of them together are brought to the middle by their mean slope: that of each is uncertain, and over half a cell
    its error would be larger than that of the height.
    """

    def mean(values: Array) -> Array:
        return np.add.reduceat(w * values, new)

    right, down = at % columns + 0.5 - mean(p.column), at // columns + 0.5 - mean(p.row)
    height = mean(p.height) + mean(p.slope[:, 0]) * right + mean(p.slope[:, 1]) * down
    return height, right**2 + down**2


def _uppermost(cell: Index, middle: Array, p: PointsOfCells) -> Mask:
    """Which points (n,), by cell and from above, lie in the uppermost layer of their cell."""
    first = np.concatenate([[True], cell[1:] != cell[:-1]])
    steep = np.abs(p.slope).sum(axis=1)
    limit = np.zeros(len(cell))
    # slopes show how far a height may be off in the middle of a cell: by half of what the surface rises in it
    limit[1:] = APART * np.hypot(p.local[1:], p.local[:-1]) + 0.5 * np.maximum(steep[1:], steep[:-1])
    gap = np.concatenate([[0.0], middle[:-1] - middle[1:]])
    layer = np.cumsum(first | (gap > limit)) - 1
    size = np.bincount(layer)
    begin = np.flatnonzero(np.concatenate([[True], layer[1:] != layer[:-1]]))
    of_cell = np.cumsum(first) - 1
    total = np.bincount(of_cell)
    cell_of_layer = of_cell[begin]
    large = size >= LEAST_SHARE * total[cell_of_layer]
    chosen = np.full(len(total), -1)
    # layers go downwards: of the large ones the first is taken
    largest = np.flatnonzero(large)[::-1]
    chosen[cell_of_layer[largest]] = largest
    # many small layers and none large: the largest of them
    missing = np.flatnonzero(chosen < 0)
    if len(missing):
        by_size = np.argsort(size, kind="stable")
        most = np.full(len(total), -1)
        most[cell_of_layer[by_size]] = by_size
        chosen[missing] = most[missing]
    return layer == chosen[of_cell]


def _share_of_one_map(image: Index, w: Array, new: Index, count: Index) -> Array:
    """(cells,) chance that two points, drawn by their weights, are of one map."""
    of = np.repeat(np.arange(len(new)), count)
    order = np.lexsort((image, of))
    of, image, w = of[order], image[order], w[order]
    begin = np.flatnonzero(np.concatenate([[True], (of[1:] != of[:-1]) | (image[1:] != image[:-1])]))
    return np.bincount(of[begin], np.add.reduceat(w, begin) ** 2, minlength=len(new))


def _largest(w: Array, new: Index, count: Index) -> Index:
    """(cells,) the point of the largest weight in each cell."""
    of = np.repeat(np.arange(len(new)), count)
    last = np.lexsort((w, of))
    return last[np.cumsum(count) - 1]


def within(length: float) -> float:
    """Mean correlation of two places in a cell, of exp(-(distance / length)^2), where a cell is 1 wide."""
    return float(between(np.zeros(1), np.zeros(1), length)[0])


def between(columns: Array, rows: Array, length: float) -> Array:
    """Mean correlation (...) of places in two cells so many columns and rows apart.

    length  of exp(-(distance / length)^2), in cells; the mean over both cells in closed form
    """
    return _between(columns, length) * _between(rows, length)


def _between(apart: Array, length: float) -> Array:
    """Mean of exp(-(x / length)^2) over two intervals of length 1 whose middles are `apart`."""

    def twice(x: Array) -> Array:
        """The second integral of exp(-(x / length)^2)."""
        s = x / length
        return length**2 / 2 * (np.sqrt(np.pi) * s * erf(s) + np.exp(-(s**2)))

    x = np.abs(np.asarray(apart, float))
    return np.maximum(twice(x + 1) - 2 * twice(x) + twice(np.abs(x - 1)), 0.0)
