"""Residuals in figures: per image, against the normal curve, against the radius."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from raybundle.adjustment.cell_means import normalised_residuals
from raybundle.block import Camera
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.report.view import View, rms


def normalised(view: View) -> Array:
    """Residuals over their standard deviation (m, 2), a-posteriori; NaN where untested or rejected."""
    return normalised_residuals(view.adjustment)


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
    order = np.argsort(o.image, kind="stable")
    starts = np.searchsorted(o.image[order], np.arange(len(view.given.images) + 1))
    rows: list[ImageRow] = []
    for i in np.flatnonzero(np.diff(starts)):
        mine = order[starts[i] : starts[i + 1]]
        good = mine[view.used[mine]]
        t = np.abs(tests[good])
        r = s.redundancy[good]
        rows.append(
            ImageRow(
                image=int(i),
                count=len(good),
                rejected=len(mine) - len(good),
                rms_px=np.array([rms(s.residuals_px[good, k]) for k in (0, 1)]),
                ratio=rms(t),
                largest=float(np.nanmax(t)) if np.isfinite(t).any() else math.nan,
                redundancy=float(np.nanmean(r)) if np.isfinite(r).any() else math.nan,
            )
        )
    return rows


def rows_of_images(view: View) -> list[Index]:
    """Rows of the observations of each image."""
    image = view.given.observations.image
    order = np.argsort(image, kind="stable").astype(np.int32)
    starts = np.searchsorted(image[order], np.arange(len(view.given.images) + 1))
    return [order[a:b] for a, b in pairwise(starts.tolist())]
