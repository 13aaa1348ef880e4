"""Numbers on the command line: finite, and within what a computation in double precision carries."""

from __future__ import annotations

import math
import re
from typing import Any

import click

from raybundle import settings
from raybundle.errors import message

SMALLEST, LARGEST = 1e-12, 1e12
"""Least and greatest size of a number other than 0.

What an adjustment sums are squares of ratios of what is given here, a length over a standard deviation: of at most
(1e12 / 1e-12)^2 = 1e48 each.  Their products in a factor of a matrix, and the squares of those, stay below 1e192, far
from the 1.8e308 at which a double overflows.  No length of surveying comes near either limit in metres or millimetres.
"""
LENGTH = re.compile(r"([0-9]+(?:\.[0-9]*)?|\.[0-9]+)\s*(mm|cm|m|in)?")
UNITS = {None: 1.0, "mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}


class Number(click.FloatRange):
    """A finite number of a range: click's own let NaN through, which compares with nothing, infinity and 1e300."""

    def __init__(self, low: float | None = None, high: float | None = None, *, above: bool = False) -> None:
        """From `low`, or above it, to `high`; LARGEST in size at most and, but for 0, SMALLEST at least."""
        super().__init__(low, high, min_open=above)

    def _describe_range(self) -> str:
        """The range for the help; click's word for none is x<=None."""
        return "" if self.min is None and self.max is None else super()._describe_range()

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """The number; a usage error where it is none, is not finite or lies outside."""
        found = float(super().convert(value, param, ctx))
        if not math.isfinite(found):
            self.fail(message("value.not_finite", value=repr(value)).text(), param, ctx)
        if abs(found) > LARGEST or 0 < abs(found) < SMALLEST:
            out = message("value.size_out_of_range", value=found, least=SMALLEST, most=LARGEST)
            self.fail(out.text(), param, ctx)
        return found


class Length(Number):
    """A length in millimetres, written with or without its unit."""

    name = "LENGTH"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """5mm, 0.5cm, 5."""
        from raybundle.io.reading.words import number_of

        if isinstance(value, float):
            return value
        match = LENGTH.fullmatch(str(value).strip())
        if match is None:
            self.fail(message("value.no_length", value=repr(value)).text(), param, ctx)
        return super().convert((number_of(match[1]) or 0.0) * UNITS[match[2]], param, ctx)


NUMBER = Number()
POSITIVE = Number(0, above=True)
NOT_NEGATIVE = Number(0)
PIXELS = Number(settings.PIXELS.low, settings.PIXELS.high, above=True)
