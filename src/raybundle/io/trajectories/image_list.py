"""Position lists of photogrammetric programs: a line for each image, with or without a line of column names.

    imagename,latitude [decimal degrees],longitude [decimal degrees],altitude [meter],accuracy horizontal,... (Pix4D)
    # CoordinateSystem: GEOGCS["WGS 84", ...
    #Label,X/Longitude,Y/Latitude,Z/Altitude,Yaw,Pitch,Roll,...                                          (Metashape)
    a.jpg,47.5,8.25,450,0.02,0.03

Columns stand between commas, semicolons, tabs or blanks.  Without names the order is Pix4D's, latitude first, unless
the numbers contradict it.  Angles, estimated values and errors are not read.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from raybundle.errors import InputError
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.photos.container import SUFFIXES
from raybundle.io.reading.dialects import table_text
from raybundle.io.reading.ledger import enter
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory, TrajectoryFormat, register
from raybundle.io.trajectories.geo_txt import WGS84_HEIGHTS, system_of
from raybundle.io.trajectories.image_rows import ImageRow, cell_number, cells_of_line, listed, separator_of

OURS = {"image", "point"}
"""First columns of raybundle's own tables."""
_SYSTEM = re.compile(r"#?\s*(?:coordinate\s*system|crs)\s*[:=]\s*(.+)", re.IGNORECASE)
_KINDS = {
    "name": r"(image|photo|file|camera)?(name|label)|image|images|photo|file|label|name",
    "longitude": r"x?(longitude|lon|long|lng)(deg|decimaldegrees|wgs84)?",
    "latitude": r"y?(latitude|lat)(deg|decimaldegrees|wgs84)?",
    "x": r"x|xm|xeasting|easting|xeast|east|e",
    "y": r"y|ym|ynorthing|northing|ynorth|north|n",
    "z": r"z|zm|zaltitude|altitude|altitudem|altitudemeter|alt|height|heightm|elevation|ellipsoidalheight|zheight|h",
    "plan": r"(accuracy|error|sigma)(horz|horizontal|xy|h|plan)m?|(horz|horizontal|xy)accuracym?|accuracyxym?",
    "sx": r"(accuracy|sigma)(x|xeasting|xlongitude|east|lon|longitude)m?|(x|east|easting|longitude)accuracym?|sx",
    "sy": r"(accuracy|sigma)(y|ynorthing|ylatitude|north|lat|latitude)m?|(y|north|northing|latitude)accuracym?|sy",
    "sz": r"(accuracy|sigma)(z|zaltitude|up|alt|altitude|vert|vertical|height|v)m?|"
    r"(z|vert|vertical|altitude)accuracym?|sz",
}
_PATTERNS = {kind: re.compile(pattern) for kind, pattern in _KINDS.items()}
METRES = {"", "m", "meter", "meters", "metre", "metres"}
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
    content: list[tuple[int, str]] = []
    for line, text in lines:
        if said := _SYSTEM.fullmatch(text):
            crs, remarks = system_of(said[1].strip().strip('"'), path, line)
        elif not content and not header and _header(text) is not None:
            header = text
        elif not text.startswith("#"):
            content.append((line, text))
    separator = separator_of([*([header] if header else []), *(t for _, t in content)])
    cells = [(n, cells_of_line(t, separator)) for n, t in content]
    columns = _header(header) if header else None
    if columns is None:  # nothing names them
        columns, remark = _by_plausibility(path, cells)
        remarks = (*remarks, *remark)
    if columns.geographic and crs is None:
        crs, remarks = WGS84_HEIGHT, (*remarks, WGS84_HEIGHTS)
    _check_units(path, columns, compound=crs is not None and parse_crs(crs).is_compound)
    width = max((len(w) for _, w in cells), default=0)
    for k in range(width):
        if k not in columns.at.values():
            enter(columns.names[k] if k < len(columns.names) else f"column {k + 1}")
    rows = [_row(path, n, w, columns, comma=separator != ",") for n, w in cells]
    return listed(path, rows, crs, remarks)


def _header(text: str) -> _Columns | None:
    """The columns of a line of names; None where it is none."""
    bare = text.lstrip("#").strip()
    counts = {s: bare.count(s) for s in ("\t", ";", ",")}
    separator = max(counts, key=lambda s: counts[s])
    words = [w.strip().strip('"') for w in (bare.split(separator) if counts[separator] else bare.split())]
    at: dict[str, int] = {}
    for k, word in enumerate(words):
        plain = re.sub(r"[^a-z0-9]", "", re.sub(r"[\[(].*?[\])]", "", word.lower()))  # without units
        kind = next((n for n, p in _PATTERNS.items() if p.fullmatch(plain)), None)
        if kind is not None:
            at.setdefault(kind, k)
    placed = {"longitude", "latitude"} <= at.keys() or {"x", "y"} <= at.keys()
    return _Columns(at, words) if "name" in at and placed else None


