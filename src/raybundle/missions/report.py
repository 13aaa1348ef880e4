"""What a mission amounts to: overlaps over the relief, GSD, blur, way, time, batteries; and what is wrong with it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raybundle.missions.mission import Exposures, Mission, exposures
from raybundle.missions.patterns import patterns
from raybundle.missions.places import places
from raybundle.missions.polygons import distance_to, inside
from raybundle.missions.terrain import Ground
from raybundle.missions.vehicle import HEIGHT_LIMIT_M, SIGHT_M
from raybundle.missions.views import Coverage, aimed_at, coverage, ground_points, overlap
from raybundle.numerics.arrays import Array
from raybundle.settings import option

OVERLAP_LOST = 0.05
"""By which the least overlap may stay below what was asked for without a word."""
PARALLEL = 0.2
"""Sine of the angle between lines up to which they lie beside each other."""
SAME, FARTHEST = 1e-3, 1.5
"""Distances to another line, as shares of the spacing, between which it is the next one: parts of one line, which a
zone or a battery divides, lie on one; rows of a facade lie nearer where the ground does not let them lie lower."""
SEEN = 3
"""Photographs in which a place is to be seen at least: with two, a blunder along the epipolar line stays unseen."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Spread:
    """The least, the middle and the greatest of some figures."""

    low: float
    middle: float
    high: float


@dataclass(frozen=True, slots=True, kw_only=True)
class MissionFacts:
    """Figures of a mission."""

    photographs: int
    lines: int
    way_points: int
    gsd: Spread
    """in the middle of photographs [m]"""
    above: Spread
    """heights of photographs above the ground below [m]"""
    along: Spread | None
    """overlap of neighbours along a line, share of the photograph that both show; None: no line has two"""
    across: Spread | None
    """overlap of photographs of neighbouring lines; None: no two lines of a group"""
    blur_px: float
    """greatest motion during the exposure"""
    interval_s: float | None
    """least time between photographs of a line; None: all are taken standing"""
    rolling_px: float | None
    """motion while a rolling shutter reads a frame; None: none is known"""
    length_m: float
    minutes: tuple[float, ...]
    """of each battery"""
    farthest_m: float
    """from the take-off, in plan"""
    coverage: Coverage | None
    """of an area; None: no ground is photographed"""
    seen_rarely: float
    """share of the area that fewer than `SEEN` photographs show"""
    rarely_inside: float = 0.0
    """share of the area that is seen so rarely farther inside than a photograph beyond its edge could reach"""
    rarely_at_zones: float = 0.0
    """the same, but so near to a no-go zone that a photograph from there would show it"""


def mission_facts(mission: Mission, ground: Ground) -> MissionFacts:
    """The figures.

    What they do not show: overlaps hold for a vehicle that keeps its way and its attitude; wind and a late release
    change them.
    """
    e = exposures(mission)
    w = mission.way_points
    along, across = overlaps(mission, e, ground)
    centre = ground_points(mission.camera, e, ground, (1, 1))[:, 0, 0]
    away = np.linalg.norm(centre - e.xyz, axis=1)
    gsd = away / mission.camera.c_px
    on_line = w.line >= 0
    lined = on_line & np.isfinite(w.base)
    speed = w.speed[lined]
    area, deep, at_zones = None, 0.0, 0.0
    if mission.closed and np.isnan(e.distance).any():
        sides = mission.camera.footprint(float(np.nanmedian(away)))
        area = coverage(mission.camera, e, places(mission.outline, min(sides) / 20, ground))
        deep, at_zones = _rarely(mission, area, max(sides) / 2)
    readout = mission.camera.read_out_s
    fastest = float(speed.max(initial=0.0))
    finest = float(np.nanmin(gsd))
    return MissionFacts(
        photographs=len(e), lines=len(mission.lines), way_points=len(w), gsd=spread(gsd),
        above=spread(e.xyz[:, 2] - ground(e.xyz[:, :2])), along=along, across=across,
        blur_px=fastest * mission.camera.exposure_s / finest,
        interval_s=float((w.base[lined] / speed).min()) if lined.any() else None,
        rolling_px=None if readout is None else fastest * readout / finest,
        length_m=sum(_length(w.of_flight(f).xyz) for f in range(mission.flights)),
        minutes=tuple(seconds_of(mission, f) / 60 for f in range(mission.flights)),
        farthest_m=float(np.linalg.norm(w.xyz[:, :2] - np.array(mission.take_off[:2]), axis=1).max()),
        coverage=area, seen_rarely=0.0 if area is None else area.share_below(SEEN),
        rarely_inside=deep, rarely_at_zones=at_zones,
    )  # fmt: skip


