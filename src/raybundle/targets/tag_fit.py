"""Corners of small tags, whose sides are a few pixels long: the whole drawn tag fitted to the grey values.

A tag of n x n modules, light or dark, is a sum of products of blurred steps along its two sides.  With (u, v) the
place of a pixel in modules, by the homography of the four corners,

    P(u, v) = sum_ij B_ij F_i(u) F_j(v),    F_i(u) = (erf((u - i) / (s_u sqrt 2)) - erf((u - i - 1) / (s_u sqrt 2))) / 2
    grey = (dark + (light - dark) P) (1 + g_x x + g_y y)

s_u is the blur s and the breadth of a pixel (variance 1/12) over the length of a module along u, so that the image of
a module that is smaller than a pixel is still its mean.  Thirteen unknowns: eight coordinates of the corners, s, dark,
light, g_x, g_y.  Every edge within the tag shows the corners, not only its rim.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

CORNERS = 8
S, DARK, LIGHT, GX, GY = range(CORNERS, CORNERS + 5)
UNKNOWNS = CORNERS + 5
ROUNDING = 1 / 12
PIXEL = 1 / 12
"""Variance of a place within a pixel [px^2]."""
SHARPEST, SOFTEST = 0.05, 2.0
"""Limits of the blur, the latter in modules beyond which no tag is read [px, modules]."""
FIRST_S = 0.6


@dataclass(frozen=True, slots=True, kw_only=True)
class TagOptions:
    """What counts as a tag that was drawn."""

    around: float = 1.0
    """light rim around the tag that takes part, in modules: as much as every tag must have"""
    residual: float = 0.12
    """largest standard deviation of a grey value, in units of the contrast"""
    contrast: float = 8.0
    """least difference of dark and light [grey values]"""
    moved: float = 2.0
    """farthest that a corner may move from where it was seen, in modules, or pixels where those are larger: the finder
    strays by a module, and a tag moved farther would not look like itself"""
    iterations: int = 20


@dataclass(frozen=True, slots=True, kw_only=True)
class FittedTags:
    """Corners of tags in the order in which they were given."""

    xy_px: Array
    """(n, 4, 2)"""
    covariance: Array
    """(n, 4, 2, 2) [px^2], from the residuals of the grey values alone; corners of one tag are correlated besides"""
    residual: Array
    """(n,) standard deviation of a grey value, in units of the contrast"""
    measured: Mask
    """(n,)"""


def fit_tags(image: Array, corners: Array, bits: Index, options: TagOptions | None = None) -> FittedTags:
    """Fit tags from approximate corners.

    image    (h, w) uint8 or uint16
    corners  (n, 4, 2) of the black square, the upper left one first, clockwise as the tag is drawn, pixel frame
    bits     (n, m, m) modules of each tag, rim included, 1 light and 0 dark, row by row

    What the covariance does not show: that the tag is plane, and printed as it should be.
    """
    o = options or TagOptions()
    n = len(corners)
    xy, C = np.array(corners, float), np.zeros((n, 4, 2, 2))
    residual, measured = np.zeros(n), np.zeros(n, bool)
    for k in range(n):
        found = _fit(image, xy[k], np.asarray(bits[k], float), o)
        if found is not None:
            xy[k], C[k], residual[k] = found
            measured[k] = True
    return FittedTags(xy_px=xy, covariance=C, residual=residual, measured=measured)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Window:
    """Pixels of a tag: places (m, 2), those from the middle, grey values (m,)."""

    xy: Array
    off: Array
    grey: Array


def _fit(image: Array, start: Array, bits: Array, o: TagOptions) -> tuple[Array, Array, float] | None:
    """Corners (4, 2), covariances (4, 2, 2), residual; None where they do not settle or are none of a tag."""
    module = float(np.hypot(*(np.roll(start, -1, axis=0) - start).T).min()) / len(bits)
    if not module > 0:
        return None
    place = _window(image, start, bits, o)
    if place is None:
        return None
    p = np.zeros(UNKNOWNS)
    p[:CORNERS], p[S] = start.ravel(), FIRST_S
    P = _pattern(p, place, bits)[0]
    level = np.stack([1 - P, P], axis=1)
    p[[DARK, LIGHT]] = np.linalg.lstsq(level, place.grey, rcond=None)[0]
    if not p[LIGHT] - p[DARK] > o.contrast / 2:
        return None
    solved = _iterate(p, place, bits, module, o)
    if solved is None:
        return None
    p, N, square = solved
    variance = max(square / max(len(place.grey) - UNKNOWNS, 1), ROUNDING)
    contrast = p[LIGHT] - p[DARK]
    residual = float(np.sqrt(variance)) / max(contrast, 1e-9)
    xy = p[:CORNERS].reshape(4, 2)
    far = float(np.hypot(*(xy - start).T).max())
    if contrast < o.contrast or residual > o.residual or far > o.moved * max(module, 1.0):
        return None
    scale = np.sqrt(np.diag(N))
    A = N / np.outer(scale, scale) + 1e-9 * np.eye(UNKNOWNS)
    Q = np.linalg.inv(A) / np.outer(scale, scale) * variance
    C = np.stack([Q[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] for k in range(4)])
    return xy, C, residual


def _iterate(p: Array, place: _Window, bits: Array, module: float, o: TagOptions) -> tuple[Array, Array, float] | None:
    """Unknowns, normal matrix and sum of squares where the corners settle; None where they do not."""
    J, r = _evaluate(p, place, bits)
    square, damping, small = float(r @ r), 1e-3, False
    for _ in range(o.iterations):
        N, right = J.T @ J, J.T @ r
        scale = np.sqrt(np.maximum(np.diag(N), 1e-12))
        A = N / np.outer(scale, scale) + (damping + 1e-9) * np.eye(UNKNOWNS)
        step = np.linalg.solve(A, right / scale) / scale
        step *= min(1.0, 0.5 * module / max(float(np.abs(step[:CORNERS]).max()), 1e-12))
        new = p + step
        new[S] = np.clip(new[S], SHARPEST, SOFTEST * module)
        Jn, rn = _evaluate(new, place, bits)
        better = float(rn @ rn) <= square * (1 + 1e-9)
        small = better and bool(np.abs(step[:CORNERS]).max() < 1e-3)
        if better:
            p, J, r, square = new, Jn, rn, float(rn @ rn)
        damping = max(damping / 10, 1e-7) if better else damping * 10
        if small or damping > 1e6:
            break
    N = J.T @ J
    return (p, N, square) if small and (np.diag(N) > 1e-12).all() else None


def _window(image: Array, corners: Array, bits: Array, o: TagOptions) -> _Window | None:
    """The pixels of a tag and its rim; None where the image cuts into the tag itself."""
    h, w = image.shape
    n = len(bits)
    if (corners < 0).any() or (corners > [w, h]).any():
        return None
    around = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * o.around + np.array([[0, 0], [n, 0], [n, n], [0, n]])
    H = _homography(corners, n)
    if H is None:
        return None
    outer, _ = _mapped(H, around.astype(float))
    low = np.maximum(np.floor(outer.min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(outer.max(axis=0)).astype(int), [w, h])
    x, y = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
    xy = np.stack([x.ravel(), y.ravel()], axis=1) + 0.5
    uv, _ = _mapped(np.linalg.inv(H), xy)
    inside = (np.abs(uv - n / 2) <= n / 2 + o.around).all(axis=1)
    if inside.sum() < 3 * UNKNOWNS:
        return None
    grey = image[y.ravel()[inside], x.ravel()[inside]].astype(float)
    return _Window(xy=xy[inside], off=xy[inside] - corners.mean(axis=0), grey=grey)


def _homography(corners: Array, n: int) -> Array | None:
    """(3, 3) from modules to pixels, of the corners (4, 2) of n modules; None where they lie on a line."""
    uv = np.array([[0, 0], [n, 0], [n, n], [0, n]], float)
    A = np.zeros((8, 8))
    for k, ((u, v), (x, y)) in enumerate(zip(uv, corners, strict=True)):
        A[2 * k] = [u, v, 1, 0, 0, 0, -u * x, -v * x]
        A[2 * k + 1] = [0, 0, 0, u, v, 1, -u * y, -v * y]
    try:
        h = np.linalg.solve(A, corners.ravel())
    except np.linalg.LinAlgError:
        return None
    H = np.append(h, 1.0).reshape(3, 3)
    return H if abs(np.linalg.det(H)) > 1e-9 else None


def _mapped(H: Array, points: Array) -> tuple[Array, Array]:
    """Points (m, 2) by a homography, and the derivatives (m, 2, 2) of them."""
    q = points @ H[:, :2].T + H[:, 2]
    at = q[:, :2] / q[:, 2:]
    return at, (H[None, :2, :2] - at[:, :, None] * H[None, 2:, :2]) / q[:, 2, None, None]


def _steps(u: Array, sigma: Array, n: int) -> tuple[Array, Array, Array]:
    """F (m, n) of n modules, its derivatives by u and by sigma."""
    from scipy.special import erf

    z = (u[:, None] - np.arange(n + 1)) / sigma[:, None]
    whole = 0.5 * erf(z / np.sqrt(2))
    bell = np.exp(-0.5 * z * z) / np.sqrt(2 * np.pi)
    by_u, by_sigma = bell / sigma[:, None], -bell * z / sigma[:, None]
    return tuple(a[:, :-1] - a[:, 1:] for a in (whole, by_u, by_sigma))  # pyright: ignore[reportReturnType]


def _pattern(p: Array, place: _Window, bits: Array) -> tuple[Array, Array, Array, Array]:
    """P (m,), its derivatives by (u, v) (m, 2) and by s (m,), and those of a place by the tag's (m, 2, 2)."""
    n = len(bits)
    H = _homography(p[:CORNERS].reshape(4, 2), n)
    if H is None:
        H = np.eye(3) * np.nan
    with np.errstate(all="ignore"):
        uv, _ = _mapped(np.linalg.inv(H), place.xy) if np.isfinite(H).all() else (np.full(place.xy.shape, np.nan), None)
        _, J = _mapped(H, uv)
        module = np.sqrt((J**2).sum(axis=1))  # px per module along u, v
        spread = np.sqrt(p[S] ** 2 + PIXEL)
        sigma = spread / module
        sigma_by_s = p[S] / spread / module
        Fu, Fu_u, Fu_s = _steps(uv[:, 0], sigma[:, 0], n)
        Fv, Fv_v, Fv_s = _steps(uv[:, 1], sigma[:, 1], n)
    across, down = Fv @ bits, Fu @ bits.T  # over rows, over columns
    # beyond the tag all is light
    light = 1 - Fu.sum(axis=1) * Fv.sum(axis=1)
    P = (across * Fu).sum(axis=1) + light
    rim_u, rim_v = -Fu_u.sum(axis=1) * Fv.sum(axis=1), -Fv_v.sum(axis=1) * Fu.sum(axis=1)
    by_uv = np.stack([(across * Fu_u).sum(axis=1) + rim_u, (down * Fv_v).sum(axis=1) + rim_v], axis=1)
    by_su = (across * Fu_s).sum(axis=1) - Fu_s.sum(axis=1) * Fv.sum(axis=1)
    by_sv = (down * Fv_s).sum(axis=1) - Fv_s.sum(axis=1) * Fu.sum(axis=1)
    return P, by_uv, by_su * sigma_by_s[:, 0] + by_sv * sigma_by_s[:, 1], J


