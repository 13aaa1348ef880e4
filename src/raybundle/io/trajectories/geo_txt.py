"""geo.txt of OpenDroneMap: the coordinate system in the first line, then a line for each image.

    image X Y [Z] [yaw pitch roll] [horizontal accuracy] [vertical accuracy]

X is the longitude in a geographic system.  Angles are not read: their zero differs among programs that write them.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

from raybundle.errors import InputError, phrase
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.reading.dialects import table_text
from raybundle.io.reading.ledger import enter
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory, TrajectoryFormat, register
from raybundle.io.trajectories.image_rows import ImageRow, cell_number, cells_of_line, listed

SYSTEM = re.compile(r"\s*(EPSG:\d+|\+(proj|init)=|WGS ?84(\s+UTM|\s*$)|(PROJ|GEOG|COMPD)(CS|CRS)\[)", re.IGNORECASE)
NAMES = ("image", "X", "Y", "Z", "yaw", "pitch", "roll", "horizontal accuracy", "vertical accuracy")
WGS84_HEIGHTS = "position_list.ellipsoid"


def read(path: Path) -> Trajectory:
    """Positions of a geo.txt; raises InputError with line and column."""
    lines = [(n, t.strip()) for n, t in enumerate(table_text(path).split("\n"), 1)]
    lines = [(n, t) for n, t in lines if t and not t.startswith("#")]
    if not lines:
        raise InputError("geo_txt.empty", file=path, line=1)
    (first, system), *rest = lines
    crs, remarks = system_of(system, path, first)
    separator = "\t" if rest and all(t.count("\t") >= 2 for _, t in rest) else None
    rows = [_row(path, n, cells_of_line(t, separator)) for n, t in rest]
    return listed(path, rows, crs, remarks)


def system_of(text: str, path: Path, line: int) -> tuple[str, tuple[str, ...]]:
    """The coordinate system of a text, and what is assumed about heights; raises InputError with file and line."""
    if re.fullmatch(r"WGS ?84", text.strip(), re.IGNORECASE):
        return WGS84_HEIGHT, (phrase(WGS84_HEIGHTS),)
    try:
        system = parse_crs(text)
    except InputError as error:
        raise error.at(path, line=line) from None
    if system.is_geographic and len(system.axis_info) == 2 and system.equals(parse_crs("EPSG:4326"), True):
        return WGS84_HEIGHT, (phrase(WGS84_HEIGHTS),)
    return text, ()


def _row(path: Path, line: int, words: list[str]) -> ImageRow:
    if len(words) < 3:
        raise InputError("line.too_few_cells", n=len(words), needed=3, file=path, line=line)
    if number_of(words[0]) is not None:
        raise InputError(
            "geo_txt.name_is_number", value=quoted(words[0]), example=f"{words[0]}.jpg 8.25 47.5 450",
            file=path, line=line, column="image",
        )  # fmt: skip
    numbers = [
        cell_number(w, path, line, c, comma=False) for w, c in zip(words[1:], NAMES[1:], strict=False)
    ]  # fmt: skip
    x, y = numbers[:2]
    height = numbers[2] if len(numbers) > 2 else math.nan
    for name in NAMES[4 : min(7, len(words))]:
        enter(name)
    for k in range(len(NAMES), len(words)):
        enter(f"column {k + 1}")
    plan = numbers[6] if len(numbers) > 6 else math.nan
    up = numbers[7] if len(numbers) > 7 else math.nan
    return ImageRow(line, words[0], (x, y, height), (plan, plan, up))


def _recognises(head: str, suffix: str) -> bool:
    lines = [t.strip() for t in head.splitlines() if t.strip() and not t.startswith("#")]
    if suffix != ".txt" or len(lines) < 2 or not SYSTEM.match(lines[0]):
        return False
    words = cells_of_line(lines[1], "\t" if lines[1].count("\t") >= 2 else None)
    return len(words) >= 3 and all(number_of(w) is not None for w in words[1:3])


register(
    TrajectoryFormat(
        name="geo-txt", title="geo.txt of OpenDroneMap: coordinate system, then image X Y Z", read=read,
        recognises=_recognises,
    )
)  # fmt: skip
