"""Languages of the report: those of the catalogues in `raybundle.words`."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from raybundle import words
from raybundle.errors import InputError

ENGLISH = words.ENGLISH


class Localised(str):
    """A text that is in the reader's language already, and stays as it is."""

    __slots__ = ()


def language_codes() -> tuple[str, ...]:
    """The languages that a report can be written in, English first."""
    return words.languages()


def checked_language(code: str) -> str:
    """The language that was asked for; raises InputError where there is none of that name."""
    if code not in language_codes():
        raise InputError("report.unknown_language", language=code, known=list(language_codes()))
    return code


@cache
def divided_words(code: str) -> dict[str, str]:
    """Long words of headings with soft hyphens, as the file of the language has them."""
    file = Path(__file__).parent / f"{code}.txt"
    found = file.read_text(encoding="utf-8").split() if file.exists() else []
    return {w.replace("-", ""): w.replace("-", "\u00ad") for w in found}
