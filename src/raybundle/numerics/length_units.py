"""Units of length that a factor between two lengths gives away."""

from __future__ import annotations

from math import isfinite, log

UNITS = {"mm": 1e-3, "cm": 1e-2, "inches": 0.0254, "feet": 0.3048, "m": 1.0, "km": 1e3}
"""Metres of one"""
BEYOND = 2.0
"""Ratio of two lengths of one thing, or its inverse, from which on they are reported in two units: these differ by more
(an inch is 2.5 cm)"""
LIKELY = 1.1
"""Ratio of what is left in a unit up to which that unit is named."""


def precision_unit(sigma: float, unit: str) -> tuple[float, str]:
    """In what a standard deviation in a unit is read, and how many of it are one: millimetres below a metre."""
    return (1000.0, "mm") if unit == "m" and not sigma >= 1 else (1.0, unit)


def is_other_unit(ratio: float) -> bool:
    """Whether two lengths of one thing differ by more than any measurement errs."""
    return not isfinite(ratio) or ratio <= 0 or abs(log(ratio)) > log(BEYOND)


def unit_of(ratio: float) -> str | None:
    """The unit of a length that is so many times what it is in metres; None where no unit explains it."""
    return next((n for n, metres in UNITS.items() if n != "m" and 1 / LIKELY < ratio * metres < LIKELY), None)


def units_of(ratio: float) -> tuple[str, str] | None:
    """The units of a length and of another of the same thing, the first being so many times the second in numbers.

    Metres are the likeliest of either.  None where no two units explain it.
    """
    pairs = [(a, b) for a in UNITS for b in UNITS if a != b]
    left = {p: abs(log(ratio * UNITS[p[0]] / UNITS[p[1]])) for p in pairs}
    likely = [p for p in pairs if left[p] < log(LIKELY)]
    return min(likely, key=lambda p: ("m" not in p, left[p]), default=None)


def factor_unit(ratio: float, unit: str, near: float, *, kilometres: bool = False) -> str:
    """The unit in which given lengths are `ratio` times the right ones in `unit`; "" where none explains it.

    near        relative difference within which a unit explains it
    kilometres  whether they are named, too; nobody measures bars in them
    """
    names = [n for n in UNITS if n != unit and (kilometres or n != "km")]
    return next((n for n in names if abs(ratio * UNITS[n] / UNITS[unit] - 1) < near), "")
