"""Centre of a round dot: least squares on grey values, with the covariance of the centre.

The perspective image of a disc is the inside of an ellipse.  Blurred by a Gaussian of standard deviation s (optics and
pixel together) it is

    f(x) = sum over the edge r(t) of Phi((r_x - x) / s) phi((r_y - y) / s) / s dr_y        (Green's theorem)

with r = centre + L (cos t, sin t), and a grey value is (ground + contrast f) (1 + g_x dx + g_y dy).  Ten unknowns:
centre, three of the lower triangle L, s, ground, contrast and the relative slope g of the light, which is bound to 0
by its standard deviation.  The sum is exact for ellipses of any size and blur; Phi of the distance to the edge is not:
it fails where the edge bends within the blur.

The centre is that of the ellipse, not the image of the disc's centre: eccentricity is for the adjustment.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index, Mask

UNKNOWNS = 10
FAR = 5.5
"""Standard deviations beyond which an edge is not felt."""
NODES = 1.1
"""Largest distance of edge points, in standard deviations."""
SHARPEST, SOFTEST = 0.3, 12.0
ROUNDING = 1 / 12
"""Variance of a whole grey value."""
X0, Y0, A, B, D, S, GROUND, CONTRAST, GX, GY = range(UNKNOWNS)
SECTORS = 32
"""Sectors by which the edge of a dot is judged."""
WIDTHS = (2, 4, 6)
"""Sectors of the parts of an edge that are judged together."""
NORMAL = 0.6744897501960817
"""Median of the absolute value of a standard normal deviate."""


class DotOutcome(IntEnum):
    """What became of a dot."""

    MEASURED = 0
    OUTSIDE = 1
    FLAT = 2
    MOVED = 3
    UNSTEADY = 4
    COVERED = 5
    """too much of it is covered: what is free does not show where the centre is (see `covered`)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DotOptions:
    """The fit."""

    iterations: int = 30
    step: float = 1e-4
    """shift of the centre below which the iteration ends [px]"""
    reach: float = 0.6
    """largest shift from the start, in semi-minor axes"""
    slope: float = 0.002
    """standard deviation of the relative change of the light [1/px]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Dots:
    """Fitted dots; rows that are not MEASURED hold the last iterate."""

    values: Array
    """(n, 10) centre x, y, L11, L21, L22, blur [px], ground, contrast, slope of the light in x and y [1/px]"""
    cov_px2: Array
    """(n, 2, 2) covariance of the centre, from the residuals of the grey values alone"""
    residual: Array
    """(n,) standard deviation of a grey value"""
    doubts: Array
    """(n, 3) signs of something that lies on the dot: see `doubts_of`"""
    outcome: Index
    """(n,) `DotOutcome`"""
    covered: Mask
    """(n,) whether only a part of the dot was used, since something lies on it"""

    @property
    def measured(self) -> Mask:
        """(n,) whether the fit came to its end."""
        return self.outcome == DotOutcome.MEASURED

    @property
    def xy_px(self) -> Array:
        """(n, 2) centres of the ellipses, pixel frame."""
        return self.values[:, :2]

    @property
    def ellipse(self) -> Array:
        """(n, 2, 2) C: the edge is where (x - centre)' C^-1 (x - centre) = 1."""
        return ellipse_from_triangle(self.values[:, A : D + 1])


def ellipse_from_triangle(abd: Array) -> Array:
    """C (n, 2, 2) = L L' of rows L11, L21, L22."""
    a, b, d = np.asarray(abd).T
    return np.stack([a * a, a * b, a * b, b * b + d * d], axis=1).reshape(-1, 2, 2)


def triangle_from_ellipse(C: Array) -> Array:
    """L11, L21, L22 (n, 3) of positive definite C (n, 2, 2)."""
    C = np.asarray(C)
    a = np.sqrt(C[:, 0, 0])
    b = C[:, 1, 0] / a
    return np.stack([a, b, np.sqrt(np.maximum(C[:, 1, 1] - b * b, 0))], axis=1)


