"""Corners and crosses: least squares on grey values, with the covariance of the point where two edges meet.

Two straight edges cross at the point; blurred by a Gaussian of standard deviation s (optics and pixel together), with
e1, e2 = erf(d / (s sqrt 2)) of the distances to them, a grey value is

    corner   g = a + b e1 + c e2 + d E + g_x dx + g_y dy             four quarters of any grey values: the corner of a
                                                                     window, of a chessboard, of a sill
    cross    g = a + d (1 - (1 - B1) (1 - B2)) + g_x dx + g_y dy     two bars of half width h, B = (erf+ - erf-) / 2 at
                                                                     the distances d + h and d - h from its axis

E is what blur leaves of the product of the edges' signs: of two normal variates u, v with the correlation r = cos of
the angle between the edges, 4 P(u < d1 / s, v < d2 / s) - 2 P(u < d1 / s) - 2 P(v < d2 / s) + 1 (Owen 1956 for P);
where the edges cross at right angles it is e1 e2.  The product of bars is exact there, too.  Unknowns that are linear
(a, b, c, d, g_x, g_y) follow from the others in each step (variable projection; Golub and Pereyra 1973), and all count
in the covariance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.numerics.arrays import Array

ROUNDING = 1 / 12
"""Variance of a whole grey value."""
SHARPEST, SOFTEST = 0.3, 4.0
NARROWEST, WIDEST = 0.3, 5.0
"""Half width of a bar [px]."""
USUAL_BLUR, USUAL_BLUR_SIGMA = 0.9, 0.5
"""Of crosses, as known beforehand [px]."""
LEAST_ANGLE = np.deg2rad(25.0)
"""Between the edges, below which where they meet is not stated."""
Model = Literal["corner", "cross"]
STEPS = 40
START_STEP_DEG = 10.0
TINY = 1e-12


@dataclass(slots=True)
class Junction:
    """A fitted corner or cross."""

    xy: Array
    """(2,) pixel frame of the window's picture"""
    covariance: Array
    """(2, 2) [px^2], from the residuals of the grey values alone"""
    residual: float
    """standard deviation of a grey value, in units of the contrast of the weaker edge"""
    contrast: float
    """across the weaker edge [grey values]"""
    blur_px: float
    angle: float
    """between the edges [rad], 0 .. pi / 2"""
    ended: bool
    """whether the iteration came to its end"""


def forstner_point(grey: Array, xy: Array, half: int) -> Array | None:
    """Where the edges within a window meet (2,): nearest to the lines of all edge elements.  Förstner, Gülch 1987.

    None where the window leaves the picture or holds no two directions.
    """
    x0, y0 = int(np.floor(xy[0])) - half, int(np.floor(xy[1])) - half
    size = 2 * half + 1
    if x0 < 1 or y0 < 1 or x0 + size + 1 > grey.shape[1] or y0 + size + 1 > grey.shape[0]:
        return None
    part = grey[y0 - 1 : y0 + size + 1, x0 - 1 : x0 + size + 1].astype(float)
    gx = (part[1:-1, 2:] - part[1:-1, :-2]) / 2
    gy = (part[2:, 1:-1] - part[:-2, 1:-1]) / 2
    x, y = np.meshgrid(np.arange(size) + x0 + 0.5, np.arange(size) + y0 + 0.5)
    w = np.exp(-((x - xy[0]) ** 2 + (y - xy[1]) ** 2) / (2 * (half / 1.5) ** 2))
    xx, yy, xy_ = (float((w * p).sum()) for p in (gx * gx, gy * gy, gx * gy))
    N = np.array([[xx, xy_], [xy_, yy]])
    values = np.linalg.eigvalsh(N)
    if not values[0] > 0.01 * values[1] or not values[1] > 0:
        return None
    along = gx * x + gy * y
    return np.linalg.solve(N, np.array([float((w * gx * along).sum()), float((w * gy * along).sum())]))


def fit_junction(grey: Array, start: Array, half: int, model: Model) -> Junction | None:
    """Fit a corner or a cross in a window of 2 half + 1 pixels about the pixel of `start`; None without a start."""
    cx, cy = int(np.floor(start[0])), int(np.floor(start[1]))
    h, w = grey.shape
    if cx - half < 0 or cy - half < 0 or cx + half >= w or cy + half >= h:
        return None
    g = grey[cy - half : cy + half + 1, cx - half : cx + half + 1].astype(float).ravel()
    x, y = (k.ravel() for k in np.meshgrid(np.arange(-half, half + 1.0), np.arange(-half, half + 1.0)))
    inside = np.hypot(x, y) <= half + 0.5
    g, x, y = g[inside], x[inside], y[inside]
    p = _start(g, x, y, start - [cx + 0.5, cy + 0.5], model)
    p, J, e, ended = _iterate(p, g, x, y, model, half)
    made = _junction(p, J, e, g, model)
    return replace(made, xy=made.xy + np.array([cx + 0.5, cy + 0.5]), ended=made.ended and ended)


