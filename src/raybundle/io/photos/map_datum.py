"""Datum that a photograph names for its position (GPSMapDatum), and the way from there to WGS 84."""

from __future__ import annotations

import math
import re
from functools import lru_cache

from raybundle.io.geo.parsed_systems import of_older_datum

_WGS84 = re.compile(r"(WORLDGEODETICSYSTEM|WGS)(19)?84.*|UNKNOWN.*")
_NAME = re.compile(r"[A-Za-z][\w ()./-]{1,59}", re.ASCII)


def is_wgs84(name: str) -> bool:
    """Whether a name is that of WGS 84, or none."""
    plain = _plain(name)
    return not plain or _WGS84.fullmatch(plain) is not None


@lru_cache(maxsize=64)
def geographic_system(name: str) -> str | None:
    """The code of the geographic system of a datum; None where pyproj knows none of this name.

    pyproj also finds names that are merely alike: the name or its numbers must be the same.
    """
    from pyproj import CRS
    from pyproj.exceptions import CRSError

    if not _NAME.fullmatch(name):
        return None
    try:
        found = CRS.from_user_input(name)
    except CRSError:
        return None
    same = _plain(found.name) == _plain(name) or (re.findall(r"\d+", found.name) == re.findall(r"\d+", name) != [])
    code = found.to_authority() if found.is_geographic and same else None
    return None if code is None else ":".join(code)


def in_wgs84(system: str, latitude: float, longitude: float) -> tuple[float, float] | None:
    """Latitude and longitude [deg] in WGS 84, by pyproj's best transformation without grids; None without one.

    Datums of the Earth's centre without a transformation differ from WGS 84 by a few metres at most.
    """
    from pyproj import Transformer
    from pyproj.exceptions import ProjError

    try:
        way = Transformer.from_crs(system, "EPSG:4326", always_xy=True, allow_ballpark=of_older_datum(system) is False)
        x, y = way.transform(longitude, latitude)
    except ProjError:
        return None
    return (y, x) if math.isfinite(x) and math.isfinite(y) else None


def _plain(name: str) -> str:
    return re.sub(r"[^A-Z0-9]", "", name.upper())
