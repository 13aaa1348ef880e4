"""Masks of photographs: which pixels are not to be measured in.

Named as the programs name them that make them: COLMAP takes `photo.jpg.png` in a folder that repeats those of the
photographs, and no feature where it is 0 (colmap.github.io/faq.html, "Mask image regions"); Metashape writes
`photo_mask.png` by its usual template {filename}_mask, or `photo.png`, black where the photograph is masked (Metashape
manual, "Using masks").  So 0 in every channel is masked out and anything else is used; where a mask has an alpha
channel, what is wholly transparent is masked out, too.

Both programs lay a mask on the pixels as stored and read no EXIF orientation.  A mask that was drawn over the picture
shown upright shows so by its shape or by an EXIF orientation of its own; where neither shows, that is to be stated.
"""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock

import numpy as np

from raybundle.errors import InputError, Text, phrase, text_of_error
from raybundle.io.photos.container import SUFFIXES, Header, Unusable, decode_channels, read_header
from raybundle.io.photos.exif import read_tags
from raybundle.io.photos.photo import LIMIT_PIXELS, Photo, shown, stored_from_turned, upright
from raybundle.io.photos.remote import url_of
from raybundle.io.reading.files import guarded
from raybundle.numerics.arrays import Array, Mask

DEPTH = 4
"""Folders of a photograph's path that a mask's path may repeat."""
HELD = 4
"""Distances to masked pixels that are held: they are asked for photograph by photograph."""
READING = 2
"""Raised with every change of how the pixels of a mask are understood: features depend on it."""
ORIENTATION = 274
"""The EXIF tag."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Laid:
    """How the pixels of a mask lie on its photograph."""

    own: int = 1
    """EXIF orientation by which the mask is shown"""
    shown: bool = False
    """whether the mask as shown is one of the photograph as shown, not of its pixels as stored"""
    reported: bool = True
    """False: neither its shape nor an EXIF orientation shows, and the pixels as stored are taken"""


@dataclass(frozen=True, slots=True, kw_only=True)
class MaskFile:
    """The mask of a photograph."""

    path: Path
    sha256: str
    laid: Laid
    free: float
    """Share of the photograph that may be measured in"""


@dataclass(slots=True)
class Masks:
    """The masks of some photographs; pixels are read when they are asked for."""

    photos: tuple[Photo, ...]
    files: dict[str, MaskFile] = field(default_factory=dict[str, MaskFile])
    """By the photograph's name"""
    refused: tuple[tuple[str, str], ...] = ()
    """Photographs whose mask cannot be used, and why"""
    _held: dict[int, Array] = field(default_factory=dict[int, Array])
    _lock: Lock = field(default_factory=Lock)

    @property
    def content(self) -> dict[str, str]:
        """What they are known by."""
        return {p.name: self.key(p) for p in self.photos}

    def key(self, photo: Photo) -> str:
        """What a product that heeds the mask of a photograph depends on; "" without a mask."""
        file = self.files.get(photo.name)
        return "" if file is None else f"{file.sha256}:{READING}"

    @property
    def missing(self) -> tuple[str, ...]:
        """Photographs without a mask."""
        lost = {n for n, _ in self.refused}
        return tuple(p.name for p in self.photos if p.name not in self.files and p.name not in lost)

    @property
    def doubtful(self) -> tuple[Photo, ...]:
        """Photographs that are shown turned and whose mask does not show whether it is turned, too."""
        return tuple(p for p in self.photos if p.name in self.files and not self.files[p.name].laid.reported)

    def with_free(self, share: float) -> tuple[str, ...]:
        """Photographs of which exactly this share is not masked: 0 where all is hidden, 1 where nothing is."""
        return tuple(p.name for p in self.photos if p.name in self.files and self.files[p.name].free == share)

    def of(self, photo: Photo) -> Array | None:
        """(h, w) True where the photograph, as stored, may be measured in; None: everywhere."""
        file = self.files.get(photo.name)
        return None if file is None else _read(file.path, photo, file.laid)

    def visible(self, photo: Photo, xy_px: Array, radius_px: Array) -> Mask:
        """(n,) whether no masked pixel lies within a radius (n,) of places (n, 2) of a photograph."""
        far = self._distance(photo)
        if far is None:
            return np.ones(len(xy_px), bool)
        x, y = np.clip(np.floor(xy_px).astype(int), 0, [photo.width_px - 1, photo.height_px - 1]).T
        return np.asarray(far[y, x] > radius_px)

    def _distance(self, photo: Photo) -> Array | None:
        """(h, w) from each pixel to the nearest masked one [px]."""
        import cv2

        if photo.name not in self.files:
            return None
        at = next(i for i, p in enumerate(self.photos) if p.name == photo.name)
        with self._lock:
            if at in self._held:
                return self._held[at]
        free = _read(self.files[photo.name].path, photo, self.files[photo.name].laid)
        found = cv2.distanceTransform(free.astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5)
        if free.all():  # there is no masked pixel to be near to
            found = np.full(free.shape, np.inf, np.float32)
        with self._lock:
            while len(self._held) >= HELD:
                self._held.pop(next(iter(self._held)))
            self._held[at] = found
        return found


