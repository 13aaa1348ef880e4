"""A route as a list of MAVLink mission items, which two formats write down differently.

Commands and their parameters: mavlink.io, MAV_CMD (common message set): 16 way point (parameter 1: seconds to stand, 4:
yaw), 20 return to launch, 22 take-off, 178 speed, 205 mount (1: pitch, 7: mode 2), 206 photographs by distance (1:
metres, 0 stops; 3: one at once), 2000 photographs by time (2: seconds, 3: how many, 0 for ever), 2001 stops them.  A
command that is no place holds from the way point before it.  Frame 3: height above the take-off; frame 2: no place.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.mission import Trigger
from raybundle.missions.route import Route

WAY_POINT, RETURN, TAKE_OFF, SPEED, MOUNT, BY_DISTANCE, BY_TIME, STOP_TIME = 16, 20, 22, 178, 205, 206, 2000, 2001
RELATIVE, NO_PLACE, ABSOLUTE = 3, 2, 0
TARGETING = 2.0
"""MAV_MOUNT_MODE_MAVLINK_TARGETING."""
STANDING_S = 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """One item: a command, its seven parameters, and the frame of its place."""

    command: int
    frame: int
    parameters: tuple[float, ...]


def items_of(route: Route) -> list[Item]:
    """Take-off, way points each followed by what begins there, return."""
    items = [_place(TAKE_OFF, route, 0, stand=0.0)]
    speed = pitch = math.nan
    for k in range(len(route)):
        here = route.trigger[k] == Trigger.HERE
        items.append(_place(WAY_POINT, route, k, stand=STANDING_S if here else 0.0))
        if route.speed[k] != speed:
            speed = float(route.speed[k])
            items.append(_command(SPEED, 1, speed, -1))
        if route.pitch_deg[k] != pitch:
            pitch = float(route.pitch_deg[k])
            items.append(_command(MOUNT, pitch, 0, 0, 0, 0, 0, TARGETING))
        if here:
            items.append(_command(BY_TIME, 0, 0, 1))
        elif route.trigger[k] == Trigger.START:
            base = float(route.base[k])
            by_time = route.trigger_by == "interval"
            items.append(_command(BY_TIME, 0, base / speed, 0) if by_time else _command(BY_DISTANCE, base, 0, 1))
        elif route.trigger[k] == Trigger.STOP:
            items.append(_command(STOP_TIME, 0) if route.trigger_by == "interval" else _command(BY_DISTANCE, 0, 0, 0))
    items.append(Item(command=RETURN, frame=NO_PLACE, parameters=(0.0,) * 7))
    return items


def _command(command: int, *parameters: float) -> Item:
    return Item(command=command, frame=NO_PLACE, parameters=(*parameters, *(0.0,) * (7 - len(parameters))))


def _place(command: int, route: Route, k: int, *, stand: float) -> Item:
    at = float(route.latitude_deg[k]), float(route.longitude_deg[k]), float(route.height[k])
    if command == TAKE_OFF:
        at = (*route.home[:2], at[2])
    return Item(command=command, frame=RELATIVE, parameters=(stand, 0.0, 0.0, float(route.heading_deg[k]), *at))


@dataclass(slots=True)
class _Found:
    """What was read so far."""

    rows: list[list[float]] = field(default_factory=list[list[float]])
    speed: float = math.nan
    pitch: float = math.nan
    by_time: bool = False


def route_of(items: Sequence[Item], home: tuple[float, float, float], name: str, file: str) -> Route:
    """The route that a list of items is; commands that have nothing to do with photographs are passed over.

    raises  InputError for an item in another frame than heights above the take-off, or one that is no number
    """
    found = _Found()
    for number, item in enumerate(items):
        p = item.parameters
        if item.command in {WAY_POINT, TAKE_OFF}:
            if item.frame not in {RELATIVE, 6}:
                raise InputError(
                    "mission.height_reference",
                    reference=f"item {number + 1}, frame {item.frame}",
                    needed="frame 3",
                    file=file,
                )
            if item.command == WAY_POINT:
                row = [*p[4:7], p[3], found.pitch, found.speed, float(Trigger.NONE), math.nan]
                found.rows.append(row)
        elif found.rows:
            _apply(found, item)
    if not found.rows:
        raise InputError("mission.no_way_point", file=file)
    t = np.array(found.rows)
    return Route(
        name=name, home=home, latitude_deg=t[:, 0], longitude_deg=t[:, 1], height=t[:, 2], heading_deg=t[:, 3] % 360.0,
        pitch_deg=t[:, 4], speed=t[:, 5], trigger=t[:, 6].astype(int), base=t[:, 7],
        trigger_by="interval" if found.by_time else "distance",
    )  # fmt: skip


def _apply(found: _Found, item: Item) -> None:
    """Let a command hold from the last way point on."""
    row, p = found.rows[-1], item.parameters
    if item.command == SPEED:
        found.speed = row[5] = p[1]
    elif item.command == MOUNT:
        found.pitch = row[4] = p[0]
    elif item.command == BY_DISTANCE:
        row[6], row[7] = (Trigger.START, p[0]) if p[0] > 0 else (Trigger.STOP, math.nan)
    elif item.command == BY_TIME and p[2] == 1:
        row[6] = Trigger.HERE
    elif item.command == BY_TIME:
        row[6], row[7], found.by_time = Trigger.START, p[1] * found.speed, True
    elif item.command == STOP_TIME:
        row[6] = Trigger.STOP
