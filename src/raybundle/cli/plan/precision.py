"""Predicted precision in words."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from raybundle.errors import Message, note, phrase, warning

if TYPE_CHECKING:
    from raybundle.planning.flights.aerial import ControlRow, ControlTable, Precision
    from raybundle.planning.flights.mission import MissionForecast
    from raybundle.planning.flights.mission_mends import Mend


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


def control_lines(table: ControlTable) -> list[Message | str]:
    """What control brings, by number and standard deviation, and where it should lie."""
    rows = [f"{'control points: sigma [mm]':56}{'plan':>8}{'worst':>8}{'Z':>8}{'worst':>8}   not determinable"]
    for row in table.rows:
        name = "none" if not row.points else f"{row.points} of {1000 * row.sigma_m:.0f} mm: {_where(row)}"
        rows.append(_line(name, row.found))
    enough = [_enough(table.enough(s), s) for s in sorted({r.sigma_m for r in table.rows if r.points})]
    layouts = [_line(_where(row), row.found) for row in table.layouts]
    return [*rows, *enough, note("flight.layouts"), *layouts]


def _where(row: ControlRow) -> str:
    return phrase("flight_change.places", where=row.where)


def forecast_lines(f: MissionForecast) -> list[Message]:
    """What a mission will determine without control."""
    from raybundle.planning.flights.aerial import NO_RTK, is_rtk

    own = f.asked.station_sigma
    lines = [_predicted(own, f.rtk, f.pixel_mm, rtk=is_rtk(own))]
    if f.without_rtk is not None:
        lines.append(_predicted(NO_RTK, f.without_rtk, f.pixel_mm, rtk=False, held=bool(f.asked.lever_arm)))
    if f.thinned:
        lines.append(note("flight.thinned", n=f.rtk.photographs, of=f.photographs))
    return lines


def left_open(f: MissionForecast) -> list[Message]:
    """What is not determinable of a mission flown exactly as planned, and what determines it."""
    from raybundle.planning.flights.aerial import UNSOLVED

    if not f.lost_even:
        return []
    if f.lost_even == (UNSOLVED,):
        return [warning("plan.flown_apart")]
    found = warning("plan.flown_lost", parameters=list(f.lost_even))
    return [found, *map(_mend, f.mends)] if f.mends else [found, note("plan.flown_calibrated")]


def _mend(mend: Mend) -> Message:
    """A change that determines what is open."""
    return note("flight.mend", kind=mend.kind, n=mend.control)


def _predicted(
    sigma_m: tuple[float, float, float], p: Precision, pixel_mm: float, *, rtk: bool, held: bool = False
) -> Message:
    c = "-" if "c" in p.lost else f"{figure(p.std['c'] / pixel_mm, 1)} px"
    return note(
        "flight.predicted", rtk=rtk, sigma_m=list(sigma_m), held=held, plan=length(p.plan_m),
        height=length(float(p.sigma_m[2])), c=c, n_lost=len(p.lost), lost=list(p.lost),
    )  # fmt: skip


def _line(name: str, found: Precision) -> str:
    metres = (found.plan_m, found.plan_worst_m, float(found.sigma_m[2]), found.height_worst_m)
    return f"{name:56}{''.join(f'{cell(v, 1):>8}' for v in metres)}   {', '.join(found.lost) or 'none'}"


def _enough(row: ControlRow, sigma: float) -> Message:
    return note(
        "flight.control_enough", sigma_mm=1000 * sigma, n=row.points, known=math.isfinite(row.found.height_worst_m)
    )  # fmt: skip
