"""Rotations from object axes to image axes, and their angles.

R = R3(kappa) R2(phi) R1(omega) turns the object axes into the image axes, so that
(U, V, W) = R (X - X0).  A small rotation `delta` acts on the left: R_new = exp([delta]x) R.
"""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array


def rotation_from_angles(angles: Array) -> Array:
    """Rotation matrices (..., 3, 3) of omega, phi, kappa (..., 3) [rad]."""
    angles = np.asarray(angles, dtype=float)
    so, co = np.sin(angles[..., 0]), np.cos(angles[..., 0])
    sp, cp = np.sin(angles[..., 1]), np.cos(angles[..., 1])
    sk, ck = np.sin(angles[..., 2]), np.cos(angles[..., 2])
    rows = [
        [ck * cp, ck * sp * so + sk * co, -ck * sp * co + sk * so],
        [-sk * cp, -sk * sp * so + ck * co, sk * sp * co + ck * so],
        [sp, -cp * so, cp * co],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def angles_from_rotation(rotation: Array) -> Array:
    """Angles omega, phi, kappa (..., 3) [rad] of rotation matrices (..., 3, 3); phi in [-pi/2, pi/2].

    At phi = +-90 degrees omega and kappa turn about the same axis; omega is then set to zero.
    """
    R = np.asarray(rotation, dtype=float)
    phi = np.arctan2(R[..., 2, 0], np.hypot(R[..., 0, 0], R[..., 1, 0]))
    locked = np.hypot(R[..., 0, 0], R[..., 1, 0]) < 1e-12
    omega = np.where(locked, 0.0, np.arctan2(-R[..., 2, 1], R[..., 2, 2]))
    kappa = np.where(locked, np.arctan2(R[..., 0, 1], R[..., 1, 1]), np.arctan2(-R[..., 1, 0], R[..., 0, 0]))
    return np.stack([omega, phi, kappa], axis=-1)


def angle_derivatives(rotation: Array) -> Array:
    """D (omega, phi, kappa) / d delta, (..., 3, 3), at rotation matrices (..., 3, 3).

    The sign follows R_new = exp([delta]x) R with R = R3 R2 R1 turning axes, not vectors.
    Infinite at phi = +-90 degrees, where the angles are not defined one by one.
    """
    angles = angles_from_rotation(rotation)
    sp, cp = np.sin(angles[..., 1]), np.cos(angles[..., 1])
    sk, ck = np.sin(angles[..., 2]), np.cos(angles[..., 2])
    zero, one = np.zeros_like(sp), np.ones_like(sp)
    # dR R' = -[w]x with w = e3 dkappa + R3 e2 dphi + R3 R2 e1 domega, hence delta = -w
    columns = [[ck * cp, sk, zero], [-sk * cp, ck, zero], [sp, zero, one]]
    return np.linalg.inv(-np.moveaxis(np.array(columns), (0, 1), (-2, -1)))


def rotation_from_vector(vector: Array) -> Array:
    """exp([v]x): rotation matrices (..., 3, 3) of rotation vectors (..., 3) [rad] (Rodrigues)."""
    v = np.asarray(vector, dtype=float)
    angle2 = np.sum(v * v, axis=-1)[..., None, None]
    angle = np.sqrt(angle2)
    small = angle2 < 1e-8
    safe = np.where(small, 1.0, angle)
    a = np.where(small, 1 - angle2 / 6, np.sin(safe) / safe)
    b = np.where(small, 0.5 - angle2 / 24, (1 - np.cos(safe)) / (safe * safe))
    K = cross_matrix(v)
    return np.eye(3) + a * K + b * (K @ K)


def vector_from_rotation(rotation: Array) -> Array:
    """Rotation vectors (..., 3) [rad] of rotation matrices (..., 3, 3), length in [0, pi]."""
    from scipy.spatial.transform import Rotation

    R = np.asarray(rotation, dtype=float)
    return Rotation.from_matrix(R.reshape(-1, 3, 3)).as_rotvec().reshape(R.shape[:-1])


def left_jacobian(vector: Array) -> Array:
    """J (..., 3, 3) of exp([v + d]x) = exp([J d]x) exp([v]x) to first order in d, for rotation vectors (..., 3)."""
    v = np.asarray(vector, dtype=float)
    angle2 = np.sum(v * v, axis=-1)[..., None, None]
    small = angle2 < 1e-6
    safe = np.where(small, 1.0, np.sqrt(angle2))
    a = np.where(small, 0.5 - angle2 / 24, (1 - np.cos(safe)) / safe**2)
    b = np.where(small, 1 / 6 - angle2 / 120, (safe - np.sin(safe)) / safe**3)
    K = cross_matrix(v)
    return np.eye(3) + a * K + b * (K @ K)


def cross_matrix(vector: Array) -> Array:
    """[v]x (..., 3, 3) of vectors (..., 3), so that [v]x w = v x w."""
    v = np.asarray(vector, dtype=float)
    found = np.zeros((*v.shape, 3))
    found[..., 2, 1], found[..., 0, 2], found[..., 1, 0] = v[..., 0], v[..., 1], v[..., 2]
    return found - np.swapaxes(found, -2, -1)


def nearest_rotation(matrix: Array) -> Array:
    """The rotation matrices (..., 3, 3) nearest to the matrices (..., 3, 3) (Frobenius norm; Higham 1989)."""
    u, _, vt = np.linalg.svd(matrix)
    flip = np.ones((*u.shape[:-2], 3))
    flip[..., 2] = np.linalg.det(u @ vt)
    return (u * flip[..., None, :]) @ vt


def rotation_between(u: Array, v: Array) -> Array:
    """The smallest rotation (3, 3) that brings a unit vector u (3,) onto v (3,)."""
    axis = np.cross(u, v)
    if np.linalg.norm(axis) < 1e-9:
        if u @ v > 0:
            return np.eye(3)
        across = np.linalg.svd(u[None])[2][1]
        return 2 * np.outer(across, across) - np.eye(3)
    angle = np.arctan2(np.linalg.norm(axis), u @ v)
    return rotation_from_vector((angle * axis / np.linalg.norm(axis))[None])[0]
