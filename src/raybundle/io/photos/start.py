"""The camera constant to start with, and how far to trust it.

In this order: XMP of the manufacturer, focal plane resolution, table of sensor sizes, 35 mm equivalent, default; focal
plane resolution and 35 mm equivalent together outvote the table.  A stored calibration stands above all and is dealt
with in `cameras`.  Sources that contradict each other are compared by the sensor width that they imply, in which the
entry for the focal length cancels.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from raybundle.errors import phrase
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.sensor_sizes import sensor_size
from raybundle.io.reading.words import number_of, quoted

DIAGONAL_35MM = math.hypot(36, 24)
XMP_SOURCE = "camera_start.xmp"
DEFAULT_SOURCE = "camera_start.default"
EQUIVALENT_SOURCE = "camera_start.equivalent"
NOMINAL_PIXEL_MM = 0.001
SIGMA = {"xmp": 0.01, "focal plane": 0.02, "table": 0.02, "35 mm": 0.05, "default": 0.4}
"""Relative standard deviations: the nominal focal length alone is good to one or two per cent."""
SHOWN = {
    "focal plane": "camera_start.focal_plane", "table": "camera_start.table", "35 mm": EQUIVALENT_SOURCE,
}  # fmt: skip
SENSOR_WIDTH_MM = (2.0, 75.0)
EQUIVALENT_MM = (4.0, 4000.0)
"""35 mm equivalents that lenses have: fisheyes from 6 mm, bridge cameras to 3000 mm (Nikon P1000)."""
SAME_SENSOR = 0.015
"""Relative difference of two sensor widths up to which they are the same."""
SAME_EQUIVALENT = 0.12
"""Relative difference up to which a 35 mm equivalent supports another source: rounding, width for diagonal."""
SAME_CAMERA = 0.15
"""Relative difference up to which a calibration in XMP can belong to the focal length."""

CENTRE = 0.02
"""Sigma of the principal point in longer sides.  Eight cameras of sets that determine it: 0.8 % rms, 1.8 % at most."""
CENTRE_OPEN = 0.05
"""The same where nothing shows whether the photograph was cropped: published cameras of such sets are 3 and 6 % off."""
NOMINAL = 0.05
"""Least sigma of ln c from a nominal focal length: five cameras with metadata, well determined, lie 0.2, 0.8, 3.8,
4.9 and 8.4 % off, 5 % rms, the focus, rounding and the stated size of the sensor being in it."""
BY_FACTOR = 0.5
"""Sigma of ln c where nothing is stated: 26 to 71 mm for 24 x 36 mm, and seldom beyond 16 and 117 mm."""
DEWARP_VALUES = 9
"""fx, fy, cx, cy, k1, k2, p1, p2, k3 after the date."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Start:
    """Camera constant with the pixel size that it goes with."""

    c_mm: float
    pixel_mm: float
    sigma: float
    """Relative standard deviation of c in pixels."""
    source: str
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class _Taken:
    """The image as the camera took it, before a program made it smaller."""

    long: int
    short: int
    ratio: float = 1.0
    """Its pixels by those of the file."""
    doubt: float = 0.0
    """Relative sigma of the above."""


