"""What a mission amounts to: overlaps over the relief, GSD, blur, way, time, batteries; and what is wrong with it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.errors import Message, Severity, warning
from raybundle.missions.mission import Exposures, Mission, exposures
from raybundle.missions.patterns import patterns
from raybundle.missions.places import places
from raybundle.missions.polygons import distance_to, inside
from raybundle.missions.terrain import Ground
from raybundle.missions.vehicle import HEIGHT_LIMIT_M, SIGHT_M
from raybundle.missions.views import Coverage, aimed_at, coverage, ground_points, overlap
from raybundle.numerics.arrays import Array

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
    from scipy.spatial import KDTree

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


def warnings(
    mission: Mission, facts: MissionFacts, *, limit_m: float = HEIGHT_LIMIT_M, sight_m: float = SIGHT_M,
) -> tuple[Message, ...]:  # fmt: skip
    """What is wrong (faults: it must not be flown so) or doubtful: the figure, its limit, and what to do."""
    usable, longest, needed = mission.vehicle.usable_s / 60, max(facts.minutes), mission.camera.interval_s
    faults: list[Message] = []
    found: list[Message] = []
    if facts.above.high > limit_m:
        faults.append(
            warning(
                "mission.too_high", height_m=facts.above.high, limit_m=limit_m, open_category=limit_m == HEIGHT_LIMIT_M
            )
        )
    if longest > usable * 1.02:
        faults.append(warning("mission.battery_exceeded", minutes=longest, usable=usable))
    if facts.interval_s is not None and facts.interval_s < needed * (1 - 1e-9):
        faults.append(
            warning("mission.interval_short", interval_s=facts.interval_s, camera=mission.camera.name, needed_s=needed)
        )
    if facts.farthest_m > sight_m:
        found.append(warning("mission.out_of_sight", distance_m=facts.farthest_m, limit_m=sight_m))
    found += _low_overlaps(mission, facts)
    if facts.rolling_px is not None and facts.rolling_px > 1:
        found.append(warning("mission.rolling_motion", motion_px=facts.rolling_px))
    if facts.seen_rarely > 0:
        where = "middle" if facts.rarely_inside > 0 else "zones" if facts.rarely_at_zones > 0 else "edges"
        along, across = mission.overlap
        found.append(
            warning(
                "mission.seen_rarely",
                share=facts.seen_rarely,
                photographs=SEEN,
                where=where,
                along=along,
                across=across,
            )
        )
    return (*(replace(m, severity=Severity.FAULT) for m in faults), *found)


def _low_overlaps(mission: Mission, facts: MissionFacts) -> list[Message]:
    """Overlaps below what was asked for, and their cause: relief, or how lines of the pattern lie."""
    cause = "relief" if mission.terrain and patterns[mission.pattern].ground else mission.pattern
    directions = (("along", facts.along, mission.overlap[0]), ("across", facts.across, mission.overlap[1]))
    return [
        warning("mission.overlap_low", direction=direction, overlap=found.low, asked=asked, cause=cause)
        for direction, found, asked in directions
        if found is not None and found.low < asked - OVERLAP_LOST
    ]
