"""Covariance of the displacements of subsets, from the noise of both images."""

from __future__ import annotations

import numpy as np

from raybundle.matching.least_squares import LEAST_SHARE, WindowMatches, WindowOptions
from raybundle.matching.spline_pictures import TAPS, Picture, coefficient_taps
from raybundle.numerics.arrays import Array, Index, Mask

GRADIENT_NOISE = 9 * (2 / np.sqrt(3) - 1)
"""Variance of the spline's slope at a pixel, of white noise of variance 1: the mean of (3 sin w / (2 + cos w))^2"""
WEAK_PX = 0.15
"""Standard deviation of a displacement, from which on its subset is called flat."""
NOISE_F = 2.0
"""Quantile of 99.9 % of the test quantity of `part_displacements` under noise alone, in windows of 21 to 41 px."""
SAMPLE, LAGS = 300, 8
"""Subsets from which the correlation of noise is estimated, and the distance up to which it is [px]: a JPEG block."""


def lost_contrast(correlation: Array, window: WindowOptions) -> Array:
    """Variance of residuals, in units of the contrast."""
    count = (2 * window.half + 1) ** 2
    return np.maximum(2 * (1 - correlation) * count / (count - window.unknowns), 1e-12)


def part_displacements(m: WindowMatches, window: WindowOptions) -> tuple[Array, Array]:
    """Displacement [px] of the ninths of windows against their shape, noise taken off, and its test quantity.

    The sums S of b b' over the parts are in the mean s^2 T of noise alone, and T d d' T / 9 of displacements d.
    """
    lost = lost_contrast(m.correlation, window)
    S, T = (m.residual[:, [k, k + 1, k + 1, k + 2]].reshape(-1, 2, 2) for k in (2, 5))
    S = S * (lost / np.maximum(m.residual[:, 0], 1e-300))[:, None, None]
    size = np.maximum(np.trace(T, axis1=1, axis2=2), 1e-300)
    inverse = np.linalg.inv(T + 1e-9 * size[:, None, None] * np.eye(2))
    both, noise = (np.trace(k, axis1=1, axis2=2) for k in (inverse @ S @ inverse, inverse * lost[:, None, None]))
    return np.sqrt(9 * np.maximum(both - noise, 0)), np.trace(inverse @ S, axis1=1, axis2=2) / (2 * lost)


def displacement_covariance(
    reference: Picture, target: Picture, xy: Array, m: WindowMatches, rows: Index, window: WindowOptions
) -> tuple[Array, Array]:
    """Covariances (n, 2, 2) of displacements, and standard deviations (n, 2) of a grey value of both images.

    xy  (n, 2) of the rows in the reference

    Residuals hold the noise of the reference and that of the target, which interpolation reduces by a share that
    depends on the place between the pixels.  The gradients of textures lie where interpolation reduces nothing, so
    that the variance of two whole noises counts.  The gradients' noise is no information (`with_noisy_gradients`).
    """
    lost = lost_contrast(m.correlation[rows], window)
    reduced = _noise_share(m, rows, window.half)
    difference = _roughness(target.grey, m.xy_px[rows], window.half) - _roughness(reference.grey, xy, window.half)
    own = np.clip(np.median((1 - reduced * difference / lost) / (1 + reduced)), 0, 1)
    first, second = own * lost, (1 - own) * lost / reduced
    B = m.affine[rows]
    back = np.linalg.inv(B)
    Q = m.cov_px2[rows][:, [0, 2, 2, 1]].reshape(-1, 2, 2) / lost[:, None, None]
    N = np.linalg.inv(back @ Q @ back.swapaxes(1, 2))
    values, vectors = np.linalg.eigh(N)
    count = 1 / np.square(shift_kernel(window.half, quadratic=window.quadratic)).sum()
    share = np.maximum(1 - count * GRADIENT_NOISE * first[:, None] / values, LEAST_SHARE)
    C = np.einsum("nij,nj,nkj->nik", vectors, (first + second)[:, None] / (values * share**2), vectors)
    noise = np.sqrt(np.stack([first, second], axis=1) * (m.residual[rows, 0] / lost)[:, None])
    D = B * np.sqrt(_coloured_noise(reference, target, xy, m, rows, window, first + second))
    return D @ C @ D.swapaxes(1, 2), noise / reference.scale


