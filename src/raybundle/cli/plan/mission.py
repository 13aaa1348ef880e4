"""`raybundle plan mission`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import NEW_FOLDER, Command, facts
from raybundle.cli.plan.precision import forecast_lines, left_open
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.planning.mission import MissionSettings, run_plan_mission
from raybundle.errors import Message, note
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.planning.mission import PlannedMission
    from raybundle.missions.report import Spread


@click.command("mission", cls=Command)
@click.argument("area", metavar="AREA")
@options_of(MissionSettings, out=NEW_FOLDER)
def command(area: str, **given: Any) -> None:
    """Plan a flight over AREA for a vehicle: way points, heights, views, photographs.

    AREA is a file with one polygon, line or point (GeoJSON, KML, KMZ; GeoPackage and others by pyogrio), or
    coordinates: "LON LAT, LON LAT, ...".  The folder holds the plan itself (mission.toml), a picture of it, and one
    file for each battery and format. Heights refer to the take-off; no geoid is needed.

    \b
    Example:
      raybundle plan mission field.geojson --vehicle mavic-3e --gsd 0.02 --to wpml,kml --out plan
      raybundle plan mission field.geojson --vehicle mavic-3e --predict --free-lever-arm --out plan
      raybundle plan mission hill.kml --camera IMG_1.JPG --dem dsm.tif --pattern double-grid --tilt 20 --out plan
      raybundle plan mission wall.geojson --vehicle mavic-3e --pattern facade --heights 0 18 --gsd 0.003 --out plan
    """
    done = run_plan_mission(made(MissionSettings, {"area": area, **values_of(MissionSettings, given)}))
    facts(figures=done.facts, files=done.files, forecast=done.forecast)
    report(_summary(done))


def _summary(done: PlannedMission) -> Summary:
    """What the command reports."""
    m, f = done.mission, done.facts
    forecast = [] if done.forecast is None else forecast_lines(done.forecast)
    more: list[Message] = [
        note("flight.camera", camera=m.camera.name, width_px=m.camera.width_px, height_px=m.camera.height_px,
             c_px=m.camera.c_px),
        note("flight.spacing", base_m=m.base, spacing_m=m.spacing),
    ]  # fmt: skip
    if f.interval_s is None:
        more.append(note("flight.standing"))
    else:
        speed = float(m.way_points.speed[m.way_points.base == m.way_points.base].max())
        exposure = round(1 / m.camera.exposure_s)
        more.append(note("flight.motion", speed=speed, interval_s=f.interval_s, blur_px=f.blur_px, exposure=exposure))
    if f.coverage is not None:
        count = sorted(f.coverage.count.tolist())
        more.append(note("flight.coverage", least=int(count[0]), middle=int(count[len(count) // 2])))
    return Summary(
        done=[
            note("flight.mission", photographs=f.photographs, lines=f.lines, way_points=f.way_points,
                 pattern=m.pattern, vehicle=m.vehicle.name),
            note("flight.ground", pixel=_mm(f.gsd), asked=_in_mm(m.gsd), above=_metres(f.above),
                 along=_share(f.along, m.overlap[0]), across=_share(f.across, m.overlap[1])),
            note("flight.batteries", way_km=f.length_m / 1000, n=len(f.minutes), minutes=list(f.minutes),
                 usable=m.vehicle.usable_s / 60, farthest_m=f.farthest_m),
            *forecast[:1],
        ],
        details=[*more, *forecast[1:]], files=done.files,
        notices=[
            *done.warnings,
            *([] if done.forecast is None else left_open(done.forecast)), *of_texts(done.remarks),
        ],
    )  # fmt: skip


def _mm(s: Spread) -> str:
    if s.high - s.low < 0.01 * s.middle:
        return _in_mm(s.middle)
    return f"{_in_mm(s.low)} to {_in_mm(s.high)}"


def _in_mm(metres: float) -> str:
    return f"{1000 * metres:.3g}" if metres < 0.9995 else f"{1000 * metres:.0f}"


def _metres(s: Spread) -> str:
    return f"{s.middle:.1f}" if s.high - s.low < 0.1 else f"{s.low:.1f} to {s.high:.1f}"


def _share(s: Spread | None, asked: float) -> str:
    if s is None or not math.isfinite(s.middle):
        return f"{100 * asked:.0f} % (asked for)"
    if abs(s.low - s.middle) < 0.005:
        return f"{100 * s.middle:.0f} %"
    return f"{100 * s.middle:.0f} % ({100 * s.low:.0f} % at least)"
