"""A network planned for an object: the fewest stations that reach what is wanted, and what each is for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from threadpoolctl import threadpool_limits

from raybundle.errors import InputError, Message, message
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.progress import Progress, silent
from raybundle.objects.surface import SurfacePoints, tiles
from raybundle.planning.network.aims import Aim, AimName, aims
from raybundle.planning.network.candidates import LEAST, Stations, candidate_stations, places_of
from raybundle.planning.network.configuration import Design, Designer, Search, improved
from raybundle.planning.network.datum_of_plan import Held, Wanted, held
from raybundle.planning.network.densify import Densified, densified, repeated
from raybundle.planning.network.detection_draws import Promise, promised
from raybundle.planning.network.expected import SURE, Expected, Networks, Part, Short
from raybundle.planning.network.site import Site

FEWEST, MOST = 4, 60
"""Stations of a network that are looked for"""
QUICK = Search(places=250, beginnings=3, moved=1, moves=1200, together=0)
MARGIN = 1.03
"""How far a quick search may miss what is wanted where a thorough one is still tried: what the second gains on average
in benchmarks/design.py is more"""
NEARLY = 0.1
"""Part of its stations that a network of points that are not always found may have more than the fewest: quick searches
are no better"""
GIVEN_UP, FEW = 3, 0.1
"""How often points that a network does not show are left out of it, and at most what part of all at once"""
PLACES = 400
"""Places from which it is looked at what can be seen at all"""
MAPPED = 1500
"""Places of the object at which the precision is reported"""
LOSES = 1.02
"""A station without which a figure grows by less than this is there for redundancy"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cost:
    """What a network costs on site."""

    photographs: int
    path_m: float
    """Walked from station to station, shortest way found"""
    minutes: float
    seconds_per_photograph: float = 30.0
    metres_per_second: float = 0.7

    @classmethod
    def of(cls, centre: Array) -> Cost:
        """Of stations (n, 3), in the order in which one walks."""
        path = float(np.linalg.norm(np.diff(centre, axis=0), axis=1).sum())
        none = cls(photographs=len(centre), path_m=path, minutes=0.0)
        seconds = none.photographs * none.seconds_per_photograph + path / none.metres_per_second
        return replace(none, minutes=seconds / 60)


@dataclass(frozen=True, slots=True, kw_only=True)
class Purpose:
    """What one station is there for: what the network would lose without it."""

    unseen: Index
    """Points that would have less than two rays"""
    ratio: float
    """Worst or mean standard deviation without the station, by that with it; infinite where it is not determined"""
    worst: int
    """The point that loses most"""
    worst_ratio: float
    parameters: tuple[tuple[str, float], ...] = ()
    """Parameters of the interior orientation and by how much they lose, most first"""


@dataclass(frozen=True, slots=True, kw_only=True)
class NetworkPlan:
    """A network and what it promises."""

    site: Site
    design: Design
    """Its stations in the order in which one walks"""
    expected: Expected
    aim: Aim
    wanted: float | None
    """Standard deviation that was wanted [m]"""
    purposes: tuple[Purpose, ...]
    cost: Cost
    corners: Array
    """(m, 3, 3) triangles of the object, small enough to show the precision of each"""
    mapped: SurfacePoints
    """Their middles"""
    map_sigma: Array
    """(m,) standard deviation of the middles [m]; NaN where less than two stations see them"""
    promise: Promise
    """Of the points, relative to all of them"""
    promise_known: Promise
    """The same in the frame of the scale bars and control that were wanted; the same without any"""
    left_out: SurfacePoints
    """Points of the object that cannot be seen often enough from where one may stand; nothing is promised of them"""
    more: tuple[Densified, ...] = ()
    """Photographs that were added: for the whole surface, or once more from stations that are there"""
    held: Held | None = None
    """With the scale bars and control that were wanted; None without"""
    tried: tuple[tuple[int, float], ...] = field(default=())
    """Numbers of stations that were tried, and the figure that was reached with them [m]"""

    @property
    def reached(self) -> bool:
        """Whether what was wanted is promised."""
        return self.wanted is None or self.figure <= self.wanted

    @property
    def figure(self) -> float:
        """What is made small, as it is promised: a standard deviation [m], pixels, or 1 by a redundancy number."""
        return figure_of(self.aim, self.promise, self.design)

    @property
    def scale_number(self) -> float:
        """Mean image scale number S = distance / c of the rays."""
        return self.mean_distance / (self.site.camera.sensor.camera_constant(self.site.camera.parameters) / 1000)

    @property
    def mean_distance(self) -> float:
        """Mean distance of the points from the stations that see them [m]."""
        s = self.design.stations
        station, point, _, _ = self.site.seen(s.centre, s.rotation)
        return float(np.linalg.norm(s.centre[station] - self.site.points.xyz[point], axis=1).mean())

    @property
    def base_to_depth(self) -> float:
        """B/D: of each point the longest base between two stations that see it by its mean distance; their median."""
        s, xyz = self.design.stations, self.site.points.xyz
        station, point, _, _ = self.site.seen(s.centre, s.rotation)
        far = np.linalg.norm(s.centre[:, None] - s.centre[None], axis=2)
        away = np.linalg.norm(s.centre[station] - xyz[point], axis=1)
        found = [
            far[np.ix_(station[mine], station[mine])].max() / away[mine].mean()
            for mine in (np.flatnonzero(point == p) for p in range(len(xyz))) if len(mine)
        ]  # fmt: skip
        return float(np.median(found))

    @property
    def q(self) -> float:
        """Factor q of sigma_XYZ = q S sigma / sqrt(k), with the mean number k of rays (Fraser 1984)."""
        sigma_xyz = float(np.sqrt(np.mean(self.expected.sigma**2)))
        sigma = self.site.sigma_px * self.site.camera.pixel_mm[0] / 1000
        return sigma_xyz * np.sqrt(self.expected.rays.mean()) / (self.scale_number * sigma)