def _coloured_noise(
    reference: Picture, target: Picture, xy: Array, m: WindowMatches, rows: Index, window: WindowOptions, total: Array
) -> Array:
    """(2,) variance of displacements along x and y by that of white noise, 1 at least.

    total  (n,) variance of white noise of the difference, in units of the contrast

    J'e has the variance sum c(d) G(d) over distances d, of the autocorrelations c of noise and G of gradients, both as
    means of some windows.  Residuals have less than the noise: (I - P) c (I - P) of the projection P on the design.
    """
    from scipy.ndimage import map_coordinates

    fit = np.flatnonzero(part_displacements(m, window)[1][rows] < NOISE_F)  # residuals of others are no noise alone
    fit = fit if len(fit) else np.arange(len(rows))
    some = fit[np.unique(np.linspace(0, len(fit) - 1, SAMPLE).astype(int))]
    side, half = 2 * window.half + 1, window.half
    v, u = (a.ravel() for a in np.mgrid[-half : half + 1, -half : half + 1])
    at = np.floor(xy[some]).astype(int)
    h, w = reference.grey.shape
    y, x = (np.clip(at[:, k, None] + a, 1, n - 2) for k, a, n in ((1, v, h), (0, u, w)))
    T = reference.grey.astype(float)
    R, gx, gy = T[y, x], (T[y, x + 1] - T[y, x - 1]) / 2, (T[y + 1, x] - T[y - 1, x]) / 2
    second = np.stack([u * u / 2, u * v, v * v / 2])
    place = m.affine[rows[some]] @ np.stack([u, v]) + m.bend[rows[some]] @ second + m.xy_px[rows[some], :, None]
    # two coefficients a pixel, the first of them in its middle
    S = map_coordinates(target.coefficients, 2 * place[:, ::-1].swapaxes(0, 1) - 1, float, order=3, prefilter=False)
    R, S = ((a - a.mean(axis=1, keepdims=True)) / np.maximum(a.std(axis=1, keepdims=True), 1e-9) for a in (R, S))
    ones, columns = np.ones_like(R), [gx, gy, gx * u, gx * v, gy * u, gy * v]
    if window.quadratic:
        columns += [g * s for g in (gx, gy) for s in second]
    design = np.linalg.qr(np.stack([*columns, ones, R, R * u, R * v], axis=2) + 1e-12)[0]
    e = S - R
    e -= np.einsum("nik,nk->ni", design, np.einsum("nik,ni->nk", design, e))

    def auto(a: Array) -> Array:
        """Of (n, pixels, k) the sums over k and means over n, by distances (2 LAGS - 1, 2 LAGS - 1)."""
        size = [side + LAGS] * 2
        power = np.abs(np.fft.rfft2(a.reshape(len(a), side, side, -1), size, axes=(1, 2))) ** 2
        near = np.arange(-LAGS + 1, LAGS)
        return np.fft.irfft2(power.mean(axis=0).sum(axis=-1), size)[near[:, None], near]

    pairs = auto(ones[:1, :, None])
    c = auto((e / np.sqrt(total[some])[:, None])[..., None]) / pairs
    P = auto(design) / pairs
    contrast = np.maximum(T[y, x].std(axis=1, keepdims=True), 1e-9)
    G = [auto((g / contrast)[..., None]) / pairs for g in (gx, gy)]
    return np.array([max((c * g).sum() / (g.max() - (P * g).sum()), 1.0) for g in G])


def shift_kernel(half: int, *, quadratic: bool) -> Array:
    """(side, side): weights of the pixels of a window in its displacement, by what its shape leaves to the shift."""
    side = 2 * half + 1
    u = np.arange(-half, half + 1.0)
    x, y = (a.ravel() for a in np.meshgrid(u, u))
    columns = [np.ones_like(x), x, y, *([x * x, x * y, y * y] if quadratic else [])]
    return np.linalg.pinv(np.stack(columns, axis=1))[0].reshape(side, side)


