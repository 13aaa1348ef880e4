"""EXIF: a reader of TIFF directories that takes nothing for granted.

Every offset and count is checked against the bytes there are; directories are read once each, so that a file
whose directories point at each other ends.  EXIF 2.32 (CIPA DC-008-2019), TIFF 6.0.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field

from raybundle.io.reading.words import finite, number_of

ENTRIES = 1000
VALUE_BYTES = 1 << 20
SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 13: 4}
LETTERS = {1: "B", 3: "H", 4: "I", 6: "b", 8: "h", 9: "i", 11: "f", 12: "d", 13: "I"}
EXIF_POINTER, GPS_POINTER = 0x8769, 0x8825

Value = str | bytes | tuple[float, ...]
"""Text, bytes as they are, or numbers; a rational x/0 is NaN."""


@dataclass(frozen=True, slots=True)
class Tags:
    """The directories of one image that matter here."""

    main: Mapping[int, Value] = field(default_factory=dict[int, Value])
    exif: Mapping[int, Value] = field(default_factory=dict[int, Value])
    gps: Mapping[int, Value] = field(default_factory=dict[int, Value])
    remarks: tuple[str, ...] = ()

    def number(self, *tags: int, gps: bool = False) -> float | None:
        """The first finite number under one of these tags; None where there is none."""
        numbers = self.numbers(*tags, gps=gps)
        return numbers[0] if numbers and numbers[0] == numbers[0] else None

    def numbers(self, *tags: int, gps: bool = False) -> tuple[float, ...]:
        """All numbers under the first of these tags that there is; NaN for x/0."""
        for tag in tags:
            for directory in (self.gps,) if gps else (self.exif, self.main):
                value = directory.get(tag)
                if isinstance(value, tuple) and value:
                    return value
                if isinstance(value, str) and (found := number_of(value)) is not None:
                    return (found,)
        return ()

    def positive(self, *tags: int, gps: bool = False) -> float | None:
        """As `number`, but only what is greater than 0 and finite."""
        number = self.number(*tags, gps=gps)
        return number if number is not None and 0 < number < 1e9 else None

    def text(self, *tags: int, gps: bool = False) -> str:
        """The first text under one of these tags, without padding; empty where there is none."""
        for tag in tags:
            for directory in (self.gps,) if gps else (self.main, self.exif):
                value = directory.get(tag)
                if isinstance(value, bytes):
                    value = _decoded(value)
                if isinstance(value, str) and value:
                    return value
        return ""


def read_tags(data: bytes | memoryview) -> Tags:
    """The main, EXIF and GPS directory of a TIFF structure (the body of an EXIF segment, or a TIFF file).

    Never raises on bad data: what can be read is returned, and `remarks` says what was wrong.
    """
    source = memoryview(data)
    if bytes(source[:6]) == b"Exif\0\0":
        source = source[6:]
    order = {b"II": "<", b"MM": ">"}.get(bytes(source[:2]), "")
    if len(source) < 8 or not order:
        return Tags(remarks=("EXIF does not begin with II or MM: not read",))
    reader = _Reader(source, order)
    main = reader.directory(struct.unpack_from(order + "I", source, 4)[0], "main")
    exif = reader.linked(main, EXIF_POINTER, "EXIF")
    gps = reader.linked(main, GPS_POINTER, "GPS") or reader.linked(exif, GPS_POINTER, "GPS")
    return Tags(main, exif, gps, tuple(reader.remarks))


class _Reader:
    """One TIFF structure; remembers which directories were read."""

    def __init__(self, source: memoryview, order: str) -> None:
        self.source = source
        self.order = order
        self.seen: set[int] = set()
        self.remarks: list[str] = []

    def linked(self, directory: Mapping[int, Value], tag: int, name: str) -> dict[int, Value]:
        """The directory that an entry points to."""
        pointer = directory.get(tag)
        if not isinstance(pointer, tuple) or not pointer or pointer[0] != pointer[0]:
            return {}
        return self.directory(int(pointer[0]), name)

    def directory(self, offset: int, name: str) -> dict[int, Value]:
        """The entries of a directory; the first of several with the same tag."""
        if not 8 <= offset <= len(self.source) - 2:
            self.remarks.append(f"the {name} directory lies outside the data")
            return {}
        if offset in self.seen:
            self.remarks.append(f"the {name} directory was read already under another name")
            return {}
        self.seen.add(offset)
        (count,) = struct.unpack_from(self.order + "H", self.source, offset)
        room = min(ENTRIES, (len(self.source) - offset - 2) // 12)
        if count > room:
            self.remarks.append(f"the {name} directory promises {count} entries, {room} can be read")
        entries: dict[int, Value] = {}
        bad = 0
        for k in range(min(count, room)):
            tag, kind, number = struct.unpack_from(self.order + "HHI", self.source, offset + 2 + 12 * k)
            value = self._value(kind, number, offset + 2 + 12 * k + 8)
            if value is None:
                bad += 1
            else:
                entries.setdefault(tag, value)
        if bad:
            self.remarks.append(f"{bad} of {count} entries of the {name} directory are damaged")
        return entries

    def _value(self, kind: int, number: int, at: int) -> Value | None:
        size = SIZES.get(kind, 0) * number
        if kind not in SIZES or size > VALUE_BYTES:
            return None
        if size > 4:
            (at,) = struct.unpack_from(self.order + "I", self.source, at)
        if at + size > len(self.source):
            return None
        raw = bytes(self.source[at : at + size])
        if kind == 2:
            return _decoded(raw)
        if kind == 7:
            return raw
        if kind in {5, 10}:
            pairs = struct.unpack(f"{self.order}{2 * number}{'I' if kind == 5 else 'i'}", raw)
            return tuple(_bounded(a / b) if b else math.nan for a, b in zip(pairs[::2], pairs[1::2], strict=True))
        return tuple(_bounded(v) for v in struct.unpack(f"{self.order}{number}{LETTERS[kind]}", raw))


def _decoded(raw: bytes) -> str:
    """Text up to the first NUL, UTF-8 if it is, else Latin-1, in one line."""
    head = raw.partition(b"\0")[0]
    try:
        text = head.decode("utf-8")
    except UnicodeDecodeError:
        text = head.decode("latin-1")
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())


def _bounded(value: float) -> float:
    """A number as it is; NaN where it is not finite, or too large to be one of a camera."""
    found = finite(value)
    return math.nan if found is None else found
