"""Parts of rasters for the page: pictures as they are, heights shaded; what a raster holds at a place."""

from __future__ import annotations

import math
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from threading import Lock
from typing import Any

import numpy as np
from PIL import Image

from raybundle.errors import InputError
from raybundle.io.geo.rasters import scale_and_offset
from raybundle.io.raster_library import raster_errors, raster_library
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.files.heights import HEIGHTS

SUFFIXES = frozenset({".tif", ".tiff", ".png", ".jpg", ".jpeg"})
MOST_PX = 4096
"""Width and height of a part, on the screen"""
LEAST_PX = 1e-3
"""Width and height of a part, in pixels of the raster"""
SAMPLE_PX = 512
"""Of the copy from which the range of heights is taken"""
SUN = np.array([-1.0, -1.0, 1.4]) / math.sqrt(3.96)
"""From where shaded heights are lit: column, row, height; upper left, 45 degrees"""
LOW, HIGH = np.array([52.0, 94.0, 116.0]), np.array([245.0, 225.0, 170.0])
"""Colours of the lowest and the highest heights"""


@dataclass(slots=True)
class Pictures:
    """Reads parts of rasters; remembers the range of heights of each."""

    _ranges: dict[tuple[str, int], tuple[float, float]] = field(
        default_factory=dict[tuple[str, int], tuple[float, float]]
    )
    _lock: Lock = field(default_factory=Lock)

    @staticmethod
    def is_picture(file: Path) -> bool:
        """Whether a file may be one, by its name."""
        return file.suffix.lower() in SUFFIXES

    def about(self, file: Path) -> dict[str, Any]:
        """Size, and how pixels lie in the plane or the map: X = x0 + dx column, Y = y0 - dy row."""
        with _opened(file) as data:
            t = data.transform
            placed = not t.is_identity and t.b == t.d == 0
            return {
                "width": data.width, "height": data.height, "stamp": str(file.stat().st_mtime_ns),
                "heights": _is_heights(data) or (placed and _heights_of(file).is_file()),
                "place": [t.c, t.f, t.a, -t.e] if placed else None,
                "system": data.crs.to_string() if data.crs else "",
            }  # fmt: skip

    def place(self, file: Path, given: Mapping[str, Any]) -> dict[str, Any]:
        """The height at a pixel and its standard deviation, from the raster of heights and that beside it."""
        column, row = _numbers(given, "column", "row")
        with _opened(file) as data:
            own, t = _is_heights(data), data.transform
        if not own:
            x, y, file = t.c + t.a * column, t.f + t.e * row, _heights_of(file)
            if not file.is_file():
                return {"height": None, "sigma": None}
            with _opened(file) as data:
                column, row = (x - data.transform.c) / data.transform.a, (y - data.transform.f) / data.transform.e
        height = _value(file, column, row)
        beside = file.with_name(f"{file.stem}_sigma{file.suffix}")
        sigma = _value(beside, column, row) if beside.is_file() else None
        return {"height": height, "sigma": sigma}

    def part(self, file: Path, given: Mapping[str, Any]) -> bytes:
        """A window of a raster at a size of the screen, as PNG; what is beyond it or unknown is transparent."""
        left, top, width, height = _numbers(given, "left", "top", "width", "height")
        across, down = (round(v) for v in _numbers(given, "across", "down"))
        if not (1 < across <= MOST_PX and 1 < down <= MOST_PX and min(width, height) > LEAST_PX):
            raise InputError("value.not_one_of", entry="across", given=f"{across} x {down}", known=[f"2 ... {MOST_PX}"])
        with _opened(file) as data:
            if _is_heights(data):
                picture = self._shaded(file, data, (left, top, width, height), (down, across))
            else:
                picture = _colours(data, (left, top, width, height), (down, across))
        out = BytesIO()
        Image.fromarray(picture, "RGBA").save(out, "PNG", compress_level=1)
        return out.getvalue()

    def _shaded(self, file: Path, data: Any, window: tuple[float, ...], shape: tuple[int, int]) -> Array:
        z, known = _band(data, 1, window, shape)
        low, high = self._range(file, data)
        step = window[2] / shape[1] * abs(data.transform.a)
        down, across = np.gradient(np.where(known, z, np.nan), step)
        normal = np.dstack([-across, -down, np.ones_like(z)])
        light = np.clip(normal @ SUN / np.linalg.norm(normal, axis=2), 0, 1)
        share = np.clip((z - low) / max(high - low, 1e-12), 0, 1)[..., None]
        colours = (LOW + share * (HIGH - LOW)) * (0.35 + 0.65 * np.where(np.isfinite(light), light, 0.7))[..., None]
        out = np.zeros((*shape, 4), np.uint8)
        out[..., :3] = np.where(known[..., None], np.clip(colours, 0, 255), 0).astype(np.uint8)
        out[..., 3] = np.where(known, 255, 0)
        return out

    def _range(self, file: Path, data: Any) -> tuple[float, float]:
        """Heights between which colours change: all but a hundredth at each end."""
        key = str(file), file.stat().st_mtime_ns
        with self._lock:
            if key not in self._ranges:
                shape = min(SAMPLE_PX, data.height), min(SAMPLE_PX, data.width)
                z, known = _band(data, 1, (0, 0, data.width, data.height), shape)
                low, high = np.quantile(z[known], [0.01, 0.99]) if known.any() else (0.0, 1.0)
                self._ranges[key] = float(low), float(high)
            return self._ranges[key]


