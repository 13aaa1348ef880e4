"""The similarity that moves points onto given coordinates within an open datum, from sums over them."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.system.datum import Datum
from raybundle.numerics.arrays import Array

STEPS = 50


def onto(own: Array, given: Array, datum: Datum) -> Array:
    """The similarity of the open generators that brings points as near as can be to given coordinates.

    own    (4, 4) sum of (r, 1)(r, 1)', r the points from the centre of the datum
    given  (3, 4) sum of g (r, 1)', g their given coordinates from there
    returns  (4, 4) homogeneous, of coordinates from the centre

    Small transformations are repeated until nothing moves (`adjustment.system.transformation.fit_to_given`): all that
    they need of the points are these sums.
    """
    from scipy.linalg import expm

    M = _generators(datum)
    A = np.eye(4)  # r -> A r, homogeneous, from the centre
    for _ in range(STEPS):
        S, H = A @ own @ A.T, given @ A.T
        N = np.einsum("aij,jk,alk->il", M, S, M)
        n = np.einsum("aij,aj->i", M, H - S[:3])
        basis = datum.basis
        step = basis @ np.linalg.lstsq(basis.T @ N @ basis, basis.T @ n, rcond=None)[0]
        step /= max(1.0, np.abs(step).max())  # in parts, where a block is to become many times larger
        t, w, s = step[:3] * datum.extent, step[3:6], step[6]
        generator = np.zeros((4, 4))
        generator[:3, :3] = np.array([[s, -w[2], w[1]], [w[2], s, -w[0]], [-w[1], w[0], s]])
        generator[:3, 3] = t
        A = expm(generator) @ A
        if np.abs(step).max() < 1e-13:
            break
    return A


def _generators(datum: Datum) -> Array:
    """(3, 7, 4) the seven generators of coordinate a as linear functions of (r, 1)."""
    M = np.zeros((3, 7, 4))
    M[[0, 1, 2], [0, 1, 2], 3] = datum.extent
    M[1, 3, 2], M[2, 3, 1] = -1.0, 1.0
    M[0, 4, 2], M[2, 4, 0] = 1.0, -1.0
    M[0, 5, 1], M[1, 5, 0] = -1.0, 1.0
    M[[0, 1, 2], 6, [0, 1, 2]] = 1.0
    return M
