"""EXIF: the directories of one image, from a source that nothing is taken for granted of.

Directories are read once each, so that a file whose directories point at each other ends.  EXIF 2.32 (CIPA
DC-008-2019).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from raybundle.errors import phrase
from raybundle.io.reading.tiff import BYTES, LETTERS, SMALLEST, TEXT, Entry, Memory, Tiff
from raybundle.io.reading.words import finite, number_of

ENTRIES = 1000
VALUE_BYTES = 1 << 20
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

    Never raises on bad data: what can be read is returned, and `remarks` states what was wrong.
    """
    source = memoryview(data)
    if bytes(source[:6]) == b"Exif\0\0":
        source = source[6:]
    tiff = Tiff.of(Memory(source))
    if tiff is None:
        return Tags(remarks=(phrase("photo_entry.exif_no_tiff"),))
    reader = _Reader(tiff)
    main = reader.directory(tiff.first, "main")
    exif = reader.linked(main, EXIF_POINTER, "EXIF")
    gps = reader.linked(main, GPS_POINTER, "GPS") or reader.linked(exif, GPS_POINTER, "GPS")
    return Tags(main, exif, gps, tuple(reader.remarks))


class _Reader:
    """One TIFF structure; remembers which directories were read."""

    def __init__(self, tiff: Tiff) -> None:
        self.tiff = tiff
        self.seen: set[int] = set()
        self.remarks: list[str] = []

    def linked(self, directory: Mapping[int, Value], tag: int, name: str) -> dict[int, Value]:
        """The directory that an entry points to."""
        pointer = directory.get(tag)
        if not isinstance(pointer, tuple) or not pointer or pointer[0] != pointer[0]:
            return {}
        return self.directory(int(pointer[0]), name)

    def directory(self, at: int | None, name: str) -> dict[int, Value]:
        """The entries of a directory; the first of several with the same tag."""
        count = None if at is None or at < SMALLEST else self.tiff.count(at)
        if at is None or count is None:
            self.remarks.append(phrase("photo_entry.exif_outside", directory=name))
            return {}
        if at in self.seen:
            self.remarks.append(phrase("photo_entry.exif_twice", directory=name))
            return {}
        self.seen.add(at)
        entries: dict[int, Value] = {}
        read = bad = 0
        for entry in self.tiff.entries(at, min(count, ENTRIES)):
            read += 1
            value = self._value(entry)
            if value is None:
                bad += 1
            else:
                entries.setdefault(entry.tag, value)
        if read < count:
            self.remarks.append(phrase("photo_entry.exif_cut", directory=name, n=read, of=count))
        if bad:
            self.remarks.append(phrase("photo_entry.exif_damaged", directory=name, n=bad, of=count))
        return entries

    def _value(self, entry: Entry) -> Value | None:
        if entry.type not in LETTERS or entry.size > VALUE_BYTES:
            return None
        raw = self.tiff.raw(entry)
        if raw is None or entry.type == BYTES:
            return raw
        if entry.type == TEXT:
            return _decoded(raw)
        return tuple(_bounded(v) for v in self.tiff.numbers(entry, raw))


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
