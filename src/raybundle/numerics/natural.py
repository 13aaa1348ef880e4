"""The order of names that people expect: P2 before P10."""

from __future__ import annotations

import re

_DIGITS = re.compile(r"(\d+)")

NaturalKey = tuple[tuple[tuple[int, str], ...], str]


def natural(name: str) -> NaturalKey:
    """What names are sorted by so that P2 stands before P10, whatever their case.

    Runs of digits compare as numbers, of any length; names that differ in case or leading zeros alone, as texts.
    """
    parts = _DIGITS.split(name.casefold())  # text and digits by turns
    key = [_number(p) if k % 2 else (0, p) for k, p in enumerate(parts)]
    return tuple(key), name


def _number(digits: str) -> tuple[int, str]:
    plain = (digits if digits.isascii() else "".join(str(int(d)) for d in digits)).lstrip("0")
    return len(plain), plain


def natural_order(names: tuple[str, ...] | list[str]) -> list[int]:
    """Positions of names in natural order."""
    if all(map(str.isdecimal, names)) and all(map(str.isascii, names)):
        return sorted(range(len(names)), key=lambda k: (*_number(names[k]), names[k]))
    return sorted(range(len(names)), key=lambda k: natural(names[k]))