def fit_dots(image: Array, xy_px: Array, ellipse: Array, window: Array, options: DotOptions | None = None) -> Dots:
    """Fit dots, dark or light, from approximate ellipses.

    image    (h, w) uint16 (or uint8)
    xy_px    (n, 2) approximate centres, pixel frame
    ellipse  (n, 2, 2) approximate C
    window   (n,) radii to which the ground around the dot is free of anything else

    What the covariance does not show: that the dot is round, that its ground is even, that the optics blur alike to all
    sides.  Variance components of the block decide how much is to be added.
    """
    o = options or DotOptions()
    image = np.ascontiguousarray(image, np.uint16)
    xy = np.ascontiguousarray(xy_px, float).reshape(-1, 2)
    abd = np.ascontiguousarray(triangle_from_ellipse(np.reshape(ellipse, (-1, 2, 2))))
    window = np.ascontiguousarray(np.broadcast_to(np.asarray(window, float), len(xy)))
    module = native.module()
    if module is None:
        return fit_dots_twin(image, xy, abd, window, o)
    values, cov, residual, doubts, outcome = module.fit_dots(
        image, xy, abd, window, o.iterations, o.step, o.reach, o.slope
    )
    cov = cov[:, [0, 2, 2, 1]].reshape(-1, 2, 2)
    return Dots(values=values, cov_px2=cov, residual=residual, doubts=doubts, outcome=outcome, covered=outcome < 0)


def fit_dots_twin(image: Array, xy_px: Array, triangle: Array, window: Array, options: DotOptions) -> Dots:
    """The same with NumPy, dot by dot; `triangle` (n, 3) holds L11, L21, L22."""
    n = len(xy_px)
    values = np.zeros((n, UNKNOWNS))
    values[:, :2], values[:, A : D + 1] = xy_px, triangle
    cov, residual, outcome = np.zeros((n, 2, 2)), np.zeros(n), np.zeros(n, np.int32)
    doubts = np.tile([0.0, 0.0, 1.0], (n, 1))
    for i in range(n):
        values[i], Q, residual[i], place, outcome[i] = _fit_dot(image, values[i], window[i], options)
        if place is not None:
            cov[i] = residual[i] ** 2 * Q[:2, :2]
            doubts[i] = doubts_of(values[i], Q, place, *_pictures(image, values[i], place))
    return Dots(values=values, cov_px2=cov, residual=residual, doubts=doubts, outcome=outcome, covered=outcome < 0)


@dataclass(frozen=True, slots=True, kw_only=True)
class MaskedDots:
    """Dots fitted to some of the pixels of a box; rows that are not MEASURED hold the last iterate."""

    values: Array
    """(n, 10) as those of `Dots`"""
    cov: Array
    """(n, 10, 10) covariance of all values, from the pixels that take part"""
    residual: Array
    """(n,) standard deviation of a grey value"""
    outcome: Index
    """(n,) `DotOutcome`"""
    residuals: list[Array]
    """(h, w) of each: grey value less the model, of all pixels of the box"""
    derivatives: list[Array]
    """(h, w, 10) of each: of the model by the values"""


Box = tuple[slice, slice]
"""Rows and columns."""


