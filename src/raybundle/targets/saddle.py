"""Corners where four squares meet: least squares on grey values, with the covariance of the corner.

Two straight edges cross at the corner; blurred by a Gaussian of standard deviation s, a grey value is

    mean + half erf(d1 / (s sqrt 2)) erf(d2 / (s sqrt 2)) + g_x dx + g_y dy

with the distances d1, d2 to the edges.  Nine unknowns: corner, directions of both normals, s, mean, half the contrast
(its sign shows which squares are dark) and the slope of the light.  The product is exact where the edges cross at right
angles; at others it stays symmetric about the corner, which therefore does not move.

The window must end before the next corner (Bradski's usual 11 px on each side does not, on small boards): pixels count
within `reach` times the two sides that meet at the corner, and within `band` of an edge.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Mask

UNKNOWNS = 9
X0, Y0, A1, A2, S, MEAN, HALF, GX, GY = range(UNKNOWNS)
ROUNDING = 1 / 12
SHARPEST, SOFTEST = 0.25, 6.0


@dataclass(frozen=True, slots=True, kw_only=True)
class CornerOptions:
    """The fit of a corner."""

    reach: float = 0.40
    """half the window, in units of the distance to the next corner"""
    most_px: float = 10.0
    """and no farther than this: lenses bend edges"""
    band: float = 1.0
    """distance from an edge within which squares are blank, in units of the distance to the next corner"""
    clear_px: float = 1.8
    """pixels count to so much less than that, for blur; 1.2 px count in any case"""
    moved: float = 0.5
    """largest shift from the start, in units of half the window"""
    residual: float = 0.10
    """largest standard deviation of a grey value, in units of the contrast"""
    contrast: float = 8.0
    """least difference of dark and light [grey values]"""
    iterations: int = 15


@dataclass(frozen=True, slots=True, kw_only=True)
class Corners:
    """Fitted corners."""

    xy_px: Array
    """(n, 2) pixel frame"""
    covariance: Array
    """(n, 2, 2) [px^2], from the residuals of the grey values alone"""
    contrast: Array
    """(n,) grey value of the squares that hold the bisector of +u and +v, less that of the other two"""
    residual: Array
    """(n,) standard deviation of a grey value, in units of the contrast"""
    blur_px: Array
    """(n,) standard deviation of the blur"""
    measured: Mask
    """(n,) whether the fit came to its end within its limits"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Windows:
    """Where corners are fitted."""

    xy_px: Array
    """(n, 2) approximate corners"""
    u: Array
    v: Array
    """(n, 2) arms: half the window along the two edges [px]"""
    band: Array
    """(n, 2) distance from an edge up to which pixels count, in arms"""
    half: Array
    """(n,) the longer arm; a step is at most half of it [px]"""


def fit_corners(image: Array, xy_px: Array, u: Array, v: Array, options: CornerOptions | None = None) -> Corners:
    """Fit corners from approximate places.

    image  (h, w) uint8 or uint16
    xy_px  (n, 2) approximate corners, pixel frame
    u, v   (n, 2) vectors to the next corners along the two edges [px]

    What the covariance does not show: that edges are straight and squares evenly dark; JPEG makes noise that hangs
    together from pixel to pixel.
    """
    o = options or CornerOptions()
    xy = np.asarray(xy_px, float).reshape(-1, 2)
    n = len(xy)
    if not n:
        none = np.zeros(0)
        return Corners(
            xy_px=xy, covariance=np.zeros((0, 2, 2)), contrast=none, residual=none, blur_px=none, measured=none > 0
        )
    lengths = np.stack([np.hypot(*u.T), np.hypot(*v.T)], axis=1)
    shrink = np.minimum(o.reach, o.most_px / np.maximum(lengths, 1e-9))
    windows = Windows(
        xy_px=xy,
        u=shrink[:, :1] * u,
        v=shrink[:, 1:] * v,
        band=np.maximum(o.band * lengths - o.clear_px, 1.2) / np.maximum(shrink * lengths, 1e-9),
        half=(shrink * lengths).max(axis=1),
    )
    module = native.module()
    if module is None:
        p, Q, variance, ended = fit_twin(image, windows, o.contrast / 2, o.iterations)
    else:
        w = [np.ascontiguousarray(k, float) for k in (xy, windows.u, windows.v, windows.band, windows.half)]
        grey = np.ascontiguousarray(image, np.uint16)
        p, packed, variance, steady = module.fit_corners(grey, *w, o.contrast / 2, o.iterations)
        Q, ended = packed[:, [0, 2, 2, 1]].reshape(-1, 2, 2), steady > 0
    contrast = 2 * p[:, HALF]
    residual = np.sqrt(variance) / np.maximum(abs(contrast), 1e-9)
    measured = ended & (abs(contrast) >= o.contrast) & (residual < o.residual)
    measured &= np.hypot(*(p[:, :2] - (xy - np.floor(xy) - 0.5)).T) < o.moved * windows.half
    return Corners(
        xy_px=p[:, :2] + np.floor(xy) + 0.5,
        covariance=Q * variance[:, None, None],
        contrast=contrast,
        residual=residual,
        blur_px=p[:, S],
        measured=measured,
    )


