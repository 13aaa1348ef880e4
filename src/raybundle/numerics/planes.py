"""The plane that most of many points lie in, each within what its standard deviation allows."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.numerics.arrays import Array, Mask

LIMIT = 3.29
"""Standard deviations within which a point lies in the plane: one point of it in a thousand is missed."""
TRIALS = 4600
"""Planes tried: of three points each all three lie in a plane that holds a tenth of the points with probability 1e-3,
and ln 0.01 / ln (1 - 1e-3) trials miss it once in a hundred."""
SAMPLE = 2000
"""Points by which the trials are compared; a tenth of them is counted to 7 %."""
TOGETHER = 256
"""Planes tried at a time"""
ROUNDS = 20
STEEP = 0.26
"""Vertical part of the normal up to which a plane is a wall: 15 degrees, which no building that stands leans"""
RELIEF = 0.1
"""Depth of a wall's relief (cornices, reveals, bays), as a share of its longer side: no other wall lies within it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundPlane:
    """A plane and the points that lie in it."""

    origin: Array
    """(3,) centre of gravity of these points, by weight"""
    normal: Array
    """(3,)"""
    inliers: Mask
    """(n,)"""


def plane_of_most(points: Array, sigma: Array, least: float, *, steep: Array | None = None) -> FoundPlane:
    """The plane in which most of the points (n, 3) lie, fitted to these by weight.

    sigma  (n, 3) standard deviations of the coordinates [as these]; NaN: not known, `least` alone counts
    least  distance below which a point lies in the plane whatever its sigma [as the points], > 0
    steep  (3,) the vertical, of which the plane is to be within 15 degrees: a wall; None: any plane

    Three points at a time, chosen by chance with a fixed seed, make planes to be tried; the one of least truncated
    squares is taken (MSAC: Torr, Zisserman 2000), each distance against `LIMIT` times the point's own standard
    deviation across that plane.  The covariances between the coordinates of a point are left out of that deviation.

    Limits: which of two planes with as many points is meant, and whether the few that lie in the best
    one are a wall or chance.
    """
    variance = np.where(np.isfinite(sigma), sigma, 0.0) ** 2
    rng = np.random.default_rng(1)
    pick = rng.choice(len(points), min(len(points), SAMPLE), replace=False)
    few, few_variance = points[pick] - points.mean(axis=0), variance[pick]
    best, found = np.inf, (np.zeros(3), np.array([0.0, 0.0, 1.0]))
    chosen = np.array([rng.choice(len(few), 3, replace=False) for _ in range(TRIALS)])
    a, b, c = few[chosen].swapaxes(0, 1)
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1)
    normal = normal / np.maximum(length, 1e-300)[:, None]
    tried = length >= 1e-12
    if steep is not None:
        tried &= np.abs(normal @ steep) <= STEEP
    a, normal = a[tried], normal[tried]
    for k in range(0, len(a), TOGETHER):
        some = slice(k, k + TOGETHER)
        across = few @ normal[some].T - np.sum(a[some] * normal[some], axis=1)
        cost = np.minimum(across**2 / _square_limits(few_variance, normal[some].T, least), 1.0).sum(axis=0)
        if cost.min() < best:
            best, found = float(cost.min()), (a[some][np.argmin(cost)], normal[some][np.argmin(cost)])
    return _fitted(points, variance, least, points.mean(axis=0) + found[0], found[1])


def planes_of_most(
    points: Array, sigma: Array, least: float, *, count: int, steep: Array | None = None
) -> list[FoundPlane]:
    """Up to `count` planes, most points first, each without the points of those before it and of their relief.

    Arguments as of `plane_of_most`.  Fewer planes are returned where fewer than three points are left.
    """
    rest, found = np.arange(len(points)), list[FoundPlane]()
    while len(found) < count and len(rest) > 2:
        one = plane_of_most(points[rest], sigma[rest], least, steep=steep)
        if one.inliers.sum() < 3:
            break
        mine = np.zeros(len(points), bool)
        mine[rest[one.inliers]] = True
        found.append(replace(one, inliers=mine))
        rest = rest[~_in_relief(points[rest], points[mine], one)]
    return found


def _in_relief(points: Array, mine: Array, plane: FoundPlane) -> Mask:
    """(n,) points in front of or behind the part of a plane that its own points (k, 3) cover, by its relief at most."""
    axes = np.linalg.svd(mine - plane.origin, full_matrices=False)[2]
    own, at = (mine - plane.origin) @ axes[:2].T, (points - plane.origin) @ axes[:2].T
    low, high = np.percentile(own, [0.5, 99.5], axis=0)
    reach = RELIEF * float((high - low).max())
    near = np.abs((points - plane.origin) @ plane.normal) <= reach
    return np.asarray(near & (at >= low - reach).all(axis=1) & (at <= high + reach).all(axis=1))


def in_plane(points: Array, variance: Array, least: float, origin: Array, normal: Array) -> Mask:
    """(n,) which points lie in a plane, each within what its variances (n, 3) allow or within `least`."""
    return ((points - origin) @ normal) ** 2 <= _square_limits(variance, normal, least)


def _fitted(points: Array, variance: Array, least: float, origin: Array, normal: Array) -> FoundPlane:
    """The plane by its own points, until these are the same."""
    inliers = np.zeros(len(points), bool)
    for _ in range(ROUNDS):
        limits = _square_limits(variance, normal, least)
        near = ((points - origin) @ normal) ** 2 <= limits
        if near.sum() < 3 or (near == inliers).all():
            break
        inliers = near
        weight = 1.0 / limits[near]
        origin = np.average(points[near], axis=0, weights=weight)
        centred = (points[near] - origin) * np.sqrt(weight)[:, None]
        normal = np.linalg.svd(centred, full_matrices=False)[2][2]
    return FoundPlane(origin=origin, normal=normal, inliers=inliers)


def _square_limits(variance: Array, normal: Array, least: float) -> Array:
    """(n,) or (n, t) squared distances within which points lie in a plane of this normal (3,), or in these (3, t)."""
    return np.maximum(LIMIT**2 * (variance @ normal**2), least**2)


def hull(xy: Array) -> Array:
    """The convex hull (k, 2) of points (n, 2), counter-clockwise (Andrew 1979)."""
    points = np.unique(np.asarray(xy, float), axis=0)
    if len(points) < 3:
        return points

    def half(rows: Array) -> list[Array]:
        chain: list[Array] = []
        for p in rows:
            while len(chain) > 1:
                u, v = chain[-1] - chain[-2], p - chain[-1]
                if u[0] * v[1] - u[1] * v[0] > 0:
                    break
                chain.pop()
            chain.append(p)
        return chain

    return np.array(half(points)[:-1] + half(points[::-1])[:-1])
