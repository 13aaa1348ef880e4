"""Residuals in figures: per image, against the normal curve, against the radius."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from raybundle.adjustment.evaluation.cell_means import normalised_residuals
from raybundle.block import Camera
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_largest
from raybundle.report.figures.svg import spread_rows
from raybundle.report.view import View


def normalised(view: View) -> Array:
    """Residuals over their standard deviation (m, 2), a-posteriori; NaN where untested or rejected."""
    return normalised_residuals(view.adjustment)


@dataclass(frozen=True, slots=True, kw_only=True)
class Distribution:
    """Normalised residuals counted in columns, beside what a normal distribution lets expect."""

    edges: Array
    """(k + 1,) of the columns, within +-5; what lies beyond counts in the outermost ones"""
    counts: Array
    """(k,)"""
    at: Array
    expected: Array
    """counts in a column of this width at the values `at`"""


def distribution(tests: Array) -> Distribution:
    """Columns of the finite normalised residuals, and the normal curve of as many."""
    t = tests[np.isfinite(tests)]
    width = 0.25 if len(t) >= 1000 else 0.5
    edges = np.arange(-5.0, 5.0 + width / 2, width)
    x = np.linspace(-5, 5, 101)
    return Distribution(
        edges=edges, counts=np.histogram(np.clip(t, -5, 5 - 1e-9), edges)[0].astype(float), at=x,
        expected=len(t) * width * np.exp(-x * x / 2) / math.sqrt(2 * math.pi),
    )  # fmt: skip


def normalised_symbol(view: View) -> str:
    """What normalised residuals are, in symbols."""
    return "w / σ₀" if view.adjustment.precision is not None else "v / (s σ₀)"


def spread_vectors(tests: Array, most: int) -> Index:
    """Positions of the residuals that are drawn of many: the largest by |w| and others, evenly spread.

    tests  (m, 2) normalised residuals
    """
    if len(tests) <= most:
        return np.arange(len(tests))
    size = np.nan_to_num(np.abs(tests).max(axis=1))
    large = rows_of_largest(size, 20)
    return np.unique(np.concatenate([large, spread_rows(len(tests), most - 20)]))


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """Mean radial and tangential residual in rings about the principal point."""

    radius_mm: Array
    """(k,) middle of each ring"""
    mean_px: Array
    """(k, 2) radial (outwards), tangential (clockwise as seen in the image)"""
    std_px: Array
    """(k, 2) standard deviation of the mean, residuals taken as uncorrelated"""


def radial_profile(view: View, camera: Camera, mask: Mask, centre_mm: Array, rings: int = 12) -> Profile:
    """Residuals split into radial and tangential parts, averaged in rings of equal number of points."""
    rows = np.flatnonzero(mask)
    offset = camera.image_from_pixel(view.given.observations.xy_px[rows]) - centre_mm
    r = np.linalg.norm(offset, axis=1)
    unit = offset * [1, -1] / np.maximum(r, 1e-12)[:, None]
    v = view.adjustment.image_observations.residuals_px[rows]
    radial, tangential = np.sum(v * unit, axis=1), unit[:, 0] * v[:, 1] - unit[:, 1] * v[:, 0]
    parts = np.array_split(np.argsort(r, kind="stable"), min(rings, max(1, len(rows) // 20)))
    middle, mean, std = [], [], []
    for p in parts:
        middle.append(float(r[p].mean()))
        mean.append([radial[p].mean(), tangential[p].mean()])
        std.append([radial[p].std() / math.sqrt(len(p)), tangential[p].std() / math.sqrt(len(p))])
    return Profile(radius_mm=np.array(middle), mean_px=np.array(mean), std_px=np.array(std))


@dataclass(frozen=True, slots=True, kw_only=True)
class ImageRow:
    """Residuals of one image."""

    image: int
    count: int
    rejected: int
    rms_px: Array
    """(2,)"""
    ratio: float
    """rms of the normalised residuals"""
    largest: float
    """largest |w| / sigma0"""
    redundancy: float
    """mean redundancy number"""


def image_rows(view: View, tests: Array) -> list[ImageRow]:
    """One row for each image with observations, in the order of the block."""
    o, s = view.given.observations, view.adjustment.image_observations
    n, used = len(view.given.images), view.used
    image, t, r = o.image[used], np.abs(tests[used]), s.redundancy[used]

    def mean(values: Array) -> Array:
        each = values.reshape(len(image), -1)
        known = np.isfinite(each)
        count = np.bincount(image, known.sum(axis=1), n)
        with np.errstate(invalid="ignore"):
            return np.bincount(image, np.where(known, each, 0).sum(axis=1), n) / count

    largest = np.full(n, math.nan)
    order = np.argsort(image, kind="stable")
    count, given = np.bincount(image, minlength=n), np.bincount(o.image, minlength=n)
    first = np.flatnonzero(np.diff(image[order], prepend=-1))
    if len(order):
        largest[image[order[first]]] = np.fmax.reduceat(np.fmax(*t.T)[order], first)
    rms_px = np.sqrt(np.stack([mean(v**2) for v in s.residuals_px[used].T], axis=1))
    ratio, redundancy = np.sqrt(mean(t**2)), mean(r)
    return [
        ImageRow(
            image=i, count=int(count[i]), rejected=int(given[i] - count[i]), rms_px=rms_px[i], ratio=float(ratio[i]),
            largest=float(largest[i]), redundancy=float(redundancy[i]),
        )
        for i in np.flatnonzero(given).tolist()
    ]  # fmt: skip


def rows_of_images(view: View) -> list[Index]:
    """Rows of the observations of each image."""
    image = view.given.observations.image
    order = np.argsort(image, kind="stable").astype(np.int32)
    starts = np.searchsorted(image[order], np.arange(len(view.given.images) + 1))
    return [order[a:b] for a, b in pairwise(starts.tolist())]
