"""Directories of TIFF, BigTIFF and EXIF: entries and their values, every offset and count held against the bytes there.

Aldus 1992, TIFF 6.0; BigTIFF as libtiff writes it; EXIF 2.32 (CIPA DC-008-2019).
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Protocol

from raybundle.errors import InputError

LETTERS = {1: "B", 2: "s", 3: "H", 4: "I", 5: "I", 6: "b", 7: "s", 8: "h", 9: "i", 10: "i", 11: "f", 12: "d", 13: "I",
           16: "Q", 17: "q", 18: "Q"}  # fmt: skip
"""Types of values: 2 is text, 7 bytes, 5 and 10 are pairs of whole numbers."""
TEXT, RATIONAL, BYTES, SIGNED_RATIONAL = 2, 5, 7, 10
MOST_TAGS = 4096
MOST_VALUES = 1 << 24
SMALLEST = 8
"""Bytes of the head."""
NUMBER_TYPES = frozenset(LETTERS) - {TEXT, RATIONAL, SIGNED_RATIONAL}


class Source(Protocol):
    """Bytes that are read where they are needed."""

    def take(self, at: int, size: int) -> bytes | None:
        """The bytes from a place on; where there are not so many None, or InputError, as the source has it."""
        ...


@dataclass(frozen=True, slots=True)
class Memory:
    """Bytes in memory."""

    data: memoryview

    def take(self, at: int, size: int) -> bytes | None:
        """See `Source`."""
        return bytes(self.data[at : at + size]) if 0 <= at <= len(self.data) - size else None


@dataclass(frozen=True, slots=True)
class Opened:
    """An opened file, which may be long; what it does not hold raises InputError."""

    path: Path
    file: BinaryIO

    def take(self, at: int, size: int) -> bytes:
        """See `Source`."""
        there = 0 <= at <= self.file.seek(0, 2) - size
        self.file.seek(at if there else 0)
        data = self.file.read(size) if there else b""
        if not there or len(data) < size:
            raise InputError("tiff.ends_early", byte=at + size, file=self.path)
        return data


@dataclass(frozen=True, slots=True)
class Entry:
    """One entry of a directory."""

    tag: int
    type: int
    """number of the type of its values"""
    count: int
    inline: int
    """where its value stands, or the place of its values"""
    size: int
    """bytes of all its values; 0 for a type that is not known"""


@dataclass(frozen=True, slots=True)
class Tiff:
    """Byte order and widths of a TIFF structure."""

    source: Source
    order: str
    """ "<" or ">" """
    big: bool

    @classmethod
    def of(cls, source: Source) -> Tiff | None:
        """By its first bytes; None where they are not those of a TIFF or BigTIFF."""
        head = source.take(0, SMALLEST)
        order = {b"II": "<", b"MM": ">"}.get(head[:2] if head else b"", "")
        if head is None or not order:
            return None
        (version,) = struct.unpack(order + "H", head[2:4])
        return cls(source, order, version == 43) if version in {42, 43} else None

    @property
    def _pointer(self) -> str:
        return "Q" if self.big else "I"

    def unpacked(self, layout: str, at: int) -> tuple[int, ...] | None:
        """Whole numbers in the notation of `struct` that stand at a place; None where the bytes end before."""
        raw = self.source.take(at, struct.calcsize(self.order + layout))
        return None if raw is None else struct.unpack(self.order + layout, raw)

    @property
    def first(self) -> int | None:
        """Where the first directory stands."""
        found = self.unpacked(self._pointer, 8 if self.big else 4)
        return None if found is None else found[0]

    def count(self, at: int) -> int | None:
        """How many entries the directory at a place promises."""
        found = self.unpacked("Q" if self.big else "H", at)
        return None if found is None else found[0]

    def entries(self, at: int, count: int) -> Iterator[Entry]:
        """The first `count` entries of the directory at a place, as far as there are bytes."""
        start, width = (at + 8, 20) if self.big else (at + 2, 12)
        for k in range(count):
            place = start + k * width
            found = self.source.take(place, width)
            if found is None:
                return
            tag, type_, number = struct.unpack_from(self.order + "HH" + self._pointer, found)
            each = struct.calcsize("<" + LETTERS[type_]) if type_ in LETTERS else 0
            pairs = 2 if type_ in {RATIONAL, SIGNED_RATIONAL} else 1
            yield Entry(tag, type_, number, place + (12 if self.big else 8), each * pairs * number)

    def raw(self, entry: Entry) -> bytes | None:
        """The bytes of an entry's values; None where they lie outside."""
        at = entry.inline
        if entry.size > (8 if self.big else 4):
            found = self.unpacked(self._pointer, at)
            if found is None:
                return None
            (at,) = found
        return self.source.take(at, entry.size)

    def numbers(self, entry: Entry, raw: bytes) -> tuple[float, ...]:
        """The numbers that an entry's bytes stand for; a fraction x/0 is NaN."""
        letter = LETTERS[entry.type].replace("s", "B")
        pairs = entry.type in {RATIONAL, SIGNED_RATIONAL}
        values = struct.unpack(f"{self.order}{entry.count * (2 if pairs else 1)}{letter}", raw)
        if not pairs:
            return values
        return tuple(a / b if b else math.nan for a, b in zip(values[::2], values[1::2], strict=True))


Numbers = dict[int, tuple[float, ...]]
"""Tag -> numbers."""


def is_tiff(path: Path) -> bool:
    """Whether a file begins as a TIFF or BigTIFF does."""
    with path.open("rb") as file:
        return file.read(4) in {b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"}


def tiff_tags(path: Path, only: frozenset[int] | None = None) -> tuple[str, Numbers]:
    """Byte order ("<" or ">") and the numeric tags of the first image of a TIFF or BigTIFF file.

    only    tags that are wanted; None: all.  Text, fractions and what has more than 2^24 values are passed over.
    raises  InputError where the file is none, or ends too early
    """
    with path.open("rb") as file:
        source = Opened(path, file)
        tiff = Tiff.of(source) if file.seek(0, 2) >= SMALLEST else None
        at = None if tiff is None else tiff.first
        count = None if tiff is None or at is None else tiff.count(at)
        if tiff is None or at is None or count is None:
            raise InputError("tiff.no_tiff", file=path)
        if count > MOST_TAGS:
            raise InputError("tiff.too_many_tags", n=count, most=MOST_TAGS, file=path)
        found: Numbers = {}
        for entry in tiff.entries(at, count):
            if (only is None or entry.tag in only) and entry.type in NUMBER_TYPES and 0 < entry.count <= MOST_VALUES:
                raw = tiff.raw(entry)
                if raw is not None:
                    found[entry.tag] = tiff.numbers(entry, raw)
    return tiff.order, found
