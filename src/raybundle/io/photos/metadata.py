"""What a photograph states about itself: camera, lens, time, position, attitude."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class Gps:
    """A position as the camera recorded it; WGS84 unless the recorder states otherwise."""

    latitude_deg: float
    longitude_deg: float
    altitude_m: float | None = None
    altitude_reference: str = ""
    """"sea level", "ellipsoid" or "" where there is no altitude; cameras often write one and mean the other."""
    sigma_m: tuple[float, float, float] | None = None
    """Standard deviations east, north, up as recorded; NaN for a component not recorded; None: nothing recorded."""
    fix: str = ""
    """"rtk fixed", "rtk float", "single", "none", or "" where the recorder does not say."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Metadata:
    """EXIF and XMP, cleaned: an empty text or None means not known (0 and x/0 count as not known)."""

    make: str = ""
    model: str = ""
    serial: str = ""
    lens: str = ""
    software: str = ""
    focal_mm: float | None = None
    focal35_mm: float | None = None
    """35 mm equivalent; by the diagonal (CIPA DCG-001), though some cameras take the width."""
    exposure_s: float | None = None
    """Exposure time."""
    focal_plane_px_per_mm: tuple[float, float] | None = None
    """Of the image as it was taken, `exif_width` by `exif_height`; a reduced copy keeps the old figures."""
    exif_width: int | None = None
    exif_height: int | None = None
    zoom_ratio: float | None = None
    """Digital zoom; 1 = none."""
    focal_range_mm: tuple[float, float] | None = None
    """Shortest and longest focal length of the lens; equal for a prime lens."""
    subject_distance_m: float | None = None
    taken: datetime | None = None
    """With fractions of a second and time zone where recorded."""
    gps: Gps | None = None
    gimbal: tuple[float, float, float] | None = None
    """Yaw, pitch, roll of the camera [deg], as recorded."""
    flight: tuple[float, float, float] | None = None
    """Yaw, pitch, roll of the aircraft [deg], as recorded."""
    xmp: Mapping[str, str] = field(default_factory=dict[str, str])
    """Entries of the namespaces that raybundle reads, by "prefix:name"."""
    remarks: tuple[str, ...] = ()
    """What of the metadata could not be used, and why."""
