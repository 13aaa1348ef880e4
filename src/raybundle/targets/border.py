"""Corners of dark squares: each side measured as a straight edge, neighbouring sides cut with each other.

Near a side, a grey value is (mean + half erf(d / (s sqrt 2))) (1 + g_x x + g_y y), with the distance d to a straight
line, the blur s, and the slope of the light along and across.  Seven unknowns for each side: offset and direction of
the line, s, mean, half, g_x, g_y.  A corner is where two lines meet; its
covariance follows from theirs.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Mask

UNKNOWNS = 7
OFFSET, ANGLE, S, MEAN, HALF, GX, GY = range(UNKNOWNS)
ROUNDING = 1 / 12
SHARPEST, SOFTEST = 0.25, 6.0
MOST_COLUMNS = 80
"""Columns (rows) along a side that are used."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BorderOptions:
    """The fit of sides."""

    ends: float = 0.1
    """share of a side left out at each end, where the neighbouring side blurs into it"""
    strip: float = 0.8
    """half the width of the strip in which a side is measured, in units of what is even on both its sides"""
    most_px: float = 5.0
    least_px: float = 1.2
    """limits of that half width [px]"""
    residual: float = 0.12
    """largest standard deviation of a grey value, in units of the contrast"""
    contrast: float = 8.0
    """least difference of dark and light [grey values]"""
    iterations: int = 15


@dataclass(frozen=True, slots=True, kw_only=True)
class Squares:
    """Corners of squares, in the order in which they were given."""

    xy_px: Array
    """(n, 4, 2)"""
    covariance: Array
    """(n, 4, 2, 2) [px^2], from the residuals of the grey values alone"""
    residual: Array
    """(n, 4) the larger of those of the two sides, in units of the contrast"""
    measured: Mask
    """(n, 4)"""


def fit_squares(image: Array, corners: Array, even: float, options: BorderOptions | None = None) -> Squares:
    """Fit squares, dark within, from approximate corners.

    image    (h, w) uint8 or uint16
    corners  (n, 4, 2) approximate, in order round the square, pixel frame
    even     breadth of the dark border, and of the light around it, in units of a side

    What the covariance does not show: that sides are straight under the lens, and printed as they should be.
    """
    o = options or BorderOptions()
    n = len(corners)
    if not n:
        empty = np.zeros((0, 4))
        return Squares(xy_px=corners, covariance=np.zeros((0, 4, 2, 2)), residual=empty, measured=empty > 0)
    a, b = corners, np.roll(corners, -1, axis=1)
    length = np.hypot(*(b - a).transpose(2, 0, 1))
    half = np.clip(o.strip * even * length.min(axis=1), o.least_px, o.most_px)
    lines = _fit_lines(image, a.reshape(-1, 2), b.reshape(-1, 2), np.repeat(half, 4), o)
    normal, place, cov, residual, good = (k.reshape(n, 4, *k.shape[1:]) for k in lines)
    xy, C = np.zeros((n, 4, 2)), np.zeros((n, 4, 2, 2))
    fine = np.zeros((n, 4), bool)
    for k in range(4):  # corner k lies between side k - 1 and side k
        xy[:, k], C[:, k], fine[:, k] = _cut(
            normal[:, k - 1], place[:, k - 1], cov[:, k - 1], normal[:, k], place[:, k], cov[:, k]
        )
        fine[:, k] &= good[:, k - 1] & good[:, k]
    fine &= np.hypot(*(xy - corners).transpose(2, 0, 1)) < np.maximum(2.0, 0.5 * even * length)
    return Squares(xy_px=xy, covariance=C, residual=np.maximum(residual, np.roll(residual, 1, axis=1)), measured=fine)


