"""Settings with which photographs are begun to be measured by hand; nothing is loaded for them that computes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from raybundle.settings import POSITIVE, setting
from raybundle.workflows.orienting.options import APART_HELP, KNOWN_HELP, LIBRARY_HELP


@dataclass(frozen=True, slots=True, kw_only=True)
class BeginSettings:
    """What photographs are begun with."""

    photos: tuple[Path, ...]
    """folders and files"""
    out: Path
    """project folder; begun, or continued"""
    calibration: Path | None = setting(None, KNOWN_HELP, metavar="CAMERAS.toml")
    own_camera: tuple[str, ...] = setting((), APART_HELP, metavar="PATTERN")
    library: bool = setting(True, LIBRARY_HELP, flag="no-library")
    film: Path | None = setting(
        None, "Calibrated fiducial marks of film scans: mark,x_mm,y_mm. All photographs are scans; {calibration} "
        "gives their camera.", metavar="CERTIFICATE.csv",
    )  # fmt: skip
    pixel_mm: float | None = setting(
        None, "Pixel size of the scanner.  [default: that of the camera]", metavar="MM", limits=POSITIVE
    )
    film_transformation: Literal["similarity", "affine"] = setting(
        "affine", "Transformation from a scan to the camera's frame."
    )