def find_masks(folder: Path, photos: Sequence[Photo]) -> Masks:
    """The masks of photographs in a folder, each decoded once so that what is stated of it is true.

    raises  InputError where there is no such folder, a mask for none of the photographs in it, or masks that leave
            fewer than two photographs to measure in
    A mask that cannot be used costs itself alone: its photograph is used whole, and it is listed with the reason.
    """
    if not folder.is_dir():
        raise InputError("file.missing", file=folder)
    files: dict[str, MaskFile] = {}
    refused: list[tuple[str, str]] = []
    alike: list[tuple[str, str]] = []
    own = {p.path.absolute() for p in photos}
    for photo in photos:
        path = mask_file(folder, photo)
        if path is None:
            other = _named_alike(folder, photo, own)
            alike += [] if other is None else [(photo.name, _alike_text(other, photo))]
            continue
        try:
            files[photo.name] = _examined(path, photo)
        except InputError as error:
            refused.append((photo.name, text_of_error(error)))
    if photos and not files and not refused:
        one = photos[0]
        raise InputError(
            "mask.none_found", n=len(photos), names=_mask_names(one), similar=[name for name, _ in alike] or ["-"],
            file=folder,
        )  # fmt: skip
    found = Masks(photos=tuple(photos), files=files, refused=(*refused, *alike))
    _check_left(folder, found)
    return found


def _check_left(folder: Path, masks: Masks) -> None:
    """Raise InputError where masks hide so much that no two photographs are left."""
    hidden = masks.with_free(0.0)
    n = len(masks.photos)
    if hidden and n >= 2 > n - len(hidden):
        raise InputError("mask.all_hidden", hidden=len(hidden), n=n, names=list(hidden), file=folder)


def _mask_names(photo: Photo) -> list[str]:
    return [f"{photo.path.name}.png", f"{photo.path.stem}_mask.png", f"{photo.path.stem}.png"]


def _alike_text(other: Path, photo: Photo) -> Text:
    return phrase("mask.other_name", name=shown(other).name, names=_mask_names(photo))


def mask_file(folder: Path, photo: Photo) -> Path | None:
    """The mask of a photograph: its path repeated from the longest part to the name alone."""
    parts = photo.path.absolute().parts
    least = len(Path(photo.name).parts)  # names that repeat are distinguished by their folders
    for k in range(min(DEPTH, len(parts) - 1), 0, -1):
        if k < least:
            break
        base = folder.joinpath(*parts[-k:])
        for name in (f"{base.name}.png", f"{base.stem}_mask.png", f"{base.stem}.png"):
            path = base.with_name(name)
            if path.is_file() and (url_of(photo.path) or not path.samefile(photo.path)):
                return path
    return None