def _cut(n1: Array, p1: Array, C1: Array, n2: Array, p2: Array, C2: Array) -> tuple[Array, Array, Mask]:
    """Where lines meet: points (n, 2), covariances (n, 2, 2), whether they do at more than 10 degrees.

    A line has its unit normal (n, 2), a point (n, 2), and there the covariance (n, 2, 2) of offset and direction.
    """
    N = np.stack([n1, n2], axis=1)
    det = np.linalg.det(N)
    fine = abs(det) > 0.17
    N = np.where(fine[:, None, None], N, np.eye(2))
    x = np.linalg.solve(N, np.stack([(n1 * p1).sum(axis=1), (n2 * p2).sum(axis=1)], axis=1)[..., None])[..., 0]
    variance = np.zeros((len(x), 2, 2))
    for k, (n, p, C) in enumerate(((n1, p1, C1), (n2, p2, C2))):
        along = (x[:, 1] - p[:, 1]) * n[:, 0] - (x[:, 0] - p[:, 0]) * n[:, 1]
        g = np.stack([np.ones(len(x)), along], axis=1)
        variance[:, k, k] = np.einsum("ni,nij,nj->n", g, C, g)
    G = np.linalg.inv(N)
    return x, G @ variance @ G.transpose(0, 2, 1), fine


def _fit_lines(
    image: Array, a: Array, b: Array, half: Array, o: BorderOptions
) -> tuple[Array, Array, Array, Array, Mask]:
    """Sides from a to b (n, 2): normals, points, covariances of offset and direction, residuals, whether measured."""
    n = len(a)
    length = np.hypot(*(b - a).T)
    along = (b - a) / np.maximum(length, 1e-9)[:, None]
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    middle = (a + b) / 2
    x, y, grey, weight, inside = _strip(image, middle, along, across, (0.5 - o.ends) * length, half)
    p = np.zeros((n, UNKNOWNS))
    one, other = ((grey * (weight * (s * y > 0.5))).sum(axis=1) for s in (1, -1))
    counts = [np.maximum((weight * (s * y > 0.5)).sum(axis=1), 1) for s in (1, -1)]
    one, other = one / counts[0], other / counts[1]
    p[:, S], p[:, MEAN], p[:, HALF] = 0.8, (one + other) / 2, (one - other) / 2
    ended, damping = np.zeros(n, bool), np.full(n, 1e-3)
    N, r, square = _evaluate(p, x, y, grey, weight)
    going = np.flatnonzero(inside & (abs(p[:, HALF]) > o.contrast / 4))
    d_ = np.arange(UNKNOWNS)
    for _ in range(o.iterations):
        if not len(going):
            break
        scale = np.sqrt(np.maximum(N[going][:, d_, d_], 1e-12))
        L = N[going] / (scale[:, :, None] * scale[:, None])
        L[:, d_, d_] += damping[going, None] + 1e-9
        # the least blur allowed is held
        L[:, S, S] += 1e9 * ((p[going, S] <= SHARPEST) & (r[going, S] < 0))
        step = np.linalg.solve(L, (r[going] / scale)[..., None])[..., 0] / scale
        limits = np.stack([half[going] / 2, np.full(len(going), 0.2), p[going, S] / 2], axis=1)
        step *= np.minimum(1, (limits / np.maximum(abs(step[:, :3]), 1e-12)).min(axis=1))[:, None]
        new = p[going] + step
        new[:, S] = np.clip(new[:, S], SHARPEST, SOFTEST)
        Nn, rn, sn = _evaluate(new, x[going], y[going], grey[going], weight[going])
        better = sn <= square[going] * (1 + 1e-9)
        t = going[better]
        p[t], N[t], r[t], square[t] = new[better], Nn[better], rn[better], sn[better]
        damping[going] = np.where(better, np.maximum(damping[going] / 10, 1e-7), damping[going] * 10)
        small = better & (abs(step[:, OFFSET]) < 1e-3)
        ended[going[small]] = True
        going = going[~small & (damping[going] < 1e6)]
    return _lines(p, N, np.maximum(square / np.maximum(weight.sum(axis=1) - UNKNOWNS, 1), ROUNDING), ended, middle,
                  along, across, o)  # fmt: skip


