"""Tracks measured again: every image point by least-squares matching against one reference image of its track."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from raybundle.matching.least_squares import FIGURES, Outcome, WindowOptions, match_windows, with_noisy_gradients
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.rows import rows_of_each

CORRELATION = 0.75
"""Least correlation of two windows that are believed to show the same."""
NEIGHBOURS_FROM = 20
"""Common points of two images from which on neighbours give the affine map."""
WINDOWS = (
    WindowOptions(half=5, sigma=3.0, step=0.01, reach=2.5),
    WindowOptions(half=8, sigma=4.8, step=0.01, reach=2.5),
)
"""The first that promises enough: on relief larger windows give smaller residuals and a worse block, because they
are not plane and overlap; in weak texture smaller ones say too little."""
ENOUGH_PX = 0.15
"""Standard deviation from grey values alone from which on a larger window is tried [px of the level]."""
INTERPOLATION_PX2 = np.array([0.035**2, 0.035**2, 0.0])
"""What cubic convolution of a picture that is sampled coarsely adds to the covariance: 0.03 to 0.04 px of its level,
measured on textures of waves from 7 px on, reduced to an eighth."""
LEVELS = 4
"""Levels of the image pyramid, each half as large as the one before; the finest at which a point is found counts.

What is soft, moved, noisy or compressed shows nothing in a window of eleven pixels that two images share; in a picture
of half or a quarter the size the same window holds structure, and noise is averaged."""

Levels = Callable[[int, int], Array]
"""Image i at a level: (h >> level, w >> level) uint16, slightly smoothed (`smoothed`, `pyramid`)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class TrackPoints:
    """Image points of tracks with the similarity that their features give."""

    image: Index
    """(m,)"""
    point: Index
    """(m,)"""
    xy_px: Array
    """(m, 2)"""
    scale_px: Array
    """(m,)"""
    angle: Array
    """(m,) [rad]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Refined:
    """What least-squares matching made of the image points."""

    xy_px: Array
    """(m, 2); unchanged where nothing was measured"""
    cov_px2: Array
    """(m, 3) from grey values alone; 0 for the reference of a track"""
    measured: Mask
    """(m,) matched, or the reference of a track with a match"""
    reference: Mask
    """(m,)"""
    correlation: Array
    """(m,) 1 for references"""
    level: Index
    """(m,) of the pyramid, 0 the full size; of a reference: the finest at which it was matched"""
    window_px: Array
    """(m,) standard deviation of the weights of the window [px of the full size]; NaN where nothing was matched"""
    residual: Array
    """(m, FIGURES) see `WindowMatches.residual`; 0 where nothing was matched"""


def choose_references(points: TrackPoints) -> Index:
    """(m,) row of the reference of each row's track: the ray whose feature is largest, so that windows shrink."""
    order = np.lexsort((np.arange(len(points.point)), -points.scale_px, points.point))
    _, first = np.unique(points.point[order], return_index=True)
    best = order[first]
    return best[np.searchsorted(points.point[best], points.point)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidates:
    """Places where a point of a reference row is looked for."""

    reference: Index
    """(k,) row of the track points"""
    image: Index
    """(k,)"""
    point: Index
    """(k,)"""
    xy_px: Array
    """(k, 2) where to begin"""
    row: Index
    """(k,) row of the track points that begins there; -1 where none does"""
    coarsest: Index | None = None
    """(k,) level of the pyramid up to which each is looked for; None: to the last"""

    def rows(self, keep: Mask) -> Candidates:
        """A selection."""
        return Candidates(
            reference=self.reference[keep], image=self.image[keep], point=self.point[keep], xy_px=self.xy_px[keep],
            row=self.row[keep], coarsest=None if self.coarsest is None else self.coarsest[keep],
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class CandidateMatches:
    """What was found at the candidates."""

    good: Mask
    xy_px: Array
    cov_px2: Array
    correlation: Array
    level: Index
    """(k,) of the pyramid; `LEVELS` where nothing was found"""
    window_px: Array
    """(k,) standard deviation of the weights of the window [px of the full size]; NaN where nothing was found"""
    residual: Array
    """(k, FIGURES) see `WindowMatches.residual`, curvature in pixels of the full size; 0 where nothing was found"""


Matcher = Callable[[TrackPoints, Candidates], CandidateMatches]
"""Looks for candidates among track points"""


def refine_tracks(points: TrackPoints, match: Matcher) -> Refined:
    """Measure the points of tracks again; `match` finds candidates, as `match_candidates` does."""
    m = len(points.image)
    reference = choose_references(points)
    rows = np.flatnonzero(reference != np.arange(m))
    start = Candidates(
        reference=reference[rows],
        image=points.image[rows],
        point=points.point[rows],
        xy_px=points.xy_px[rows],
        row=rows,
    )
    found = match(points, start)
    xy, cov = points.xy_px.copy(), np.zeros((m, 3))
    measured, correlation, level = np.zeros(m, bool), np.zeros(m), np.full(m, LEVELS)
    window, residual = np.full(m, np.nan), np.zeros((m, FIGURES))
    window[rows], residual[rows] = found.window_px, found.residual
    xy[rows[found.good]], cov[rows[found.good]] = found.xy_px[found.good], found.cov_px2[found.good]
    measured[rows], correlation[rows], level[rows] = found.good, found.correlation, found.level
    references = np.unique(reference[measured])
    np.minimum.at(level, reference[measured], level[measured])
    measured[references], correlation[references] = True, 1.0
    is_reference = np.zeros(m, bool)
    is_reference[references] = True
    return Refined(
        xy_px=xy, cov_px2=cov, measured=measured, reference=is_reference, correlation=correlation, level=level,
        window_px=window, residual=residual,
    )  # fmt: skip


def match_candidates(
    points: TrackPoints,
    candidates: Candidates,
    image: Levels,
    *,
    threads: int = 1,
    progress: Progress = silent,
) -> CandidateMatches:
    """Least-squares matching of all candidates, one pair of images after the other.

    The affine map to begin with is that of the neighbours which both images see; where they are too few, the
    similarity of the two features.  What is not found at full size is looked for at the next level of the pyramid.
    """
    k = len(candidates.image)
    xy, cov, correlation, level = candidates.xy_px.copy(), np.zeros((k, 3)), np.zeros(k), np.full(k, LEVELS)
    width, residual = np.full(k, np.nan), np.zeros((k, FIGURES))
    source = points.image[candidates.reference]
    pair = source.astype(np.int64) * (int(points.image.max(initial=0)) + 1) + candidates.image
    order = np.argsort(pair, kind="stable")
    groups = np.split(order, np.flatnonzero(np.diff(pair[order])) + 1) if k else []
    rows_of_image = rows_of_each(points.image, int(points.image.max(initial=-1)) + 1)

    def run(group: Index) -> None:
        a, b = int(source[group[0]]), int(candidates.image[group[0]])
        reference = candidates.reference[group]
        affine = _affine(points, rows_of_image[a], rows_of_image[b], reference, candidates.row[group])
        left = np.flatnonzero(np.isfinite(affine).all(axis=(1, 2)))
        for step in range(LEVELS):
            if candidates.coarsest is not None:
                left = left[candidates.coarsest[group[left]] >= step]
            if not len(left):
                return
            pictures, size, mine = (image(a, step), image(b, step)), float(2**step), left
            for window in WINDOWS:
                at = group[mine]
                own, begin = points.xy_px[reference[mine]] / size, candidates.xy_px[at] / size
                found = match_windows(*pictures, own, begin, affine[mine], window)
                found = with_noisy_gradients(found, own, window)
                grey = (found.cov_px2 + INTERPOLATION_PX2) * size**2
                better = (found.outcome == Outcome.MATCHED) & (found.correlation > CORRELATION)
                better &= (level[at] == LEVELS) | (grey[:, :2].sum(axis=1) < cov[at, :2].sum(axis=1))
                at = at[better]
                correlation[at], level[at], width[at] = found.correlation[better], step, window.sigma * size
                residual[at] = found.residual[better] * np.repeat([1.0, size, size**2], [FIGURES - 6, 2, 4])
                xy[at], cov[at] = found.xy_px[better] * size, grey[better]
                # what a small window cannot match is an edge of the relief, or the wrong place
                mine = mine[(level[group[mine]] == step) & (cov[group[mine], :2].max(axis=1) > (ENOUGH_PX * size) ** 2)]
            missing = level[group[left]] == LEVELS
            left = left[missing | (cov[group[left], :2].max(axis=1) > (ENOUGH_PX * size) ** 2)]

    with ThreadPoolExecutor(max(threads, 1)) as pool:
        for n, _ in enumerate(pool.map(run, groups)):
            progress("least-squares matching", (n + 1) / max(len(groups), 1))
    return CandidateMatches(
        good=level < LEVELS,
        xy_px=xy,
        cov_px2=cov,
        correlation=correlation,
        level=level,
        window_px=width,
        residual=residual,
    )


def _affine(points: TrackPoints, rows_a: Index, rows_b: Index, reference: Index, row: Index) -> Array:
    """target_from_reference (n, 2, 2) where to begin; NaN where nothing is known."""
    _, in_a, in_b = np.intersect1d(points.point[rows_a], points.point[rows_b], return_indices=True)
    if len(in_a) >= NEIGHBOURS_FROM:
        p, q = points.xy_px[rows_a[in_a]], points.xy_px[rows_b[in_b]]
        return local_affine(p, q, points.xy_px[reference])
    result = np.full((len(reference), 2, 2), np.nan)
    own = row >= 0
    result[own] = similarity(points, reference[own], row[own])
    return result


def local_affine(p: Array, q: Array, at: Array, neighbours: int = 12) -> Array:
    """Affine maps (n, 2, 2) q_from_p around places `at` (n, 2), from the nearest of the common points p, q (m, 2)."""
    from scipy.spatial import KDTree

    distance, index = KDTree(p).query(at, k=min(neighbours, len(p)))
    weight = 1 / (distance + distance.mean(axis=1, keepdims=True) + 1e-9)
    weight /= weight.sum(axis=1, keepdims=True)
    both = np.concatenate([p, q], axis=1)[index]
    both -= weight[:, None] @ both
    products = (weight[:, :, None] * both).swapaxes(1, 2) @ both[:, :, :2]
    M = products[:, :2]
    M += 1e-6 * np.trace(M, axis1=1, axis2=2)[:, None, None] * np.eye(2) + 1e-12 * np.eye(2)
    return products[:, 2:] @ np.linalg.inv(M)


def similarity(points: TrackPoints, source: Index, target: Index) -> Array:
    """target_from_reference (n, 2, 2) by scale and direction of the features."""
    s = points.scale_px[target] / points.scale_px[source]
    a = points.angle[target] - points.angle[source]
    c, n = s * np.cos(a), s * np.sin(a)
    return np.stack([np.stack([c, -n], axis=1), np.stack([n, c], axis=1)], axis=1)


def smoothed(grey: Array, sigma_px: float = 0.6) -> Array:
    """A grey image (uint8 or uint16) as uint16 with a light smoothing, which keeps interpolation honest."""
    import cv2

    scale = 256.0 if grey.dtype == np.uint8 else 1.0
    kernel = cv2.getGaussianKernel(round(8 * sigma_px + 1) | 1, sigma_px, cv2.CV_32F)
    return cv2.sepFilter2D(grey, cv2.CV_16U, kernel * scale, kernel)


def halved(image: Array) -> Array:
    """The next level of a pyramid, (h // 2, w // 2): means of 2 x 2 pixels, smoothed as the level before was."""
    import cv2

    h, w = image.shape
    if min(h, w) < 2:
        return image[:0, :0]
    mean = cv2.resize(image[: h // 2 * 2, : w // 2 * 2], (w // 2, h // 2), interpolation=cv2.INTER_AREA)
    return cv2.GaussianBlur(mean, (0, 0), 0.5)


def pyramid(image: Array) -> tuple[Array, ...]:
    """A smoothed image (h, w) uint16 and its coarser levels."""
    levels = [image]
    while len(levels) < LEVELS:
        levels.append(halved(levels[-1]))
    return tuple(levels)