def _rarely(mission: Mission, area: Coverage, reach: float) -> tuple[float, float]:
    """Shares of the area that are seen rarely beyond the reach of its edge: far from no-go zones, and near them."""
    at, part = area.places.xyz[:, :2], area.places.part
    few = (area.count < SEEN) & (distance_to(mission.outline, at) > reach)
    near = np.zeros(len(at), bool)
    for zone in mission.no_go:
        near |= inside(zone, at) | (distance_to(zone, at) <= reach)
    return float(part[few & ~near].sum() / part.sum()), float(part[few & near].sum() / part.sum())


def spread(values: Array) -> Spread:
    """Of some figures, those that are not known left out."""
    return Spread(low=float(np.nanmin(values)), middle=float(np.nanmedian(values)), high=float(np.nanmax(values)))


def _length(xyz: Array) -> float:
    return float(np.linalg.norm(np.diff(xyz, axis=0), axis=1).sum())


def overlaps(mission: Mission, e: Exposures, ground: Ground) -> tuple[Spread | None, Spread | None]:
    """Overlaps of neighbours along lines, and of each photograph with the nearest one of the next line of its group."""
    follow = np.flatnonzero((e.line[1:] == e.line[:-1]) & (e.flight[1:] == e.flight[:-1]))
    along = overlap(mission.camera, e, ground, follow, follow + 1, abreast=False) if len(follow) else None
    first, second = beside(mission, e, ground)
    across = overlap(mission.camera, e, ground, first, second, abreast=True) if len(first) else None
    return None if along is None else spread(along), None if across is None else spread(across)


def beside(mission: Mission, e: Exposures, ground: Ground) -> tuple[Array, Array]:
    """Photographs, and the one of the nearest line beside theirs that is aimed nearest to what they are aimed at.

    Lines of one group run the same way at one tilt, to and fro.  Those at the ends of lines, to which the next line
    has nobody beside, are left out: nearer than half a base along.
    """
    from scipy.spatial import KDTree  # noqa: PLC0415  (SciPy is loaded only where it is used)

    first: list[int] = []
    second: list[int] = []
    groups: dict[str, list[int]] = {}
    for k, line in enumerate(mission.lines):
        groups.setdefault(line.group, []).append(k)
    aim = aimed_at(mission.camera, e, ground)
    for members in groups.values():
        rows = np.flatnonzero(np.isin(e.line, members))
        walls = np.isfinite(e.distance[rows]).any()
        at = aim[rows] if walls else aim[rows, :2]
        reach = float(np.hypot(FARTHEST * mission.spacing, mission.base))
        for i, near in zip(rows.tolist(), KDTree(at).query_ball_point(at, reach), strict=True):
            others = rows[near]
            j = _nearest_beside(e, aim, i, others[e.line[others] != e.line[i]], mission)
            if j is not None:
                first.append(i)
                second.append(j)
    return np.array(first, int), np.array(second, int)


def _nearest_beside(e: Exposures, aim: Array, i: int, others: Array, mission: Mission) -> int | None:
    if not len(others):
        return None
    d = aim[others] - aim[i]
    ahead = np.array([np.sin(e.heading[i]), np.cos(e.heading[i])])
    if np.isfinite(e.distance[i]):  # a facade or ring: rows lie above each other
        along = np.abs(d[:, :2] @ np.array([ahead[1], -ahead[0]]))
        away = np.abs(d[:, 2])
    else:
        along = np.abs(d[:, :2] @ ahead)
        away = np.abs(d[:, :2] @ np.array([ahead[1], -ahead[0]]))
    turn = np.abs(np.sin(e.heading[others] - e.heading[i])) < PARALLEL  # in a bend nobody flies beside
    apart = away / mission.spacing
    good = np.flatnonzero(turn & (along <= mission.base / 2 + 1e-6) & (apart > SAME) & (apart < FARTHEST))
    if not len(good):
        return None
    return int(others[good[np.lexsort((along[good], np.round(away[good], 3)))[0]]])


