"""Coordinate systems as texts name them, and as messages name them."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING

from raybundle.errors import InputError
from raybundle.io.reading.words import quoted, whole_of

if TYPE_CHECKING:
    from pyproj import CRS

LONGEST_CRS = 100_000
"""Characters; the longest WKT with its operations has some 20 000."""
_UTM = re.compile(r"^(?:EPSG\s+)?WGS\s*_?84\s*[/,]?\s*UTM\s*(?:zone)?\s*([0-9]{1,2})\s*([NS])$", re.IGNORECASE)
LONGEST_NAME = 60
"""Characters of a system in a line of text."""
SEMI_MAJOR, SAME_AXIS = 6378137.0, 1.0
"""Of GRS 80 and WGS 84 [m], and by how much that of an ellipsoid at the Earth's centre may differ."""
ELLIPSOID = "+ellipsoid"
_CODE_BEHIND = re.compile(r"(?<=[\w.])\s*\+\d+$")
"""The code of a system of heights, which PROJ passes over behind a PROJ string"""
"""Behind the name of a plan system: heights count from its ellipsoid."""


@lru_cache(maxsize=64)
def parse_crs(text: str) -> CRS:
    """The coordinate system that a text names: EPSG:code, EPSG:code+code, PROJ string, WKT, WGS84 UTM 11N.

    With +ellipsoid behind it, as EPSG:32633+ellipsoid, the system in three dimensions: heights above its ellipsoid, in
    its unit of plan.
    raises  InputError where it names none, or one without a place on the earth
    """
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    text = text.strip()
    if text.lower().endswith(ELLIPSOID):
        return _above_ellipsoid(text[: -len(ELLIPSOID)])
    if len(text) > LONGEST_CRS or not text.replace("\n", " ").replace("\r", " ").replace("\t", " ").isprintable():
        raise InputError("crs.unknown", text=quoted(text))
    if text.startswith("+") and (heights := _CODE_BEHIND.search(text)):
        raise InputError("crs.heights_of_proj_string", text=quoted(heights[0]), ellipsoid=ELLIPSOID)
    if utm := _UTM.match(text):
        zone = whole_of(utm[1]) or 0
        if not 1 <= zone <= 60:
            raise InputError("crs.utm_zone", zone=zone)
        text = _utm_code(zone, north=utm[2].upper() == "N")
    try:
        system = CRS.from_user_input(text)
    except CRSError:
        raise InputError("crs.unknown", text=quoted(text)) from None
    if system.geodetic_crs is None or (system.is_vertical and not system.is_compound):
        raise InputError("crs.not_on_earth", text=quoted(text))
    return system


def _utm_code(zone: int, *, north: bool) -> str:
    return f"EPSG:{(32600 if north else 32700) + zone}"


def utm_at(lon: float, lat: float) -> str | None:
    """EPSG code of the zone of UTM at a place [degrees, WGS 84]; None beyond the latitudes of UTM."""
    if not -80 <= lat <= 84:
        return None
    return _utm_code(int((lon + 180) // 6) % 60 + 1, north=lat >= 0)


def _above_ellipsoid(plan: str) -> CRS:
    system = parse_crs(plan)
    if system.is_compound or len(system.axis_info) == 3:
        raise InputError("crs.heights_twice", system=plan, ellipsoid=ELLIPSOID)
    return system.to_3d()


def is_plan(crs: str) -> bool:
    """Whether a system shows nothing of heights."""
    system = parse_crs(crs)
    return len(system.axis_info) == 2 and not system.is_compound


def plan_of(crs: str) -> CRS:
    """The plan of a system of plan and heights, or in three dimensions; a geocentric one as it is."""
    system = parse_crs(crs)
    if system.is_compound:
        system = system.sub_crs_list[0]
    return system.to_2d() if len(system.axis_info) == 3 and not system.is_geocentric else system


@lru_cache(maxsize=64)
def code_of(crs: str) -> str:
    """EPSG:code of a system, or of its plan where it states nothing else; empty where it has none."""
    system = parse_crs(crs)
    if len(system.axis_info) == 3 and not (system.is_compound or system.is_geocentric):
        system = system.to_2d()
    code = system.to_authority(min_confidence=70)
    return ":".join(code) if code else ""


@lru_cache(maxsize=64)
def system_name(crs: str) -> str:
    """How a system is called in a line: as it was given where that is short and no PROJ string, else its code or name.

    Of a PROJ string that has neither, its projection: "UTM zone 11N (PROJ string)".
    """
    proj = crs.lstrip().startswith("+")
    if not proj and len(crs) <= LONGEST_NAME and crs.isprintable():
        return crs
    system = parse_crs(crs)
    if code := code_of(crs):
        return code
    if system.name not in ("unknown", ""):
        return system.name[:LONGEST_NAME]
    plan = system.sub_crs_list[0] if system.is_compound else system
    while plan.is_bound and plan.source_crs is not None:
        plan = plan.source_crs
    how = plan.coordinate_operation
    name = "geographic" if how is None else how.name if how.name not in ("unknown", "") else how.method_name
    grid = geoid_file(crs)
    heights = f", heights by {grid.replace(chr(92), '/').rpartition('/')[2]}" if grid else ""
    return f"{name} ({'PROJ string' if proj else 'WKT'}{heights})"


def height_name(crs: str) -> str:
    """What the heights of a system with heights of its own are called."""
    system = parse_crs(crs)
    name = system.sub_crs_list[1].name if system.is_compound else ""
    return name if name not in ("unknown", "") else f"the height system of {system_name(crs)}"


def geoid_file(crs: str) -> str:
    """The file of a geoid that a PROJ string or WKT names itself; empty where it names none."""
    found = re.search(r"geoidgrids=([^\s,\"\]]+)", crs)
    return found[1] if found else ""


@lru_cache(maxsize=64)
def of_older_datum(crs: str) -> bool:
    """Whether the ellipsoid of a system is none of the Earth's centre (Bessel, Airy, Clarke, Krassovsky ...).

    Heights of the geoid are reported above GRS 80 or WGS 84, whatever datum a survey's plan has: above an older
    ellipsoid, which fits the geoid of its country, they would be others by tens of metres.
    """
    base = parse_crs(crs).geodetic_crs
    assert base is not None
    assert base.ellipsoid is not None
    return abs(base.ellipsoid.semi_major_metre - SEMI_MAJOR) > SAME_AXIS
