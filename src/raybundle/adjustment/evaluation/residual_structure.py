"""Structure left in the residuals: what neighbouring image points have in common, the model does not explain."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import FEWEST_IMAGES
from raybundle.adjustment.records.severity import NEARLY
from raybundle.adjustment.result import Adjustment, Noise
from raybundle.errors import Value, message
from raybundle.numerics.arrays import Array
from raybundle.numerics.rows import rows_of_each
from raybundle.numerics.statistics import fisher_tail

NEAR, FAR = 0.01, 0.03
"""Distances between neighbours, in diagonals of the format: beyond what one matching window covers, within a cell."""
MOST_POINTS = 4000
"""Points of an image that are looked at."""
NOTICED = 0.05
"""Correlation from which on it is worth a notice."""
FEWEST_PAIRS = 500
USUAL = (2.4, 6.0)
"""Factor of standard deviations by errors that are smooth within an image: the roots of 6 and 37, of real sets
(docs/explanation/noise-of-photographs.md).  Neighbours alone show less of it, and a few photographs absorb more."""
CELL = 0.04
"""Side of a cell in which image points are at the same place of the format, in diagonals."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ResidualStructure:
    """Correlation of the residuals of neighbouring image points."""

    correlation: float
    """Mean over pairs of neighbours; 0 where the model explains everything"""
    std: float
    """Of the correlation, where there is none"""
    pairs: int
    images: Array
    """(n,) the same in each image; NaN where there are too few pairs"""
    factor: float
    """By which standard deviations are too small at least, if the structure reaches no farther than FAR"""


