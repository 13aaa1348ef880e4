"""QGroundControl's .plan: JSON (docs.qgroundcontrol.com, developer guide, "Plan File Format", version 1)."""

from __future__ import annotations

import json
import math
from pathlib import Path

from raybundle.io.missions.base import MissionFormat, register
from raybundle.io.missions.mavlink import RELATIVE, Item, items_of, route_of
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import quoted
from raybundle.missions.route import Route

PX4, MULTIROTOR = 12, 2
"""MAV_AUTOPILOT and MAV_TYPE."""


def write(route: Route, path: Path) -> None:
    """One plan."""
    items = [_item(item, k + 1) for k, item in enumerate(items_of(route))]
    speed = float(route.speed.max())
    mission = {
        "cruiseSpeed": speed, "firmwareType": PX4, "globalPlanAltitudeMode": 1, "hoverSpeed": speed, "items": items,
        "plannedHomePosition": list(route.home), "vehicleType": MULTIROTOR, "version": 2,
    }  # fmt: skip
    plan = {
        "fileType": "Plan", "geoFence": {"circles": [], "polygons": [], "version": 2},
        "groundStation": "QGroundControl", "mission": mission, "rallyPoints": {"points": [], "version": 2},
        "version": 1,
    }  # fmt: skip
    path.write_text(json.dumps(plan, indent=1) + "\n", encoding="utf-8", newline="\n")


def _item(item: Item, number: int) -> dict[str, object]:
    placed = {"AMSLAltAboveTerrain": None, "Altitude": item.parameters[6], "AltitudeMode": 1}
    return {
        **(placed if item.frame == RELATIVE else {}), "autoContinue": True, "command": item.command,
        "doJumpId": number, "frame": item.frame, "params": list(item.parameters), "type": "SimpleItem",
    }  # fmt: skip


def read(path: Path) -> Route:
    """The way points of a plan of simple items; a survey of QGroundControl's own is refused with the reason."""
    top = read_json(path)
    if not top.has("fileType") or top.get("fileType").text() != "Plan":
        top.fail("qgc.no_plan")
    mission = top.get("mission")
    items = [_read(j) for j in mission.get("items").items()]
    lat, lon, height = mission.get("plannedHomePosition").numbers(3)
    return route_of(items, (float(lat), float(lon), float(height)), path.stem, str(path))


def _read(item: Json) -> Item:
    kind = item.get("type").text()
    if kind != "SimpleItem":
        item.fail("qgc.complex_item", kind=quoted(kind))
    parameters = item.get("params").items()
    if len(parameters) != 7:
        item.fail("value.count", n=len(parameters), needed=7)
    values = tuple(math.nan if p.value is None else p.number() for p in parameters)
    return Item(command=item.get("command").whole(0, 65535), frame=item.get("frame").whole(0, 30), parameters=values)


register(MissionFormat(name="qgc", about="QGroundControl, .plan", suffix=".plan", write=write, read=read))