def _named_alike(folder: Path, photo: Photo, photos: Collection[Path]) -> Path | None:
    """A picture that differs from the name of a mask by letters' case or by its kind alone."""
    stems = {s.lower() for s in (photo.path.name, f"{photo.path.stem}_mask", photo.path.stem)}
    for place in dict.fromkeys((folder / photo.path.parent.name, folder)):
        if not place.is_dir() or place.absolute() == photo.path.parent.absolute():
            continue
        for path in sorted(place.iterdir()):
            if path.suffix.lower() in SUFFIXES and path.stem.lower() in stems and path.absolute() not in photos:
                return path
    return None


def _examined(path: Path, photo: Photo) -> MaskFile:
    """What is known of a mask; InputError where it cannot be used."""
    try:
        header = read_header(path, limit_pixels=LIMIT_PIXELS)
    except Unusable as error:
        raise error.at(shown(path)) from None
    except OSError as error:
        raise InputError("file.not_readable", detail=error.strerror or str(error), file=shown(path)) from None
    laid = _laid(path, header, photo)
    free = float(_read(path, photo, laid).mean())
    with guarded(path), path.open("rb") as file:
        return MaskFile(path=path, sha256=hashlib.file_digest(file, "sha256").hexdigest(), laid=laid, free=free)


def _laid(path: Path, header: Header, photo: Photo) -> Laid:
    """How a mask lies on its photograph; InputError where it fits in no way."""
    tags = () if header.exif is None else read_tags(header.exif).numbers(ORIENTATION)
    own = int(tags[0]) if tags and 1 <= tags[0] <= 8 else None
    w, h = header.width_px, header.height_px
    stored, turned = (_fits((w, h), size) for size in ((photo.width_px, photo.height_px), photo.upright_size))
    if own is not None and own != photo.orientation:
        if _fits((h, w) if own >= 5 else (w, h), photo.upright_size):
            return Laid(own=own, shown=True)
    elif stored:
        return Laid(reported=photo.orientation == 1 or own is not None or not turned)
    elif turned:
        return Laid(shown=True)
    raise InputError(
        "mask.size_differs", width_px=w, height_px=h, orientation=own or photo.orientation, photograph=photo.name,
        photograph_width_px=photo.width_px, photograph_height_px=photo.height_px, file=shown(path),
    )  # fmt: skip


def _fits(one: tuple[int, int], two: tuple[int, int]) -> bool:
    """Whether two sizes are one, or a whole multiple or part of each other."""
    return two[0] * one[1] == two[1] * one[0] and (one[0] % two[0] == 0 or two[0] % one[0] == 0)


def _read(path: Path, photo: Photo, laid: Laid) -> Mask:
    """(h, w) of the photograph as stored."""
    import cv2

    try:
        free = _used(path).astype(np.uint8)
    except Unusable as error:
        raise error.at(shown(path)) from None
    if laid.shown:
        free = stored_from_turned(upright(free, laid.own), photo.orientation)
    if free.shape != (photo.height_px, photo.width_px):
        free = cv2.resize(free, (photo.width_px, photo.height_px), interpolation=cv2.INTER_NEAREST)
    return np.asarray(free > 0)


def _used(path: Path) -> Mask:
    """(h, w) where a mask is neither 0 in every channel nor, if it has alpha that masks, transparent.

    Where one colour is everywhere, only alpha can be meant; alpha that is the same everywhere states nothing.
    """
    colour, alpha = decode_channels(path, read_header(path, limit_pixels=LIMIT_PIXELS).kind)
    used = np.asarray((colour != 0).any(axis=2))
    if alpha is None or (alpha == alpha[0, 0]).all():
        return used
    visible = np.asarray(alpha != 0)
    return visible if (colour == colour[0, 0]).all() else used & visible
