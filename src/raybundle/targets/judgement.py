"""Which pixels of a dot something lies on, by the residuals of a fit to those that seem free.

Means and squares of 3 x 3 pixels, and shifts of parts of the edge, are normal deviates where nothing lies there.  The
compiled kernel (cpp/covered.inl) and `covered_pixels` are the same.
"""

from __future__ import annotations

from statistics import NormalDist
from typing import Any

import numpy as np

from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Mask
from raybundle.targets.centre import (
    NORMAL,
    SECTORS,
    SOFTEST,
    UNKNOWNS,
    WIDTHS,
    A,
    Box,
    D,
    S,
    chi_deviate,
    difference_noise,
    edge_shifts,
    radius_of,
    sector_of,
)

NORMAL_DEVIATE = NormalDist()
FALSE = 0.01
"""Share of dots on which nothing lies that are looked at again, and of those that lose an arc all the same.

An arc of a sixteenth costs a tenth of the precision of a centre: a thousandth of all.
"""
HALO = 1.2
"""Standard deviations of the blur by which what stands out is enlarged.

The mean of 3 x 3 pixels stands out at 1.5 standard deviations of a grey value.  Beyond, a blurred edge that is 10 to
100 of these high falls to a tenth of that within 1.1 to 0.8 standard deviations of the blur.
"""


def covered_of(
    values: Array, cov: Array, boxes: list[Box], free: list[Mask], residuals: list[Array], derivatives: list[Array],
    strict: Mask,
) -> list[Mask]:  # fmt: skip
    """`covered_pixels` of n dots: values (n, 10), cov (n, 10, 10), strict (n,), lists of n pictures."""
    module = native.module()
    if module is None or not len(boxes):
        return [
            covered_pixels(v, C, box, some, e, J, strict=bool(s))
            for v, C, box, some, e, J, s in zip(values, cov, boxes, free, residuals, derivatives, strict, strict=True)
        ]
    size = np.array([m.size for m in free])
    offset = np.concatenate([[0], np.cumsum(size)])
    edge = NORMAL_DEVIATE.inv_cdf(1 - FALSE / (2 * len(WIDTHS) * SECTORS))
    limits = np.stack(
        [
            [NORMAL_DEVIATE.inv_cdf(1 - FALSE / (3 * n)) for n in size], np.full(len(size), edge),
            _reach(values[:, S]), strict.astype(float),
        ],
        axis=1,
    )  # fmt: skip
    flat = module.cover_dots(
        np.ascontiguousarray(values), np.ascontiguousarray(cov),
        np.array([[c.start, r.start, c.stop, r.stop] for r, c in boxes], np.int32), offset,
        np.concatenate([m.ravel() for m in free]).astype(np.uint8), np.concatenate([e.ravel() for e in residuals]),
        np.concatenate([J.reshape(-1, UNKNOWNS) for J in derivatives]), limits,
    )  # fmt: skip
    return [flat[i:j].reshape(m.shape).astype(bool) for i, j, m in zip(offset[:-1], offset[1:], free, strict=True)]


def _reach(blur: Array) -> Array:
    """Pixels (n,) around what stands out that are no longer trusted."""
    return HALO * np.minimum(blur, SOFTEST) + 0.5


def covered_pixels(v: Array, cov: Array, box: Box, free: Mask, e: Array, J: Array, *, strict: bool = False) -> Mask:
    """Pixels (h, w) of a box that something lies on, or near enough to be touched by its blurred edge.

    v, cov  (10,), (10, 10) values and their covariance
    free    (h, w) the pixels that the fit rests on: they show the noise
    e, J    (h, w), (h, w, 10) residuals and derivatives of the model

    Means and squares of 3 x 3 pixels as normal deviates, in units of their own median, and shifts of parts of the edge
    in units of the rms residual, where these are more than 1 (unless strict).  Far from the free arc a residual may be
    what the ellipse is wrong by there, which its covariance shows.
    """
    from scipy.ndimage import binary_dilation, uniform_filter

    h = J[..., A : D + 1] @ v[A : D + 1]
    noise = _noise(e, free, radius_of(v, *box), h)
    t, u = e / noise, J / noise[..., None]
    loose = np.where(free, 0, np.einsum("hwi,ij,hwj->hw", u, cov, u))
    smooth: Any = uniform_filter
    mean_u = smooth(u, (3, 3, 0), mode="nearest")
    mean, square = smooth(np.stack([t, t * t / (1 + 9 * loose)]), (0, 3, 3), mode="nearest")
    mean = 3 * abs(mean) / np.sqrt(1 + 9 * np.where(free, 0, np.einsum("hwi,ij,hwj->hw", mean_u, cov, mean_u)))
    limit = NORMAL_DEVIATE.inv_cdf(1 - FALSE / (3 * max(t.size, 1)))
    flagged = np.zeros(t.shape, bool)
    for deviate in (mean, chi_deviate(9 * np.asarray(square), 9.0)):
        flagged |= deviate > limit * (1.0 if strict else _roughness(deviate[free]))
    flagged |= _moved_edge(v, cov, box, free & ~flagged, t, u, strict=strict)
    reach = float(_reach(v[S : S + 1])[0])
    k = int(reach)
    y, x = np.mgrid[-k : k + 1, -k : k + 1]
    return binary_dilation(flagged, np.hypot(x, y) <= reach)


def _noise(e: Array, free: Mask, radius: Array, h: Array) -> Array:
    """Standard deviation (h, w) of grey values: that of all, or that within the dot or around it where it is more."""
    all_ = difference_noise(e, free)
    flat = abs(h) < 0.01 * abs(h).max()
    noise = np.full(e.shape, all_)
    for side in (radius < 1, radius >= 1):
        of = e[free & flat & side]
        if len(of) > 2 * UNKNOWNS:
            noise[side] = max(all_, float(np.median(abs(of))) / NORMAL)
    return noise


def _roughness(deviates: Array) -> float:
    """By how much more than 1 the standard deviation of normal deviates is, by their median."""
    return max(1.0, float(np.median(abs(deviates))) / NORMAL) if deviates.size else 1.0


def _moved_edge(v: Array, cov: Array, box: Box, free: Mask, t: Array, u: Array, *, strict: bool) -> Mask:
    """Pixels (h, w) at those parts of the edge that lie elsewhere than on the ellipse."""
    y, x = np.mgrid[box] + 0.5
    k = sector_of(v, x, y)
    deviates = edge_shifts(v, k[free], t[free], u[free], cov)
    limit = NORMAL_DEVIATE.inv_cdf(1 - FALSE / (2 * deviates.size)) * (
        1 if strict else max(1, float(np.sqrt(np.mean(t[free] ** 2))))
    )
    off = np.zeros(deviates.shape, bool)
    # what has moved bends the ellipse beside it: the worst part alone, and what is left out already and still is off
    off.flat[deviates.argmax()] = deviates.max() > limit
    off[0] |= edge_shifts(v, k[~free], t[~free], u[~free], cov, fitted=False)[0] > limit
    parts = np.zeros(SECTORS, bool)
    for m, of in zip(WIDTHS, off, strict=True):
        for j in range(m):
            parts |= np.roll(of, j)
    h = abs(u[..., A : D + 1] @ v[A : D + 1])
    return parts[k] & (h > 0.1 * h.max())
