"""Least squares with few unknowns: Gauss and Newton, damped where a step does not help.

For closed problems of some to some hundred unknowns: a calibration converted, a DLT, an empirical model.  Bundle
adjustment (`adjustment.system.solve`: sparse, with statistics) and windows of grey values (`targets`, `matching`:
thousands side by side in compiled code) have solvers of their own.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

from raybundle.numerics.arrays import Array

V = TypeVar("V")
FIRST_DAMPING, MOST_DAMPING, LEAST_DAMPING = 1e-3, 1e10, 1e-15
STILL = 1e-20
"""A step that changes the residuals by this share (squared) changes nothing."""
ROUNDING = 1e-30
"""The same, as a share of the squared residuals at the start, and of what the unknowns contribute to them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Minimum(Generic[V]):
    """Where the sum of squares is smallest."""

    values: V
    residuals: Array
    """(m,)"""
    jacobian: Array
    """(m, k) derivatives of the residuals by the step"""
    steps: int
    settled: bool
    """False: the steps ran out before"""

    @property
    def square_sum(self) -> float:
        """Sum of squares of the residuals."""
        return float(self.residuals @ self.residuals)


def minimum(
    function: Callable[[V], tuple[Array, Array]],
    start: V,
    moved: Callable[[V, Array], V],
    *,
    damping: float = 0.0,
    enough: float = 0.0,
    steps: int = 80,
    rcond: float | None = None,
) -> Minimum[V]:
    """Values with a smallest sum of squares, from a start in its neighbourhood.

    function  residuals (m,) and their derivatives (m, k) by a step, at values of any kind
    moved     the values after a step (k,): a sum, or a turn where a rotation is among them
    damping   at the start (Levenberg 1944, Marquardt 1963, with scaled columns); 0: Gauss and Newton as long as
              that helps
    enough    a step that lowers the sum of squares by a smaller share is the last; 0: until nothing changes
    rcond     singular values below this share of the largest count as none; None: rounding
    Limits: whether the minimum is the smallest of all, and whether the unknowns are determined: a step
    along what the residuals do not feel is the shortest one.
    """
    values, taken = start, 0
    with np.errstate(all="ignore"):
        residuals, J = function(values)
        first = before = _square(residuals)
        while taken < steps:
            taken += 1
            step, predicted = _step(residuals, J, damping, rcond)
            still = predicted <= STILL * before + ROUNDING * (first + _size(J, values))
            tried = moved(values, step)
            new, J_new = function(tried)
            after = _square(new)
            if not (after <= before and np.isfinite(J_new).all()):
                damping = damping * 10 if damping > 0 else FIRST_DAMPING
                if damping > MOST_DAMPING or still:
                    return Minimum(values=values, residuals=residuals, jacobian=J, steps=taken, settled=True)
                continue
            values, residuals, J = tried, new, J_new
            gain, before = before - after, after
            damping = max(damping / 10, LEAST_DAMPING) if damping > 0 else 0.0
            if still or (enough > 0 and gain <= enough * (before + gain) and damping < 1e-6):
                return Minimum(values=values, residuals=residuals, jacobian=J, steps=taken, settled=True)
    return Minimum(values=values, residuals=residuals, jacobian=J, steps=taken, settled=False)


def added(values: Array, step: Array) -> Array:
    """Numbers after a step: their sum."""
    return values + step


def _square(residuals: Array) -> float:
    square = float(residuals @ residuals)
    return square if math.isfinite(square) else math.inf


def _size(J: Array, values: object) -> float:
    """Squared contributions of the unknowns, from which residuals are differences: their rounding errors are of it."""
    return float(((J * values) ** 2).sum()) if isinstance(values, np.ndarray) and values.shape == J.shape[1:] else 0.0


def _step(residuals: Array, J: Array, damping: float, rcond: float | None) -> tuple[Array, float]:
    """The step (k,), and by how much, squared, it changes the residuals to first order."""
    scale = np.linalg.norm(J, axis=0)
    scale = np.where(scale > 0, scale, 1.0)
    A, b = J / scale, -residuals
    if damping > 0:
        k = J.shape[1]
        A, b = np.concatenate([A, math.sqrt(damping) * np.eye(k)]), np.concatenate([b, np.zeros(k)])
    step = np.linalg.lstsq(A, b, rcond=rcond)[0] / scale
    change = J @ step
    return step, float(change @ change)