def fit_masked(
    image: Array, values: Array, boxes: list[Box], free: list[Mask], options: DotOptions | None = None
) -> MaskedDots:
    """Fit dots to the pixels that take part, once, from values that are near.

    image   (h, w) uint16
    values  (n, 10) start
    boxes   rows and columns of each dot, within the image
    free    (h, w) of each: pixels of the box that take part
    """
    o = options or DotOptions()
    values = np.ascontiguousarray(values, float).reshape(-1, UNKNOWNS)
    module = native.module()
    if module is None:
        return fit_masked_twin(image, values, boxes, free, o)
    box = np.array([[c.start, r.start, c.stop, r.stop] for r, c in boxes], np.int32).reshape(-1, 4)
    offset = np.cumsum([0, *(m.size for m in free)])
    flat = np.concatenate([m.ravel() for m in free]).astype(np.uint8) if free else np.zeros(0, np.uint8)
    fitted, cov, residual, outcome, e, J = module.fit_masked_dots(
        image, values, box, offset, flat, o.iterations, o.step, o.reach, o.slope
    )
    parts = list(zip(offset, offset[1:], free, strict=False))
    return MaskedDots(
        values=fitted, cov=cov, residual=residual, outcome=outcome,
        residuals=[e[i:j].reshape(m.shape) for i, j, m in parts],
        derivatives=[J[i:j].reshape(*m.shape, UNKNOWNS) for i, j, m in parts],
    )  # fmt: skip


def fit_masked_twin(image: Array, values: Array, boxes: list[Box], free: list[Mask], options: DotOptions) -> MaskedDots:
    """The same with NumPy, dot by dot."""
    n, o = len(values), options
    values, cov, residual, outcome = (
        values.copy(),
        np.zeros((n, UNKNOWNS, UNKNOWNS)),
        np.zeros(n),
        np.zeros(n, np.int32),
    )
    pictures: tuple[list[Array], list[Array]] = ([], [])
    for i, (box, mask) in enumerate(zip(boxes, free, strict=True)):
        start, outcome[i] = values[i].copy(), DotOutcome.FLAT
        if min(start[A], start[D]) > 0.5 and mask.sum() >= 2 * UNKNOWNS:
            values[i], Q, variance, outcome[i] = _iterate(image, start, (*box, mask), o, o.step)
            if outcome[i] == DotOutcome.MEASURED:
                minor, shift = min(start[A], start[D]), np.hypot(*(values[i] - start)[:2])
                cov[i], residual[i] = variance * Q, np.sqrt(variance)
                outcome[i] = DotOutcome.MOVED if shift > o.reach * minor else DotOutcome.MEASURED
        for kept, picture in zip(pictures, _pictures(image, values[i], (*box, mask)), strict=True):
            kept.append(picture)
    return MaskedDots(
        values=values, cov=cov, residual=residual, outcome=outcome, residuals=pictures[0], derivatives=pictures[1]
    )


def doubts_of(v: Array, Q: Array, place: tuple[slice, slice, Mask], e: Array, J: Array) -> Array:
    """Signs (3,) of something that lies on a dot, after a fit to whole dots.

    v, Q  (10,), (10, 10) values and their cofactor
    e, J  (h, w), (h, w, 10) residuals and derivatives of the model

    1. largest shift of a part of the edge, as a normal deviate (see `edge_shifts`);
    2. largest sum of squares of two neighbouring sectors, as a normal deviate (Wilson, Hilferty 1931);
    3. rms residual over the noise, which the differences of neighbouring residuals show: an ellipse through the
       outline of a covered dot is wrong all around, and no part of it stands out.
    The variance of a grey value in 1 and 2 is the median of that of all pairs of sectors.  An edge that is rough all
    around is no sign: 1 is in units of 3, and 2 in units of its own median, where these are more than 1.
    """
    rows, columns, within = place
    y, x = np.mgrid[rows, columns] + 0.5
    noise = difference_noise(e, within)
    e, J, k = e[within], J[within], sector_of(v, x[within], y[within])
    ee, count = (np.bincount(k, w, minlength=SECTORS) for w in (e * e, np.ones_like(e)))
    pairs, count = ee + np.roll(ee, -1), count + np.roll(count, -1)
    some = count > 0
    variance = max(float(np.median(pairs[some] / count[some])), ROUNDING) if some.any() else ROUNDING
    shift = edge_shifts(v, k, e / np.sqrt(variance), J, Q)
    square = chi_deviate(pairs[some] / variance, count[some])
    rough = float(np.sqrt(max(np.mean(e**2), ROUNDING))) / noise
    largest = square.max() / max(1.0, float(np.median(abs(square))) / NORMAL) if square.size else 0.0
    return np.array([shift.max() / max(1.0, rough), largest, rough])


