"""A mission in a file of its own: TOML, in which nothing is lost."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.trees import Json, read_toml
from raybundle.io.reading.words import quoted
from raybundle.missions.camera import MissionCamera
from raybundle.missions.mission import FlightLine, Mission, Trigger, WayPoints
from raybundle.missions.vehicle import Vehicle
from raybundle.numerics.arrays import Array

NAME = "mission.toml"
COLUMNS = (
    "x", "y", "z", "heading_deg", "pitch_deg", "speed", "trigger", "base", "line", "flight"
)  # fmt: skip
TRIGGERS = ("none", "here", "start", "stop")


def _text(value: object) -> str:
    """A value as TOML writes it; a JSON text, number or list is one."""
    if isinstance(value, Mapping):
        inner = ", ".join(f"{json.dumps(k)} = {_text(v)}" for k, v in cast("Mapping[str, object]", value).items())
        return f"{{ {inner} }}"
    return json.dumps(value, ensure_ascii=False, default=str).replace("\x7f", "\\u007f")


def mission_text(mission: Mission) -> str:
    """The file's text."""
    m, c, v = mission, mission.camera, mission.vehicle
    top: dict[str, object] = {
        "name": m.name, "pattern": m.pattern, "crs": m.crs, "take_off": list(m.take_off), "gsd": m.gsd,
        "overlap": list(m.overlap), "base": m.base, "spacing": m.spacing, "trigger_by": m.trigger_by,
        "terrain": m.terrain, "closed": m.closed, "outline": np.asarray(m.outline).tolist(),
        "no_go": [np.asarray(z).tolist() for z in m.no_go], "remarks": list(m.remarks),
    }  # fmt: skip
    lines = [
        "# A flight plan of raybundle: x, y, z in the coordinate system, angles in degrees, the rest in metres and s."
    ]
    lines += [f"{k} = {_text(value)}" for k, value in top.items()]
    camera: dict[str, object] = {
        "name": c.name, "width_px": c.width_px, "height_px": c.height_px, "c_px": c.c_px, "pixel_mm": c.pixel_mm,
        "exposure_s": c.exposure_s, "interval_s": c.interval_s, "source": c.source,
        **({} if c.read_out_s is None else {"read_out_s": c.read_out_s}),
    }  # fmt: skip
    vehicle: dict[str, object] = {
        "name": v.name, "speed": v.speed, "climb": v.climb, "descent": v.descent, "acceleration": v.acceleration,
        "minutes": v.minutes, "reserve": v.reserve, "source": v.source,
        **({} if v.codes is None else {"codes": list(v.codes)}),
    }  # fmt: skip
    for name, table in (("camera", camera), ("vehicle", vehicle), ("settings", dict(m.settings))):
        lines += ["", f"[{name}]", *(f"{k} = {_text(value)}" for k, value in table.items() if value is not None)]
    for f in m.lines:
        lines += ["", "[[line]]", f"name = {_text(f.name)}", f"group = {_text(f.group)}"]
        lines += [] if f.distance is None else [f"distance = {_text(f.distance)}"]
    lines += ["", "[way_points]", f"columns = {_text(list(COLUMNS))}", "rows = ["]
    lines += [f"  {_row(m.way_points, k)}," for k in range(len(m.way_points))]
    return "\n".join([*lines, "]"]) + "\n"


def _row(w: WayPoints, k: int) -> str:
    base = float(w.base[k])
    numbers = [*w.xyz[k].tolist(), math.degrees(w.heading[k]), math.degrees(w.pitch[k]), float(w.speed[k])]
    ends = [base if math.isfinite(base) else 0.0, int(w.line[k]), int(w.flight[k])]
    cells = [*map(repr, numbers), json.dumps(TRIGGERS[int(w.trigger[k])]), *map(repr, ends)]
    return f"[{', '.join(cells)}]"


def write_mission(mission: Mission, path: Path) -> None:
    """Write a mission."""
    path.write_text(mission_text(mission), encoding="utf-8", newline="\n")