def starting_value(metadata: Metadata, width_px: int, height_px: int) -> Start:
    """Where the camera constant starts, for photographs of this size as stored.

    Limits: the effect of the focus; close up c is longer than the focal length by f / distance.
    """
    remarks: list[str] = []
    if metadata.focal35_mm is not None and not EQUIVALENT_MM[0] <= metadata.focal35_mm <= EQUIVALENT_MM[1]:
        remarks.append(
            phrase(
                "camera_start.equivalent_impossible", equivalent_mm=metadata.focal35_mm, least_mm=EQUIVALENT_MM[0],
                most_mm=EQUIVALENT_MM[1],
            )
        )  # fmt: skip
        metadata = replace(metadata, focal35_mm=None)
    taken = _taken(metadata, width_px, height_px, remarks)
    density, doubt = _densities(metadata, taken, remarks)
    best = next(iter(density), "")
    zoom = metadata.zoom_ratio if metadata.zoom_ratio is not None and 1.01 < metadata.zoom_ratio < 100 else 1.0
    if zoom > 1:
        remarks.append(phrase("camera_start.digital_zoom", zoom=zoom))
    focal, c = metadata.focal_mm, None
    if best and focal is not None:
        c = focal * (zoom if best != "35 mm" else 1.0) * density[best] / taken.ratio
    pixel = taken.ratio / density[best] if best else NOMINAL_PIXEL_MM
    found = _from_xmp(metadata, taken, density.get(best), remarks)
    if found is not None and c is not None and abs(math.log(found / c)) > SAME_CAMERA:
        remarks.append(phrase("camera_start.xmp_contradicts", c_px=round(found), expected_px=round(c)))
    elif found is not None:
        return _start(found, pixel, math.hypot(SIGMA["xmp"], taken.doubt), XMP_SOURCE, remarks)
    if c is not None:
        sigma = math.hypot(SIGMA[best], _focus(metadata, remarks), taken.doubt, doubt)
        return _start(c, pixel, sigma, SHOWN[best], remarks)
    diagonal = math.hypot(taken.long, taken.short) / taken.ratio
    if metadata.focal35_mm is not None:
        c = metadata.focal35_mm * diagonal / DIAGONAL_35MM
        sigma = math.hypot(SIGMA["35 mm"], taken.doubt)
        return _start(c, DIAGONAL_35MM / diagonal, sigma, EQUIVALENT_SOURCE, remarks)
    if focal is not None:
        remarks.append(phrase("camera_start.no_sensor_size", focal_mm=focal))
    return _start(1.2 * max(width_px, height_px), NOMINAL_PIXEL_MM, SIGMA["default"], DEFAULT_SOURCE, remarks)


def stated_projection(metadata: Metadata) -> str:
    """What is stated of a projection that is not central, in words; empty for a photograph."""
    kind = metadata.xmp.get("GPano:ProjectionType")
    return phrase("camera_start.panorama", kind=kind) if kind else ""


def centre_sigma(metadata: Metadata, width_px: int, height_px: int) -> float:
    """Standard deviation of the principal point about the middle of the format, as a share of its longer side.

    `CENTRE` of a photograph as taken; what was cut off to another shape may have been cut off on any side: uniform
    within +- half of it, which has the standard deviation of the whole by sqrt 12.  Without metadata: `CENTRE_OPEN`.
    """
    if not (metadata.model or metadata.exif_width):
        return CENTRE_OPEN
    if metadata.exif_width is None or metadata.exif_height is None:
        return CENTRE
    long, short = max(metadata.exif_width, metadata.exif_height), min(metadata.exif_width, metadata.exif_height)
    file_long, file_short = max(width_px, height_px), min(width_px, height_px)
    ratio = min(long / file_long, short / file_short)
    cut = max(long - ratio * file_long, short - ratio * file_short) / (ratio * file_long)
    return math.hypot(CENTRE, cut / math.sqrt(12))


def _start(c_px: float, pixel_mm: float, sigma: float, source: str, remarks: list[str]) -> Start:
    return Start(c_mm=c_px * pixel_mm, pixel_mm=pixel_mm, sigma=sigma, source=phrase(source), remarks=tuple(remarks))


def _taken(metadata: Metadata, width: int, height: int, remarks: list[str]) -> _Taken:
    """Size of the image as taken; that of the file where EXIF does not say."""
    file_long, file_short = max(width, height), min(width, height)
    same = _Taken(long=file_long, short=file_short)
    if metadata.exif_width is None or metadata.exif_height is None:
        return same
    long, short = max(metadata.exif_width, metadata.exif_height), min(metadata.exif_width, metadata.exif_height)
    if max(abs(long - file_long), abs(short - file_short)) <= 16:
        return same
    sizes: dict[str, Any] = {
        "exif_width": metadata.exif_width, "exif_height": metadata.exif_height, "width": width, "height": height,
    }  # fmt: skip
    by_long, by_short = long / file_long, short / file_short
    if abs(math.log(by_long / by_short)) < 0.015:
        remarks.append(phrase("camera_start.copy", ratio=by_long, **sizes))
        return _Taken(long=long, short=short, ratio=by_long)
    remarks.append(phrase("camera_start.cropped", **sizes))
    if min(by_long, by_short) < 1:
        return _Taken(long=file_long, short=file_short, doubt=0.2)
    ratio = min(by_long, by_short)
    # cut to another shape after a reduction by a whole number, or else only cut
    whole = round(ratio) if ratio > 1.9 and abs(ratio - round(ratio)) < 0.005 else 1.0
    return _Taken(long=long, short=short, ratio=whole, doubt=0.15)


