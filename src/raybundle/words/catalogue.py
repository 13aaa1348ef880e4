"""The files of the languages, cut into entries; an entry is parsed when it is read for the first time."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

ENGLISH = "en"
FOLDER = Path(__file__).parent
TEXTS = "texts"
"""Folder of a language for texts that are no messages"""
_BEGIN = re.compile(r"(-?[a-zA-Z][\w-]*) *=")
_EXAMPLE = re.compile(r"# \$(\w+) = (.+)")


@dataclass(frozen=True, slots=True, eq=False)
class Entry:
    """One entry of a catalogue as it stands in its file."""

    name: str
    """of a term with its dash"""
    text: str
    examples: Mapping[str, str]
    """values of the comments before it, by name, as JSON"""
    file: str
    line: int
    """of the file, from 1"""


@cache
def languages() -> tuple[str, ...]:
    """Codes of the languages, English first."""
    found = {f.parent.name for f in FOLDER.glob("*/*.ftl")}
    return (ENGLISH, *sorted(found - {ENGLISH}))


@cache
def entries(language: str) -> Mapping[str, Entry]:
    """The entries of a language by name; raises ValueError where a name stands twice."""
    found: dict[str, Entry] = {}
    for file in sorted((FOLDER / language).rglob("*.ftl")):
        for entry in _cut(file.read_text(encoding="utf-8"), file.relative_to(FOLDER).as_posix()):
            if entry.name in found:
                raise ValueError(f"{entry.file}, line {entry.line}: {entry.name} is in {found[entry.name].file}, too")
            found[entry.name] = entry
    return found


def _cut(text: str, file: str) -> list[Entry]:
    """The entries of a file."""
    found: list[Entry] = []
    begin, lines, examples, waiting = 0, list[str](), dict[str, str](), dict[str, str]()
    name = ""
    for number, line in enumerate([*text.splitlines(), "end ="], 1):
        example = _EXAMPLE.fullmatch(line)
        start = _BEGIN.match(line)
        if example:
            waiting[example[1]] = example[2]
        elif start:
            if name:
                found.append(Entry(name, "\n".join(lines).rstrip() + "\n", examples, file, begin))
            name, lines, begin = start[1], [line], number
            examples, waiting = waiting, {}
        elif not line.startswith("#"):
            lines.append(line)
    return found


def entry_of(code: str) -> str:
    """The name of a code's entry: a dash in the place of the dot."""
    return code.replace(".", "-")


def code_of(entry: str) -> str:
    """The code of an entry."""
    return entry.replace("-", ".")


@cache
def codes() -> tuple[str, ...]:
    """Codes of all messages, in order."""
    return _codes(texts=False)


@cache
def text_codes() -> tuple[str, ...]:
    """Codes of texts of reports and summaries, in order; no message has them."""
    return _codes(texts=True)


def _codes(*, texts: bool) -> tuple[str, ...]:
    found = entries(ENGLISH).items()
    return tuple(sorted(code_of(n) for n, e in found if not n.startswith("-") and (f"/{TEXTS}/" in e.file) == texts))


def examples(code: str) -> dict[str, Any]:
    """Values of a code by name, as an example."""
    import msgspec

    return {name: msgspec.json.decode(text) for name, text in entries(ENGLISH)[entry_of(code)].examples.items()}
