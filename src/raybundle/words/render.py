"""The text of a code and its values in a language."""

from __future__ import annotations

import re
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from json import dumps
from typing import TYPE_CHECKING, Any, Literal

from raybundle.readable import without_controls
from raybundle.words.catalogue import ENGLISH, Entry, entries, entry_of

if TYPE_CHECKING:
    from raybundle.words.values import Bundle

Part = Literal["", "why", "do"]
_MENTIONED = re.compile(r"\{\s*(-?[a-zA-Z][\w-]*)(?![\w-]*\()")
_END = ".:!?"


@dataclass(frozen=True, slots=True)
class Reader:
    """Who reads a message."""

    language: str = ENGLISH
    flags: bool = False
    """whether a setting is a flag of the command line, or an argument in Python"""


PYTHON, COMMAND_LINE = Reader(), Reader(flags=True)
_readers = [PYTHON]


def reader() -> Reader:
    """Who reads messages of this process."""
    return _readers[-1]


def read_by(who: Reader) -> None:
    """Set who reads messages of this process, in all its threads."""
    _readers[-1] = who


@contextmanager
def reading(who: Reader) -> Generator[None]:
    """Set it meanwhile."""
    _readers.append(who)
    try:
        yield
    finally:
        _readers.pop()


def headline(code: str, values: Mapping[str, Any], reader: Reader = PYTHON) -> str:
    """What happened, in one line; the code and its values where no language has an entry for it."""
    found = _formatted(code, "", values, reader)
    return found or f"{code} {dumps(dict(values), default=str, ensure_ascii=False)}"


def why(code: str, values: Mapping[str, Any], reader: Reader = PYTHON) -> str:
    """Why it matters, in one sentence; empty where that is clear."""
    return _formatted(code, "why", values, reader)


def action(code: str, values: Mapping[str, Any], reader: Reader = PYTHON) -> str:
    """What to do, as an imperative; empty where there is nothing to be done."""
    return _formatted(code, "do", values, reader)


def sentences(code: str, values: Mapping[str, Any], reader: Reader = PYTHON) -> str:
    """All three, one after the other."""
    parts = [p for part in (headline, why, action) if (p := part(code, values, reader))]
    return " ".join([*(p if p[-1] in _END else f"{p}." for p in parts[:-1]), *parts[-1:]])


def _formatted(code: str, part: Part, values: Mapping[str, Any], reader: Reader) -> str:
    """One part of an entry, in English where the language lacks it; empty where there is no such part."""
    name = entry_of(code)
    for language in dict.fromkeys((reader.language, ENGLISH)):
        entry = entries(language).get(name)
        if entry is None:
            continue
        bundle = _with(language, entry, flags=reader.flags)
        message = bundle.get_message(name)
        pattern = message.attributes.get(part) if part else message.value
        if pattern is not None:
            return without_controls(bundle.written(pattern, values)[0]).strip()
    return ""


@cache
def _bundle(language: str, *, flags: bool) -> Bundle:
    from raybundle.words.values import Bundle

    return Bundle(language, flags=flags)


@cache
def _parsed(text: str) -> Any:
    from fluent.runtime import FluentResource

    return FluentResource(text)


def _with(language: str, entry: Entry, *, flags: bool) -> Bundle:
    """The bundle of a language with an entry and what it mentions in it."""
    bundle = _bundle(language, flags=flags)
    bundle.add_resource(_parsed(entry.text))
    for name in _MENTIONED.findall(entry.text):
        other = entries(language).get(name)
        if other is not None and other is not entry:
            _with(language, other, flags=flags)
    return bundle
