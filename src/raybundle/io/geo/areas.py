"""Coordinates against the area that their coordinate system is used in."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from raybundle.errors import InputError, Text, note
from raybundle.io.geo.parsed_names import parsed_system
from raybundle.io.geo.parsed_systems import plan_of, system_name
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.length_units import UNITS

if TYPE_CHECKING:
    from pyproj import Transformer

BEYOND_DEG = 1.0
"""How far beyond its area of use a grid is still taken: zones of UTM overlap by 40 km, half a degree at the equator and
nearly one at 60 degrees of latitude.  Coordinates of a site that begin near 0 are farther off: the false easting of a
zone of 6 degrees puts them 1.5 degrees beyond its edge, those of smaller zones and of state grids farther."""
FAR = 3.0
"""Distance beyond the area, in extents of it, at which nobody uses a grid: the whole of Norway in one zone has 2.2."""
HALF_TURN, QUARTER_TURN = 180.0, 90.0


def check_area(crs: str, xy: Array, file: Path, *, named: bool = False, lines: Index | None = None) -> tuple[str, ...]:
    """Remark on places (n, 2) that lie beyond the area of use of their system: a grid may be used farther out.

    named   whether the user names the system, and not the file
    lines   (n,) of the file
    raises  InputError for longitudes and latitudes that do not exist, for degrees in a grid, for places beyond the area
            where the other order of the two fits (in a grid: beyond by more than the extent of the area), for a grid
            beyond by FAR extents, and for all beyond that of a system that the user names
    """
    known = np.flatnonzero(np.isfinite(xy).all(axis=1))
    if not len(known) or plan_of(crs).is_geocentric:
        return ()
    line = None if lines is None or not len(lines) else lines[known]
    places = xy[known]
    _check_degrees(crs, places, file, line)
    x, y = np.median(places, axis=0).tolist()
    here = _beside(crs, x, y)
    if here.off <= BEYOND_DEG:
        return ()
    name = system_name(crs)
    exchanged = _beside(crs, y, x).off <= BEYOND_DEG
    if named:
        raise _outside(crs, (x, y), here, "named_exchanged" if exchanged else "named").at(file)
    geographic = plan_of(crs).is_geographic
    degrees = abs(x) <= HALF_TURN and abs(y) <= HALF_TURN and not geographic
    far = here.share > FAR or not math.isfinite(here.off)
    if (exchanged and (geographic or here.share > 1)) or degrees or far:
        feet = not exchanged and _beside(crs, UNITS["feet"] * x, UNITS["feet"] * y).off <= BEYOND_DEG
        hint = "degrees" if degrees else "exchanged" if exchanged else "feet" if feet else "system"
        raise _outside(crs, (x, y), here, hint).at(file, line=None if line is None else int(line[0]))
    outside = note(
        "crs.outside_use", table=file.name, x=x, y=y, system=name, longitude_deg=here.longitude,
        latitude_deg=here.latitude, exchanged=exchanged,
    )  # fmt: skip
    return (Text.of(outside),)


def _outside(crs: str, xy: tuple[float, float], here: _Beside, hint: str) -> InputError:
    """The error of a place far outside the area of use; `hint` chooses what to do."""
    west, south, east, north = _area(crs) or (-HALF_TURN, -QUARTER_TURN, HALF_TURN, QUARTER_TURN)
    on_earth = math.isfinite(here.off)
    return InputError(
        "crs.outside_area", x=xy[0], y=xy[1], system=system_name(crs), on_earth=on_earth,
        longitude_deg=here.longitude if on_earth else None, latitude_deg=here.latitude if on_earth else None,
        longitudes_deg=[west, east], latitudes_deg=[south, north], hint=hint,
    )  # fmt: skip


def _check_degrees(crs: str, places: Array, file: Path, lines: Index | None) -> None:
    """Raise InputError where longitude or latitude of a geographic system is beyond what a circle has."""
    system = plan_of(crs)
    if not system.is_geographic:
        return
    turn = math.pi / system.axis_info[0].unit_conversion_factor
    for k, (limit, name) in enumerate(((HALF_TURN, "longitude"), (QUARTER_TURN, "latitude"))):
        bad = np.flatnonzero(np.abs(places[:, k]) > limit * turn / HALF_TURN * (1 + 1e-12))
        if not len(bad):
            continue
        x, y = places[bad[0]]
        swapped = abs(x) <= turn / 2 and abs(y) <= turn
        raise InputError(
            "crs.beyond_circle", x=x, y=y, system=system_name(crs), quantity=name, limit=limit * turn / HALF_TURN,
            swapped=swapped, file=file, line=None if lines is None else int(lines[bad[0]]),
        )  # fmt: skip


@dataclass(frozen=True, slots=True)
class _Beside:
    """A place against the area of use of its system."""

    longitude: float
    latitude: float
    off: float
    """how far beyond [degrees]; infinite where it is no place on the earth"""
    share: float
    """the same, of the extent of the area"""


def _beside(crs: str, x: float, y: float) -> _Beside:
    longitude, latitude = _geographic(crs).transform(x, y)
    if not (math.isfinite(longitude) and math.isfinite(latitude)):
        return _Beside(longitude, latitude, math.inf, math.inf)
    if (area := _area(crs)) is None:
        return _Beside(longitude, latitude, 0.0, 0.0)
    west, south, east, north = area
    east += 360 if east < west else 0
    aside = min(max(west - at, at - east) for at in (longitude - 360, longitude, longitude + 360))
    along = max(south - latitude, latitude - north)
    share = max(aside / max(east - west, BEYOND_DEG), along / max(north - south, BEYOND_DEG))
    return _Beside(longitude, latitude, max(aside, along), share)


@lru_cache(maxsize=64)
def _area(crs: str) -> tuple[float, float, float, float] | None:
    """West, south, east, north of the plan of a system; None where it states none, as a PROJ string of its own."""
    area = parsed_system(crs).area_of_use or plan_of(crs).area_of_use
    return None if area is None else area.bounds


@lru_cache(maxsize=64)
def _geographic(crs: str) -> Transformer:
    from pyproj import Transformer

    return Transformer.from_crs(plan_of(crs), "EPSG:4326", always_xy=True)