def fit_twin(image: Array, windows: Windows, least: float, iterations: int) -> tuple[Array, Array, Array, Mask]:
    """The fit with NumPy: unknowns, cofactors of the corner, variances of a grey value, whether each came to its end.

    least    half the contrast below which nothing is fitted
    returns  (n, 9), the corner relative to the middle of the pixel of the start; (n, 2, 2); (n,); (n,)
    """
    w = windows
    grey, dx, dy, weight, inside = _pixels(image, w.xy_px, w.u, w.v, w.band)
    p = _start(w.xy_px, w.u, w.v, grey, dx, dy, weight)
    lively = inside & (abs(p[:, HALF]) > least)
    p, Q, variance, ended = _iterate(p, grey, dx, dy, weight, w.half, lively, iterations)
    return p, Q[:, :2, :2], variance, ended


def _pixels(image: Array, xy: Array, u: Array, v: Array, band: Array) -> tuple[Array, Array, Array, Array, Mask]:
    """Grey values (n, m), offsets dx, dy (n, m) from the pixel of the start, weights (n, m) 0 or 1; windows within."""
    h, w = image.shape
    base = np.floor(xy).astype(np.int64)
    reach = np.ceil((abs(u) + abs(v)).max(axis=0)).astype(int) + 1
    ix, iy = (k.reshape(-1) for k in np.meshgrid(*(np.arange(-r, r + 1) for r in reach)))
    px, py = base[:, :1] + ix, base[:, 1:] + iy
    grey = image[np.clip(py, 0, h - 1), np.clip(px, 0, w - 1)].astype(float)
    # (dx, dy) = a u + b v
    dx, dy = ix - (xy - base - 0.5)[:, :1], iy - (xy - base - 0.5)[:, 1:]
    det = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    det = np.where(abs(det) < 1e-9, 1e-9, det)[:, None]
    a = abs(v[:, 1:] * dx - v[:, :1] * dy) / abs(det)
    b = abs(u[:, :1] * dy - u[:, 1:] * dx) / abs(det)
    weight = (np.maximum(a, b) <= 1) & ((a <= band[:, :1]) | (b <= band[:, 1:]))
    off = (px < 0) | (py < 0) | (px >= w) | (py >= h)
    count = weight.sum(axis=1)
    inside = ~(weight & off).any(axis=1) & (count > 2 * UNKNOWNS)
    # only what counts is carried on
    kept = np.argsort(~weight, axis=1, kind="stable")[:, : max(1, int(count.max()))]
    grey, weight = (np.take_along_axis(k, kept, axis=1) for k in (grey, weight))
    return grey, ix[kept].astype(float), iy[kept].astype(float), weight.astype(float), inside


