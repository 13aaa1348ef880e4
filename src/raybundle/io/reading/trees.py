"""JSON and TOML: bounded nesting, no key twice, numbers that are finite; every value knows the way to itself."""

from __future__ import annotations

import ast
import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn, cast

import numpy as np

from raybundle.errors import InputError, Message, Value, content, message
from raybundle.io.reading.files import TEXT_BYTES, read_text
from raybundle.io.reading.ledger import enter_tree
from raybundle.io.reading.words import NOT_FINITE, finite, no_number, quoted, whole_of
from raybundle.numerics.arrays import Array

DEEPEST = 100
"""Levels of nesting; no format that is read has more than twelve."""
TOML_BYTES = 1 << 23
_TOKEN = re.compile(r'"(?:[^"\\]|\\[\s\S])*+(?:"|\Z)|[\[\]{}]')
_KEY = re.compile(r"""\s*([A-Za-z0-9_-]+|"[^"]*"|'[^']*')\s*[=.]""")


class Asked(dict[str, "Asked"]):
    """Keys that a reader asked for, as a tree; MEMBER and ELEMENT stand for all members and elements."""

    __slots__ = ()

    def below(self, key: str) -> Asked:
        """The keys asked for below a key, which counts as asked for."""
        if key not in self:
            self[key] = Asked()
        return self[key]


MEMBER, ELEMENT = "\0*", "\0[]"


def _passed_over(value: object, asked: Asked, name: str) -> Iterator[tuple[str, str]]:
    """Keys that hold something and were not asked for; a value of which nothing was asked is read as a whole."""
    if isinstance(value, dict) and asked:
        for key, member in cast("dict[str, Any]", value).items():
            below = asked.get(key, asked.get(MEMBER))
            if below is not None:
                yield from _passed_over(member, below, key if key in asked else name)
            elif member not in (None, "", [], {}):
                yield key, _step(f"{name}.{key}" if name else key)
    elif isinstance(value, list) and asked.get(ELEMENT):
        for element in cast("list[Any]", value):
            yield from _passed_over(element, asked[ELEMENT], name)


@dataclass(frozen=True, slots=True)
class Json:
    """A JSON value with the way to it, for messages."""

    file: Path
    value: Any
    at: str = ""
    asked: Asked = field(default_factory=Asked, repr=False, compare=False)

    def fail(self, code: str | Message, /, **values: Value) -> NoReturn:
        """Raise at this place."""
        raise InputError(content(code, values), file=self.file, column=self.at or None)

    def _below(self, key: str | int, value: object, asked: Asked) -> Json:
        return Json(self.file, value, f"{self.at}.{_step(key)}" if self.at else _step(key), asked)

    def passed_over(self) -> Iterator[tuple[str, str]]:
        """Keys that hold something and were not asked for, each with the key above it."""
        return _passed_over(self.value, self.asked, "")

    def mapping(self) -> Mapping[str, Json]:
        """The members of an object."""
        if not isinstance(self.value, dict):
            self.fail("value.no_table")
        asked = self.asked.below(MEMBER)
        return {k: self._below(k, v, asked) for k, v in cast("dict[str, Any]", self.value).items()}

    def items(self) -> list[Json]:
        """The elements of an array."""
        if not isinstance(self.value, list):
            self.fail("value.no_list")
        asked = self.asked.below(ELEMENT)
        return [self._below(k, v, asked) for k, v in enumerate(cast("list[Any]", self.value))]

    def names(self) -> list[str]:
        """Names of the members of an object; their values count as passed over until a reader asks for them."""
        if not isinstance(self.value, dict):
            self.fail("value.no_table")
        return list(cast("dict[str, Any]", self.value))

    def has(self, key: str) -> bool:
        """Whether an object has a member that is not null."""
        return isinstance(self.value, dict) and cast("dict[str, Any]", self.value).get(key) is not None

    def get(self, key: str) -> Json:
        """A member of an object."""
        if not isinstance(self.value, dict):
            self.fail("value.no_table")
        if not self.has(key):
            self.fail("value.key_missing", name=quoted(key))
        return self._below(key, cast("dict[str, Any]", self.value)[key], self.asked.below(key))

    def text(self) -> str:
        """A string that can be printed."""
        if not isinstance(self.value, str) or not self.value.isprintable():
            self.fail("value.no_text", value=quoted(self.value))
        return self.value

    def number(self) -> float:
        """A finite number."""
        number = finite(self.value)
        if number is None:
            near = isinstance(self.value, float | int) or NOT_FINITE.fullmatch(str(self.value))
            near = near and not isinstance(self.value, bool)
            self.fail(no_number(self.value) if near else message("value.not_a_number", value=quoted(self.value)))
        return number

    def optional(self, key: str, default: float = 0.0) -> float:
        """A member that is a number, or the default where there is none."""
        return self.get(key).number() if self.has(key) else default

    def positive(self) -> float:
        """A finite number above 0."""
        number = self.number()
        if number <= 0:
            self.fail("value.not_above", value=number, limit=0.0)
        return number

    def truth(self) -> bool:
        """True or false."""
        if not isinstance(self.value, bool):
            self.fail("value.no_truth_value", value=quoted(self.value))
        return self.value

    def whole(self, least: int = 1, most: int = 10_000_000) -> int:
        """A whole number between two limits."""
        value = self.value if isinstance(self.value, int) and not isinstance(self.value, bool) else self.number()
        if not least <= value <= most or value != int(value):
            self.fail("value.not_whole", value=quoted(self.value), least=least, most=most)
        return int(value)

    def numbers(self, count: int) -> Array:
        """(count,) finite numbers."""
        items = self.items()
        if len(items) != count:
            self.fail("value.count", n=len(items), needed=count)
        return np.array([i.number() for i in items])


