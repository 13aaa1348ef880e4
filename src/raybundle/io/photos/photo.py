"""Photographs: found, checked one by one, and read.

The measurement frame of a photograph is that of its pixels AS STORED: the sensor's own.  An EXIF orientation
only states which way up it is to be shown.  So a camera turned on its side keeps its interior orientation,
and `stored_from_upright` brings over what was measured in a picture that a viewer had turned.
"""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Text, code_of, message, message_of_text, named, phrase
from raybundle.io.photos.container import (
    HEIC_SUFFIXES,
    JPEG_SUFFIXES,
    RAW_SUFFIXES,
    SUFFIXES,
    Header,
    Kind,
    Unusable,
    check_pixels,
    decode,
    other_kind,
    read_header,
)
from raybundle.io.photos.metadata import Gps, Metadata
from raybundle.io.photos.read_metadata import read_metadata
from raybundle.io.photos.remote import at_hand, local_path, remote_files, url_of
from raybundle.io.reading.files import guarded
from raybundle.numerics.arrays import Array
from raybundle.numerics.natural import natural
from raybundle.numerics.progress import Progress, silent
from raybundle.readable import readable_names, readable_path

__all__ = [
    "LIMIT_PIXELS", "Found", "Gps", "Metadata", "Photo", "PhotoFormat", "find_photos", "read_colour", "read_grey",
    "read_photo", "stored_from_turned", "stored_from_upright", "upright", "upright_from_stored",
]  # fmt: skip

