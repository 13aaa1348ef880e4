"""Numbers with units and standard deviations, in words."""

from __future__ import annotations

import math

FREE = "the scale is free: lengths have no unit"


def measured(value: float, sigma: float, unit: str, power: int = 1) -> str:
    """A value with its standard deviation and unit, to two digits of the standard deviation."""
    digits = 2 - math.ceil(math.log10(sigma)) if sigma > 0 and math.isfinite(sigma) else 4
    digits = min(max(digits, 0), 12)
    name = f" {unit}{power if power > 1 else ''}" if unit else ""
    return f"{value:.{digits}f}{name} (sigma {sigma:.2g})"
