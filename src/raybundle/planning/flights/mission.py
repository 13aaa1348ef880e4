"""What the photographs of a mission will determine: the forecast of a flight, for positions and ground as planned."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.mission import Exposures, Mission, exposures
from raybundle.missions.patterns import patterns
from raybundle.missions.terrain import Ground
from raybundle.missions.views import ground_points
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.flights.aerial import NO_RTK, Precision, is_rtk, open_in, precision
from raybundle.planning.flights.aerial_block import Aerial
from raybundle.planning.flights.mission_mends import Mend, mission_mends
from raybundle.planning.flights.uav_networks import FREE

MOST = 150
"""Photographs in the middle of a mission that stand for all: their block takes seconds, and is the weaker one"""
RASTER = (5, 6)
"""Rays of a photograph, rows and columns, that meet the ground in tie points; of neighbours one in a cell is kept"""
FILLED, FINEST = 0.95, 30
"""Share of height and width over which they are spread; the most along either: strips of 7 % and less have fewer than
two, where photographs are hardly joined"""
LEAST_RAYS = 3
"""Of the points that are judged: those at the edge of a block with two are as bad in every plan"""
UNEVEN = (0.5, 1.5)
"""Standard deviations of height [m] and attitude [deg] of a real flight about its plan"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """With what a mission is forecast."""

    station_sigma: tuple[float, float, float] = (0.02, 0.02, 0.03)
    """Of positions by RTK [m]"""
    lever_arm: bool = False
    """Whether the lever arm of the antenna is free"""
    image_sigma_px: float = 0.3
    seed: int = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class MissionForecast:
    """What a mission determines without control, its camera calibrated with it."""

    rtk: Precision
    """With the positions that were asked for"""
    without_rtk: Precision | None
    """With positions beside whose errors a lever arm is of no account: it is held; None: those asked for are no better
    than a plain receiver's"""
    lost_even: tuple[str, ...]
    """What these positions leave open where the mission is flown exactly as planned, so that no accident helps"""
    mends: tuple[Mend, ...]
    """What would determine it"""
    asked: Asked
    photographs: int
    """Of the mission; `rtk.photographs` of them were taken"""
    pixel_mm: float

    @property
    def thinned(self) -> bool:
        """Whether a part stands for all."""
        return self.rtk.photographs < self.photographs

    @property
    def lost(self) -> tuple[str, ...]:
        """What is not determinable by design."""
        return tuple(dict.fromkeys((*self.rtk.lost, *self.lost_even)))


def mission_forecast(mission: Mission, ground: Ground, asked: Asked | None = None) -> MissionForecast:
    """The forecast of a mission: c, x0, y0, K1-K3, P1, P2 free, no control.

    ground  heights as far as they are known, NaN elsewhere
    raises  InputError for an orbit, whose object is not known; NotSolvable where photographs see too little in common
    Limits: what wind, trees and ground without texture take.
    """
    asked = asked or Asked()
    if patterns[mission.pattern].shape == "place":
        raise InputError("plan.mission_pattern", pattern=str(mission.pattern))
    every = exposures(mission)
    chosen = _middle(every.xyz)
    part = every.rows(chosen)
    plan = _aerial(mission, part, ground, asked)
    uneven = _uneven(plan, asked.seed)
    plain = replace(uneven, station_sigma=NO_RTK, lever_arm=False)
    lost, rtk = open_in(plan), precision(uneven, LEAST_RAYS)
    accident = {symbol: s for symbol, s in rtk.std.items() if symbol not in rtk.lost}
    return MissionForecast(
        rtk=rtk,
        without_rtk=precision(plain, LEAST_RAYS) if is_rtk(asked.station_sigma) else None,
        lost_even=lost, asked=asked, photographs=len(every), pixel_mm=mission.camera.pixel_mm,
        mends=mission_mends(
            plan, part, mission.camera, ground, patterns[mission.pattern], lost, accident,
            lambda changed: _uneven(changed, asked.seed),
        ),
    )  # fmt: skip


def _middle(xyz: Array) -> Index:
    """Rows of at most `MOST` photographs, those nearest to the middle one in the larger of two coordinates."""
    away = np.abs(xyz[:, :2] - np.median(xyz[:, :2], axis=0)).max(axis=1)
    return np.sort(np.argsort(away, kind="stable")[:MOST])


def _aerial(mission: Mission, part: Exposures, ground: Ground, asked: Asked) -> Aerial:
    middle = part.xyz.mean(axis=0)
    camera = replace(mission.camera.as_block_camera(), estimate=FREE)
    return Aerial(
        camera=camera, centre=part.xyz - middle, rotation=part.rotation,
        ground=_tie_points(mission, part, ground) - middle, image_sigma_px=asked.image_sigma_px,
        station_sigma=asked.station_sigma, lever_arm=asked.lever_arm,
        read_out_s=mission.camera.read_out_s or 0.0, velocity=_velocity(mission, part), name=mission.name,
        about=f"mission {mission.name}, planned", source="raybundle plan mission",
    )  # fmt: skip


def _raster(mission: Mission) -> tuple[int, int]:
    """Rows and columns of rays: so many that two lie in the strip that neighbours of either kind have in common."""
    along, across = mission.overlap
    common = (along, across) if patterns[mission.pattern].ground else (across, along)  # of height and width
    return (_rays(RASTER[0], common[0]), _rays(RASTER[1], common[1]))


def _rays(usual: int, common: float) -> int:
    """The second of n rays lies (1 - f) / 2 + 1.5 f / n of a side inside the edge, f the share that they fill."""
    room = common - (1 - FILLED) / 2
    return max(usual, min(FINEST, math.ceil(1.5 * FILLED / room))) if room > 0 else FINEST


def _tie_points(mission: Mission, part: Exposures, ground: Ground) -> Array:
    """(p, 3) where rays of the photographs meet what is photographed, one in each cell of their mean distance."""
    met = ground_points(mission.camera, part, ground, _raster(mission), (FILLED, FILLED))
    step = np.linalg.norm(np.diff(met, axis=2), axis=3)
    cell = float(np.nanmedian(step))
    xyz = met.reshape(-1, 3)
    xyz = xyz[np.isfinite(xyz).all(axis=1)]
    _, first = np.unique(np.floor(xyz / cell), axis=0, return_index=True)
    return xyz[np.sort(first)]


def _velocity(mission: Mission, part: Exposures) -> Array:
    """(m, 3) from the photographs before and after on the same line [m/s]; zero where there is none."""
    speed = mission.way_points.speed[np.isfinite(mission.way_points.base)]
    found = np.zeros((len(part), 3))
    for line in np.unique(part.line):
        mine = np.flatnonzero(part.line == line)
        if len(mine) > 1 and len(speed):
            way = np.gradient(part.xyz[mine], axis=0)
            length = np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-9)
            found[mine] = way / length * float(np.median(speed))
    return found


def _uneven(plan: Aerial, seed: int) -> Aerial:
    """The plan as it is really flown."""
    rng = np.random.default_rng(seed)
    n = len(plan.centre)
    up = np.column_stack([np.zeros((n, 2)), rng.normal(0, UNEVEN[0], n)])
    turn = np.radians(rng.normal(0, UNEVEN[1], (n, 3)))
    return replace(plan, centre=plan.centre + up, rotation=rotation_from_vector(turn) @ plan.rotation)
