"""Languages of the report: English, in which its sentences are written, and one file here for every other one."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from raybundle.errors import InputError

ENGLISH = "en"


class Said(str):
    """A text that is in the reader's language already, and is not translated again."""

    __slots__ = ()


@cache
def language_codes() -> tuple[str, ...]:
    """The languages that a report can be written in, English first: as there are files here."""
    return (ENGLISH, *sorted(f.stem for f in Path(__file__).parent.glob("*.toml")))


def checked_language(code: str) -> str:
    """The language that was asked for; raises InputError where there is none of that name."""
    if code not in language_codes():
        raise InputError("report.unknown_language", language=code, known=list(language_codes()))
    return code


def catalogue(code: str) -> dict[str, Any]:
    """The file of a language as it stands."""
    from raybundle.io.reading.trees import read_toml  # noqa: PLC0415  (numeric packages are loaded after the help)

    return dict(read_toml(Path(__file__).parent / f"{code}.toml").values)
