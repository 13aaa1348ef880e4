"""Lists of exterior orientations: a line for each image with its place and three angles or the nine elements of R.

    image X Y Z omega phi kappa           names of the columns in any order and spelling, or none; a title above
    # Camera; Session; Nr; X; Y; Z; Rot_X; Rot_Y; Rot_Z                                              (UltraMap)
    ID  # EVENT  TIME(s)  EASTING  NORTHING  ELLIPSOID HEIGHT  OMEGA  PHI  KAPPA  LAT  LONG          (Applanix POSEO)

Columns stand between commas, semicolons, tabs or blanks, or in fixed columns; decimals may have a comma.  The unit is
the one that a name, a bracket or the title states.  Where nothing is stated, angles above 400 are refused, above 360
are gon, above 2 pi degrees or gon; the rest may be radians too.  Columns phi, omega, kappa may mean either sequence of
rotations, and so may columns without names.  A list with several readings leaves the choice to the photographs.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.reading.dialects import table_text
from raybundle.io.reading.ledger import enter
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.trajectories.angle_csv import UNITS, has_angles
from raybundle.io.trajectories.attitudes import ROTATIONS
from raybundle.io.trajectories.base import WGS84_HEIGHT, Reading, Trajectory, TrajectoryFormat, decided, register
from raybundle.io.trajectories.geo_txt import SYSTEM, system_of
from raybundle.io.trajectories.image_rows import (
    LIMITS,
    METRES,
    OURS,
    SEPARATORS,
    STATED_SYSTEM,
    ImageRow,
    cell_number,
    cells_of_line,
    kind_of,
    listed,
    separator_of,
)
from raybundle.numerics.arrays import Array
from raybundle.numerics.attitude import opk_from_rotation
from raybundle.numerics.rotation import nearest_rotation

ANGLES = ("omega", "phi", "kappa")
ELEMENTS = tuple(f"r{i}{j}" for i in "123" for j in "123")
MATRICES = ("matrix", "matrix-inverse")
"""R of the file turns object axes to image axes, or image axes to object axes."""
LARGEST, CIRCLE, RADIANS = 400.0, 360.0, 6.3
"""Size of angles in gon, in degrees and in radians"""
ORTHOGONAL = 1e-3
WIDTHS = (7, 13)
"""Cells of a line without names: name, place, angles or elements"""
_SPREAD = "s|sd|std|stdev|sig|sigma|rms|acc|accuracy"
_SPELLED = {"omega": "omega|om|w|ω|rotx", "phi": "phi|p|φ|ϕ|roty", "kappa": "kappa|kap|k|κ|rotz"}
_KINDS = {
    **{f"s{n}": rf"(?:{_SPREAD})(?:{s})|(?:{s})(?:{_SPREAD})" for n, s in _SPELLED.items()},
    **_SPELLED,
    **{n: rf"[armd]{n[1:]}" for n in ELEMENTS},
    "time": r"(gps|utc)?(time|sec|seconds|sow|tow)s?",
    "event": r"event|eventno|eventid|nr|no|number",
    "name": r"(image|photo|frame|picture|exposure|img|bild|foto|aufnahme)(id|no|nr|num|number|nummer|file)?|id",
    "x": r"(x|e)0|x[cls]|(projection|perspective|proj|persp)?cent(er|re)x",
    "y": r"(y|n)0|y[cls]|(projection|perspective|proj|persp)?cent(er|re)y",
    "z": r"(z|h)0|z[cls]|(projection|perspective|proj|persp)?cent(er|re)z|ortho(metric)?height|ellipsoid(al)?height",
}
_UNIT = "deg|degree|degrees|gon|gons|grads|rad|radian|radians"
_PATTERNS = {kind: re.compile(rf"(?:{pattern})(?P<unit>{_UNIT})?") for kind, pattern in _KINDS.items()}
_SIGNS = {"°": "deg", "grad": "", "grads": "gon", "neugrad": "gon", "altgrad": "deg"}
_ABOUT_ANGLES = re.compile(
    r"(?:orientation|angle|angular|rotation|attitude|winkel|drehung|omega|kappa|unit|einheit)", re.IGNORECASE
)
_STATED_UNIT = re.compile(rf"(?<![a-zA-Z])({_UNIT}|neugrad|altgrad)(?![a-zA-Z])", re.IGNORECASE)
_STATED_PLACE = re.compile(
    r"(?:position|coordinates?|linear unit)s?\W+(?:in|:|=)\s*\W?(feet|foot|ft|usft)\b", re.IGNORECASE
)
_SEQUENCE = re.compile(r"\b(omega|phi)\b\W+\b(omega|phi)\b\W+kappa", re.IGNORECASE)
_PRIMARY = re.compile(r"(?:first rotation|primary)\b.{0,40}?\b([xy]|omega|phi)\b", re.IGNORECASE)
_JOINED = (
    (re.compile(r"#\s*event", re.IGNORECASE), "event"),
    (re.compile(r"(?i)(ellipsoid\w*|ortho\w*|photo|image|frame|file)\s+(height|name|id|number|no|nr)\b"), r"\1\2"),
    (re.compile(r"(\w)\s+([\[(])"), r"\1\2"),
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class _Columns:
    """Which column holds what, and the units that names state."""

    at: dict[str, int]
    names: tuple[str, ...] = ()
    unit: dict[str, str] | None = None

    def called(self, kinds: Sequence[str]) -> str:
        """The names of columns, or their numbers, for messages."""
        places = [self.at[k] for k in kinds if k in self.at]
        return " ".join(self.names[k] if k < len(self.names) else str(k + 1) for k in places)

    @property
    def place(self) -> tuple[str, str]:
        """The kinds of the horizontal coordinates: a grid before degrees where there are both."""
        return ("x", "y") if {"x", "y"} <= self.at.keys() else ("longitude", "latitude")

    @property
    def turn(self) -> tuple[str, ...]:
        """The kinds of what states rotations."""
        return ANGLES if {*ANGLES} <= self.at.keys() else ELEMENTS


def read(path: Path) -> Trajectory:
    """Exterior orientations of a list; raises InputError with line and column."""
    lines = [(n, t.strip("\x1a").rstrip()) for n, t in enumerate(table_text(path).split("\n"), 1)]
    lines = [(n, t) for n, t in lines if t.strip()]
    first, columns = _beginning(lines)
    above = [t for _, t in lines[:first]]
    rows = [(n, t) for n, t in lines[first:] if not t.lstrip().startswith("#")]
    if not rows:
        raise InputError("trajectory.no_position", file=path)
    for line, text in lines[:first]:
        if _STATED_PLACE.search(text):
            raise InputError("image_list.unit", unit=quoted(text.strip()), quantity="length", file=path, line=line)
    crs, remarks = _system(path, lines[:first])
    separator = separator_of([t for _, t in rows])
    width = None if columns is None else len(columns.names)
    cells = _cells(rows, separator, width)
    columns = columns or _unnamed(path, cells, above)
    _check_metres(path, columns)
    for k in range(len(columns.names)):
        if k not in columns.at.values() and columns.names[k]:
            enter(columns.names[k])
    comma = separator != ","
    found = [_row(path, n, w, columns, comma=comma) for n, w in cells]
    geographic = columns.place[0] == "longitude"
    trajectory = listed(path, found, WGS84_HEIGHT if geographic and crs is None else crs, remarks)
    turns = np.array([[_number(path, n, w, columns, k, comma=comma) for k in columns.turn] for n, w in cells])
    spread = [f"s{a}" for a in ANGLES]
    sigma = np.array([[_number(path, n, w, columns, k, comma=comma) for k in spread] for n, w in cells])
    times = np.array([_number(path, n, w, columns, "time", comma=comma) for n, w in cells])
    return replace(
        _with_angles(trajectory, columns, turns, sigma, above),
        time=times if np.isfinite(times).any() else None, numbered="event" in columns.at and "name" not in columns.at,
        true_north=trajectory.crs == WGS84_HEIGHT,
    )  # fmt: skip


def _beginning(lines: Sequence[tuple[int, str]]) -> tuple[int, _Columns | None]:
    """The first line with an orientation, and the columns by their names; None: they have no names."""
    for k, (_, text) in enumerate(lines):
        if (columns := _header(text, [t for _, t in lines[k + 1 : k + 5]])) is not None:
            row = k + 1
            while row < len(lines) and not re.search(r"[0-9]", lines[row][1]):
                row += 1  # units, rules
            return row, columns
        if _is_row(text):
            above = _split(lines[k - 1][1]) if k else []
            named = len(above) in WIDTHS and all(number_of(w) is None for w in above)
            if named and (separator_of([text]) is not None or _kind(above[0])[0] == "name"):
                return len(lines), None  # names that are not understood
            width = len(_split(text))
            return next((j for j in range(k) if _nearly_row(lines[j][1], width)), k), None
    return len(lines), None


def _split(text: str) -> list[str]:
    return cells_of_line(text, separator_of([text]))


def _is_row(text: str) -> bool:
    """Whether a line is one of a list without names, in a grid."""
    words = _split(text)
    glued = _glued(text)
    numbers = [number_of(w.replace(",", ".")) for w in words[1:]]
    if words and words[-1] == "":
        numbers = numbers[:-1]
    if None in numbers and glued:
        return True
    return len(numbers) + 1 in WIDTHS and None not in numbers and abs(numbers[0] or 0.0) > LIMITS[0]


def _nearly_row(text: str, width: int) -> bool:
    """Whether a line has so many cells and all numbers but one: a row, whether it can be read or not."""
    words = _split(text)
    missing = sum(number_of(w.replace(",", ".")) is None for w in words[1:])
    return len(words) == width and missing < 2 and not text.lstrip().startswith("#")


def _glued(text: str) -> bool:
    """Whether a line is a name and numbers that partly follow each other without a blank."""
    words = text.split()
    rest = "".join(words[1:])
    return len(words) > 2 and re.fullmatch(r"[-+.0-9]+", rest) is not None and rest.count(".") in {6, 12}


def _header(text: str, below: Sequence[str]) -> _Columns | None:
    """The columns of a line of names; None where it is none."""
    bare = text.strip().lstrip("/").strip()
    plain = bare.lstrip("#").strip()
    for pattern, put in _JOINED:
        bare = pattern.sub(put, bare)
    bare = bare.lstrip("#").strip()
    counts = {s: plain.count(s) for s in SEPARATORS}
    separator = max(counts, key=lambda s: counts[s])
    ways = [plain.split(separator)] if counts[separator] >= 5 else [re.split(r"\s{2,}", plain), bare.split()]
    widths = {len(_split(t)) for t in below} | {len(t.split()) for t in below}
    for words in sorted(ways, key=lambda w: len(w) not in widths):
        names = tuple(w.strip().strip('"').strip() for w in words)
        at: dict[str, int] = {}
        unit: dict[str, str] = {}
        for k, name in enumerate(names):
            kind, stated = _kind(name)
            if kind and kind not in at:
                at[kind] = k
                if stated:
                    unit[kind] = stated
        found = _Columns(at, names, unit)
        if {"name", "event"} & at.keys() and {*found.place, "z", *found.turn} <= at.keys():
            return found
    return None


def _kind(word: str) -> tuple[str | None, str]:
    """What a column of this name holds, and the unit that it states."""
    inside = re.search(r"[\[(]\s*(.*?)\s*[\])]", word)
    stated = _unit(inside[1]) if inside else ""
    plain = re.sub(r"[^a-z0-9ωφϕκ]", "", re.sub(r"[\[(].*?[\])]", "", word.lower()))
    for kind, pattern in _PATTERNS.items():
        if match := pattern.fullmatch(plain):
            return kind, stated or _unit(match["unit"] or "")
    kind = kind_of(re.sub("[ö\ufffd]", "oe", word.lower()), estimated=True)  # Windows-1252 while a format is looked for
    return (kind, "") if kind not in {None, "plan", "enabled"} else (None, "")


def _unit(text: str) -> str:
    """The unit that a text states: deg, gon, rad or empty."""
    plain = text.strip().lower()
    if plain in _SIGNS:
        return _SIGNS[plain]
    return next((u for u in UNITS if plain.startswith(u)), "") if re.fullmatch(_UNIT, plain) else ""


def _system(path: Path, above: Sequence[tuple[int, str]]) -> tuple[str | None, tuple[str, ...]]:
    for line, text in above:
        if stated := STATED_SYSTEM.fullmatch(text.strip()):
            return system_of(stated[1].strip().strip('"'), path, line)
    return None, ()


def _cells(rows: Sequence[tuple[int, str]], separator: str | None, width: int | None) -> list[tuple[int, list[str]]]:
    """The cells of each line; between blanks by the number of names, or in fixed columns where numbers touch."""
    if separator is not None:
        cells = [(n, cells_of_line(t, separator)) for n, t in rows]
        return [(n, w[:-1] if w and not w[-1] and len(w) != width else w) for n, w in cells]
    plain = [(n, t.split()) for n, t in rows]
    if width is not None and all(len(w) == width for _, w in plain):
        return plain
    if any(_glued(t) and len(t.split()) < WIDTHS[0] for _, t in rows):
        return _fixed(rows)
    return [(n, cells_of_line(t, None)) for n, t in rows]


def _fixed(rows: Sequence[tuple[int, str]]) -> list[tuple[int, list[str]]]:
    """Lines cut where numbers end in some of them and a digit stands in all."""
    texts = [t for _, t in rows]
    longest = max(map(len, texts))
    ends = {m.end() for t in texts for m in re.finditer(r"(?<=[0-9])(?=[ +-]|$)", t)}
    cuts = [e for e in sorted(ends) if all(len(t) < e or t[e - 1].isdigit() for t in texts)]
    found: list[tuple[int, list[str]]] = []
    for line, text in rows:
        start = re.match(r"\s*\S+", text)
        a = start.end() if start else 0
        words = [text[:a].strip()]
        for b in [c for c in cuts if c > a] + [longest]:
            words += text[a:b].split()
            a = b
        found.append((line, words))
    return found


def _unnamed(path: Path, cells: Sequence[tuple[int, list[str]]], above: Sequence[str]) -> _Columns:
    """The columns of a list without names: name, place, and three angles or nine elements; raises InputError."""
    line, words = next(((n, w) for n, w in cells if len(w) not in WIDTHS), cells[0])
    touching = next((k for k, w in enumerate(words) if k and w.count(".") > 1), None)
    if touching is not None:
        raise InputError(
            "exterior_list.touching", value=quoted(words[touching]), file=path, line=line, column=str(touching + 1)
        )
    if len(words) not in WIDTHS:
        raise InputError(
            "exterior_list.columns", n=len(words), needed=[*WIDTHS], file=path, line=line,
            column=str(min(len(words), WIDTHS[0]) + 1),
        )  # fmt: skip
    sequence = next((m for t in above if (m := _SEQUENCE.search(t))), None)
    phi_first = sequence is not None and sequence[1].lower() == "phi"
    turn = ELEMENTS if len(words) == WIDTHS[1] else ("phi", "omega", "kappa") if phi_first else ANGLES
    return _Columns({k: i for i, k in enumerate(("name", "x", "y", "z", *turn))})


def _check_metres(path: Path, columns: _Columns) -> None:
    """Raise InputError where a coordinate of a grid has another unit than the metre."""
    for kind in ("x", "y", "z"):
        k = columns.at.get(kind, len(columns.names))
        for unit in re.findall(r"[\[(](.*?)[\])]", columns.names[k] if k < len(columns.names) else ""):
            if re.sub(r"[^a-z]", "", unit.lower()) not in METRES:
                raise InputError(
                    "image_list.unit", unit=quoted(unit), quantity="length", file=path, column=columns.names[k]
                )


def _number(path: Path, line: int, words: Sequence[str], columns: _Columns, kind: str, *, comma: bool) -> float:
    k = columns.at.get(kind)
    if k is None or k >= len(words):
        return math.nan
    return cell_number(words[k], path, line, columns.called([kind]), comma=comma)


def _row(path: Path, line: int, words: list[str], columns: _Columns, *, comma: bool) -> ImageRow:
    name = "name" if "name" in columns.at else "event"
    needed = 1 + max(columns.at[k] for k in (name, *columns.place, "z", *columns.turn))
    if len(words) < needed:
        raise InputError("line.too_few_cells", n=len(words), needed=needed, file=path, line=line)

    def number(kind: str) -> float:
        return _number(path, line, words, columns, kind, comma=comma)

    x, y = (number(k) for k in columns.place)
    sigma = number("sx"), number("sy"), number("sz")
    return ImageRow(line, words[columns.at[name]], (x, y, number("z")), sigma)


def _with_angles(
    trajectory: Trajectory, columns: _Columns, turns: Array, sigma: Array, above: Sequence[str]
) -> Trajectory:
    """The trajectory with its attitudes, or with the readings that the file leaves open."""
    if columns.turn == ELEMENTS:
        return with_matrices(trajectory, turns.reshape(-1, 3, 3), columns.called(ELEMENTS))
    units, by_size = _units(trajectory, columns, turns, above)
    text = "\n".join(above)
    primary = _PRIMARY.search(text)
    stated = bool(columns.names) or _SEQUENCE.search(text) is not None
    phi_first = columns.at["phi"] < columns.at["omega"]
    if primary:
        orders = ["opk" if primary[1].lower() in {"x", "omega"} else "pok"]
    else:
        orders = ["opk"] if stated and not phi_first else ["pok", "opk"] if stated else ["opk", "pok"]
    readings: list[Reading] = []
    for order, unit in product(orders, units):
        # the first two columns of a list without names are phi and omega where phi is primary
        columns_of = [1, 0, 2] if order == "pok" and stated else [0, 1, 2]
        a = turns[:, columns_of] * UNITS[unit]
        R = np.full((len(a), 3, 3), np.nan)
        known = np.isfinite(a).all(axis=1)
        R[known] = ROTATIONS[order](a[known])
        s = sigma[:, columns_of] * UNITS[(columns.unit or {}).get("somega", unit)]
        readings.append(Reading(name=f"{order}-{unit}", convention=order, angles=a, rotation=R,
                                sigma=s if np.isfinite(s).any() else None))  # fmt: skip
    return with_readings(trajectory, readings, columns.called(_open(columns, units, orders)), by_size=by_size)


def _open(columns: _Columns, units: Sequence[str], orders: Sequence[str]) -> Sequence[str]:
    """The columns that a message names: the angle without a unit, or all three without a sequence."""
    return ["kappa"] if len(orders) == 1 and len(units) > 1 else sorted(ANGLES, key=lambda a: columns.at[a])


def _units(trajectory: Trajectory, columns: _Columns, turns: Array, above: Sequence[str]) -> tuple[list[str], bool]:
    """The units that the angles may have, and whether only their size shows them."""
    stated = {u for a in ANGLES if (u := (columns.unit or {}).get(a, ""))}
    if not stated:
        about = [t for t in above if _ABOUT_ANGLES.search(t) or not re.search(r"[a-z]{3}.*[a-z]{3}", t)]
        stated = {u for t in about for m in _STATED_UNIT.finditer(_angles_part(t)) if (u := _unit(m[1]))}
    if len(stated) == 1:
        return [*stated], False
    size = np.abs(turns)
    largest = float(np.nanmax(size, initial=0.0))
    if largest > LARGEST:
        row, k = np.unravel_index(int(np.nanargmax(size)), size.shape)
        raise InputError(
            "exterior_list.angle_size", value=largest, largest=LARGEST, file=trajectory.path,
            line=int(trajectory.lines[row]), column=columns.called([ANGLES[k]]),
        )  # fmt: skip
    if largest > CIRCLE:
        return ["gon"], True
    return ["deg", "gon"] if largest > RADIANS else ["rad", "deg", "gon"], True


def _angles_part(text: str) -> str:
    """What a line states of the angles: behind their name, up to the next comma."""
    start = _ABOUT_ANGLES.search(text)
    return text[start.start() :].partition(", lat")[0] if start else text


def with_matrices(
    trajectory: Trajectory, matrices: Array, column: str, *, names: Sequence[str] = MATRICES, preferred: bool = False
) -> Trajectory:
    """The trajectory with rotations of a file in the readings `names`; raises InputError where one is no rotation."""
    off = np.abs(matrices @ np.swapaxes(matrices, 1, 2) - np.eye(3)).max(axis=(1, 2))
    bad = np.flatnonzero(~(off < ORTHOGONAL) | ~(np.linalg.det(matrices) > 0))
    if len(bad):
        raise InputError(
            "rotation.not_orthogonal", file=trajectory.path, line=int(trajectory.lines[bad[0]]), column=column
        )
    R = np.array([nearest_rotation(m) for m in matrices])
    turned = {"matrix": R, "matrix-inverse": np.swapaxes(R, 1, 2)}
    readings = [
        Reading(name=n, convention="opk", angles=opk_from_rotation(turned[n]), rotation=turned[n]) for n in names
    ]
    return with_readings(trajectory, readings, column, preferred=preferred)


def with_readings(
    trajectory: Trajectory, readings: Sequence[Reading], column: str, *, by_size: bool = False, preferred: bool = False
) -> Trajectory:
    """The trajectory with its readings, and the remark that states them; R of a single or preferred one."""
    names = [r.name for r in readings]
    if len(readings) == 1 or preferred:
        remark = phrase("position_list.orientations", reading=names[0], by_size=by_size)
        trajectory = replace(decided(replace(trajectory, readings=tuple(readings)), names[0]),
                             readings=tuple(readings) if preferred else ())  # fmt: skip
    else:
        remark = phrase("position_list.orientations_open", readings=names, columns=column)
        trajectory = replace(trajectory, readings=tuple(readings), undecided=column)
    return replace(trajectory, remarks=(*trajectory.remarks, remark))


def is_list(head: str) -> bool:
    """Whether the beginning of a file is a list of exterior orientations."""
    texts = [t for t in head.splitlines() if t.strip()][: -1 if len(head) > 4000 else None]
    if not texts or SYSTEM.match(texts[0]) or texts[0].startswith("%") or has_angles(head, ANGLES):
        return False
    first, columns = _beginning([*enumerate(texts)])
    return first < len(texts) and (columns is None or not (columns.names[0] in OURS and "omega_deg" in columns.names))


register(
    TrajectoryFormat(
        name="exterior-list",
        title="exterior orientations",
        read=read,
        recognises=lambda head, suffix: suffix != ".prj" and is_list(head),
    )
)