def _lines(
    p: Array, N: Array, variance: Array, ended: Mask, middle: Array, along: Array, across: Array, o: BorderOptions
) -> tuple[Array, Array, Array, Array, Mask]:
    d_ = np.arange(UNKNOWNS)
    scale = np.sqrt(N[:, d_, d_])
    fine = ended & (scale > 1e-6).all(axis=1)
    scale = np.maximum(scale, 1e-6)
    A = np.where(fine[:, None, None], N / (scale[:, :, None] * scale[:, None]), 0) + 1e-9 * np.eye(UNKNOWNS)
    Q = np.linalg.inv(A) / (scale[:, :, None] * scale[:, None])
    contrast = 2 * abs(p[:, HALF])
    residual = np.sqrt(variance) / np.maximum(contrast, 1e-9)
    c, q = np.cos(p[:, ANGLE])[:, None], np.sin(p[:, ANGLE])[:, None]
    normal = across * c + along * q
    place = middle + p[:, :1] * normal
    cov = Q[:, :2, :2] * variance[:, None, None]
    return normal, place, cov, residual, fine & (contrast >= o.contrast) & (residual < o.residual)


def _strip(
    image: Array, middle: Array, along: Array, across: Array, reach: Array, half: Array
) -> tuple[Array, Array, Array, Array, Mask]:
    """Pixels of strips: along x and across y (n, m) from their middles, grey values, weights 0 or 1; strips within.

    A side is gone along by columns, a steep one by rows; of a long one every second or third is enough.
    """
    h, w = image.shape
    steep = abs(along[:, 1]) > abs(along[:, 0])
    major = np.where(steep, 1, 0)
    pick = np.arange(len(middle))
    m0, a0 = middle[pick, major], along[pick, major]
    m1, a1 = middle[pick, 1 - major], along[pick, 1 - major]
    extent = reach * abs(a0) + half
    stride = np.maximum(1, np.floor(2 * extent / MOST_COLUMNS)).astype(np.int64)
    columns = int(np.ceil((2 * extent / stride).max(initial=1.0))) + 1
    rows = int(np.ceil((half / abs(a0)).max(initial=1.0))) + 1
    k0 = np.floor(m0 - extent).astype(np.int64)[:, None] + np.arange(columns) * stride[:, None]
    line = m1[:, None] + (k0 + 0.5 - m0[:, None]) * (a1 / a0)[:, None]
    k1 = np.floor(line).astype(np.int64)[..., None] + np.arange(-rows, rows + 1)
    k0 = np.broadcast_to(k0[..., None], k1.shape).reshape(len(middle), -1)
    k1 = k1.reshape(len(middle), -1)
    px, py = np.where(steep[:, None], k1, k0), np.where(steep[:, None], k0, k1)
    dx, dy = px + 0.5 - middle[:, :1], py + 0.5 - middle[:, 1:]
    x, y = dx * along[:, :1] + dy * along[:, 1:], dx * across[:, :1] + dy * across[:, 1:]
    weight = (abs(y) <= half[:, None]) & (abs(x) <= reach[:, None])
    off = (px < 0) | (py < 0) | (px >= w) | (py >= h)
    inside = ~(off & weight).any(axis=1) & (weight.sum(axis=1) > 2 * UNKNOWNS)
    grey = image[np.clip(py, 0, h - 1), np.clip(px, 0, w - 1)].astype(float)
    return x, y, grey, weight.astype(float), inside


def _evaluate(p: Array, x: Array, y: Array, grey: Array, weight: Array) -> tuple[Array, Array, Array]:
    from scipy.special import erf

    s, half = p[:, S, None], p[:, HALF, None]
    c, q = np.cos(p[:, ANGLE])[:, None], np.sin(p[:, ANGLE])[:, None]
    d = y * c + x * q - p[:, OFFSET, None]
    z = d / (s * np.sqrt(2))
    e = erf(z)
    g = half * np.sqrt(2 / np.pi) / s * np.exp(-(z**2))
    light, level = 1 + p[:, GX, None] * x + p[:, GY, None] * y, p[:, MEAN, None] + half * e
    g = g * light
    J = np.stack([-g, g * (x * c - y * q), -g * d / s, light, light * e, level * x, level * y], axis=2)
    J *= weight[..., None]
    r = (grey - level * light) * weight
    JT = J.transpose(0, 2, 1)
    return JT @ J, (JT @ r[..., None])[..., 0], (r**2).sum(axis=1)
