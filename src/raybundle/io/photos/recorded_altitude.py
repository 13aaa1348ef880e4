"""Altitude of a photograph from all entries that record one: EXIF, XMP of the aircraft, and an editor's copy of EXIF.

An altitude that was not measured (GPSMeasureMode 2) or is 0 beside another one is no witness.  Of two that rounding
does not reconcile the aircraft's is taken where single GNSS heights may differ so much, else none; what they count from
may explain a difference as large as a height of the geoid.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from raybundle.errors import phrase
from raybundle.io.photos.exif import Tags
from raybundle.io.photos.recorded_position import SLACK_DEG, step_of_number, step_of_text
from raybundle.io.reading.words import number_of

GNSS_HEIGHT_M = 10.0
"""Usual standard deviation of the height of a single GNSS position."""
NEAR_M = 3 * math.sqrt(2) * GNSS_HEIGHT_M
"""Largest difference of two single heights of one place: three standard deviations of the difference."""
GEOID_M = 110.0
"""Largest height of the geoid above or below the ellipsoid."""
ABOVE = {0: "sea level", 1: "sea level", 2: "ellipsoid", 3: "ellipsoid"}
"""GPSAltitudeRef, EXIF 3.0; odd ones are depths."""


@dataclass(frozen=True, slots=True)
class _Altitude:
    source: str
    metres: float
    reference: str
    step: float

    def __str__(self) -> str:
        """For people."""
        return f"{self.source} {self.metres:.7g} m"


def recorded_altitude(
    tags: Tags, entries: Mapping[str, str], remarks: list[str], *, of_exif: bool
) -> tuple[float | None, str]:
    """Altitude [m], None without one, and what it is above; DJI writes AltitudeType RtkAlt for the ellipsoid.

    of_exif  whether the position is that of EXIF; the altitude 0 beside another one is of a receiver without a fix
    remarks  what was left out is added
    """
    rtk = entries.get("drone-dji:AltitudeType", "") == "RtkAlt"
    exif = _of_exif(tags, entries, remarks, rtk=rtk)
    if exif is not None and exif.metres == 0 and not of_exif:
        exif = None
    text = entries.get("drone-dji:AbsoluteAltitude", "").strip()
    absolute = number_of(text)
    if absolute is None:
        return (None, "") if exif is None else (exif.metres, exif.reference)
    own = _Altitude(
        "XMP drone-dji:AbsoluteAltitude", absolute, "ellipsoid" if rtk else "sea level", step_of_text(text)
    )  # fmt: skip
    if exif is None or exif.metres == 0 or abs(own.metres - exif.metres) <= own.step + exif.step + SLACK_DEG:
        return own.metres, own.reference
    if own.metres == 0:
        return exif.metres, exif.reference
    apart = abs(own.metres - exif.metres)
    if (rtk or own.reference != exif.reference) and apart <= GEOID_M:
        return own.metres, own.reference
    values: dict[str, Any] = {"first": str(own), "second": str(exif), "apart_m": apart}
    if apart <= NEAR_M:
        remarks.append(phrase("photo_entry.altitudes_differ", source=own.source, **values))
        return own.metres, own.reference
    remarks.append(phrase("photo_entry.altitudes_contradict", **values))
    return None, ""


def _of_exif(tags: Tags, entries: Mapping[str, str], remarks: list[str], *, rtk: bool) -> _Altitude | None:
    """The altitude of EXIF, or of an editor's copy of it in XMP where EXIF has none."""
    source, altitude = "EXIF", tags.number(6, gps=True)
    code = tags.gps.get(5, (0.0,))
    reference = code[0] if isinstance(code, bytes | tuple) and code else 0
    if altitude is None:
        source, (head, _, below) = "XMP exif:GPSAltitude", entries.get("exif:GPSAltitude", "").partition("/")
        above, under = number_of(head.strip()), number_of(below.strip() or "1")
        altitude = above / under if above is not None and under else None
        reference = number_of(entries.get("exif:GPSAltitudeRef", "0").strip()) or 0
    if altitude is None or not math.isfinite(altitude):
        return None
    if (tags.text(10, gps=True) or entries.get("exif:GPSMeasureMode", "")).strip() == "2":
        remarks.append(phrase("photo_entry.altitude_no_fix", source=source))
        return None
    above_what = "ellipsoid" if rtk else ABOVE.get(int(reference), "sea level")
    sign = -1.0 if reference in {1, 3} else 1.0
    return _Altitude(source, sign * altitude, above_what, step_of_number(altitude))