def _heights_of(picture: Path) -> Path:
    """The heights that stand beside an orthophoto."""
    return picture.with_name(HEIGHTS)


@contextmanager
def _opened(file: Path) -> Generator[Any]:
    library = raster_library(file)
    with raster_errors(file), library.open(file) as data:
        yield data


def _is_heights(data: Any) -> bool:
    """Whether a raster holds values, not colours."""
    return data.dtypes[0].startswith("float")


def _numbers(given: Mapping[str, Any], *names: str) -> list[float]:
    try:
        found = [float(given[n]) for n in names]
    except (KeyError, ValueError):
        found = [math.nan]
    if not all(math.isfinite(v) and abs(v) < 2**31 for v in found):
        raise InputError("value.not_one_of", entry=", ".join(names), given=str(dict(given))[:80], known=["1.5"])
    return found


def _band(data: Any, band: int, window: tuple[float, ...], shape: tuple[int, int]) -> tuple[Array, Mask]:
    """A band in a window, and where it is known; overviews are used where the screen is coarser."""
    z = np.full(shape, np.nan)
    within, at = _inside(data, window, shape)
    if at is not None:
        read = data.read(band, window=at, out_shape=z[within].shape, masked=True)
        scale, offset = scale_and_offset(data, band)
        z[within] = np.ma.filled(read.astype(float), np.nan) * scale + offset
    return z, np.isfinite(z)


def _colours(data: Any, window: tuple[float, ...], shape: tuple[int, int]) -> Array:
    """Red, green, blue and whether there is anything; grey where a raster has one band."""
    out = np.zeros((*shape, 4), np.uint8)
    within, at = _inside(data, window, shape)
    if at is None:
        return out
    size = out[within].shape[:2]
    bands = [1, 2, 3] if data.count >= 3 else [1, 1, 1]
    values = np.ma.filled(data.read(bands, window=at, out_shape=(3, *size), masked=True), 0)
    if values.dtype != np.uint8:  # 16 bit
        values = (values.astype(float) / max(float(values.max()), 1.0) * 255).astype(np.uint8)
    out[(*within, slice(3))] = np.moveaxis(values, 0, -1)
    out[(*within, 3)] = data.dataset_mask(window=at, out_shape=size)
    return out


def _inside(data: Any, window: tuple[float, ...], shape: tuple[int, int]) -> tuple[tuple[slice, slice], Any]:
    """The part of the screen (rows, columns) that lies within a raster, and its window there; None: there is none."""
    left, top, width, height = window
    part, place = list[slice](), list[tuple[float, float]]()
    for begin, size, end, count in ((top, height, data.height, shape[0]), (left, width, data.width, shape[1])):
        step = size / count
        first = max(0, math.ceil(-begin / step - 1e-9))
        last = min(count, math.floor((end - begin) / step + 1e-9))
        if last <= first:
            return (slice(0), slice(0)), None
        part.append(slice(first, last))
        place.append((max(begin + first * step, 0.0), (last - first) * step))
    (y, h), (x, w) = place
    return (part[0], part[1]), raster_library().windows.Window(x, y, w, h)


def _value(file: Path, column: float, row: float) -> float | None:
    """The first band at a pixel; None where it is unknown or outside."""
    with _opened(file) as data:
        if not (0 <= column < data.width and 0 <= row < data.height):
            return None
        z, known = _band(data, 1, (math.floor(column), math.floor(row), 1, 1), (1, 1))
        return float(z[0, 0]) if known[0, 0] else None
