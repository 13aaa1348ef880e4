"""Settings as their reader writes them."""

from __future__ import annotations

import re
from json import dumps
from shlex import quote

DIGITS = 12
"""Of numbers that a reader is to type: micrometres in coordinates of a grid, short of the digits of rounding"""
_WORD = re.compile("[A-Z]+")


def option_words(name: str, *values: object, flag: str = "", flags: bool) -> str:
    """A setting as its reader writes it: a flag with values, or `size=(WIDTH, HEIGHT)` in Python.

    values  what to give it; words in capitals stand for values of the reader's own, True and False for a flag alone
    flag    its name on the command line, where that is not the field's: flag="no-gps" of gps=False
    flags   whether it is a flag
    """
    if flags:
        given = [quote(_plain(v)) for v in values if not isinstance(v, bool)]
        return " ".join([f"--{flag or name.replace('_', '-')}", *given])
    parts = [dumps(v, ensure_ascii=False) if _is_text(v) else _plain(v) for v in values]
    return f"{name}={parts[0] if len(parts) == 1 else '(' + ', '.join(parts) + ')' if parts else ''}"


def _plain(v: object) -> str:
    """A value with all its digits, without those of rounding."""
    return f"{v:.{DIGITS}g}" if isinstance(v, float) else str(v)


def _is_text(v: object) -> bool:
    """Whether it is a text that is meant as it stands, and no value of the reader's own."""
    return isinstance(v, str) and _WORD.fullmatch(v) is None
