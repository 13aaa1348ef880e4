"""What footer and pages of a Parquet file state of their own sizes, before anything is decoded.

A footer states sizes, and so does the head of each page; a decoder believes the latter.  Both are read
here (Thrift's compact protocol; Apache Parquet format, parquet.thrift), so that a small file cannot unfold to what no
memory holds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, BinaryIO

HEAD_BYTES = 1 << 16
"""Of the head of a page: type, sizes, encodings, and the least and largest value."""
DEEP = 8
"""Structures within each other in the head of a page; the format has 3."""
NONE, TRUE, FALSE, BYTE, DOUBLE, BINARY, LIST, STRUCT = 0, 1, 2, 3, 7, 8, 9, 12
WHOLE = (4, 5, 6)
ENCODING = {5: 2, 8: 4}
"""Field of a page's head that describes its kind of data page -> field of the encoding in there."""


class BadPage(Exception):
    """The footer, or the head of a page, cannot be read."""


@dataclass(frozen=True, slots=True)
class Page:
    """What the head of a page states."""

    unpacked: int
    """bytes"""
    encoding: int
    """of its values, as the format numbers them; -1 of a dictionary"""


@dataclass(frozen=True, slots=True)
class Chunk:
    """Where a column of a group of rows stands in the file [bytes]."""

    name: str
    begin: int
    length: int


def row_groups(footer: bytes) -> list[tuple[int, list[Chunk]]]:
    """Number of rows and columns of each group of rows.

    raises  BadPage
    """
    found: list[tuple[int, list[Chunk]]] = []
    for group in _part(_Head(footer).struct(0), 4, list):
        chunks: list[Chunk] = []
        for column in _part(group, 1, list):
            meta = _part(column, 3, dict)
            begin, dictionary = _part(meta, 9, int), meta.get(11)
            if isinstance(dictionary, int) and dictionary > 0:
                begin = min(begin, dictionary)
            name = ".".join(str(n, "utf-8", "replace") for n in _part(meta, 3, list) if isinstance(n, bytes))
            chunks.append(Chunk(name, begin, _part(meta, 7, int)))
        found.append((_part(group, 3, int), chunks))
    return found


def _part(fields: Any, number: int, kind: type) -> Any:
    value = fields.get(number) if isinstance(fields, dict) else None
    if not isinstance(value, kind):
        raise BadPage
    return value


def pages(file: BinaryIO, begin: int, length: int) -> Iterator[Page]:
    """The pages of a column within a group of rows.

    begin, length  where they stand in the file [bytes]
    raises         BadPage
    """
    at, end = begin, begin + length
    if begin < 0 or length < 0:
        raise BadPage
    while at < end:
        file.seek(at)
        head = _Head(file.read(min(HEAD_BYTES, end - at)))
        fields = head.struct(0)
        unpacked, packed = fields.get(2), fields.get(3)
        if not isinstance(unpacked, int) or not isinstance(packed, int) or unpacked < 0 or packed < 0:
            raise BadPage
        kinds = [(fields[k], place) for k, place in ENCODING.items() if isinstance(fields.get(k), dict)]
        encoding = kinds[0][0].get(kinds[0][1], -1) if kinds else -1
        yield Page(unpacked, encoding if isinstance(encoding, int) else -1)
        at += head.at + packed


class _Head:
    """A structure of Thrift's compact protocol."""

    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0

    def byte(self) -> int:
        if self.at >= len(self.data):
            raise BadPage
        self.at += 1
        return self.data[self.at - 1]

    def number(self) -> int:
        """A whole number without sign, seven bits a byte."""
        value = 0
        for k in range(10):
            byte = self.byte()
            value |= (byte & 127) << (7 * k)
            if byte < 128:
                return value
        raise BadPage

    def signed(self) -> int:
        n = self.number()
        return (n >> 1) ^ -(n & 1)

    def skip(self, count: int) -> bytes:
        if count > len(self.data) - self.at:
            raise BadPage
        self.at += count
        return self.data[self.at - count : self.at]

    def struct(self, depth: int) -> dict[int, Any]:
        """Fields by their numbers."""
        if depth > DEEP:
            raise BadPage
        found, field = dict[int, Any](), 0
        while (head := self.byte()) & 15 != NONE:
            field = field + (head >> 4) if head >> 4 else self.signed()
            found[field] = self.value(head & 15, depth)
        return found

    def value(self, kind: int, depth: int) -> Any:
        if kind in {TRUE, FALSE}:
            return kind == TRUE
        if kind in WHOLE:
            return self.signed()
        if kind == STRUCT:
            return self.struct(depth + 1)
        if kind in {BYTE, DOUBLE, BINARY}:
            return self.skip({BYTE: 1, DOUBLE: 8}.get(kind) or self.number())
        if kind == LIST:
            return self.values(depth)
        raise BadPage  # sets and maps: the format has none

    def values(self, depth: int) -> list[Any]:
        """A list."""
        head = self.byte()
        count, kind = head >> 4, head & 15
        count = self.number() if count == 15 else count
        if count > len(self.data) - self.at:
            raise BadPage
        return [self.byte() == TRUE if kind in {TRUE, FALSE} else self.value(kind, depth) for _ in range(count)]
