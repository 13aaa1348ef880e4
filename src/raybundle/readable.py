r"""Names that can be written, read back and shown: the one rule for photographs, images, points and paths.

A file system holds names with line ends, escape sequences, blanks at their ends, spaces that look like others, bytes
that are no UTF-8.  In a table, an exchange format or a terminal such a character is written as in Python: \x1b,
\u202f; a blank at an end as \x20; a byte as \xff.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from pathlib import Path

HIDDEN = {"Cc", "Cf", "Cs"}
"""Categories of Unicode that a terminal may obey, or that nobody sees: control, format, surrogates"""


def readable(name: str) -> str:
    r"""The name in printable characters, without blanks at its ends; a readable one is returned unchanged."""
    inner = name.strip(" ")
    if inner.isprintable() and inner == name:
        return name
    begin = len(name) - len(name.lstrip(" "))
    end = len(name) - begin - len(inner)
    return r"\x20" * begin + "".join(map(_escaped, inner)) + r"\x20" * end


def readable_names(names: Sequence[str]) -> tuple[str, ...]:
    """The same for names that differ: they differ afterwards, too; one that is readable already stays."""
    found = {name for name in names if readable(name) == name}
    result: list[str] = []
    for name in names:
        new = readable(name)
        if new != name:
            k, stem = 1, new
            while new in found:
                k += 1
                new = f"{stem}~{k}"
            found.add(new)
        result.append(new)
    return tuple(result)


def readable_path(path: Path) -> Path:
    """The path with each of its parts readable."""
    parts = [readable(part) for part in path.parts]
    return path if parts == [*path.parts] else Path(*parts)


def without_controls(text: str) -> str:
    """A text of several lines in which no character is left that a terminal obeys."""
    if text.isprintable():
        return text
    return "".join(c if c == "\n" or unicodedata.category(c) not in HIDDEN else _escaped(c) for c in text)


def _escaped(character: str) -> str:
    if character.isprintable():
        return character
    number = ord(character)
    if 0xDC80 <= number <= 0xDCFF:  # a byte that is no UTF-8, as Python holds it (PEP 383)
        return f"\\x{number - 0xDC00:02x}"
    if number < 0x80:
        return f"\\x{number:02x}"
    return f"\\u{number:04x}" if number < 0x10000 else f"\\U{number:08x}"
