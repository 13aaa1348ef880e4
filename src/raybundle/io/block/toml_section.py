"""A table of a TOML file, with the way to it for messages."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn, cast

from raybundle.errors import InputError, Message, Value, content
from raybundle.io.reading import trees
from raybundle.io.reading.words import finite, no_number, quoted


@dataclass(frozen=True, slots=True)
class Section:
    """One TOML table, with the way to it for messages."""

    file: Path
    lines: Mapping[tuple[str, ...], int]
    at: tuple[str, ...]
    values: Mapping[str, Any]

    def fail(self, key: str, code: str | Message, /, **values: Value) -> NoReturn:
        """Raise at the line of a key, or of the section."""
        place = (*self.at, key)
        line = self.lines.get(place, self.lines.get(self.at))
        raise InputError(content(code, values), file=self.file, line=line, column=".".join(place))

    def allow(self, keys: Sequence[str]) -> None:
        """Raise where another key stands."""
        for key in self.values:
            if key not in keys:
                self.fail(key, "toml.unknown_key", name=quoted(key), known=keys)

    def text(self, key: str, default: str) -> str:
        """A string."""
        value = self.values.get(key, default)
        if not isinstance(value, str):
            self.fail(key, "value.no_text", value=quoted(value))
        return value

    def choice(self, key: str, options: Sequence[str], default: str) -> str:
        """One of some words."""
        value = self.text(key, default)
        if value not in options:
            self.fail(key, "value.not_supported", value=quoted(value), known=options)
        return value

    def number(self, key: str, default: float | None = None, *, above: float = -math.inf) -> float:
        """A finite number greater than `above`."""
        value = self.values.get(key, default)
        if value is None:
            self.fail(key, "value.key_missing", name=key)
        return self.checked(key, value, above=above)

    def checked(self, key: str, value: object, *, above: float = -math.inf) -> float:
        """The value as a finite number greater than `above`."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            self.fail(key, "value.not_a_number", value=quoted(value))
        number = finite(value)
        if number is None:
            self.fail(key, no_number(value))
        if number <= above:
            self.fail(key, "value.not_above", value=number, limit=above)
        return number

    def whole(self, key: str) -> int:
        """A whole number greater than 0."""
        number = self.number(key, above=0)
        if number > 1e7 or number != int(number):
            self.fail(key, "value.not_whole", value=f"{number:g}", least=1, most=10_000_000)
        return int(number)

    def section(self, key: str) -> Section:
        """A table within this one; empty where there is none."""
        value = self.values.get(key, {})
        if not isinstance(value, dict):
            self.fail(key, "value.no_table")
        return Section(self.file, self.lines, (*self.at, key), cast("dict[str, Any]", value))


def read_toml(path: Path) -> Section:
    """The top table of a TOML file; raises InputError with the line of a mistake."""
    top = trees.read_toml(path)
    return Section(path, top.lines, (), top.values)
