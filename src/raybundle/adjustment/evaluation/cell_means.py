"""Residuals averaged over the cells of the image format: what the camera model leaves, and a notice of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import FEWEST_IMAGES
from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera
from raybundle.errors import Message, Value, message
from raybundle.numerics.arrays import Array, Index, Mask

FAMILY = 0.05
"""Family-wise significance level of the tests of all cells of a camera."""
SPREAD = 0.1
"""Share of the cells that differ from zero beyond which it is the camera, not a place of it; by chance a single cell
does in one camera of twenty."""
FEWEST = 400
"""Image points of a camera below which its cells are too few to be distinguished from single points."""


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
    """(cells,) chi-square with 2 degrees of freedom of the mean, or what is as improbable; 0 where nothing tests it"""
    limit: float
    """Its family-wise critical value (Bonferroni)"""

    @property
    def significant(self) -> Mask:
        """(cells,) whether the mean differs from zero."""
        return np.nan_to_num(self.test) > self.limit

    @property
    def well_filled(self) -> Mask:
        """(cells,) whether a mean states something: three points at least, and a tenth of the typical number."""
        if not self.count.any():
            return np.zeros(len(self.count), bool)
        return self.count >= max(3.0, 0.1 * float(np.median(self.count[self.count > 0])))

    @property
    def tested(self) -> int:
        """Number of cells whose mean is tested."""
        return int((np.nan_to_num(self.test) > 0).sum())

    @property
    def systematic(self) -> bool:
        """Whether the means differ from zero in more than a tenth (SPREAD) of the cells."""
        return int(self.significant.sum()) > SPREAD * self.tested

    @property
    def rms_px(self) -> float:
        """Rms of the means of well filled cells, by their numbers of points, per coordinate; NaN without any."""
        full = self.well_filled
        if not full.any():
            return math.nan
        square = np.sum(self.mean_px[full] ** 2, axis=1)
        return math.sqrt(float(np.sum(self.count[full] * square) / self.count[full].sum()) / 2)

    @property
    def largest_px(self) -> float:
        """Length of the largest mean of a well filled cell; NaN without any."""
        full = self.well_filled
        return float(np.nanmax(np.linalg.norm(self.mean_px[full], axis=1))) if full.any() else math.nan


def normalised_residuals(result: Adjustment) -> Array:
    """Residuals over their standard deviation (m, 2), a-posteriori: w / sigma0; NaN where untested or rejected.

    Without statistics v / (s sigma0), whose spread is below 1 by the root of the redundancy numbers.
    """
    s = result.image_observations
    scale = result.sigma0 if math.isfinite(result.sigma0) and result.sigma0 > 0 else 1.0
    if result.precision is not None:
        return np.where(s.used[:, None], s.w / scale, np.nan)
    sigma = np.sqrt(result.given.observations.cov_px2[:, :2])
    return np.where(s.used[:, None], s.residuals_px / sigma / scale, np.nan)


def cell_means(result: Adjustment, camera: Camera, mask: Mask, tests: Array) -> CellMeans:
    """Means over cells of about a tenth of the format's width.

    mask   (m,) observations of the camera
    tests  (m, 2) normalised residuals

    Where the standard deviations contain smooth errors of single images (`noise.kind` other than white), what an
    image's points of a cell have in common is one observation, and the images show how far it scatters: Hotelling's
    T^2 over the images.  With white noise the test takes residuals as uncorrelated; a common unmodelled effect of a
    few images then looks like a systematic one of the camera.
    """
    columns = 12 if mask.sum() >= 2400 else 8 if mask.sum() >= 400 else 5
    rows = int(min(max(2, round(columns * camera.height_px / camera.width_px)), 24))
    xy = result.given.observations.xy_px[mask]
    i = np.clip((xy[:, 0] / camera.width_px * columns).astype(int), 0, columns - 1)
    j = np.clip((xy[:, 1] / camera.height_px * rows).astype(int), 0, rows - 1)
    cell = j * columns + i
    s = result.image_observations

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
    test = np.sum(t**2, axis=1)
    if result.noise.kind != "white":
        test = between_images(cell, result.given.observations.image[mask], tests[mask], columns * rows)
    return CellMeans(
        columns=columns,
        rows=rows,
        count=count,
        mean_px=mean,
        redundancy=redundancy,
        test=test,
        limit=-2 * math.log(FAMILY / max(filled, 1)),
    )


def between_images(cell: Index, image: Index, tests: Array, cells: int) -> Array:
    """Of each cell, the chi-square with 2 degrees of freedom that is as improbable as T^2 of the means of its images.

    T^2 = n m' S^-1 m of n images, m and S mean and covariance of the roots-of-n-weighted sums of normalised residuals
    (k, 2); its tail is (1 + T^2 / (n - 1)) ^ (-(n - 2) / 2) (Hotelling 1931).  0 where fewer than `FEWEST_IMAGES` show
    the cell.
    """
    good = np.isfinite(tests).all(axis=1)
    width = int(image.max(initial=0)) + 1
    key = cell[good].astype(np.int64) * width + image[good]
    seen, group, count = np.unique(key, return_inverse=True, return_counts=True)
    z = np.stack([np.bincount(group, tests[good, k], len(seen)) for k in (0, 1)], axis=1) / np.sqrt(count)[:, None]
    of = seen // width
    n = np.bincount(of, minlength=cells).astype(float)

    def total(values: Array) -> Array:
        return np.bincount(of, values, minlength=cells)

    with np.errstate(invalid="ignore", divide="ignore"):
        m = np.stack([total(z[:, k]) / n for k in (0, 1)], axis=1)
        e = z - m[of]
        xx, yy, xy = (total(e[:, i] * e[:, j]) / (n - 1) for i, j in ((0, 0), (1, 1), (0, 1)))
        square = n * (yy * m[:, 0] ** 2 - 2 * xy * m[:, 0] * m[:, 1] + xx * m[:, 1] ** 2) / (xx * yy - xy**2)
        test = (n - 2) * np.log1p(square / (n - 1))
    return np.where((n >= FEWEST_IMAGES) & np.isfinite(test), test, 0.0)


def systematic_notices(result: Adjustment) -> list[Notice]:
    """One notice of the cameras whose mean residuals differ from zero in more than a tenth of their cells."""
    o, tests = result.given.observations, normalised_residuals(result)
    each: list[Message] = []
    ids: list[str] = []
    for k, camera in enumerate(result.given.cameras):
        mask = result.image_observations.used & (result.given.images.camera[o.image] == k)
        if camera.is_scene or mask.sum() < FEWEST:
            continue
        means = cell_means(result, camera, mask, tests)
        if not means.systematic:
            continue
        ids.append(camera.id)
        overall = math.sqrt(float(np.mean(result.image_observations.residuals_px[mask] ** 2)))
        each.append(
            message(
                "systematic_residuals.camera", camera=camera.id, cells=int(means.significant.sum()),
                tested=means.tested, rms_px=means.rms_px, share=means.rms_px / overall, largest_px=means.largest_px,
            )
        )  # fmt: skip
    if not each:
        return []
    values: dict[str, Value] = {"n": len(ids), "independent": result.noise.kind == "white"}
    return [Notice(code="systematic_residuals", values=values, ids=tuple(ids), details=tuple(each))]
