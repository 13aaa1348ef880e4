"""Tracks measured again: every image point by least-squares matching against one reference image of its track."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from raybundle.matching.least_squares import Outcome, WindowOptions, match_windows
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent

CORRELATION = 0.85
"""Least correlation of two windows that are believed to show the same."""


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


def choose_references(points: TrackPoints) -> Index:
    """(m,) row of the reference of each row's track: the ray whose feature is largest, so that windows shrink."""
    order = np.lexsort((np.arange(len(points.point)), -points.scale_px, points.point))
    _, first = np.unique(points.point[order], return_index=True)
    best = order[first]
    return best[np.searchsorted(points.point[best], points.point)]


def refine_tracks(
    points: TrackPoints,
    image: Callable[[int], Array],
    *,
    rows: Mask | None = None,
    options: WindowOptions | None = None,
    threads: int = 1,
    progress: Progress = silent,
) -> Refined:
    """Measure the points of tracks again.

    image    gives image i as (h, w) uint16, slightly smoothed (`smoothed`)
    rows     (m,) rows to measure; None = all
    """
    m = len(points.image)
    options = options or WindowOptions()
    reference = choose_references(points)
    wanted = np.ones(m, bool) if rows is None else rows.copy()
    wanted &= reference != np.arange(m)
    xy, cov = points.xy_px.copy(), np.zeros((m, 3))
    measured, correlation = np.zeros(m, bool), np.zeros(m)
    pair = points.image[reference].astype(np.int64) * (int(points.image.max(initial=0)) + 1) + points.image
    todo = np.flatnonzero(wanted)
    todo = todo[np.argsort(pair[todo], kind="stable")]
    groups = np.split(todo, np.flatnonzero(np.diff(pair[todo])) + 1) if len(todo) else []

    def run(group: Index) -> None:
        r = reference[group]
        affine = similarity(points, r, group)
        source, target = image(int(points.image[r[0]])), image(int(points.image[group[0]]))
        found = match_windows(source, target, points.xy_px[r], points.xy_px[group], affine, options)
        good = (found.outcome == Outcome.MATCHED) & (found.correlation > CORRELATION)
        mine = group[good]
        xy[mine], cov[mine], measured[mine] = found.xy_px[good], found.cov_px2[good], True
        correlation[group] = found.correlation

    with ThreadPoolExecutor(max(threads, 1)) as pool:
        for k, _ in enumerate(pool.map(run, groups)):
            progress("least-squares matching", (k + 1) / max(len(groups), 1))
    references = np.unique(reference[measured])
    measured[references], correlation[references] = True, 1.0
    is_reference = np.zeros(m, bool)
    is_reference[references] = True
    return Refined(xy_px=xy, cov_px2=cov, measured=measured, reference=is_reference, correlation=correlation)


def similarity(points: TrackPoints, source: Index, target: Index) -> Array:
    """target_from_reference (n, 2, 2) by scale and direction of the features."""
    s = points.scale_px[target] / points.scale_px[source]
    a = points.angle[target] - points.angle[source]
    c, n = s * np.cos(a), s * np.sin(a)
    return np.stack([np.stack([c, -n], axis=1), np.stack([n, c], axis=1)], axis=1)


def smoothed(grey: Array, sigma_px: float = 0.6) -> Array:
    """A grey image (uint8 or uint16) as uint16 with a light smoothing, which keeps interpolation honest."""
    import cv2  # noqa: PLC0415

    scale = 256.0 if grey.dtype == np.uint8 else 1.0
    wide = cv2.GaussianBlur(grey.astype(np.float32) * np.float32(scale), (0, 0), sigma_px)
    return np.clip(np.round(wide), 0, 65535).astype(np.uint16)