def plan_network(
    site: Site, *, wanted: float | None = None, stations: int | None = None, start: Stations | None = None,
    aim: AimName = "worst", least_rays: int = 3, search: Search | None = None, as_given: bool = False,
    known: Wanted | None = None, everywhere: bool = False, repeat: int = 0, progress: Progress = silent,
) -> NetworkPlan:  # fmt: skip
    """The network of so many stations with the best figure, or of the fewest that reach what is wanted.

    wanted    standard deviation [m] of the worst point or of all in the mean, as `aim` states
    stations  how many; None: as few as reach `wanted`
    start     stations to begin with; the result is never worse
    as_given  the stations of `start` are judged as they are and in their order, and none is looked for
    known     scale bars and control that are put on the object, beside the figure of the network itself
    everywhere  stations are added until `wanted` is reached on all of the surface that can be seen
    repeat    so many photographs more from stations that are there
    least_rays  as of `Networks`
    raises    InputError where neither is reported, or `wanted` is beyond reach: it states what can be reached and why
    Limits: whether targets can be fixed and recognised there; errors that all photographs share, as of
    a camera that is not stable.
    """
    if wanted is not None and aims[aim].unit != "m":
        raise InputError("plan.aim_no_sigma", aim=aim)
    if wanted is None and stations is None and start is None:
        raise InputError("plan.no_goal")
    site, left_out = _reachable(site, least_rays, start if as_given else None)
    designer = Designer(Networks(site, None, least_rays), aim, progress)
    none = Stations(centre=np.zeros((0, 3)), at=np.zeros((0, 3)), roll=np.zeros(0))
    first = none if start is None else start
    tried = list[tuple[int, float]]()
    if as_given:
        design = designer.design(first)
    elif stations is not None or wanted is None:
        design = improved(designer, first, search, stations or len(first))
        for _ in range(GIVEN_UP):  # few points that so many stations do not show are left out rather than all refused
            if design.expected is not None:
                break
            seldom = _seldom_shown(designer, design)
            if not 0 < len(seldom) <= FEW * len(site.points):
                break
            site, left_out = _without(site, seldom, left_out)
            designer = Designer(Networks(site, None, least_rays), aim, progress)
            design = improved(designer, design.stations, search, stations or len(first))
        tried.append((len(design.stations), design.figure))
    else:
        design = _fewest(designer, first, wanted, search, tried)
    if design.expected is None:
        raise InputError(_not_determined(site, design, least_rays, as_given=as_given))
    if wanted is not None and not as_given:
        design = _as_promised(designer, design, wanted, tried)
    more = list[Densified]()
    if everywhere and wanted is not None:
        more.append(densified(designer, design.stations, wanted))
        design = designer.design(more[-1].stations)
    if repeat:
        more.append(repeated(designer, design.stations, repeat))
        design = designer.design(more[-1].stations)
    with threadpool_limits(1):
        return _plan(
            designer, design, wanted, tuple(tried), left_out, known or Wanted(), tuple(more), in_order=as_given
        )


def _seldom_shown(d: Designer, design: Design) -> Index:
    """Points that a design does not show as often as they must be, or from one place alone."""
    parts = d.networks.parts(design.stations.centre, design.stations.rotation)
    e = d.networks.expected(parts)
    return np.flatnonzero(e.unseen) if isinstance(e, Short) else np.zeros(0, np.int64)


