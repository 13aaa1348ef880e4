"""Masks of photographs: which pixels are not to be measured in.

Named as the programs name them that make them: COLMAP takes `photo.jpg.png` in a folder that repeats those of the
photographs, and no feature where it is 0 (colmap.github.io/faq.html, "Mask image regions"); Metashape writes
`photo_mask.png` by its usual template {filename}_mask, or `photo.png`, black where the photograph is masked (Metashape
manual, "Using masks").  So 0 is masked out and anything else is used.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock

import numpy as np

from raybundle.errors import InputError
from raybundle.io.photos.container import Unusable, decode, read_header
from raybundle.io.photos.photo import LIMIT_PIXELS, Photo, shown, stored_from_turned
from raybundle.io.reading.files import guarded
from raybundle.numerics.arrays import Array, Mask

DEPTH = 4
"""Folders of a photograph's path that a mask's path may repeat."""
HELD = 4
"""Distances to masked pixels that are held: they are asked for photograph by photograph."""


@dataclass(frozen=True, slots=True, kw_only=True)
class _File:
    path: Path
    sha256: str


@dataclass(slots=True)
class Masks:
    """The masks of some photographs; pixels are read when they are asked for."""

    photos: tuple[Photo, ...]
    files: dict[str, _File] = field(default_factory=dict[str, _File])
    """By the photograph's name"""
    refused: tuple[tuple[str, str], ...] = ()
    """Photographs whose mask cannot be used, and why"""
    _held: dict[int, Array] = field(default_factory=dict[int, Array])
    _lock: Lock = field(default_factory=Lock)

    def key(self, photo: Photo) -> str:
        """What a product that heeds the mask of a photograph depends on; "" without a mask."""
        file = self.files.get(photo.name)
        return "" if file is None else file.sha256

    @property
    def missing(self) -> tuple[str, ...]:
        """Photographs without a mask."""
        lost = {n for n, _ in self.refused}
        return tuple(p.name for p in self.photos if p.name not in self.files and p.name not in lost)

    def of(self, photo: Photo) -> Array | None:
        """(h, w) True where the photograph, as stored, may be measured in; None: everywhere."""
        file = self.files.get(photo.name)
        return None if file is None else _read(file.path, photo)

    def visible(self, photo: Photo, xy_px: Array, radius_px: Array) -> Mask:
        """(n,) whether no masked pixel lies within a radius (n,) of places (n, 2) of a photograph."""
        far = self._distance(photo)
        if far is None:
            return np.ones(len(xy_px), bool)
        x, y = np.clip(np.floor(xy_px).astype(int), 0, [photo.width_px - 1, photo.height_px - 1]).T
        return np.asarray(far[y, x] > radius_px)

    def _distance(self, photo: Photo) -> Array | None:
        """(h, w) from each pixel to the nearest masked one [px]."""
        import cv2  # noqa: PLC0415  (slow to load)

        if photo.name not in self.files:
            return None
        at = next(i for i, p in enumerate(self.photos) if p.name == photo.name)
        with self._lock:
            if at in self._held:
                return self._held[at]
        free = _read(self.files[photo.name].path, photo)
        found = cv2.distanceTransform(free.astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5)
        if free.all():  # there is no masked pixel to be near to
            found = np.full(free.shape, np.inf, np.float32)
        with self._lock:
            while len(self._held) >= HELD:
                self._held.pop(next(iter(self._held)))
            self._held[at] = found
        return found


def find_masks(folder: Path, photos: Sequence[Photo]) -> Masks:
    """The masks of photographs in a folder.

    raises  InputError where there is no such folder, or a mask for none of the photographs in it
    A mask that cannot be used costs itself alone: its photograph is used whole, and it is listed with the reason.
    """
    if not folder.is_dir():
        raise InputError("there is no such folder of masks", file=folder)
    files: dict[str, _File] = {}
    refused: list[tuple[str, str]] = []
    for photo in photos:
        path = _mask_of(folder, photo)
        if path is None:
            continue
        try:
            _check(path, photo)
            with guarded(path), path.open("rb") as file:
                files[photo.name] = _File(path=path, sha256=hashlib.file_digest(file, "sha256").hexdigest())
        except InputError as error:
            refused.append((photo.name, str(error)))
    if photos and not files and not refused:
        first = photos[0]
        raise InputError(
            f"holds no mask of any of the {len(photos)} photographs; a mask is named {first.path.name}.png (COLMAP), "
            f"{first.path.stem}_mask.png or {first.path.stem}.png (Metashape), 0 where the photograph is masked out",
            file=folder,
        )
    return Masks(photos=tuple(photos), files=files, refused=tuple(refused))


def _mask_of(folder: Path, photo: Photo) -> Path | None:
    """The mask of a photograph: its path repeated from the longest part to the name alone."""
    parts = photo.path.absolute().parts
    least = len(Path(photo.name).parts)  # names that repeat are told apart by their folders
    for k in range(min(DEPTH, len(parts) - 1), 0, -1):
        if k < least:
            break
        base = folder.joinpath(*parts[-k:])
        for name in (f"{base.name}.png", f"{base.stem}_mask.png", f"{base.stem}.png"):
            path = base.with_name(name)
            if path.is_file() and not path.samefile(photo.path):
                return path
    return None


def _check(path: Path, photo: Photo) -> tuple[int, int, bool]:
    """Width and height of a mask, and whether it is that of the upright picture; InputError where it does not fit."""
    try:
        header = read_header(path, limit_pixels=LIMIT_PIXELS)
    except Unusable as error:
        raise InputError(f"cannot be used as a mask: {error}", file=shown(path)) from None
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror or error}", file=shown(path)) from None
    w, h = header.width_px, header.height_px
    for size, upright in (((photo.width_px, photo.height_px), False), (photo.upright_size, True)):
        if size[0] * h == size[1] * w and (w % size[0] == 0 or size[0] % w == 0):
            return w, h, upright
    raise InputError(
        f"the mask has {w} x {h} px, the photograph {photo.name} {photo.width_px} x {photo.height_px}: not one and the "
        "same picture at a whole multiple or part of its size; the photograph is used whole",
        file=shown(path),
    )


def _read(path: Path, photo: Photo) -> Mask:
    """(h, w) of the photograph as stored."""
    import cv2  # noqa: PLC0415

    _, _, upright = _check(path, photo)
    try:
        grey = decode(path, read_header(path, limit_pixels=LIMIT_PIXELS).kind, "grey")
    except Unusable as error:
        raise InputError(f"cannot be used as a mask: {error}", file=shown(path)) from None
    free = (grey != 0).astype(np.uint8)
    if upright:
        free = stored_from_turned(free, photo.orientation)
    if free.shape != (photo.height_px, photo.width_px):
        free = cv2.resize(free, (photo.width_px, photo.height_px), interpolation=cv2.INTER_NEAREST)
    return np.asarray(free > 0)
