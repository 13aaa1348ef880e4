"""DJI's WPML 1.0.2 in a KMZ: wpmz/template.kml and wpmz/waylines.wpml.

Source: developer.dji.com, Cloud API, "DJI WPML" (github.com/dji-sdk/Cloud-API-Doc, 60.api-reference/00.dji-wpml).
Heights above the take-off (executeHeightMode relativeToStartPoint); headings in whole degrees, -180 to 180 from true
north (smoothTransition); pitch of the gimbal 0 to the horizon, -90 to the nadir, set by an action where it changes;
photographs by an action group over the way points of a line (multipleDistance in metres, multipleTiming in seconds),
or at one way point (reachPoint).
"""

from __future__ import annotations

import math
import zipfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.missions.base import MissionFormat, register
from raybundle.io.reading.files import UNPACKING, check_regular, guarded
from raybundle.io.reading.words import no_number, number_of, quoted
from raybundle.io.reading.xml import Element, xml_of
from raybundle.missions.mission import Trigger
from raybundle.missions.route import Route
from raybundle.numerics.arrays import Array

TEMPLATE, WAYLINES = "wpmz/template.kml", "wpmz/waylines.wpml"
NAMES = 'xmlns="http://www.opengis.net/kml/2.2" xmlns:wpml="http://www.dji.com/wpmz/1.0.2"'
LARGEST = 1 << 26
"""Bytes of a member of the archive; a way point takes some 2 kB."""
CODES = (77, 0, 66)
"""Mavic 3E: what is written where nothing is known of the vehicle; the app that flies asks for another."""
DAMPING_M = 0.2
"""Before a way point that is flown through, at which the vehicle begins to turn."""
FASTEST = 15.0
"""Of the transitional speed [m/s]."""
SUFFIX = "plan"
"""Which the vehicle appends to the names of photographs."""
SAFE_M = 20.0
"""Height to which a vehicle climbs before it flies off (2 to 1500 m)."""


