"""RTKLIB's solutions of camera events: NAME_events.pos, a line for each exposure in their order.

    %  GPST                  latitude(deg) longitude(deg)  height(m)   Q  ns   sdn(m)   sde(m)   sdu(m)  sdne(m) ...
    2024/05/01 10:00:01.237   47.500012345    8.250001234   450.1234   1  12   0.0041   0.0032   0.0087   0.0011 ...

Also with week and second, and as x, y, z from the earth's centre.  Signs of sdne, sdeu, sdun, or sdxy, sdyz, sdzx, are
those of the covariances, whose roots they are (RTKLIB manual, appendix B.1).  A track of all epochs is refused: its
lines belong to no photograph.  Refused as well: another datum than WGS 84, and heights above a geoid, which the file
does not name.

    % (lat/lon/height=WGS84/ellipsoidal,Q=1:fix,2:float,3:sbas,4:dgps,5:single,6:ppp,ns=# of satellites)
"""

from __future__ import annotations

import math
import re
from datetime import datetime
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.reading.dialects import table_text
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.trajectories.base import WEEK_S, WGS84_HEIGHT, Trajectory, TrajectoryFormat, register
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import enu_from_geocentric, geographic_from_geocentric

GPS_EPOCH = datetime(1980, 1, 6)  # noqa: DTZ001  (GPS time has no zone)
FIX = {1: "rtk fixed", 2: "rtk float", 5: "single"}
EPOCH_S, SAME_S, FEWEST = 0.05, 1e-4, 3
"""Receivers record epochs at whole multiples of 0.05 s (20 Hz and slower); of exposures one in 500 falls there."""
COLUMNS = ("latitude", "longitude", "height", "q", "ns", "sdn", "sde", "sdu", "sdne", "sdeu", "sdun")
"""Names of the columns, without their units; the last is also sdue."""
ECEF = ("x-ecef", "y-ecef", "z-ecef", "q", "ns", "sdx", "sdy", "sdz", "sdxy", "sdyz", "sdzx")
_STATED = re.compile(r"(?:/|%\s*)(height|z-ecef)\s*[=:]\s*([a-z][^,;()\s/]*)(?:\s*/\s*([^,;()\s]+))?", re.IGNORECASE)
"""Datum and reference of the heights: lat/lon/height=WGS84/ellipsoidal, height: geodetic, x/y/z-ecef=WGS84."""
_TIME = re.compile(r"\s*(?:(\d{4})/(\d\d)/(\d\d)\s+(\d\d):(\d\d):(\d\d(?:\.\d*)?)|(\d{1,4})\s+(\d+(?:\.\d*)?))\s+(.+)")


def read(path: Path) -> Trajectory:
    """Positions of events; raises InputError with the line of what cannot be read."""
    header, heights = "", False
    times: list[float] = []
    rows: list[list[float]] = []
    lines: list[int] = []
    for line, text in enumerate(table_text(path).split("\n"), 1):
        if text.startswith("%"):
            heights |= _check_reference(path, line, text)
            header = text if "(" in text and re.search(r"latitude|x-ecef|baseline", text) else header
        elif text.strip():
            second, values = _line(path, line, text)
            times.append(second)
            rows.append(values)
            lines.append(line)
    if not rows:
        raise InputError("trajectory.no_position", file=path, line=1)
    columns = _columns(path, header)
    width = min(*map(len, rows), columns)
    table = np.array([r[:width] for r in rows])
    _check(path, header, times, table)
    ecef = "x-ecef" in header
    xyz = table[:, :3][:, [1, 0, 2]]
    if ecef:
        xyz = geographic_from_geocentric(table[:, :3])
    sigma, correlation = _spread(table, xyz if ecef else None)
    fix = tuple(FIX.get(int(q), "") for q in table[:, 3]) if width > 3 else ()
    weak = sum(f != "rtk fixed" for f in fix)
    clock = _clock(header)
    remarks = [
        phrase("position_list.of_antenna"),
        *([phrase("position_list.heights_open")] if not (heights or ecef) else []),
        *([phrase("position_list.clock", clock=clock)] if clock else []),
        *([phrase("position_list.sigma_columns")] if columns < 8 else []),
        *([phrase("position_list.not_fixed", n=weak, of=len(fix))] if weak else []),
    ]
    return Trajectory(
        path=path, names=tuple(str(k + 1) for k in range(len(rows))), numbered=True, ordered=True, xyz=xyz, sigma=sigma,
        correlation=correlation, crs=WGS84_HEIGHT, time=None if clock else np.array(times), fix=fix,
        remarks=tuple(remarks), lines=np.array(lines, np.int32),
    )  # fmt: skip


def _check_reference(path: Path, line: int, text: str) -> bool:
    """Whether a line of the header states ellipsoidal heights; raises InputError for others, and another datum."""
    match = _STATED.search(text)
    if match is None:
        return False
    datum, above = match[2], match[3] or ""
    if match[1].lower() == "height" and not above and _word(datum) != "WGS84":
        datum, above = "WGS84", datum
    if _word(datum) != "WGS84":
        raise InputError("rtklib.datum", datum=quoted(datum), file=path, line=line)
    if above and not _word(above).startswith("ELLIPSOID"):
        raise InputError(
            "rtklib.heights",
            heights=quoted(above),
            file=path,
            line=line,
        )
    return bool(above)


