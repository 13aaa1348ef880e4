"""Numbers as they are written in files, and foreign texts as they are quoted in messages."""

from __future__ import annotations

import math
import re
import reprlib
from collections.abc import Iterable

import numpy as np

from raybundle.errors import Message, message
from raybundle.numerics.arrays import Array

LARGEST = 1e18
"""Numbers of a greater size are refused.  Coordinates, times and standard deviations stay far below it, and a product
of 17 such numbers is still finite: what is computed from them cannot overflow unseen."""
SMALLEST = 1e-100
"""Numbers nearer to 0 are 0: the reciprocal of the third power of any other is finite.  The coefficient of r^13 at a
radius of 10^5 px would still move an image point by less than 10^-30 px."""
SHOWN = 40
"""Characters of a foreign text that a message quotes."""
_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]{1,4})?")
_WHOLE = re.compile(r"[-+]?[0-9]{1,19}")
_SHORT = reprlib.Repr()
_SHORT.maxstring = _SHORT.maxother = _SHORT.maxlong = 60
_SHORT.maxlevel = 3


def quoted(value: object) -> str:
    """A foreign text or value as a message quotes it: in one line, printable, short whatever it is."""
    if isinstance(value, str):
        return repr(value if len(value) <= SHOWN else value[:SHOWN] + "...")
    try:
        text = _SHORT.repr(value)
    except ValueError:  # a whole number of more digits than Python writes
        text = "a number of thousands of digits"
    return text if len(text) <= SHOWN else text[:SHOWN] + "..."


def number_of(word: str, factor: float = 1.0) -> float | None:
    """The finite number that a word is, in ASCII digits with a decimal point, times a factor; None where it is none.

    Not taken, though `float` does: 1_000, digits of other scripts, nan, inf, blanks around, sizes above LARGEST.
    """
    if not _NUMBER.fullmatch(word):
        return None
    return finite(float(word) * factor)


def fortran_of(word: str) -> float | None:
    """The same where the exponent may be marked by D, as Fortran writes."""
    return number_of(word.replace("D", "E").replace("d", "e"))


def finite(value: object) -> float | None:
    """The value as a number of bounded size; None where it is no number, a truth value, not finite, or too large."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    if not -LARGEST <= value <= LARGEST:  # so is NaN
        return None
    return float(value) if abs(value) >= SMALLEST else math.copysign(0.0, value)


def no_number(value: object) -> Message:
    """Why `number_of` or `finite` refuse a value; with the limit where it is a number beyond it."""
    size: float = 0
    if isinstance(value, str):
        size = abs(float(value)) if _NUMBER.fullmatch(value) else 0
    elif isinstance(value, int) or (isinstance(value, float) and math.isfinite(value)):
        size = abs(value)
    if size > LARGEST:
        return message("value.too_large", value=quoted(value), largest=LARGEST)
    return message("value.not_finite", value=quoted(value))


def vanishes(word: str) -> bool:
    """Whether a word is a number other than 0 that counts as 0, nearer to it than SMALLEST."""
    return number_of(word) == 0 and any(digit in "123456789" for digit in re.split("[eE]", word)[0])


def whole_of(word: str) -> int | None:
    """The whole number that a word is, of at most 19 ASCII digits; None where it is none."""
    return int(word) if _WHOLE.fullmatch(word) else None


def numbers_of(words: Iterable[str]) -> Array | None:
    """(n,) the numbers that words are; None where one of them is none."""
    found = [number_of(w) for w in words]
    return None if None in found else np.array(found, float)


def column_of(cells: list[str]) -> Array | None:
    """(n,) the numbers in a column of cells, NaN for an empty one; None where one of them is no number.

    As `number_of` for each cell, and as quick as `float`.
    """
    joined = "".join(cells)
    if not joined:
        return np.full(len(cells), np.nan)
    if not joined.isascii() or not _PLAIN.fullmatch(joined):
        return None
    try:
        values = np.fromiter(map(float, cells), float, len(cells))
    except ValueError:
        try:
            values = np.fromiter((float(c) if c else math.nan for c in cells), float, len(cells))
        except ValueError:
            return None
    return bounded(values)


def bounded(values: Array) -> Array | None:
    """(n,) numbers, those nearer to 0 than SMALLEST as 0, NaN as it is; None where one is beyond LARGEST."""
    size = np.abs(values)
    if (size > LARGEST).any():
        return None
    values[size < SMALLEST] = 0.0
    return values


_PLAIN = re.compile(r"[-+.0-9eE]*")
NOT_FINITE = re.compile(r"[-+]?(?:nan|inf|infinity|[0-9.]+(?:[eE][-+]?[0-9]+)?)", re.IGNORECASE)
"""How a number looks that `number_of` refuses for its size, or for being none."""
