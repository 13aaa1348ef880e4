"""Least-squares matching: an image point measured again in another image, to a few hundredths of a pixel.

The window of a reference image is brought onto the target image by an affine map (Förstner 1982; Ackermann 1984; Gruen
1985), brightness, contrast and a slope of the illumination free: without the slope the fall-off of light towards the
corners moves points by a hundredth of a pixel, all of them outwards, and that looks like distortion.  Iterated
in the inverse-compositional form (Baker and Matthews 2004), in which the normal equations belong to the reference
window and stay.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np

from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index

UNKNOWNS = 10
FIGURES = 14
"""Of `WindowMatches.residual`"""
PARTS = 3
"""Of a window along a side, each of which may be displaced by itself."""
NOISE_SIGMA_PX = 0.6
"""White noise after the smoothing of `smoothed` and `halved` correlates as exp(-d^2 / (4 sigma^2)) at a distance d."""
LEAST_SHARE = 0.2
"""Share of the gradients' information below which it may be noise: the variance is 25 times the naive one."""


class Outcome(IntEnum):
    """What became of a point."""

    MATCHED = 0
    OUTSIDE = 1
    FLAT = 2
    MOVED = 3
    UNSTEADY = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class WindowOptions:
    """The window and the iteration."""

    half: int = 8
    """window of (2 half + 1)^2 positions, one pixel of the reference apart"""
    sigma: float = 4.8
    """of the Gaussian weight [px]"""
    iterations: int = 20
    step: float = 0.003
    """shift below which the iteration ends [px]"""
    reach: float = 2.0
    """largest shift from the starting point [px]"""
    loose: float = 0.1
    """standard deviation of the elements of the affine map that is given: it is an observation, too"""
    spline: bool = False
    """whether both images hold coefficients of a cubic B-spline (`raybundle.matching.spline_pictures`);
    otherwise grey values, interpolated by cubic convolution"""
    quadratic: bool = False
    """whether the map has second derivatives, too"""

    @property
    def unknowns(self) -> int:
        """Of a window: light, and shape."""
        return UNKNOWNS + 6 * self.quadratic


@dataclass(frozen=True, slots=True, kw_only=True)
class WindowMatches:
    """Measured points; rows that are not MATCHED hold the last iterate."""

    xy_px: Array
    """(n, 2) in the target"""
    affine: Array
    """(n, 2, 2) target_from_reference of small vectors"""
    bend: Array
    """(n, 2, 3) second derivatives of x and y in the target along uu, uv and vv [1 / px]; 0 of an affine map"""
    cov_px2: Array
    """(n, 3) variances of x and y and their covariance, from grey values alone"""
    correlation: Array
    """(n,) of the two windows, weighted"""
    residual: Array
    """(n, FIGURES) of matched points: variance of the residuals [grey values^2]; mean grey value of the reference
    window; for displacements in the target, sum of b b' over the parts of the window and sum of w^2 g g' over its
    positions, each as xx, xy, yy.  b: sum of w g e over a part, w weights, g gradients in the target [1 / px] of grey
    values with variance 1, e residuals [grey values].  Of noise alone, along any direction the former is the variance
    of the residuals times the latter; a part that is displaced adds to it along its displacement.

    Then of a surface that is curved within the window: displacements p k |u|^2 / 2 at places u of the reference window,
    p a vector in the target, have k = p'a / p'M p, of variance residual[0] / p'M p.  a as x, y; M as xx, xy, yy; last
    the share r of [px^2] of k that the match is displaced by, p k r.  All 0 of a quadratic map."""
    outcome: Index
    """(n,) `Outcome`"""


def match_windows(
    reference: Array, target: Array, xy_reference: Array, xy_start: Array, affine_start: Array, options: WindowOptions
) -> WindowMatches:
    """Match windows of a reference image in a target image.

    reference, target      (h, w) uint16
    xy_reference, xy_start (n, 2) pixel frame
    affine_start           (n, 2, 2) target_from_reference

    What the covariance does not show: gradients of the reference hold noise, too (`with_noisy_gradients`); grey values
    of neighbouring pixels are correlated, and a surface that is not plane within the window moves the result; variance
    components of the block decide how much is to be added.
    """
    module = native.module()
    arguments = (
        np.ascontiguousarray(reference),
        np.ascontiguousarray(target),
        np.ascontiguousarray(xy_reference, float),
        np.ascontiguousarray(xy_start, float),
        np.ascontiguousarray(affine_start, float),
    )
    if module is None:
        return match_windows_twin(*arguments, options)
    o = options
    xy, affine, bend, covariance, correlation, residual, outcome = module.match_windows(
        *arguments, o.half, o.sigma, o.iterations, o.step, o.reach, o.loose, o.spline, o.quadratic
    )
    return WindowMatches(
        xy_px=xy, affine=affine, bend=bend, cov_px2=covariance, correlation=correlation, residual=residual,
        outcome=outcome,
    )  # fmt: skip