def _start(xy: Array, u: Array, v: Array, grey: Array, dx: Array, dy: Array, weight: Array) -> Array:
    """Approximate unknowns (n, 9): corner relative to the pixel of the start; levels from the four squares."""
    p = np.zeros((len(xy), UNKNOWNS))
    p[:, :2] = xy - np.floor(xy) - 0.5
    turn = np.sign(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    # the normal of the edge along u looks to +v, that of the edge along v to +u
    p[:, A1] = np.arctan2(u[:, 0] * turn, -u[:, 1] * turn)
    p[:, A2] = np.arctan2(-v[:, 0] * turn, v[:, 1] * turn)
    p[:, S] = 0.8
    x, y = dx - p[:, :1], dy - p[:, 1:2]
    side = np.sign(_across(x, y, p[:, A1]) * _across(x, y, p[:, A2]))
    up, down = weight * (side > 0), weight * (side < 0)
    one, other = ((grey * k).sum(axis=1) / np.maximum(k.sum(axis=1), 1) for k in (up, down))
    p[:, MEAN], p[:, HALF] = (one + other) / 2, (one - other) / 2
    return p


def _across(x: Array, y: Array, angle: Array) -> Array:
    return x * np.cos(angle)[:, None] + y * np.sin(angle)[:, None]


def _evaluate(p: Array, grey: Array, dx: Array, dy: Array, weight: Array) -> tuple[Array, Array, Array]:
    """Normal equations (n, 9, 9), (n, 9) and sums of squares (n,)."""
    from scipy.special import erf

    x, y = dx - p[:, :1], dy - p[:, 1:2]
    s = p[:, S, None]
    c1, q1, c2, q2 = (f(p[:, k])[:, None] for k in (A1, A2) for f in (np.cos, np.sin))
    d1, d2 = x * c1 + y * q1, x * c2 + y * q2
    z1, z2 = d1 / (s * np.sqrt(2)), d2 / (s * np.sqrt(2))
    e1, e2 = erf(z1), erf(z2)
    half = p[:, HALF, None]
    k = half * np.sqrt(2 / np.pi) / s
    g1, g2 = k * np.exp(-(z1**2)) * e2, k * np.exp(-(z2**2)) * e1
    J = np.empty((*grey.shape, UNKNOWNS))
    J[..., X0] = -(g1 * c1 + g2 * c2)
    J[..., Y0] = -(g1 * q1 + g2 * q2)
    J[..., A1] = g1 * (y * c1 - x * q1)
    J[..., A2] = g2 * (y * c2 - x * q2)
    J[..., S] = -(g1 * d1 + g2 * d2) / s
    J[..., MEAN] = 1
    J[..., HALF] = e1 * e2
    J[..., GX] = x
    J[..., GY] = y
    e = (grey - p[:, MEAN, None] - half * e1 * e2 - p[:, GX, None] * x - p[:, GY, None] * y) * weight
    J *= weight[..., None]
    JT = J.transpose(0, 2, 1)
    return JT @ J, (JT @ e[..., None])[..., 0], (e**2).sum(axis=1)


def _iterate(
    p: Array, grey: Array, dx: Array, dy: Array, weight: Array, half: Array, lively: Mask, iterations: int
) -> tuple[Array, Array, Array, Mask]:
    """Levenberg and Marquardt for all corners: unknowns, cofactors (n, 9, 9), variances (n,), whether each ended."""
    n = len(p)
    ended, damping = np.zeros(n, bool), np.full(n, 1e-3)
    Q, freedom = np.zeros((n, UNKNOWNS, UNKNOWNS)), np.maximum(weight.sum(axis=1) - UNKNOWNS, 1)
    N, b, square = _evaluate(p, grey, dx, dy, weight)
    going = np.flatnonzero(lively)
    diagonal = np.arange(UNKNOWNS)
    for _ in range(iterations):
        if not len(going):
            break
        L = N[going]
        scale = np.sqrt(np.maximum(L[:, diagonal, diagonal], 1e-12))
        L = L / (scale[:, :, None] * scale[:, None])
        L[:, diagonal, diagonal] += damping[going, None] + 1e-9
        # the least blur allowed is held
        L[:, S, S] += 1e9 * ((p[going, S] <= SHARPEST) & (b[going, S] < 0))
        d = np.linalg.solve(L, (b[going] / scale)[..., None])[..., 0] / scale
        limits = np.stack([half[going] / 2, half[going] / 2, *[np.full(len(going), 0.3)] * 2, p[going, S] / 2], axis=1)
        d *= np.minimum(1, (limits / np.maximum(abs(d[:, :5]), 1e-12)).min(axis=1))[:, None]
        new = p[going] + d
        new[:, S] = np.clip(new[:, S], SHARPEST, SOFTEST)
        N_new, b_new, square_new = _evaluate(new, grey[going], dx[going], dy[going], weight[going])
        better = square_new <= square[going] * (1 + 1e-9)
        taken = going[better]
        p[taken], N[taken], b[taken], square[taken] = new[better], N_new[better], b_new[better], square_new[better]
        damping[going] = np.where(better, np.maximum(damping[going] / 10, 1e-7), damping[going] * 10)
        small = better & (np.hypot(d[:, X0], d[:, Y0]) < 1e-3)  # the next step would be its square
        ended[going[small]] = True
        lost = damping[going] > 1e6
        going = going[~small & ~lost]
    fine = np.flatnonzero(ended)
    if len(fine):
        scale = np.sqrt(N[fine][:, diagonal, diagonal])
        ended[fine] = (scale > 1e-6).all(axis=1)
        scale = np.maximum(scale, 1e-6)
        A = N[fine] / (scale[:, :, None] * scale[:, None]) + 1e-12 * np.eye(UNKNOWNS)
        Q[fine] = np.linalg.inv(A) / (scale[:, :, None] * scale[:, None])
    return p, Q, np.maximum(square / freedom, ROUNDING), ended
