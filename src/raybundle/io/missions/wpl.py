"""QGC WPL 110: tab separated lines, as Mission Planner and MAVProxy take them (mavlink.io, "File Formats").

Index, current, frame, command, seven parameters, autocontinue; item 0 is the take-off with its absolute height.
"""

from __future__ import annotations

from pathlib import Path

from raybundle.errors import InputError
from raybundle.io.missions.base import MissionFormat, register
from raybundle.io.missions.mavlink import ABSOLUTE, WAY_POINT, Item, items_of, route_of
from raybundle.io.reading.files import read_lines
from raybundle.io.reading.words import no_number, number_of
from raybundle.missions.route import Route

HEAD = "QGC WPL 110"
CELLS = 12


def write(route: Route, path: Path) -> None:
    """One list of items."""
    home = Item(command=WAY_POINT, frame=ABSOLUTE, parameters=(0.0, 0.0, 0.0, 0.0, *route.home))
    lines = [HEAD]
    for k, item in enumerate([home, *items_of(route)]):
        numbers = [f"{v:.10f}" for v in item.parameters]
        lines.append("\t".join([str(k), "1" if k == 0 else "0", str(item.frame), str(item.command), *numbers, "1"]))
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")


def read(path: Path) -> Route:
    """The way points of a list of items."""
    lines = [(n, line) for n, line in read_lines(path) if line.strip()]
    if not lines or lines[0][1].strip() != HEAD:
        raise InputError("wpl.no_header", head=HEAD, file=path, line=1)
    items = [_item(path, n, line) for n, line in lines[1:]]
    if not items:
        raise InputError("mission.no_way_point", file=path)
    lat, lon, height = items[0].parameters[4:7]
    return route_of(items[1:], (lat, lon, height), path.stem, str(path))


def _item(path: Path, line: int, text: str) -> Item:
    words = text.split()
    if len(words) != CELLS:
        raise InputError("value.count", n=len(words), needed=CELLS, file=path, line=line)
    values: list[float] = []
    for word in words:
        value = number_of(word)
        if value is None:
            raise InputError(no_number(word), file=path, line=line)
        values.append(value)
    return Item(command=int(values[3]), frame=int(values[2]), parameters=tuple(values[4:11]))


register(MissionFormat(name="wpl", about="QGC WPL 110, .waypoints", suffix=".waypoints", write=write, read=read))
