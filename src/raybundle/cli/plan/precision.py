"""Predicted precision in words."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from raybundle.cli.summary import notice_line
from raybundle.errors import note, phrase, warning

if TYPE_CHECKING:
    from raybundle.planning.aerial import ControlRow, ControlTable, Precision
    from raybundle.planning.mission import MissionForecast
    from raybundle.planning.mission_mends import Mend


ONE = 0.9995
"""Metres that are written as such: what would be rounded to 1000 mm"""


def figure(value: float, decimals: int) -> str:
    """A figure; a dash where there is none."""
    return f"{value:.{decimals}f}" if math.isfinite(value) else "-"


def cell(metres: float, decimals: int) -> str:
    """A standard deviation of a table in mm; from a metre on in metres, with their unit."""
    return f"{metres:.2f} m" if math.isfinite(metres) and metres >= ONE else figure(1000 * metres, decimals)


def length(metres: float) -> str:
    """A standard deviation in a sentence, with its unit."""
    if not math.isfinite(metres):
        return "-"
    return f"{metres:.2f} m" if metres >= ONE else f"{1000 * metres:.3g} mm"


def positions(sigma: tuple[float, float, float]) -> str:
    """Standard deviations of positions, and what they are of."""
    east, north, up = sigma
    return f"{east:g}, {north:g}, {up:g} m"


def control_lines(table: ControlTable) -> list[str]:
    """What control brings, by number and standard deviation, and where it should lie."""
    head = f" {'control points: sigma [mm]':56}{'plan':>8}{'worst':>8}{'Z':>8}{'worst':>8}   not determinable"
    lines = ["", head]
    for row in table.rows:
        name = "none" if not row.points else f"{row.points} of {1000 * row.sigma_m:.0f} mm: {_where(row)}"
        lines.append(_line(name, row.found))
    lines += [f" {_worth(table.enough(s), s)}" for s in sorted({r.sigma_m for r in table.rows if r.points})]
    lines.append(f" {'where five of 10 mm lie':56}")
    lines += [_line(_where(row), row.found) for row in table.layouts]
    return lines


def _where(row: ControlRow) -> str:
    return phrase("flight_change.places", where=row.where)


def forecast_lines(f: MissionForecast) -> list[str]:
    """What a mission will determine without control."""
    from raybundle.planning.aerial import NO_RTK, is_rtk  # noqa: PLC0415  (what computes is loaded after the help)

    part = f"; {f.rtk.photographs} photographs in the middle stand for {f.photographs}" if f.thinned else ""
    own = f.asked.station_sigma
    kind = "RTK" if is_rtk(own) else "no RTK"
    held = ", lever arm held" if f.asked.lever_arm else ""
    lines = [
        f" predicted without control, root mean square{part}:",
        _predicted(f"{kind} ({positions(own)})", f.rtk, f.pixel_mm),
    ]
    if f.without_rtk is not None:
        lines.append(_predicted(f"no RTK ({positions(NO_RTK)}){held}", f.without_rtk, f.pixel_mm))
    if f.lost_even:
        lines += _left_open(f)
    return lines


def _left_open(f: MissionForecast) -> list[str]:
    from raybundle.planning.aerial import UNSOLVED  # noqa: PLC0415

    if f.lost_even == (UNSOLVED,):
        return [f" {notice_line(warning('plan.flown_apart'))}"]
    found = f" {notice_line(warning('plan.flown_lost', parameters=list(f.lost_even)))}"
    if not f.mends:
        return [found, f" {notice_line(note('plan.flown_calibrated'))}"]
    return [found, f"   what determines them: {', or '.join(_mend(m) for m in f.mends)}"]


def _mend(mend: Mend) -> str:
    """A change in words."""
    points = "" if not mend.control else "one control point" if mend.control == 1 else f"{mend.control} control points"
    if mend.kind == "control":
        return points
    views = {
        "tilted-grid": "views tilted by 20 deg (--pattern double-grid --tilt 20)",
        "oblique-grid": "oblique views beside those straight down (--pattern oblique-grid)",
        "again": "the lines flown once more with the view tilted ahead by 30 deg",
        "turned": "the rows flown once more with the view turned by 30 deg to the left and right in turn",
    }[mend.kind]
    return f"{views} with {points}" if points else views


def _predicted(name: str, p: Precision, pixel_mm: float) -> str:
    lost = f"; not determinable: {', '.join(p.lost)}" if p.lost else ""
    c = "-" if "c" in p.lost else f"{figure(p.std['c'] / pixel_mm, 1)} px"
    return f"  {name}: plan {length(p.plan_m)}, height {length(float(p.sigma_m[2]))}, c {c}{lost}"


def _line(name: str, found: Precision) -> str:
    metres = (found.plan_m, found.plan_worst_m, float(found.sigma_m[2]), found.height_worst_m)
    return f" {name:56}{''.join(f'{cell(v, 1):>8}' for v in metres)}   {', '.join(found.lost) or 'none'}"


def _worth(row: ControlRow, sigma: float) -> str:
    what = f"of {1000 * sigma:.0f} mm"
    if not math.isfinite(row.found.height_worst_m):
        return f"{what}: not even {row.points} determine everything"
    if not row.points:
        return f"{what}: none brings 10 % of the worst height"
    return f"{what}: {row.points} are enough; more bring less than 10 % of the worst height"