def residual_structure(result: Adjustment) -> ResidualStructure | None:
    """How much the residuals of neighbouring image points agree; None where there are too few.

    Normalised residuals v / (sigma sqrt(r)) of points NEAR to FAR apart in the same image are multiplied.  A positive
    mean states that the image points share errors: a term is missing in the model, the interior orientation was not the
    same in all images (stabilised lens, refocusing, zoom), the film or the shutter deformed the image, or what is
    measured is not the same in all images.  The sum over all neighbours is the factor by which n points carry less
    information than n independent ones.  Limits: errors that are common to a whole image, which its
    orientation absorbs.
    """
    o, block = result.given.observations, result.given
    s = result.image_observations
    used = s.used
    safe = np.sqrt(np.maximum(s.redundancy, 0.05))
    z = s.residuals_px / np.sqrt(o.cov_px2[:, :2]) / safe
    used = used & np.isfinite(z).all(axis=1)
    variance = float(np.mean(z[used] ** 2)) if used.any() else math.nan
    n = len(block.images)
    total, pairs, images = 0.0, 0, np.full(n, np.nan)
    weight = 0.0
    for i, mine in enumerate(rows_of_each(np.where(used, o.image, -1), n)):
        thinned, rows = 1.0, mine
        if len(rows) > MOST_POINTS:
            thinned = len(rows) / MOST_POINTS
            rows = rows[np.linspace(0, len(rows) - 1, MOST_POINTS).astype(int)]
        if len(rows) < 2:
            continue
        camera = block.cameras[block.images.camera[i]]
        diagonal = math.hypot(camera.width_px, camera.height_px)
        one, other = _neighbours(o.xy_px[rows], NEAR * diagonal, FAR * diagonal)
        products = np.sum(z[rows[one]] * z[rows[other]], axis=1) / 2 / variance
        if len(one) >= FEWEST_PAIRS // 5:
            images[i] = float(products.mean())
        total += float(products.sum())
        pairs += len(one)
        weight += 2 * float(products.sum()) * thinned
    if pairs < FEWEST_PAIRS:
        return None
    return ResidualStructure(
        correlation=total / pairs,
        std=1 / math.sqrt(2 * pairs),
        pairs=pairs,
        images=images,
        factor=math.sqrt(max(1.0, 1 + weight / int(used.sum()))),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class RepeatedResiduals:
    """Correlation of the residuals of different images at the same place of the format."""

    correlation: float
    """0 where the interior orientation explains everything"""
    std: float
    """Of the correlation, where there is none"""
    pairs: int
    rms_px: float
    """Of what the residuals have in common, per coordinate"""

    @property
    def noticed(self) -> bool:
        """Whether it is there, and large enough to be worth a word."""
        return self.correlation > max(NOTICED, 5 * self.std)


def repeated_residuals(result: Adjustment, camera: int) -> RepeatedResiduals | None:
    """How much the residuals of a camera agree from image to image; None where there are too few.

    camera  position in `Block.cameras`
    Image points of different images and of different object points within a cell (CELL diagonals of the format wide)
    are multiplied, all pairs of them.  A positive mean states that the distortion model lacks something that the camera
    does to every image.  Limits: distortion that changes within a cell, and what exterior orientations
    and object coordinates absorb.
    """
    o, block, s = result.given.observations, result.given, result.image_observations
    rows = np.flatnonzero((block.images.camera[o.image] == camera) & s.used)
    safe = np.sqrt(np.maximum(s.redundancy[rows], 0.05))
    v = s.residuals_px[rows] / safe
    sigma = np.sqrt(o.cov_px2[rows, :2])
    good = np.isfinite(v / sigma).all(axis=1)
    rows, v, sigma = rows[good], v[good], sigma[good]
    if len(rows) < 2:
        return None
    known = block.cameras[camera]
    cell = np.floor(o.xy_px[rows] / (CELL * math.hypot(known.width_px, known.height_px))).astype(np.int64)
    cell = (cell[:, 0] - cell[:, 0].min()) * (1 + cell[:, 1].max() - cell[:, 1].min()) + cell[:, 1] - cell[:, 1].min()
    z = v / sigma
    z /= math.sqrt(float(np.mean(z**2)))
    both = [np.zeros(len(rows), np.int64), o.image[rows].astype(np.int64), o.point[rows].astype(np.int64)]
    whole, image, point = (_pair_sums(cell, other, z) for other in both)
    pairs = whole[1] - image[1] - point[1]  # a point is measured once in an image
    if pairs < FEWEST_PAIRS:
        return None
    correlation = (whole[0] - image[0] - point[0]) / pairs / 2
    rms = math.sqrt(max(correlation, 0.0) * float(np.mean(v**2)))
    return RepeatedResiduals(correlation=correlation, std=1 / math.sqrt(2 * pairs), pairs=pairs, rms_px=rms)


def _pair_sums(cell: Array, other: Array, z: Array) -> tuple[float, int]:
    """Sum of z_i . z_j over the pairs of rows that agree in both labels, and their number."""
    _, group = np.unique(cell * (1 + other.max()) + other, return_inverse=True)
    count = np.bincount(group)
    square = sum(float((np.bincount(group, z[:, k]) ** 2).sum()) for k in (0, 1)) - float((z**2).sum())
    return square / 2, int((count * (count - 1) // 2).sum())


def _neighbours(xy: Array, near: float, far: float) -> tuple[Array, Array]:
    """Pairs of rows of points (n, 2) that are more than `near` and at most `far` apart, each pair once."""
    order = np.argsort(xy[:, 0], kind="stable")
    x = xy[order, 0]
    following = np.searchsorted(x, x + far, side="right") - np.arange(len(x)) - 1
    one = np.repeat(np.arange(len(x)), following)
    other = one + 1 + np.arange(len(one)) - np.repeat(np.cumsum(following) - following, following)
    one, other = order[one], order[other]
    distance = np.linalg.norm(xy[one] - xy[other], axis=1)
    good = (distance > near) & (distance <= far)
    return one[good], other[good]


def structure_notice(result: Adjustment) -> Notice | None:
    """What a user should know of the structure in the residuals; None where there is none to speak of.

    Nor where standard deviations carry it already (`raybundle.adjustment.statistics.noise`).
    """
    found = residual_structure(result) if result.noise.kind == "white" else None
    if found is None or found.correlation < max(NOTICED, 5 * found.std):
        return None
    ids = result.given.images.ids
    worst = [ids[i] for i in np.argsort(-np.nan_to_num(found.images))[:3]]
    few = len(np.unique(result.given.observations.image[result.image_observations.used])) < FEWEST_IMAGES
    values: dict[str, Value] = {
        "correlation": found.correlation, "factor": found.factor, "least_images": FEWEST_IMAGES,
        "usual_low": USUAL[0], "usual_high": USUAL[1], "few": few,
    }  # fmt: skip
    return Notice(code="residual_structure", values=values, ids=tuple(worst))


BY_CHANCE = 0.01
"""Probability below which what the residuals show of shared errors is no accident of white noise."""


def shared_errors_notice(result: Adjustment, noise: Noise) -> Notice | None:
    """What errors that image points share make of standard deviations which rest on white noise; None: no more.

    noise  what the residuals of the same adjustment show (`raybundle.adjustment.evaluation.noise_covariance`)
    The mean square of the residuals in the directions of smooth fields is held against that of all (F test).
    """
    wider = {"interior": noise.ratio_interior, "points": noise.ratio_points}
    found = {what: ratio for what, ratio in wider.items() if math.isfinite(ratio)}
    if noise.kind == "white" or max(found.values(), default=1.0) <= NEARLY:
        return None
    if fisher_tail(noise.chi_square, noise.directions, max(result.redundancy, 1)) > BY_CHANCE:
        return None
    parts = [message("residual_structure.fields", tau_px=noise.tau_px)] if noise.tau_px > 0 else []
    parts += [message("residual_structure.focus", focus_px=noise.focus_px)] if noise.focus_px > 0 else []
    parts += [message("residual_structure.neighbours", phi=noise.phi)] if noise.phi > 1 else []
    parts += [message("residual_structure.times", object=what, factor=ratio) for what, ratio in found.items()]
    values: dict[str, Value] = {
        "tau_px": noise.tau_px, "focus_px": noise.focus_px, "phi": noise.phi, "ratio_interior": noise.ratio_interior,
        "ratio_points": noise.ratio_points, "largest": max(found.values()),
    }  # fmt: skip
    return Notice(code="residual_structure.shared", values=values, details=tuple(parts))