def edge_shifts(v: Array, k: Index, t: Array, J: Array, Q: Array, *, fitted: bool = True) -> Array:
    """How far parts of the edge are from the ellipse: absolute normal deviates (3, 32); 0 where none is seen.

    k  (n,) sectors of pixels
    t  (n,) residuals in standard deviations of a grey value
    J  (n, 10) derivatives of the model; h = J L is what a pixel gains when the dot grows by its own size
    Q  (10, 10) cofactor of the values

    Parts are 2, 4 and 6 sectors from each on.  Of a shift of a part so long the ellipse follows a third, a half, three
    quarters: the deviate of sum(h t) is in units of what is left, sum(h^2) - (sum h J) Q (sum h J)'.  Of pixels that
    the fit does not rest on, what the ellipse is wrong by there is added.
    """
    h = J[:, A : D + 1] @ v[A : D + 1]
    ht, hh = (np.bincount(k, w, minlength=SECTORS) for w in (h * t, h * h))
    hJ = np.stack([np.bincount(k, h * column, minlength=SECTORS) for column in J.T])
    deviates = np.zeros((len(WIDTHS), SECTORS))
    for i, m in enumerate(WIDTHS):
        a, b, G = (np.sum([np.roll(w, -j, axis=-1) for j in range(m)], axis=0) for w in (ht, hh, hJ))
        left = b + (-1 if fitted else 1) * np.einsum("ik,ij,jk->k", G, Q, G)
        seen = (b > 0) & (left > 0.1 * b)
        deviates[i] = np.where(seen, abs(a) / np.sqrt(np.where(seen, left, 1)), 0)
    return deviates


def difference_noise(e: Array, some: Mask) -> float:
    """Standard deviation of grey values from differences of neighbours (h, w), which a wrong fit hardly touches."""
    across = abs(e[:, 1:] - e[:, :-1])[some[:, 1:] & some[:, :-1]]
    down = abs(e[1:] - e[:-1])[some[1:] & some[:-1]]
    both = np.concatenate([across, down])
    return max(float(np.median(both)) / (NORMAL * 2**0.5) if len(both) else 0.0, ROUNDING**0.5)


def chi_deviate(square: Array, n: Array | float) -> Array:
    """Normal deviates of sums of squares of n standard normal deviates.  Wilson, Hilferty 1931."""
    return (np.cbrt(square / n) - (1 - 2 / (9 * n))) / np.sqrt(2 / (9 * n))


def sector_of(v: Array, x: Array, y: Array) -> Index:
    """Sectors 0..31 of positions, of equal angles in the frame of the dot."""
    p = (x - v[X0]) / v[A]
    turn = np.arctan2((y - v[Y0] - v[B] * p) / v[D], p) / (2 * np.pi)
    return np.clip((np.where(turn < 0, turn + 1, turn) * SECTORS).astype(int), 0, SECTORS - 1)


