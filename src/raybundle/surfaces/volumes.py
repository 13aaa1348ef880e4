"""Volumes and areas of heights, with standard deviations: weighted sums of heights, the base being one of them, too."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.height_model import HeightModel, SumOfHeights
from raybundle.surfaces.heights import between, within
from raybundle.surfaces.outlines import along_edge

Spread = Callable[[Array], Array]
"""By which weights of heights a base moves a sum of heights above it"""
FEWEST = 3
"""Cells along the edge that tell a plane."""


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
    filled: float
    """share of the plan area whose heights were interpolated"""
    filled_sigma: float
    """standard deviation of the net volume by that alone"""
    base: Array
    """(rows, columns) heights of the base"""
    mean_sigma: float
    """standard deviation of the mean height above the base"""


def volume(model: HeightModel, covered: Array, base: float | None) -> Volume:
    """Volumes within the cells' shares that an outline covers.

    covered  (rows, columns) 0 to 1
    base     a height that is exact; None: the plane that fits the heights along the edge best, with its errors
    raises   InputError where a cell within has no height, or the edge tells no plane

    Above and below are linear in the heights as long as their signs are sure: where the surface runs along the base
    within its noise, each is too large by about 0.4 sigma of a height times that area, and the net volume is not.
    """
    used = covered > 0
    if not used.any():
        raise InputError("the outline holds no cell of the surface")
    plane, spread = _level(model, base) if base is not None else _rim_plane(model, covered)
    area = model.cell**2
    d = np.where(used, np.nan_to_num(model.heights.height.astype(float)) - plane, 0.0)

    def summed(w: Array) -> SumOfHeights:
        found = model.sum_of(w - spread(w))
        return SumOfHeights(value=float((w * d).sum()), local=found.local, moved=found.moved)

    w = covered * area
    true, true_sigma = _true_area(model, covered)
    net = summed(w)
    filled = model.holes.filled & used if model.holes is not None else np.zeros(used.shape, bool)
    plan = float(w.sum())
    return Volume(
        above=summed(np.where(d > 0, w, 0.0)), below=summed(np.where(d < 0, -w, 0.0)), net=net, plan_area=plan,
        true_area=true, true_area_sigma=true_sigma, filled=float(w[filled].sum()) / plan,
        filled_sigma=_by_holes(model, w), base=plane, mean_sigma=net.sigma / plan,
    )  # fmt: skip


def _level(model: HeightModel, base: float) -> tuple[Array, Spread]:
    """A level base, which weights nothing."""
    return np.full(model.shape, base), np.zeros_like


def _rim_plane(model: HeightModel, covered: Array) -> tuple[Array, Spread]:
    """The plane by the heights along the edge, and what it makes of weights of heights above it."""
    rim = along_edge(covered) & model.known
    if model.holes is not None:
        measured = rim & ~model.holes.filled
        rim = measured if measured.sum() >= FEWEST else rim
    r, c = np.nonzero(rim)
    if len(r) < FEWEST:
        raise InputError(f"{len(r)} heights along the edge of the outline tell no plane; give the height of the base")
    rows, columns = np.mgrid[: model.shape[0], : model.shape[1]].astype(float)
    middle = np.array([c.mean(), r.mean()])
    every = np.stack([np.ones(model.shape), columns - middle[0], rows - middle[1]], axis=-1)
    A = every[r, c]
    solve = np.linalg.pinv(A)
    plane = every @ (solve @ model.heights.height[r, c].astype(float))

    def spread(w: Array) -> Array:
        """Weights of the heights along the edge, by which the base moves w."""
        found = np.zeros(model.shape)
        found[r, c] = np.einsum("rc,rck->k", w, every) @ solve
        return found

    return plane, spread


def _by_holes(model: HeightModel, w: Array) -> float:
    """Standard deviation of a sum by what was interpolated alone."""
    if model.holes is None:
        return 0.0
    each = np.bincount(model.holes.number.ravel(), (w * model.holes.sigma).ravel())[1:]
    return float(np.linalg.norm(each))


def _true_area(model: HeightModel, covered: Array) -> tuple[float, float]:
    """Area of the surface itself and its standard deviation; what noise adds to it is taken off."""
    h, c = model.heights.height.astype(float), model.cell
    known: Mask = model.known
    slopes, parts = list[Array](), list[tuple[Array, Array, Array]]()
    for axis in (1, 0):
        after, before = (_shifted(h, k, axis) for k in (1, -1))
        right = np.where(np.isfinite(after), 1, 0)
        left = np.where(np.isfinite(before), 1, 0)
        span = right + left
        rise = np.where(right > 0, after, h) - np.where(left > 0, before, h)
        slopes.append(np.where(known & (span > 0), rise / (np.maximum(span, 1) * c), 0.0))
        parts.append((right, left, np.maximum(span, 1) * c))
    gx, gy = slopes
    root = np.sqrt(1 + gx**2 + gy**2)
    w = covered * c**2
    used = w > 0
    gradient = np.zeros(model.shape)
    for g, (right, left, span), axis in zip((gx, gy), parts, (1, 0), strict=True):
        by = np.where(used, w * g / root / span, 0.0)
        gradient += _shifted(by * right, -1, axis, 0.0)
        gradient -= _shifted(by * left, 1, axis, 0.0)
        gradient += by * (1 - right) - by * (1 - left)
    noise = np.nan_to_num(model.heights.local.astype(float)) ** 2
    far = float(between(np.array(2.0), np.zeros(1), model.length)[0]) / within(model.length)
    added = [
        np.where(used, w * (1 + other**2) / root**3 * noise * (1 - far) / span**2, 0.0)
        for other, (_, _, span) in zip((gy, gx), parts, strict=True)
    ]
    area = float((w[used] * root[used]).sum() - np.sum(added))
    # a square of noise has twice its mean as variance; neighbours share theirs
    square = 2 * sum(float((a**2).sum()) for a in added) * (1 + np.pi * model.length**2)
    sigma = np.hypot(model.sum_of(np.where(known, gradient, 0.0)).sigma, np.sqrt(square))
    return max(area, float(w.sum())), float(sigma)


def _shifted(values: Array, by: int, axis: int, beyond: float = np.nan) -> Array:
    """(rows, columns) what lies so many cells further along an axis."""
    found = np.roll(values, -by, axis=axis).astype(float)
    edge = [slice(None), slice(None)]
    edge[axis] = slice(-by, None) if by > 0 else slice(None, -by)
    found[tuple(edge)] = beyond
    return found
