"""What the container of a video states about the camera: ISO base media files (MP4, MOV), read box by box.

ISO/IEC 14496-12 for the boxes; Apple's QuickTime File Format for user data and metadata keys.  Other containers
say nothing here.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import BinaryIO

from raybundle.io.reading.words import number_of

MOOV_BYTES = 1 << 26
HIGHEST_M = 1e5
"""No camera of a video is higher."""
EPOCH = datetime(1904, 1, 1, tzinfo=UTC)
USER_DATA = {b"\xa9mak": "make", b"\xa9mod": "model", b"\xa9swr": "software", b"\xa9xyz": "location"}
APPLE = "com.apple.quicktime."


@dataclass(frozen=True, slots=True, kw_only=True)
class MovieMetadata:
    """Empty or None where the container does not say."""

    make: str = ""
    model: str = ""
    software: str = ""
    lens: str = ""
    focal35_mm: float | None = None
    start: datetime | None = None
    """When the recording began, UTC."""
    position: tuple[float, float, float | None] | None = None
    """Latitude, longitude [deg], altitude [m] of the start."""


def read_movie_metadata(path: Path) -> MovieMetadata:
    """Make, model, time and place from the container; nothing where it is of another kind or damaged."""
    try:
        with path.open("rb") as file:
            moov = _moov(file)
    except OSError:
        return MovieMetadata()
    found: dict[str, str] = {}
    start = None
    for kind, body in _boxes(moov):
        if kind == b"mvhd":
            start = _creation(body)
        elif kind == b"udta":
            found = {**_user_data(body), **found}
        elif kind == b"meta":
            found.update(_keyed(body))
    return MovieMetadata(
        make=found.get("make", ""),
        model=found.get("model", ""),
        software=found.get("software", ""),
        lens=found.get("camera.lens_model", ""),
        focal35_mm=_positive(found.get("camera.focal_length.35mm_equivalent", "")),
        start=start,
        position=_position(found.get("location.ISO6709", "") or found.get("location", "")),
    )


def _moov(file: BinaryIO) -> bytes:
    """The body of the movie box, looked for among the outermost boxes."""
    size = file.seek(0, 2)
    at = 0
    for _ in range(1000):
        file.seek(at)
        head = file.read(16)
        if len(head) < 8:
            break
        length, kind = struct.unpack_from(">I4s", head)
        skip = 8
        if length == 1 and len(head) == 16:
            (length,), skip = struct.unpack_from(">Q", head, 8), 16
        if length == 0:
            length = size - at
        if length < skip or at + length > size:
            break
        if kind == b"moov":
            file.seek(at + skip)
            return file.read(length - skip) if length <= MOOV_BYTES else b""
        at += length
    return b""


def _boxes(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Kind and body of each box, as far as they fit."""
    at = 0
    while at + 8 <= len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        if length < 8 or at + length > len(data):
            return
        yield kind, data[at + 8 : at + length]
        at += length


def _creation(body: bytes) -> datetime | None:
    if len(body) < 20:
        return None
    seconds = struct.unpack_from(">Q", body, 4)[0] if body[0] == 1 else struct.unpack_from(">I", body, 4)[0]
    if not 3e9 < seconds < 6e9:  # 1999 to 2094; many writers leave 0
        return None
    return EPOCH + timedelta(seconds=seconds)


def _user_data(body: bytes) -> dict[str, str]:
    """QuickTime's international texts: length, language, text."""
    found: dict[str, str] = {}
    for kind, value in _boxes(body):
        if kind in USER_DATA and len(value) > 4:
            length = int.from_bytes(value[:2], "big")
            found[USER_DATA[kind]] = _text(value[4 : 4 + length])
        elif kind == b"meta":
            found.update(_keyed(value))
    return found


def _keyed(body: bytes) -> dict[str, str]:
    """QuickTime metadata: a table of keys, and a list whose items are numbered by them."""
    if body[4:8] != b"hdlr":
        body = body[4:]  # in MP4 the box has version and flags
    parts = dict(_boxes(body))
    keys = [k.decode("utf-8", "replace") for _, k in _boxes(parts.get(b"keys", b"")[8:])]
    found: dict[str, str] = {}
    for kind, item in _boxes(parts.get(b"ilst", b"")):
        number = int.from_bytes(kind, "big")
        for inner, value in _boxes(item):
            if inner == b"data" and 1 <= number <= len(keys):
                code, raw = int.from_bytes(value[:4], "big"), value[8:]
                found[keys[number - 1].removeprefix(APPLE)] = _value(code, raw)
    return found


def _value(code: int, raw: bytes) -> str:
    if code in {21, 22, 65, 66, 67, 74, 75, 76, 77, 78} and len(raw) <= 8:
        return str(int.from_bytes(raw, "big", signed=code in {21, 65, 66, 67, 74}))
    if code in {23, 24} and len(raw) in {4, 8}:
        return repr(struct.unpack(">f" if len(raw) == 4 else ">d", raw)[0])
    return _text(raw)


def _text(raw: bytes) -> str:
    return "".join(c for c in raw.decode("utf-8", "replace") if c.isprintable()).strip()[:200]


def _positive(text: str) -> float | None:
    found = number_of(text)
    return found if found is not None and 0 < found < 1e4 else None


def _position(text: str) -> tuple[float, float, float | None] | None:
    """ISO 6709: +47.1234+008.5678+512.3/."""
    found = re.match(r"([+-]\d{1,2}(?:\.\d+)?)([+-]\d{1,3}(?:\.\d+)?)([+-]\d+(?:\.\d+)?)?", text, re.ASCII)
    if not found:
        return None
    latitude, longitude = number_of(found[1]), number_of(found[2])
    if latitude is None or longitude is None or abs(latitude) > 90 or abs(longitude) > 180:
        return None
    altitude = None if found[3] is None else number_of(found[3])
    return latitude, longitude, altitude if altitude is not None and abs(altitude) < HIGHEST_M else None