def _word(text: str) -> str:
    return re.sub(r"[\W_]", "", text).upper()


def _columns(path: Path, header: str) -> int:
    """Number of columns after the time whose names are those of RTKLIB; raises InputError for other coordinates."""
    names = [n.lower() for n in re.findall(r"([A-Za-z][\w-]*)(?:\([^)]*\))?", header)][1:]
    known = ECEF if "x-ecef" in header else COLUMNS
    if not names or not ("latitude" in header or known is ECEF):
        return len(COLUMNS)
    same = 0
    for name, right in zip(names, known, strict=False):
        if name not in {right, right.replace("sdun", "sdue")}:
            break
        same += 1
    if same < 3:
        raise InputError("rtklib.columns", names=names[:3], needed=list(known[:3]), file=path)
    return same


def _clock(header: str) -> str:
    """Name of the times where they are not GPS time."""
    match = re.match(r"%\s*([A-Z]{2,5})\b", header)
    return match[1] if match and not match[1].startswith("GPS") else ""


def _line(path: Path, line: int, text: str) -> tuple[float, list[float]]:
    match = _TIME.fullmatch(text)
    if match is None:
        raise InputError("rtklib.line", text=quoted(text.strip()), file=path, line=line)
    values: list[float] = []
    for word in re.split(r"[\s,;]+", match[9].strip()):
        value = number_of(word)
        if value is None:
            raise InputError("rtklib.not_decimal_degrees", value=quoted(word), file=path, line=line)
        values.append(value)
    if len(values) < 3:
        raise InputError("value.count", n=len(values), needed=3, file=path, line=line)
    return _second(path, line, match), values


def _second(path: Path, line: int, match: re.Match[str]) -> float:
    """GPS time [s]."""
    if match[7]:
        return (number_of(match[7]) or 0.0) * WEEK_S + (number_of(match[8]) or 0.0)
    year, month, day, hour, minute = (int(match[k]) for k in range(1, 6))
    try:
        whole = datetime(year, month, day, hour, minute)  # noqa: DTZ001
    except ValueError:
        raise InputError("rtklib.date", text=quoted(match[0][:24]), file=path, line=line) from None
    return (whole - GPS_EPOCH).total_seconds() + (number_of(match[6]) or 0.0)


def _check(path: Path, header: str, times: list[float], table: Array) -> None:
    """Raise InputError for solutions that are no positions of exposures."""
    if "baseline" in header:
        raise InputError("rtklib.baselines", file=path, line=1)
    if "d'" in header:
        raise InputError("rtklib.not_decimal_degrees", value="d'", file=path, line=1)
    if "x-ecef" not in header and (np.abs(table[:, 0]).max() > 90 or np.abs(table[:, 1]).max() > 180):
        raise InputError("rtklib.beyond_degrees", file=path)
    rest = np.array(times) / EPOCH_S
    if len(times) >= FEWEST and (np.abs(rest - np.round(rest)) * EPOCH_S < SAME_S).all():
        raise InputError(
            "rtklib.track",
            n=len(times),
            file=path,
        )


def _spread(table: Array, geographic: Array | None) -> tuple[Array, Array | None]:
    """Standard deviations east, north, up [m] and their correlations, NaN where the variances are not positive.

    geographic  (n, 3) longitude and latitude [deg] where the columns are x, y, z from the earth's centre; None: they
                are north, east, up
    """
    n, width = table.shape
    if width < 8:
        return np.full((n, 3), math.nan), None
    C = np.zeros((n, 3, 3))
    C[:, (0, 1, 2), (0, 1, 2)] = np.where(table[:, 5:8] > 0, table[:, 5:8] ** 2, math.nan)
    for k, (i, j) in enumerate(((0, 1), (1, 2), (2, 0)) if width >= 11 else ()):
        C[:, i, j] = C[:, j, i] = np.sign(table[:, 8 + k]) * table[:, 8 + k] ** 2
    east, north, up = (1, 0, 2)
    if geographic is not None:
        R = enu_from_geocentric(geographic)
        C, (east, north, up) = R @ C @ np.swapaxes(R, -1, -2), (0, 1, 2)
    variance = C[:, (east, north, up), (east, north, up)]
    sigma = np.sqrt(np.where(variance > 0, variance, math.nan))
    if width < 11 and geographic is None:
        return sigma, None
    pairs = C[:, (east, east, north), (north, up, up)]
    with np.errstate(all="ignore"):
        found = pairs / (sigma[:, (0, 0, 1)] * sigma[:, (1, 2, 2)])
    return sigma, np.clip(np.nan_to_num(found), -1, 1)


def _recognises(head: str, suffix: str) -> bool:
    lines = head.splitlines()
    marked = any(t.startswith("%") and re.search(r"latitude\(|x-ecef\(|e-baseline\(", t) for t in lines)
    return marked or (suffix == ".pos" and any(_TIME.fullmatch(t) for t in lines))


register(
    TrajectoryFormat(
        name="rtklib", title="RTKLIB solution of camera events (NAME_events.pos)", read=read, recognises=_recognises
    )
)
