"""Predicted precision in words."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.planning.aerial import ControlRow, ControlTable, Precision


def figure(value: float, decimals: int) -> str:
    """A figure; a dash where there is none."""
    return f"{value:.{decimals}f}" if math.isfinite(value) else "-"


def control_lines(table: ControlTable) -> list[str]:
    """What control brings, by number and standard deviation, and where it should lie."""
    head = f" {'control points: sigma [mm]':56}{'plan':>7}{'worst':>7}{'Z':>7}{'worst':>7}   not determinable"
    lines = ["", head]
    for row in table.rows:
        name = "none" if not row.points else f"{row.points} of {1000 * row.sigma_m:.0f} mm: {row.where}"
        lines.append(_line(name, row.found))
    lines += [f" {_worth(table.enough(s), s)}" for s in sorted({r.sigma_m for r in table.rows if r.points})]
    lines.append(f" {'where five of 10 mm lie':56}")
    lines += [_line(row.where, row.found) for row in table.layouts]
    return lines


def _line(name: str, found: Precision) -> str:
    mm = (found.plan_m, found.plan_worst_m, float(found.sigma_m[2]), found.height_worst_m)
    return f" {name:56}{''.join(f'{figure(1000 * v, 1):>7}' for v in mm)}   {', '.join(found.lost) or 'none'}"


def _worth(row: ControlRow, sigma: float) -> str:
    what = f"of {1000 * sigma:.0f} mm"
    if not math.isfinite(row.found.height_worst_m):
        return f"{what}: not even {row.points} determine everything"
    if not row.points:
        return f"{what}: none brings 10 % of the worst height"
    return f"{what}: {row.points} are enough; more bring less than 10 % of the worst height"