def with_noisy_gradients(found: WindowMatches, xy_reference: Array, options: WindowOptions) -> WindowMatches:
    """The matches of two noisy windows with a covariance that does not take the noise of gradients for information.

    xy_reference  (n, 2) where the reference windows stand

    Half of the residuals' variance is the noise of the reference window, whose gradients make the normal matrix N; of
    N only N_s = N - noise of the gradients * sum(weights) ties the shift to the grey values, and an equation J'We = 0
    in which e moves by N_s d has the covariance s^2 N_s^-1 N N_s^-1 (errors in variables; Fuller 1987, section 1.2).
    The same holds where the second derivative of the residuals' square sum is taken in place of N.
    """
    rows = np.flatnonzero(found.outcome == Outcome.MATCHED)
    side = np.arange(-options.half, options.half + 1.0)
    weights = np.exp(-(side**2) / (2 * options.sigma**2)).sum() ** 2
    positions = len(side) ** 2
    lost = 1 - found.correlation[rows]  # the noise of one window, in units of its contrast
    s2 = np.maximum(2 * lost * positions / (positions - UNKNOWNS), 1e-12)
    x, y, xy = found.cov_px2[rows].T
    A = found.affine[rows].reshape(-1, 4).T
    back = np.stack([A[3], -A[1], -A[2], A[0]]) / (A[0] * A[3] - A[1] * A[2])
    u, v, uv = _carried(back, x, y, xy) / s2  # N^-1, of the reference window
    # p and q, the shares of the information that are noise, are the eigenvalues of noise D times N^-1
    along, down = lost * weights * _gradient_noise(xy_reference[rows]).T
    middle = (along * u + down * v) / 2
    half = np.sqrt(np.maximum(middle**2 - along * down * (u * v - uv**2), 0))
    p, q = (1 / np.maximum(1 - k, LEAST_SHARE) ** 2 for k in (middle - half, middle + half))
    # f(M) of a symmetric 2 x 2 matrix is linear in M: N^-1 f = a N^-1 + b N^-1 D N^-1
    b = np.divide(q - p, 2 * half, out=np.zeros(len(rows)), where=half > 1e-9)
    a = p - b * (middle - half)
    noisy = along * u**2 + down * uv**2, along * uv**2 + down * v**2, uv * (along * u + down * v)
    cov = found.cov_px2.copy()
    cov[rows] = (s2 * _carried(A, *(a * k + b * n for k, n in zip((u, v, uv), noisy, strict=True)))).T
    return replace(found, cov_px2=cov)


def _carried(A: Array, x: Array, y: Array, xy: Array) -> Array:
    """(3, n) A C A' of matrices A (4, n) and symmetric ones C, given and returned as xx, yy, xy."""
    return np.stack([
        A[0] ** 2 * x + A[1] ** 2 * y + 2 * A[0] * A[1] * xy, A[2] ** 2 * x + A[3] ** 2 * y + 2 * A[2] * A[3] * xy,
        A[0] * A[2] * x + A[1] * A[3] * y + (A[0] * A[3] + A[1] * A[2]) * xy,
    ])  # fmt: skip


def _gradient_noise(xy: Array) -> Array:
    """(n, 2) variances of both gradients of noise where windows stand, in units of the noise of two windows' mean.

    All positions of a window are read at one place between the pixels: in the middle of a pixel a gradient is a
    difference over two pixels, at its edge one over one.
    """
    (vx, dx), (vy, dy) = _noise_of(xy[:, 0] - 0.5), _noise_of(xy[:, 1] - 0.5)
    mean = (vx * vy + ANYWHERE) / 2
    return np.stack([dx * vy / mean, vx * dy / mean], axis=1)


def match_windows_twin(
    reference: Array, target: Array, xy_reference: Array, xy_start: Array, affine_start: Array, options: WindowOptions
) -> WindowMatches:
    """The same with NumPy, point by point."""
    n = len(xy_reference)
    result = WindowMatches(
        xy_px=xy_start.copy(), affine=affine_start.copy(), bend=np.zeros((n, 2, 3)), cov_px2=np.zeros((n, 3)),
        correlation=np.zeros(n), residual=np.zeros((n, FIGURES)), outcome=np.full(n, Outcome.UNSTEADY, np.int32),
    )  # fmt: skip
    side = np.arange(-options.half, options.half + 1.0)
    u = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    w = np.exp(-(u**2).sum(axis=1) / (2 * options.sigma**2))
    for i in range(n):
        window = _Window.of(reference, xy_reference[i], u, w, options)
        if isinstance(window, Outcome):
            result.outcome[i] = window
            continue
        _match_one(window, target, i, result, options)
    return result


