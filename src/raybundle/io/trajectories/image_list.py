"""Position lists of photogrammetric programs: a line for each image, with or without a line of column names.

    imagename,latitude [decimal degrees],longitude [decimal degrees],altitude [meter],accuracy horizontal,... (Pix4D)
    # CoordinateSystem: GEOGCS["WGS 84", ...
    #Label,X/Longitude,Y/Latitude,Z/Altitude,Yaw,Pitch,Roll,...                                          (Metashape)
    a.jpg,47.5,8.25,450,0.02,0.03

Columns stand between commas, semicolons, tabs or blanks.  Without names the numbers decide the order where one of the
two is beyond 90 degrees, or both are no degrees; else a list of one site in degrees has the order of Pix4D.  Angles and
errors are not read; estimated coordinates only where the list has no others.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.cells import SHOWN
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.photos.container import SUFFIXES
from raybundle.io.reading.dialects import table_text
from raybundle.io.reading.ledger import enter
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory, TrajectoryFormat, register
from raybundle.io.trajectories.exterior_list import is_list
from raybundle.io.trajectories.geo_txt import SYSTEM, WGS84_HEIGHTS, system_of
from raybundle.io.trajectories.image_rows import (
    LIMITS,
    METRES,
    OURS,
    PATTERNS,
    SEPARATORS,
    STATED_SYSTEM,
    ImageRow,
    cell_number,
    cells_of_line,
    kind_of,
    listed,
    separator_of,
)

ESTIMATED = "position_list.estimated"
SPREAD_DEG = 2.0
"""Extent of a block up to which two numbers are taken for degrees; at the equator 220 km."""
DEGREES = {"", "deg", "degree", "degrees", "decimaldegree", "decimaldegrees", "dd", "wgs84"}
ELLIPSOID = {"wgs84", "ellipsoid", "ellipsoidal", "ellipsoidalheight", "hae"}
"""Words in brackets that the columns may have."""
BY_COUNT = {6: (4, 5), 9: (7, 8)}
"""Columns of horizontal and vertical accuracy by the number of columns, without names."""


@dataclass(frozen=True, slots=True)
class _Columns:
    """Which column holds what."""

    at: dict[str, int]
    names: Sequence[str] = ()
    estimated: bool = False
    """Whether the coordinates are results of an adjustment."""

    @property
    def geographic(self) -> bool:
        """Whether positions are longitude and latitude."""
        return "longitude" in self.at and "latitude" in self.at


def read(path: Path) -> Trajectory:
    """Positions of a list; raises InputError with line and column."""
    lines = [(n, t.strip()) for n, t in enumerate(table_text(path).split("\n"), 1) if t.strip()]
    crs: str | None = None
    remarks: tuple[str, ...] = ()
    header = ""
    comments: list[tuple[int, str]] = []
    content: list[tuple[int, str]] = []
    for line, text in lines:
        if stated := STATED_SYSTEM.fullmatch(text):
            crs, remarks = system_of(stated[1].strip().strip('"'), path, line)
        elif not content and not header and _header(text) is not None:
            header = text
        elif text.startswith("#"):
            comments += [(line, text)] if not content else []
        else:
            content.append((line, text))
    separator = separator_of([*([header] if header else []), *(t for _, t in content)])
    cells = [(n, cells_of_line(t, separator)) for n, t in content]
    columns = _header(header) if header else None
    if columns is None:
        _check_names(path, comments, cells, separator)
        columns, remark = _by_plausibility(path, cells, crs)
        remarks = (*remarks, *remark)
    elif columns.estimated:
        remarks = (*remarks, phrase(ESTIMATED))
    if columns.geographic and crs is None:
        crs, remarks = WGS84_HEIGHT, (*remarks, phrase(WGS84_HEIGHTS))
    _check_units(path, columns, compound=crs is not None and parse_crs(crs).is_compound)
    width = max((len(w) for _, w in cells), default=0)
    for k in range(width):
        if k not in columns.at.values():
            enter(columns.names[k] if k < len(columns.names) else f"column {k + 1}")
    rows = [_row(path, n, w, columns, comma=separator != ",") for n, w in cells]
    if off := sum(_is_off(w, columns) for _, w in cells):
        remarks = (*remarks, phrase("position_list.disabled", n=off, of=len(cells)))
    return listed(path, rows, crs, remarks)


def _header(text: str) -> _Columns | None:
    """The columns of a line of names; None where it is none."""
    words = _names(text)
    for estimated in (False, True):
        at: dict[str, int] = {}
        for k, word in enumerate(words):
            if (kind := kind_of(word, estimated=estimated)) is not None:
                at.setdefault(kind, k)
        if "name" in at and ({"longitude", "latitude"} <= at.keys() or {"x", "y"} <= at.keys()):
            return _Columns(at, words, estimated)
    return None


def _names(text: str) -> list[str]:
    bare = text.lstrip("#").strip()
    counts = {s: bare.count(s) for s in SEPARATORS}
    separator = max(counts, key=lambda s: counts[s])
    return [w.strip().strip('"') for w in (bare.split(separator) if counts[separator] else bare.split())]


def _check_names(
    path: Path, comments: Sequence[tuple[int, str]], cells: Sequence[tuple[int, list[str]]], separator: str | None
) -> None:
    """Raise InputError where a line above the numbers names columns, and the coordinates are not among the known names.

    A comment names columns where it has as many as the first line, or begins with the name of the first column.
    """
    candidates = [(n, _names(t)) for n, t in comments]
    wide = len(cells[0][1]) if cells else 0
    lines = [
        (n, w) for n, w in candidates
        if (separator is not None and len(w) == wide > 2) or (len(w) > 2 and kind_of(w[0], estimated=True) == "name")
    ]  # fmt: skip
    if len(cells) > 1 and _is_header(cells[0][1]):
        lines.append(cells[0])
    if not lines:
        return
    line, words = lines[-1]
    unknown = [w for w in words if w and kind_of(w, estimated=True) is None]
    raise InputError(
        "image_list.unknown_columns", names=[quoted(w) for w in (unknown or words)[:SHOWN]],
        file=path, line=line,
    )  # fmt: skip


def _is_header(words: Sequence[str]) -> bool:
    """Whether a line has words where a position has numbers."""
    place = [w for w in words[1:4] if w]
    named = bool(words) and Path(words[0]).suffix.lower() in SUFFIXES
    return len(place) > 1 and not named and all(number_of(w.replace(",", ".")) is None for w in place)


def _check_units(path: Path, columns: _Columns, *, compound: bool) -> None:
    """Raise InputError where a name states, in brackets, another unit or another reference of the heights.

    compound  whether the coordinate system has a zero of heights
    """
    for kind, k in columns.at.items():
        if kind == "name" or k >= len(columns.names):
            continue
        for words in re.findall(r"[\[(](.*?)[\])]", columns.names[k]):
            plain = re.sub(r"[^a-z0-9]", "", words.lower())
            allowed = DEGREES if kind in {"longitude", "latitude"} else METRES
            if plain in allowed or PATTERNS[kind].fullmatch(plain):
                continue
            if kind == "z" and (compound or plain in ELLIPSOID):
                continue
            raise InputError(
                "image_list.unit",
                unit=quoted(words),
                quantity="height" if kind == "z" else "angle" if allowed is DEGREES else "length",
                file=path,
                column=columns.names[k],
            )


def _by_plausibility(
    path: Path, cells: Sequence[tuple[int, list[str]]], crs: str | None
) -> tuple[_Columns, tuple[str, ...]]:
    """The columns of a list without names: name, latitude, longitude, height in one order, or X, Y, Z.

    raises  InputError where the numbers do not decide between these
    """
    places: list[tuple[float, float]] = []
    for line, words in cells:
        if len(words) < 4:
            raise InputError("line.too_few_cells", n=len(words), needed=4, file=path, line=line)
        a, b = (cell_number(w, path, line, str(k), comma=True) for k, w in enumerate(words[1:3], 2))
        places.append((a, b))
    width = min((len(w) for _, w in cells), default=4)
    at = {"name": 0, "z": 3}
    if width in BY_COUNT:
        at["plan"], at["sz"] = BY_COUNT[width]
    known = np.array([p for p in places if p[0] == p[0] and p[1] == p[1]]).reshape(-1, 2)
    a, b = np.abs(known).max(axis=0, initial=0.0).tolist()
    geographic = None if crs is None else parse_crs(crs).is_geographic
    if geographic is False or max(a, b) > LIMITS[0] or min(a, b) > LIMITS[1]:
        return _Columns(at | {"x": 1, "y": 2}), (phrase("position_list.unnamed", order="xyz"),)
    degrees = geographic or not len(known) or float(np.ptp(known, axis=0).max()) <= SPREAD_DEG
    if degrees and b > LIMITS[1]:
        return _Columns(at | {"latitude": 1, "longitude": 2}), (
            phrase("position_list.unnamed", order="latitude_longitude"),
        )
    if degrees and a > LIMITS[1]:
        return _Columns(at | {"longitude": 1, "latitude": 2}), (
            phrase("position_list.unnamed", order="longitude_latitude"),
        )
    if degrees and len(known):
        north, east = known[0].tolist()
        remark = phrase(
            "position_list.order_of_pix4d", latitude_deg=abs(north), south=north < 0, longitude_deg=abs(east),
            west=east < 0,
        )  # fmt: skip
        return _Columns(at | {"latitude": 1, "longitude": 2}), (remark,)
    raise InputError(
        "image_list.order_unclear", first=known[0].tolist() if len(known) else ["-"],
        file=path, line=cells[0][0] if cells else 1,
    )  # fmt: skip


def _is_off(words: Sequence[str], columns: _Columns) -> bool:
    """Whether the list switches a position off."""
    k = columns.at.get("enabled", len(words))
    return k < len(words) and words[k].lower() in {"0", "false"}


def _row(path: Path, line: int, words: list[str], columns: _Columns, *, comma: bool) -> ImageRow:
    def number(*kinds: str) -> float:
        k = next((columns.at[kind] for kind in kinds if kind in columns.at), None)
        return math.nan if k is None or k >= len(words) else cell_number(words[k], path, line, kinds[0], comma=comma)

    if len(words) <= max(columns.at[k] for k in columns.at if k in {"name", "longitude", "latitude", "x", "y"}):
        raise InputError(
            "line.too_few_cells",
            n=len(words),
            needed=1 + max(columns.at[k] for k in columns.at if k in {"name", "longitude", "latitude", "x", "y"}),
            file=path,
            line=line,
        )
    place = ("longitude", "latitude") if columns.geographic else ("x", "y")
    x, y = (math.nan if _is_off(words, columns) else number(n) for n in place)
    sigma = number("sx", "plan"), number("sy", "plan"), number("sz")
    return ImageRow(line, words[columns.at["name"]], (x, y, number("z")), sigma)


def _recognises(head: str, suffix: str) -> bool:
    lines = [t.strip() for t in head.splitlines() if t.strip()]
    if suffix not in {".csv", ".txt"} or not lines or SYSTEM.match(lines[0]) or is_list(head):
        return False
    for text in lines[:5]:
        if _names(text)[0] in OURS:
            return False
        if _header(text) is not None:
            return True
        if not text.startswith("#"):
            break
    rows = [t for t in lines if not t.startswith("#")][:2]
    separator = separator_of(rows)
    cells = [cells_of_line(t, separator) for t in rows]
    if len(cells) > 1 and _is_header(cells[0]):
        cells = cells[1:]
    words = cells[0] if cells else []
    named = bool(words) and Path(words[0]).suffix.lower() in SUFFIXES
    return named and len(words) >= 4 and all(number_of(w.replace(",", ".")) is not None for w in words[1:4])


register(
    TrajectoryFormat(
        name="image-list", title="position list of Pix4D, Metashape and others: image, coordinates, accuracies",
        read=read, recognises=_recognises,
    )
)  # fmt: skip
