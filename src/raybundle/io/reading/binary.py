"""Binary files, read from front to back; every count is held against what is left of the file."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from raybundle.errors import InputError, Value, content
from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.words import finite, quoted
from raybundle.numerics.arrays import Array


class Binary:
    """A binary file that is read from front to back; every count is held against what is left of the file."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.data = read_bytes(path, 1 << 36)
        self.position = 0

    def fail(self, code: str, /, **values: Value) -> NoReturn:
        """Raise at this position, which is the value `byte`."""
        raise InputError(content(code, {**values, "byte": self.position}), file=self.path)

    def take(self, layout: str) -> tuple[Any, ...]:
        """The next values, little endian, in the notation of `struct`."""
        size = struct.calcsize("<" + layout)
        if size > len(self.data) - self.position:
            self.fail("binary.ends_in_record")
        values = struct.unpack_from("<" + layout, self.data, self.position)
        self.position += size
        return values

    def floats(self, count: int, kind: str, number: int) -> tuple[float, ...]:
        """The next numbers, which must be finite, of a kind of object and its number in the file."""
        values = self.take(f"{count}d")
        found = [finite(v) for v in values]
        if None in found:
            self.fail("binary.number_not_finite", kind=kind, number=number)
        return tuple(v for v in found if v is not None)

    def count(self, least_bytes: int, kind: str) -> int:
        """The next 64-bit count; refused where the rest of the file cannot hold so many records."""
        (number,) = self.take("Q")
        left = (len(self.data) - self.position) // least_bytes
        if number > left:
            self.fail("binary.count_too_large", kind=kind, n=number, most=left)
        return int(number)

    def records(self, dtype: np.dtype[Any], count: int) -> Array:
        """The next `count` records."""
        if count * dtype.itemsize > len(self.data) - self.position:
            self.fail("binary.ends_in_record")
        records = np.frombuffer(self.data, dtype, count, self.position)
        self.position += count * dtype.itemsize
        return records

    def name(self) -> str:
        """The next text, closed by a zero byte."""
        end = self.data.find(b"\0", self.position, self.position + 4096)
        if end < 0:
            self.fail("binary.name_too_long", most=4096)
        try:
            text = self.data[self.position : end].decode("utf-8")
        except UnicodeDecodeError:
            self.fail("binary.name_not_utf8")
        if not text.strip() or not text.isprintable():
            raise InputError("name.unprintable", name=quoted(text), file=self.path)
        self.position = end + 1
        return text

    def end(self) -> None:
        """Raise where something is left."""
        if self.position != len(self.data):
            self.fail("binary.bytes_left", n=len(self.data) - self.position)
