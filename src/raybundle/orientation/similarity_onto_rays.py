"""A free block onto known points that are seen once or twice: the similarity by which rays pass them best.

Where fewer than three known points have two rays, no similarity of points is determined; a point that one image sees
still shows two of its coordinates.  Turns that come into question are those by the resection of one image, those about
the line of two points, and where these do not fit, turns all over; scale and place follow linearly from each, and the
best are refined.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import cross_matrix, rotation_between, rotation_from_vector
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.candidates import resect_all

FEWEST = 3
"""Known points without which there is no similarity."""
TURNS, ALL_OVER, REFINED = 72, 800, 12
"""Turns about the line of two points that are tried; turns all over; and how many of those are refined."""
MISSED = 0.05
"""Angle [rad] beyond which a ray counts as one of a wrong point."""
FITS = 0.01
"""Angle up to which no other turn is looked for."""
ROUNDS = 30


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownRays:
    """Rays of a free block to known points."""

    image: Index
    """(m,) which image"""
    point: Index
    """(m,) which point"""
    target: Array
    """(m, 3) its known coordinates"""
    centre: Array
    """(m, 3) projection centres in the free block"""
    direction: Array
    """(m, 3) unit directions there"""


@dataclass(frozen=True, slots=True, kw_only=True)
class OntoRays:
    """X = scale rotation x + translation brings the free block to object space."""

    scale: float
    rotation: Array
    translation: Array
    angle: Array
    """(m,) [rad] by which each ray passes its point"""


def onto_rays(rays: KnownRays, free: Array) -> OntoRays | None:
    """The similarity by which the rays pass the known points best; None where it is not determined.

    free  (m, 3) the point of each ray in the free block, NaN where it has one ray only

    An approximate value: the free block counts as free of error, and the smallest of truncated angles decides, so that
    a wrong point does not bend it.  Rays may fit two similarities alike; which of them is right it does not show.
    """
    _, first = np.unique(rays.point, return_index=True)
    if len(first) < FEWEST or _in_line(rays.target[first]):
        return None
    best = _best(rays, [*_by_resection(rays), *_by_turning(rays, free)], 1)
    if best is None or np.median(best.angle) > FITS:
        more = _best(rays, _all_over(), REFINED)
        best = more if best is None or (more is not None and _cost(more) < _cost(best)) else best
    return best


def _cost(found: OntoRays) -> float:
    return float(np.minimum(found.angle, MISSED).sum())


def _best(rays: KnownRays, rotations: Sequence[Array] | Array, refined: int) -> OntoRays | None:
    """The best similarity after the most promising of some rotations were refined."""
    placed = [p for R in rotations if (p := _placed(rays, R)) is not None]
    # untruncated: far from the solution every angle is large
    placed.sort(key=lambda p: float(np.median(p.angle)) + _cost(p))
    found = [p for start in placed[:refined] if (p := _refined(rays, start.rotation)) is not None]
    return min(found, key=_cost, default=None)


def _in_line(xyz: Array) -> bool:
    s = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    return bool(s[1] < 0.02 * s[0])


def _by_resection(rays: KnownRays) -> Iterator[Array]:
    """Rotations (object from free) by the resection of each image that sees three points."""
    for mine in rows_of_each(rays.image, int(rays.image.max(initial=-1)) + 1):
        if len(mine) >= FEWEST and not _in_line(rays.target[mine]):
            # the image's own axes are those of the free block: its rotation there is none
            for pose in resect_all(rays.direction[mine], rays.target[mine]):
                yield pose.rotation.T


def _by_turning(rays: KnownRays, free: Array) -> Iterator[Array]:
    """Rotations that bring the line of two points onto their known line, turned about it."""
    known, first = np.unique(np.where(np.isfinite(free[:, 0]), rays.point, -1), return_index=True)
    rows = first[known >= 0]
    for a, b in list(combinations(rows.tolist(), 2))[:6]:
        u, v = free[b] - free[a], rays.target[b] - rays.target[a]
        if min(np.linalg.norm(u), np.linalg.norm(v)) < 1e-12 * max(1.0, float(np.abs(rays.target).max())):
            continue
        u, v = u / np.linalg.norm(u), v / np.linalg.norm(v)
        onto = rotation_between(u, v)
        for turn in np.arange(TURNS) * (2 * np.pi / TURNS):
            yield rotation_from_vector((turn * v)[None])[0] @ onto


def _all_over() -> Array:
    """Rotations (n, 3, 3) spread evenly over all there are (super-Fibonacci spirals, Alexa 2022)."""
    s = np.arange(ALL_OVER) + 0.5
    r, other = np.sqrt(s / ALL_OVER), np.sqrt(1 - s / ALL_OVER)
    a, b = 2 * np.pi * s / np.sqrt(2), 2 * np.pi * s / 1.533751168755204288118041
    x, y, z, w = r * np.sin(a), r * np.cos(a), other * np.sin(b), other * np.cos(b)
    half = np.stack([x, y, z], axis=1)
    length = np.linalg.norm(half, axis=1, keepdims=True)
    return rotation_from_vector(2 * np.arctan2(length, w[:, None]) * half / length)


def _placed(rays: KnownRays, R: Array, use: Mask | None = None) -> OntoRays | None:
    """Scale and translation that belong to a rotation, by rays `use`; None where the block turns inside out."""
    d = rays.direction @ R.T
    C = rays.centre @ R.T
    P = np.eye(3) - d[:, :, None] * d[:, None, :]
    weight = np.ones(len(d)) if use is None else use.astype(float)
    middle = rays.target.mean(axis=0)
    X = rays.target - middle
    A = np.concatenate([(P @ C[:, :, None]), P], axis=2)
    b = (P @ X[:, :, None])[:, :, 0]

    def solved(weight: Array) -> tuple[float, Array, Array]:
        x = np.linalg.lstsq((A * weight[:, None, None]).reshape(-1, 4), (b * weight[:, None]).ravel(), rcond=None)[0]
        return float(x[0]), x[1:], X - x[1:] - x[0] * C

    away = solved(weight)[2]
    # an angle is what counts: with the distances that are known now
    s, t, away = solved(weight / np.maximum(np.linalg.norm(away, axis=1), 1e-300))
    if not s > 0:
        return None
    angle = np.arctan2(np.linalg.norm(np.cross(away, d), axis=1), (away * d).sum(axis=1))
    return OntoRays(scale=s, rotation=R, translation=t + middle, angle=angle)


def _refined(rays: KnownRays, R: Array) -> OntoRays | None:
    """Gauss-Newton on the rotation; scale and translation, and which rays take part, follow."""
    best = _placed(rays, R)
    for _ in range(ROUNDS):
        if best is None:
            return None
        use = best.angle < max(MISSED, 3 * float(np.median(best.angle)))
        now = _placed(rays, best.rotation, use)
        if now is None:
            return best
        r = _across(rays, now)[use].ravel()
        step = 1e-5
        columns = list[Array]()
        for e in np.eye(3):
            other = _placed(rays, rotation_from_vector((step * e)[None])[0] @ now.rotation, use)
            if other is None:
                return best
            columns.append((_across(rays, other)[use].ravel() - r) / step)
        turn = -np.linalg.lstsq(np.stack(columns, axis=1), r, rcond=None)[0]
        length = float(np.linalg.norm(turn))
        turned = rotation_from_vector((turn * min(1.0, 0.2 / max(length, 1e-300)))[None])[0] @ now.rotation
        new = _placed(rays, turned, use)
        if new is None or np.minimum(new.angle, MISSED).sum() > np.minimum(now.angle, MISSED).sum() * (1 + 1e-9):
            return now
        best = new
        if length < 1e-9:
            break
    return best


def _across(rays: KnownRays, found: OntoRays) -> Array:
    """(m, 3) by how much each ray passes its point, as a vector divided by the distance."""
    d = rays.direction @ found.rotation.T
    away = rays.target - found.translation - found.scale * rays.centre @ found.rotation.T
    across = (cross_matrix(d) @ away[:, :, None])[:, :, 0]
    return across / np.linalg.norm(away, axis=1, keepdims=True)