def _profile(angle: float, p: Array, x: Array, y: Array, model: Model) -> Array:
    """What an edge (a bar) makes of places: -1 .. 1 (0 .. 1)."""
    from scipy.special import erf

    d, s = (x - p[0]) * np.cos(angle) + (y - p[1]) * np.sin(angle), p[4] * np.sqrt(2)
    return erf(d / s) if model == "corner" else (erf((d + p[5]) / s) - erf((d - p[5]) / s)) / 2


def _columns(e1: Array, e2: Array, both: Array, x: Array, y: Array, model: Model) -> Array:
    """Columns of the linear unknowns (n, 6 or 4).

    both  (n,) of the two edges (bars) together: their product at right angles
    """
    one = np.ones_like(x)
    parts = [e1, e2, both] if model == "corner" else [e1 + e2 - both]
    return np.stack([one, *parts, x, y], axis=1)


def _basis(p: Array, x: Array, y: Array, model: Model) -> Array:
    e1, e2 = (_profile(float(a), p, x, y, model) for a in p[2:4])
    return _columns(e1, e2, _signs(p, x, y) if model == "corner" else e1 * e2, x, y, model)


def _distances(p: Array, x: Array, y: Array) -> tuple[Array, Array]:
    """Distances of places from the two edges, in units of the blur."""
    a, b = (((x - p[0]) * np.cos(t) + (y - p[1]) * np.sin(t)) / p[4] for t in p[2:4])
    return a, b


def _signs(p: Array, x: Array, y: Array) -> Array:
    """The blurred product of the signs of two edges."""
    from scipy.special import owens_t

    a, b = (np.where(np.abs(d) < TINY, TINY, d) for d in _distances(p, x, y))
    r = np.cos(p[3] - p[2])
    q = np.sqrt(max(1 - r * r, TINY))
    opposite = a * b < 0
    return 1.0 - 2.0 * opposite - 4 * owens_t(a, (b / a - r) / q) - 4 * owens_t(b, (a / b - r) / q)


def _signs_by(p: Array, x: Array, y: Array) -> tuple[Array, Array, Array]:
    """Its derivatives: by the first edge's erf, by the second's, and by the direction of the second less the first."""
    from scipy.special import erf

    a, b = _distances(p, x, y)
    r, turn = np.cos(p[3] - p[2]), np.sin(p[3] - p[2])
    q = np.sqrt(max(1 - r * r, TINY))
    by_r = 2 / (np.pi * q) * np.exp(-(a * a - 2 * r * a * b + b * b) / (2 * q * q))
    return erf((b - r * a) / (q * np.sqrt(2))), erf((a - r * b) / (q * np.sqrt(2))), -turn * by_r


def _linear(columns: Array, g: Array) -> Array:
    N = columns.T @ columns + 1e-9 * np.eye(columns.shape[1])
    return np.linalg.solve(N, columns.T @ g)


def _start(g: Array, x: Array, y: Array, xy: Array, model: Model) -> Array:
    """Position, directions, blur and half width to begin with: the best of all pairs of directions."""
    angles = np.deg2rad(np.arange(0.0, 180.0, START_STEP_DEG))
    best, found = -np.inf, np.zeros(6)
    for width in (1.0,) if model == "corner" else (0.8, 2.0):
        p = np.array([xy[0], xy[1], 0.0, 0.0, 0.9, width])
        profiles = [_profile(float(a), p, x, y, model) for a in angles]
        for i in range(len(angles)):
            for j in range(i + 1, len(angles)):
                apart = (angles[j] - angles[i]) % np.pi
                if min(apart, np.pi - apart) < LEAST_ANGLE:
                    continue
                columns = _columns(profiles[i], profiles[j], profiles[i] * profiles[j], x, y, model)
                explained = float(columns.T @ g @ _linear(columns, g))
                if explained > best:
                    best, found = explained, np.array([xy[0], xy[1], angles[i], angles[j], 0.9, width])
    return found


def _parameters(model: Model) -> int:
    return 5 if model == "corner" else 6


