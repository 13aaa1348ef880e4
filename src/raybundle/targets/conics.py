"""Conics A x^2 + B x y + C y^2 + D x + E y = 1: through points, about a centre, how far points are from them."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Mask


def conics(p: Array, w: Array) -> Array:
    """Conics (..., 5) through points (..., k, 2) with weights (..., k)."""
    x, y = p[..., 0], p[..., 1]
    J = np.stack([x * x, x * y, y * y, x, y], axis=-1)
    JW = J * w[..., None]
    N = np.einsum("...ki,...kj->...ij", JW, J) + 1e-9 * np.eye(5)
    return np.linalg.solve(N, JW.sum(axis=-2)[..., None])[..., 0]


def algebraic(a: Array, p: Array) -> Array:
    """A x^2 + B x y + C y^2 + D x + E y - 1 (..., k) of points (..., k, 2) and conics (..., 5)."""
    x, y = p[..., 0], p[..., 1]
    A, B, C, D, E = (k[..., None] for k in np.moveaxis(a, -1, 0))
    return A * x * x + B * x * y + C * y * y + D * x + E * y - 1


def sampson(a: Array, p: Array) -> Array:
    """Distances (..., k) of points (..., k, 2) from conics (..., 5), to first order.  Sampson 1982."""
    x, y = p[..., 0], p[..., 1]
    A, B, C, D, E = (k[..., None] for k in np.moveaxis(a, -1, 0))
    return abs(algebraic(a, p)) / np.maximum(np.hypot(2 * A * x + B * y + D, B * x + 2 * C * y + E), 1e-9)


def matrix(a: Array) -> Array:
    """M (n, 2, 2), the quadratic part of conics (n, 5)."""
    return np.stack([a[:, 0], a[:, 1] / 2, a[:, 1] / 2, a[:, 2]], axis=1).reshape(-1, 2, 2)


def centred(a: Array, regular: Mask) -> tuple[Array, Array, Array]:
    """M (n, 2, 2), centre (n, 2), k (n,) with (x - centre)' M (x - centre) = k; M is the unit where not `regular`."""
    M = np.where(regular[:, None, None], matrix(a), np.eye(2))
    c = -0.5 * np.linalg.solve(M, a[:, 3:, None])[..., 0]
    return M, c, 1 + np.einsum("ni,nij,nj->n", c, M, c)
