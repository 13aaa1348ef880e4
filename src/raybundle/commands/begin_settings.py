"""Settings with which photographs are begun to be measured by hand; nothing is loaded for them that computes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from raybundle.commands.camera_settings import camera_library, cameras_apart, known_cameras


@dataclass(frozen=True, slots=True, kw_only=True)
class BeginSettings:
    """What photographs are begun with."""

    photos: tuple[Path, ...]
    """folders and files"""
    out: Path
    """project folder; begun, or continued"""
    calibration: Path | None = known_cameras()
    separate: tuple[str, ...] = cameras_apart()
    library: bool = camera_library()
