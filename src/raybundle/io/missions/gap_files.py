"""What came of a flight, as files: the photographs as a table, what is to be flown again as GeoJSON and KML."""

from __future__ import annotations

import json
import math
from html import escape
from pathlib import Path

import numpy as np

from raybundle.errors import phrase
from raybundle.io.digits import Places
from raybundle.io.missions.areas import GEOGRAPHIC, in_crs
from raybundle.io.tables import write_table
from raybundle.missions.check import FlightCheck
from raybundle.missions.mission import Mission
from raybundle.numerics.arrays import Array

DIGITS = Places(2)
"""Centimetres, hundredths of a degree and of a pixel: what a receiver and a gimbal show no better"""


def write_flown(check: FlightCheck, mission: Mission, path: Path) -> None:
    """The table of a flight: a row a photograph, and one for each planned one that nobody took."""
    f, missing = check.flown, check.missing.tolist()
    planned = [int(j) for j in check.match] + missing
    none = [math.nan] * len(missing)
    numbers = {
        "off_plan_m": check.off_plan_m, "off_height_m": check.off_height_m, "tilt_deg": np.degrees(check.tilt),
        "motion_px": check.motion_px, "blur_px": f.blur_px,
    }  # fmt: skip
    write_table(
        path,
        {
            "photograph": [*f.names, *[""] * len(missing)],
            "planned": ["" if j < 0 else str(j + 1) for j in planned],
            "line": ["" if j < 0 else mission.lines[int(check.planned.line[j])].name for j in planned],
            **{name: np.array([*values, *none], float) for name, values in numbers.items()},
            "counts": [*("yes" if c else "no" for c in check.counted), *["no"] * len(missing)],
            "reason": [*(reason(check, k) for k in range(len(f.names))), *["missing"] * len(missing)],
        },
        dict.fromkeys(numbers, DIGITS),
    )


def reason(check: FlightCheck, k: int) -> str:
    """Why a photograph does not count, or what is odd about it; "" for nothing."""
    if not np.isfinite(check.flown.xyz[k, :2]).all():
        return "no position"
    if check.counted[k]:
        return "" if check.match[k] >= 0 else "not planned"
    return "blurred" if check.flown.blurred[k] else "tilted"


def write_gaps(check: FlightCheck, mission: Mission, folder: Path) -> tuple[Path, ...]:
    """gaps.geojson and gaps.kml in longitude and latitude: each an area that can be planned again."""
    rings = [_closed(in_crs(g.outline, mission.crs, GEOGRAPHIC)) for g in check.gaps]
    features = [
        {
            "type": "Feature",
            "properties": {
                "name": phrase("mission_picture.gap", number=k + 1), "area_m2": round(g.area_m2, 1), "seen": g.seen,
                "wanted": g.wanted,
            },
            "geometry": {"type": "Polygon", "coordinates": [np.round(ring, 9).tolist()]},
        }
        for k, (g, ring) in enumerate(zip(check.gaps, rings, strict=True))
    ]  # fmt: skip
    text = json.dumps({"type": "FeatureCollection", "features": features}, indent=1)
    (folder / "gaps.geojson").write_text(text + "\n", encoding="utf-8", newline="\n")
    marks = "".join(
        f"<Placemark><name>{escape(phrase('mission_picture.gap', number=k + 1))}</name>"
        "<Polygon><outerBoundaryIs><LinearRing><coordinates>"
        + " ".join(f"{x:.9f},{y:.9f},0" for x, y in ring.tolist())
        + "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>\n"
        for k, ring in enumerate(rings)
    )
    (folder / "gaps.kml").write_text(
        '<?xml version="1.0" encoding="UTF-8"?>\n<kml xmlns="http://www.opengis.net/kml/2.2">\n<Document>\n'
        f"<name>{escape(phrase('mission_picture.gaps', name=mission.name))}</name>\n{marks}</Document>\n</kml>\n",
        encoding="utf-8",
        newline="\n",
    )
    return folder / "gaps.geojson", folder / "gaps.kml"


def _closed(ring: Array) -> Array:
    return np.vstack([ring, ring[:1]])