def overlap_correlation(window: WindowOptions, step: int, reach: int) -> Array:
    """Correlations of displacements of overlapping subsets, (2 reach + 1, 2 reach + 1) by steps between.

    Noise of pixels that two subsets share is common to both.  Of texture that is alike everywhere; a plane shape
    weighs pixels equally, a quadratic one by a - b (u^2 + v^2).
    """
    kernel, side = shift_kernel(window.half, quadratic=window.quadratic), 2 * window.half + 1
    found = np.zeros((2 * reach + 1, 2 * reach + 1))
    for i in range(-reach, reach + 1):
        for j in range(-reach, reach + 1):
            di, dj = abs(i) * step, abs(j) * step
            if max(di, dj) < side:
                found[i + reach, j + reach] = (kernel[di:, dj:] * kernel[: side - di, : side - dj]).sum()
    return found / found[reach, reach]


def weak_texture(reference: Picture, xy: Array, half: int, noise: Array) -> Mask:
    """(n,) where gradients of the reference promise no useful displacement, at noises (2,) of both images."""
    import cv2

    gx, gy = (cv2.Sobel(reference.grey, cv2.CV_64F, k, 1 - k, ksize=1) / 2 for k in (1, 0))
    side, at = (2 * half + 1, 2 * half + 1), np.floor(xy).astype(int)
    xx, yy, xy_ = (
        cv2.boxFilter(a * b, cv2.CV_64F, side, normalize=False)[at[:, 1], at[:, 0]]
        for a, b in ((gx, gx), (gy, gy), (gx, gy))
    )
    own = side[0] ** 2 * noise[0] ** 2 / 2  # of noise alone
    least = (xx + yy) / 2 - np.hypot((xx - yy) / 2, xy_) - own
    return least * WEAK_PX**2 < noise @ noise


def _roughness(grey: Array, xy: Array, half: int) -> Array:
    """(n,) variance of what differs from pixel to pixel, as white noise does, by that of the window around places.

    Second differences along rows and columns, of which white noise of variance 1 has the variance 1.
    """
    import cv2

    values = grey.astype(np.float32)
    second = np.array([1.0, -2.0, 1.0], np.float32) / np.float32(np.sqrt(6))
    side = (2 * half + 1, 2 * half + 1)
    rough = cv2.sepFilter2D(values, cv2.CV_32F, second, second) ** 2
    mean = cv2.boxFilter(values, cv2.CV_64F, side)
    variance = cv2.sqrBoxFilter(values, cv2.CV_64F, side, normalize=True) - mean**2
    at = np.floor(xy).astype(int)
    found = cv2.boxFilter(rough, cv2.CV_64F, side) / np.maximum(variance, 1e-9)
    return found[at[:, 1], at[:, 0]]


def _noise_share(m: WindowMatches, rows: Index, half: int) -> Array:
    """(n,) variance of interpolated white noise of variance 1, in the mean of each window in the target."""
    t = np.linspace(0, 1, 65)
    weights = np.zeros((len(t), 2 * TAPS + 1))
    for j, taps in enumerate(coefficient_taps(2)):
        for offset in range(-2, 4):  # coefficients at offset + j / 2
            a = np.abs(2 * (t - offset) - j)
            basis = np.where(a < 1, 4 - 6 * a**2 + 3 * a**3, np.maximum(2 - a, 0) ** 3) / 6
            weights += basis[:, None] * np.roll(taps, offset)
    table = (weights**2).sum(axis=1)
    side = np.arange(-half, half + 1, max(half // 5, 1))
    u = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2).astype(float)
    second = np.stack([u[:, 0] ** 2 / 2, u[:, 0] * u[:, 1], u[:, 1] ** 2 / 2], axis=1)
    found = np.empty(len(rows))
    for k in range(0, len(rows), 4096):
        at = rows[k : k + 4096]
        xy = m.xy_px[at, None] - 0.5 + u @ m.affine[at].swapaxes(1, 2) + second @ m.bend[at].swapaxes(1, 2)
        found[k : k + 4096] = np.interp(xy % 1, t, table).prod(axis=2).mean(axis=1)
    return found
