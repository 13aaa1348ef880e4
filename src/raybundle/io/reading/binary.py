"""Binary files, read from front to back; every count is held against what is left of the file."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.words import finite, quoted
from raybundle.numerics.arrays import Array


class Binary:
    """A binary file that is read from front to back; every count is held against what is left of the file."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.data = read_bytes(path, 1 << 36)
        self.position = 0

    def fail(self, message: str) -> NoReturn:
        """Raise at this position."""
        raise InputError(f"{message} (byte {self.position})", file=self.path)

    def take(self, layout: str) -> tuple[Any, ...]:
        """The next values, little endian, in the notation of `struct`."""
        size = struct.calcsize("<" + layout)
        if size > len(self.data) - self.position:
            self.fail("the file ends in the middle of a record; it is not complete")
        values = struct.unpack_from("<" + layout, self.data, self.position)
        self.position += size
        return values

    def floats(self, count: int, what: str) -> tuple[float, ...]:
        """The next numbers, which must be finite."""
        values = self.take(f"{count}d")
        found = [finite(v) for v in values]
        if None in found:
            self.fail(f"{what} holds a number that is not finite, or beyond all measure")
        return tuple(v for v in found if v is not None)

    def count(self, least_bytes: int, what: str) -> int:
        """The next 64-bit count; refused where the rest of the file cannot hold so many records."""
        (number,) = self.take("Q")
        left = (len(self.data) - self.position) // least_bytes
        if number > left:
            self.fail(f"{number} {what} are announced, the rest of the file has room for {left} at most")
        return int(number)

    def records(self, dtype: np.dtype[Any], count: int) -> Array:
        """The next `count` records."""
        if count * dtype.itemsize > len(self.data) - self.position:
            self.fail("the file ends in the middle of a record; it is not complete")
        records = np.frombuffer(self.data, dtype, count, self.position)
        self.position += count * dtype.itemsize
        return records

    def name(self) -> str:
        """The next text, closed by a zero byte."""
        end = self.data.find(b"\0", self.position, self.position + 4096)
        if end < 0:
            self.fail("a name has no end within 4096 bytes")
        try:
            text = self.data[self.position : end].decode("utf-8")
        except UnicodeDecodeError:
            self.fail("a name is not UTF-8")
        if not text.strip() or not text.isprintable():
            self.fail(f"{quoted(text)} is no name that can be printed")
        self.position = end + 1
        return text

    def end(self) -> None:
        """Raise where something is left."""
        if self.position != len(self.data):
            self.fail(f"{len(self.data) - self.position} bytes are left over; another version of the format?")
