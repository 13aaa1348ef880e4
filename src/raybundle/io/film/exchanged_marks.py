"""Fiducial marks that do not lie as their certificate states: which of them seem exchanged."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from raybundle.errors import Message, message
from raybundle.numerics.arrays import Array

LARGEST_RESIDUAL_MM = 1.0
"""No film and no scanner deforms by so much; larger residuals are wrong names or wrong measurements."""
LARGEST_SHEAR, LARGEST_RATIO = 0.05, 1.1
"""Deviation from the right angle [rad], and stretch along one axis by that along the other, that no film shows."""
TRIED = 60
"""Marks with the largest residuals among which exchanges are tried."""


def implausible(residuals_mm: Array, affine: Array | None) -> Message | None:
    """Why a fit of marks cannot be that of a film; None where it can.

    residuals_mm  (n, 2)
    affine        (2, 2) derivatives of the camera's frame by the scan's, in the same unit; None: any shape will do
    """
    worst = float(np.linalg.norm(residuals_mm, axis=1).max(initial=0.0))
    if worst > LARGEST_RESIDUAL_MM:
        return message("film.residuals", worst_mm=worst, limit_mm=LARGEST_RESIDUAL_MM)
    if affine is None:
        return None
    ratio, shear = _shape(affine)
    if ratio > LARGEST_RATIO:
        return message("film.stretch", ratio=ratio, limit=LARGEST_RATIO)
    if shear > LARGEST_SHEAR:
        return message("film.shear", shear_deg=float(np.degrees(shear)), limit_deg=float(np.degrees(LARGEST_SHEAR)))
    return None


def exchanges(names: Sequence[str], uv: Array, target: Array) -> tuple[tuple[str, str], ...]:
    """Pairs of marks whose exchange makes a film of what was none, the best first; at most three.

    uv, target  (n, 2) measured, and in the camera [mm]
    With three marks every exchange fits without residuals; only the shape of the film can speak against it.
    """
    v = _residuals(uv, target)[0]
    among = (
        np.sort(np.argsort(-np.linalg.norm(v, axis=1), kind="stable")[:TRIED]) if len(uv) > 3 else np.arange(len(uv))
    )
    found: list[tuple[float, tuple[str, str]]] = []
    for i, j in combinations(among.tolist(), 2):
        order = np.arange(len(uv))
        order[[i, j]] = j, i
        v, affine = _residuals(uv, target[order])
        if not implausible(v, affine):
            found.append((float(np.sqrt(np.mean(v**2))), (min(names[i], names[j]), max(names[i], names[j]))))
    found.sort(key=lambda f: f[0])
    least = max(found[0][0], 1e-3) if found else 0.0
    return tuple(pair for rms, pair in found if rms < 3 * least)[:3]


def wrong_mark(names: Sequence[str], uv: Array, target: Array) -> tuple[str, float] | None:
    """The one mark without which the others make a film, and its misfit [mm]; None where there is none."""
    if len(uv) < 5:
        return None
    found: list[tuple[float, tuple[str, float]]] = []
    for k in range(len(uv)):
        others = np.arange(len(uv)) != k
        v, affine = _residuals(uv[others], target[others])
        if implausible(v, affine):
            continue
        middle = uv[others].mean(axis=0)
        there = target[others].mean(axis=0) + affine @ (uv[k] - middle)
        off = float(np.linalg.norm(there - target[k]))
        found.append((float(np.sqrt(np.mean(v**2))), (names[k], off)))
    return min(found)[1] if found else None


def _residuals(uv: Array, target: Array) -> tuple[Array, Array]:
    """Residuals (n, 2) of the affine transformation by least squares, and its linear part (2, 2)."""
    u, x = uv - uv.mean(axis=0), target - target.mean(axis=0)
    solved = np.linalg.lstsq(u, x, rcond=None)[0]
    return u @ solved - x, solved.T


def _shape(affine: Array) -> tuple[float, float]:
    """Stretch of one axis by the other, at least 1, and deviation from the right angle [rad]."""
    x, y = affine
    lengths = np.hypot(*x), np.hypot(*y)
    if min(lengths) == 0:
        return float("inf"), 0.0
    return float(max(lengths) / min(lengths)), abs(float(np.arcsin(np.clip(x @ y / (lengths[0] * lengths[1]), -1, 1))))
