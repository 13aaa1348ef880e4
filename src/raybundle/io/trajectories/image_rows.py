"""Lines NAME NUMBER NUMBER ... of position lists: separators, names with blanks, decimal signs."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.photos.container import SUFFIXES
from raybundle.io.reading.words import no_number, number_of
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory

_DECIMAL_COMMAS = re.compile(r"\S +[-+]?\d+,\d+ +[-+]?\d+,\d+( |$)")
"""Two numbers with decimal commas between blanks"""
SEPARATORS = ("\t", ";", ",")
LIMITS = (180.0, 90.0)
METRES = {"", "m", "meter", "meters", "metre", "metres"}
OURS = {"image", "point"}
"""First columns of raybundle's own tables."""
STATED_SYSTEM = re.compile(r"#?\s*(?:coordinate\s*system|crs)\s*[:=]\s*(.+)", re.IGNORECASE)
_KINDS = {
    "name": r"(image|photo|file|camera)?(name|label)|image|images|photo|file|label|name",
    "enabled": r"enabled?",
    "longitude": r"x?(longitude|lon|long|lng)(deg|decimaldegrees|wgs84)?",
    "latitude": r"y?(latitude|lat)(deg|decimaldegrees|wgs84)?",
    "x": r"xm?|x?(easting|east|e|rechtswert)m?",
    "y": r"ym?|y?(northing|north|n|hochwert)m?",
    "z": r"zm?|z?(altitude|alt|ellipsoidalheight|height|elevation|elev|up|h|hoehe)(m|meter)?",
    "plan": r"(accuracy|error|sigma)(horz|horizontal|xy|h|plan)m?|(horz|horizontal|xy)accuracym?|accuracyxym?",
    "sx": r"(accuracy|sigma)(x|xeasting|xlongitude|east|lon|longitude)m?|(x|east|easting|longitude)accuracym?|sx",
    "sy": r"(accuracy|sigma)(y|ynorthing|ylatitude|north|lat|latitude)m?|(y|north|northing|latitude)accuracym?|sy",
    "sz": r"(accuracy|sigma)(z|zaltitude|up|alt|altitude|vert|vertical|height|v)m?|"
    r"(z|vert|vertical|altitude)accuracym?|sz",
}
PATTERNS = {kind: re.compile(pattern) for kind, pattern in _KINDS.items()}
_ABOUT = "gps|gnss|position|pos|local|coordinate|coord|camera|cam"
_AROUND = {
    estimated: re.compile(rf"(?:{words})*(.+?)(?:{words})*")
    for estimated, words in ((False, _ABOUT), (True, f"estimated|est|{_ABOUT}"))
}
"""Words before and behind the name of a coordinate, which change nothing of it."""


@dataclass(frozen=True, slots=True)
class ImageRow:
    """An image with its position."""

    line: int
    name: str
    place: tuple[float, float, float]
    """x or longitude, y or latitude, height; NaN where not known"""
    sigma: tuple[float, float, float] = (math.nan, math.nan, math.nan)
    """east, north, up [m]"""


def kind_of(word: str, *, estimated: bool) -> str | None:
    """What a column of this name holds; None: not understood."""
    plain = re.sub(r"[^a-z0-9]", "", re.sub(r"[\[(].*?[\])]", "", word.lower()))  # without units
    core = _AROUND[estimated].fullmatch(plain)
    for name in (plain, core[1] if core else plain):
        for kind, pattern in PATTERNS.items():
            if pattern.fullmatch(name):
                return kind
    return None


def separator_of(lines: Sequence[str]) -> str | None:
    """What separates the columns of most lines; None: blanks."""
    if lines and all(_DECIMAL_COMMAS.search(line) for line in lines):
        return None
    for separator in SEPARATORS:
        if 2 * sum(line.count(separator) >= 2 for line in lines) >= max(len(lines), 1):
            return separator
    return None


def cells_of_line(text: str, separator: str | None) -> list[str]:
    """The columns of a line; between blanks the name of an image ends with its suffix."""
    if separator is not None:
        return [c.strip().strip('"').strip() for c in text.split(separator)]
    words = [(m.start(), m.end()) for m in re.finditer(r"\S+", text)]
    ends = [k for k, (a, b) in enumerate(words) if Path(text[a:b]).suffix.lower() in SUFFIXES]
    if not ends or ends[-1] == 0:
        return text.split()
    return [text[: words[ends[-1]][1]].strip(), *(text[a:b] for a, b in words[ends[-1] + 1 :])]


def cell_number(word: str, path: Path, line: int, column: str, *, comma: bool) -> float:
    """The number in a cell, NaN for an empty one.

    comma   whether decimals may have a comma
    raises  InputError
    """
    if not word or word.lower() in {"nan", "none", "-"}:
        return math.nan
    value = number_of(word.replace(",", ".") if comma and word.count(",") == 1 else word)
    if value is None:
        raise InputError(no_number(word), file=path, line=line, column=column)
    return value


def listed(
    path: Path, rows: Sequence[ImageRow], crs: str | None, remarks: Sequence[str] = (), fix: Sequence[str] = ()
) -> Trajectory:
    """The positions of rows; raises InputError for a name that stands twice, or a place that is none on the earth."""
    if not rows:
        raise InputError("trajectory.no_position", file=path)
    first: dict[str, int] = {}
    for row in rows:
        if not row.name.strip():
            raise InputError("name.missing", file=path, line=row.line, column="name")
        if row.name in first:
            raise InputError(
                "cell.id_twice",
                id=row.name,
                earlier=first[row.name],
                rows=False,
                file=path,
                line=row.line,
                column="name",
            )
        first[row.name] = row.line
    xyz, sigma = np.array([r.place for r in rows]), np.array([r.sigma for r in rows])
    stated = list(remarks)
    if crs == WGS84_HEIGHT:
        for k, limit in enumerate(LIMITS):
            bad = np.flatnonzero(np.abs(xyz[:, k]) > limit)
            if len(bad):
                raise InputError(
                    "position.beyond_degrees", value=xyz[bad[0], k], limit=limit, file=path, line=rows[int(bad[0])].line
                )
        lost = (xyz[:, :2] == 0).all(axis=1)
        xyz[lost] = np.nan
        if lost.any():
            stated.append(phrase("position_list.no_fix", n=int(lost.sum()), of=len(lost)))
    return Trajectory(
        path=path, names=tuple(r.name for r in rows), xyz=xyz, sigma=np.where(sigma > 0, sigma, np.nan), crs=crs,
        fix=tuple(fix), remarks=tuple(stated), lines=np.array([r.line for r in rows], np.int32),
    )  # fmt: skip
