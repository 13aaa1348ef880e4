"""Photographs as tiles of reduced copies, made when they are looked at, kept in a folder that goes with the server.

A copy of level n is reduced by 2^n.  A photograph is decoded once; its levels lie in memory-mapped files, so that the
server's memory does not grow with what was looked at.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path

import cv2
import numpy as np
from PIL import Image

from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo, read_colour, read_photo
from raybundle.numerics.arrays import Array

SIDE = 512
MOST_BYTES = 6 * 1024**3
"""Of decoded photographs on disk; the one that was looked at longest ago leaves."""
QUALITY = 88
BAND = 1024
"""Rows that are reduced at once; even."""


def levels(width: int, height: int) -> int:
    """Number of levels: the last is the first that fits into one tile."""
    n = 1
    while max(width, height) > SIDE:
        width, height, n = -(-width // 2), -(-height // 2), n + 1
    return n


@dataclass(slots=True)
class _Pyramid:
    levels: list[Array]
    size: int
    lock: threading.Lock = field(default_factory=threading.Lock)


@dataclass(slots=True)
class Tiles:
    """Tiles of photographs by their number."""

    folder: Path
    """for decoded photographs; goes with the server"""
    paths: dict[int, Path]
    sizes: dict[int, tuple[int, int]] = field(default_factory=dict[int, tuple[int, int]])
    """width and height that a photograph must have"""
    most_bytes: int = MOST_BYTES
    _pyramids: OrderedDict[int, _Pyramid] = field(default_factory=OrderedDict[int, "_Pyramid"])
    _photos: dict[int, Photo] = field(default_factory=dict[int, Photo])
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _begun: dict[int, threading.Lock] = field(default_factory=dict[int, threading.Lock])

    def photo(self, image: int) -> Photo:
        """What a photograph's file states of itself; raises InputError where there is none."""
        if image not in self._photos:
            path = self.paths.get(image)
            if path is None:
                raise InputError("studio.photograph_file_unknown")
            photo = read_photo(path)
            size = photo.width_px, photo.height_px
            if self.sizes.get(image, size) != size:
                raise InputError(
                    "photograph.other_size",
                    width_px=size[0],
                    height_px=size[1],
                    block_width_px=self.sizes[image][0],
                    block_height_px=self.sizes[image][1],
                    file=path,
                )
            self._photos[image] = photo
        return self._photos[image]

    def tile(self, image: int, level: int, column: int, row: int) -> bytes:
        """A tile as JPEG; raises InputError for one that is not there, or a photograph that cannot be read."""
        every = self._pyramid(image).levels
        if not 0 <= level < len(every):
            raise InputError("studio.no_level", level=level, n=len(every))
        copy = every[level]
        part = copy[SIDE * row : SIDE * (row + 1), SIDE * column : SIDE * (column + 1)]
        if min(row, column) < 0 or not part.size:
            raise InputError("studio.tile_outside", across=column, down=row, level=level)
        file = BytesIO()
        Image.fromarray(np.ascontiguousarray(part)).save(file, "JPEG", quality=QUALITY)
        return file.getvalue()

    def pixels(self, image: int) -> Array:
        """The photograph as stored (h, w, 3), to be read in parts."""
        return self._pyramid(image).levels[0]

    def _pyramid(self, image: int) -> _Pyramid:
        with self._lock:
            found = self._pyramids.get(image)
            if found is not None:
                self._pyramids.move_to_end(image)
                return found
            begun = self._begun.setdefault(image, threading.Lock())
        with begun:  # two tiles of one photograph decode it once
            with self._lock:
                found = self._pyramids.get(image)
            if found is None:
                found = self._made(image)
                with self._lock:
                    self._pyramids[image] = found
                    self._make_room(image)
        return found

    def _made(self, image: int) -> _Pyramid:
        photo = self.photo(image)
        file = self.folder / f"{image}-0.npy"
        np.save(file, read_colour(photo))
        made = [np.load(file, mmap_mode="r")]
        for level in range(1, levels(photo.width_px, photo.height_px)):
            made.append(_halved(made[-1], self.folder / f"{image}-{level}.npy"))
        return _Pyramid(made, sum(int(a.nbytes) for a in made))

    def _make_room(self, latest: int) -> None:
        while sum(p.size for p in self._pyramids.values()) > self.most_bytes and len(self._pyramids) > 1:
            oldest = next(k for k in self._pyramids if k != latest)
            self._remove(oldest)

    def forget(self) -> None:
        """Remove all copies: nobody asks for them any more."""
        with self._lock:
            for image in [*self._pyramids]:
                self._remove(image)

    def _remove(self, image: int) -> None:
        """Remove a copy; what still reads it keeps its mapping, the file goes with the last of them."""
        gone = self._pyramids.pop(image)
        for level in range(len(gone.levels)):
            (self.folder / f"{image}-{level}.npy").unlink(missing_ok=True)


def _halved(source: Array, file: Path) -> Array:
    """A copy of half the size in a file of its own, made in bands.

    Each pixel is the mean of four, so that places stay where they are; a last odd row or column is repeated.
    """
    h, w = source.shape[:2]
    target = np.lib.format.open_memmap(file, mode="w+", dtype=np.uint8, shape=(-(-h // 2), -(-w // 2), 3))
    for top in range(0, h, BAND):
        band = np.ascontiguousarray(source[top : top + BAND])
        even = cv2.copyMakeBorder(band, 0, len(band) % 2, 0, w % 2, cv2.BORDER_REPLICATE)
        size = even.shape[1] // 2, len(even) // 2
        target[top // 2 : top // 2 + size[1]] = cv2.resize(even, size, interpolation=cv2.INTER_AREA)
    target.flush()
    del target
    return np.load(file, mmap_mode="r")
