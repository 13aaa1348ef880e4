"""The largest part of a dot's edge that lies on one ellipse, along rays from within the dot.

Grey values fall from dot to ground somewhere along a ray; where something lies on the dot or beside it, they do so
elsewhere, several times or never.  Ellipses are put through parts of the edge, beginning at every ray; the one that
most rays agree with is kept, and fitted again to all of these.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.targets.centre import SECTORS
from raybundle.targets.conics import centred, conics, matrix, sampson
from raybundle.targets.rings import circle, frame, sample

RAYS = 48
PARTS = (0.35, 0.5)
"""Shares of the rays that an ellipse is put through."""
NEAR_PX, NEAR = 0.25, 0.02
"""Largest distance of an edge from the ellipse: pixels and mean radii.

Between two samples an edge is found to a tenth of a pixel; perspective and print leave a hundredth of a radius.
"""
LEAST = 0.5
"""Least share of the rays that agree."""
FARTHEST = 1.9
"""Radii to which the edge is sought."""
SIZES = (0.4, 2.5)
"""Least and largest semi-axis, in units of those of the approximate ellipse."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Arc:
    """An ellipse and the part of it that was seen."""

    xy_px: Array
    """(2,)"""
    ellipse: Array
    """(2, 2)"""
    free: Mask
    """(32,) sectors of the ellipse, as `centre.sector_of` counts them, in which the edge lies on it"""


def free_arc(image: Array, xy: Array, ellipse: Array) -> Arc | None:
    """The ellipse (near `xy` (2,), `ellipse` (2, 2)) that the largest part of an edge lies on; None without."""
    L = frame(ellipse)
    u = circle(np.arange(RAYS) * 2 * np.pi / RAYS)
    radius = float(np.sqrt(abs(np.linalg.det(L))))
    crossings = _crossings(image, xy, L, u, radius)
    if crossings is None:
        return None
    points = u[:, None] * crossings[..., None]  # NaN where there is none
    near = max(NEAR_PX / radius, NEAR)
    best, agree = None, np.zeros(RAYS, bool)
    a = _through_parts(points)
    for _ in range(3):
        a = a[_is_ellipse(a)]
        if not len(a):
            return None
        distance = _distance(a, points)
        nearest = distance.min(axis=2)
        count = (nearest < near).sum(axis=1)
        k = int(np.argmax(count - np.minimum(nearest, near).sum(axis=1) / (near * RAYS)))
        best, agree = a[k], nearest[k] < near
        which = np.argmin(distance[k], axis=1)
        a = conics(np.nan_to_num(points[np.arange(RAYS), which])[None], agree[None].astype(float))
    if best is None or agree.mean() < LEAST:
        return None
    return _as_arc(best, xy, L, points, near)


def _crossings(image: Array, xy: Array, L: Array, u: Array, radius: float) -> Array | None:
    """Distances (rays, m) from the centre at which grey values fall half way from dot to ground; NaN elsewhere."""
    n = int(np.clip(np.ceil((FARTHEST - 0.2) * radius / 0.6), 17, 90))
    rho = np.linspace(0.2, FARTHEST, n)
    places = xy + (u[:, None] * rho[:, None]) @ L.T
    grey = sample(image, places)
    h, w = image.shape
    grey[((places < 0.5) | (places > [w - 0.5, h - 0.5])).any(axis=-1)] = np.nan
    core, ground = grey[:, rho < 0.55], grey[:, rho > 1.4]
    if np.isnan(core).all() or np.isnan(ground).all():
        return None
    core, ground = float(np.nanmedian(core)), float(np.nanmedian(ground))
    if abs(core - ground) < 1:
        return None
    share = (grey - ground) / (core - ground) - 0.5
    before, after = share[:, :-1], share[:, 1:]
    falls = (before > 0) & (after <= 0)
    return np.where(falls, rho[:-1] + before / np.where(falls, before - after, 1) * (rho[1] - rho[0]), np.nan)


def _through_parts(points: Array) -> Array:
    """Conics (n, 5) through parts of the edge: of the first and of the last crossings of their rays."""
    some = ~np.isnan(points[..., 0])
    rays = np.arange(RAYS)
    first, last = np.argmax(some, axis=1), some.shape[1] - 1 - np.argmax(some[:, ::-1], axis=1)
    found: Mask = np.asarray(some.any(axis=1))
    all_ = []
    for which in (first, last):
        p = np.where(found[:, None], points[rays, which], 0)
        for part in PARTS:
            within = (rays - np.arange(0, RAYS, 2)[:, None]) % RAYS < part * RAYS
            w = (within & found).astype(float)
            w = w[w.sum(axis=1) > 0.7 * part * RAYS]
            all_.append(conics(np.broadcast_to(p, (len(w), *p.shape)), w))
    return np.concatenate(all_)


def _is_ellipse(a: Array) -> Mask:
    """Which conics (n, 5) are ellipses of about the size and place of the unit circle."""
    M, c, k = _centred(a)
    size, _ = np.linalg.eigh(M)
    fine = (size > 1e-6).all(axis=1) & (k > 0)
    axes = np.sqrt(np.where(fine, k, 1)[:, None] / np.where(fine[:, None], size, 1))
    return fine & (axes > SIZES[0]).all(axis=1) & (axes < SIZES[1]).all(axis=1) & (np.hypot(*c.T) < 1)


def _centred(a: Array) -> tuple[Array, Array, Array]:
    """As `centred`; k is -1 where there is no centre."""
    regular = abs(np.linalg.det(matrix(a))) > 1e-9
    M, c, k = centred(a, regular)
    return M, c, np.where(regular, k, -1)


def _distance(a: Array, points: Array) -> Array:
    """Distances (n, rays, m) of points (rays, m, 2) from conics (n, 5); infinite where there is none."""
    distance = sampson(a, points.reshape(-1, 2)).reshape(len(a), *points.shape[:2])
    return np.where(np.isnan(distance), np.inf, distance)


def _as_arc(a: Array, xy: Array, L: Array, points: Array, near: float) -> Arc:
    """The ellipse in the image, and its sectors in which the edge was seen, less one at the ends of each part."""
    M, c, k = (m[0] for m in _centred(a[None]))
    ellipse = L @ (np.linalg.inv(M) * k) @ L.T
    distance = _distance(a[None], points)[0]
    agree = (distance < near).any(axis=1)
    which = np.argmin(distance, axis=1)
    at = (points[np.arange(RAYS), which] - c) @ L.T
    p = np.linalg.solve(frame(ellipse), at.T)
    turn = np.arctan2(p[1], p[0]) / (2 * np.pi) % 1
    # a sector is as the nearest ray says, and as the rays beside it
    angle = (np.arange(SECTORS) + 0.5) / SECTORS
    seen = agree & np.roll(agree, 1) & np.roll(agree, -1)
    gap = abs((angle[:, None] - turn + 0.5) % 1 - 0.5)
    gap = np.where(np.isnan(gap), np.inf, gap)
    free = seen[np.argmin(gap, axis=1)] & (gap.min(axis=1) < 1.0 / SECTORS)
    return Arc(xy_px=xy + L @ c, ellipse=ellipse, free=free)
