"""The fundamental matrix of two images of unknown interior orientation, by least squares and with its covariance.

Corresponding image points x1, x2 (homogeneous, pixel frame) lie on each other's epipolar lines: x2' F x1 = 0, with F of
rank 2 and unknown scale: seven parameters.  Adjusted is the condition with corrections to all four coordinates
(Gauss-Helmert; Förstner and Wrobel 2016, section 13.2), F = U diag(cos a, sin a, 0) V' (Bartoli and Sturm 2004).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rotation import cross_matrix, rotation_from_vector

LEAST = 8
"""Points from which on there is redundancy."""
CRITICAL = 4.0
"""Normalised residual from which a correspondence is left out."""
FLAT = 0.9
"""Share of the correspondences that one homography explains from which they say nothing about F."""
STEP = 1e-2
"""Step of numeric derivatives in standard deviations."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FundamentalMatrix:
    """The fundamental matrix F of two images, x2' F x1 = 0 in the pixel frame.

    It does not show whether lenses distort: distortion of some pixels ends in F and in the residuals.
    """

    matrix: Array
    """(3, 3), rank 2, Frobenius norm 1"""
    covariance: Array
    """(9, 9) of its elements row by row, rank 7, with the a-posteriori sigma0"""
    inliers: Mask
    """(n,) correspondences that took part"""
    w: Array
    """(n,) normalised residuals of the condition; NaN where a correspondence took no part"""
    sigma0: float
    redundancy: int
    planar_share: float
    """Share of the correspondences that one homography explains: near 1, F is badly determined."""

    @property
    def epipoles(self) -> Array:
        """(2, 2) image of the second projection centre in the first image and of the first in the second [px]."""
        u, _, vt = np.linalg.svd(self.matrix)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.stack([vt[2, :2] / vt[2, 2], u[:2, 2] / u[2, 2]])

    def lines(self, first_px: Array) -> Array:
        """Epipolar lines (n, 3) in the second image of points (n, 2) in the first, a x + b y + c = 0, a^2 + b^2 = 1."""
        line = np.concatenate([first_px, np.ones((len(first_px), 1))], axis=1) @ self.matrix.T
        return line / np.linalg.norm(line[:, :2], axis=1)[:, None]

    def camera_constants(self, principal_px: Array) -> tuple[Array, Array]:
        """Camera constants (2,) [px] of both images and their covariance (2, 2), principal points (2, 2) [px] given.

        Bougnoux 1998, equation for the focal length.  NaN where F gives none: where the viewing directions meet or
        are parallel, as in a parallel stereo pair, and near such arrangements the standard deviation is large.
        Not in it: what the principal points are wrong by.
        """
        point = np.concatenate([principal_px, np.ones((2, 1))], axis=1)

        def constants(F: Array) -> Array:
            return np.array([_constant(F, point[0], point[1]), _constant(F.T, point[1], point[0])])

        # along the axes of the correlations: the elements of F differ by orders of magnitude
        std = np.sqrt(np.diagonal(self.covariance))
        values, axes = np.linalg.eigh(self.covariance / std / std[:, None])
        steps = (std[:, None] * axes * np.sqrt(np.maximum(values, 0.0)) * STEP).T.reshape(9, 3, 3)
        across = [(constants(self.matrix + d) - constants(self.matrix - d)) / (2 * STEP) for d in steps]
        J = np.stack(across, axis=1)
        return constants(self.matrix), J @ J.T


