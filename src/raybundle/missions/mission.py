"""A mission: way points in a plane coordinate system, and the photographs that they give."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.camera import MissionCamera
from raybundle.missions.vehicle import Vehicle
from raybundle.numerics.arrays import Array
from raybundle.numerics.attitude import rotation_from_gimbal

TriggerBy = Literal["distance", "interval"]
MOST = 100_000
"""Photographs of a line."""
NO_LINE = -1
"""Of a way point on the way from one line to the next."""


class Trigger(IntEnum):
    """What the camera does at a way point."""

    NONE = 0
    """goes on as before"""
    HERE = 1
    """one photograph at the way point, standing"""
    START = 2
    """a photograph here, and from here on one every `base` metres"""
    STOP = 3
    """no further photographs"""


@dataclass(frozen=True, slots=True, kw_only=True)
class WayPoints:
    """The way, point by point."""

    xyz: Array
    """(n, 3) [m]; heights in the system of those of the ground"""
    heading: Array
    """(n,) azimuth of the camera's view, or of the upper side of its image at the nadir [rad], from grid
    north; it holds to the next way point"""
    pitch: Array
    """(n,) of the gimbal [rad]: 0 to the horizon, -pi/2 to the nadir; it holds to the next way point"""
    speed: Array
    """(n,) from here to the next [m/s]"""
    trigger: Array
    """(n,) `Trigger`"""
    base: Array
    """(n,) metres in plan between photographs from a START on; NaN elsewhere"""
    line: Array
    """(n,) number of the flight line from 0, `NO_LINE` between lines"""
    flight: Array
    """(n,) number of the battery from 0"""

    def __len__(self) -> int:
        """Number of way points."""
        return len(self.xyz)

    def of_flight(self, flight: int) -> WayPoints:
        """Those of one battery."""
        return self.rows(np.flatnonzero(self.flight == flight))

    def rows(self, keep: Array) -> WayPoints:
        """Some of them."""
        return WayPoints(
            xyz=self.xyz[keep], heading=self.heading[keep], pitch=self.pitch[keep], speed=self.speed[keep],
            trigger=self.trigger[keep], base=self.base[keep], line=self.line[keep], flight=self.flight[keep],
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Exposures:
    """Photographs as they are planned, in the order of the flight."""

    xyz: Array
    """(m, 3) projection centres [m]"""
    heading: Array
    """(m,) [rad]"""
    pitch: Array
    """(m,) [rad]"""
    line: Array
    """(m,)"""
    flight: Array
    """(m,)"""
    distance: Array
    """(m,) along the viewing axis to what is photographed [m]; NaN: the ground, where it may lie"""
    roll: Array | None = None
    """(m,) about the viewing axis [rad]; None: none is planned"""

    def __len__(self) -> int:
        """Number of photographs."""
        return len(self.xyz)

    def rows(self, keep: Array) -> Exposures:
        """Some of them."""
        return Exposures(
            xyz=self.xyz[keep], heading=self.heading[keep], pitch=self.pitch[keep], line=self.line[keep],
            flight=self.flight[keep], distance=self.distance[keep],
            roll=None if self.roll is None else self.roll[keep],
        )  # fmt: skip

    @property
    def rotation(self) -> Array:
        """(m, 3, 3) from object axes to image axes, the camera's upper side up or forward."""
        roll = np.zeros(len(self.pitch)) if self.roll is None else self.roll
        return rotation_from_gimbal(np.stack([self.heading, self.pitch, roll], axis=1))


@dataclass(frozen=True, slots=True, kw_only=True)
class FlightLine:
    """What was asked of a line, as data beside its way points."""

    name: str
    group: str
    """lines of one direction, between which photographs are to overlap"""
    distance: float | None = None
    """to what is photographed along the viewing axis [m]; None: the ground"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Mission:
    """A flight as it is planned."""

    name: str
    pattern: str
    crs: str
    """plane coordinate system of the way points; "" for a local one, which no format can hold"""
    camera: MissionCamera
    vehicle: Vehicle
    take_off: tuple[float, float, float]
    """x, y and the height of the ground there [m]"""
    way_points: WayPoints
    lines: tuple[FlightLine, ...]
    outline: Array
    """(k, 2) the area, or the line of a corridor or facade [m]"""
    closed: bool = True
    """whether the outline is an area"""
    no_go: tuple[Array, ...] = ()
    gsd: float
    """asked for [m]"""
    overlap: tuple[float, float]
    """asked for along and across lines"""
    base: float
    """between photographs of a line [m]"""
    spacing: float
    """between lines [m]"""
    trigger_by: TriggerBy = "distance"
    terrain: str = ""
    """where heights of the ground come from; "": level ground at the height of the take-off"""
    settings: Mapping[str, object] = field(default_factory=dict[str, object])
    """what was asked for, as texts and numbers"""
    remarks: tuple[str, ...] = ()

    @property
    def flights(self) -> int:
        """Batteries."""
        return int(self.way_points.flight.max(initial=-1)) + 1


def exposures(mission: Mission) -> Exposures:
    """The photographs of a mission: at each HERE, and every `base` metres of plan from a START to its STOP.

    Limits: how far a vehicle strays from its way, nor how late a camera releases.
    """
    w = mission.way_points
    rows: list[Array] = []
    k = 0
    while k < len(w):
        if w.trigger[k] == Trigger.HERE:
            rows.append(_row(w, k, w.xyz[k : k + 1], np.array([k])))
        elif w.trigger[k] == Trigger.START:
            end = k + 1
            while end < len(w) and w.trigger[end] != Trigger.STOP:
                end += 1
            if end == len(w):
                raise InputError("mission.no_stop", waypoint=k + 1)
            rows.append(_along(w, k, end))
            k = end
        k += 1
    if not rows:
        raise InputError("mission.no_photographs")
    table = np.concatenate(rows)
    line = table[:, 5].astype(int)
    distance = np.array([np.nan if f.distance is None else f.distance for f in mission.lines] or [np.nan])
    return Exposures(
        xyz=table[:, :3], heading=table[:, 3], pitch=table[:, 4], line=line, flight=table[:, 6].astype(int),
        distance=distance[np.clip(line, 0, len(distance) - 1)],
    )  # fmt: skip


def _row(w: WayPoints, k: int, xyz: Array, low: Array) -> Array:
    """Rows x, y, z, heading, pitch, line, flight of photographs between way points `low` and the next."""
    n = len(xyz)
    return np.column_stack([xyz, w.heading[low], w.pitch[low], np.full(n, w.line[k]), np.full(n, w.flight[k])])


def _along(w: WayPoints, start: int, stop: int) -> Array:
    """Photographs from a START to its STOP."""
    xyz = w.xyz[start : stop + 1]
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(xyz[:, :2], axis=0), axis=1))])
    base = float(w.base[start])
    if not base > 0:
        raise InputError("mission.base_not_positive", waypoint=start + 1, base_m=base)
    count = int(np.floor(way[-1] / base + 1e-6)) + 1
    if count > MOST:
        raise InputError("mission.too_many_on_line", waypoint=start + 1, n=count, base_m=base, most=MOST)
    s = np.arange(count) * base
    s = np.minimum(s, way[-1])
    points = np.stack([np.interp(s, way, xyz[:, j]) for j in range(3)], axis=1)
    low = np.clip(np.searchsorted(way, s, side="right") - 1, 0, stop - start - 1)
    return _row(w, start, points, start + low)
