"""Bands of TIFFs as GDAL writes them: 8 to 64 bits, signed, unsigned, floating point, any number of bands, BigTIFF.

Strips and tiles may hold all bands or one; compressed without loss (LZW, deflate, Zstandard, packbits, LZMA) or by
JPEG.  What is compressed otherwise, and JPEG 2000, is read through rasterio (extra `geo`) where it is installed.

What is matched: the luminance of red, green and blue where the file names these colours, otherwise the first band.
Whole numbers from 0 to 65 535 stay as they stand.  Other numbers become 16 bits: their 0.1 and 99.9 % quantiles are
0 and 65 535; not finite values and GDAL's nodata are 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.photos.windows import (
    BITS,
    COMPRESSION,
    EXTRA_SAMPLES,
    HEIGHT,
    PHOTOMETRIC,
    PLANAR,
    PREDICTOR,
    ROWS_PER_STRIP,
    SAMPLE_FORMAT,
    SAMPLES,
    STRIP_COUNTS,
    STRIP_OFFSETS,
    TILE_COUNTS,
    TILE_HEIGHT,
    TILE_OFFSETS,
    TILE_WIDTH,
    WIDTH,
    Windows,
    tiff_of_segment,
)
from raybundle.io.raster_library import found_raster_library, raster_errors, raster_library
from raybundle.io.reading.tiff import Opened, Tiff, tiff_tags
from raybundle.io.reading.words import number_of
from raybundle.numerics.arrays import Array

NONE, JPEG = 1, 7
LOSSLESS = {5, 8, 32773, 32946, 34925, 50000}
"""LZW, deflate (two numbers), packbits, LZMA, Zstandard"""
LETTERS = {1: "u", 2: "i", 3: "f"}
RGB, YCBCR = 2, 6
GREY = np.array([0.299, 0.587, 0.114])
QUANTILES = (0.1, 99.9)
SAMPLE = 1_000_000
"""Pixels of which quantiles are taken"""
DEEPEST = 65535
ROWS = 1024
"""Rows that are scaled at once"""
LARGEST = 1 << 32
"""Bytes of a strip or tile"""
MAP = {33550, 34264}
"""Tags that place a raster in a map."""
NODATA = 42113


@dataclass(frozen=True, slots=True, kw_only=True)
class BandImage:
    """What the directory of a raster states."""

    path: Path
    width_px: int
    height_px: int
    bands: int
    dtype: np.dtype[Any]
    colours: tuple[int, ...]
    """Bands of red, green and blue, or the band that is matched; from 0"""
    tags: dict[int, tuple[float, ...]]
    """Of a TIFF; empty: it is read through rasterio"""
    order: str = "<"

    @property
    def bits(self) -> int:
        """Of the grey values that are read."""
        return 8 if self.dtype == np.uint8 else 16

    @property
    def remarks(self) -> tuple[str, ...]:
        """Which band is matched, and how its numbers become grey values."""
        scaled = self.dtype not in (np.dtype(np.uint8), np.dtype(np.uint16))
        if not scaled and self.bands in {1, len(self.colours)}:
            return ()
        return (
            phrase(
                "photo_entry.bands", bands=self.bands, band=self.colours[0] + 1, colour=len(self.colours) == len(GREY),
                numbers=str(self.dtype), scaled=scaled,
            ),
        )  # fmt: skip


def band_image(path: Path) -> BandImage | None:
    """The raster in a TIFF that the usual decoders do not read, or not rightly; None for other files.

    raises  InputError where its pixels are of no kind that is read
    """
    with path.open("rb") as file:
        big = file.read(4)[2:] in {b"+\0", b"\0+"}
    order, t = tiff_tags(path)

    def one(tag: int, default: int) -> int:
        return int(t.get(tag, (default,))[0])

    bits, formats = {int(b) for b in t.get(BITS, (1,))}, {int(f) for f in t.get(SAMPLE_FORMAT, (1,))}
    n, planar, colour = one(SAMPLES, 1), one(PLANAR, 1) == 2, one(PHOTOMETRIC, 1)
    together = n == 1 or not planar
    bytes_usual = bits == {8} and (n == 1 or (n == 2 and together) or (n in {3, 4} and colour > 1))
    transparent = n == 4 and one(EXTRA_SAMPLES, 0) > 0
    words_usual = bits == {16} and (n == 1 or (colour == RGB and (n == 3 or transparent))) and one(PLANAR, 1) == 1
    usual = formats == {1} and not big and (bytes_usual or words_usual or max(bits, default=1) < 8)
    if usual or not t:
        return None
    if len(bits) != 1 or len(formats) != 1 or not bits <= {8, 16, 32, 64} or not formats <= {*LETTERS}:
        return None
    if formats == {3} and bits == {8}:
        return None
    if formats == {3} and MAP & t.keys():
        raise InputError("photograph.map_raster", bits=max(bits), file=path)
    colours = (0, 1, 2) if colour in {RGB, YCBCR} and n >= len(GREY) else (0,)
    dtype = np.dtype(f"{order}{LETTERS[formats.pop()]}{bits.pop() // 8}")
    return BandImage(path=path, width_px=one(WIDTH, 0), height_px=one(HEIGHT, 0), bands=n, colours=colours,
                     dtype=dtype.newbyteorder("="), tags=t, order=order)  # fmt: skip


def jpeg2000_image(path: Path) -> BandImage:
    """The raster in a JPEG 2000; raises InputError where rasterio is not installed or cannot open it."""
    with raster_errors(path), raster_library(path).open(path) as raster:
        colours = (0, 1, 2) if raster.count >= len(GREY) and raster.colorinterp[0].name == "red" else (0,)
        return BandImage(path=path, width_px=raster.width, height_px=raster.height, bands=raster.count,
                         colours=colours, dtype=np.dtype(raster.dtypes[0]), tags={})  # fmt: skip


def grey_of(image: BandImage) -> Array:
    """Grey values (h, w), uint8 or uint16."""
    bands = _numbers(image)
    if len(bands) == 1:
        return bands[0]
    return np.round(np.tensordot(GREY, bands, 1)).astype(bands.dtype)


def colour_of(image: BandImage) -> Array:
    """Values (h, w, 1 or 3), uint8 or uint16."""
    return np.ascontiguousarray(np.moveaxis(_numbers(image), 0, -1))


def _numbers(image: BandImage) -> Array:
    """(k, h, w) the bands that are shown as whole numbers of 8 or 16 bits."""
    bands = _bands(image)
    nodata = _nodata(image)
    if int(image.tags.get(PHOTOMETRIC, (1,))[0]) == 0:  # 0 is white
        bands = np.iinfo(bands.dtype).max - bands if bands.dtype.kind == "u" else -bands
    if bands.dtype.kind == "u" and bands.dtype.itemsize <= 2:
        return bands
    good = np.isfinite(bands) if nodata is None else np.isfinite(bands) & (bands != nodata)
    known = bands[good]
    if not known.size:
        return np.zeros(bands.shape, np.uint16)
    if bands.dtype.kind in "iu" and known.min() >= 0 and known.max() <= DEEPEST:
        return np.where(good, bands, 0).astype(np.uint16)
    low, high = np.percentile(known[:: max(1, known.size // SAMPLE)].astype(float), QUANTILES)
    if high <= low:
        low, high = float(known.min()), float(known.max())
    scale = DEEPEST / (high - low) if high > low else 0.0
    grey = np.zeros(bands.shape, np.uint16)
    for top in range(0, image.height_px, ROWS):  # all at once they would be held as 64 bits
        rows = slice(top, top + ROWS)
        part = np.where(good[:, rows], bands[:, rows], low)
        grey[:, rows] = np.where(good[:, rows], np.clip(np.round((part - low) * scale), 0, DEEPEST), 0)
    return grey


def _nodata(image: BandImage) -> float | None:
    """GDAL's value of pixels without data; None: there is none."""
    if not image.tags:
        return None
    with image.path.open("rb") as file:
        tiff = Tiff.of(Opened(image.path, file))
        at = None if tiff is None else tiff.first
        found = [] if tiff is None or at is None else tiff.entries(at, tiff.count(at) or 0)
        raw = next((tiff.raw(e) for e in found if e.tag == NODATA), None) if tiff else None
    return number_of((raw or b"").split(b"\0")[0].decode("ascii", "replace").strip())


