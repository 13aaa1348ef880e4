"""What a network promises of points that are not always found: over drawings of what is found where.

The mean information of rays that are found by chance makes points of few rays too precise: a variance is convex in it.
The search for stations goes by that mean (`planning.network.expected`); what is promised of those found is given by
this.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from zlib import crc32

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.objects.surface import SurfacePoints
from raybundle.planning.network.bars import Bars
from raybundle.planning.network.expected import Expected, Networks, Part, has_depth
from raybundle.planning.network.reliability import redundancies

DRAWS = 40
"""Drawings: the largest standard deviation of a network scatters by a quarter between them, the median of all by 5 %"""
POINTS, PLACES = 17, 18
"""What is drawn: whether points are found, or places beside them"""
UNLUCKY = 0.9
"""Part of the drawings that are as good as is reported of an unlucky survey"""
OFTEN = 0.5
"""Part of the drawings in which a point must be determined for something to be promised of it"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Promise:
    """What a network promises of its points."""

    points: Array
    """(t, 3, 3) covariances [m^2]: the median variance of the drawings in which a point is determined, in the mean
    directions; NaN where that is seldom"""
    worst: float
    """Standard deviation of a coordinate of the worst point, root mean square of X, Y, Z, median of the drawings [m]"""
    largest: float
    """Largest standard deviation of a single coordinate of a point, median of the drawings [m]"""
    unlucky: float
    """As `worst`, but exceeded in one of ten drawings [m]"""
    unlucky_points: Array
    """(t,) of each point what its standard deviation exceeds in one of ten drawings that determine it [m]"""
    mean: float
    """Root mean square of all points, median of the drawings [m]"""
    often: Array
    """(t,) part of the drawings in which a point is found so that it has a depth"""
    places: Array
    """(m,) standard deviations of other places of the surface [m]; NaN where they are seldom determined"""
    interior: Array
    """(f, f) covariance of the free parameters of the interior orientation: median variances, mean correlations"""
    calibration_px: float | None
    """Largest uncertainty of projection over the format by it, median of the drawings; None where it is held"""
    least_redundancy: float
    """Smallest redundancy number of an image coordinate, median of the drawings"""
    lost: float = 0.0
    """Part of the drawings in which the network falls apart"""


def promised(
    networks: Networks, parts: Sequence[Part], places: SurfacePoints | None = None, progress: Progress = silent
) -> Promise:
    """What a network of these stations promises of its points, and of places that are measured in it.

    Standard deviations are infinite where it falls apart in half of the drawings.
    Limits: how much more than the median the worst point of one survey may have.
    """
    there = [] if places is None else networks.at_places(parts, places)
    if networks.site.found is None:
        e = networks.expected(parts)
        assert isinstance(e, Expected)
        return Promise(
            points=e.points, worst=float(e.sigma.max()), largest=_largest(e.points), unlucky=float(e.sigma.max()),
            unlucky_points=e.sigma, mean=float(np.sqrt(np.mean(e.sigma**2))),
            often=np.ones(len(e.sigma)), places=_sigma(networks, parts, e, places, there), interior=e.interior,
            calibration_px=_calibration(networks, e), least_redundancy=float(redundancies(parts, e).min()),
        )  # fmt: skip
    t, m = len(networks.site.points), 0 if places is None else len(places)
    total, count = np.zeros((t, 3, 3)), np.zeros(t)
    sigma, there_sigma = np.full((DRAWS, t), np.nan), np.full((DRAWS, m), np.nan)
    interior, least, largest = list[Array](), list[float](), list[float]()
    for k in range(DRAWS):
        progress("precision over drawings", k / DRAWS)
        drawn = _drawn(networks, parts, k)
        e = None if drawn is None else drawn[0].expected(drawn[1])
        if drawn is None or not isinstance(e, Expected):
            continue
        some, mine, good = drawn
        total[good] += e.points
        count[good] += 1
        sigma[k, good] = e.sigma
        interior.append(e.interior)
        largest.append(_largest(e.points))
        least.append(float(redundancies(mine, e).min()))
        found = [_part(networks, p, _found(p, k, PLACES), m) for p in there]
        there_sigma[k] = _sigma(some, mine, e, places, found)
    held = np.isfinite(sigma).any(axis=1)
    if held.mean() < OFTEN:
        none = np.full((t, 3, 3), np.nan)
        return Promise(
            points=none, worst=np.inf, largest=np.inf, unlucky=np.inf, unlucky_points=np.full(t, np.nan),
            mean=np.inf, often=count / DRAWS, places=np.full(m, np.nan),
            interior=np.full((len(networks.free),) * 2, np.nan), calibration_px=None, least_redundancy=0.0,
            lost=1 - float(held.mean()),
        )  # fmt: skip
    middle = _often(sigma)
    shape = total / np.maximum(count, 1)[:, None, None]
    own = np.trace(shape, axis1=1, axis2=2) / 3
    with np.errstate(invalid="ignore", divide="ignore"):
        points = shape * (middle**2 / own)[:, None, None]
    inside = np.array(interior)
    return Promise(
        interior=_middle(inside), calibration_px=_calibration_of(networks, inside),
        least_redundancy=float(np.median(least)),
        points=points, worst=float(np.median(np.nanmax(sigma[held], axis=1))), largest=float(np.median(largest)),
        unlucky=float(np.quantile(np.nanmax(sigma[held], axis=1), UNLUCKY)), unlucky_points=_often(sigma, UNLUCKY),
        mean=float(np.median(np.sqrt(np.nanmean(sigma[held] ** 2, axis=1)))), often=count / DRAWS,
        places=_often(there_sigma), lost=1 - float(held.mean()),
    )  # fmt: skip


