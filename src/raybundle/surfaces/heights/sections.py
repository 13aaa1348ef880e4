"""Profiles of heights along lines, with standard deviations of each place, of means and of differences of places."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.surfaces.heights.height_model import HeightModel, SumOfHeights


@dataclass(frozen=True, slots=True, kw_only=True)
class Section:
    """Heights along a line; arrays (n, ...), NaN where the surface has a hole."""

    model: HeightModel
    corners: Array
    """(k, 2) of the line, in columns and rows of the grid"""
    distance: Array
    """from its beginning, in the unit of the heights"""
    place: Array
    """(n, 2) columns and rows"""
    height: Array
    sigma: Array
    cells: Index
    """(n, 4) between whose middles the place lies, row by row"""
    weights: Array
    """(n, 4) by which their heights make its own; 0 where there is no height"""

    def of(self, shares: Array) -> SumOfHeights:
        """The sum of its heights times shares (n,); places without a height may have none.

        raises  InputError where one has
        """
        w = np.zeros(self.model.heights.height.size)
        np.add.at(w, self.cells.ravel(), (self.weights * np.where(shares == 0, 0.0, shares)[:, None]).ravel())
        return self.model.sum_of(w.reshape(self.model.shape))

    @property
    def spans(self) -> Array:
        """(n,) length of the line that each place stands for: half of what lies to neighbours, where both have heights.

        What lies beside a place without a height has none.
        """
        both = np.isfinite(self.height[1:]) & np.isfinite(self.height[:-1])
        half = np.where(both, np.diff(self.distance), 0.0) / 2
        return np.append(half, 0.0) + np.append(0.0, half)

    @property
    def with_height(self) -> float:
        """Share of the line that has one."""
        lost = ~(np.isfinite(self.height[1:]) & np.isfinite(self.height[:-1]))
        far = np.diff(self.distance)
        return 1 - float(far[lost].sum() / far.sum())

    @property
    def filled(self) -> Mask:
        """(n,) places whose height is made of any that was interpolated."""
        holes = self.model.holes
        if holes is None:
            return np.zeros(len(self.height), bool)
        return np.asarray(((self.weights > 0) & holes.filled.ravel()[self.cells]).any(axis=1))

    @property
    def filled_share(self) -> float:
        """Share of what has a height that was filled."""
        spans = self.spans
        return float(spans[self.filled].sum() / spans.sum()) if spans.any() else 0.0

    @property
    def mean(self) -> SumOfHeights | None:
        """Along what has a height, linear from place to place; None: none has.

        Where no two neighbours have one, of the places that have.
        """
        known, spans = np.isfinite(self.height), self.spans
        if not known.any():
            return None
        return self.of(spans / spans.sum() if spans.any() else known / known.sum())

    def at(self, distances: Array) -> Section:
        """The places at distances (n,) from the beginning alone."""
        run = _run(self.corners) * self.model.cell
        place = np.stack([np.interp(distances, run, self.corners[:, k]) for k in (0, 1)], axis=1)
        return _through(self.model, self.corners, place, np.asarray(distances, float))

    def nearest(self, distance: float) -> int | None:
        """The place with a height nearest to a distance from the beginning; None: there is none."""
        known = np.isfinite(self.height)
        far = np.where(known, np.abs(self.distance - distance), np.inf)
        return int(far.argmin()) if known.any() else None

    def difference(self, one: int, other: int) -> SumOfHeights:
        """Height of a place less that of another."""
        shares = np.zeros(len(self.height))
        shares[one] += 1
        shares[other] -= 1
        return self.of(shares)


def section(model: HeightModel, corners: Array, step: float) -> Section:
    """The heights along a line, evenly apart, its corners included.

    corners  (k, 2) columns and rows from the upper left corner of the grid
    step     largest distance from place to place [cells]

    A height lies linearly between those of the middles of four cells; where one that counts has none, neither has it.
    """
    places, distances, run = list[Array](), list[Array](), 0.0
    for a, b in pairwise(corners):
        length = float(np.linalg.norm(b - a))
        share = np.linspace(0, 1, max(1, int(np.ceil(length / step - 1e-9))) + 1)[:-1]
        places.append(a + share[:, None] * (b - a))
        distances.append(run + share * length)
        run += length
    place = np.concatenate([*places, corners[-1:]])
    distance = np.append(np.concatenate(distances), run) * model.cell
    return _through(model, corners, place, distance)


def _run(corners: Array) -> Array:
    """(k,) how far each corner is from the first one along the line."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1))])


def _through(model: HeightModel, corners: Array, place: Array, distance: Array) -> Section:
    """The heights at places (n, 2), linear between those of the middles of four cells."""
    cells, weights, outside = between_middles(model.shape, place)
    value = model.heights.height.ravel()[cells].astype(float)
    lost = np.asarray(outside | ((weights > 0) & ~np.isfinite(value)).any(axis=1))
    weights[lost] = 0.0
    height = np.where(lost, np.nan, (weights * np.nan_to_num(value)).sum(axis=1))
    return Section(
        model=model, corners=corners, distance=distance, place=place, height=height,
        sigma=_sigma(model, cells, weights, lost), cells=cells, weights=weights,
    )  # fmt: skip


def between_middles(shape: tuple[int, int], place: Array, *, on: bool = False) -> tuple[Index, Array, Array]:
    """Cells (n, 4) between whose middles places (n, 2) lie, their weights (n, 4), and which places lie beyond the grid.

    on  whether heights go on as between the outer two middles where a place lies beyond them, by half a cell at most;
        else the outer cells go on level
    """
    rows, columns = shape
    x, y = (place - 0.5).T
    i, j = (np.clip(np.floor(v + 1e-9), 0, max(n - 2, 0)).astype(int) for v, n in ((x, columns), (y, rows)))
    right, down = (np.minimum(k + 1, n - 1) for k, n in ((i, columns), (j, rows)))
    outside = np.asarray((place < 0).any(axis=1) | (place > [columns, rows]).any(axis=1))
    u, v = x - i, y - j
    if not on:
        u, v = np.clip(u, 0, 1), np.clip(v, 0, 1)
    cells = np.stack([j * columns + i, j * columns + right, down * columns + i, down * columns + right], axis=1)
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v], axis=1)
    weights[np.abs(weights) < 1e-9] = 0.0
    return cells, weights, outside


def _sigma(model: HeightModel, cells: Index, weights: Array, lost: Array) -> Array:
    """(n,) standard deviations of weighted sums of four cells."""
    good = np.flatnonzero(~lost)
    found = np.full(len(cells), np.nan)
    if not len(good):
        return found
    c, w = cells[good], weights[good]
    # cells without a weight may have no height: the first that has stands for them
    c = np.where(w > 0, c, np.take_along_axis(c, w.argmax(axis=1)[:, None], axis=1))
    one, other = (np.broadcast_to(x, (len(c), 4, 4)) for x in (c[:, :, None], c[:, None, :]))
    both = w[:, :, None] * w[:, None, :] * model.covariance(one.ravel(), other.ravel()).reshape(one.shape)
    found[good] = np.sqrt(np.maximum(both.sum(axis=(1, 2)), 0.0))
    return found
