"""Verification of image pairs: which candidate matches one epipolar geometry explains, and of what kind it is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

Geometry = Literal["general", "planar", "rotation", "watermark", "none"]
FEWEST = 15
"""Inliers below which a pair is not believed."""
STRONG, SHARE = 40, 0.3
"""Inliers, and their share of the candidates, from which a pair is trusted by itself."""
SURE = 1e6
"""Stands for an infinite logarithm."""
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
    """matches before verification; 0 where a first look found no more than chance gives"""
    geometry: Geometry
    planar_share: float
    """inliers of the best homography / inliers of the epipolar geometry"""
    displacement_px: float
    """median length between the places of a point in the two images"""
    log_chance: float = -SURE
    """natural logarithm of the number of such pairs, as good as this one, that chance makes of one pair of images"""
    method: str = ""
    """that proved it for a wide baseline, far beyond chance (`ties.wide_baselines`)"""


def limit_px(size: tuple[int, int]) -> float:
    """Distance [px] from a geometry up to which a match in an image of this width and height fits it."""
    return max(4.0, float(np.hypot(*size)) / 600)


def verify(
    first: int, second: int, xy1: Array, xy2: Array, matches: Index, size1: tuple[int, int], size2: tuple[int, int]
) -> VerifiedPair:
    """The part of candidate matches (k, 2) that fits a fundamental matrix or a homography.

    xy1, xy2      (n, 2) and (m, 2) features [px]
    size1, size2  width and height of the images [px]
    A distorted lens bends epipolar lines, so the limit is 1/600 of the diagonal, 4 px at least; the block decides
    later, with the adjusted interior orientation.
    """
    import poselib

    k = len(matches)

    def result(chosen: Mask, geometry: Geometry, share: float, log_chance: float = -SURE) -> VerifiedPair:
        kept = matches[chosen] if chosen.sum() >= FEWEST and geometry not in ("none", "watermark") else matches[:0]
        apart = np.linalg.norm(p - q, axis=1)[chosen] if chosen.any() else np.zeros(1)
        return VerifiedPair(
            first=first, second=second, matches=kept, candidates=k, geometry=geometry if len(kept) else
            ("watermark" if geometry == "watermark" else "none"), planar_share=share,
            displacement_px=float(np.median(apart)), log_chance=log_chance,
        )  # fmt: skip

    p, q = xy1[matches[:, 0]], xy2[matches[:, 1]]
    none = np.zeros(k, bool)
    if k < FEWEST:
        return result(none, "none", 0.0)
    half1, half2 = np.array(size1) / 2, np.array(size2) / 2
    limit = limit_px(size1)
    options: dict[str, Any] = {
        "max_epipolar_error": limit,
        "max_reproj_error": limit,
        "max_iterations": 5000,
        # beyond that the share of inliers decides: 300 samples of seven find a pure one where 61 % are right
        "min_iterations": 300,
        "seed": 1,
    }
    F, info = poselib.estimate_fundamental(p - half1, q - half2, options, {})
    general = np.asarray(info["inliers"], bool)
    H, info = poselib.estimate_homography(p - half1, q - half2, options, {})
    planar = np.asarray(info["inliers"], bool)
    n = int(general.sum())
    share = float(planar.sum() / max(n, 1))
    if n < FEWEST and planar.sum() < FEWEST:
        return result(none, "none", share)
    if _is_watermark(p, q, size1, size2, general):
        return result(general, "watermark", share)
    if share > 0.85:
        # a plane or a turn of the camera: the homography states more than an epipolar geometry it does not determine
        apart = np.linalg.norm((p - half1) - (q - half2), axis=1)[planar]
        off = _homography_distance(np.asarray(H), p - half1, q - half2)
        wrong = _homography_distance(np.asarray(H), *_at_random(xy1 - half1, xy2 - half2))
        # so few are brought together that they are counted in a circle ten times as wide, a hundred times as large
        chance = _least(k, off, [(limit, _within(wrong, 10 * limit) / 100)], 4, 1)
        return result(planar | general, "planar" if np.median(apart) > 1 else "rotation", share, chance)
    off = _sampson(np.asarray(F), p - half1, q - half2)
    wrong = _sampson(np.asarray(F), *_at_random(xy1 - half1, xy2 - half2))
    limits = [(limit / part, _within(wrong, limit) / part) for part in (1, 2, 4)]
    return result(general, "general", share, _least(k, off, limits, 7, 3))


def _least(candidates: int, off: Array, limits: Sequence[tuple[float, float]], sample: int, models: int) -> float:
    """The least of `log_false_alarms` at several limits and the shares of random matches within each."""
    found = [log_false_alarms(candidates, int((off < d).sum()), share, sample, models) for d, share in limits]
    return float(np.clip(min(found) + np.log(len(limits)), -SURE, SURE))


def log_false_alarms(candidates: int, inliers: int, share: float, sample: int, models: int) -> float:
    """Logarithm of the number of models that explain so many of so many random matches (Moisan and Stival 2004, eq. 7).

    share   of random matches that a model explains
    sample  matches from which a model is made, and `models` the most that one sample gives
    """
    from scipy.special import gammaln

    def choose(n: float, k: float) -> float:
        return float(gammaln(n + 1) - gammaln(k + 1) - gammaln(n - k + 1))

    if inliers <= sample:
        return np.inf
    return float(
        np.log(models * max(candidates - sample, 1)) + choose(candidates, inliers) + choose(inliers, sample)
        + (inliers - sample) * np.log(share)
    )  # fmt: skip


def beyond_chance(pairs: Sequence[VerifiedPair]) -> list[VerifiedPair]:
    """The pairs, without the matches of those of which chance makes one or more among so many."""
    tried = np.log(max(len(pairs), 1))
    return [replace(p, matches=p.matches[:0], geometry="none") if p.log_chance + tried > 0 else p for p in pairs]


RANDOM = 4000
"""Random pairs of features that show what share of wrong matches a geometry explains: where features crowd more."""


def _at_random(xy1: Array, xy2: Array) -> tuple[Array, Array]:
    rng = np.random.default_rng(1)
    return xy1[rng.integers(0, len(xy1), RANDOM)], xy2[rng.integers(0, len(xy2), RANDOM)]


def _within(distance: Array, limit: float) -> float:
    return float((distance < limit).sum() + 1) / (len(distance) + 1)


def _sampson(F: Array, p: Array, q: Array) -> Array:
    """(n,) distance of matches from an epipolar geometry, to first order (Sampson 1982)."""
    P, Q = (np.column_stack([a, np.ones(len(a))]) for a in (p, q))
    l2, l1 = P @ F.T, Q @ F
    with np.errstate(all="ignore"):
        return np.abs((Q * l2).sum(axis=1)) / np.sqrt((l2[:, :2] ** 2).sum(axis=1) + (l1[:, :2] ** 2).sum(axis=1))


def _homography_distance(H: Array, p: Array, q: Array) -> Array:
    """(n,) distance in the second image."""
    P = np.column_stack([p, np.ones(len(p))]) @ H.T
    with np.errstate(all="ignore"):
        return np.linalg.norm(P[:, :2] / P[:, 2:] - q, axis=1)


def trusted(pairs: Sequence[VerifiedPair], images: int) -> list[VerifiedPair]:
    """The pairs from which tracks are made: strong ones, and of images without any the best weak ones.

    Repeated windows, columns or tiles make pairs that an epipolar geometry explains with few of many candidates;
    where an image has a better neighbour, such pairs only do harm.
    """
    good = [p for p in pairs if len(p.matches)]
    strong = [p for p in good if p.method or len(p.matches) >= max(STRONG, SHARE * p.candidates)]
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
