"""Elementary functions that accept NumPy arrays and SymPy expressions alike.

A sensor model's condition is written with these, so that one text is evaluated and derived.
SymPy is touched only if an argument already is a SymPy expression.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

Scalar: TypeAlias = Any
"""A float, a float array of any shape, or a SymPy expression."""


def _symbolic(value: Scalar) -> bool:
    return hasattr(value, "free_symbols")


def sin(x: Scalar) -> Scalar:
    """Sine."""
    if _symbolic(x):
        import sympy

        return sympy.sin(x)
    return np.sin(x)


def cos(x: Scalar) -> Scalar:
    """Cosine."""
    if _symbolic(x):
        import sympy

        return sympy.cos(x)
    return np.cos(x)


def sqrt(x: Scalar) -> Scalar:
    """Square root."""
    if _symbolic(x):
        import sympy

        return sympy.sqrt(x)
    return np.sqrt(x)


def angle_ratio(r2: Scalar, w: Scalar) -> Scalar:
    """atan2(r, w) / r as a function of r**2 and w: smooth at r = 0 for w > 0."""
    if _symbolic(r2):
        from raybundle.numerics.angle_ratio import AngleRatio

        return AngleRatio(r2, w)
    return AngleRatio_numpy(r2, w)


def AngleRatio_numpy(r2: Any, w: Any) -> Any:
    """NumPy form of `angle_ratio`."""
    r2, w = np.broadcast_arrays(np.asarray(r2, dtype=float), np.asarray(w, dtype=float))
    small = (r2 < 1e-8 * w * w) & (w > 0)
    safe_w = np.where(small, w, 1.0)
    r = np.sqrt(np.where(small, 1.0, r2))
    series = (1 - r2 / (3 * safe_w * safe_w)) / safe_w
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(small, series, np.arctan2(r, w) / r)


def AngleRatioSlope_numpy(r2: Any, w: Any) -> Any:
    """Derivative of `angle_ratio` by r**2."""
    r2, w = np.broadcast_arrays(np.asarray(r2, dtype=float), np.asarray(w, dtype=float))
    small = (r2 < 1e-4 * w * w) & (w > 0)
    safe_w = np.where(small, w, 1.0)
    q = r2 / (safe_w * safe_w)
    # d/dr2 of (1/w)(1 - q/3 + q^2/5 - q^3/7 + q^4/9)
    series = (-1 / 3 + q * (2 / 5 - q * (3 / 7 - q * (4 / 9 - q * 5 / 11)))) / safe_w**3
    safe = np.where(small, 1.0, r2)
    with np.errstate(divide="ignore", invalid="ignore"):
        exact = (w / (safe + w * w) - AngleRatio_numpy(safe, w)) / (2 * safe)
    return np.where(small, series, exact)
