"""Residuals in figures: per image, averaged over the format, against the normal curve, against the radius."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from raybundle.block import Camera
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.report.view import View, rms

FAMILY = 0.05
"""Family-wise significance level of the tests in the figures."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CellMeans:
    """Residuals averaged over the cells of an image format; cells run along x (right), then y (down)."""

    columns: int
    rows: int
    count: Array
    """(cells,) image points"""
    mean_px: Array
    """(cells, 2) mean residual, pixel frame; NaN where a cell is empty"""
    redundancy: Array
    """(cells,) mean redundancy number; NaN without statistics"""
    test: Array
    """(cells,) chi-square with 2 degrees of freedom of the mean"""
    limit: float
    """Its family-wise critical value (Bonferroni)"""

    @property
    def significant(self) -> Mask:
        """(cells,) whether the mean differs from zero."""
        return np.nan_to_num(self.test) > self.limit


def normalised(view: View) -> Array:
    """Residuals over their standard deviation (m, 2), a-posteriori: w / sigma0; NaN where untested or rejected.

    Without statistics v / (s sigma0), whose spread is below 1 by the root of the redundancy numbers.
    """
    s = view.adjustment.image_observations
    if view.adjustment.precision is not None:
        return np.where(view.used[:, None], s.w / view.scale, np.nan)
    sigma = np.sqrt(view.given.observations.cov_px2[:, :2])
    return np.where(view.used[:, None], s.residuals_px / sigma / view.scale, np.nan)


def cell_means(view: View, camera: Camera, mask: Mask, tests: Array) -> CellMeans:
    """Means over cells of about a tenth of the format's width.

    mask   (m,) observations of the camera
    tests  (m, 2) normalised residuals

    The test takes residuals as uncorrelated; a common unmodelled effect of a few images looks like a
    systematic one of the camera.
    """
    columns = 12 if mask.sum() >= 2400 else 8 if mask.sum() >= 400 else 5
    rows = int(min(max(2, round(columns * camera.height_px / camera.width_px)), 24))
    xy = view.given.observations.xy_px[mask]
    i = np.clip((xy[:, 0] / camera.width_px * columns).astype(int), 0, columns - 1)
    j = np.clip((xy[:, 1] / camera.height_px * rows).astype(int), 0, rows - 1)
    cell = j * columns + i
    s = view.adjustment.image_observations

    def total(values: Array) -> Array:
        return np.bincount(cell, np.nan_to_num(values), minlength=columns * rows)

    count = np.bincount(cell, minlength=columns * rows).astype(float)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = np.stack([total(s.residuals_px[mask, k]) for k in (0, 1)], axis=1) / count[:, None]
        tested = np.stack([total(np.isfinite(tests[mask, k]).astype(float)) for k in (0, 1)], axis=1)
        t = np.stack([total(tests[mask, k]) for k in (0, 1)], axis=1) / np.sqrt(tested)
        r = s.redundancy[mask]
        redundancy = total(r.sum(axis=1)) / (2 * total(np.isfinite(r).all(axis=1).astype(float)))
    filled = int((count > 0).sum())
    return CellMeans(
        columns=columns,
        rows=rows,
        count=count,
        mean_px=mean,
        redundancy=redundancy,
        test=np.sum(t**2, axis=1),
        limit=-2 * math.log(FAMILY / max(filled, 1)),
    )


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
