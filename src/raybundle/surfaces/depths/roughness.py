"""What a surface that is no plane within the window does to its depth; local variances by the map itself.

Of a surface between its refined pixels increments grow with a power of the distance: E (t(x + r) - t(x))^2 / 2 = c
|r|^p (Matheron 1963), of each place of a map with c and p from second differences around it at lags beyond the window,
which tilts do not touch.  A depth is the middle of the window seen through the window's response h; its error is the
increment of weights delta - h, and has the variance -(delta - h)' c |r|^p (delta - h).

That is the variance of a usual pixel of the place.  The local one is a factor of it, known from witnesses: how well
planes of neighbours agree, how much their slopes differ, and residuals of grey values far beyond the map's noise, which
show that the plane does not fit.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Index

NORMAL = 0.6745
"""Median of the absolute value of a standard normal variable"""
LAGS_PX = (8, 16)
"""Both beyond windows of 7 px."""
LEAST_POWER, MOST_POWER = 0.3, 1.9
APART_PX = 4
"""To neighbours whose windows have little in common: weights of 1.9 px overlap by a third."""
FEWEST = 3
"""Neighbours that have to be known; else there is no misfit."""
NEAR_PX = 2
"""To neighbours whose windows are nearly the same: their noise is alike, and what they differ by is the surface."""
BY_MISFIT, BY_NEAR, BY_BEND = 0.3, 0.22, 0.15
"""Exponents by which the variance follows its witnesses: least squares of the logarithm of squared errors along rays
of exactly known surfaces (benchmarks/surface_roughness.py): a terrain and the portal gave 0.33 and 0.24, 0.21 and 0.24,
0.13 and 0.28.  Misfits of surroundings add nothing to them."""
BY_RESIDUAL, BEYOND = 0.4, 2.0
"""The same of residuals as far as they are beyond so many usual variances; below they show nothing of the surface.
Of the terrain; on the portal the variance follows them twice as fast (1.15)."""
LEFT = 0.1
"""Variance of the logarithm of a variance that witnesses leave (0 on the terrain, 0.3 on the portal), by the same least
squares, beside the pi^2 / 2 of normal errors.  The mean of a variance is exp(LEFT / 2) times its median."""
AROUND_PX = 60
"""Side of the surroundings whose second differences show how rough a place is: some fifty windows, so that their median
square is known to a fifth."""
MOST_SIDE, LEVELS = 255, 7
"""Of a square of a median [pixels of the grid]; steps of a logarithm to base 2, so that medians are those of bytes."""
POWERS, WINDOW_SIGMA = 9, 1.9
"""Powers by which the variance of a window is known, and the standard deviation of its weights [px]"""
CHUNK = 50_000
"""Windows at once."""
ROWS = 64
"""Of a map that are looked at together."""
BRIGHTNESSES = 8
"""Classes of brightness: the noise of a sensor grows with it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LocalRoughness:
    """Roughness of the places of a map, by the second differences around each: arrays (rows, columns) float32."""

    power: Array
    square: Array
    """squares of second differences at the first lag, less those by noise, robust over the surroundings [t^2]"""
    lag_px: float

    def variance(self, at: tuple[Index, Index], response: Array) -> Array:
        """(...,) variance by what the surface does within windows of responses (..., side^2).

        at  rows and columns (...) of the map

        How that depends on the power is taken from a Gaussian window, which responses resemble.
        """
        side = np.arange(round(response.shape[-1] ** 0.5)) - (round(response.shape[-1] ** 0.5) - 1) / 2
        window = np.exp(-np.add.outer(side**2, side**2) / (2 * WINDOW_SIGMA**2)).ravel()
        window = (window / window.sum()).astype(np.float32)[None]
        powers = np.linspace(LEAST_POWER, MOST_POWER, POWERS)
        middle = (LEAST_POWER + MOST_POWER) / 2
        of = np.array([of_window(window, p)[0] / _per_strength(self.lag_px, p) for p in powers])
        of /= of_window(window, middle)[0]
        return (of_window(response, middle) * self.square[at] * np.interp(self.power[at], powers, of)).astype(
            np.float32
        )


