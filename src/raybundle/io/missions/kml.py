"""KML 2.2 (OGC 07-147r2): the way and its points for a map; what a vehicle needs beside stands in extended data.

Heights are absolute where the terrain is known, taken as above the sea; over level ground they are above the ground.
"""

from __future__ import annotations

from html import escape
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.missions.base import MissionFormat, register
from raybundle.io.reading.words import no_number, number_of, quoted
from raybundle.io.reading.xml import Element, read_xml
from raybundle.missions.route import Route
from raybundle.numerics.arrays import Array

DATA = ("height", "heading_deg", "pitch_deg", "speed", "trigger", "base")


def write(route: Route, path: Path) -> None:
    """The way as a line, its points, and the take-off."""
    level = route.above_ground is None
    mode = "relativeToGround" if level else "absolute"
    z = route.height if level else route.height + route.home[2]
    at = [f"{x:.10f},{y:.10f},{h:.9f}" for x, y, h in zip(route.longitude_deg, route.latitude_deg, z, strict=True)]
    name = escape(route.name)
    home = f"{route.home[1]:.10f},{route.home[0]:.10f},{0.0 if level else route.home[2]:.9f}"
    line = f"<altitudeMode>{mode}</altitudeMode><coordinates>{' '.join(at)}</coordinates>"
    parts = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<kml xmlns="http://www.opengis.net/kml/2.2">',
        "<Document>",
        f"<name>{name}</name>",
        '<Style id="way"><LineStyle><color>ff00a5ff</color><width>2</width></LineStyle></Style>',
        f"<Placemark><name>take-off</name><Point><coordinates>{home}</coordinates></Point></Placemark>",
        f"<Placemark><name>way</name><styleUrl>#way</styleUrl><LineString>{line}</LineString></Placemark>",
        "<Folder><name>way points</name>",
    ]
    for k, place in enumerate(at):
        values = (
            f"{route.height[k]:.9f}", f"{route.heading_deg[k]:.9f}", f"{route.pitch_deg[k]:.9f}",
            f"{route.speed[k]:.9f}", str(int(route.trigger[k])), f"{route.base[k]:.9f}",
        )  # fmt: skip
        data = "".join(
            f'<Data name="{n}"><value>{v}</value></Data>' for n, v in zip(DATA, values, strict=True) if v != "nan"
        )
        parts.append(
            f"<Placemark><name>{k + 1}</name><ExtendedData>{data}</ExtendedData><Point>"
            f"<altitudeMode>{mode}</altitudeMode><coordinates>{place}</coordinates></Point></Placemark>"
        )
    parts += ["</Folder>", "</Document>", "</kml>"]
    path.write_text("\n".join(parts) + "\n", encoding="utf-8", newline="\n")


def read(path: Path) -> Route:
    """The way points of a file that was written here; one of another program holds no triggers and is refused."""
    document = read_xml(path, "kml").get("Document")
    folder = document.find("Folder")
    if folder is None:
        raise InputError("mission.no_folder", file=path)
    rows = [_row(p) for p in folder.all("Placemark")]
    if not rows:
        raise InputError("mission.no_way_point", file=path)
    t = np.array(rows)
    home = next((p for p in document.all("Placemark") if _text(p, "name") == "take-off"), None)
    place = t[0, [1, 0, 2]] if home is None else _place(home)
    return Route(
        name=_text(document, "name"), home=(float(place[1]), float(place[0]), float(place[2])), latitude_deg=t[:, 1],
        longitude_deg=t[:, 0], height=t[:, 3], heading_deg=t[:, 4], pitch_deg=t[:, 5], speed=t[:, 6],
        trigger=np.nan_to_num(t[:, 7]).astype(int), base=t[:, 8],
    )  # fmt: skip


def _text(element: Element, name: str) -> str:
    child = element.find(name)
    return "" if child is None else child.content.strip()


def _place(placemark: Element) -> Array:
    point = placemark.get("Point", "coordinates")
    words = point.content.strip().split(",")
    values = [number_of(w) for w in words]
    if len(values) != 3 or None in values:
        point.fail("area.no_position", text=quoted(point.content.strip()))
    return np.array(values, float)


def _row(placemark: Element) -> list[float]:
    data: dict[str, float] = {}
    for entry in placemark.get("ExtendedData").all("Data"):
        text = _text(entry, "value")
        value = number_of(text)
        if value is None:
            entry.fail(no_number(text))
        data[entry.attribute("name")] = value
    if "height" not in data:
        placemark.fail("mission.no_height")
    return [*_place(placemark).tolist(), *(data.get(n, float("nan")) for n in DATA)]


register(MissionFormat(name="kml", about="KML for maps, .kml", suffix=".kml", write=write, read=read))
