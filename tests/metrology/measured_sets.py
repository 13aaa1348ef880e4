"""Sets of points measured twice, with full covariances, for the tests of this folder."""

import numpy as np

from raybundle.metrology.point_set import PointSet, datum_directions
from raybundle.numerics.rotation import rotation_from_vector

TURN = rotation_from_vector(np.array([[0.5, -1.0, 2.0]]))[0]


def places(count=60, seed=1):
    return np.random.default_rng(seed).uniform(-1, 1, (count, 3)) * [3, 2, 1]


def free_covariance(xyz, rng, size=1e-5, *, scale=False):
    """Of a free network: correlated, of unequal sizes, singular by the datum."""
    u = 3 * len(xyz)
    A = rng.normal(size=(u, 2 * u))
    s = rng.uniform(0.5, 2, u) * size
    C = A @ A.T / (2 * u) * np.outer(s, s)
    G = datum_directions(xyz, scale=scale).reshape(u, -1)
    P = np.eye(u) - G @ np.linalg.pinv(G)
    return P @ C @ P


def root_of(covariance):
    size, way = np.linalg.eigh(covariance)
    return way * np.sqrt(np.maximum(size, 0))


def drawn(name, xyz, covariance, root, rng, turn=None, shift=(0, 0, 0), **more):
    """A measurement with errors of this covariance, in axes of its own."""
    n = len(xyz)
    met = xyz + (root @ rng.normal(size=3 * n)).reshape(n, 3)
    R = np.eye(3) if turn is None else turn
    T = np.kron(np.eye(n), R)
    ids = tuple(f"P{k + 1}" for k in range(n))
    return PointSet(name=name, ids=ids, xyz=met @ R.T + shift, covariance=T @ covariance @ T.T, **more)