def local_roughness(t: Array, noise: Array, stride: int) -> LocalRoughness:
    """Of refined depth parameters (rows, columns), NaN where there is none, whose noise has the variances `noise`.

    Medians over squares of AROUND_PX: an edge crosses few of the second differences there, and does not count.  Where
    little is known the usual ones of the map count.
    """
    lags = [max(1, round(lag / stride)) for lag in LAGS_PX]
    side = min(2 * round(AROUND_PX / stride / 2) + 1, MOST_SIDE)
    by_noise = _median_around(noise, side)
    squares = []
    for lag in lags:
        both = [_median_around(d**2, side) for d in second_differences(t, lag)]
        squares.append(np.maximum(np.sqrt(both[0] * both[1]) / NORMAL**2 - 6 * by_noise, 0.05 * by_noise))
    with np.errstate(invalid="ignore", divide="ignore"):
        power = np.log(squares[1] / squares[0]) / np.log(lags[1] / lags[0])
    power = np.clip(np.nan_to_num(power, nan=1.0), LEAST_POWER, MOST_POWER)
    return LocalRoughness(
        power=power.astype(np.float32), square=np.nan_to_num(squares[0]).astype(np.float32), lag_px=lags[0] * stride
    )


def _per_strength(lag_px: float, power: float) -> float:
    """Mean square of second differences of a surface with c = 1."""
    return 8 * lag_px**power - 2 * (2 * lag_px) ** power


def _median_around(values: Array, side: int) -> Array:
    """(rows, columns) medians of positive values in squares of so many, to a twentieth; where unknown the usual one."""
    known = np.isfinite(values) & (values > 0)
    if not known.any():
        return np.zeros(values.shape, np.float32)
    usual = float(np.median(values[known]))
    level = np.where(known, np.log2(np.where(known, values, usual) / usual), 0)
    counted = np.clip(np.round(LEVELS * level) + 128, 0, 255).astype(np.uint8)
    return (usual * np.exp2((cv2.medianBlur(counted, side).astype(np.float32) - 128) / LEVELS)).astype(np.float32)


def second_differences(t: Array, lag: int) -> tuple[Array, Array]:
    """t(+lag) - 2 t + t(-lag) along rows and columns (rows, columns) each; NaN where one of them is not known."""
    found = np.full((2, *t.shape), np.nan, np.float32)
    if t.shape[1] > 2 * lag:
        found[0, :, lag:-lag] = t[:, 2 * lag :] + t[:, : -2 * lag] - 2 * t[:, lag:-lag]
    if t.shape[0] > 2 * lag:
        found[1, lag:-lag] = t[2 * lag :] + t[: -2 * lag] - 2 * t[lag:-lag]
    return found[0], found[1]


