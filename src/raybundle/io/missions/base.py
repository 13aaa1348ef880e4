"""What a format of flight plans is, and the register of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.missions.mission import Mission
from raybundle.missions.route import Route
from raybundle.missions.terrain import Ground
from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class MissionFormat:
    """One format: a file a battery."""

    name: str
    about: str
    suffix: str
    write: Callable[[Route, Path], None]
    read: Callable[[Path], Route]
    """raises InputError with the place for what is none"""
    most: int | None = None
    """way points that programs take; None: no limit is known"""
    heading_step_deg: float = 0.0
    """to which headings are rounded; 0: not at all"""


mission_formats: dict[str, MissionFormat] = {}


def register(entry: MissionFormat) -> MissionFormat:
    """Make a format known by its name."""
    mission_formats[entry.name] = entry
    return entry


def routes_of(mission: Mission, ground: Ground | None = None) -> tuple[Route, ...]:
    """The ways of all batteries; headings turned from grid north to true north.

    Heights are differences to that of the take-off, so that no geoid is needed.
    raises  InputError for a mission in local coordinates
    """
    if not mission.crs:
        raise InputError("mission.no_crs")
    return tuple(_route(mission, flight, ground) for flight in range(mission.flights))


def _route(mission: Mission, flight: int, ground: Ground | None) -> Route:
    w = mission.way_points.of_flight(flight)
    home = np.array([mission.take_off])
    plan = np.vstack([home[:, :2], w.xyz[:, :2]])
    frame = local_frame(mission.crs, home[0])
    xyz = np.column_stack([plan, np.full(len(plan), home[0, 2])])
    geographic = frame.wgs84_from_local(frame.local_from_crs(xyz))
    turn = frame.scale_and_convergence(xyz[1:])[:, 1] if len(w) else np.zeros(0)
    many = mission.flights > 1
    return Route(
        name=f"{mission.name} {flight + 1}" if many else mission.name,
        home=(float(geographic[0, 1]), float(geographic[0, 0]), mission.take_off[2]),
        latitude_deg=geographic[1:, 1], longitude_deg=geographic[1:, 0], height=w.xyz[:, 2] - mission.take_off[2],
        heading_deg=turned(np.degrees(w.heading + turn)), pitch_deg=np.degrees(w.pitch), speed=w.speed,
        trigger=w.trigger, base=w.base, trigger_by=mission.trigger_by, codes=mission.vehicle.codes,
        above_ground=None if ground is None else w.xyz[:, 2] - ground(w.xyz[:, :2]), vehicle=mission.vehicle.name,
    )  # fmt: skip


def turned(degrees: Array) -> Array:
    """Azimuths from 0 up to 360, those that rounding put next to 360 as 0."""
    a = np.asarray(degrees, float) % 360.0
    return np.where(np.abs(a - 360.0) < 1e-9, 0.0, a)
