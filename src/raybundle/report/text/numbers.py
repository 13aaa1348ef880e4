"""Numbers as a printed report shows them: as many digits as the standard deviation allows, no more."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

import numpy as np

from raybundle.errors import Text
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import decimals_for

NARROW = "\u202f"
"""Narrow no-break space between groups of three digits."""
MINUS = "\u2212"
NONE = "\u2013"
"""Stands for a number that there is not."""
_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def grouped(number: float) -> str:
    """A whole number in groups of three digits: 18 803."""
    return f"{round(number):,}".replace(",", NARROW).replace("-", MINUS) if math.isfinite(number) else NONE


def unbroken(words: str) -> str:
    """A sentence whose numbers stay on one line, as they are printed: 8 % and 2 × 10⁻⁴ for the 8% and 2e-04 of a log.

    No break between groups of digits, and after the sign of a sigma.
    """
    if isinstance(words, Text):
        return words.with_text(unbroken(str(words)))
    words = re.sub(r"(?<=\d) (?=\d{3}(?!\d))", NARROW, words).replace("± ", "±\u00a0")
    words = re.sub(r"(?<=\d)%", " %", words)
    return re.sub(r"(?<![\w.])(\d+(?:\.\d+)?)e([-+]\d+)(?!\w)", lambda m: f"{m[1]} × {power(int(m[2]))}", words)


def counted(number: int, noun: str) -> str:
    """A number and its noun: "1 image", "18 803 images"."""
    return f"{grouped(number)} {noun}{'' if number == 1 else 's'}"


def fixed(value: float, decimals: int) -> str:
    """A number with so many decimals."""
    if not math.isfinite(value):
        return NONE
    text = f"{value:.{max(decimals, 0)}f}"
    return text.replace("-", MINUS) if float(text) != 0 else text.removeprefix("-")


def power(exponent: int) -> str:
    """A power of ten in print: 10⁻⁵."""
    return f"10{str(exponent).translate(_RAISED)}"


def significant(value: float, digits: int = 3) -> str:
    """A number with so many significant digits; a power of ten where it would be long otherwise."""
    if not math.isfinite(value):
        return NONE
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(value)))
    if -4 <= exponent < 6:
        shown = round(value, digits - 1 - exponent)
        if shown != 0 and math.floor(math.log10(abs(shown))) > exponent:
            exponent += 1
        decimals = digits - 1 - exponent
        return fixed(shown, decimals) if decimals > 0 or abs(shown) < 1e4 else grouped(shown)
    mantissa = value / 10.0**exponent
    return f"{fixed(mantissa, digits - 1)} × {power(exponent)}"


def plain(value: float, digits: int = 6) -> str:
    """A number that was given: so many significant digits at most, and no zeros at their end."""
    shown = significant(value, digits)
    number, times, ten = shown.partition(" × ")
    if "." in number:
        number = number.rstrip("0").rstrip(".")
    return number + times + ten


def column_decimals(sigmas: Array) -> int:
    """Decimals of a column, from its smaller standard deviations (lower five per cent)."""
    good = sigmas[np.isfinite(sigmas) & (sigmas > 0)]
    return decimals_for(float(np.partition(good, len(good) // 20)[len(good) // 20])) if len(good) else 3


def with_sigma(value: float, sigma: float) -> tuple[str, str]:
    """Value and standard deviation, both to the second digit of the latter, small ones with a common power of ten."""
    if not (math.isfinite(sigma) and sigma > 0):
        return plain(value), NONE
    decimals = decimals_for(sigma)
    largest = max(abs(value), sigma)
    if largest >= 1e-3 and decimals <= 9:
        return fixed(value, decimals), fixed(sigma, decimals)
    exponent = math.floor(math.log10(largest))
    left, ten = max(decimals + exponent, 0), power(exponent)
    return f"{fixed(value / 10.0**exponent, left)} × {ten}", f"{fixed(sigma / 10.0**exponent, left)} × {ten}"


def probability(p: float) -> str:
    """A probability; very small ones as a bound."""
    if not math.isfinite(p):
        return NONE
    return "< 0.001" if p < 0.001 else fixed(p, 3)


def per_cent(share: float) -> str:
    """A share in per cent, a decimal more where it is small."""
    if not math.isfinite(share):
        return NONE
    if 0 < share < 0.001:
        return f"{significant(100 * share, 1)} %"
    return f"{fixed(100 * share, 1 if 0 < share < 0.1 else 0)} %"


def cells(values: Iterable[float], decimals: int) -> list[str]:
    """A column of numbers with common decimals."""
    form = f"{{:.{max(decimals, 0)}f}}".format
    zero = form(0.0)
    return [
        NONE if not math.isfinite(v) else zero if (t := form(v)).lstrip("-") == zero else t.replace("-", MINUS)
        for v in values
    ]


def unit_text(unit: str) -> str:
    """A unit in print: "mm^-2" becomes mm⁻², "1" nothing."""
    if unit == "1":
        return ""
    base, _, exponent = unit.partition("^")
    return base + exponent.translate(_RAISED)


def listed(words: Iterable[str], most: int = 8) -> str:
    """Words as a list in a sentence, cut after so many."""
    all_words = list(words)
    shown = ", ".join(all_words[:most])
    return shown if len(all_words) <= most else f"{shown} and {grouped(len(all_words) - most)} more"
