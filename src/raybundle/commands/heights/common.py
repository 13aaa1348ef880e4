"""Settings that the commands on heights share."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from raybundle.settings import NOT_NEGATIVE, setting

CELLS_FILLED = 10
"""Width in cells of the holes that are filled where nobody states how wide."""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightsSettings:
    """What is taken from a surface."""

    source: Path
    """folder of `surface` with heights"""
    fill: float | None = setting(
        None, "Fill holes up to this width; 0: none. In the unit of the heights. Filled heights come from the "
        "surroundings; their standard deviation grows with the gap.  [default: 10 cells]",
        metavar="WIDTH", limits=NOT_NEGATIVE,
    )  # fmt: skip