@dataclass(slots=True)
class _Window:
    """A reference window: positions, weights, normalised grey values, design matrix, normal matrix."""

    u: Array
    w: Array
    T: Array
    J: Array
    N: Array
    level: float
    """mean grey value"""
    contrast: float
    """standard deviation of the grey values"""

    @classmethod
    def of(cls, image: Array, centre: Array, u: Array, w: Array, options: WindowOptions) -> _Window | Outcome:
        if not _inside(image, centre + u[[0, -1]]):
            return Outcome.OUTSIDE
        T, gx, gy = _sample(image, centre + u, options.spline)
        level = w @ T / w.sum()
        T, contrast = _normalised(T, w)
        if contrast == 0:
            return Outcome.FLAT
        gx, gy = gx / contrast, gy / contrast
        slope = u * (T + level / contrast)[:, None] / u.max()
        second = _second(u).T if options.quadratic else ()
        columns = [gx, gy, gx * u[:, 0], gx * u[:, 1], gy * u[:, 0], gy * u[:, 1]]
        columns += [g * s for g in (gx, gy) for s in second]
        J = np.stack([*columns, np.ones_like(T), T, *slope.T], axis=1)
        N = J.T @ (w[:, None] * J)
        return cls(u, w, T, J, N, float(level), contrast)


def _match_one(o: _Window, target: Array, i: int, result: WindowMatches, options: WindowOptions) -> None:
    p, B, C = result.xy_px[i].copy(), result.affine[i].copy(), result.bend[i]
    start, total, h, unknowns = p.copy(), o.w.sum(), options.half, options.unknowns
    unit = np.concatenate([[1, 1], np.full(4, h), np.full(6 * options.quadratic, h**2 / 2)])
    corners = h * np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])
    outcome = Outcome.UNSTEADY
    for _ in range(options.iterations):
        at = p + o.u @ B.T + _second(o.u) @ C.T
        around = np.abs(C) @ [h**2 / 2, h**2, h**2 / 2]
        if not all(_inside(target, p + corners @ B.T + sign * around) for sign in (-1, 1)):
            outcome = Outcome.OUTSIDE
            break
        G, contrast = _normalised(_sample(target, at, options.spline)[0], o.w)
        if contrast == 0:
            outcome = Outcome.FLAT
            break
        e = G - o.T
        square = float(o.w @ e**2)
        result.correlation[i] = 1 - square / (2 * total)
        weight = max(square / total, 1e-4) / options.loose**2
        prior = np.concatenate([[0, 0], np.full(4, weight), np.zeros(unknowns - 6)])
        D = np.linalg.inv(result.affine[i]) @ B - np.eye(2)
        deviation = np.concatenate([[0, 0], D.ravel(), np.zeros(unknowns - 6)])
        try:
            Q = np.linalg.inv(o.N + np.diag(prior))
        except np.linalg.LinAlgError:
            outcome = Outcome.FLAT
            break
        d = Q @ (o.J.T @ (o.w * e) + prior * deviation)
        longest = float((np.abs(d[: len(unit)]) * unit).max())
        if longest > h / 4:
            d = d * (h / 4 / longest)
        A = np.eye(2) + d[2:6].reshape(2, 2)
        if not abs(np.linalg.det(A)) > 0.1:
            break
        B = B @ np.linalg.inv(A)
        shift = B @ d[:2]
        p = p - shift
        if options.quadratic:
            C -= B @ d[6:12].reshape(2, 3)
        if np.hypot(*(p - start)) > options.reach:
            outcome = Outcome.MOVED
            break
        if np.hypot(*shift) < options.step and longest <= h / 4:
            outcome = Outcome.MATCHED
            variance = square / total * len(o.u) / (len(o.u) - unknowns)
            K = variance * B @ Q[:2, :2] @ B.T
            result.cov_px2[i] = K[0, 0], K[1, 1], K[0, 1]
            result.residual[i] = _judged(o, e, Q, square, B, h)
            if options.quadratic:
                result.residual[i, 8:] = 0
            break
    result.xy_px[i], result.affine[i], result.outcome[i] = p, B, outcome