def _check_units(path: Path, columns: _Columns, *, compound: bool) -> None:
    """Raise InputError where a name states, in brackets, another unit or another reference of the heights.

    compound  whether the coordinate system says what heights count from
    """
    for kind, k in columns.at.items():
        if kind == "name" or k >= len(columns.names):
            continue
        for words in re.findall(r"[\[(](.*?)[\])]", columns.names[k]):
            plain = re.sub(r"[^a-z0-9]", "", words.lower())
            allowed = DEGREES if kind in {"longitude", "latitude"} else METRES
            if plain in allowed or _PATTERNS[kind].fullmatch(plain):
                continue
            if kind == "z" and (compound or plain in ELLIPSOID):
                continue
            need = "degrees" if allowed is DEGREES else "metres"
            if kind == "z":
                need = (
                    "metres above the ellipsoid, or name the system of the heights (# CoordinateSystem: EPSG:4326+5773)"
                )
            raise InputError(f"{quoted(words)} is not read; give {need}", file=path, column=columns.names[k])


def _by_plausibility(path: Path, cells: Sequence[tuple[int, list[str]]]) -> tuple[_Columns, tuple[str, ...]]:
    """The columns of a list without names: name, latitude, longitude, height, or X, Y, Z."""
    places: list[tuple[float, float]] = []
    for line, words in cells:
        if len(words) < 4:
            message = f"{len(words)} columns; without a line of names a line is NAME, three coordinates"
            raise InputError(message, file=path, line=line)
        a, b = (cell_number(w, path, line, str(k), comma=True) for k, w in enumerate(words[1:3], 2))
        places.append((a, b))
    width = min((len(w) for _, w in cells), default=4)
    at = {"name": 0, "z": 3}
    if width in BY_COUNT:
        at["plan"], at["sz"] = BY_COUNT[width]
    a, b = (max((abs(p[k]) for p in places if p[k] == p[k]), default=0.0) for k in (0, 1))
    if a <= 90 and b <= 180:
        return _Columns(at | {"latitude": 1, "longitude": 2}), (
            "no column names: taken as latitude, longitude, height",
        )
    if a <= 180 and b <= 90:
        return _Columns(at | {"longitude": 1, "latitude": 2}), (
            "no column names: taken as longitude, latitude, height",
        )
    return _Columns(at | {"x": 1, "y": 2}), ("no column names: taken as X, Y, Z",)


def _row(path: Path, line: int, words: list[str], columns: _Columns, *, comma: bool) -> ImageRow:
    def number(*kinds: str) -> float:
        k = next((columns.at[kind] for kind in kinds if kind in columns.at), None)
        return math.nan if k is None or k >= len(words) else cell_number(words[k], path, line, kinds[0], comma=comma)

    if len(words) <= max(columns.at[k] for k in columns.at if k in {"name", "longitude", "latitude", "x", "y"}):
        raise InputError(f"{len(words)} columns, fewer than the names of columns need", file=path, line=line)
    place = ("longitude", "latitude") if columns.geographic else ("x", "y")
    x, y = (number(n) for n in place)
    sigma = number("sx", "plan"), number("sy", "plan"), number("sz")
    return ImageRow(line, words[columns.at["name"]], (x, y, number("z")), sigma)


def _recognises(head: str, suffix: str) -> bool:
    lines = [t.strip() for t in head.splitlines() if t.strip()]
    if suffix not in {".csv", ".txt"} or not lines:
        return False
    for text in lines[:5]:
        columns = _header(text)
        if columns is not None:
            return columns.names[0] not in OURS
        if not text.startswith("#"):
            break
    rows = [t for t in lines if not t.startswith("#")][:1]
    separator = separator_of(rows)
    words = cells_of_line(rows[0], separator) if rows else []
    named = bool(words) and Path(words[0]).suffix.lower() in SUFFIXES
    return named and len(words) >= 4 and all(number_of(w.replace(",", ".")) is not None for w in words[1:4])


register(
    TrajectoryFormat(
        name="image-list", title="position list of Pix4D, Metashape and others: image, coordinates, accuracies",
        read=read, recognises=_recognises,
    )
)  # fmt: skip