def blurred_ellipse(v: Array, x: Array, y: Array) -> tuple[Array, Array]:
    """Share f (h, w) of a dot with values v in pixels with centres x (w,), y (h,), and its derivatives (6, h, w).

    Derivatives with respect to centre, L11, L21, L22 and blur.
    """
    s = v[S]
    u, w = x - v[X0], y - v[Y0]
    trace, det = v[A] ** 2 + v[B] ** 2 + v[D] ** 2, v[A] * v[D]
    major = np.sqrt((trace + np.sqrt(max(0.0, trace**2 - 4 * det**2))) / 2)
    n = max(24, int(np.ceil(2 * np.pi * major / (NODES * s))))
    t = (np.arange(n) + 0.5) * 2 * np.pi / n
    c, q = np.cos(t), np.sin(t)
    rx, ry = v[A] * c, v[B] * c + v[D] * q
    dx, dy = -v[A] * q * 2 * np.pi / n, (-v[B] * q + v[D] * c) * 2 * np.pi / n
    tx, ty = (rx[:, None] - u) / s, (ry[:, None] - w) / s
    P = np.where(abs(tx) < FAR, _normal(tx), tx > 0)
    ex, ey = (np.where(abs(z) < FAR, np.exp(-(z**2) / 2), 0) / (s * np.sqrt(2 * np.pi)) for z in (tx, ty))
    f, fx, fy, fa, fb, fd, m = (
        (ey * weight[:, None]).T @ table
        for weight, table in (
            (dy, P), (dy, ex), (-dx, ex), (c * dy, ex), (-c * dx, ex), (-q * dx, ex), (rx * dy - ry * dx, ex),
        )
    )  # fmt: skip
    fs = -(m - u * fx - w[:, None] * fy) / s
    return f, np.stack([fx, fy, fa, fb, fd, fs])


def _normal(t: Array) -> Array:
    from scipy.special import ndtr

    return ndtr(t)


def _window(image: Array, v: Array, window: float) -> tuple[slice, slice, Mask] | None:
    """Rows, columns and pixels among them whose centres lie within `window` radii."""
    h, w = image.shape
    hx, hy = window * v[A], window * np.hypot(v[B], v[D])
    if not (v[X0] - hx > 0 and v[Y0] - hy > 0 and v[X0] + hx < w and v[Y0] + hy < h):
        return None
    rows = slice(int(np.ceil(v[Y0] - hy - 0.5)), int(np.floor(v[Y0] + hy - 0.5)) + 1)
    columns = slice(int(np.ceil(v[X0] - hx - 0.5)), int(np.floor(v[X0] + hx - 0.5)) + 1)
    return rows, columns, radius_of(v, rows, columns) <= window


def radius_of(v: Array, rows: slice, columns: slice) -> Array:
    """Distances (h, w) of pixels from the centre, in radii of the dot."""
    p = (np.arange(columns.start, columns.stop) + (0.5 - v[X0])) / v[A]
    q = (np.arange(rows.start, rows.stop) + (0.5 - v[Y0])) / v[D]
    return np.hypot(p, q[:, None] - v[B] / v[D] * p)


def _evaluate(image: Array, v: Array, place: tuple[slice, slice, Mask]) -> tuple[Array, Array, float]:
    """Normal equations (10, 10), (10,) and sum of squares."""
    e, J = (a[place[2]] for a in _pictures(image, v, place))
    return J.T @ J, J.T @ e, float(e @ e)


def _pictures(image: Array, v: Array, place: tuple[slice, slice, Mask]) -> tuple[Array, Array]:
    """Residuals (h, w) and derivatives of the model (h, w, 10), of all pixels of a box."""
    rows, columns = place[:2]
    y, x = (np.arange(s.start, s.stop) + 0.5 for s in (rows, columns))
    f, derivatives = blurred_ellipse(v, x, y)
    dx, dy = np.meshgrid(x - v[X0], y - v[Y0])
    light, level = 1 + v[GX] * dx + v[GY] * dy, v[GROUND] + v[CONTRAST] * f
    J = np.stack([*(v[CONTRAST] * light * derivatives), light, light * f, level * dx, level * dy], axis=2)
    J[..., X0] -= level * v[GX]
    J[..., Y0] -= level * v[GY]
    return image[rows, columns] - level * light, J