def _step(key: str | int) -> str:
    """A key as it stands in the way to a value."""
    text = str(key)
    return text if text.isprintable() and len(text) <= 80 else quoted(text)


class _Twice(ValueError):
    """A key that stands twice."""


class _NotFinite(ValueError):
    """NaN or Infinity, which JSON does not know."""


def read_json(path: Path, limit: int = TEXT_BYTES) -> Json:
    """The value in a JSON file; raises InputError with the line of a mistake."""
    top = Json(path, json_of(read_text(path, limit), path))
    enter_tree(top)
    return top


def json_of(text: str, path: Path) -> Any:
    """The value of a JSON text; `path` is named in messages.

    raises  InputError with the line of a mistake; for a key that stands twice in an object, NaN, Infinity, or more
            than DEEPEST levels
    """
    try:
        if _deep(text):
            raise InputError("file.nested_too_deeply", most=DEEPEST, file=path)
        return json.loads(text, parse_constant=_constant, object_pairs_hook=_members)
    except json.JSONDecodeError as error:
        cut = error.pos >= len(text.rstrip()) - 1
        raise InputError(
            "json.invalid", detail=error.msg, character=error.colno, cut=cut, file=path, line=error.lineno
        ) from None
    except _Twice as error:
        raise InputError("json.key_twice", name=quoted(str(error)), file=path) from None
    except _NotFinite as error:
        line = text.count("\n", 0, max(text.find(str(error)), 0)) + 1
        raise InputError(
            "json.not_finite", value=str(error), file=path, line=line, column=_not_finite_at(text)
        ) from None
    except RecursionError:
        raise InputError("file.nested_too_deeply", most=DEEPEST, file=path) from None
    except ValueError:
        raise InputError("file.number_too_long", file=path) from None


def own_json_of(text: str) -> Any:
    """The value of a JSON text that this program wrote into a file of its own, with numbers that are not finite."""
    return json.loads(text)


def _constant(word: str) -> NoReturn:
    raise _NotFinite(word)