def fundamental_matrix(first_px: Array, second_px: Array, *, sigma_px: float) -> FundamentalMatrix:
    """The fundamental matrix of corresponding image points (n, 2), (n, 2) [px] of this standard deviation.

    raises  NoOrientation with fewer than 8 points that agree, or where a homography explains them: object in a
            plane, or images from one place
    """
    import poselib

    first, second = (np.ascontiguousarray(v, dtype=float) for v in (first_px, second_px))
    n = len(first)
    if n < LEAST:
        raise NoOrientation("fundamental.too_few_points", n=n, least=LEAST)
    middle, size = np.stack([first.mean(axis=0), second.mean(axis=0)]), float(np.ptp(first, axis=0).max()) / 2
    if not size > 0:
        raise NoOrientation("fundamental.one_point")
    limit = CRITICAL * sigma_px
    options: dict[str, Any] = {
        "max_epipolar_error": limit,
        "max_reproj_error": limit,
        "max_iterations": 5000,
        "seed": 1,
    }
    _, found = poselib.estimate_fundamental(first - middle[0], second - middle[1], options, {})
    _, plane = poselib.estimate_homography(first - middle[0], second - middle[1], options, {})
    inliers = np.asarray(found["inliers"], bool)
    if inliers.sum() < LEAST:
        raise NoOrientation(
            "fundamental.too_few_inliers", n=int(inliers.sum()), total=n, least=LEAST, sigma_px=sigma_px
        )
    share = float(np.mean(np.asarray(plane["inliers"], bool)[inliers]))
    if share > FLAT:
        raise NoOrientation("fundamental.homography", share=share, limit=FLAT)
    p, q = (first - middle[0]) / size, (second - middle[1]) / size
    state, w = _adjusted(p, q, inliers, sigma_px / size)
    for _ in range(10):
        kept = np.abs(w) < CRITICAL
        if kept.sum() < LEAST or (kept == inliers).all():
            break
        inliers = kept
        state, w = _adjusted(p, q, inliers, sigma_px / size)
    T = [np.array([[1 / size, 0, -m[0] / size], [0, 1 / size, -m[1] / size], [0, 0, 1]]) for m in middle]
    to_px = np.kron(T[1].T, T[0].T)
    raw = to_px @ state.F.ravel()
    norm = float(np.linalg.norm(raw))
    scaled = (np.eye(9) - np.outer(raw, raw) / norm**2) / norm @ to_px @ state.by_parameters
    return FundamentalMatrix(
        matrix=(raw / norm).reshape(3, 3),
        covariance=scaled @ state.covariance @ scaled.T,
        inliers=inliers,
        w=np.where(inliers, w, np.nan),
        sigma0=state.sigma0,
        redundancy=int(inliers.sum()) - 7,
        planar_share=share,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class _State:
    F: Array
    by_parameters: Array
    """(9, 7)"""
    covariance: Array
    """(7, 7)"""
    sigma0: float


def _adjusted(p: Array, q: Array, inliers: Mask, sigma: float) -> tuple[_State, Array]:
    """F of the inliers in scaled coordinates, and normalised residuals (n,) of all points."""
    a, b = p[inliers], q[inliers]
    u, d, vt = np.linalg.svd(_eight_points(a, b))
    U, V, angle = u * np.sign(np.linalg.det(u)), vt.T * np.sign(np.linalg.det(vt)), float(np.arctan2(d[1], d[0]))
    observed = np.concatenate([a, b], axis=1)
    at = observed.copy()
    N, w0, M = np.eye(7), np.zeros(len(a)), np.ones(len(a))
    for _ in range(50):
        F, by = _matrix(U, V, angle)
        A, B, f = _condition(F, by, at)
        w0 = f + np.einsum("nk,nk->n", B, observed - at)
        M = sigma**2 * np.einsum("nk,nk->n", B, B)
        N = (A / M[:, None]).T @ A
        step = -np.linalg.solve(N, A.T @ (w0 / M))
        at = observed - sigma**2 * B * ((w0 + A @ step) / M)[:, None]
        U, V, angle = (
            U @ rotation_from_vector(step[None, :3])[0],
            V @ rotation_from_vector(step[None, 3:6])[0],
            angle + step[6],
        )
        if step @ N @ step < 1e-12 * 7:
            break
    F, by = _matrix(U, V, angle)
    redundancy = len(a) - 7
    v = (observed - at) / sigma
    sigma0 = float(np.sqrt((v**2).sum() / redundancy)) if redundancy > 0 else np.nan
    covariance = np.linalg.inv(N)
    every = np.concatenate([p, q], axis=1)
    A, B, f = _condition(F, by, every)
    M = sigma**2 * np.einsum("nk,nk->n", B, B)
    own = np.einsum("ni,ij,nj->n", A, covariance, A)
    w = f / np.sqrt(np.where(inliers, np.maximum(M - own, 1e-9 * M), M + own))
    scale = sigma0**2 if np.isfinite(sigma0) else 1.0
    return _State(F=F, by_parameters=by, covariance=covariance * scale, sigma0=sigma0), w


def _matrix(U: Array, V: Array, angle: float) -> tuple[Array, Array]:
    """F and its derivatives (9, 7) by small rotations of U and V and by the angle."""
    D = np.diag([np.cos(angle), np.sin(angle), 0.0])
    units = cross_matrix(np.eye(3))
    parts = [U @ units[k] @ D @ V.T for k in range(3)]
    parts += [-U @ D @ units[k] @ V.T for k in range(3)]
    parts.append(U @ np.diag([-np.sin(angle), np.cos(angle), 0.0]) @ V.T)
    return U @ D @ V.T, np.stack([m.ravel() for m in parts], axis=1)


def _condition(F: Array, by: Array, at: Array) -> tuple[Array, Array, Array]:
    """Derivatives (n, 7) by the parameters and (n, 4) by the coordinates, and the condition (n,)."""
    one = np.ones((len(at), 1))
    p, q = np.concatenate([at[:, :2], one], axis=1), np.concatenate([at[:, 2:], one], axis=1)
    outer = (q[:, :, None] * p[:, None, :]).reshape(-1, 9)
    B = np.concatenate([(q @ F)[:, :2], (p @ F.T)[:, :2]], axis=1)
    return outer @ by, B, outer @ F.ravel()


def _eight_points(p: Array, q: Array) -> Array:
    one = np.ones((len(p), 1))
    outer = np.concatenate([q, one], axis=1)[:, :, None] * np.concatenate([p, one], axis=1)[:, None, :]
    _, vectors = np.linalg.eigh(outer.reshape(-1, 9).T @ outer.reshape(-1, 9))
    return vectors[:, 0].reshape(3, 3)


def _constant(F: Array, p: Array, q: Array) -> float:
    """Camera constant of the first image by Bougnoux' formula; NaN where it has none."""
    e = np.linalg.svd(F)[0][:, 2]
    flat = np.diag([1.0, 1.0, 0.0])
    left = q @ cross_matrix(e) @ flat @ F
    square = -(left @ p) * (p @ F.T @ q) / (left @ flat @ F.T @ q)
    return float(np.sqrt(square)) if square > 0 else np.nan
