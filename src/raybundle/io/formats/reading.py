"""Reading what others wrote: JSON, XML and binary files, checked before anything is allocated or believed."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn, cast
from xml.parsers import expat

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

TEXT_BYTES = 1 << 30
"""Largest text file that is read at once."""
DEEPEST = 100


def read_bytes(path: Path, limit: int = TEXT_BYTES) -> bytes:
    """The bytes of a file; raises InputError where it cannot be read or is larger than the limit."""
    try:
        size = path.stat().st_size
        if size > limit:
            raise InputError(f"{size} bytes, more than the {limit} that are read; is it the right file?", file=path)
        return path.read_bytes()
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}; check the path and the permissions", file=path) from None


def read_text(path: Path) -> str:
    """The text of a UTF-8 file, without a byte order mark."""
    data = read_bytes(path)
    try:
        return data.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise InputError(
            f"byte 0x{data[error.start]:02x} is not UTF-8; save the file with the encoding UTF-8", file=path, line=line
        ) from None


@dataclass(frozen=True, slots=True)
class Json:
    """A JSON value with the way to it, for messages."""

    file: Path
    value: Any
    at: str = ""

    def fail(self, message: str) -> NoReturn:
        """Raise at this place."""
        raise InputError(message, file=self.file, column=self.at or None)

    def _below(self, key: str | int, value: object) -> Json:
        return Json(self.file, value, f"{self.at}.{key}" if self.at else str(key))

    def mapping(self) -> Mapping[str, Json]:
        """The members of an object."""
        if not isinstance(self.value, dict):
            self.fail("a JSON object is needed here")
        return {k: self._below(k, v) for k, v in cast("dict[str, Any]", self.value).items()}

    def items(self) -> list[Json]:
        """The elements of an array."""
        if not isinstance(self.value, list):
            self.fail("a JSON array is needed here")
        return [self._below(k, v) for k, v in enumerate(cast("list[Any]", self.value))]

    def has(self, key: str) -> bool:
        """Whether an object has a member that is not null."""
        return isinstance(self.value, dict) and cast("dict[str, Any]", self.value).get(key) is not None

    def get(self, key: str) -> Json:
        """A member of an object."""
        if not isinstance(self.value, dict):
            self.fail("a JSON object is needed here")
        if not self.has(key):
            self.fail(f"key {key!r} is missing")
        return self._below(key, cast("dict[str, Any]", self.value)[key])

    def text(self) -> str:
        """A string that can be printed."""
        if not isinstance(self.value, str) or not self.value.isprintable():
            self.fail(f"{shown(self.value)} is not a text that can be printed")
        return self.value

    def number(self) -> float:
        """A finite number."""
        if isinstance(self.value, bool) or not isinstance(self.value, int | float):
            self.fail(f"{shown(self.value)} is not a number")
        try:
            number = float(self.value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            self.fail(f"{shown(self.value)} is not a finite number")
        return number

    def optional(self, key: str, default: float = 0.0) -> float:
        """A member that is a number, or the default where there is none."""
        return self.get(key).number() if self.has(key) else default

    def whole(self, least: int = 1, most: int = 10_000_000) -> int:
        """A whole number between two limits."""
        number = self.number()
        if number != int(number) or not least <= number <= most:
            self.fail(f"{shown(self.value)} is not a whole number from {least} to {most}")
        return int(self.value)

    def numbers(self, count: int) -> Array:
        """(count,) finite numbers."""
        items = self.items()
        if len(items) != count:
            self.fail(f"{len(items)} elements, {count} are needed")
        return np.array([i.number() for i in items])


def read_json(path: Path) -> Json:
    """The value in a JSON file; raises InputError with the line of a mistake."""
    text = read_text(path)
    try:
        return Json(path, json.loads(text))
    except json.JSONDecodeError as error:
        cut = "; the file is cut off: get it again" if error.pos >= len(text.rstrip()) - 1 else ""
        message = f"this is not JSON: {error.msg} (character {error.colno}){cut}"
        raise InputError(message, file=path, line=error.lineno) from None
    except (RecursionError, ValueError):
        raise InputError("this is not JSON: nested too deeply, or a number is too long", file=path) from None


def shown(value: object) -> str:
    """An offending value as it is quoted in a message."""
    text = repr(value)
    return text if len(text) <= 40 else text[:40] + "..."


@dataclass(slots=True)
class Element:
    """An XML element; unlike the rest it is filled while it is read."""

    file: Path
    line: int
    name: str
    attributes: Mapping[str, str]
    children: list[Element] = field(default_factory=list["Element"])
    content: str = ""

    def fail(self, message: str) -> NoReturn:
        """Raise at this element."""
        raise InputError(message, file=self.file, line=self.line, column=self.name)

    def all(self, name: str) -> Iterator[Element]:
        """Children of this name."""
        return (c for c in self.children if c.name == name)

    def find(self, *names: str) -> Element | None:
        """The first element down this way of names."""
        found: Element | None = self
        for name in names:
            found = next(found.all(name), None) if found is not None else None
        return found

    def get(self, *names: str) -> Element:
        """The same; raises InputError where there is none."""
        found = self.find(*names)
        if found is None:
            self.fail(f"element {'/'.join(names)} is missing")
        return found

    def attribute(self, name: str) -> str:
        """An attribute; raises InputError where there is none."""
        if name not in self.attributes:
            self.fail(f"attribute {name!r} is missing")
        return self.attributes[name]

    def numbers(self, count: int) -> Array:
        """(count,) finite numbers, the content."""
        words = self.content.split()
        try:
            values = np.array([float(w) for w in words])
        except ValueError:
            self.fail(f"{shown(self.content.strip())} is not a row of numbers")
        if len(values) != count or not np.isfinite(values).all():
            self.fail(f"{len(values)} numbers, {count} finite ones are needed")
        return values

    def number(self, name: str, default: float | None = None) -> float:
        """The number in a child, or the default where there is none."""
        child = self.find(name)
        if child is None and default is not None:
            return default
        return float(self.get(name).numbers(1)[0])


def read_xml(path: Path, root: str) -> Element:
    """The root element; document types and entities of their own are refused, and so is deep nesting.

    raises  InputError with the line
    """
    data = read_bytes(path)
    parser = expat.ParserCreate()
    stack: list[Element] = []
    top: list[Element] = []

    def begin(name: str, attributes: dict[str, str]) -> None:
        element = Element(path, parser.CurrentLineNumber, name, attributes)
        if len(stack) >= DEEPEST:
            element.fail(f"nested more than {DEEPEST} deep")
        (stack[-1].children if stack else top).append(element)
        stack.append(element)

    def end(_: str) -> None:
        stack.pop()

    def characters(text: str) -> None:
        if stack:
            stack[-1].content += text

    def doctype(*_: object) -> None:
        raise InputError(
            "a document type (DOCTYPE) is not read, for safety; take it out", file=path, line=parser.CurrentLineNumber
        )

    parser.buffer_text = True
    parser.StartElementHandler, parser.EndElementHandler = begin, end
    parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = characters, doctype
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        cut = "; the file is cut off: get it again" if error.lineno >= data.count(b"\n") else ""
        message = f"this is not XML: {expat.ErrorString(error.code)}{cut}"
        raise InputError(message, file=path, line=error.lineno) from None
    except (ValueError, LookupError) as error:
        raise InputError(f"this is not XML that can be read: {error}", file=path, line=1) from None
    if not top or top[0].name != root:
        raise InputError(f"the root element is {top[0].name if top else 'missing'}, not {root}", file=path, line=1)
    return top[0]


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
        if not all(map(math.isfinite, values)):
            self.fail(f"{what} holds a number that is not finite")
        return values

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
            self.fail(f"{shown(text)} is no name that can be printed")
        self.position = end + 1
        return text

    def end(self) -> None:
        """Raise where something is left."""
        if self.position != len(self.data):
            self.fail(f"{len(self.data) - self.position} bytes are left over; another version of the format?")