def seconds_of(mission: Mission, flight: int) -> float:
    """Time of a battery in the air [s], from take-off to landing, in calm air."""
    v, w = mission.vehicle, mission.way_points.of_flight(flight)
    ground = mission.take_off[2]
    time = max(w.xyz[0, 2] - ground, 0) / v.climb + max(w.xyz[-1, 2] - ground, 0) / v.descent
    d = np.diff(w.xyz, axis=0)
    plan = np.linalg.norm(d[:, :2], axis=1)
    vertical = np.where(d[:, 2] > 0, d[:, 2] / v.climb, -d[:, 2] / v.descent)
    time += float(np.maximum(plan / w.speed[:-1], vertical).sum())
    standing = w.trigger == 1
    stops = w.trigger >= 1  # at both ends of a line, and where one photograph is taken
    time += float((w.speed[stops] / v.acceleration).sum()) / 2
    return float(time) + float(standing.sum()) * max(1.0, mission.camera.interval_s)


@dataclass(frozen=True, slots=True, kw_only=True)
class Doubt:
    """What speaks against a mission."""

    kind: str
    fault: bool
    """whether it must not be flown so"""
    words: str


def warnings(
    mission: Mission, facts: MissionFacts, *, limit_m: float = HEIGHT_LIMIT_M, sight_m: float = SIGHT_M,
) -> tuple[Doubt, ...]:  # fmt: skip
    """What is wrong or doubtful; words that show the figure, its limit, and what to do."""
    found: list[Doubt] = []

    def notify(kind: str, words: str, *, fault: bool = False) -> None:
        found.append(Doubt(kind=kind, fault=fault, words=words))

    if facts.above.high > limit_m:
        source = " of the open category (EU 2019/947, UAS.OPEN.010)" if limit_m == HEIGHT_LIMIT_M else ""
        notify(
            "height",
            f"photographs lie up to {facts.above.high:.0f} m above the ground, {limit_m:g} m are the limit{source}; "
            f"plan a finer GSD, follow the terrain, or raise {option('height_limit')} where you may fly higher",
            fault=True,
        )
    if facts.farthest_m > sight_m:
        notify(
            "sight",
            f"the flight goes {facts.farthest_m:.0f} m away from the take-off, {sight_m:g} m are taken for the reach "
            f"of sight ({option('sight')}); take off nearer to the middle, or divide the area",
        )
    usable = mission.vehicle.usable_s / 60
    longest = max(facts.minutes)
    if longest > usable * 1.02:
        notify("battery", f"a flight takes {longest:.1f} min, {usable:.1f} min of a battery may be used", fault=True)
    if facts.interval_s is not None and facts.interval_s < mission.camera.interval_s * (1 - 1e-9):
        notify(
            "interval",
            f"photographs follow each other in {facts.interval_s:.2f} s, {mission.camera.name} needs "
            f"{mission.camera.interval_s:g} s",
            fault=True,
        )
    _judge_overlap(notify, mission, facts)
    if facts.rolling_px is not None and facts.rolling_px > 1:
        notify(
            "shutter",
            f"the rolling shutter moves by {facts.rolling_px:.1f} px on the ground while a frame is read; stop for the "
            "photographs, fly more slowly, or adjust with the rolling platform",
        )
    if facts.seen_rarely > 0:
        notify(
            "rare",
            f"{100 * facts.seen_rarely:.1f} % of the area is seen by fewer than {SEEN} photographs; "
            f"{_more_photographs(mission, facts)}",
        )
    return tuple(found)


def _more_photographs(mission: Mission, facts: MissionFacts) -> str:
    """What shows places of an area in more photographs: it goes by where they lie."""
    if facts.rarely_inside > 0:
        along, across = (f"{100 * v:.0f} %" for v in mission.overlap)
        return f"{along} along and {across} across show no more of its middle: raise the overlap ({option('overlap')})"
    if facts.rarely_at_zones > 0:
        return f"that is at no-go zones: let views tilted towards them show it ({option('tilt')}), or make them smaller"
    return f"that is at its edges: widen it ({option('margin')})"


def _judge_overlap(notify: Callable[[str, str], None], mission: Mission, facts: MissionFacts) -> None:
    pattern = patterns[mission.pattern]
    advice, where = pattern.more(), ""
    if mission.terrain and pattern.ground:
        where = " over high ground"
        advice = (
            "lines are followed by the heights below them alone, and ground that rises beside them is nearer: fly "
            f"higher ({option('gsd')}, {option('height')}), or ask for more ({option('overlap')})"
        )
    for what, found, asked in (
        ("along the lines", facts.along, mission.overlap[0]), ("across the lines", facts.across, mission.overlap[1]),
    ):  # fmt: skip
        if found is not None and found.low < asked - OVERLAP_LOST:
            line = f"the overlap {what} falls to {100 * found.low:.0f} %{where}, {100 * asked:.0f} % were asked for"
            notify("overlap", f"{line}; {advice}")
