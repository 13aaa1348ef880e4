"""Cameras of equirectangular images."""

from __future__ import annotations

import math

from raybundle.block import Camera
from raybundle.cameras.conversions import NOMINAL_SIDE_MM


def equirectangular_camera(id_: str, width_px: int, height_px: int, *, whole_sphere: bool) -> Camera:
    """The spherical camera of an image whose width is a full turn.

    whole_sphere  the height is half a turn, whatever its pixels; otherwise pixels are square
    """
    pixel = NOMINAL_SIDE_MM / width_px
    height = width_px / 2 / height_px if whole_sphere else 1.0
    return Camera(
        id=id_,
        model="spherical",
        width_px=width_px,
        height_px=height_px,
        pixel_mm=(pixel, pixel * height),
        values={"c": NOMINAL_SIDE_MM / (2 * math.pi), "y0": 0.0},
        estimate=(),
    )