def write(route: Route, path: Path) -> None:
    """One archive; its entries have no date, so that equal plans are equal files."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in ((TEMPLATE, _template(route)), (WAYLINES, _waylines(route))):
            entry = zipfile.ZipInfo(name)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text)


def _document(body: str) -> str:
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<kml {NAMES}>\n<Document>\n{body}\n</Document>\n</kml>\n'


def _tags(**values: object) -> str:
    return "".join(f"<wpml:{name}>{value}</wpml:{name}>" for name, value in values.items())


def _config(route: Route) -> str:
    drone, variant, payload = route.codes or CODES
    vehicle = _tags(droneEnumValue=drone, droneSubEnumValue=variant)
    camera = _tags(payloadEnumValue=payload, payloadSubEnumValue=0, payloadPositionIndex=0)
    config = _tags(
        flyToWaylineMode="safely", finishAction="goHome", exitOnRCLost="executeLostAction",
        executeRCLostAction="goBack",
        takeOffSecurityHeight=f"{SAFE_M:g}", takeOffRefPoint=",".join(f"{v:.10f}" for v in route.home),
        globalTransitionalSpeed=f"{min(float(route.speed.max()), FASTEST):.9f}",
        globalRTHHeight=f"{max(float(route.height.max()), SAFE_M):.9f}", droneInfo=vehicle, payloadInfo=camera,
    )  # fmt: skip
    return f"<wpml:missionConfig>{config}</wpml:missionConfig>"


def _template(route: Route) -> str:
    """What an app shows: the same way points, without their actions."""
    system = _tags(coordinateMode="WGS84", heightMode="relativeToStartPoint")
    head = _tags(
        templateType="waypoint", templateId=0, waylineCoordinateSysParam=system,
        autoFlightSpeed=f"{_usual_speed(route):.9f}", globalHeight=f"{float(route.height.max()):.9f}",
        gimbalPitchMode="usePointSetting", globalWaypointTurnMode="toPointAndStopWithDiscontinuityCurvature",
        globalUseStraightLine=1,
    )  # fmt: skip
    marks = [
        f"<Placemark>{_point(route, k)}"
        + _tags(
            index=k,
            ellipsoidHeight=f"{route.height[k]:.9f}",
            height=f"{route.height[k]:.9f}",
            waypointSpeed=f"{route.speed[k]:.9f}",
            useGlobalHeight=0,
            useGlobalSpeed=0,
            useGlobalHeadingParam=0,
            useGlobalTurnParam=0,
            waypointHeadingParam=_heading(route, k),
            waypointTurnParam=_turn(route, k),
            useStraightLine=1,
            gimbalPitchAngle=f"{route.pitch_deg[k]:.9f}",
        )
        + "</Placemark>"
        for k in range(len(route))
    ]
    return _document(_config(route) + "\n<Folder>" + head + "\n" + "\n".join(marks) + "\n</Folder>")


def _usual_speed(route: Route) -> float:
    on_lines = route.speed[route.trigger == Trigger.START]
    return float(on_lines[0]) if len(on_lines) else float(route.speed.min())


def _point(route: Route, k: int) -> str:
    at = f"{route.longitude_deg[k]:.10f},{route.latitude_deg[k]:.10f}"
    return f"<Point><coordinates>{at}</coordinates></Point>"


def _heading(route: Route, k: int) -> str:
    angle = (route.heading_deg[k] + 180.0) % 360.0 - 180.0
    return _tags(
        waypointHeadingMode="smoothTransition", waypointHeadingAngle=round(angle), waypointPoiPoint="0,0,0",
        waypointHeadingAngleEnable=1, waypointHeadingPathMode="followBadArc",
    )  # fmt: skip


def _turn(route: Route, k: int) -> str:
    through = 0 < k < len(route) - 1 and route.trigger[k] == Trigger.NONE
    mode = "toPointAndPassWithContinuityCurvature" if through else "toPointAndStopWithDiscontinuityCurvature"
    return _tags(waypointTurnMode=mode, waypointTurnDampingDist=DAMPING_M if through else 0)


def _waylines(route: Route) -> str:
    length = sum(
        math.hypot(float(np.radians(b - a)) * 6.371e6, float(np.radians(d - c) * np.cos(np.radians(a))) * 6.371e6)
        for a, b, c, d in zip(
            route.latitude_deg[:-1], route.latitude_deg[1:], route.longitude_deg[:-1], route.longitude_deg[1:],
            strict=True,
        )
    )  # fmt: skip
    speed = _usual_speed(route)
    head = _tags(
        templateId=0, executeHeightMode="relativeToStartPoint", waylineId=0, distance=f"{length:.3f}",
        duration=f"{length / speed:.3f}", autoFlightSpeed=f"{speed:.9f}",
    )  # fmt: skip
    groups = _groups(route)
    marks = [
        f"<Placemark>{_point(route, k)}"
        + _tags(
            index=k,
            executeHeight=f"{route.height[k]:.9f}",
            waypointSpeed=f"{route.speed[k]:.9f}",
            waypointHeadingParam=_heading(route, k),
            waypointTurnParam=_turn(route, k),
            useStraightLine=1,
        )
        + "".join(groups.get(k, ()))
        + "</Placemark>"
        for k in range(len(route))
    ]
    return _document(_config(route) + "\n<Folder>" + head + "\n" + "\n".join(marks) + "\n</Folder>")


def _groups(route: Route) -> dict[int, list[str]]:
    """Action groups by the way point at which they begin: what is done there, and photographs up to the line's end."""
    found: dict[int, list[str]] = {}
    number = 0
    photo = "takePhoto", _tags(payloadPositionIndex=0, fileSuffix=SUFFIX, useGlobalPayloadLensIndex=1)

    def add(first: int, last: int, trigger: str, actions: list[tuple[str, str]]) -> None:
        nonlocal number
        inner = "".join(
            _tags(action=_tags(actionId=k, actionActuatorFunc=function, actionActuatorFuncParam=values))
            for k, (function, values) in enumerate(actions)
        )
        head = _tags(
            actionGroupId=number, actionGroupStartIndex=first, actionGroupEndIndex=last, actionGroupMode="sequence",
            actionTrigger=trigger,
        )  # fmt: skip
        found.setdefault(first, []).append(_tags(actionGroup=head + inner))
        number += 1

    pitch = math.nan
    for k in range(len(route)):
        here: list[tuple[str, str]] = []
        if route.pitch_deg[k] != pitch:
            pitch = float(route.pitch_deg[k])
            here.append(("gimbalRotate", _gimbal(pitch)))
        if route.trigger[k] == Trigger.HERE:
            here.append(photo)
        if here:
            add(k, k, _tags(actionTriggerType="reachPoint"), here)
        if route.trigger[k] == Trigger.START:
            last = k + 1 + int(np.argmax(route.trigger[k + 1 :] == Trigger.STOP))
            by_time = route.trigger_by == "interval"
            step = float(route.base[k]) / float(route.speed[k]) if by_time else float(route.base[k])
            kind = "multipleTiming" if by_time else "multipleDistance"
            add(k, last, _tags(actionTriggerType=kind, actionTriggerParam=f"{step:.9f}"), [photo])
    return found


def _gimbal(pitch: float) -> str:
    return _tags(
        gimbalHeadingYawBase="north", gimbalRotateMode="absoluteAngle", gimbalPitchRotateEnable=1,
        gimbalPitchRotateAngle=f"{pitch:.9f}", gimbalRollRotateEnable=0, gimbalRollRotateAngle=0,
        gimbalYawRotateEnable=0, gimbalYawRotateAngle=0, gimbalRotateTimeEnable=0, gimbalRotateTime=0,
        payloadPositionIndex=0,
    )  # fmt: skip


