"""What came of a flight, as files: the photographs as a table, what is to be flown again as GeoJSON and KML."""

from __future__ import annotations

import csv
import io
import json
from html import escape
from pathlib import Path

import numpy as np

from raybundle.io.missions.areas import GEOGRAPHIC, in_crs
from raybundle.missions.check import FlightCheck
from raybundle.missions.mission import Mission
from raybundle.numerics.arrays import Array

COLUMNS = (
    "photograph", "planned", "line", "off_plan_m", "off_height_m", "tilt_deg", "motion_px", "blur_px", "counts",
    "reason",
)  # fmt: skip


def table_text(check: FlightCheck, mission: Mission) -> str:
    """A row a photograph, and one for each planned one that nobody took."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(COLUMNS)
    f = check.flown
    for k, name in enumerate(f.names):
        j = int(check.match[k])
        line = "" if j < 0 else mission.lines[int(check.planned.line[j])].name
        figures = [
            _figure(v) for v in (
                check.off_plan_m[k], check.off_height_m[k], np.degrees(check.tilt[k]), check.motion_px[k], f.blur_px[k]
            )
        ]  # fmt: skip
        counts = bool(check.counted[k])
        writer.writerow([name, "" if j < 0 else j + 1, line, *figures, "yes" if counts else "no", reason(check, k)])
    for j in check.missing.tolist():
        name = mission.lines[int(check.planned.line[j])].name
        writer.writerow(["", j + 1, name, *[""] * 5, "no", "missing"])
    return out.getvalue()


def reason(check: FlightCheck, k: int) -> str:
    """Why a photograph does not count, or what is odd about it; "" for nothing."""
    if not np.isfinite(check.flown.xyz[k, :2]).all():
        return "no position"
    if check.counted[k]:
        return "" if check.match[k] >= 0 else "not planned"
    return "blurred" if check.flown.blurred[k] else "tilted"


def _figure(value: float) -> str:
    return f"{value:.2f}" if np.isfinite(value) else ""


def write_gaps(check: FlightCheck, mission: Mission, folder: Path) -> tuple[Path, ...]:
    """gaps.geojson and gaps.kml in longitude and latitude: each an area that can be planned again."""
    rings = [_closed(in_crs(g.outline, mission.crs, GEOGRAPHIC)) for g in check.gaps]
    features = [
        {
            "type": "Feature",
            "properties": {"name": f"gap {k + 1}", "area_m2": round(g.area_m2, 1), "seen": g.seen, "wanted": g.wanted},
            "geometry": {"type": "Polygon", "coordinates": [np.round(ring, 9).tolist()]},
        }
        for k, (g, ring) in enumerate(zip(check.gaps, rings, strict=True))
    ]  # fmt: skip
    text = json.dumps({"type": "FeatureCollection", "features": features}, indent=1)
    (folder / "gaps.geojson").write_text(text + "\n", encoding="utf-8", newline="\n")
    marks = "".join(
        f"<Placemark><name>gap {k + 1}</name><Polygon><outerBoundaryIs><LinearRing><coordinates>"
        + " ".join(f"{x:.9f},{y:.9f},0" for x, y in ring.tolist())
        + "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>\n"
        for k, ring in enumerate(rings)
    )
    (folder / "gaps.kml").write_text(
        '<?xml version="1.0" encoding="UTF-8"?>\n<kml xmlns="http://www.opengis.net/kml/2.2">\n<Document>\n'
        f"<name>{escape(mission.name)}: to be flown again</name>\n{marks}</Document>\n</kml>\n",
        encoding="utf-8",
        newline="\n",
    )
    return folder / "gaps.geojson", folder / "gaps.kml"


def _closed(ring: Array) -> Array:
    return np.vstack([ring, ring[:1]])
