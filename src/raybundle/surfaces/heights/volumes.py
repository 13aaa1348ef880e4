"""Volumes and areas of heights, with standard deviations: weighted sums of heights, the base being one of them, too."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.surfaces.heights.cut_and_fill import Signs
from raybundle.surfaces.heights.grids import shifted
from raybundle.surfaces.heights.height_model import HeightModel, SumOfHeights
from raybundle.surfaces.heights.sections import between_middles
from raybundle.surfaces.heights.true_areas import true_area

FEWEST = 3
"""Places along the outline that show a plane."""
APART = 0.5
"""Cells from one of them to the next, at most."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Volume:
    """What lies above and below a base, within an outline."""

    above: SumOfHeights
    below: SumOfHeights
    """positive: what is missing up to the base"""
    net: SumOfHeights
    """above less below"""
    plan_area: float
    true_area: float
    """of the surface itself"""
    true_area_sigma: float
    true_area_noise: float
    """the part of that by errors of the heights; the rest is what lies between cells and in holes"""
    filled: float
    """share of the plan area whose heights were interpolated"""
    filled_sigma: float
    """standard deviation of the net volume by that alone"""
    base: Array
    """(rows, columns) heights of the base"""
    mean_sigma: float
    """standard deviation of the mean height above the base"""


def volume(model: HeightModel, covered: Array, base: float | Sequence[Array]) -> Volume:
    """Volumes within the cells' shares that an outline covers.

    covered  (rows, columns) 0 to 1
    base     a height that is exact; or the rings (n, 2) of the outline, columns and rows: the plane that fits the
             heights along them best, with its errors
    raises   InputError where a cell within has no height, or the outline shows no plane

    What lies above is decided as of `Signs`: where the surface runs along the base within its noise, the sign of each
    cell would make both too large by 0.4 sigma of a height times that area.
    """
    used = covered > 0
    if not used.any():
        raise InputError("outline.no_cell")
    b = base_of(model, base)
    area = model.cell**2
    d = np.where(used, np.nan_to_num(model.heights.height.astype(float)) - b.plane, 0.0)

    def summed(w: Array) -> SumOfHeights:
        found = model.sum_of(w - b.spread(w))
        local = float(np.hypot(found.local, b.bent(w)))
        return SumOfHeights(value=float((w * d).sum()), local=local, moved=found.moved)

    w = covered * area
    true = true_area(model, covered)
    signs = Signs.of(model.heights.height.astype(float) - b.plane, model.local, model.length)
    net, above, below = signs.cut_and_fill(w, summed)
    filled = model.holes.filled & used if model.holes is not None else np.zeros(used.shape, bool)
    plan = float(w.sum())
    return Volume(
        above=above, below=below, net=net, plan_area=plan,
        true_area=true.value, true_area_sigma=true.sigma, true_area_noise=true.by_noise,
        filled=float(w[filled].sum()) / plan, filled_sigma=_by_holes(model, w), base=b.plane,
        mean_sigma=net.sigma / plan,
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Base:
    """From where heights count."""

    plane: Array
    """(rows, columns)"""
    spread: Callable[[Array], Array]
    """by which weights of heights it moves a sum of heights above it"""
    bent: Callable[[Array], float]
    """standard deviation of such a sum as heights along the outline are those between cells"""


def base_of(model: HeightModel, base: float | Sequence[Array]) -> Base:
    """A level, which is exact, or the plane by the heights along the rings of an outline; as of `volume`."""
    if isinstance(base, int | float):
        return Base(plane=np.full(model.shape, float(base)), spread=np.zeros_like, bent=lambda w: 0.0 * w.size)
    return _rim_plane(model, base)


def _rim_plane(model: HeightModel, rings: Sequence[Array]) -> Base:
    """The plane by the heights along an outline."""
    place = np.concatenate([_along(r) for r in rings])
    cells, weights, height = _heights_at(model, place)
    good = np.isfinite(height)
    x, y = place[good].T
    if len(x) < FEWEST or np.linalg.matrix_rank(np.stack([np.ones(len(x)), x - x.mean(), y - y.mean()])) < FEWEST:
        raise InputError("outline.too_few_heights", n=len(x), total=len(place))
    rows, columns = np.mgrid[: model.shape[0], : model.shape[1]] + 0.5
    middle = np.array([x.mean(), y.mean()])
    every = np.stack([np.ones(model.shape), columns - middle[0], rows - middle[1]], axis=-1)
    solve = np.linalg.pinv(np.stack([np.ones(len(x)), x - middle[0], y - middle[1]], axis=1))
    plane = every @ (solve @ height[good])

    def spread(w: Array) -> Array:
        """Weights of the heights along the outline, by which the base moves w."""
        found = np.zeros(model.shape)
        shares = np.einsum("rc,rck->k", w, every) @ solve
        np.add.at(found.ravel(), cells[good].ravel(), (weights[good] * shares[:, None]).ravel())
        return found

    bends = _bends(model)[np.clip(y.astype(int), 0, model.shape[0] - 1), np.clip(x.astype(int), 0, model.shape[1] - 1)]

    def bent(w: Array) -> float:
        """By how much the base is off where the surface bends along the whole outline."""
        return abs(float(np.einsum("rc,rck->k", w, every) @ solve @ bends))

    return Base(plane=plane, spread=spread, bent=bent)


def _bends(model: HeightModel) -> Array:
    """(rows, columns) by how much heights between cells lie below the surface, in the mean of all places.

    A cell has the mean of the surface over it, 1 / 24 of the second difference off its middle; linear between two
    middles it is 1 / 12 in the mean.
    """
    h = model.heights.height.astype(float)
    found = np.zeros(h.shape)
    for axis in (0, 1):
        second = shifted(h, 1, axis) + shifted(h, -1, axis) - 2 * h
        found -= np.nan_to_num(second) / 8
    return found


def _along(ring: Array) -> Array:
    """(n, 2) places along a ring, evenly apart on each side, `APART` cells at most."""
    ends = np.roll(ring, -1, axis=0)
    found = list[Array]()
    for a, b in zip(ring, ends, strict=True):
        n = max(1, int(np.ceil(float(np.linalg.norm(b - a)) / APART)))
        found.append(a + (np.arange(n)[:, None] + 0.5) / n * (b - a))
    return np.concatenate(found)


def _heights_at(model: HeightModel, place: Array) -> tuple[Index, Array, Array]:
    """Cells (n, 4) about places, weights by which their heights make those of the places, and these; NaN: none.

    Measured heights where there are enough of them, else those of filled holes, too.
    """
    cells, weights, outside = between_middles(model.shape, place, on=True)
    known = model.known.ravel()
    if model.holes is not None:
        measured = known & ~model.holes.filled.ravel()
        if ((weights == 0) | measured[cells]).all(axis=1).sum() >= len(place) / 2:
            known = measured
    lost = np.asarray(outside | ((weights != 0) & ~known[cells]).any(axis=1))
    value = np.nan_to_num(model.heights.height.ravel()[cells].astype(float))
    return cells, weights, np.where(lost, np.nan, (weights * value).sum(axis=1))


def _by_holes(model: HeightModel, w: Array) -> float:
    """Standard deviation of a sum by what was interpolated alone."""
    if model.holes is None:
        return 0.0
    each = np.bincount(model.holes.number.ravel(), (w * model.holes.sigma).ravel())[1:]
    return float(np.linalg.norm(each))
