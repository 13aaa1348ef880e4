"""Ground points of image points of an RPC at given heights: its two ratios solved for longitude and latitude.

Everything is in the RPC's centred and scaled coordinates, where rounding does not depend on how small the scene is.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from raybundle.numerics.arrays import Array

Ratios = Callable[[Array], tuple[Array, Array, Array]]
"""u, v (n, 2) of L, P, H (n, 3), their derivatives (n, 2, 2) by L and P, and the smaller of the two denominators (n,)
relative to the centre."""
SETTLED, FLOOR = 1e-15 * 16, 1e-11
"""Misfit at which a point is found at once; and below which it is found when the misfit shrinks no more."""
LONGEST = 0.5
"""Longest step, in halves of the scene."""
ITERATIONS = 60
SHORTEST = 2.0**-12
"""Part of a step down to which it is tried; if none lessens the misfit there is no ground point this way."""
FAR = 3.0
"""Halves of the scene, and half of its own distance, by which a point may lie from where straight rays put it."""
STRETCHES = (1, 8, 64)
"""Into how many stretches the way from the middle height is cut, one after the other."""
LEAST_DENOMINATOR = 1e-3
"""Share of its value at the centre below which a denominator counts as zero; what lies beyond is no ground point."""


def ground_points(ratios: Ratios, uv: Array, H: Array) -> Array:
    """L, P (n, 2) where the ratios are u, v (n, 2) at heights H (n,); NaN where there is no such point.

    Newton's method with steps that must lessen the misfit; where that fails from the middle of the scene, the point
    is followed along its ray, from the middle height in more and more stretches.
    """
    found = np.full(uv.shape, np.nan)
    left = np.arange(len(uv))
    for stretches in STRETCHES:
        at = np.zeros((len(left), 2))
        slope = np.zeros((len(left), 2))
        for k in range(1, stretches + 1):
            start = np.where(np.isfinite(at + slope), at + slope, 0.0)
            reached = _newton(ratios, uv[left], H[left] * (k / stretches), start)
            slope, at = (np.zeros_like(at) if k == 1 else reached - at), reached
        found[left] = at
        left = left[np.isnan(at[:, 0])]
        if not len(left):
            break
    found[~(np.abs(found - _expected(ratios, uv, H)).max(axis=1) < FAR + np.abs(found).max(axis=1) / 2)] = np.nan
    return found


def _expected(ratios: Ratios, uv: Array, H: Array) -> Array:
    """L, P (n, 2) by the ratios' derivatives at the centre."""
    seen, J, _ = ratios(np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1e-4]]))
    back = np.linalg.pinv(J[0])
    return (uv - seen[0] - H[:, None] * (seen[1] - seen[0]) / 1e-4) @ back.T


def _newton(ratios: Ratios, uv: Array, H: Array, start: Array) -> Array:
    """L, P (n, 2) by Newton's method from a start; NaN where it found none."""
    at = np.column_stack([start, H])
    found = np.full(uv.shape, np.nan)
    left = np.arange(len(uv))
    miss, step, part = np.full(len(uv), np.inf), np.zeros((len(uv), 2)), np.ones(len(uv))
    for _ in range(ITERATIONS):
        trial = at[left]
        trial[:, :2] += part[left, None] * step[left]
        seen, J, denominator = ratios(trial)
        with np.errstate(all="ignore"):
            apart = uv[left] - seen
            size = np.where(denominator > LEAST_DENOMINATOR, np.abs(apart).max(axis=1), np.inf)
            full = _step(J, apart)
        better = size < miss[left]
        # at the floor of rounding the misfit no longer shrinks
        done = (better & (size < SETTLED)) | ((np.minimum(size, miss[left]) < FLOOR) & ~(size < 0.5 * miss[left]))
        rows = left[better]
        at[rows], miss[rows], step[rows], part[rows] = trial[better], size[better], full[better], 1.0
        part[left[~better]] /= 2
        found[left[done]] = at[left[done], :2]
        lost = (part[left] < SHORTEST) | ~np.isfinite(step[left]).all(axis=1) | np.isinf(miss[left])
        left = left[~done & ~lost]
        if not len(left):
            break
    return found


def _step(J: Array, apart: Array) -> Array:
    """Newton's steps (n, 2), shortened to `LONGEST`; NaN where the derivatives are singular."""
    det = J[:, 0, 0] * J[:, 1, 1] - J[:, 0, 1] * J[:, 1, 0]
    step = np.stack(
        [
            (J[:, 1, 1] * apart[:, 0] - J[:, 0, 1] * apart[:, 1]) / det,
            (J[:, 0, 0] * apart[:, 1] - J[:, 1, 0] * apart[:, 0]) / det,
        ],
        axis=1,
    )
    longest = np.abs(step).max(axis=1, keepdims=True)
    return step * np.minimum(1.0, LONGEST / np.maximum(longest, 1e-300))