def _without(site: Site, points: Index, left_out: SurfacePoints) -> tuple[Site, SurfacePoints]:
    p = site.points
    kept = np.setdiff1d(np.arange(len(p)), points)
    out = SurfacePoints(
        xyz=np.concatenate([left_out.xyz, p.xyz[points]]), normal=np.concatenate([left_out.normal, p.normal[points]])
    )
    return replace(site, points=SurfacePoints(xyz=p.xyz[kept], normal=p.normal[kept])), out


def _reachable(site: Site, least_rays: int, only: Stations | None) -> tuple[Site, SurfacePoints]:
    """The site with the points that can be seen from enough places, or by enough of these stations; the others.

    raises  InputError where too few are left for a network
    """
    p = site.points
    if only is None:
        count = places_of(site, candidate_stations(site, PLACES, straight=False))
    else:
        station, point = site.seen(only.centre, only.rotation)[:2]
        count = np.bincount(point, site.share(only.centre[station], point), minlength=len(p))
    good = count >= least_rays - SURE
    left_out = SurfacePoints(xyz=p.xyz[~good], normal=p.normal[~good])
    if good.sum() < LEAST:
        raise InputError(
            "plan.too_few_visible",
            n=int(good.sum()),
            total=len(p),
            least=least_rays,
            given=only is not None,
        )
    return replace(site, points=SurfacePoints(xyz=p.xyz[good], normal=p.normal[good])), left_out


def _fewest(
    d: Designer, first: Stations, wanted: float, search: Search | None, tried: list[tuple[int, float]]
) -> Design:
    """The smallest network that reaches what is wanted: quick searches of ever more stations, then a thorough one."""
    n, best = max(FEWEST, len(first)), None
    figures = list[tuple[int, float]]()
    while n <= MOST:
        quick = improved(d, first, QUICK, n)
        figures.append((n, quick.figure))
        if quick.figure <= wanted * MARGIN:
            best = improved(d, quick.stations, search, n)
            tried.append((n, best.figure))
            if best.figure <= wanted:
                return best
        n += _step(figures, wanted)
    reached = [f for f in figures if np.isfinite(f[1])]
    if best is not None and not reached:
        return best
    raise InputError(_beyond(d, wanted, reached))


def figure_of(aim: Aim, promise: Promise, design: Design) -> float:
    """The figure of an aim, of standard deviations as they are promised."""
    if aim.name == "calibration":
        return design.figure if promise.calibration_px is None else promise.calibration_px
    if aim.name == "reliability":
        return 1 / max(promise.least_redundancy, 1e-9)
    return promise.worst if aim.name == "worst" else promise.mean