def _derivatives(p: Array, linear: Array, x: Array, y: Array, model: Model) -> Array:
    """(n, 5 or 6) of the model by position, directions, blur and half width."""
    dx, dy = x - p[0], y - p[1]
    s, k = p[4], np.sqrt(2 / np.pi) / p[4]
    e1, e2 = (_profile(float(a), p, x, y, model) for a in p[2:4])
    by_angle = np.zeros_like(x)
    if model == "corner":
        by_first, by_second, by_angle = _signs_by(p, x, y)
        weight = (linear[1] + linear[3] * by_first, linear[2] + linear[3] * by_second)
    else:
        weight = (linear[1] * (1 - e2), linear[1] * (1 - e1))
    J = np.zeros((len(x), _parameters(model)))
    for n, (angle, wt) in enumerate(zip(p[2:4], weight, strict=True)):
        c, q = np.cos(angle), np.sin(angle)
        d, turned = dx * c + dy * q, dy * c - dx * q
        if model == "corner":
            by_d = k * np.exp(-(d**2) / (2 * s * s))
            by_s, by_h = -by_d * d / s, np.zeros_like(d)
        else:
            plus, minus = (k / 2 * np.exp(-((d + sign * p[5]) ** 2) / (2 * s * s)) for sign in (1, -1))
            by_d = plus - minus
            by_s, by_h = -(plus * (d + p[5]) - minus * (d - p[5])) / s, plus + minus
        J[:, 0] -= wt * by_d * c
        J[:, 1] -= wt * by_d * q
        J[:, 2 + n] = wt * by_d * turned
        J[:, 4] += wt * by_s
        if model == "cross":
            J[:, 5] += wt * by_h
    J[:, 2] -= linear[3] * by_angle
    J[:, 3] += linear[3] * by_angle
    return J


def _iterate(p: Array, g: Array, x: Array, y: Array, model: Model, half: int) -> tuple[Array, Array, Array, bool]:
    """Levenberg and Marquardt: unknowns, derivatives by all of them, residuals, whether it came to its end."""
    damping, ended = 1e-3, False
    columns = _basis(p, x, y, model)
    linear = _linear(columns, g)
    e = g - columns @ linear
    n = _parameters(model)
    low = np.array([-half, -half, -np.inf, -np.inf, SHARPEST, NARROWEST])
    high = np.array([half, half, np.inf, np.inf, SOFTEST, WIDEST])
    for _ in range(STEPS):
        J = np.concatenate([_derivatives(p, linear, x, y, model), columns], axis=1)
        N, b = J.T @ J, J.T @ e
        prior = _blur_weight(e, len(g) - J.shape[1], model)
        N[4, 4] += prior
        b[4] += prior * (USUAL_BLUR - p[4])
        scale = np.sqrt(np.maximum(np.diagonal(N), 1e-12))
        A = N / np.outer(scale, scale) + damping * np.eye(len(N)) + 1e-10 * np.eye(len(N))
        step = np.linalg.solve(A, b / scale) / scale
        d = step[:n] * min(
            1.0, 1.5 / max(float(np.abs(step[:2]).max()), 1e-12), 0.3 / max(float(np.abs(step[2:4]).max()), 1e-12)
        )
        new = p.copy()
        new[:n] = np.clip(p[:n] + d, low[:n], high[:n])
        columns_new = _basis(new, x, y, model)
        linear_new = _linear(columns_new, g)
        e_new = g - columns_new @ linear_new
        before = e @ e + prior * (p[4] - USUAL_BLUR) ** 2
        if e_new @ e_new + prior * (new[4] - USUAL_BLUR) ** 2 <= before * (1 + 1e-9):
            small = float(np.abs(new[:2] - p[:2]).max()) < 1e-4
            p, columns, linear, e = new, columns_new, linear_new, e_new
            damping = max(damping / 10, 1e-8)
            if small and damping < 1e-2:
                ended = True
                break
        else:
            damping *= 10
            if damping > 1e7:
                break
    return p, np.concatenate([_derivatives(p, linear, x, y, model), columns], axis=1), e, ended


def _blur_weight(e: Array, freedom: int, model: Model) -> float:
    """Blur and width of thin bars show in their sum alone, so that the blur is loosely known beforehand."""
    if model == "corner":
        return 0.0
    return max(float(e @ e) / max(freedom, 1), ROUNDING) / USUAL_BLUR_SIGMA**2


def _junction(p: Array, J: Array, e: Array, g: Array, model: Model) -> Junction:
    """The result, its place relative to the middle of the window."""
    N = J.T @ J
    N[4, 4] += _blur_weight(e, len(g) - J.shape[1], model)
    scale = np.sqrt(np.maximum(np.diagonal(N), 1e-12))
    A = N / np.outer(scale, scale)
    variance = max(float(e @ e) / max(len(g) - J.shape[1], 1), ROUNDING)
    if np.linalg.cond(A) > 1e10:
        Q = np.full((2, 2), np.nan)
    else:
        Q = (np.linalg.inv(A) / np.outer(scale, scale))[:2, :2]
    linear = _linear(J[:, _parameters(model) :], g)
    if model == "corner":
        contrast = 2 * min(np.hypot(linear[1], linear[3]), np.hypot(linear[2], linear[3]))
    else:
        contrast = abs(float(linear[1]))
    apart = float((p[3] - p[2]) % np.pi)
    return Junction(
        xy=p[:2], covariance=variance * Q, residual=float(np.sqrt(variance)) / max(float(contrast), 1e-9),
        contrast=float(contrast), blur_px=float(p[4]), angle=min(apart, np.pi - apart),
        ended=bool(np.isfinite(Q).all()),
    )  # fmt: skip
