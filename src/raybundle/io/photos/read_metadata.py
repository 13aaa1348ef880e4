"""Metadata of a photograph from its EXIF and XMP."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from datetime import datetime, timedelta, timezone

from raybundle.errors import phrase
from raybundle.io.photos.exif import Tags, read_tags
from raybundle.io.photos.metadata import Gps, Metadata
from raybundle.io.photos.recorded_altitude import recorded_altitude
from raybundle.io.photos.recorded_position import Recorded, recorded_position
from raybundle.io.photos.xmp import read_xmp
from raybundle.io.reading.words import finite, number_of, quoted, whole_of

MM_PER_UNIT = {2: 25.4, 3: 10.0, 4: 1.0, 5: 0.001}
"""EXIF FocalPlaneResolutionUnit; inch where it is absent (4 and 5 are not in the standard but are written)."""
RTK_FIX = {0: "none", 16: "single", 34: "rtk float", 50: "rtk fixed"}
NUMBERS = tuple(
    f"drone-dji:{name}"
    for name in (
        "GpsLatitude", "GpsLongitude", "GpsLongtitude", "Latitude", "Longitude", "Longtitude", "AbsoluteAltitude",
        "RelativeAltitude", "RtkFlag", "RtkStdLon",
        "RtkStdLat", "RtkStdHgt",
        *(f"{what}{axis}Degree" for what in ("Gimbal", "Flight") for axis in ("Yaw", "Pitch", "Roll")),
    )
)  # fmt: skip
"""Entries that are numbers."""
NAN = math.nan
WEAK_DOP = 10.0
"""Dilution of precision above which a position is a rough estimate (Langley 1999); as a factor it is not defined,
because programs write an accuracy in metres under this name, too."""


def read_metadata(exif: bytes | memoryview | None, xmp: bytes | None) -> tuple[Metadata, int]:
    """Metadata and EXIF orientation (1 to 8; 1 where not known) from the segments of a file.

    Never raises on bad data: what cannot be used is not known, and `Metadata.remarks` states why.
    EXIF stands before XMP where both say something, but for positions: see `recorded_position`.
    """
    tags = read_tags(exif) if exif else Tags()
    if xmp is None and isinstance(found := tags.main.get(700), bytes | tuple):
        xmp = found if isinstance(found, bytes) else bytes(int(v) & 255 for v in found)
    entries, xmp_remarks = read_xmp(xmp) if xmp else ({}, ())
    remarks = [*tags.remarks, *xmp_remarks, *_no_numbers(entries)]
    orientation = int(tags.number(0x0112) or _number(entries, "tiff:Orientation") or 1)
    if not 1 <= orientation <= 8:
        remarks.append(phrase("photo_entry.orientation", orientation=orientation))
        orientation = 1
    width, height = tags.positive(0xA002), tags.positive(0xA003)
    place, left_out = recorded_position(tags, entries)
    remarks += left_out
    return Metadata(
        make=tags.text(0x010F) or entries.get("tiff:Make", ""),
        model=tags.text(0x0110) or entries.get("tiff:Model", ""),
        serial=_serial(tags, entries),
        lens=tags.text(0xA434) or entries.get("exifEX:LensModel", "") or entries.get("aux:Lens", ""),
        software=tags.text(0x0131) or entries.get("xmp:CreatorTool", ""),
        focal_mm=tags.positive(0x920A) or _positive(entries, "exif:FocalLength"),
        focal35_mm=tags.positive(0xA405) or _positive(entries, "exif:FocalLengthIn35mmFilm"),
        exposure_s=tags.positive(0x829A) or _positive(entries, "exif:ExposureTime"),
        focal_plane_px_per_mm=_focal_plane(tags),
        exif_width=None if width is None else int(width),
        exif_height=None if height is None else int(height),
        zoom_ratio=tags.positive(0xA404),
        focal_range_mm=_focal_range(tags),
        subject_distance_m=_distance(tags),
        taken=_taken(tags),
        gps=None if place is None else _gps(place, tags, entries, remarks),
        gimbal=_angles(entries, "drone-dji:Gimbal{}Degree") or _angles(entries, "Camera:{}"),
        flight=_angles(entries, "drone-dji:Flight{}Degree"),
        xmp=entries,
        remarks=tuple(remarks),
    ), orientation


def _no_numbers(entries: Mapping[str, str]) -> list[str]:
    """What is reported of entries of an aircraft's XMP that are to be numbers and are none."""
    bad = [k for k in NUMBERS if entries.get(k) and _number(entries, k) is None]
    return [phrase("photo_entry.xmp_no_number", entry=k, value=quoted(entries[k])) for k in bad]


def _number(entries: Mapping[str, str], *keys: str) -> float | None:
    """The first entry that is a finite number, also one written as a fraction "585/100"."""
    for key in keys:
        head, _, below = entries.get(key, "").partition("/")
        above, under = number_of(head.strip()), number_of(below.strip() or "1")
        if above is not None and under:
            found = finite(above / under)
            if found is not None:
                return found
    return None


def _positive(entries: Mapping[str, str], *keys: str) -> float | None:
    found = _number(entries, *keys)
    return found if found is not None and 0 < found < 1e9 else None