LIMIT_PIXELS = 600_000_000
"""Pixels that a photograph may have; the largest aerial frame cameras stay below."""
SMALLEST_SIDE = 32
EMPTIEST = (30_000_000, 250)
"""Pixels, and pixels for each byte of the file, above both of which a file is made to burst a decoder: not even a
black photograph is packed so densely."""
THUMBNAIL = (400, 1 / 16)
"""Longest side [px], and share of the median number of pixels, below both of which a photograph is a thumbnail."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PhotoFormat:
    """Size of a photograph and which way up it is to be shown."""

    width_px: int
    """As stored (see `orientation`)."""
    height_px: int
    orientation: int = 1
    """EXIF: 1 as stored, 3 to be turned by 180 deg, 6 by 90 deg clockwise, 8 counter-clockwise; 2, 4, 5, 7 mirrored."""

    @property
    def upright_size(self) -> tuple[int, int]:
        """Width and height [px] when shown the right way up."""
        turned = self.orientation >= 5
        return (self.height_px, self.width_px) if turned else (self.width_px, self.height_px)


@dataclass(frozen=True, slots=True, kw_only=True)
class Photo(PhotoFormat):
    """One photograph; its pixels are read when they are asked for."""

    path: Path
    name: str
    """File name; where names repeat among the inputs, the path from their common folder."""
    bits: int = 8
    """Per channel, 8 or 16."""
    kind: Kind = "jpeg"
    sha256: str
    metadata: Metadata

    @property
    def content(self) -> tuple[str, str]:
        """What a photograph is known by, wherever it lies: its metadata are in its bytes, or come from another file."""
        return self.sha256, self.name

    @property
    def format(self) -> PhotoFormat:
        """Without path and metadata."""
        return PhotoFormat(width_px=self.width_px, height_px=self.height_px, orientation=self.orientation)


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """The photographs among some files, and what became of the others."""

    photos: tuple[Photo, ...]
    refused: tuple[tuple[Path, str], ...]
    """Files and the reason why each is left out."""
    remarks: tuple[str, ...]
    copies: Mapping[str, str] = field(default_factory=dict[str, str])
    """Names of files that are left out because another has the same content, and the name of that one"""


def find_photos(
    inputs: Sequence[Path], *, leave: Collection[Path] = (), limit_pixels: int = LIMIT_PIXELS,
    progress: Progress = silent,
) -> Found:  # fmt: skip
    """The photographs in folders and files, in the order of their names (numbers within names count as numbers).

    inputs        folders (looked into, not their subfolders) and files; URLs of both, and of lists (.txt)
    leave         files that are no photographs and not passed over, as satellite scenes
    limit_pixels  a file whose header states more is not decoded
    raises        InputError for an input that does not exist or a folder that cannot be listed
    A file that cannot be used costs that file only and is listed with its reason: empty, truncated, no image,
    too large, not readable, a thumbnail beside photographs, the same content as another file (of an earlier input).
    Limits: whether the pixels in the middle of a file are damaged; `read_grey` finds that.
    """
    files, remarks = _files(inputs, frozenset(leave))
    names = _names(files)
    photos: list[Photo] = []
    refused: list[tuple[Path, str]] = []
    of_content: dict[str, list[tuple[Path, Photo]]] = {}
    for k, (path, name) in enumerate(zip(files, names, strict=True)):
        progress("reading photographs", k / len(files))
        try:
            photo = read_photo(path, name=name, limit_pixels=limit_pixels)
        except InputError as error:
            refused.append((shown(path), Text.of(error.message) if error.message is not None else str(error)))
            continue
        of_content.setdefault(photo.sha256, []).append((path, photo))
    copies: dict[str, str] = {}
    turn: dict[Path, int] = {}
    for k, given in enumerate(inputs):
        path = local_path(Path(given))
        turn.setdefault(path if path.is_dir() else path.parent, k)
    for same in of_content.values():
        # of the folder that is given first; "copy of a.jpg", "a (1).jpg" are longer
        original = min(same, key=lambda s: (turn.get(s[0].parent, len(turn)), len(s[1].name)))[1]
        photos.append(original)
        for path, photo in same:
            if photo is not original:
                copies[photo.name] = original.name
                refused.append((shown(path), Text.of(message("photograph.copy", original=original.name))))
    order = {name: k for k, name in enumerate(names)}
    photos.sort(key=lambda p: order[p.name])
    kept, thumbnails = _without_thumbnails(photos)
    progress("reading photographs", 1.0)
    remarks += _together([(p.name, r) for p in kept for r in p.metadata.remarks if _concerns_all(r)])
    return Found(photos=kept, refused=tuple(sorted(refused + thumbnails)), remarks=tuple(remarks), copies=copies)


def _concerns_all(remark: str) -> bool:
    """Whether a remark on the metadata of a photograph matters to the set: entries of XMP, positions."""
    return not code_of(remark).startswith(("photo_entry.exif_", "photo_entry.orientation"))


def _together(remarks: list[tuple[str, str]]) -> list[str]:
    """One remark for all photographs in which the same entry is of no use, with the first of them."""
    by_entry: dict[tuple[str, str, str], list[tuple[str, str]]] = {}
    for name, remark in remarks:
        values = message_of_text(remark).values
        entry = code_of(remark), str(values.get("entry", "")), str(values.get("source", ""))
        by_entry.setdefault(entry, []).append((name, remark))
    found: list[str] = []
    for same in by_entry.values():
        name, remark = same[0]
        found.append(Text.of(named(f"{name} (+{len(same) - 1})" if len(same) > 1 else name, remark)))
    return found


def read_photo(path: Path, *, name: str = "", limit_pixels: int = LIMIT_PIXELS) -> Photo:
    """One photograph with its metadata; its pixels are only checked for being complete.

    raises  InputError with the reason where it cannot be used
    """
    try:
        header, digest = at_hand(path, lambda file: _examined(file, limit_pixels))
    except Unusable as error:
        raise error.at(path) from None
    except OSError as error:
        raise InputError("file.not_readable", detail=error.strerror or str(error), file=path) from None
    metadata, orientation = read_metadata(header.exif, header.xmp)
    metadata = replace(metadata, remarks=(*metadata.remarks, *header.remarks))
    photo = Photo(
        path=path,
        name=name or path.name,
        width_px=header.width_px,
        height_px=header.height_px,
        orientation=orientation,
        bits=header.bits,
        kind=header.kind,
        sha256=digest,
        metadata=metadata,
    )
    return _as_sensor(photo, header)


def _examined(path: Path, limit_pixels: int) -> tuple[Header, str]:
    """Header and SHA-256 of a file that can be used; raises Unusable or OSError."""
    mode = path.stat().st_mode
    if not stat.S_ISREG(mode):
        raise Unusable("file.not_a_file", kind="folder" if stat.S_ISDIR(mode) else "device")
    header = read_header(path, limit_pixels=limit_pixels)
    if min(header.width_px, header.height_px) < SMALLEST_SIDE:
        raise Unusable("photograph.too_small", width_px=header.width_px, height_px=header.height_px)
    pixels, size = header.width_px * header.height_px, path.stat().st_size
    if pixels > EMPTIEST[0] and pixels > EMPTIEST[1] * size:
        raise Unusable("photograph.no_content", width_px=header.width_px, height_px=header.height_px, size_bytes=size)
    check_pixels(path, header.kind)
    with path.open("rb") as file:
        return header, hashlib.file_digest(file, "sha256").hexdigest()


def _as_sensor(photo: Photo, header: Header) -> Photo:
    """A HEIC decoder turns the picture upright itself; the size is given as the sensor has it."""
    if header.kind == "heic" and photo.orientation >= 5:
        return replace(photo, width_px=header.height_px, height_px=header.width_px)
    return photo


def _files(inputs: Sequence[Path], leave: frozenset[Path]) -> tuple[list[Path], list[str]]:
    """Candidates in natural order, each once, and remarks on what was passed over."""
    remarks: list[str] = []
    files: dict[Path, None] = {}
    for given in inputs:
        path = local_path(Path(given))
        remote = remote_files(path) if url_of(path) else None
        if remote is not None:
            files.update(dict.fromkeys(_of_entries(path, [p for p in remote if not p.name.startswith(".")], remarks)))
        elif path.is_dir():
            files.update(dict.fromkeys(_in_folder(path, leave, remarks)))
        elif url_of(path) or path.exists() or path.is_symlink():
            files[path] = None
        else:
            raise InputError("file.missing", file=path)
    seen: dict[str, Path] = {}
    for path in files:
        if path in leave:
            continue
        seen.setdefault(os.path.realpath(path), path)
    return sorted(seen.values(), key=lambda p: (natural(p.name), str(p))), remarks


def _in_folder(folder: Path, leave: frozenset[Path], remarks: list[str]) -> list[Path]:
    try:
        entries = sorted(p for p in folder.iterdir() if not p.name.startswith(".") and p not in leave)
    except OSError as error:
        raise InputError("folder.not_listed", detail=error.strerror, file=folder) from None
    return _of_entries(folder, entries, remarks)


def _of_entries(folder: Path, entries: Sequence[Path], remarks: list[str]) -> list[Path]:
    """The photographs among what is in a folder."""
    files = [p for p in entries if p.suffix.lower() in SUFFIXES and (p.is_symlink() or not p.is_dir())]
    jpegs = {p.stem.lower() for p in files if p.suffix.lower() in JPEG_SUFFIXES}
    doubles = [p for p in files if p.suffix.lower() in (RAW_SUFFIXES | HEIC_SUFFIXES) and p.stem.lower() in jpegs]
    if doubles:
        remarks.append(
            phrase("photo_entry.jpeg_taken", folder=str(shown(folder)), n=len(doubles), first=shown(doubles[0]).name)
        )
        files = [p for p in files if p not in set(doubles)]
    others = [p for p in entries if p.suffix.lower() not in SUFFIXES and not p.is_dir()]
    if others:
        suffixes = sorted({shown(p).suffix.lower() or "-" for p in others})
        remarks.append(phrase("photo_entry.other_files", folder=str(shown(folder)), n=len(others), suffixes=suffixes))
        hints = {h.code: h for p in others if (h := other_kind(p.suffix)) is not None}
        for hint in hints.values():
            same = [shown(p).name for p in others if other_kind(p.suffix) == hint]
            name = f"{same[0]} (+{len(same) - 1})" if len(same) > 1 else same[0]
            remarks.append(Text.of(named(name, Text.of(hint))))
    folders = [p for p in entries if p.is_dir()]
    if folders:
        remarks.append(
            phrase(
                "photo_entry.sub_folders",
                folder=str(shown(folder)),
                n=len(folders),
                names=[shown(p).name for p in folders],
            )
        )
    return files


def _names(files: Sequence[Path]) -> list[str]:
    names = [p.name for p in files]
    if len(set(names)) < len(names):
        common = Path(os.path.commonpath([p.parent.absolute() for p in files]))
        names = [shown(p.absolute().relative_to(common)).as_posix() for p in files]
    return [*readable_names(names)]


def shown(path: Path) -> Path:
    """The path as it can be shown and written (`raybundle.readable`)."""
    return readable_path(path)


def _without_thumbnails(photos: Sequence[Photo]) -> tuple[tuple[Photo, ...], list[tuple[Path, str]]]:
    """Leave out what is much smaller than the other photographs."""
    if len(photos) < 2:
        return tuple(photos), []
    pixels = np.array([p.width_px * p.height_px for p in photos])
    longest = np.array([max(p.width_px, p.height_px) for p in photos])
    typical = float(np.median(pixels))
    small = (longest < THUMBNAIL[0]) & (pixels < THUMBNAIL[1] * typical)
    refused: list[tuple[Path, str]] = [
        (
            shown(p.path),
            Text.of(
                message(
                    "photograph.thumbnail", width_px=p.width_px, height_px=p.height_px, typical_megapixels=typical / 1e6
                )
            ),
        )
        for p, s in zip(photos, small, strict=True)
        if s
    ]
    return tuple(p for p, s in zip(photos, small, strict=True) if not s), refused


def read_grey(photo: Photo) -> Array:
    """Grey values (h, w) as stored, uint8 or uint16, C-contiguous.

    0.299 R + 0.587 G + 0.114 B of the values in the file (ITU-R BT.601, the Y of a JPEG): not linear in light.
    Raises InputError where the pixels cannot be decoded, or the content of the file has changed since.
    """
    return at_hand(photo.path, lambda file: _checked(photo, file, decode(file, photo.kind, "grey")))


def read_colour(photo: Photo) -> Array:
    """Red, green, blue (h, w, 3) as stored, uint8; 16-bit values are brought to 8 by leaving out low bits.

    Raises InputError as `read_grey`.
    """
    return at_hand(photo.path, lambda file: _checked(photo, file, decode(file, photo.kind, "colour")))


def _checked(photo: Photo, path: Path, pixels: Array) -> Array:
    if photo.kind == "heic":
        pixels = stored_from_turned(pixels, photo.orientation)
    if pixels.shape[:2] != (photo.height_px, photo.width_px):
        raise InputError(
            "photograph.size_changed", width_px=pixels.shape[1], height_px=pixels.shape[0],
            header_width_px=photo.width_px, header_height_px=photo.height_px, file=path,
        )  # fmt: skip
    with guarded(path), path.open("rb") as file:
        # after decoding, so that an exchange before or meanwhile is seen
        now = hashlib.file_digest(file, "sha256").hexdigest()
    if now != photo.sha256:
        raise InputError("photograph.changed", file=path)
    return pixels


_TURNS = {
    1: lambda a: a,
    2: lambda a: a[:, ::-1],
    3: lambda a: a[::-1, ::-1],
    4: lambda a: a[::-1],
    5: lambda a: a.swapaxes(0, 1),
    6: lambda a: a.swapaxes(0, 1)[:, ::-1],
    7: lambda a: a[::-1, ::-1].swapaxes(0, 1),
    8: lambda a: a.swapaxes(0, 1)[::-1],
}
_INVERSE = {1: 1, 2: 2, 3: 3, 4: 4, 5: 5, 6: 8, 7: 7, 8: 6}


def upright(pixels: Array, orientation: int) -> Array:
    """Pixels (h, w) or (h, w, 3) the right way up, for showing."""
    return np.ascontiguousarray(_TURNS[orientation](pixels))


def stored_from_turned(pixels: Array, orientation: int) -> Array:
    """The inverse of `upright`: pixels as stored of pixels the right way up."""
    return np.ascontiguousarray(_TURNS[_INVERSE[orientation]](pixels))


def upright_from_stored(xy_px: Array, photo: PhotoFormat) -> Array:
    """Pixel frame (n, 2) of the upright picture, of points (n, 2) in the photograph as stored."""
    return _turned(np.asarray(xy_px, float), photo.orientation, photo.width_px, photo.height_px)


def stored_from_upright(xy_px: Array, photo: Photo) -> Array:
    """Pixel frame (n, 2) of the photograph as stored, of points (n, 2) measured in the upright picture."""
    return _turned(np.asarray(xy_px, float), _INVERSE[photo.orientation], *photo.upright_size)


def _turned(xy: Array, orientation: int, width: int, height: int) -> Array:
    x, y = xy[:, 0], xy[:, 1]
    new = {
        1: (x, y),
        2: (width - x, y),
        3: (width - x, height - y),
        4: (x, height - y),
        5: (y, x),
        6: (height - y, x),
        7: (height - y, width - x),
        8: (y, width - x),
    }[orientation]
    return np.stack(new, axis=1)