def _densities(m: Metadata, taken: _Taken, remarks: list[str]) -> tuple[dict[str, float], float]:
    """Pixels per mm of the image as taken, by source in the order of trust, contradictions resolved.

    The second value is the relative sigma that a contradiction which cannot be resolved adds.
    """
    long, short = taken.long, taken.short
    doubt = 0.0
    plane = _focal_plane(m, long, remarks)
    size = sensor_size(m, (long, short))
    table = None if size is None else max(long / size[0], short / size[1])
    equivalent = None
    if m.focal35_mm is not None and m.focal_mm is not None:
        equivalent = m.focal35_mm / DIAGONAL_35MM * math.hypot(long, short) / m.focal_mm
    if plane is not None and equivalent is not None and table is not None and _outvoted(table, plane, equivalent):
        remarks.append(phrase("camera_start.table_outvoted", table_mm=long / table, taken_mm=long / plane))
        table = None
    if plane is not None and table is not None and abs(math.log(plane / table)) > SAME_SENSOR:
        remarks.append(phrase("camera_start.table_taken", plane_mm=long / plane, table_mm=long / table))
        plane = None
    if plane is not None and table is None and equivalent is not None and _far(plane, equivalent):
        remarks.append(phrase("camera_start.equivalent_taken", plane_mm=long / plane, equivalent_mm=long / equivalent))
        plane = None
    if table is not None and equivalent is not None and _far(table, equivalent):
        remarks.append(phrase("camera_start.table_doubtful", equivalent_mm=long / equivalent, table_mm=long / table))
        doubt = abs(math.log(table / equivalent)) / 2
    named = (("focal plane", plane), ("table", table), ("35 mm", equivalent))
    return {name: density for name, density in named if density is not None}, doubt


def _outvoted(table: float, plane: float, equivalent: float) -> bool:
    """Whether the two sources of the photograph agree with each other and neither with the table."""
    return not _far(plane, equivalent) and _far(table, plane) and _far(table, equivalent)


def _far(a: float, b: float) -> bool:
    return abs(math.log(a / b)) > SAME_EQUIVALENT


def _focal_plane(m: Metadata, long: int, remarks: list[str]) -> float | None:
    """Pixels per mm from the focal plane resolution, which belongs to the image as taken."""
    if m.focal_plane_px_per_mm is None:
        return None
    x, y = m.focal_plane_px_per_mm
    if not SENSOR_WIDTH_MM[0] <= long / x <= SENSOR_WIDTH_MM[1]:
        remarks.append(phrase("camera_start.focal_plane_impossible", plane_mm=long / x))
        return None
    if abs(math.log(x / y)) > 0.008:
        remarks.append(phrase("camera_start.not_square", share=abs(x / y - 1)))
    return math.sqrt(x * y)


def _from_xmp(m: Metadata, taken: _Taken, density: float | None, remarks: list[str]) -> float | None:
    """Camera constant [px of the file] as the manufacturer wrote it.

    DJI: DewarpData or CalibratedFocalLength [px]; Pix4D's camera tags: PerspectiveFocalLength [mm].
    """
    dewarp = m.xmp.get("drone-dji:DewarpData", "")
    values = dewarp.partition(";")[2].split(",")
    if dewarp and len(values) < DEWARP_VALUES:
        remarks.append(phrase("camera_start.dewarp_data", value=quoted(dewarp), n=DEWARP_VALUES))
    candidates = [("DewarpData", values[0], 1.0)] if len(values) >= DEWARP_VALUES else []
    candidates.append(("CalibratedFocalLength", m.xmp.get("drone-dji:CalibratedFocalLength", ""), 1.0))
    if density is not None:
        candidates.append(("PerspectiveFocalLength", m.xmp.get("Camera:PerspectiveFocalLength", ""), density))
    for name, text, px in candidates:
        if not text:
            continue
        value = number_of(text.strip())
        if value is None:
            remarks.append(phrase("camera_start.no_number", entry=name, value=quoted(text)))
            continue
        c = value * px
        if 0.2 * taken.long < c < 50 * taken.long:
            return c / taken.ratio
        remarks.append(phrase("camera_start.no_constant", entry=name, value=quoted(text)))
    return None


def _focus(m: Metadata, remarks: list[str]) -> float:
    """Relative uncertainty of c from the focus; noted where it matters."""
    if m.subject_distance_m is None or m.focal_mm is None:
        return 0.0
    share = m.focal_mm / 1000 / m.subject_distance_m
    if share < 0.01:
        return 0.0
    share = min(share, 1.0)
    remarks.append(phrase("camera_start.focused", distance_m=m.subject_distance_m, share=share))
    return share
