"""Structure left in the residuals: what neighbouring image points have in common, the model does not explain."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from raybundle.adjustment.result import Adjustment, Notice
from raybundle.numerics.arrays import Array

NEAR, FAR = 0.01, 0.03
"""Distances between neighbours, in diagonals of the format: beyond what one matching window covers, within a cell."""
MOST_POINTS = 4000
"""Points of an image that are looked at."""
NOTICED = 0.05
"""Correlation from which on it is worth a notice."""
FEWEST_PAIRS = 500


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
    mean says that the image points share errors: a term is missing in the model, the interior orientation was not the
    same in all images (stabilised lens, refocusing, zoom), the film or the shutter deformed the image, or what is
    measured is not the same in all images.  The sum over all neighbours is the factor by which n points carry less
    information than n independent ones.  What it does not tell: errors that are common to a whole image, which its
    orientation absorbs.
    """
    from scipy.spatial import KDTree  # noqa: PLC0415

    o, block = result.given.observations, result.given
    s = result.image_observations
    used = np.array([not r for r in s.rejected])
    safe = np.sqrt(np.maximum(s.redundancy, 0.05))
    z = s.residuals_px / np.sqrt(o.cov_px2[:, :2]) / safe
    used &= np.isfinite(z).all(axis=1)
    variance = float(np.mean(z[used] ** 2)) if used.any() else math.nan
    n = len(block.images)
    total, pairs, images = 0.0, 0, np.full(n, np.nan)
    weight = 0.0
    for i in range(n):
        rows = np.flatnonzero(used & (o.image == i))
        thinned = 1.0
        if len(rows) > MOST_POINTS:
            thinned = len(rows) / MOST_POINTS
            rows = rows[np.linspace(0, len(rows) - 1, MOST_POINTS).astype(int)]
        if len(rows) < 2:
            continue
        camera = block.cameras[block.images.camera[i]]
        diagonal = math.hypot(camera.width_px, camera.height_px)
        near = KDTree(o.xy_px[rows]).query_pairs(FAR * diagonal, output_type="ndarray")
        distance = np.linalg.norm(o.xy_px[rows[near[:, 0]]] - o.xy_px[rows[near[:, 1]]], axis=1)
        near = near[distance > NEAR * diagonal]
        products = np.sum(z[rows[near[:, 0]]] * z[rows[near[:, 1]]], axis=1) / 2 / variance
        if len(near) >= FEWEST_PAIRS // 5:
            images[i] = float(products.mean())
        total += float(products.sum())
        pairs += len(near)
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


def structure_notice(result: Adjustment) -> Notice | None:
    """What a user should know of the structure in the residuals; None where there is none to speak of."""
    found = residual_structure(result)
    if found is None or found.correlation < max(NOTICED, 5 * found.std):
        return None
    ids = result.given.images.ids
    worst = [ids[i] for i in np.argsort(-np.nan_to_num(found.images))[:3]]
    return Notice(
        code="residual_structure",
        message=f"residuals of neighbouring image points agree (correlation {found.correlation:.2f}, most in "
        f"{', '.join(worst)}): something is not in the model, as an interior orientation that was not the same in all "
        f"images (stabilised lens, refocusing, zoom). Standard deviations are too small, by a factor of "
        f"{found.factor:.1f} at least; look at the residuals in the report, and fix lens and focus next time",
        ids=tuple(worst),
    )
