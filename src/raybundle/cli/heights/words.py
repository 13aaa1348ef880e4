"""Numbers with units and standard deviations, in words."""

from __future__ import annotations

import math

from raybundle.cli.common import grouped, significant
from raybundle.errors import Message, note

MOST_PLACES = 9
GROUPED = 1e4
LEAST_SHARE = 5e-5
"""Share that is reported: less is 0.00 %."""


def free_scale(unit: str) -> list[Message]:
    """That lengths have no unit, where the scale is free."""
    return [] if unit else [note("heights.scale_free")]


def measured(value: float, sigma: float, unit: str, power: int = 1) -> str:
    """A value with its standard deviation and unit, both to two digits of the standard deviation."""
    name = f" {unit}{power if power > 1 else ''}" if unit else ""
    if not (sigma > 0 and math.isfinite(sigma)):
        return f"{plain(value)}{name} (sigma {'0' if sigma == 0 else '?'})"
    places = 1 - math.floor(math.log10(sigma))
    if places > MOST_PLACES:
        return f"{plain(value)}{name} (sigma {significant(sigma, 2)})"
    return (
        f"{_whole(round(value, places), max(places, 0))}{name} (sigma {_whole(round(sigma, places), max(places, 0))})"
    )


def two_digits(sigma: float) -> str:
    """A standard deviation."""
    return significant(sigma, 2) if sigma > 0 else "0"


def plain(value: float, digits: int = 6) -> str:
    """A number that is exact or has no standard deviation, to six digits or whole."""
    if value and not 1e-4 <= abs(value) < 1e15:
        return f"{value:.{digits}g}"
    places = 0 if value == 0 else max(0, digits - 1 - math.floor(math.log10(abs(value))))
    text = _whole(value, places)
    return text.rstrip("0").rstrip(".") if "." in text else text


def _whole(value: float, places: int) -> str:
    """With so many decimals, thousands apart from 10 000 on as all counts are."""
    text = f"{value + 0.0:.{places}f}"
    whole, dot, rest = text.partition(".")
    return f"{grouped(int(whole))}{dot}{rest}" if abs(value) >= GROUPED else text
