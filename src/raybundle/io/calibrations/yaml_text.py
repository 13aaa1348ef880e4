"""The part of YAML in which calibrations are written: mappings, lists, flow lists, numbers and texts.

Anchors, block texts, and documents after the first are refused; tags (`!!opencv-matrix`) are passed over.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn

from raybundle.errors import InputError, Value, content
from raybundle.io.reading.files import read_text
from raybundle.io.reading.ledger import enter_tree
from raybundle.io.reading.trees import Json
from raybundle.io.reading.words import number_of, quoted, whole_of

DEEPEST = 20
_ENTRY = re.compile(r"""("[^"]*"|'[^']*'|[^\s'"\[\]{},#:][^\[\]{}#:]*?)\s*:(?:\s+|$)(.*)""")
_TAG = re.compile(r"^!+[\w-]*\s*")
_COMMENT = re.compile(r"(^|\s)#.*$")


@dataclass(frozen=True, slots=True)
class _Line:
    number: int
    indent: int
    text: str


def read_yaml(path: Path) -> Json:
    """The value in a YAML file; raises InputError with the line of what is not understood."""
    top = Json(path, parse_yaml(read_text(path), path))
    enter_tree(top)
    return top


def parse_yaml(text: str, path: Path) -> Any:
    """The value in a YAML text; `path` is named in messages."""
    reader = _Reader(path, _lines(text, path))
    if not reader.lines:
        raise InputError("file.empty", file=path)
    value = reader.block(reader.lines[0].indent, 0)
    if reader.at < len(reader.lines):
        reader.fail("yaml.indentation")
    return value


def _lines(text: str, path: Path) -> list[_Line]:
    """Lines without comments, each flow list joined into one line."""
    lines: list[_Line] = []
    open_ = 0
    ended = False
    for number, raw in enumerate(text.split("\n"), 1):
        line = _COMMENT.sub("", raw).rstrip()
        if ended and line.strip() and not line.startswith(("---", "...", "%")):
            raise InputError("yaml.second_document", file=path, line=number)
        if line.startswith(("%", "---")) and not lines:
            continue
        if line in {"---", "..."}:
            ended = True
            continue
        if not line.strip():
            continue
        if "\t" in line[: len(line) - len(line.lstrip())]:
            raise InputError("yaml.tab", file=path, line=number)
        if open_:
            lines[-1] = _Line(lines[-1].number, lines[-1].indent, lines[-1].text + " " + line.strip())
        else:
            lines.append(_Line(number, len(line) - len(line.lstrip()), line.strip()))
        open_ += sum(line.count(c) for c in "[{") - sum(line.count(c) for c in "]}")
    if open_ > 0:
        raise InputError("yaml.open_list", file=path, line=lines[-1].number)
    return lines


class _Reader:
    """Reads lines from top to bottom."""

    def __init__(self, path: Path, lines: list[_Line]) -> None:
        self.path, self.lines, self.at = path, lines, 0

    def fail(self, code: str, /, **values: Value) -> NoReturn:
        line = self.lines[min(self.at, len(self.lines) - 1)]
        raise InputError(content(code, values), file=self.path, line=line.number)

    def block(self, indent: int, depth: int) -> Any:
        """The mapping or list whose lines stand `indent` far in."""
        if depth > DEEPEST:
            self.fail("file.nested_too_deeply", most=DEEPEST)
        if self.lines[self.at].text.startswith(("- ", "[")) or self.lines[self.at].text == "-":
            return self._list(indent, depth)
        return self._mapping(indent, depth)

    def _mapping(self, indent: int, depth: int) -> dict[str, Any]:
        values: dict[str, Any] = {}
        while self.at < len(self.lines) and self.lines[self.at].indent == indent:
            entry = _ENTRY.fullmatch(self.lines[self.at].text)
            if entry is None:
                self.fail("yaml.no_entry")
            key, rest = entry[1].strip("\"'"), _TAG.sub("", entry[2])
            if key in values:
                self.fail("json.key_twice", name=quoted(key))
            values[key] = self._value(rest, indent, depth)
        return values

    def _list(self, indent: int, depth: int) -> Any:
        if self.lines[self.at].text.startswith("["):
            return self._value(self.lines[self.at].text, indent, depth)
        values: list[Any] = []
        while self.at < len(self.lines) and self.lines[self.at].indent == indent:
            line = self.lines[self.at]
            if not line.text.startswith("-"):
                break
            rest = line.text[1:]
            if _ENTRY.fullmatch(rest.strip()) and not rest.strip().startswith(("[", "{")):
                inner = indent + 1 + len(rest) - len(rest.lstrip())
                self.lines[self.at] = _Line(line.number, inner, rest.strip())
                values.append(self.block(inner, depth + 1))
            else:
                values.append(self._value(rest.strip(), indent, depth))
        return values

    def _value(self, rest: str, indent: int, depth: int) -> Any:
        """What stands after a key or a dash, or in the lines below it."""
        if rest:
            value = self._scalar(rest, depth)
            self.at += 1
            return value
        self.at += 1
        if self.at == len(self.lines):
            return None
        below = self.lines[self.at]
        if below.indent > indent or (below.indent == indent and below.text.startswith("- ")):
            return self.block(below.indent, depth + 1)
        return None

    def _scalar(self, text: str, depth: int) -> Any:
        if text.startswith(("[", "{")):
            value, rest = self._flow(text, depth)
            if rest.strip():
                self.fail("yaml.list_form")
            return value
        if text.startswith(("&", "*", "|", ">")):
            self.fail("yaml.not_supported")
        return _plain(text)

    def _flow(self, text: str, depth: int) -> tuple[Any, str]:
        """A flow list or mapping at the beginning of a text, and the rest."""
        if depth > DEEPEST:
            self.fail("file.nested_too_deeply", most=DEEPEST)
        opening, closing = text[0], {"[": "]", "{": "}"}[text[0]]
        items: list[Any] = []
        mapping: dict[str, Any] = {}
        rest = text[1:].lstrip()
        while not rest.startswith(closing):
            key = ""
            if opening == "{":
                key, colon, rest = rest.partition(":")
                if not colon:
                    self.fail("yaml.no_entry")
                rest = rest.lstrip()
            if rest.startswith(("[", "{")):
                value, rest = self._flow(rest, depth + 1)
            else:
                word = re.match(r"""\s*("[^"]*"|'[^']*'|[^,\[\]{}]*)""", rest)
                assert word is not None
                value, rest = _plain(word[1].strip()), rest[word.end() :]
            items.append(value)
            mapping[key.strip().strip("\"'")] = value
            rest = rest.lstrip()
            if rest.startswith(","):
                rest = rest[1:].lstrip()
            elif not rest.startswith(closing):
                self.fail("yaml.list_form")
        return (mapping if opening == "{" else items), rest[1:]


def _plain(text: str) -> Any:
    """A number, truth value, nothing, or text."""
    if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'":
        return text[1:-1]
    if text in {"", "~", "null"}:
        return None
    if text.lower() in {"true", "false"}:
        return text.lower() == "true"
    found: int | float | None = whole_of(text)
    if found is None:
        found = number_of(text)
    return text if found is None else found
