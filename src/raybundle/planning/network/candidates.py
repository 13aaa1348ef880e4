"""Stations that could be taken at a site: places one may stand at, and where the camera looks from there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.planning.network.site import Site
from raybundle.planning.synthetic_networks import look_at

LEAST = 4
"""Points that a photograph must show: fewer do not orient it"""
SEVERAL = 6
"""Places from which each point should be seen: two or three of them are to be chosen"""
TRIES = 60
"""Places drawn for each that is wanted, before it is stated that there are none"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Stations:
    """Places, what is looked at, and how the camera is turned about its axis."""

    centre: Array
    """(n, 3) [m]"""
    at: Array
    """(n, 3) points on the axes [m]"""
    roll: Array
    """(n,) turn about the axis against the upright camera [rad]"""

    @property
    def rotation(self) -> Array:
        """(n, 3, 3) object axes to image axes."""
        return look_at(self.centre, self.at, self.roll)

    def __len__(self) -> int:
        """How many there are."""
        return len(self.centre)

    def rows(self, rows: Index) -> Stations:
        """Some of them."""
        return Stations(centre=self.centre[rows], at=self.at[rows], roll=self.roll[rows])

    def with_one(self, k: int, centre: Array, at: Array, roll: float) -> Stations:
        """With another one in the place of number k."""
        c, a, r = self.centre.copy(), self.at.copy(), self.roll.copy()
        c[k], a[k], r[k] = centre, at, roll
        return Stations(centre=c, at=a, roll=r)

    def without(self, k: int) -> Stations:
        """Without number k."""
        return self.rows(np.delete(np.arange(len(self)), k))


def joined(*parts: Stations) -> Stations:
    """All stations of some sets."""
    return Stations(
        centre=np.concatenate([p.centre for p in parts]), at=np.concatenate([p.at for p in parts]),
        roll=np.concatenate([p.roll for p in parts]),
    )  # fmt: skip


