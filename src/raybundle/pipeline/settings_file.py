"""project.toml beside the settings of the last run: tables of other hands, which a run leaves as they are."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from raybundle.errors import InputError
from raybundle.io.reading.files import read_text
from raybundle.io.reading.trees import TOML_BYTES, read_toml, toml_of

_TABLE = re.compile(r"""^\s*\[\[?\s*(?:([A-Za-z0-9_-]+)|"([^"\\]+)"|'([^']+)')""")
_STRINGS = re.compile(
    r"""(?P<basic>\"\"\")|(?P<literal>''')|"(?:[^"\\]|\\.)*"|'[^']*'|(?P<comment>\#.*)|\\.|.""", re.DOTALL
)


def tables_of(path: Path) -> dict[str, str]:
    """The tables of a project.toml by name, each as it stands there, comments with it; {} where there is no file.

    A comment before a table belongs to it.  raises InputError, with the line, for a file that is no TOML
    """
    if not path.is_file():
        return {}
    read_toml(path)  # mistakes are told with their line
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
    tables.pop(name, None)
    ours = {name: text.strip("\n")} if text else {}
    every = {**ours, **tables} if name == "orient" else {**tables, **ours}
    done = "\n\n".join(t for t in every.values() if t) + "\n"
    if _others(done, name) != (_others(read_text(path, TOML_BYTES), name) if path.is_file() else {}):
        raise InputError(
            f"table [{name}] cannot be written without changing another one; write it by hand, with plain headers and "
            "texts of one line",
            file=path,
        )
    return done


def _others(text: str, name: str) -> dict[str, Any] | None:
    """All but one table of a file; None for what is no TOML."""
    try:
        return {k: v for k, v in toml_of(text, Path(name)).values.items() if k != name}
    except InputError:
        return None
