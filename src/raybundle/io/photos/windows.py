"""Windows of a large TIFF: pixels are read where they are needed, so that memory does not grow with the image.

Strips or tiles that are not compressed are taken from the file as
they are, others are handed to OpenCV's decoder one by one, each as a small TIFF of its own (decision 13).
"""

from __future__ import annotations

import struct
from collections import OrderedDict
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.tiff import tiff_tags
from raybundle.numerics.arrays import Array

WIDTH, HEIGHT, BITS, COMPRESSION, PHOTOMETRIC = 256, 257, 258, 259, 262
STRIP_OFFSETS, SAMPLES, ROWS_PER_STRIP, STRIP_COUNTS, PLANAR, PREDICTOR = 273, 277, 278, 279, 284, 317
TILE_WIDTH, TILE_HEIGHT, TILE_OFFSETS, TILE_COUNTS = 322, 323, 324, 325
EXTRA_SAMPLES, SAMPLE_FORMAT, JPEG_TABLES = 338, 339, 347
WRITTEN = {3: "H", 4: "I", 7: "B"}
"""Types of values, in the notation of `struct`."""
HELD_BYTES = 64e6
"""Decoded strips or tiles that are held for the next window."""


@dataclass(slots=True)
class Windows:
    """An opened TIFF of whole numbers, 8 or 16 bits, grey or of several bands (their mean is taken)."""

    path: Path
    order: str
    tags: dict[int, tuple[float, ...]]
    width_px: int
    height_px: int
    bits: int
    samples: int
    """Bands in one strip or tile."""
    segment: tuple[int, int]
    """Width and height of a strip or tile."""
    offsets: tuple[int, ...]
    counts: tuple[int, ...]
    held: OrderedDict[int, Array] = field(default_factory=OrderedDict[int, Array])
    lock: Lock = field(default_factory=Lock)

    @classmethod
    def of(cls, path: Path) -> Windows:
        """Read the directory; raises InputError for what cannot be read by windows, or is not whole."""
        order, t = tiff_tags(path)

        def one(tag: int, default: int) -> int:
            return int(t.get(tag, (default,))[0])

        width, height = one(WIDTH, 0), one(HEIGHT, 0)
        bits, form = set(t.get(BITS, (1,))), set(t.get(SAMPLE_FORMAT, (1,)))
        tiled = TILE_OFFSETS in t
        offsets, counts = (t.get(a if tiled else b, ()) for a, b in
                           ((TILE_OFFSETS, STRIP_OFFSETS), (TILE_COUNTS, STRIP_COUNTS)))  # fmt: skip
        segment = (
            (one(TILE_WIDTH, 0), one(TILE_HEIGHT, 0)) if tiled else (width, min(one(ROWS_PER_STRIP, height), height))
        )
        if bits not in ({8}, {16}) or form != {1}:
            raise InputError(
                "tiff.pixel_format", bits=[int(b) for b in sorted(bits)], format=[int(f) for f in sorted(form)],
                file=path,
            )  # fmt: skip
        if min(width, height, *segment) < 1 or len(offsets) != len(counts) or not offsets:
            raise InputError("tiff.directory_damaged", file=path)
        samples = one(SAMPLES, 1) if one(PLANAR, 1) == 1 else 1
        found = cls(
            path=path, order=order, tags=t, width_px=width, height_px=height, bits=int(bits.pop()), samples=samples,
            segment=segment, offsets=tuple(int(v) for v in offsets), counts=tuple(int(v) for v in counts),
        )  # fmt: skip
        across, down = found.grid
        if len(offsets) < across * down:
            raise InputError("tiff.too_few_tiles", n=len(offsets), needed=across * down, file=path)
        ends = max(a + b for a, b in zip(found.offsets, found.counts, strict=True))
        if ends > path.stat().st_size:
            raise InputError("tiff.ends_early", byte=ends, file=path)
        return found

    @property
    def grid(self) -> tuple[int, int]:
        """Strips or tiles across and down."""
        return -(-self.width_px // self.segment[0]), -(-self.height_px // self.segment[1])

    def read(self, x0: int, y0: int, x1: int, y1: int) -> Array:
        """Grey values (y1 - y0, x1 - x0), uint8 or uint16, of a window within the image."""
        result = np.zeros((y1 - y0, x1 - x0), np.uint8 if self.bits == 8 else np.uint16)
        w, h = self.segment
        for row in range(y0 // h, -(-y1 // h)):
            for column in range(x0 // w, -(-x1 // w)):
                top, left = row * h, column * w
                a, b = max(y0, top), min(y1, top + h)
                c, d = max(x0, left), min(x1, left + w)
                part = self._part(row * self.grid[0] + column, a - top, b - top)
                result[a - y0 : b - y0, c - x0 : d - x0] = part[:, c - left : d - left]
        return result

    def _part(self, k: int, first: int, last: int) -> Array:
        """Rows of a strip or tile, grey."""
        if int(self.tags.get(COMPRESSION, (1,))[0]) == 1:
            return self._grey(self._plain(k, first, last))
        with self.lock:
            if k in self.held:
                self.held.move_to_end(k)
                return self.held[k][first:last]
        pixels = self._grey(self.decoded(k))
        with self.lock:
            self.held[k] = pixels
            while len(self.held) > 1 and sum(a.nbytes for a in self.held.values()) > HELD_BYTES:
                self.held.popitem(last=False)
        return pixels[first:last]

    def _rows(self, k: int) -> int:
        """Rows in a strip or tile: the last strip is shorter."""
        if TILE_OFFSETS in self.tags:
            return self.segment[1]
        return min(self.segment[1], self.height_px - (k // self.grid[0]) * self.segment[1])

    def _plain(self, k: int, first: int, last: int) -> Array:
        """Rows of pixels that are not compressed."""
        kind = np.dtype(np.uint8 if self.bits == 8 else self.order + "u2")
        row = self.segment[0] * self.samples * kind.itemsize
        with self.path.open("rb") as file:
            file.seek(self.offsets[k] + first * row)
            data = file.read((last - first) * row)
        if len(data) < (last - first) * row:
            raise InputError("tiff.pixels_end_early", file=self.path)
        return np.frombuffer(data, kind).reshape(last - first, self.segment[0], self.samples)

    def decoded(self, k: int, *, rgb: bool = False) -> Array:
        """A compressed strip or tile, by OpenCV as a TIFF of its own; rgb: red first, where it has three bands."""
        import cv2

        with self.path.open("rb") as file:
            file.seek(self.offsets[k])
            data = file.read(self.counts[k])
        found: Array | None = cv2.imdecode(np.frombuffer(self._alone(k, data), np.uint8), cv2.IMREAD_UNCHANGED)
        if found is None or found.shape[:2] != (self._rows(k), self.segment[0]):
            raise InputError(
                "tiff.pixels_unreadable", compression=int(self.tags[COMPRESSION][0]), bands=self.samples,
                bits=self.bits, file=self.path,
            )  # fmt: skip
        found = found.reshape(*found.shape[:2], -1)
        return found[..., ::-1] if rgb and found.shape[2] == 3 else found

    def _alone(self, k: int, data: bytes) -> bytes:
        """A classic TIFF that holds one strip or tile, compressed as it is."""
        t, n = self.tags, self.samples
        photometric = int(t.get(PHOTOMETRIC, (1,))[0])
        if photometric < 5:  # how bands are shown is of no matter, but the decoder wants it to go with their number
            photometric = 1 if n < 3 else 2
        entries: dict[int, tuple[int, tuple[int, ...]]] = {
            WIDTH: (4, (self.segment[0],)),
            HEIGHT: (4, (self._rows(k),)),
            BITS: (3, (self.bits,) * n),
            COMPRESSION: (3, (int(t[COMPRESSION][0]),)),
            PHOTOMETRIC: (3, (photometric,)),
            STRIP_OFFSETS: (4, (0,)),
            SAMPLES: (3, (n,)),
            ROWS_PER_STRIP: (4, (self._rows(k),)),
            STRIP_COUNTS: (4, (len(data),)),
            PLANAR: (3, (1,)),
            PREDICTOR: (3, (int(t.get(PREDICTOR, (1,))[0]),)),
            SAMPLE_FORMAT: (3, (1,) * n),
        }
        if spare := n - (1 if n < 3 else 3):
            entries[EXTRA_SAMPLES] = (3, (0,) * spare)
        if JPEG_TABLES in t:
            entries[JPEG_TABLES] = (7, tuple(int(v) for v in t[JPEG_TABLES]))
        return tiff_of_segment(self.order, entries, data)

    def _grey(self, pixels: Array) -> Array:
        """The mean of the bands; MinIsWhite turned over."""
        kind = np.uint8 if self.bits == 8 else np.uint16
        grey = pixels[..., 0] if pixels.shape[2] == 1 else np.round(pixels[..., :3].mean(axis=2))
        if int(self.tags.get(PHOTOMETRIC, (1,))[0]) == 0:
            grey = (1 << self.bits) - 1 - grey.astype(np.int64)
        return np.ascontiguousarray(grey, kind)


def tiff_of_segment(order: str, entries: dict[int, tuple[int, tuple[int, ...]]], data: bytes) -> bytes:
    """A classic TIFF of one strip.

    order    "<" or ">"
    entries  tag -> type and values; the place of the strip is put in
    """
    after = 8 + 2 + 12 * len(entries) + 4
    extra, rows = b"", b""
    for tag, (kind, values) in sorted(entries.items()):
        packed = struct.pack(f"{order}{len(values)}{WRITTEN[kind]}", *values)
        if len(packed) <= 4:
            packed = packed.ljust(4, b"\0")
        else:
            packed, extra = (
                struct.pack(order + "I", after + len(extra)),
                extra + packed + b"\0" * (len(packed) % 2),
            )
        rows += struct.pack(order + "HHI", tag, kind, len(values)) + packed
    place = struct.pack(order + "I", after + len(extra))
    at = 12 * sorted(entries).index(STRIP_OFFSETS) + 8
    rows = rows[:at] + place + rows[at + 4 :]
    head = (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", 8)
    return head + struct.pack(order + "H", len(entries)) + rows + b"\0\0\0\0" + extra + data