def standing_places(site: Site, count: int) -> Array:
    """(k, 3) places where one may stand and from which something of the object is seen; at most `count`.

    Half of them evenly over the volume that is allowed; half before points of the surface along their normals, at
    distances that are even in their logarithm.
    raises  InputError where there are none
    """
    a = site.access
    even = a.low + (a.high - a.low) * _sequence(TRIES * count, 3)
    p = site.points
    row = np.arange(TRIES * count) % len(p)
    before = _along_normals(site, row, np.linalg.norm(p.normal, axis=1)[row, None])
    found = [_first_allowed(site, places, count // 2) for places in (even, before)]
    places = np.concatenate(found)
    if not len(places):
        raise InputError(
            "plan.no_station_allowed",
            n=2 * TRIES * count,
            low=a.low.tolist(),
            high=a.high.tolist(),
            clearance_m=a.clearance,
        )
    station, _ = site.faced(places)
    seen = np.bincount(station, minlength=len(places)) >= LEAST
    if not seen.any():
        raise InputError(
            "plan.object_not_seen", n=len(places), least=LEAST, near_m=site.depth[0], incidence_deg=site.incidence_deg
        )
    return places[seen]


def candidate_stations(site: Site, places: int = 400, aims: int = 3, *, straight: bool = True) -> Stations:
    """Stations at places where one may stand, upright and rolled by 90 degrees, that look at what they see best.

    aims      at most so many directions from a place where not everything seen from there fits into the format
    straight  with stations that look straight at points which few of the others show
    """
    centre = standing_places(site, places)
    station, point = site.faced(centre)
    found = list[tuple[Array, Array]]()
    half = np.arctan(site.camera.size_mm.max() / 2 / site.camera.sensor.camera_constant(site.camera.parameters))
    for k in range(len(centre)):
        rows = point[station == k]
        if len(rows) < LEAST:
            continue
        found += [(centre[k], at) for at in _aims(centre[k], site.points.xyz[rows], float(half), aims)]
    made = _both_rolls(np.array([f[0] for f in found]), np.array([f[1] for f in found]))
    if straight:
        seldom = np.flatnonzero(places_of(site, made) < SEVERAL)
        made = joined(made, _at_them(site, seldom, centre)) if len(seldom) else made
    shown = np.bincount(site.seen(made.centre, made.rotation)[0], minlength=len(made))
    return made if (shown >= LEAST).all() or not (shown >= LEAST).any() else made.rows(np.flatnonzero(shown >= LEAST))


def places_of(site: Site, stations: Stations) -> Array:
    """(t,) from how many places stations show each point; a place counts by the share in which it is found there."""
    station, point = site.seen(stations.centre, stations.rotation)[:2]
    place = np.unique(stations.centre, axis=0, return_inverse=True)[1].ravel()[station]
    pairs, first = np.unique(place * len(site.points) + point, return_index=True)
    share = site.share(stations.centre[station[first]], point[first])
    return np.bincount(pairs % len(site.points), share, minlength=len(site.points))


def _both_rolls(centre: Array, at: Array) -> Stations:
    roll = np.repeat([0.0, np.pi / 2], len(centre))
    return Stations(centre=np.tile(centre, (2, 1)), at=np.tile(at, (2, 1)), roll=roll)


def _at_them(site: Site, points: Index, places: Array) -> Stations:
    """Stations that look straight at points which few others show, from places that are there and some before them."""
    places = np.concatenate([places, _before(site, points)])
    station, point = site.faced(places)
    enough = np.bincount(station, minlength=len(places)) >= LEAST
    mine = np.flatnonzero(np.isin(point, points) & enough[station])
    off = np.linalg.norm(places[station[mine]] - site.points.xyz[point[mine]], axis=1)
    mine = mine[np.lexsort((off, point[mine]))]
    rank = np.arange(len(mine)) - np.searchsorted(point[mine], point[mine])
    mine = mine[rank < 2 * SEVERAL]
    return _both_rolls(places[station[mine]], site.points.xyz[point[mine]])


def _before(site: Site, points: Index) -> Array:
    """(k, 3) places where one may stand before points that few other places see, along their normals."""
    row = np.tile(points, 10 * TRIES)
    drawn = _along_normals(site, row, 2 * np.tan(np.radians(site.incidence_deg)))
    allowed = np.flatnonzero(site.may_stand(drawn))
    allowed = allowed[np.argsort(row[allowed], kind="stable")]
    station, point = site.faced(drawn[allowed])
    enough = np.bincount(station, minlength=len(allowed)) >= LEAST
    mine = (point == row[allowed][station]) & enough[station]
    good = allowed[np.unique(station[mine])]
    rank = np.arange(len(good)) - np.searchsorted(row[good], row[good])  # of each point the first so many
    return drawn[good[rank < SEVERAL]]


def _along_normals(site: Site, row: Index, aside: Array | float) -> Array:
    """(n, 3) places before points, in directions beside their normals, at distances even in their logarithm."""
    a, p = site.access, site.points
    u = _sequence(len(row), 4)
    far = min(float(np.linalg.norm(a.high - a.low)), site.depth[1])
    near = max(a.clearance, site.depth[0], 1e-3 * far)
    way = p.normal[row] + aside * (u[:, :3] - 0.5)
    return np.clip(p.xyz[row] + (near * (far / near) ** u[:, 3:]) * way, a.low, a.high)


def _aims(centre: Array, xyz: Array, half_angle: float, most: int) -> list[Array]:
    """What to look at: the middle of what is seen; where that is wider than the format, also its parts."""
    ray = xyz - centre
    ray = ray / np.linalg.norm(ray, axis=1, keepdims=True)
    middle = ray.mean(axis=0)
    middle = middle / np.linalg.norm(middle)
    aims = [xyz[np.argmax(ray @ middle)]]
    wide = ray @ middle < np.cos(half_angle)
    if wide.any():
        far = [int((ray @ middle).argmin())]
        while len(far) < most - 1:
            near = np.max(ray @ ray[far].T, axis=1)
            far.append(int(near.argmin()))
        aims += [(0.5 * xyz[k] + 0.5 * aims[0]) for k in far]
    return aims


def _first_allowed(site: Site, places: Array, count: int) -> Array:
    """The first `count` of places where one may stand."""
    found = list[Array]()
    for first in range(0, len(places), 4 * count or 1):
        some = places[first : first + 4 * count]
        found.append(some[site.may_stand(some)])
        if sum(len(f) for f in found) >= count:
            break
    return np.concatenate(found)[:count]


def _sequence(n: int, dimensions: int) -> Array:
    """(n, d) evenly distributed numbers between 0 and 1 (Roberts 2018: the root of x^(d+1) = x + 1)."""
    g = 2.0
    for _ in range(40):
        g = (1 + g) ** (1 / (dimensions + 1))
    return (0.5 + np.arange(1, n + 1)[:, None] / g ** np.arange(1, dimensions + 1)) % 1.0
