"""What a network promises of points that are not always found: over drawings of what is found where.

The mean information of rays that are found by chance makes points of few rays too precise: a variance is convex in it.
The search for stations goes by that mean (`planning.expected`); what is promised of those found is told by this.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.objects.surface import SurfacePoints
from raybundle.planning.bars import Bars
from raybundle.planning.expected import Expected, Networks, Part, has_depth

DRAWS = 40
"""Drawings: the largest standard deviation of a network scatters by a quarter between them, the median of all by 5 %"""
OFTEN = 0.5
"""Part of the drawings in which a point must be determined for something to be promised of it"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Promise:
    """What a network promises of its points."""

    points: Array
    """(t, 3, 3) covariances [m^2]: the median variance of the drawings in which a point is determined, in the mean
    directions; NaN where that is seldom"""
    worst: float
    """Largest standard deviation of a coordinate of a point, median of the drawings [m]"""
    mean: float
    """Root mean square of all points, median of the drawings [m]"""
    often: Array
    """(t,) part of the drawings in which a point is found so that it has a depth"""
    places: Array
    """(m,) standard deviations of other places of the surface [m]; NaN where they are seldom determined"""
    lost: float = 0.0
    """Part of the drawings in which the network falls apart"""


def promised(
    networks: Networks, parts: Sequence[Part], places: SurfacePoints | None = None, progress: Progress = silent
) -> Promise:
    """What a network of these stations promises of its points, and of places that are measured in it.

    Standard deviations are infinite where it falls apart in half of the drawings.
    What it does not tell: how much more than the median the worst point of one survey may have.
    """
    there = [] if places is None else networks.at_places(parts, places)
    if networks.site.found is None:
        e = networks.expected(parts)
        assert isinstance(e, Expected)
        return Promise(
            points=e.points, worst=float(e.sigma.max()), mean=float(np.sqrt(np.mean(e.sigma**2))),
            often=np.ones(len(e.sigma)), places=_sigma(networks, parts, e, places, there),
        )  # fmt: skip
    t, m = len(networks.site.points), 0 if places is None else len(places)
    total, count = np.zeros((t, 3, 3)), np.zeros(t)
    sigma, there_sigma = np.full((DRAWS, t), np.nan), np.full((DRAWS, m), np.nan)
    for k in range(DRAWS):
        progress("precision over drawings", k / DRAWS)
        rng = np.random.default_rng([k, 17])
        drawn = _drawn(networks, parts, rng)
        e = None if drawn is None else drawn[0].expected(drawn[1])
        if drawn is None or not isinstance(e, Expected):
            continue
        some, mine, good = drawn
        total[good] += e.points
        count[good] += 1
        sigma[k, good] = e.sigma
        found = [_part(networks, p, _found(p, rng), m) for p in there]
        there_sigma[k] = _sigma(some, mine, e, places, found)
    held = np.isfinite(sigma).any(axis=1)
    if held.mean() < OFTEN:
        none = np.full((t, 3, 3), np.nan)
        return Promise(
            points=none, worst=np.inf, mean=np.inf, often=count / DRAWS, places=np.full(m, np.nan),
            lost=1 - float(held.mean()),
        )  # fmt: skip
    middle = _often(sigma)
    shape = total / np.maximum(count, 1)[:, None, None]
    own = np.trace(shape, axis1=1, axis2=2) / 3
    with np.errstate(invalid="ignore", divide="ignore"):
        points = shape * (middle**2 / own)[:, None, None]
    return Promise(
        points=points, worst=float(np.median(np.nanmax(sigma[held], axis=1))),
        mean=float(np.median(np.sqrt(np.nanmean(sigma[held] ** 2, axis=1)))), often=count / DRAWS,
        places=_often(there_sigma), lost=1 - float(held.mean()),
    )  # fmt: skip


def _often(sigma: Array) -> Array:
    """Medians (n,) of standard deviations (d, n) over the drawings that have one; NaN where those are few."""
    found = np.isfinite(sigma)
    enough = found.mean(axis=0) >= OFTEN
    middle = np.full(sigma.shape[1], np.nan)
    middle[enough] = np.nanmedian(sigma[:, enough], axis=0)
    return middle


def _sigma(
    networks: Networks, parts: Sequence[Part], e: Expected, places: SurfacePoints | None, there: Sequence[Part]
) -> Array:
    """(m,) standard deviations of places in a network."""
    if places is None:
        return np.zeros(0)
    return np.sqrt(np.trace(networks.elsewhere(parts, e, places, there), axis1=1, axis2=2) / 3)


def _found(p: Part, rng: np.random.Generator) -> Mask:
    return rng.random(len(p.share)) < p.share


def _part(networks: Networks, p: Part, keep: Mask, count: int, place: Index | None = None) -> Part:
    """A part with some of its observations, each found for sure; place: of points among those that are kept."""
    root = np.sqrt(p.share[keep])[:, None, None]
    point = p.points[keep]
    return networks.part(
        p.centre, p.rotation, point if place is None else place[point], np.ones(len(point)),
        (p.A[keep] / root, p.B[keep] / root, p.D[keep] / root), count,
    )  # fmt: skip


def _drawn(
    networks: Networks, parts: Sequence[Part], rng: np.random.Generator
) -> tuple[Networks, list[Part], Index] | None:
    """One drawing: networks of the points that have a depth in it, the parts of the stations, and these points."""
    site, t = networks.site, len(networks.site.points)
    keep = [_found(p, rng) for p in parts]
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
