"""`raybundle plan mission`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import NEW_FOLDER, Command, counted, facts
from raybundle.cli.plan.precision import forecast_lines
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line, remark_lines
from raybundle.commands.planning.mission import MissionSettings, run_plan_mission
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
    """  # noqa: D301
    done = run_plan_mission(made(MissionSettings, {"area": area, **values_of(MissionSettings, given)}))
    facts(figures=done.facts, files=done.files, forecast=done.forecast)
    click.echo("\n".join(lines(done)))


def lines(done: PlannedMission) -> list[str]:
    """What is reported of a plan."""
    m, f = done.mission, done.facts
    flown = (
        f"{counted(f.photographs, 'photograph')} on {counted(f.lines, 'line')}, {counted(f.way_points, 'way point')}"
    )
    camera = f"{m.camera.name} ({m.camera.width_px} x {m.camera.height_px} px, c = {m.camera.c_px:.0f} px)"
    along, across = _share(f.along, m.overlap[0]), _share(f.across, m.overlap[1])
    text = [
        f" {m.pattern}: {flown}; {m.vehicle.name}, {camera}",
        f" a pixel is {_mm(f.gsd)} mm ({_in_mm(m.gsd)} asked for); {_metres(f.above)} m above the ground",
        f" base {m.base:.2f} m, lines {m.spacing:.2f} m apart; overlap {along} along, {across} across",
    ]
    on_lines = m.way_points.speed[m.way_points.base == m.way_points.base]
    motion = "photographs are taken standing"
    if f.interval_s is not None:
        speed = float(on_lines.max())
        motion = (
            f"{speed:.1f} m/s, a photograph every {f.interval_s:.2f} s or more; motion blur {f.blur_px:.2f} px at "
            f"1/{1 / m.camera.exposure_s:.0f} s"
        )
    text.append(f" {motion}")
    minutes = ", ".join(f"{v:.1f}" for v in f.minutes)
    count = len(f.minutes)
    flights = f"one battery, {minutes} min" if count == 1 else f"{count} batteries, {minutes} min"
    text.append(
        f" {f.length_m / 1000:.2f} km of way, {flights} ({m.vehicle.usable_s / 60:.1f} of {m.vehicle.minutes:g} may be "
        f"used); farthest {f.farthest_m:.0f} m from the take-off"
    )
    if f.coverage is not None:
        count = sorted(f.coverage.count.tolist())
        least = counted(count[0], "photograph")
        text.append(f" a place of the area is seen by {least} or more, in the middle by {count[len(count) // 2]}")
    if done.forecast is not None:
        text += forecast_lines(done.forecast)
    text += [f" {one}" for r in done.remarks for one in remark_lines(r)]
    text += [f" {notice_line(w)}" for w in done.warnings]
    text.append(f" written: {done.files[0].parent}: {', '.join(p.name for p in done.files)}")
    return text


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
