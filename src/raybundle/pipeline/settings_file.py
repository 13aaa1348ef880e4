"""project.toml beside the settings of the last run: tables of other hands, which a run leaves as they are."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

from raybundle.errors import InputError
from raybundle.io.reading.files import read_text
from raybundle.io.reading.trees import TOML_BYTES, read_toml, toml_of

_TABLE = re.compile(r"""^\s*\[\[?\s*(?:([A-Za-z0-9_-]+)|"([^"\\]+)"|'([^']+)')""")
_ENTRY = re.compile(r"""^\s*(?:([A-Za-z0-9_-]+)|"([^"\\]+)"|'([^']+)')\s*=""")
_STRINGS = re.compile(
    r"""(?P<basic>\"\"\")|(?P<literal>''')|"(?:[^"\\]|\\.)*"|'[^']*'|(?P<comment>\#.*)|\\.|.""", re.DOTALL
)


def tables_of(path: Path) -> dict[str, str]:
    """The tables of a project.toml by name, each as it stands there, comments with it; {} where there is no file.

    A comment before a table belongs to it.  raises InputError, with the line, for a file that is no TOML
    """
    if not path.is_file():
        return {}
    read_toml(path)  # mistakes are reported with their line
    found: dict[str, list[str]] = {}
    name, waiting, inside = "", list[str](), ""
    for line in read_text(path, TOML_BYTES).splitlines():
        header = None if inside else _TABLE.match(line)
        inside = _within(line, inside)
        if header is not None:
            name = header[1] or header[2] or header[3]
            found.setdefault(name, []).extend(waiting)
            waiting = []
        elif not inside and (not line.strip() or line.lstrip().startswith("#")):
            waiting.append(line)
            continue
        found.setdefault(name, []).extend([*waiting, line])
        waiting = []
    if waiting:
        found.setdefault(name, []).extend(waiting)
    return {name: "\n".join(lines).strip("\n") for name, lines in found.items()}


def _within(line: str, inside: str) -> str:
    """The mark of the text of several lines within which a line ends; "" where it ends in none.

    inside  the same of the line before
    """
    at = 0
    while at < len(line):
        if inside:
            end = line.find(inside, at)
            while inside == '"""' and end > 0 and _escaped(line, end):
                end = line.find(inside, end + 1)
            if end < 0:
                return inside
            inside, at = "", end + 3
            while at < len(line) and line[at] == line[end]:  # quotation marks may stand before the end
                at += 1
            continue
        found = _STRINGS.match(line, at)
        assert found is not None
        if found["comment"]:
            return ""
        inside = found["basic"] or found["literal"] or ""
        at = found.end()
    return inside


def _escaped(line: str, at: int) -> bool:
    before = line[:at]
    return (len(before) - len(before.rstrip("\\"))) % 2 == 1


def with_table(path: Path, name: str, text: str) -> str:
    """The file with one table in another wording, all others as they stand; "" takes it away.

    raises  InputError where the others would not be the same afterwards: nothing is lost then
    """
    tables = tables_of(path)
    ours = {name: text.strip("\n")} if text else {}
    if name in tables and text:
        every = {**tables, **ours}  # where it stands
    else:
        tables.pop(name, None)
        every = {**ours, **tables} if name == "orient" else {**tables, **ours}
    done = "\n\n".join(t for t in every.values() if t) + "\n"
    if _others(done, name) != (_others(read_text(path, TOML_BYTES), name) if path.is_file() else {}):
        raise InputError(
            "project.table_not_writable",
            table=name,
            file=path,
        )
    return done


def with_entries(path: Path, name: str, entries: Mapping[str, str]) -> str:
    """The file with these texts for the entries of one table: what stands in it keeps its order and its comments.

    entries  all that the table is to hold; a table without any is taken away
    raises   InputError where other tables would not be the same afterwards: nothing is lost then
    """
    before = tables_of(path).get(name, "")
    written = {key: f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in entries.items()}
    plain = "\n".join([f"[{name}]", *written.values()])  # a JSON text is one of TOML
    if not entries:
        return with_table(path, name, "")
    stated = toml_of(before, path).values.get(name, {}) if before else {}
    edited = _edited(before, stated, entries, written) if isinstance(stated, dict) and stated else ""
    kept = _texts(edited, name) == dict(entries)
    return with_table(path, name, edited if kept else plain)


def _edited(before: str, stated: Mapping[str, Any], entries: Mapping[str, str], written: Mapping[str, str]) -> str:
    """The lines of a table with other texts for some of its entries, new ones behind the last."""
    lines: list[str] = []
    key, inside, last = "", "", 0
    for line in before.splitlines():
        found = None if inside else _ENTRY.match(line)
        inside = _within(line, inside)
        if found is not None:
            key = found[1] or found[2] or found[3]
        elif not key or not line.strip() or line.lstrip().startswith("#"):
            key = key if inside else ""
        same = key not in stated or (key in entries and str(stated[key]) == entries[key])
        if not key or same:
            lines.append(line)
        elif found is not None and key in written:
            lines.append(written[key] + _comment(line))
        if key:
            last = len(lines)
            key = key if inside else ""
    new = [text for entry, text in written.items() if entry not in stated]
    at = last or len(lines)
    return "\n".join([*lines[:at], *new, *lines[at:]])


def _comment(line: str) -> str:
    """The comment behind an entry of one line."""
    at = 0
    while at < len(line):
        found = _STRINGS.match(line, at)
        if found is None or found["basic"] or found["literal"]:
            return ""
        if found["comment"]:
            return f"  {found['comment']}"
        at = found.end()
    return ""


def _texts(text: str, name: str) -> dict[str, str] | None:
    try:
        stated = toml_of(text, Path(name)).values.get(name)
    except InputError:
        return None
    return {k: str(v) for k, v in cast("dict[str, Any]", stated).items()} if isinstance(stated, dict) else None


def _others(text: str, name: str) -> dict[str, Any] | None:
    """All but one table of a file; None for what is no TOML."""
    try:
        return {k: v for k, v in toml_of(text, Path(name)).values.items() if k != name}
    except InputError:
        return None
