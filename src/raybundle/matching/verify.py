"""Verification of image pairs: which candidate matches one epipolar geometry explains, and of what kind it is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

Geometry = Literal["general", "planar", "rotation", "watermark", "none"]
FEWEST = 15
"""Inliers below which a pair is not believed."""
STRONG, SHARE = 40, 0.3
"""Inliers, and their share of the candidates, from which a pair is trusted by itself."""
LINKS = 1
"""Strong pairs that make an image independent of its weak ones."""


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifiedPair:
    """A pair of images and what they share."""

    first: int
    second: int
    matches: Index
    """(k, 2) feature positions, verified"""
    candidates: int
    """matches before verification"""
    geometry: Geometry
    planar_share: float
    """inliers of the best homography / inliers of the epipolar geometry"""
    displacement_px: float
    """median length between the places of a point in the two images"""


def verify(
    first: int, second: int, xy1: Array, xy2: Array, matches: Index, size1: tuple[int, int], size2: tuple[int, int]
) -> VerifiedPair:
    """The part of candidate matches (k, 2) that fits a fundamental matrix or a homography.

    xy1, xy2      (n, 2) and (m, 2) features [px]
    size1, size2  width and height of the images [px]
    A distorted lens bends epipolar lines, so the limit is 1/600 of the diagonal, 4 px at least; the block decides
    later, with the adjusted interior orientation.
    """
    import poselib  # noqa: PLC0415

    k = len(matches)

    def result(chosen: Mask, geometry: Geometry, share: float) -> VerifiedPair:
        kept = matches[chosen] if chosen.sum() >= FEWEST and geometry not in ("none", "watermark") else matches[:0]
        apart = np.linalg.norm(p - q, axis=1)[chosen] if chosen.any() else np.zeros(1)
        return VerifiedPair(
            first=first, second=second, matches=kept, candidates=k, geometry=geometry if len(kept) else
            ("watermark" if geometry == "watermark" else "none"), planar_share=share,
            displacement_px=float(np.median(apart)),
        )  # fmt: skip

    p, q = xy1[matches[:, 0]], xy2[matches[:, 1]]
    none = np.zeros(k, bool)
    if k < FEWEST:
        return result(none, "none", 0.0)
    half1, half2 = np.array(size1) / 2, np.array(size2) / 2
    limit = max(4.0, float(np.hypot(*size1)) / 600)
    options: dict[str, Any] = {
        "max_epipolar_error": limit,
        "max_reproj_error": limit,
        "max_iterations": 5000,
        # the number that the share of inliers asks for decides; 1000 by default, where 20 often do
        "min_iterations": 100,
        "seed": 1,
    }
    _, info = poselib.estimate_fundamental(p - half1, q - half2, options, {})
    general = np.asarray(info["inliers"], bool)
    _, info = poselib.estimate_homography(p - half1, q - half2, options, {})
    planar = np.asarray(info["inliers"], bool)
    n = int(general.sum())
    share = float(planar.sum() / max(n, 1))
    if n < FEWEST and planar.sum() < FEWEST:
        return result(none, "none", share)
    if _is_watermark(p, q, size1, size2, general):
        return result(general, "watermark", share)
    if share > 0.85:
        # a plane or a turn of the camera: the homography says more than an epipolar geometry it does not determine
        apart = np.linalg.norm((p - half1) - (q - half2), axis=1)[planar]
        return result(planar | general, "planar" if np.median(apart) > 1 else "rotation", share)
    return result(general, "general", share)


def trusted(pairs: Sequence[VerifiedPair], images: int) -> list[VerifiedPair]:
    """The pairs from which tracks are made: strong ones, and of images without any the best weak ones.

    Repeated windows, columns or tiles make pairs that an epipolar geometry explains with few of many candidates;
    where an image has a better neighbour, such pairs only do harm.
    """
    good = [p for p in pairs if len(p.matches)]
    strong = [p for p in good if len(p.matches) >= STRONG and len(p.matches) >= SHARE * p.candidates]
    links = np.zeros(images, int)
    for p in strong:
        links[[p.first, p.second]] += 1
    chosen = {(p.first, p.second): p for p in strong}
    weak = sorted(
        (p for p in good if (p.first, p.second) not in chosen), key=lambda p: (-len(p.matches), p.first, p.second)
    )
    for p in weak:
        if min(links[p.first], links[p.second]) < LINKS:
            chosen[p.first, p.second] = p
            links[[p.first, p.second]] += 1
    return [chosen[k] for k in sorted(chosen)]


def _is_watermark(p: Array, q: Array, size1: tuple[int, int], size2: tuple[int, int], inliers: Mask) -> bool:
    """Whether the matches stay in place near the border: a stamp of date or name, not the object."""
    if size1 != size2 or not inliers.any():
        return False
    still = np.linalg.norm(p - q, axis=1) < 1.0
    width, height = size1
    edge = np.minimum(np.minimum(p[:, 0], width - p[:, 0]) / width, np.minimum(p[:, 1], height - p[:, 1]) / height)
    return float((still & (edge < 0.15))[inliers].mean()) > 0.7
