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
from raybundle.targets.conics import centred, conics, sampson
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
TOGETHER = 32
"""Dots that are looked at together."""
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


def free_arcs(image: Array, xy: Array, ellipse: Array) -> list[Arc | None]:
    """The ellipses (near `xy` (n, 2), `ellipse` (n, 2, 2)) that the largest parts of edges lie on; None without."""
    found: list[Arc | None] = [None] * len(xy)
    L = frame(ellipse)
    radius = np.sqrt(np.abs(np.linalg.det(L)))
    u = circle(np.arange(RAYS) * 2 * np.pi / RAYS)
    crossed = {i: c for i in range(len(xy)) if (c := _crossings(image, xy[i], L[i], u, float(radius[i]))) is not None}
    for first in range(0, len(crossed), TOGETHER):
        rows = list(crossed)[first : first + TOGETHER]
        points = u[:, None] * _few([crossed[i] for i in rows])[..., None]  # NaN where there is none
        near = np.maximum(NEAR_PX / radius[rows], NEAR)
        best, good = _best_ellipses(points, near)
        for k in np.flatnonzero(good).tolist():
            i = rows[k]
            found[i] = _as_arc(best[k], xy[i], L[i], points[k], float(near[k]))
    return found


def _best_ellipses(points: Array, near: Array) -> tuple[Array, Mask]:
    """Conics (d, 5) that most rays agree with to `near` (d,), and which (d,) are good ellipses; points (d, rays, m, 2).

    The best of those through parts of the edge, fitted again to all rays that agree, twice.
    """
    d, rays = len(points), np.arange(RAYS)
    each = np.arange(d)
    a, there = _through_parts(points)
    best, agree, alive = np.zeros((d, 5)), np.zeros((d, RAYS), bool), np.ones(d, bool)
    for _ in range(3):
        there = there & _is_ellipse(a)
        alive &= there.any(axis=1)
        distance = np.where(there[..., None, None], _distance(a, points), np.inf)
        nearest, limit = distance.min(axis=3), near[:, None, None]
        count = (nearest < limit).sum(axis=2) - np.minimum(nearest, limit).sum(axis=2) / (near[:, None] * RAYS)
        k = np.argmax(count, axis=1)
        best, agree = a[each, k], nearest[each, k] < near[:, None]
        which = np.argmin(distance[each, k], axis=2)
        at = np.nan_to_num(points[each[:, None], rays, which])
        a, there = conics(at, agree.astype(float))[:, None], np.ones((d, 1), bool)
    return best, alive & (agree.mean(axis=1) >= LEAST)


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


def _few(crossings: list[Array]) -> Array:
    """The same crossings (d, rays, m), those of a ray one after the other, in as few columns as hold them."""
    most = max(int((~np.isnan(c)).sum(axis=1).max(initial=1)) for c in crossings)
    packed = np.full((len(crossings), RAYS, most), np.nan)
    for k, c in enumerate(crossings):
        ray, column = np.nonzero(~np.isnan(c))
        starts = np.searchsorted(ray, np.arange(RAYS))
        packed[k, ray, np.arange(len(ray)) - starts[ray]] = c[ray, column]
    return packed


def _through_parts(points: Array) -> tuple[Array, Mask]:
    """Conics (d, k, 5) through parts of the edges: of the first and of the last crossings of their rays; which are."""
    some = ~np.isnan(points[..., 0])
    each, rays = np.arange(len(points))[:, None], np.arange(RAYS)
    first, last = np.argmax(some, axis=2), some.shape[2] - 1 - np.argmax(some[..., ::-1], axis=2)
    found: Mask = np.asarray(some.any(axis=2))
    conic, there = list[Array](), list[Mask]()
    for which in (first, last):
        p = np.where(found[..., None], points[each, rays, which], 0)[:, None]
        for part in PARTS:
            within = (rays - np.arange(0, RAYS, 2)[:, None]) % RAYS < part * RAYS
            w = (within & found[:, None]).astype(float)
            conic.append(conics(np.broadcast_to(p, (*w.shape, 2)), w))
            there.append(w.sum(axis=2) > 0.7 * part * RAYS)
    return np.concatenate(conic, axis=1), np.concatenate(there, axis=1)


def _is_ellipse(a: Array) -> Mask:
    """Which conics (..., 5) are ellipses of about the size and place of the unit circle."""
    M, c, k = _centred(a.reshape(-1, 5))
    # semi-axes squared are k over the eigenvalues of M
    half, det = (M[:, 0, 0] + M[:, 1, 1]) / 2, M[:, 0, 0] * M[:, 1, 1] - M[:, 0, 1] * M[:, 1, 0]
    root = np.sqrt(np.maximum(half * half - det, 0))
    small, large = half - root, half + root
    fine = (small > 1e-6) & (k > 0) & (np.hypot(*c.T) < 1)
    fine &= (k > SIZES[0] ** 2 * large) & (k < SIZES[1] ** 2 * small)
    return fine.reshape(a.shape[:-1])


def _centred(a: Array) -> tuple[Array, Array, Array]:
    """As `centred`; k is -1 where there is no centre."""
    regular = abs(a[:, 0] * a[:, 2] - a[:, 1] ** 2 / 4) > 1e-9
    M, c, k = centred(a, regular)
    return M, c, np.where(regular, k, -1)


def _distance(a: Array, points: Array) -> Array:
    """Distances (d, k, rays, m) of points (d, rays, m, 2) from conics (d, k, 5); infinite where there is none."""
    d, rays, m, _ = points.shape
    distance = sampson(a, points.reshape(d, 1, rays * m, 2)).reshape(*a.shape[:2], rays, m)
    return np.where(np.isnan(distance), np.inf, distance)


def _as_arc(a: Array, xy: Array, L: Array, points: Array, near: float) -> Arc:
    """The ellipse in the image, and its sectors in which the edge was seen, less one at the ends of each part."""
    M, c, k = (m[0] for m in _centred(a[None]))
    ellipse = L @ (np.linalg.inv(M) * k) @ L.T
    distance = _distance(a[None, None], points[None])[0, 0]
    agree = (distance < near).any(axis=1)
    which = np.argmin(distance, axis=1)
    at = (points[np.arange(RAYS), which] - c) @ L.T
    p = np.linalg.solve(frame(ellipse), at.T)
    turn = np.arctan2(p[1], p[0]) / (2 * np.pi) % 1
    # a sector is as the nearest ray states, and as the rays beside it
    angle = (np.arange(SECTORS) + 0.5) / SECTORS
    seen = agree & np.roll(agree, 1) & np.roll(agree, -1)
    gap = abs((angle[:, None] - turn + 0.5) % 1 - 0.5)
    gap = np.where(np.isnan(gap), np.inf, gap)
    free = seen[np.argmin(gap, axis=1)] & (gap.min(axis=1) < 1.0 / SECTORS)
    return Arc(xy_px=xy + L @ c, ellipse=ellipse, free=free)