def _iterate(
    image: Array, v: Array, place: tuple[slice, slice, Mask], o: DotOptions, step: float
) -> tuple[Array, Array, float, DotOutcome]:
    """Levenberg and Marquardt within one window: values, cofactor, variance of a grey value."""
    N, b, square = _evaluate(image, v, place)
    freedom, damping = max(1, int(place[2].sum()) - UNKNOWNS), 1e-3
    slopes = np.arange(UNKNOWNS) >= GX
    none = np.zeros((UNKNOWNS, UNKNOWNS))
    for _ in range(o.iterations):
        prior = slopes * max(square / freedom, ROUNDING) / o.slope**2
        L = N + np.diag(prior)
        Q = _inverse(L + damping * np.diag(np.diag(L)))
        if Q is None:
            return v, none, 0.0, DotOutcome.FLAT
        d = Q @ (b - prior * v)
        shorten = min(
            1, *(0.4 * min(v[A], v[D]) / np.maximum(abs(d[: D + 1]), 1e-12)), 0.5 * v[S] / max(abs(d[S]), 1e-12)
        )
        new = v + shorten * d
        new[S] = min(max(new[S], SHARPEST), SOFTEST)
        N_new, b_new, square_new = _evaluate(image, new, place)
        if not square_new + prior @ new**2 <= (square + prior @ v**2) * (1 + 1e-6):
            damping *= 10
            if not damping < 1e8:
                return v, none, 0.0, DotOutcome.UNSTEADY
            continue
        shift, growth = np.hypot(*(new - v)[:2]), abs((new - v)[A : D + 1]).max()
        v, N, b, square = new, N_new, b_new, square_new
        if shift < step and growth < 10 * step and damping < 1e-2:
            variance = max(square / freedom, ROUNDING)
            Q = _inverse(N + np.diag(slopes * variance / o.slope**2))
            return (v, none, 0.0, DotOutcome.FLAT) if Q is None else (v, Q, variance, DotOutcome.MEASURED)
        damping = max(damping * 0.1, 1e-9)
    return v, none, 0.0, DotOutcome.UNSTEADY


def _inverse(N: Array) -> Array | None:
    scale = np.sqrt(np.diag(N))
    if not (scale > 0).all():
        return None
    try:
        L = np.linalg.cholesky(N / np.outer(scale, scale))
    except np.linalg.LinAlgError:
        return None
    if not (np.diag(L) ** 2 > 1e-11).all():
        return None
    half = np.linalg.inv(L) / scale
    return half.T @ half


def _fit_dot(
    image: Array, start: Array, window: float, o: DotOptions
) -> tuple[Array, Array, float, tuple[slice, slice, Mask] | None, DotOutcome]:
    """Values, cofactor, standard deviation of a grey value, pixels (none where there is no fit)."""
    v, minor, Q, variance = start.copy(), min(start[A], start[D]), np.zeros((0, 0)), 0.0
    if not minor > 0.5:
        return v, Q, 0.0, None, DotOutcome.FLAT
    place = None
    for step in (0.02, o.step):
        place = _window(image, v, window)
        if place is None:
            return v, Q, 0.0, None, DotOutcome.OUTSIDE
        if place[2].sum() < 2 * UNKNOWNS:
            return v, Q, 0.0, None, DotOutcome.FLAT
        if step != o.step:
            radius, grey = radius_of(v, place[0], place[1])[place[2]], image[place[0], place[1]][place[2]]
            inner, outer = grey[radius < 0.6], grey[radius > (1 + window) / 2]
            v[GROUND] = outer.mean() if len(outer) else 0
            v[CONTRAST] = (inner.mean() if len(inner) else 0) - v[GROUND]
            v[S], v[GX], v[GY] = 0.8, 0, 0
            if not abs(v[CONTRAST]) > 1:
                return v, Q, 0.0, None, DotOutcome.FLAT
        v, Q, variance, outcome = _iterate(image, v, place, o, step)
        if outcome != DotOutcome.MEASURED:
            return v, Q, 0.0, None, outcome
        if not min(v[A], v[D]) > 0.5:
            return v, Q, 0.0, None, DotOutcome.FLAT
        if np.hypot(*(v[:2] - start[:2])) > o.reach * minor:
            return v, Q, 0.0, None, DotOutcome.MOVED
    return v, Q, float(np.sqrt(variance)), place, DotOutcome.MEASURED
