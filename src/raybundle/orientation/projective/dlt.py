"""Direct linear transformation: an image of known points without any knowledge of the camera."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Array
from raybundle.numerics.least_squares import added, minimum
from raybundle.numerics.rotation import nearest_rotation


@dataclass(frozen=True, slots=True, kw_only=True)
class Dlt:
    """Eleven parameters and what they mean for a camera."""

    parameters: Array
    """(11,) L1 .. L11:  x = (L1 X + L2 Y + L3 Z + L4) / (L9 X + L10 Y + L11 Z + 1), y alike with L5 .. L8 [mm]"""
    covariance: Array
    """(11, 11) a-posteriori"""
    sigma0_mm: float
    """Standard deviation of an image coordinate [mm]; NaN without redundancy"""
    residuals_mm: Array
    """(n, 2) model - measured"""
    c: float
    """Camera constant [mm], mean of both axes"""
    x0: float
    y0: float
    affinity: float
    """Ratio of the camera constants in x and y, minus 1"""
    shear: float
    """Tangent of the deviation of the image axes from a right angle"""
    centre: Array
    """(3,) projection centre"""
    rotation: Array
    """(3, 3) object axes to image axes"""


def dlt(xy_mm: Array, xyz: Array) -> Dlt:
    """Direct linear transformation from six or more points that are not in a plane.

    xy_mm    (n, 2) image points, image frame
    xyz      (n, 3) object points
    raises   NoOrientation for fewer than six points or points (nearly) in a plane

    Abdel-Aziz and Karara 1971; coordinates normalised after Hartley 1997, then one weighted least squares solution
    of the fractions (Gauss-Newton on image residuals).  Lens distortion is not modelled: a start, not a calibration.
    """
    xy, X = np.asarray(xy_mm, float), np.asarray(xyz, float)
    n = len(X)
    if n < 6:
        raise NoOrientation("dlt.too_few_points", n=n)
    centre, spread = X.mean(axis=0), np.linalg.svd(X - X.mean(axis=0), compute_uv=False)
    if spread[2] < 1e-3 * spread[0]:
        raise NoOrientation("dlt.plane", ratio=spread[2] / spread[0])
    s3 = np.sqrt(3) / np.mean(np.linalg.norm(X - centre, axis=1))
    c2 = xy.mean(axis=0)
    s2 = np.sqrt(2) / np.mean(np.linalg.norm(xy - c2, axis=1))
    U, u = (X - centre) * s3, (xy - c2) * s2
    H = np.concatenate([U, np.ones((n, 1))], axis=1)
    A = np.zeros((2 * n, 12))
    A[0::2, :4], A[1::2, 4:8] = H, H
    A[0::2, 8:], A[1::2, 8:] = -u[:, :1] * H, -u[:, 1:] * H
    P = np.linalg.svd(A)[2][-1].reshape(3, 4)
    T2 = np.array([[1 / s2, 0, c2[0]], [0, 1 / s2, c2[1]], [0, 0, 1]])
    T3 = np.eye(4)
    T3[:3, :3] *= s3
    T3[:3, 3] = -s3 * centre
    P = T2 @ P @ T3
    L = (P / P[2, 3]).ravel()[:11]
    L, covariance, residuals, sigma0 = _refine(L, xy, X)
    return _interpret(L, covariance, residuals, sigma0, X)


def _refine(L: Array, xy: Array, X: Array) -> tuple[Array, Array, Array, float]:
    n = len(X)
    H = np.concatenate([X, np.ones((n, 1))], axis=1)

    def function(L: Array) -> tuple[Array, Array]:
        w = X @ L[8:] + 1
        model = np.stack([H @ L[:4] / w, H @ L[4:8] / w], axis=1)
        J = np.zeros((n, 2, 11))
        J[:, 0, :4] = H / w[:, None]
        J[:, 1, 4:8] = H / w[:, None]
        J[:, :, 8:] = -model[:, :, None] * (X / w[:, None])[:, None, :]
        return (model - xy).ravel(), J.reshape(-1, 11)

    found = minimum(function, L, added)
    scale = np.maximum(np.linalg.norm(found.jacobian, axis=0), 1e-300)
    N = (found.jacobian / scale).T @ (found.jacobian / scale)
    redundancy = 2 * n - 11
    sigma0 = float(np.sqrt(found.square_sum / redundancy)) if redundancy > 0 else float("nan")
    variance = sigma0**2 if redundancy > 0 else 1.0
    covariance = variance * np.linalg.inv(N) / np.outer(scale, scale)
    return found.values, covariance, found.residuals.reshape(n, 2), sigma0


def _interpret(L: Array, covariance: Array, residuals: Array, sigma0: float, X: Array) -> Dlt:
    P = np.append(L, 1.0).reshape(3, 4)
    M = P[:, :3]
    centre = -np.linalg.solve(M, P[:, 3])
    # x = K R (X - X0) / w with K upper triangular; R(2) = -view direction for points in front
    K, R = _rq(M)
    K = K / K[2, 2]
    # our image frame looks along -Z: the camera constants stand with a negative sign
    D = np.diag([-np.sign(K[0, 0]), -np.sign(K[1, 1]), 1.0])
    K, R = K @ D, D @ R
    if np.linalg.det(R) < 0:
        R = -R
    if np.mean((X - centre) @ R[2]) > 0:
        raise NoOrientation("dlt.behind")
    cx, cy = -K[0, 0], -K[1, 1]
    return Dlt(
        parameters=L, covariance=covariance, sigma0_mm=sigma0, residuals_mm=residuals,
        c=float((cx + cy) / 2), x0=float(K[0, 2]), y0=float(K[1, 2]), affinity=float(cx / cy - 1),
        shear=float(K[0, 1] / cx), centre=centre, rotation=nearest_rotation(R),
    )  # fmt: skip


def _rq(M: Array) -> tuple[Array, Array]:
    """Upper triangular times orthogonal."""
    q, r = np.linalg.qr(np.flipud(M).T)
    return np.fliplr(np.flipud(r.T)), np.flipud(q.T)
