"""Crosses as of windows and of masonry: bars of two widths before panes of four grey values, in a photograph's texture.

With B1, B2 of the blurred bars and e1, e2 of their axes as in `junction`, and o = (1 - B1) (1 - B2), a grey value is

    g = o (a + b e1 + c e2 + d e1 e2) + B1 (1 - B2) (f + h e2) + B2 (1 - B1) (k + l e1) + m B1 B2 + g_x dx + g_y dy

so that each half of a bar has its own grey value, too.  What the model leaves out is no white noise: see
`_covariance`, to which the difference of two windows is added.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.measuring.junction import LEAST_ANGLE, ROUNDING, Junction
from raybundle.numerics.arrays import Array

HALVES = (12, 9)
"""Half widths of the windows [px], the one that places the cross first."""
WIDTHS = (1.0, 3.5)
"""Half widths of bars to begin with [px]."""
STEP_DEG = 10.0
ALIKE = np.array([1.0, 2.0, 3.0, 2.0, 1.0]) / 3
"""Weights of products of residuals that are so many pixels apart along an axis (Bartlett)."""
TINY = 1e-4
Values = tuple[Array, Array, Array, Array]
"""Profiles of two bars and of their axes"""


def fit_window_cross(grey: Array, starts: Sequence[Array]) -> Junction | None:
    """Fit a cross from the best of some places; None where a window leaves the picture."""
    first = _fitted(grey, starts, HALVES[0], None)
    if first is None:
        return None
    found, p = first
    again = _fitted(grey, [found.xy], HALVES[1], p)
    if again is None:
        return None
    apart = again[0].xy - found.xy
    return replace(found, covariance=found.covariance + np.outer(apart, apart))


def _fitted(grey: Array, starts: Sequence[Array], half: int, like: Array | None) -> tuple[Junction, Array] | None:
    from scipy.optimize import least_squares

    corner = np.floor(starts[0]).astype(int) - half
    size = 2 * half + 1
    if (corner < 0).any() or (corner[::-1] + size > grey.shape).any():
        return None
    g = grey[corner[1] : corner[1] + size, corner[0] : corner[0] + size].astype(float)
    x, y = (k.ravel() for k in np.meshgrid(np.arange(-half, half + 1.0), np.arange(-half, half + 1.0)))
    inside = np.hypot(x, y) <= half + 0.5
    g, x, y = g.ravel()[inside], x[inside], y[inside]
    middle = corner + half + 0.5
    begin = _start(g, x, y, [s - middle for s in starts]) if like is None else np.append(starts[0] - middle, like[2:])

    def left(p: Array) -> Array:
        A = _columns(p, x, y)
        return g - A @ _linear(A, g)

    low = np.array([-half, -half, -np.inf, -np.inf, 0.3, 0.3, 0.3])
    high = np.array([half, half, np.inf, np.inf, 4.0, half / 1.7, half / 1.7])
    begin = np.clip(begin, low + TINY, high - TINY)
    solved = least_squares(left, begin, bounds=(low, high), x_scale=[1, 1, 0.1, 0.1, 0.5, 1, 1], max_nfev=60)
    p = np.asarray(solved.x)
    A = _columns(p, x, y)
    linear = _linear(A, g)
    by = [(_columns(p + d, x, y) - _columns(p - d, x, y)) @ linear / (2 * TINY) for d in TINY * np.eye(7)]
    J, e = np.concatenate([np.stack(by, axis=1), A], axis=1), g - A @ linear
    variance = max(float(e @ e) / (len(g) - J.shape[1]), ROUNDING)
    contrast = _contrast(linear)
    apart = float((p[3] - p[2]) % np.pi)
    found = Junction(
        xy=p[:2] + middle, covariance=_covariance(J, e, inside.reshape(size, size), variance),
        residual=float(np.sqrt(variance)) / max(contrast, 1e-9), contrast=contrast, blur_px=float(p[4]),
        angle=min(apart, np.pi - apart), ended=bool(solved.success),
    )  # fmt: skip
    return found, p


def _profiles(p: Array, x: Array, y: Array) -> Values:
    from scipy.special import erf

    d = [((x - p[0]) * np.cos(a) + (y - p[1]) * np.sin(a)) for a in p[2:4]]
    s = p[4] * np.sqrt(2)
    B1, B2 = ((erf((k + h) / s) - erf((k - h) / s)) / 2 for k, h in zip(d, p[5:7], strict=True))
    return B1, B2, erf(d[0] / s), erf(d[1] / s)


def _columns(p: Array, x: Array, y: Array) -> Array:
    B1, B2, e1, e2 = _profiles(p, x, y)
    o, u, v = (1 - B1) * (1 - B2), B1 * (1 - B2), B2 * (1 - B1)
    return np.stack([o, o * e1, o * e2, o * e1 * e2, u, u * e2, v, v * e1, B1 * B2, x, y], axis=1)


def _linear(A: Array, g: Array) -> Array:
    return np.linalg.solve(A.T @ A + 1e-3 * np.eye(A.shape[1]), A.T @ g)


def _start(g: Array, x: Array, y: Array, places: Sequence[Array]) -> Array:
    """Places, directions and widths to begin with: the best of all, of panes and bars that are alike."""
    angles, best, found = np.deg2rad(np.arange(0.0, 180.0, STEP_DEG)), np.inf, np.zeros(7)
    keys = np.array([(a, h) for a in angles for h in WIDTHS])
    i, k = np.triu_indices(len(keys), 1)
    apart = (keys[k, 0] - keys[i, 0]) % np.pi
    good = np.minimum(apart, np.pi - apart) >= LEAST_ANGLE
    i, k = i[good], k[good]
    for place in places:
        bars = np.array([_profiles(np.array([*place, a, a, 0.9, h, h]), x, y)[0] for a, h in keys])
        one, two = bars[i], bars[k]
        both, flat = one * two, np.broadcast_to(np.stack([np.ones_like(x), x, y]), (len(i), 3, len(x)))
        A = np.concatenate([np.stack([one, two, both], axis=1), flat], axis=1)  # spans the same as panes and bars alike
        N, b = A @ A.transpose(0, 2, 1) + 1e-3 * np.eye(6), A @ g
        explained = np.einsum("ni,ni->n", b, np.linalg.solve(N, b[..., None])[..., 0])
        n = int(np.argmax(explained))
        if (cost := float(g @ g - explained[n])) < best:
            (a, h), (c, d) = keys[i[n]], keys[k[n]]
            best, found = cost, np.array([*place, a, c, 0.9, h, d])
    return found


def _contrast(q: Array) -> float:
    """Of the weaker bar against the panes beside it, in its more distinct half [grey values]."""
    first = [q[4] + t * q[5] - (q[0] + t * q[2]) for t in (1, -1)]
    second = [q[6] + t * q[7] - (q[0] + t * q[1]) for t in (1, -1)]
    return float(min(np.abs(first).max(), np.abs(second).max()))


def _covariance(J: Array, e: Array, inside: Array, variance: float) -> Array:
    """(2, 2) of the place: of white noise, or of residuals that neighbours share, whichever is larger.

    N^-1 M N^-1 with M from the products of residuals up to two pixels apart (Newey and West 1987, in the plane).
    """
    import cv2

    scale = np.sqrt(np.maximum((J * J).sum(axis=0), 1e-12))
    N = (J / scale).T @ (J / scale)
    if np.linalg.cond(N) > 1e10:
        return np.full((2, 2), np.nan)
    inverse = np.linalg.inv(N) / np.outer(scale, scale)
    plane = np.zeros((*inside.shape, J.shape[1]))
    plane[inside] = J * e[:, None]
    near = np.stack([
        cv2.sepFilter2D(np.ascontiguousarray(plane[..., k]), -1, ALIKE, ALIKE, borderType=cv2.BORDER_CONSTANT)
        for k in range(J.shape[1])
    ], axis=2)  # fmt: skip
    M = np.einsum("ijk,ijl->kl", plane, near) * len(e) / (len(e) - J.shape[1])
    white, shared = variance * inverse[:2, :2], (inverse @ M @ inverse)[:2, :2]
    return shared if np.trace(shared) > np.trace(white) else white