def read_mission(path: Path) -> Mission:
    """The mission in a file, or in a folder that holds mission.toml; raises InputError with file and place."""
    path = path / NAME if path.is_dir() else path
    top = read_toml(path).tree()
    if not top.has("way_points"):
        raise InputError("mission.no_table", file=path)
    camera, vehicle = _camera(top.get("camera")), _vehicle(top.get("vehicle"))
    points = top.get("way_points")
    names = tuple(i.text() for i in points.get("columns").items())
    if names != COLUMNS:
        points.get("columns").fail("mission.columns", needed=list(COLUMNS))
    lines = tuple(_line(j) for j in top.get("line").items()) if top.has("line") else ()
    w = _way_points(points.get("rows"), len(lines))
    x, y, z = top.get("take_off").numbers(3)
    along, across = top.get("overlap").numbers(2)
    by = top.get("trigger_by").text()
    if by not in {"distance", "interval"}:
        top.get("trigger_by").fail("value.not_supported", value=quoted(by), known=["distance", "interval"])
    return Mission(
        name=top.get("name").text(), pattern=top.get("pattern").text(), crs=top.get("crs").text(), camera=camera,
        vehicle=vehicle, take_off=(float(x), float(y), float(z)), way_points=w, lines=lines,
        outline=_ring(top.get("outline")), closed=bool(top.get("closed").value),
        no_go=tuple(_ring(z) for z in top.get("no_go").items()), gsd=top.get("gsd").number(),
        overlap=(float(along), float(across)), base=top.get("base").number(), spacing=top.get("spacing").number(),
        trigger_by="interval" if by == "interval" else "distance", terrain=top.get("terrain").text(),
        settings={k: v.value for k, v in top.get("settings").mapping().items()} if top.has("settings") else {},
        remarks=tuple(i.text() for i in top.get("remarks").items()),
    )  # fmt: skip


def _ring(value: Json) -> Array:
    rows = [i.numbers(2) for i in value.items()]
    return np.array(rows).reshape(-1, 2)


def _camera(j: Json) -> MissionCamera:
    return MissionCamera(
        name=j.get("name").text(), width_px=j.get("width_px").whole(), height_px=j.get("height_px").whole(),
        c_px=j.get("c_px").number(), pixel_mm=j.get("pixel_mm").number(), exposure_s=j.get("exposure_s").number(),
        interval_s=j.get("interval_s").number(), source=j.get("source").text(),
        read_out_s=j.get("read_out_s").number() if j.has("read_out_s") else None,
    )  # fmt: skip


def _vehicle(j: Json) -> Vehicle:
    codes: Any = tuple(int(v) for v in j.get("codes").numbers(3)) if j.has("codes") else None
    return Vehicle(
        name=j.get("name").text(), speed=j.get("speed").number(), climb=j.get("climb").number(),
        descent=j.get("descent").number(), acceleration=j.get("acceleration").number(),
        minutes=j.get("minutes").number(), reserve=j.get("reserve").number(), source=j.get("source").text(),
        codes=codes,
    )  # fmt: skip


def _line(j: Json) -> FlightLine:
    return FlightLine(
        name=j.get("name").text(), group=j.get("group").text(),
        distance=j.get("distance").number() if j.has("distance") else None,
    )  # fmt: skip


def _way_points(rows: Json, lines: int) -> WayPoints:
    table: list[list[float]] = []
    for row in rows.items():
        cells = row.items()
        if len(cells) != len(COLUMNS):
            row.fail("value.count", n=len(cells), needed=len(COLUMNS))
        word = cells[6].text()
        if word not in TRIGGERS:
            cells[6].fail("value.not_supported", value=quoted(word), known=list(TRIGGERS))
        numbers = [c.number() for c in (*cells[:6], *cells[7:])]
        if not -1 <= numbers[7] < max(lines, 1):
            cells[8].fail("mission.line_unknown", line_number=int(numbers[7]), n=lines)
        table.append([*numbers[:6], float(TRIGGERS.index(word)), *numbers[6:]])
    if not table:
        rows.fail("mission.no_way_point")
    t = np.array(table)
    start = t[:, 6] == Trigger.START
    return WayPoints(
        xyz=t[:, :3], heading=np.radians(t[:, 3]), pitch=np.radians(t[:, 4]), speed=t[:, 5],
        trigger=t[:, 6].astype(int), base=np.where(start, t[:, 7], np.nan), line=t[:, 8].astype(int),
        flight=t[:, 9].astype(int),
    )  # fmt: skip