def _middle(covariances: Array) -> Array:
    """Of covariances (d, f, f): median variances, and mean correlations."""
    if not covariances.shape[1]:
        return covariances[0]
    std = np.sqrt(np.diagonal(covariances, axis1=1, axis2=2))
    related = np.mean(covariances / (std[:, :, None] * std[:, None]), axis=0)
    middle = np.median(std, axis=0)
    return related * np.outer(middle, middle)


def _calibration(networks: Networks, e: Expected) -> float | None:
    return _calibration_of(networks, e.interior[None])


def _calibration_of(networks: Networks, covariances: Array) -> float | None:
    """Largest uncertainty of projection [px], median of drawings (d, f, f); None where the camera is held."""
    if not networks.free:
        return None
    return float(np.median([networks.shifts.uncertainty(C).largest for C in covariances]))


def _largest(points: Array) -> float:
    return float(np.sqrt(np.diagonal(points, axis1=1, axis2=2).max()))


def _often(sigma: Array, quantile: float = 0.5) -> Array:
    """Quantiles (n,) of standard deviations (d, n) over the drawings that have one; NaN where those are few."""
    found = np.isfinite(sigma)
    enough = found.mean(axis=0) >= OFTEN
    middle = np.full(sigma.shape[1], np.nan)
    middle[enough] = np.nanquantile(sigma[:, enough], quantile, axis=0)
    return middle


def _sigma(
    networks: Networks, parts: Sequence[Part], e: Expected, places: SurfacePoints | None, there: Sequence[Part]
) -> Array:
    """(m,) standard deviations of places in a network."""
    if places is None:
        return np.zeros(0)
    return np.sqrt(np.trace(networks.elsewhere(parts, e, places, there), axis1=1, axis2=2) / 3)


def _found(p: Part, drawing: int, of: int) -> Mask:
    """(k,) which of a station's points are found in a drawing: the same wherever the station stands in the list."""
    station = crc32(np.concatenate([p.centre, p.rotation.ravel()]).tobytes())
    return np.random.default_rng([drawing, of, station]).random(len(p.share)) < p.share


def _part(networks: Networks, p: Part, keep: Mask, count: int, place: Index | None = None) -> Part:
    """A part with some of its observations, each found for sure; place: of points among those that are kept."""
    root = np.sqrt(p.share[keep])[:, None, None]
    point = p.points[keep]
    return networks.part(
        p.centre, p.rotation, point if place is None else place[point], np.ones(len(point)),
        (p.A[keep] / root, p.B[keep] / root, p.D[keep] / root), count,
    )  # fmt: skip


def _drawn(networks: Networks, parts: Sequence[Part], drawing: int) -> tuple[Networks, list[Part], Index] | None:
    """One drawing: networks of the points that have a depth in it, the parts of the stations, and these points."""
    site, t = networks.site, len(networks.site.points)
    keep = [_found(p, drawing, POINTS) for p in parts]
    V, rays = np.zeros((t, 3, 3)), np.zeros(t)
    for p, k in zip(parts, keep, strict=True):
        A = p.A[k] / np.sqrt(p.share[k])[:, None, None]
        V[p.points[k]] += np.swapaxes(A, 1, 2) @ A
        rays[p.points[k]] += 1
    good = (rays >= 2) & has_depth(V)
    if networks.prior is not None:
        good |= (networks.prior > 0).all(axis=1) & (rays > 0)  # as an adjustment takes them
    rows = np.flatnonzero(good)
    if len(rows) < 3:
        return None
    place = np.full(t, -1)
    place[rows] = np.arange(len(rows))
    points = SurfacePoints(xyz=site.points.xyz[rows], normal=site.points.normal[rows])
    with np.errstate(divide="ignore"):
        control = None if networks.prior is None else 1 / np.sqrt(networks.prior[rows])
    carriers = None if networks.carriers is None else networks.carriers[rows]
    some = Networks(replace(site, points=points), control, 0, carriers, _bars(networks.bars, place))
    kept = [k & good[p.points] for p, k in zip(parts, keep, strict=True)]
    return some, [_part(networks, p, k, len(rows), place) for p, k in zip(parts, kept, strict=True)], rows


def _bars(bars: Bars | None, place: Index) -> Bars | None:
    """Those bars whose both ends are found."""
    if bars is None:
        return None
    pairs = place[bars.pairs]
    there = (pairs >= 0).all(axis=1)
    return Bars(pairs=pairs[there], sigma=bars.sigma[there]) if there.any() else None