def _not_finite_at(text: str) -> str | None:
    """The way to the first number that is not finite, in a text that json refuses for it."""
    marks: list[object] = []

    def mark(_: str) -> object:
        marks.append(object())
        return marks[-1]

    def below(value: object, at: str) -> str | None:
        if value is marks[0]:
            return at
        steps = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
        ways = (below(v, f"{at}.{_step(k)}" if at else _step(k)) for k, v in steps)
        return next((w for w in ways if w is not None), None)

    try:
        return below(json.loads(text, parse_constant=mark), "") or None
    except (ValueError, RecursionError):
        return None


def _members(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        seen: set[str] = set()
        for key, _ in pairs:
            if key in seen:
                raise _Twice(key)
            seen.add(key)
    return found


def _deep(text: str) -> bool:
    """Whether brackets outside of texts are nested more than DEEPEST deep."""
    if text.count("[") + text.count("{") <= DEEPEST:
        return False
    if len(text) > 1 << 20:  # json's own limit of recursion holds there; a scan would take longer than the reading
        return False
    depth = 0
    for token in _TOKEN.finditer(text):
        if (first := token[0][0]) in "[{":
            depth += 1
            if depth > DEEPEST:
                return True
        elif first in "]}":
            depth -= 1
    return False


def python_of(text: str, path: Path) -> Any:
    """The value of a Python literal (mappings, lists, numbers, texts), as some programs write their files."""
    try:
        if len(text) > TOML_BYTES:
            raise InputError("file.too_large", size_bytes=len(text), limit_bytes=TOML_BYTES, file=path)
        if _deep(text):
            raise InputError("file.nested_too_deeply", most=DEEPEST, file=path)
        return ast.literal_eval(text)
    except SyntaxError as error:
        raise InputError("file.not_understood", detail=error.msg, file=path, line=error.lineno) from None
    except (ValueError, TypeError, MemoryError, RecursionError, OverflowError) as error:
        raise InputError("file.not_understood", detail=quoted(str(error)), file=path) from None


@dataclass(frozen=True, slots=True)
class Toml:
    """The top table of a TOML file, and the line in which each key stands."""

    file: Path
    values: dict[str, Any]
    lines: Mapping[tuple[str, ...], int]

    def tree(self) -> Json:
        """The same as a value that knows the way to itself."""
        return Json(self.file, self.values)


def read_toml(path: Path) -> Toml:
    """The contents of a TOML file; raises InputError with the line of a mistake."""
    return toml_of(read_text(path, TOML_BYTES), path)


def toml_of(text: str, path: Path) -> Toml:
    """The contents of a TOML text; `path` is named in messages."""
    try:
        if _deep(text):
            raise InputError("file.nested_too_deeply", most=DEEPEST, file=path)
        values = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        found = re.search(r" \(at line (\d+), column (\d+)\)", str(error))
        line = whole_of(found[1]) if found else text.count("\n") + 1
        detail = str(error).replace(found[0], f" (character {found[2]})") if found else str(error)
        raise InputError("toml.invalid", detail=detail, file=path, line=line) from None
    except RecursionError:
        raise InputError("file.nested_too_deeply", most=DEEPEST, file=path) from None
    except ValueError:
        raise InputError("file.number_too_long", file=path) from None
    return Toml(path, values, _lines_of_keys(text))


def _lines_of_keys(text: str) -> dict[tuple[str, ...], int]:
    """The line in which each table and key stands; keys within inline tables are not looked for."""
    lines: dict[tuple[str, ...], int] = {}
    at: tuple[str, ...] = ()
    for number, line in enumerate(text.split("\n"), 1):
        if line.lstrip().startswith("[") and "=" not in line:
            at = _header_path(line)
            lines.setdefault(at, number)
        elif found := _KEY.match(line):
            lines.setdefault((*at, found[1].strip("\"'")), number)
    return lines


def _header_path(line: str) -> tuple[str, ...]:
    try:
        nested: Any = tomllib.loads(line) if len(line) < 1000 else {}
    except (ValueError, RecursionError):
        return ()
    path: list[str] = []
    while isinstance(nested, dict) and nested:
        key, nested = next(iter(cast("dict[str, Any]", nested).items()))
        path.append(key)
    return tuple(path)
