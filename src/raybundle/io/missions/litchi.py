"""Litchi's CSV of way points (litchiutilities.com, "Litchi CSV Format Description").

Heights above the take-off (altitude mode 0), headings from true north, pitch of the gimbal 0 to the horizon and -90 to
the nadir (gimbal mode 2, interpolated); action 1 takes a photograph; `photo_distinterval` and `photo_timeinterval` hold
from a way point to the next, -1 for none.  Heading mode, cruising speed and what comes at the end are settings of the
app and not of the file: the heading mode is to be set to "Custom".
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.missions.base import MissionFormat, register
from raybundle.io.reading.files import read_lines
from raybundle.io.reading.rows import BadRow, cells_of
from raybundle.io.reading.words import no_number, number_of
from raybundle.missions.mission import Trigger
from raybundle.missions.route import Route
from raybundle.numerics.arrays import Array

MOST = 99
"""Way points that a mission may have (DJI's SDK, and Litchi with it)."""
ACTIONS = 15
COLUMNS = (
    "latitude", "longitude", "altitude(m)", "heading(deg)", "curvesize(m)", "rotationdir", "gimbalmode",
    "gimbalpitchangle", *(f"action{part}{k}" for k in range(1, ACTIONS + 1) for part in ("type", "param")),
    "altitudemode", "speed(m/s)", "poi_latitude", "poi_longitude", "poi_altitude(m)", "poi_altitudemode",
    "photo_timeinterval", "photo_distinterval",
)  # fmt: skip
TAKE_PHOTO, INTERPOLATED, ABOVE_TAKE_OFF = 1, 2, 0


def write(route: Route, path: Path) -> None:
    """One mission."""
    lines = [",".join(COLUMNS)]
    base = math.nan
    for k in range(len(route)):
        if route.trigger[k] == Trigger.START:
            base = float(route.base[k])
        elif route.trigger[k] != Trigger.NONE:
            base = math.nan
        by_time = route.trigger_by == "interval"
        time = f"{base / route.speed[k]:.9f}" if by_time and math.isfinite(base) else "-1"
        distance = f"{base:.9f}" if not by_time and math.isfinite(base) else "-1"
        action = [str(TAKE_PHOTO), "0"] if route.trigger[k] == Trigger.HERE else ["-1", "0"]
        cells = [
            f"{route.latitude_deg[k]:.10f}", f"{route.longitude_deg[k]:.10f}", f"{route.height[k]:.9f}",
            f"{route.heading_deg[k]:.9f}", "0", "0", str(INTERPOLATED), f"{route.pitch_deg[k]:.9f}", *action,
            *["-1", "0"] * (ACTIONS - 1), str(ABOVE_TAKE_OFF), f"{route.speed[k]:.9f}", "0", "0", "0", "0", time,
            distance,
        ]  # fmt: skip
        lines.append(",".join(cells))
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")


PLACE = ("latitude", "longitude", "altitude(m)")


def read(path: Path) -> Route:
    """The way points of a mission in metres; the take-off is in no such file, and is taken to lie below the first."""
    lines = [(n, t) for n, t in read_lines(path) if t.strip()]
    try:
        rows = list(cells_of([t for _, t in lines]))
    except BadRow as error:
        raise InputError(error.problem, file=path, line=lines[error.position][0]) from None
    names = [c.strip() for c in rows[0]] if rows else []
    if "altitude(ft)" in names:
        raise InputError("litchi.feet", file=path, line=1)
    missing = [c for c in ("latitude", "longitude", "altitude(m)", "gimbalpitchangle") if c not in names]
    if missing:
        raise InputError(
            "table.columns_missing",
            names=missing,
            header=names,
            needed=["latitude", "longitude", "altitude(m)", "gimbalpitchangle"],
            file=path,
            line=1,
        )
    table = [_numbers(path, lines[k + 1][0], dict(zip(names, row, strict=False))) for k, row in enumerate(rows[1:])]
    if not table:
        raise InputError("mission.no_way_point", file=path)
    t = np.array(table)
    trigger, base = _triggers(t)
    by_time = bool((t[:, 7] > 0).any())
    return Route(
        name=path.stem, home=(float(t[0, 0]), float(t[0, 1]), 0.0), latitude_deg=t[:, 0], longitude_deg=t[:, 1],
        height=t[:, 2], heading_deg=t[:, 3] % 360.0, pitch_deg=t[:, 4], speed=t[:, 5], trigger=trigger, base=base,
        trigger_by="interval" if by_time else "distance",
    )  # fmt: skip


def _numbers(path: Path, line: int, cells: dict[str, str]) -> list[float]:
    def value(name: str, default: float) -> float:
        text = cells.get(name, "").strip()
        found = number_of(text) if text else default
        if found is None:
            raise InputError(no_number(text), file=path, line=line, column=name)
        if not text and name in PLACE:
            raise InputError("cell.empty", file=path, line=line, column=name)
        return found

    if value("altitudemode", 0.0) != ABOVE_TAKE_OFF:
        raise InputError(
            "mission.height_reference", reference="altitudemode 1", needed="altitudemode 0", file=path,
            line=line,
        )  # fmt: skip
    if value("photo_timeinterval", -1.0) > 0 and math.isnan(value("speed(m/s)", math.nan)):
        raise InputError(
            "cell.empty", file=path, line=line,
            column="speed(m/s)",
        )  # fmt: skip
    photo = any(value(f"actiontype{k}", -1.0) == TAKE_PHOTO for k in range(1, ACTIONS + 1))
    return [
        value("latitude", math.nan), value("longitude", math.nan), value("altitude(m)", math.nan),
        value("heading(deg)", math.nan), value("gimbalpitchangle", math.nan), value("speed(m/s)", math.nan),
        float(photo), value("photo_timeinterval", -1.0), value("photo_distinterval", -1.0),
    ]  # fmt: skip


def _triggers(t: Array) -> tuple[Array, Array]:
    """Where photographs begin and end, of intervals that hold from a way point to the next."""
    base = np.where(t[:, 8] > 0, t[:, 8], np.where(t[:, 7] > 0, t[:, 7] * t[:, 5], np.nan))
    trigger = np.where(t[:, 6] > 0, int(Trigger.HERE), int(Trigger.NONE))
    on = np.isfinite(base)
    before = np.append(np.nan, base[:-1])
    starts = on & ~(np.abs(base - before) < 1e-9)
    stops = ~on & np.isfinite(before)
    trigger[starts], trigger[stops] = int(Trigger.START), int(Trigger.STOP)
    return trigger, np.where(starts, base, np.nan)


register(MissionFormat(name="litchi", about="Litchi, .csv", suffix=".csv", write=write, read=read, most=MOST))
