"""Records of scene files with fields at fixed bytes, which count from 1 as their specifications count them."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from raybundle.errors import InputError, Message, Value, content
from raybundle.io.reading.files import opened
from raybundle.io.reading.words import finite, fortran_of, no_number

RECORD_BYTES = 1 << 24
"""More bytes has no record of a header."""
PIXELS = 10_000_000
"""More lines or columns has no image."""


@dataclass(frozen=True, slots=True)
class Record:
    """The bytes of one record."""

    path: Path
    name: str
    data: bytes

    @staticmethod
    def at(path: Path, name: str, first: int, size: int) -> Record:
        """The record of `size` bytes after `first` bytes of a file; raises InputError where the file ends before."""
        with opened(path) as file:
            file.seek(min(first, 1 << 62))
            data = file.read(min(size, RECORD_BYTES))
        if size < 1 or len(data) < size:
            raise InputError("binary.ends_in_record", byte=first + len(data), file=path, column=name)
        return Record(path, name, data)

    def fail(self, byte: int, code: str | Message, /, **values: Value) -> NoReturn:
        """Raise with the record and the byte in it."""
        message = content(code, values)
        raise InputError(message, file=self.path, column=f"{self.name}, byte {byte}")

    def field(self, first: int, last: int) -> bytes:
        """Bytes from the first to the last."""
        if last > len(self.data):
            self.fail(first, "binary.ends_in_record", byte=len(self.data))
        return self.data[first - 1 : last]

    def text(self, first: int, last: int) -> str:
        """Characters without blanks around them."""
        return self.field(first, last).decode("latin-1").strip(" \0")

    def number(self, first: int, last: int) -> float:
        """A number in characters, its exponent marked by E or D."""
        word = self.text(first, last)
        value = fortran_of(word)
        if value is None:
            self.fail(first, no_number(word))
        return value

    def pixels(self, first: int, last: int) -> int:
        """A number of lines or columns in characters."""
        return self.counted(first, self.number(first, last))

    def counted(self, byte: int, value: float) -> int:
        """A number of lines or columns."""
        if value != int(value) or not 1 <= value <= PIXELS:
            self.fail(byte, "scene.pixel_count", value=value)
        return int(value)

    def values(self, first: int, layout: str) -> tuple[float, ...]:
        """Binary numbers from the first byte on, big endian, in the notation of `struct`."""
        data = self.field(first, first - 1 + struct.calcsize(">" + layout))
        found: list[float] = []
        for value in struct.unpack(">" + layout, data):
            number = finite(value)
            if number is None:
                self.fail(first, no_number(value))
            found.append(number)
        return tuple(found)
