"""Numbers as messages write them."""

from __future__ import annotations

import math

LEAST_P = 1e-16
"""Probabilities below are those of no distribution of real errors: they are written as a bound"""


def grouped(number: int) -> str:
    """A whole number in groups of three digits: 18 803."""
    return f"{number:,}".replace(",", " ")


def significant(value: float, digits: int = 3) -> str:
    """A number with so many significant digits, without an exponent where it can be read without."""
    if not 1e-4 <= abs(value) < 1e6:
        return f"{value:.{digits - 1}e}"
    text = f"{value:#.{digits}g}"
    return f"{float(text):.0f}" if "e" in text else text.rstrip(".")


def short(value: float, digits: int = 3) -> str:
    """The same without zeros at the end, and with every digit before the decimal point.

    value   any number; one that is not finite is written as a word
    digits  significant digits
    """
    if not math.isfinite(value):
        return "infinite" if math.isinf(value) else "none"
    if value == 0:
        return "0"
    if 10**digits <= abs(value) < 1e15:
        return grouped(round(value))
    return f"{value:.{digits}g}"


def probability(p: float) -> str:
    """A probability behind its letter: "p 0.35", "p < 1e-16"."""
    return f"p {short(float(p), 2)}" if p >= LEAST_P else f"p < {LEAST_P:g}"
