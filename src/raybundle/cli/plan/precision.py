"""Predicted precision in words."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.planning.aerial import ControlRow, ControlTable, Precision
    from raybundle.planning.mission import MissionForecast


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


def forecast_lines(f: MissionForecast) -> list[str]:
    """What a mission will determine without control."""
    part = f"; {f.rtk.photographs} photographs in the middle stand for {f.photographs}" if f.thinned else ""
    lines = [
        f" predicted without control, root mean square{part}:",
        _predicted("RTK", f.rtk, f.pixel_mm),
        _predicted("no RTK (5, 5, 10 m)", f.without_rtk, f.pixel_mm),
    ]
    if f.lost_even:
        what = ", ".join(f.lost_even)
        arm = ", one control point the lever arm with them" if {"ax", "ay", "az"} & set(f.lost_even) else ""
        mend = f"views straight down and oblique ones together (pattern oblique-grid) determine the camera{arm}"
        lines.append(f" caution: flown exactly as planned, {what} cannot be determined; {mend}")
    return lines


def _predicted(name: str, p: Precision, pixel_mm: float) -> str:
    lost = f"; not determinable: {', '.join(p.lost)}" if p.lost else ""
    c = "-" if "c" in p.lost else figure(p.std["c"] / pixel_mm, 1)
    return f"  {name}: plan {_mm(p.plan_m)}, height {_mm(float(p.sigma_m[2]))}, c {c} px{lost}"


def _mm(metres: float) -> str:
    return f"{1000 * metres:.3g} mm" if math.isfinite(metres) else "-"


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
