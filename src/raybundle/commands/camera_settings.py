"""What is told of cameras, alike where photographs are oriented and where they are measured from nothing."""

from __future__ import annotations

from typing import Any

from raybundle.settings import setting


def known_cameras() -> Any:
    """The setting of cameras that are known."""
    return setting(
        None, "Known cameras; `estimate = []` in it holds them; those of `raybundle calibrate` are observed with their "
        "covariance.", metavar="CAMERAS.toml",
    )  # fmt: skip


def cameras_apart() -> Any:
    """The setting of photographs that are of a camera apart."""
    return setting(
        (), "Photographs whose names match, as 'left_*' or 'a.jpg|b.jpg', are a camera apart; for those without "
        "metadata.", flag="--camera", metavar="PATTERN",
    )  # fmt: skip


def camera_library() -> Any:
    """The setting of the camera library."""
    return setting(True, "Leave calibrations of the camera library out.", flag="--no-library")
