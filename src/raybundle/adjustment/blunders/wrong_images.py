"""Images that do not belong to their block as they are given: of another camera, mirrored, exchanged.

One wrong image spreads over the residuals of all, and single observations that are tested one by one do not show it.
Here the observations of an image are tested together, against those of the other images of its camera.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import POOR_FIT
from raybundle.adjustment.result import Adjustment
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.statistics import ALPHA, fisher_tail

SMOOTH = 3
"""Degrees of freedom that an image's residuals have at the least.

Errors of real photographs are smooth over the format and differ from image to image: the residuals of an image are then
not as many chances as points, but a few coefficients.  Its orientation takes up shifts, turn and scale; what is left of
the lowest smooth fields (two tilts, a radial one) are three.  The F test takes an image for no more than that.
"""
LEAST_IMAGES = 3
"""Of a camera, from which on one can be distinguished from the others."""
LEAST_REDUNDANCY = 10
"""Of an image: some two times what its exterior orientation takes; below, its residuals show too little of it."""
SPREAD = 0.25
"""Share of an image's points that bear its square sum: (sum q)^2 / (k sum q^2) of k points, q = v'Pv.

It is 1 where all bear alike, 0.5 where q is chi-square with two degrees of freedom, and the share itself where a few
points bear it all, which are then blunders.  An image that is wrong as a whole has residuals that grow from nothing
(middle, axis) to the edge of the format besides: q even over 0 .. max has 3/4, with the former 3/8.
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class WrongImage:
    """An image that contradicts the others of its camera."""

    image: int
    ratio: float
    """its sqrt(v'Pv / sum r) by that of the others"""
    probability: float
    """of a larger ratio by chance"""
    limit: float
    """of that probability: ALPHA by the number of images of the camera"""


def wrong_images(result: Adjustment) -> tuple[WrongImage, ...]:
    """Images whose residuals are far larger than those of the other images of their camera.

    result  with redundancy numbers; without: ()

    With T_i = sum v'Pv and r_i = sum of redundancy numbers over the observations of image i (Baarda 1968: the test of a
    group of observations), F = (T_i / r_i) / (T / r of the others) is held against F(SMOOTH, SMOOTH per other image)
    at ALPHA by the number of images of the camera.  Besides, the ratio of the standard deviations is more than
    POOR_FIT, as sigma0 has to be for a fault, and the share of its points that bear it more than SPREAD.  Of several
    the largest number is taken, up to a third of the images, of which each stands against those that are left (Rosner
    1983), so that two wrong ones hide each other less; among few images they still do.

    Limits: which of two images is wrong; wrong images whose errors the unknowns take up, or so many that
    the others fit no better.
    """
    r = np.nansum(result.image_observations.redundancy, axis=1)
    rows = np.flatnonzero(
        result.image_observations.used & np.isfinite(result.image_observations.redundancy).all(axis=1)
    )
    if not len(rows):
        return ()
    squares = _squares(result, rows)
    image = result.given.observations.image[rows]
    n = len(result.given.images)
    T, left, number = np.bincount(image, squares, n), np.bincount(image, r[rows], n), np.bincount(image, minlength=n)
    spread = T**2 / np.maximum(number * np.bincount(image, squares**2, n), 1e-300)
    found: list[WrongImage] = []
    for camera in range(len(result.given.cameras)):
        mine = np.flatnonzero((result.given.images.camera == camera) & (left > 0))
        found += outlying(mine, T, left, (left >= LEAST_REDUNDANCY) & (spread > SPREAD))
    return tuple(found)


def _squares(result: Adjustment, rows: Index) -> Array:
    """(k,) v'Pv of image observations, a-priori covariance."""
    v = result.image_observations.residuals_px[rows]
    sxx, syy, sxy = result.given.observations.cov_px2[rows].T
    return (syy * v[:, 0] ** 2 - 2 * sxy * v[:, 0] * v[:, 1] + sxx * v[:, 1] ** 2) / (sxx * syy - sxy**2)


def outlying(images: Index, T: Array, left: Array, may: Mask) -> list[WrongImage]:
    """Those of one camera's images that stand out by F = (T_i / r_i) / (T / r of the others), see `wrong_images`.

    T, left, may  (n,) of all images: square sums, their degrees of freedom, and which images may be named at all
    """
    if len(images) < LEAST_IMAGES:
        return []
    testable = images[may[images] & (T[images] > left[images])]
    order = testable[np.argsort(-T[testable] / left[testable], kind="stable")]
    for count in range(min(len(order), max(1, (len(images) - 1) // 3)), 0, -1):
        others = np.setdiff1d(images, order[:count])
        variance = float(T[others].sum() / left[others].sum())
        found: list[WrongImage] = []
        for i in order[:count].tolist():
            F = float(T[i] / left[i]) / max(variance, 1e-300)
            p = fisher_tail(F, SMOOTH, SMOOTH * len(others))
            limit = ALPHA / len(images)
            if F > POOR_FIT**2 and p < limit:
                found.append(WrongImage(image=i, ratio=float(np.sqrt(F)), probability=p, limit=limit))
        if len(found) == count:
            return found
    return []


def wrong_image_notices(result: Adjustment) -> list[Notice]:
    """A fault for each, with what may be the cause."""
    images = result.given.images
    camera = [result.given.cameras[k].id for k in images.camera.tolist()]
    return [
        Notice(
            code="image_contradicts",
            values={
                "image": images.ids[w.image],
                "camera": camera[w.image],
                "ratio": w.ratio,
                "limit": POOR_FIT,
                "p": w.probability,
                "limit_p": w.limit,
            },
            ids=(images.ids[w.image],),
        )
        for w in wrong_images(result)
    ]