def _evaluate(p: Array, place: _Window, bits: Array) -> tuple[Array, Array]:
    """Jacobian (m, 13) of the grey values and what is left of them (m,); infinite where the corners are none."""
    n, corners = len(bits), p[:CORNERS].reshape(4, 2)
    P, by_uv, by_s, J = _pattern(p, place, bits)
    if not np.isfinite(P).all():
        return np.zeros((len(P), UNKNOWNS)), np.full(len(P), np.inf)
    contrast = p[LIGHT] - p[DARK]
    slope = 1 + place.off @ p[[GX, GY]]
    level = p[DARK] + contrast * P
    D = np.zeros((len(P), UNKNOWNS))
    H = _homography(corners, n)
    assert H is not None
    uv, _ = _mapped(np.linalg.inv(H), place.xy)
    inverse = np.linalg.inv(J)
    for k in range(CORNERS):
        moved = corners.copy()
        moved.ravel()[k] += MOVE
        other = _homography(moved, n)
        if other is None:
            return np.zeros((len(P), UNKNOWNS)), np.full(len(P), np.inf)
        at, _ = _mapped(other, uv)
        by_corner = -np.einsum("mij,mj->mi", inverse, (at - place.xy) / MOVE)
        D[:, k] = contrast * (by_uv * by_corner).sum(axis=1) * slope
    D[:, S] = contrast * by_s * slope
    D[:, DARK], D[:, LIGHT] = (1 - P) * slope, P * slope
    D[:, [GX, GY]] = level[:, None] * place.off
    return D, place.grey - level * slope


MOVE = 1e-4
"""Of a corner, for the derivatives of a homography by it [px]: these are smooth over a module."""