def _serial(tags: Tags, entries: Mapping[str, str]) -> str:
    written = tags.text(0xA431, 0xC62F)
    keys = ("exifEX:BodySerialNumber", "aux:SerialNumber", "drone-dji:CameraSerialNumber")
    serial = written or next((entries[k] for k in keys if entries.get(k)), "")
    return serial if re.search(r"[1-9A-Za-z]", serial) else ""


def _focal_plane(tags: Tags) -> tuple[float, float] | None:
    unit = MM_PER_UNIT.get(int(tags.number(0xA210) or 2))
    x, y = tags.positive(0xA20E), tags.positive(0xA20F)
    if unit is None or (x is None and y is None):
        return None
    return (x or y or NAN) / unit, (y or x or NAN) / unit


def _focal_range(tags: Tags) -> tuple[float, float] | None:
    limits = tags.numbers(0xA432)
    if len(limits) >= 2 and 0 < limits[0] <= limits[1] < 1e5:
        return limits[0], limits[1]
    return None


def _distance(tags: Tags) -> float | None:
    distance = tags.positive(0x9206)
    return distance if distance is not None and distance < 4e6 else None  # 0xFFFFFFFF: infinity


def _taken(tags: Tags) -> datetime | None:
    for date, fraction, zone in ((0x9003, 0x9291, 0x9011), (0x9004, 0x9292, 0x9012), (0x0132, 0x9290, 0x9010)):
        found = re.fullmatch(
            r"(\d{4})[:-](\d\d)[:-](\d\d)[ T](\d\d):(\d\d):(\d\d)(?:\.\d+)?", tags.text(date), re.ASCII
        )
        if not found:
            continue
        year, month, day, hour, minute, second = (whole_of(g) or 0 for g in found.groups())
        digits = tags.text(fraction)
        micro = max(whole_of(digits[:6].ljust(6, "0")) or 0, 0)
        try:
            return datetime(year, month, day, hour, minute, second, micro, tzinfo=_zone(tags.text(zone)))
        except ValueError:
            continue
    return None


def _zone(text: str) -> timezone | None:
    found = re.fullmatch(r"([+-])(\d\d):(\d\d)", text, re.ASCII)
    if not found:
        return None
    hours, minutes = whole_of(found[2]) or 0, whole_of(found[3]) or 0
    if hours > 14 or minutes > 59:
        return None
    offset = timedelta(hours=hours, minutes=minutes)
    return timezone(-offset if found[1] == "-" else offset)


def _angles(entries: Mapping[str, str], pattern: str) -> tuple[float, float, float] | None:
    found = [_number(entries, pattern.format(name)) for name in ("Yaw", "Pitch", "Roll")]
    if any(v is None or abs(v) > 360 for v in found):
        return None
    yaw, pitch, roll = (float(v) for v in found if v is not None)
    return yaw, pitch, roll


def _gps(place: Recorded, tags: Tags, entries: Mapping[str, str], remarks: list[str]) -> Gps:
    flag = _number(entries, "drone-dji:RtkFlag")
    altitude, reference = recorded_altitude(tags, entries, remarks, of_exif=place.origin == "EXIF")
    sigma = _sigma(tags, entries)
    dop = tags.positive(11, gps=True) or _positive(entries, "exif:GPSDOP")
    if dop is not None and dop > WEAK_DOP and sigma is None:
        remarks.append(phrase("photo_entry.dop", dop=dop, limit=WEAK_DOP))
    return Gps(
        latitude_deg=place.angles[0],
        longitude_deg=place.angles[1],
        altitude_m=altitude,
        altitude_reference=reference,
        sigma_m=_with_rounding(place, sigma),
        fix="" if flag is None else RTK_FIX.get(int(flag), ""),
    )


def _with_rounding(place: Recorded, sigma: tuple[float, float, float] | None) -> tuple[float, float, float] | None:
    """East, north, up [m] with a rounding that outweighs them."""
    if not place.coarse:
        return sigma
    east, north, up = sigma or (NAN, NAN, NAN)
    coarse = place.rounding_m
    plan = [r if math.isnan(s) else math.hypot(r, s) for r, s in zip(coarse, (east, north), strict=True)]
    return plan[0], plan[1], up


def _sigma(tags: Tags, entries: Mapping[str, str]) -> tuple[float, float, float] | None:
    """East, north, up [m]."""
    rtk = [_positive(entries, f"drone-dji:RtkStd{axis}") for axis in ("Lon", "Lat", "Hgt")]
    if any(v is not None for v in rtk):
        east, north, up = (NAN if v is None else v for v in rtk)
        return east, north, up
    plan, height = _positive(entries, "Camera:GPSXYAccuracy"), _positive(entries, "Camera:GPSZAccuracy")
    if plan is not None or height is not None:
        return plan or NAN, plan or NAN, height or NAN
    radius = tags.positive(31, gps=True)
    # GPSHPositioningError is the radius of a circle; phones write that of 68 %: 1.515 sigma of each axis
    return None if radius is None else (radius / 1.515, radius / 1.515, NAN)