def _as_promised(d: Designer, design: Design, wanted: float, tried: list[tuple[int, float]]) -> Design:
    """The design with stations added until what is wanted is promised, of points that are not always found."""
    if d.site.found is None:
        return design

    def reached(design: Design) -> bool:
        s = design.stations
        with threadpool_limits(1):
            promise = promised(d.networks, d.networks.parts(s.centre, s.rotation), progress=d.progress)
        tried.append((len(s), figure_of(d.aim, promise, design)))
        figures.append(tried[-1])
        return tried[-1][1] <= wanted

    figures, short = list[tuple[int, float]](), design
    if reached(design):
        return design
    while True:
        n = len(short.stations) + _step(figures, wanted)
        if n > MOST:
            raise InputError(_beyond(d, wanted, figures))
        design = improved(d, short.stations, QUICK, n)
        if reached(design):
            break
        short = design
    while len(design.stations) - len(short.stations) > max(1, NEARLY * len(design.stations)):
        middle = improved(d, short.stations, QUICK, (len(design.stations) + len(short.stations)) // 2)
        design, short = (middle, short) if reached(middle) else (design, middle)
    return design


def _step(figures: Sequence[tuple[int, float]], wanted: float) -> int:
    """How many stations more: standard deviations fall with the root of their number at best."""
    n, figure = figures[-1]
    if not np.isfinite(figure):
        return 1
    # a point that is hardly seen makes a figure worse than the number alone: no more than twice as many at once
    return max(1, min(n, int(n * (figure / wanted) ** 2 * 0.8) - n)) if figure > 1.3 * wanted else 1


def _beyond(d: Designer, wanted: float, reached: list[tuple[int, float]]) -> Message:
    if not reached:
        return message("plan.no_network_sees_all", most=MOST, least=d.networks.least_rays)
    n, figure = min(reached, key=lambda r: r[1])
    site = d.site
    c = site.camera.sensor.camera_constant(site.camera.parameters) / site.camera.pixel_mm[0]
    near = max(site.access.clearance, site.depth[0])
    return message(
        "plan.beyond_reach",
        wanted_mm=1000 * wanted,
        n=n,
        reached_mm=1000 * figure,
        near_m=near,
        sigma_px=site.sigma_px,
        sigma_mm=1000 * near * site.sigma_px / c,
    )


def _not_determined(site: Site, design: Design, least: int, *, as_given: bool) -> Message:
    s = design.stations
    station, point, _, _ = site.seen(s.centre, s.rotation)
    rays = np.bincount(point, site.share(s.centre[station], point), minlength=len(site.points))
    shown = np.bincount(station, minlength=len(s))
    if (shown < LEAST).any():
        k = int(shown.argmin())
        return message(
            "plan.station_sees_too_few",
            station=k + 1,
            n=shown[k],
            total=len(rays),
            least=LEAST,
            stations=int((shown < LEAST).sum()),
            all_stations=len(s),
            given=as_given,
        )
    few = int((rays < least - SURE).sum())
    if few:
        return message("plan.too_few_rays", stations=len(s), n=few, total=len(rays), least=least)
    return message("plan.not_determined", stations=len(s), free=bool(site.free))


def _plan(
    d: Designer, design: Design, wanted: float | None, tried: tuple[tuple[int, float], ...], left_out: SurfacePoints,
    known: Wanted, more: tuple[Densified, ...], *, in_order: bool,
) -> NetworkPlan:  # fmt: skip
    site, e = d.site, design.expected
    assert e is not None
    parts = d.networks.parts(design.stations.centre, design.stations.rotation)
    order = np.arange(len(parts)) if in_order else walk(design.stations.centre)
    design = replace(design, stations=design.stations.rows(order))
    parts = [parts[k] for k in order]
    corners, mapped = tiles(site.surface, MAPPED)
    e = d.networks.expected(parts)
    assert isinstance(e, Expected)
    known_there = held(d, parts, known)
    networks = d.networks if known_there is None else known_there.networks
    with_known = promised(networks, parts, mapped, d.progress)
    promise = with_known if known_there is None else promised(d.networks, parts, progress=d.progress)
    for p in (with_known, promise):
        if not np.isfinite(p.worst):
            raise InputError("plan.points_rarely_found", n=len(parts), share=p.lost)
    loose = d.networks.with_rays(2)
    n, cost = len(parts), Cost.of(design.stations.centre)
    return NetworkPlan(
        site=site, design=replace(design, expected=e), expected=e, aim=d.aim, wanted=wanted, tried=tried, cost=cost,
        left_out=left_out, held=known_there, more=more,
        purposes=tuple(_purpose(d, loose, e, parts, k) for k in range(n)), corners=corners, mapped=mapped,
        map_sigma=with_known.places, promise=promise, promise_known=with_known,
    )  # fmt: skip


def _purpose(d: Designer, loose: Networks, e: Expected, parts: list[Part], k: int) -> Purpose:
    without = loose.expected(parts[:k] + parts[k + 1 :])
    if isinstance(without, Short):
        unseen = np.flatnonzero(without.unseen)
        return Purpose(unseen=unseen, ratio=np.inf, worst=int(unseen[0]) if len(unseen) else 0, worst_ratio=np.inf)
    each = without.sigma / e.sigma
    worst = int(each.argmax())
    lost = np.sqrt(np.diag(without.interior) / np.diag(e.interior)) if len(e.interior) else np.zeros(0)
    order = np.argsort(-lost)
    ratio = d.figure(parts[:k] + parts[k + 1 :], without) / d.figure(parts, e)
    return Purpose(
        unseen=np.zeros(0, np.int64), ratio=ratio, worst=worst, worst_ratio=float(each[worst]),
        parameters=tuple((d.networks.free[i], float(lost[i])) for i in order if lost[i] > LOSES),
    )  # fmt: skip


def walk(places: Array) -> Index:
    """(n,) an order of places on a short way: the nearest next, then sections turned round (2-opt)."""
    n = len(places)
    far = np.linalg.norm(places[:, None] - places[None], axis=2)
    order = [0]
    left = set(range(1, n))
    while left:
        k = min(left, key=lambda j: (far[order[-1], j], j))
        order.append(k)
        left.remove(k)
    better = True
    while better:
        better = False
        for i in range(n - 1):
            for j in range(i + 1, n):
                before = far[order[i - 1], order[i]] if i else 0.0
                after = far[order[j], order[j + 1]] if j + 1 < n else 0.0
                new = (far[order[i - 1], order[j]] if i else 0.0) + (far[order[i], order[j + 1]] if j + 1 < n else 0.0)
                if new < before + after - 1e-9:
                    order[i : j + 1] = order[i : j + 1][::-1]
                    better = True
    return np.array(order)