def read(path: Path) -> Route:
    """The way points of the first wayline of an archive."""
    document = xml_of(_member(path), path, "kml").get("Document")
    folder = document.get("Folder")
    mode = _text(folder, "wpml:executeHeightMode")
    if mode != "relativeToStartPoint":
        folder.fail("mission.height_reference", reference=quoted(mode), needed="relativeToStartPoint")
    rows: list[list[float]] = []
    by_time = False
    pitch, ends = math.nan, set[int]()
    for mark in folder.all("Placemark"):
        row, pitch, last, timed = _row(mark, pitch)
        by_time |= timed
        if last is not None:
            ends.add(last)
        rows.append(row)
    if not rows:
        raise InputError("mission.no_way_point", file=path)
    t = np.array(rows)
    for k in ends:
        if not 0 <= k < len(t):
            raise InputError("wpml.action_end", way_point=k, n=len(t), file=path)
        t[k, 6] = Trigger.STOP
    return Route(
        name=path.stem, home=_home(document, t), latitude_deg=t[:, 0], longitude_deg=t[:, 1], height=t[:, 2],
        heading_deg=t[:, 3], pitch_deg=t[:, 4], speed=t[:, 5], trigger=t[:, 6].astype(int), base=t[:, 7],
        trigger_by="interval" if by_time else "distance",
    )  # fmt: skip


def _member(path: Path) -> bytes:
    check_regular(path)
    try:
        with guarded(path), zipfile.ZipFile(path) as archive:
            entry = archive.getinfo(WAYLINES)
            if entry.file_size > LARGEST:
                raise InputError(
                    "archive.file_too_large", name=WAYLINES, size_bytes=entry.file_size, limit_bytes=LARGEST, file=path
                )
            return archive.read(entry)
    except KeyError:
        raise InputError("archive.file_missing", name=WAYLINES, file=path) from None
    except UNPACKING as error:
        raise InputError("archive.not_unpacked", detail=str(error), file=path) from None


def _text(element: Element, *names: str) -> str:
    child = element.find(*names)
    return "" if child is None else child.content.strip()


def _number(element: Element, *names: str) -> float:
    text = _text(element, *names)
    value = number_of(text)
    if value is None:
        (element.find(*names) or element).fail(no_number(text))
    return value


def _home(document: Element, t: Array) -> tuple[float, float, float]:
    text = _text(document, "wpml:missionConfig", "wpml:takeOffRefPoint")
    values = [number_of(w.strip()) for w in text.split(",")] if text else []
    lat, lon, height = values if len(values) == 3 else (None, None, None)
    if lat is None or lon is None or height is None:
        return float(t[0, 0]), float(t[0, 1]), 0.0
    return lat, lon, height


def _row(mark: Element, pitch: float) -> tuple[list[float], float, int | None, bool]:
    """A way point, the pitch that holds from it on, where photographs that begin there end, whether by time."""
    words = mark.get("Point", "coordinates").content.strip().split(",")
    place = [number_of(w) for w in words[:2]]
    if len(place) != 2 or place[0] is None or place[1] is None:
        mark.fail("area.no_position", text=quoted(",".join(words)))
    speed = _number(mark, "wpml:waypointSpeed")
    trigger, base, last, timed = float(Trigger.NONE), math.nan, None, False
    for group in mark.all("wpml:actionGroup"):
        kind = _text(group, "wpml:actionTrigger", "wpml:actionTriggerType")
        for action in _actions(group):
            function = _text(action, "wpml:actionActuatorFunc")
            if function == "gimbalRotate":
                pitch = _number(action, "wpml:actionActuatorFuncParam", "wpml:gimbalPitchRotateAngle")
            elif function == "takePhoto" and kind in {"multipleDistance", "multipleTiming"}:
                timed = kind == "multipleTiming"
                step = _number(group, "wpml:actionTrigger", "wpml:actionTriggerParam")
                trigger, base = float(Trigger.START), step * speed if timed else step
                last = int(_number(group, "wpml:actionGroupEndIndex"))
            elif function == "takePhoto":
                trigger = float(Trigger.HERE)
    heading = _number(mark, "wpml:waypointHeadingParam", "wpml:waypointHeadingAngle") % 360.0
    height = _number(mark, "wpml:executeHeight")
    return [place[1], place[0], height, heading, pitch, speed, trigger, base], pitch, last, timed


def _actions(group: Element) -> Iterator[Element]:
    return group.all("wpml:action")


register(
    MissionFormat(
        name="wpml",
        about="DJI Pilot 2 and FlightHub, WPML in .kmz",
        suffix=".kmz",
        write=write,
        read=read,
        heading_step_deg=1.0,
    )
)
