"""What a set consists of: photographs with their metadata, and tables."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image, TiffImagePlugin

from raybundle.block import Camera
from raybundle.numerics.arrays import Array
from raybundle.sensors import sensor_models

QUALITY = 92


@dataclass(frozen=True, slots=True, kw_only=True)
class Taken:
    """What a camera writes into its photographs."""

    model: str
    focal_mm: float
    """nominal"""
    when: str
    """as EXIF has it: "2026:06:21 10:15:00" """
    place: tuple[float, float, float] | None = None
    """longitude, latitude [deg], height above the ellipsoid [m] of a receiver in the camera"""


def made_camera(name: str, size_px: tuple[int, int], pixel_mm: float, **values: float) -> Camera:
    """A camera of the model brown with its true values."""
    every = {**dict.fromkeys(sensor_models["brown"].symbols, 0.0), **values}
    return Camera(
        id=name, model="brown", width_px=size_px[0], height_px=size_px[1], pixel_mm=(pixel_mm, pixel_mm), values=every
    )


def write_photograph(path: Path, pixels: Array, camera: Camera, taken: Taken) -> None:
    """A JPEG file as a camera hands it over."""
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(pixels.astype(np.uint8)).save(path, quality=QUALITY, subsampling="4:2:0", exif=_exif(camera, taken))


def write_rows(path: Path, header: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """A table with commas."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def _exif(camera: Camera, taken: Taken) -> bytes:
    tags = Image.Exif()
    tags[0x010F], tags[0x0110], tags[0x0112] = "raybundle", taken.model, 1
    inner = tags.get_ifd(0x8769)
    inner[0x9003] = taken.when
    inner[0x920A] = _rational(taken.focal_mm, 1000)
    inner[0xA002], inner[0xA003] = camera.width_px, camera.height_px
    inner[0xA20E] = inner[0xA20F] = _rational(10 / camera.pixel_mm[0], 1000)
    inner[0xA210] = 3
    if taken.place is not None:
        place = tags.get_ifd(0x8825)
        for tag, value, signs in ((1, taken.place[1], "NS"), (3, taken.place[0], "EW")):
            place[tag] = signs[int(value < 0)]
            place[tag + 1] = _sexagesimal(abs(value))
        place[5] = b"\x01" if taken.place[2] < 0 else b"\x00"
        place[6] = _rational(abs(taken.place[2]), 1000)
    return tags.tobytes()


def _sexagesimal(degrees: float) -> tuple[TiffImagePlugin.IFDRational, ...]:
    """Degrees, minutes, seconds to 0.3 mm on the ground."""
    minutes = degrees % 1 * 60
    return _rational(int(degrees), 1), _rational(int(minutes), 1), _rational(minutes % 1 * 60, 100_000)


def _rational(value: float, denominator: int) -> TiffImagePlugin.IFDRational:
    return TiffImagePlugin.IFDRational(round(value * denominator), denominator)