def _bands(image: BandImage) -> Array:
    """(k, h, w) the bands that are shown, as they stand in the file."""
    t = image.tags
    kind = int(t.get(COMPRESSION, (1,))[0])
    own = kind in {NONE, *LOSSLESS} or (kind == JPEG and image.dtype == np.uint8)
    if t and own:
        return _of_segments(image, kind)
    if t and found_raster_library() is None:
        raise InputError("tiff.compression", compression=kind, file=image.path)
    with raster_errors(image.path), raster_library(image.path).open(image.path) as raster:
        return raster.read([c + 1 for c in image.colours])


def _of_segments(image: BandImage, kind: int) -> Array:
    t, h, w = image.tags, image.height_px, image.width_px
    tiled = TILE_OFFSETS in t
    offsets, counts = (t.get(k, ()) for k in ((TILE_OFFSETS, TILE_COUNTS) if tiled else (STRIP_OFFSETS, STRIP_COUNTS)))
    side = (
        (int(t[TILE_WIDTH][0]), int(t[TILE_HEIGHT][0])) if tiled else (w, min(int(t.get(ROWS_PER_STRIP, (h,))[0]), h))
    )
    planar = int(t.get(PLANAR, (1,))[0]) == 2 and image.bands > 1
    bytes_each = side[0] * side[1] * image.dtype.itemsize * (1 if planar else image.bands)
    if min(side) < 1 or len(offsets) != len(counts) or bytes_each > LARGEST:
        raise InputError("tiff.directory_damaged", file=image.path)
    across, down = -(-w // side[0]), -(-h // side[1])
    if len(offsets) < across * down * (image.bands if planar else 1):
        raise InputError("tiff.too_few_tiles", n=len(offsets), needed=across * down, file=image.path)
    result = np.zeros((len(image.colours), h, w), image.dtype)
    windows = Windows.of(image.path) if kind == JPEG else None
    with image.path.open("rb") as file:
        for k in range(across * down):
            top, left = k // across * side[1], k % across * side[0]
            rows = side[1] if tiled else min(side[1], h - top)
            for j, band in enumerate(image.colours):
                if j and not planar:
                    break
                at = k + (band * across * down if planar else 0)
                if not counts[at]:
                    continue  # GDAL leaves out tiles without data
                if windows is not None:
                    pixels = windows.decoded(at, rgb=len(image.colours) > 1)
                else:
                    file.seek(int(offsets[at]))
                    data = file.read(int(counts[at]))
                    pixels = _pixels(image, data, kind, (rows, side[0], 1 if planar else image.bands))
                part = np.moveaxis(pixels, -1, 0)[:, : h - top, : w - left]
                into = slice(j, j + 1) if planar else slice(None)
                chosen = part if planar else part[list(image.colours)]
                result[into, top : top + part.shape[1], left : left + part.shape[2]] = chosen
    return result


def _pixels(image: BandImage, data: bytes, kind: int, shape: tuple[int, int, int]) -> Array:
    """(rows, width, bands) of the bytes of a strip or tile."""
    rows, width, bands = shape
    size = image.dtype.itemsize
    length = width * bands * size
    raw = np.frombuffer(data, np.uint8) if kind == NONE else _unpacked(image, data, kind, rows, length)
    if len(raw.reshape(-1)) < rows * length:
        raise InputError("tiff.pixels_end_early", file=image.path)
    raw = raw.reshape(-1)[: rows * length]
    stored = image.dtype.newbyteorder("<" if image.order == "<" else ">")
    predictor = int(image.tags.get(PREDICTOR, (1,))[0]) if kind != NONE else 1
    if predictor == 3:  # bytes of floating point numbers, the highest first, as differences (Adobe TIFF note 3)
        planes = np.cumsum(raw.reshape(rows, -1, bands), axis=1, dtype=np.uint8).reshape(rows, size, width * bands)
        raw = np.ascontiguousarray(np.swapaxes(planes, 1, 2)).reshape(-1)
        stored = image.dtype.newbyteorder(">")
    pixels = raw.view(stored).reshape(rows, width, bands).astype(image.dtype)
    if predictor == 2:
        whole = np.dtype(f"u{size}")
        pixels = np.cumsum(pixels.view(whole), axis=1, dtype=whole).view(image.dtype)
    return pixels


def _unpacked(image: BandImage, data: bytes, kind: int, rows: int, length: int) -> Array:
    """The bytes of a strip or tile that is compressed without loss: it is decoded as a grey TIFF of bytes."""
    from io import BytesIO

    from PIL import TiffImagePlugin

    entries: dict[int, tuple[int, tuple[int, ...]]] = {
        WIDTH: (4, (length,)), HEIGHT: (4, (rows,)), BITS: (3, (8,)), COMPRESSION: (3, (kind,)), PHOTOMETRIC: (3, (1,)),
        STRIP_OFFSETS: (4, (0,)), SAMPLES: (3, (1,)), ROWS_PER_STRIP: (4, (rows,)), STRIP_COUNTS: (4, (len(data),)),
    }  # fmt: skip
    try:
        with TiffImagePlugin.TiffImageFile(BytesIO(tiff_of_segment("<", entries, data))) as picture:
            return np.asarray(picture)
    except Exception:  # noqa: BLE001  (decoders raise anything on damaged bytes)
        raise InputError(
            "tiff.pixels_unreadable", compression=kind, bands=image.bands, bits=8 * image.dtype.itemsize,
            file=image.path,
        ) from None  # fmt: skip