def of_window(response: Array, power: float) -> Array:
    """(...,) variance of a depth parameter for c = 1, by the responses (..., side^2) of its window."""
    side = round(response.shape[-1] ** 0.5)
    v, u = (x.ravel() for x in np.mgrid[:side, :side].astype(np.float32))
    r = np.hypot(u[:, None] - u, v[:, None] - v) ** np.float32(power)
    flat, found = response.reshape(-1, side * side), np.empty(response.shape[:-1], np.float32)
    for k in range(0, len(flat), CHUNK):
        weights = -flat[k : k + CHUNK]
        weights[:, side * side // 2] += 1
        found.reshape(-1)[k : k + CHUNK] = np.maximum(-((weights @ r) * weights).sum(axis=1), 0)
    return found


def misfits(t: Array, slopes: Array, stride: int, distance_px: float = APART_PX) -> Array:
    """(8, rows, columns) differences to eight neighbours so far away, less the mean of both slopes; NaN where unknown.

    Of a surface of second degree they are 0.
    """
    around = neighbours(stride, distance_px)
    found = np.empty((len(around), *t.shape), np.float32)
    for k, (v, u) in enumerate(around):
        a, b = (at_neighbour(s, v, u) + s for s in slopes)
        found[k] = at_neighbour(t, v, u) - t - 0.5 * stride * (u * a + v * b)
    return found


def neighbours(stride: int, distance_px: float = APART_PX) -> list[tuple[int, int]]:
    """Rows and columns of the grid to eight neighbours so far away."""
    far = max(1, round(distance_px / stride))
    return [(v, u) for v, u in product((-far, 0, far), repeat=2) if u or v]


def strips(rows: int, at_once: int, stride: int) -> list[tuple[int, int, int, int]]:
    """Rows from begin to end of a map, so many at once, and the first and last of their neighbours."""
    far = max(v for v, _ in neighbours(stride))
    return [(max(0, k - far), k, min(k + at_once, rows), min(k + at_once + far, rows)) for k in range(0, rows, at_once)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Witnesses:
    """What neighbours of each pixel of a map show of its variance: arrays (rows, columns) float32, squares of t."""

    misfit: Array
    """median of the squared misfits of eight neighbours"""
    near: Array
    """of near ones; where the grid has none of those so near as NEAR_PX, of its nearest"""
    bend: Array
    """median square of what slopes of eight neighbours differ by, over APART_PX: a plane fits no crease"""


def witnesses(t: Array, slopes: Array, stride: int) -> Witnesses:
    """Of a map and its slopes, by strips."""
    found = Witnesses(**{name: np.empty(t.shape, np.float32) for name in ("misfit", "near", "bend")})
    for first, begin, end, last in strips(len(t), ROWS, stride):
        own, part = slice(begin - first, end - first), slice(first, last)
        for into, distance in ((found.misfit, APART_PX), (found.near, NEAR_PX)):
            into[begin:end] = of_neighbours(misfits(t[part], slopes[:, part], stride, distance)[:, own])
        found.bend[begin:end] = of_neighbours(_bends(slopes[:, part], stride)[:, own])
    return found


def _bends(slopes: Array, stride: int) -> Array:
    """(8, rows, columns) lengths of the differences of slopes to eight neighbours, over APART_PX; NaN: unknown."""
    around = neighbours(stride)
    found = np.empty((len(around), *slopes.shape[1:]), np.float32)
    for k, (v, u) in enumerate(around):
        found[k] = APART_PX * np.hypot(*(at_neighbour(s, v, u) - s for s in slopes))
    return found


def at_neighbour(values: Array, v: int, u: int) -> Array:
    """(rows, columns) values v rows and u columns further; NaN beyond the map."""
    rows, columns = values.shape
    found = np.full(values.shape, np.nan, values.dtype)
    to = slice(max(0, -v), max(0, rows - max(0, v))), slice(max(0, -u), max(0, columns - max(0, u)))
    by = slice(max(0, v), max(0, rows - max(0, -v))), slice(max(0, u), max(0, columns - max(0, -u)))
    found[to] = values[by]
    return found


def of_neighbours(found: Array) -> Array:
    """(rows, columns) median of squared misfits (8, rows, columns); NaN where fewer than three are known."""
    known = np.isfinite(found).sum(axis=0)
    ordered = np.sort(found**2, axis=0)
    low, high = np.maximum(known - 1, 0) // 2, np.maximum(known, 1) // 2
    middle = [np.take_along_axis(ordered, np.minimum(k, len(found) - 1)[None], axis=0)[0] for k in (low, high)]
    return np.where(known >= FEWEST, (middle[0] + middle[1]) / 2, np.nan)


def local_factor(variance: Array, shown: Witnesses, residual: Array, brightness: Array) -> Array:
    """(rows, columns) by what the variance of a pixel differs from the one that theory gives; the mean, not the median.

    variance    by noise and the map's roughness; NaN where a pixel has no depth
    shown       by its neighbours
    residual    variance of grey values, by the residuals
    brightness  of the reference
    """
    known = np.isfinite(variance)
    logarithm = np.zeros(variance.shape, np.float32)
    with np.errstate(invalid="ignore", divide="ignore"):
        for values, exponent in ((shown.misfit, BY_MISFIT), (shown.near, BY_NEAR), (shown.bend, BY_BEND)):
            ratio = np.log(values / variance)
            there = np.isfinite(ratio) & known
            usual = np.median(ratio[there]) if there.any() else 0.0
            logarithm += np.where(there, exponent * (ratio - usual), 0)
        ratio = np.log(residual / (BEYOND * _usual(residual, brightness, known)))
    logarithm += np.where(np.isfinite(ratio) & known, BY_RESIDUAL * np.maximum(ratio, 0), 0)
    return np.where(known, np.exp(logarithm + np.float32(LEFT / 2)), np.nan)


def _usual(residual: Array, brightness: Array, known: Array) -> Array:
    """(rows, columns) median of the residuals' variances of pixels as bright."""
    if not known.any():
        return residual
    edges = np.unique(np.quantile(brightness[known], np.linspace(0, 1, BRIGHTNESSES + 1)))
    of = np.clip(np.searchsorted(edges, brightness, side="right") - 1, 0, max(len(edges) - 2, 0)).astype(np.uint8)
    at, middle = list[float](), list[float]()
    for k in range(max(len(edges) - 1, 1)):
        mine = known & (of == k)
        if mine.any():
            at.append(float(np.median(brightness[mine])))
            middle.append(float(np.median(residual[mine])))
    found = np.empty(residual.shape, np.float32)
    for k in range(0, len(found), ROWS):
        found[k : k + ROWS] = np.exp(np.interp(brightness[k : k + ROWS], at, np.log(np.maximum(middle, 1e-12))))
    return found