def _judged(o: _Window, e: Array, Q: Array, square: float, B: Array, half: int) -> Array:
    """(FIGURES,) see `WindowMatches.residual`; Q: cofactors of the unknowns."""
    part = ((o.u + half).astype(int) * PARTS // (2 * half + 1)) @ [1, PARTS]
    g = o.J[:, :2]
    b = np.stack([np.bincount(part, o.w * g[:, k] * e, PARTS**2) for k in range(2)], axis=1) * o.contrast
    C = np.linalg.inv(B)
    bent = g * (o.u**2).sum(axis=1, keepdims=True) / 2
    taken = Q @ (o.J.T @ (o.w[:, None] * bent))
    left = o.w[:, None] * (bent - o.J @ taken)
    M, T, D = (C.T @ S @ C for S in (b.T @ b, (o.w[:, None] * g).T @ (o.w[:, None] * g), left.T @ bent * o.contrast**2))
    a = -C.T @ (left.T @ e) * o.contrast**2
    variance = square / o.w.sum() * len(o.u) / (len(o.u) - len(Q)) * o.contrast**2
    upper = [0, 0, 1], [0, 1, 1]
    return np.array([variance, o.level, *M[upper], *T[upper], *a, *D[upper], np.trace(taken[:2]) / 2])


def _second(u: Array) -> Array:
    """(n, 3) of second derivatives at places u."""
    x, y = u.T
    return np.stack([x * x / 2, x * y, y * y / 2], axis=1)


def _inside(image: Array, xy: Array) -> bool:
    h, w = image.shape
    return bool((xy >= 2.5).all() and (xy <= [w - 2.5, h - 2.5]).all())


def _normalised(a: Array, w: Array) -> tuple[Array, float]:
    """Weighted mean 0, weighted variance 1; contrast 0 where there is none."""
    a = a - w @ a / w.sum()
    scale = float(np.sqrt(w @ a**2 / w.sum()))
    return (a / scale, scale) if scale > 1e-6 else (a, 0.0)


def _sample(image: Array, xy: Array, spline: bool = False) -> tuple[Array, Array, Array]:  # noqa: FBT001, FBT002
    """Grey values and gradient at (n, 2) of the pixel frame: cubic convolution, or cubic B-spline of coefficients."""
    at = xy - 0.5
    whole = np.floor(at).astype(int)
    (wx, dx), (wy, dy) = ((_spline if spline else _cubic)(at[:, k] - whole[:, k]) for k in (0, 1))
    offset = np.arange(-1, 3)
    grey = image[(whole[:, 1, None] + offset)[:, :, None], (whole[:, 0, None] + offset)[:, None]].astype(float)
    return (
        np.einsum("nj,ni,nji->n", wy, wx, grey),
        np.einsum("nj,ni,nji->n", wy, dx, grey),
        np.einsum("nj,ni,nji->n", dy, wx, grey),
    )


def _spline(t: Array) -> tuple[Array, Array]:
    """Weights of four neighbouring coefficients for value and slope (Unser 1993)."""
    t2, t3 = t**2, t**3
    w = [(1 - t) ** 3 / 6, (3 * t3 - 6 * t2 + 4) / 6, (1 + 3 * t + 3 * t2 - 3 * t3) / 6, t3 / 6]
    d = [-((1 - t) ** 2) / 2, 1.5 * t2 - 2 * t, 0.5 + t - 1.5 * t2, t2 / 2]
    return np.stack(w, axis=1), np.stack(d, axis=1)


def _cubic(t: Array) -> tuple[Array, Array]:
    """The same for cubic convolution (Keys 1981, a = -1/2)."""
    t2, t3 = t**2, t**3
    w = [-0.5 * t3 + t2 - 0.5 * t, 1.5 * t3 - 2.5 * t2 + 1, -1.5 * t3 + 2 * t2 + 0.5 * t, 0.5 * t3 - 0.5 * t2]
    d = [-1.5 * t2 + 2 * t - 0.5, 4.5 * t2 - 5 * t, -4.5 * t2 + 4 * t + 0.5, 1.5 * t2 - t]
    return np.stack(w, axis=1), np.stack(d, axis=1)


NOISE = np.exp(-(np.subtract.outer(np.arange(4), np.arange(4)) ** 2) / (4 * NOISE_SIGMA_PX**2))
"""Correlations of the noise of four neighbouring pixels."""


def _noise_of(at: Array) -> tuple[Array, Array]:
    """Variances of value and derivative at places (n,)."""
    w, d = _cubic(at - np.floor(at))
    return ((w @ NOISE) * w).sum(axis=1), ((d @ NOISE) * d).sum(axis=1)


ANYWHERE = float(_noise_of(np.linspace(0, 1, 64, endpoint=False))[0].mean()) ** 2
"""Variance of the value at a place of both coordinates, in the mean of all places."""
