"""A mission made of a pattern: lines cut at no-go zones, put over the ground, joined, and divided among batteries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from raybundle.errors import InputError, Text, note, warning
from raybundle.missions.mission import NO_LINE, FlightLine, Mission, Trigger, TriggerBy, WayPoints
from raybundle.missions.patterns import Line, Wish, patterns
from raybundle.missions.places import places
from raybundle.missions.polygons import checked_ring, inside
from raybundle.missions.terrain import Climbing, Ground, profile
from raybundle.missions.vehicle import Vehicle
from raybundle.missions.zones import cut_lines, part_of, way_round
from raybundle.numerics.arrays import Array

STANDING_S = 1.0
"""At a way point where one photograph is taken, beside what the camera needs."""
SLACK_M = 1e-6
MOST = 50_000
"""Photographs of a mission; a day of a fast vehicle has some 20 000."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """What is to be flown, and with what."""

    name: str = "mission"
    pattern: str = "nadir"
    outline: Array
    """(n, 2) area, way or place [m]"""
    crs: str = ""
    wish: Wish
    vehicle: Vehicle = field(default_factory=Vehicle)
    speed: float | None = None
    """[m/s]; None: the greatest at which vehicle, interval and blur allow"""
    blur_px: float = 1.0
    """greatest motion during the exposure"""
    take_off: tuple[float, float] | None = None
    """x, y; None: the begin of the first line"""
    no_go: tuple[Array, ...] = ()
    ground: Ground
    terrain: str = ""
    ground_step: float = 5.0
    """between places at which the ground is looked at [m]"""
    tolerance: float = 1.0
    """of heights above ground [m]"""
    trigger_by: TriggerBy = "distance"
    settings: Mapping[str, object] = field(default_factory=dict[str, object])


@dataclass(frozen=True, slots=True, kw_only=True)
class _Leg:
    """A line, or a part of one, with heights."""

    line: Line
    number: int
    xyz: Array
    heading: Array
    pitch: Array
    raised: float
    seconds: float
    above: float
    """greatest height above ground that was asked for"""

    @property
    def ends(self) -> tuple[Array, Array]:
        return self.xyz[0], self.xyz[-1]


def plan_mission(task: Task) -> Mission:
    """The mission of a task.

    raises  InputError for an unknown pattern, an outline that is none, zones that leave nothing, an interval below what
            the camera can, a battery that does not reach
    """
    if task.pattern not in patterns:
        raise InputError("mission.unknown_pattern", pattern=str(task.pattern), known=sorted(patterns))
    pattern = patterns[task.pattern]
    outline = checked_outline(task.outline, pattern.shape)
    zones = tuple(checked_ring(z, "zone", str(k + 1)) for k, z in enumerate(task.no_go))
    base, spacing = pattern.steps(task.wish)
    remarks: list[str] = []
    lines, lost = cut_lines(pattern.lines(outline, task.wish), zones)
    if not lines or (pattern.shape == "area" and _covered(outline, zones)):
        raise InputError("mission.area_in_zones")
    if lost:
        kind = "metres" if lines[0].base else "photographs"
        remarks.append(Text.of(note("mission.zones_taken_out", kind=kind, metres=lost, n=round(lost))))
    photographs = sum(len(line.xy) if line.base is None else line.length / line.base for line in lines)
    if photographs > MOST:
        raise InputError("mission.too_many_photographs", n=round(photographs), most=MOST)
    speed = _speed(task, base, remarks)
    begin = np.array(task.take_off) if task.take_off is not None else lines[0].xy[0]
    lines = _ordered(lines, begin)
    legs = [_leg(line, n, task, speed) for n, line in enumerate(lines)]
    raised = max(leg.raised for leg in legs)
    if raised > task.tolerance:
        remarks.append(Text.of(warning("mission.ground_too_steep", speed=speed, raised=raised)))
    if task.take_off is None:
        begin = legs[0].xyz[0, :2]
    home = np.append(begin, task.ground(begin[None])[0])
    rows, used = _flights(legs, home, task, speed, zones)
    return Mission(
        name=task.name, pattern=task.pattern, crs=task.crs, camera=task.wish.camera, vehicle=task.vehicle,
        take_off=(float(home[0]), float(home[1]), float(home[2])), way_points=rows,
        lines=tuple(FlightLine(name=g.line.name, group=g.line.group, distance=g.line.distance) for g in used),
        outline=outline, closed=pattern.shape == "area" or (pattern.shape == "place" and len(outline) > 2),
        no_go=zones, gsd=task.wish.gsd, overlap=task.wish.overlap, base=base, spacing=spacing,
        trigger_by=task.trigger_by, terrain=task.terrain, settings=task.settings, remarks=tuple(remarks),
    )  # fmt: skip


def _covered(outline: Array, zones: Sequence[Array]) -> bool:
    """Whether zones leave nothing of an area."""
    if not zones:
        return False
    xyz = places(outline, 1.0, lambda xy: np.zeros(len(xy))).xyz
    return bool(np.all(np.any([inside(z, xyz[:, :2]) for z in zones], axis=0)))


def checked_outline(outline: Array, shape: str) -> Array:
    """The outline (n, 2) that a pattern needs; raises InputError for one that is none."""
    outline = np.asarray(outline, float).reshape(-1, 2)
    if shape == "area":
        return checked_ring(outline, "area")
    if shape == "line":
        keep = np.append(True, np.linalg.norm(np.diff(outline, axis=0), axis=1) > 1e-6)
        if keep.sum() < 2:
            raise InputError("mission.line_no_extent")
        return outline[keep]
    return checked_ring(outline, "object") if len(outline) > 2 else outline


def _speed(task: Task, base: float, remarks: list[str]) -> float:
    """The speed of lines [m/s]; raises InputError where one that was asked for is too great for the camera."""
    camera = task.wish.camera
    by_interval = base / camera.interval_s
    by_blur = task.blur_px * task.wish.gsd / camera.exposure_s
    if task.speed is None:
        speed = min(task.vehicle.speed, by_interval, by_blur)
        limit = {by_interval: "camera_interval", by_blur: "blur"}.get(speed)
        if limit and speed < task.vehicle.speed - 1e-9:
            remarks.append(Text.of(note("mission.speed_limited", limit=limit, speed=speed, vehicle=task.vehicle.speed)))
        return speed
    if task.speed > task.vehicle.speed:
        raise InputError(
            "mission.speed_of_vehicle", speed_mps=task.speed, most_mps=task.vehicle.speed, vehicle=task.vehicle.name
        )
    if task.speed > by_interval * (1 + 1e-9):
        raise InputError(
            "mission.camera_interval",
            base_m=base,
            speed_mps=task.speed,
            needed_s=base / task.speed,
            camera=camera.name,
            interval_s=camera.interval_s,
            most_mps=by_interval,
        )
    if task.speed > by_blur * (1 + 1e-9):
        blur = task.speed * camera.exposure_s / task.wish.gsd
        blurred = warning(
            "mission.blur", speed=task.speed, exposure=round(1 / camera.exposure_s), blur=blur, limit=task.blur_px,
            slower=by_blur,
        )  # fmt: skip
        remarks.append(Text.of(blurred))
    return task.speed


def _ordered(lines: Sequence[Line], begin: Array) -> list[Line]:
    """Each group of lines from the end that lies nearest to where the one before it ends, and flown from there on."""
    groups: dict[str, list[Line]] = {}
    for line in lines:
        groups.setdefault(line.group, []).append(line)
    result: list[Line] = []
    at = begin
    for group in groups.values():
        if group[0].base is None:
            result += group
            continue
        ways = [group, group[::-1]]
        if all(np.ptp(line.heading) == 0 and line.pitch[0] == -np.pi / 2 for line in group):
            ways += [[_flown_back(line) for line in way] for way in ways]
        best = min(ways, key=lambda way: float(np.linalg.norm(way[0].xy[0] - at)))
        result += best
        at = best[-1].xy[-1]
    return result


def _flown_back(line: Line) -> Line:
    """A nadir line flown the other way, the upper side of the image ahead again."""
    turned = line.turned()
    d = turned.xy[-1] - turned.xy[0]
    heading = np.full(len(turned.xy), np.arctan2(d[0], d[1]) % (2 * np.pi))
    return Line(
        name=line.name, group=line.group, xy=turned.xy, above=turned.above, heading=heading, pitch=turned.pitch,
        base=line.base, foot=line.foot, distance=line.distance,
    )  # fmt: skip


def _leg(line: Line, number: int, task: Task, speed: float) -> _Leg:
    above = float(line.above.max())
    if line.foot is not None or line.base is None:
        foot = np.array([line.foot]) if line.foot is not None else line.xy[:1]
        z = task.ground(foot)[0] + line.above
        xyz = np.column_stack([line.xy, z])
        return _Leg(
            line=line, number=number, xyz=xyz, heading=line.heading, pitch=line.pitch, raised=0.0, above=above,
            seconds=_seconds(xyz, line, task, speed),
        )  # fmt: skip
    limits = Climbing(
        up=task.vehicle.climb / speed, down=task.vehicle.descent / speed, tolerance=task.tolerance / 2,
        step=task.ground_step,
    )  # fmt: skip
    way = profile(line.xy, line.above, task.ground, limits)
    low = np.minimum(np.floor(way.part + 1e-9).astype(int), len(line.xy) - 1)
    return _Leg(
        line=line, number=number, xyz=way.xyz, heading=line.heading[low], pitch=line.pitch[low], raised=way.raised,
        above=above, seconds=_seconds(way.xyz, line, task, speed),
    )  # fmt: skip


def _seconds(xyz: Array, line: Line | None, task: Task, speed: float) -> float:
    """Time along a way; one that photographs at each point stands there."""
    plan = np.linalg.norm(np.diff(xyz[:, :2], axis=0), axis=1)
    rise = np.diff(xyz[:, 2])
    vertical = np.where(rise > 0, rise / task.vehicle.climb, -rise / task.vehicle.descent)
    time = float(np.maximum(plan / speed, vertical).sum()) + speed / task.vehicle.acceleration
    if line is not None and line.base is None:
        brake = np.minimum(speed / task.vehicle.acceleration, 2 * np.sqrt(plan / task.vehicle.acceleration))
        time += float(brake.sum()) + len(xyz) * max(STANDING_S, task.wish.camera.interval_s)
    return time


def _joined(a: Array, b: Array, above: float, task: Task, zones: Sequence[Array]) -> Array:
    """The way (n, 3) between two ends, without them: round zones, and over the ground as high as the lines."""
    plan = way_round(a[:2], b[:2], zones)
    length = np.linalg.norm(np.diff(plan, axis=0), axis=1)
    if length.sum() < SLACK_M:
        return np.zeros((0, 3))
    steep = Climbing(
        up=task.vehicle.climb / task.vehicle.speed, down=task.vehicle.descent / task.vehicle.speed,
        tolerance=max(task.tolerance, 2.0), step=task.ground_step,
    )  # fmt: skip
    way = profile(plan, np.full(len(plan), above), task.ground, steep).xyz
    return way[1:-1] if len(way) > 2 else np.zeros((0, 3))


def _ferry(home: Array, end: Array, above: float, task: Task, zones: Sequence[Array]) -> Array:
    """From above the take-off (n, 3) to the begin of a line, level, high enough over all ground between."""
    plan = way_round(home[:2], end[:2], zones)
    if np.linalg.norm(np.diff(plan, axis=0), axis=1).sum() < SLACK_M:
        return np.zeros((0, 3))
    flat = profile(plan, np.full(len(plan), above), task.ground, Climbing(up=1e3, down=1e3, step=task.ground_step))
    z = max(float(flat.xyz[:, 2].max()), float(end[2]))
    return np.column_stack([plan, np.full(len(plan), z)])


def _flights(
    legs: Sequence[_Leg], home: Array, task: Task, speed: float, zones: Sequence[Array]
) -> tuple[WayPoints, list[_Leg]]:
    """Way points of all batteries, and the legs as they were cut to fit into them."""
    waiting = list(legs)
    rows: list[WayPoints] = []
    used: list[_Leg] = []
    flight, spent, at = 0, 0.0, None
    usable = task.vehicle.usable_s
    while waiting:
        leg = waiting.pop(0)
        start, end = leg.ends
        out = _ferry(home, start, leg.above, task, zones)
        back = _ferry(home, end, leg.above, task, zones)[::-1]
        back_s = _up_and_along(back, home, task)
        if at is None:
            into, into_s = out, _up_and_along(out, home, task)
        else:
            into = _joined(at, start, leg.above, task, zones)
            into_s = _seconds(np.vstack([at, into, start]), None, task, task.vehicle.speed)
        if spent + into_s + leg.seconds + back_s > usable:
            if at is not None:
                rows.append(_plain(_home_way(at, home, used[-1].above, task, zones), used[-1], flight, task))
                flight, spent, at = flight + 1, 0.0, None
                waiting.insert(0, leg)
                continue
            parts = _halves(leg, task, speed)
            if parts is None:
                raise InputError(
                    "mission.battery",
                    flight_line=leg.line.name,
                    needed_min=(into_s + back_s) / 60,
                    usable_min=usable / 60,
                    minutes_min=task.vehicle.minutes,
                )
            waiting[:0] = parts
            continue
        number = len(used)
        rows.append(_plain(into, leg, flight, task))
        rows.append(_on_line(leg, number, flight, speed, task))
        used.append(leg)
        spent, at = spent + into_s + leg.seconds, end
    rows.append(_plain(_home_way(at, home, used[-1].above, task, zones), used[-1], flight, task))
    return _stacked(rows), used


def _home_way(at: Array | None, home: Array, above: float, task: Task, zones: Sequence[Array]) -> Array:
    assert at is not None
    return _ferry(home, at, above, task, zones)[::-1]


def _up_and_along(way: Array, home: Array, task: Task) -> float:
    """Time from the take-off up and along a ferry, or back; climbing counts, which is the slower of the two."""
    if not len(way):
        return 0.0
    slow = min(task.vehicle.climb, task.vehicle.descent)
    return float(way[0, 2] - home[2]) / slow + _seconds(way, None, task, task.vehicle.speed)


def _halves(leg: _Leg, task: Task, speed: float) -> list[_Leg] | None:
    """A leg in two, at a photograph; None where it cannot be cut."""
    line = leg.line
    if line.base is None:
        if len(line.xy) < 4:
            return None
        m = len(line.xy) // 2
        parts = [_slice(line, slice(0, m), " a"), _slice(line, slice(m, None), " b")]
    else:
        count = round(line.length / line.base)
        if count < 2:
            return None
        cut = count // 2 * line.base
        parts = [part_of(line, 0.0, cut, " a"), part_of(line, cut, line.length, " b")]
    return [_leg(p, leg.number, task, speed) for p in parts]


def _slice(line: Line, keep: slice, suffix: str) -> Line:
    return Line(
        name=line.name + suffix, group=line.group, xy=line.xy[keep], above=line.above[keep],
        heading=line.heading[keep], pitch=line.pitch[keep], base=line.base, foot=line.foot, distance=line.distance,
    )  # fmt: skip


def _plain(xyz: Array, leg: _Leg, flight: int, task: Task) -> WayPoints:
    """Way points on which nothing is photographed."""
    n = len(xyz)
    return WayPoints(
        xyz=xyz.reshape(-1, 3), heading=np.full(n, leg.heading[0]), pitch=np.full(n, leg.pitch[0]),
        speed=np.full(n, task.vehicle.speed), trigger=np.full(n, int(Trigger.NONE)), base=np.full(n, np.nan),
        line=np.full(n, NO_LINE), flight=np.full(n, flight),
    )  # fmt: skip


def _on_line(leg: _Leg, number: int, flight: int, speed: float, task: Task) -> WayPoints:
    n = len(leg.xyz)
    trigger, base = np.full(n, int(Trigger.NONE)), np.full(n, np.nan)
    if leg.line.base is None:
        trigger[:] = Trigger.HERE
    else:
        trigger[0], trigger[-1], base[0] = Trigger.START, Trigger.STOP, leg.line.base
    speeds = np.full(n, speed)
    speeds[-1] = task.vehicle.speed
    return WayPoints(
        xyz=leg.xyz, heading=leg.heading, pitch=leg.pitch, speed=speeds, trigger=trigger, base=base,
        line=np.full(n, number), flight=np.full(n, flight),
    )  # fmt: skip


def _stacked(rows: Sequence[WayPoints]) -> WayPoints:
    names = ("xyz", "heading", "pitch", "speed", "trigger", "base", "line", "flight")
    return WayPoints(**{n: np.concatenate([getattr(r, n) for r in rows if len(r)]) for n in names})
