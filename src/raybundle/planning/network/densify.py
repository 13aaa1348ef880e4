"""More photographs for a planned network: from stations that are there, or for parts of the object that are too weak.

The second and the third order of design (Grafarend 1974; Fraser 1984): weights, here as photographs that are taken more
than once from a station, and densification.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from threadpoolctl import threadpool_limits

from raybundle.numerics.arrays import Array, Index
from raybundle.objects.surface import SurfacePoints, tiles
from raybundle.planning.network.candidates import Stations, candidate_stations, joined
from raybundle.planning.network.configuration import SHORT, Designer
from raybundle.planning.network.expected import Expected, Networks, Part

MAPPED = 600
"""Places of the object that are looked at"""
MOST = 30
"""Photographs that are added at most"""
TRIED = 15
"""Candidates of each round that are tried exactly"""
PLACES = 300
RAYS_WANTED = 3.0
"""Rays from which on a place counts by its standard deviation alone; each that is missing counts as twice the figure"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Densified:
    """A network with more photographs."""

    stations: Stations
    of: Index
    """(k,) of each added photograph the station that it repeats; -1: a new one"""
    figures: Array
    """(k + 1,) figure before and after each: of the aim, or the largest standard deviation of the surface [m]"""
    open_share: float = 0.0
    """Share of the places that stay above what is wanted, of those that can be seen at all"""


def repeated(designer: Designer, stations: Stations, extra: int) -> Densified:
    """So many photographs once more from stations that are there, each from where it lowers the figure most.

    A photograph that is repeated has an orientation of its own: only its place and direction are the same.
    """
    with threadpool_limits(1):
        parts = designer.networks.parts(stations.centre, stations.rotation)
        n, all_ = len(parts), list(parts)
        values, of = [designer.value(all_)], list[int]()
        for _ in range(extra):
            tried = [designer.value([*all_, parts[k]]) for k in range(n)]
            k = int(np.argmin(tried))
            of.append(k)
            all_.append(parts[k])
            values.append(tried[k])
    rows = np.array([*range(n), *of])
    figures = np.where(np.array(values) < SHORT, np.exp(values) * designer.scale, np.inf)
    return Densified(stations=stations.rows(rows), of=np.array(of, np.int64), figures=figures)


def densified(designer: Designer, stations: Stations, wanted: float) -> Densified:
    """Stations added until the whole surface that can be seen is as precise as wanted, or no station helps.

    wanted  largest standard deviation of a coordinate [m], of points that are measured there
    Limits: that the stations before could not be moved to the same end.
    """
    with threadpool_limits(1):
        return _densified(designer, stations, wanted)


def _densified(d: Designer, stations: Stations, wanted: float) -> Densified:
    _, places = tiles(d.site.surface, MAPPED)
    there = _Places(d, places, wanted)
    all_ = candidate_stations(d.site, PLACES)
    parts = d.networks.parts(stations.centre, stations.rotation)
    mine, added, figures = list(parts), list[int](), list[float]()
    candidates, own = there.parts(all_), d.networks.parts(all_.centre, all_.rotation)
    seen = list(there.parts(stations))
    reachable = np.bincount(np.concatenate([p.points for p in candidates + seen]), minlength=len(places)) >= 2
    worth = there.worth(mine, seen, reachable)
    figures.append(worth[1])
    while worth[1] > wanted and len(added) < MOST:
        rough = there.rough(seen, candidates, reachable)
        best, at = worth, -1
        for k in np.argsort(rough, kind="stable")[:TRIED].tolist():
            new = there.worth([*mine, own[k]], [*seen, candidates[k]], reachable)
            if new[0] < best[0] * (1 - 1e-6):
                best, at = new, k
        if at < 0:
            break
        mine.append(own[at])
        seen.append(candidates[at])
        added.append(at)
        worth = best
        figures.append(worth[1])
        d.progress("adding stations", len(added) / MOST)
    return Densified(
        stations=joined(stations, all_.rows(np.array(added, np.int64))), of=np.full(len(added), -1),
        figures=np.array(figures), open_share=worth[2],
    )  # fmt: skip


class _Places:
    """Places of the surface, measured in networks without adding to them."""

    def __init__(self, d: Designer, places: SurfacePoints, wanted: float) -> None:
        self.d, self.places, self.wanted = d, places, wanted
        self.networks = Networks(replace(d.site, points=places))

    def parts(self, stations: Stations) -> list[Part]:
        return self.networks.parts(stations.centre, stations.rotation)

    def worth(self, mine: Sequence[Part], seen: Sequence[Part], reachable: Array) -> tuple[float, float, float]:
        """What is made small, the largest standard deviation [m], and the share of places above what is wanted."""
        e = self.d.networks.expected(mine)
        if not isinstance(e, Expected):
            return np.inf, np.inf, 1.0
        Q = self.d.networks.elsewhere(mine, e, self.places)
        sigma = np.sqrt(np.trace(Q, axis1=1, axis2=2) / 3)
        rays = np.bincount(np.concatenate([p.points for p in seen]), minlength=len(sigma))
        unseen = np.isnan(sigma)
        # a place that is not measured counts more the more rays it lacks, so that the first one of two helps
        excess = np.where(unseen, 2.0 * (RAYS_WANTED - np.minimum(rays, 2)), sigma / self.wanted - 1)[reachable]
        largest = np.inf if unseen[reachable].any() else float(sigma[reachable].max())
        return float(np.maximum(excess, 0).sum()), largest, float((excess > 0).mean())

    def rough(self, seen: Sequence[Part], candidates: Sequence[Part], reachable: Array) -> Array:
        """(c,) sums of squares of what places are above the wanted, with known stations."""
        V = np.sum([p.V for p in seen], axis=0)[reachable]
        weak = 1 / (2 * RAYS_WANTED * self.wanted) ** 2 * np.eye(3)
        found = np.empty(len(candidates))
        for k, p in enumerate(candidates):
            trace = np.trace(np.linalg.inv(V + p.V[reachable] + weak), axis1=1, axis2=2) / 3
            found[k] = np.maximum(trace / self.wanted**2 - 1, 0).sum()
        return found
