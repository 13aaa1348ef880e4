"""`raybundle plan mission`: a flight over an area, as way points for a vehicle, with what it will give."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError, Text, phrase, warning
from raybundle.missions.defaults import OVERLAP
from raybundle.settings import ANY, METRES, POSITIVE, Range, keywords, made, setting, settings_of

if TYPE_CHECKING:
    from raybundle.errors import Message
    from raybundle.io.missions.areas import Shape
    from raybundle.missions.camera import MissionCamera
    from raybundle.missions.mission import Mission
    from raybundle.missions.patterns import Wish
    from raybundle.missions.report import MissionFacts
    from raybundle.missions.terrain import Ground
    from raybundle.missions.vehicle import Vehicle
    from raybundle.numerics.arrays import Array
    from raybundle.objects.heights import HeightGrid
    from raybundle.planning.flights.aerial import Precision
    from raybundle.planning.flights.mission import MissionForecast

PatternName = Literal["nadir", "double-grid", "oblique-grid", "corridor", "facade", "orbit"]
SHARE, ANGLE, SECONDS = Range(low=0, high=0.95), Range(low=0, high=89), Range(low=0, high=3600, above=True)
HEIGHTS = Range(low=0, high=1e4)
DEFAULT_GSD = 0.02
IMPLAUSIBLE = 10
"""Times the allowed height beyond which a size of a pixel is refused: a unit is wrong, not a flight a little high."""
SMALLER = ((100, "cm"), (1000, "mm"))


@dataclass(frozen=True, slots=True, kw_only=True)
class MissionSettings:
    """What is to be photographed, how finely, with what; and where the plan goes."""

    area: str
    """a file with an area, line or place (GeoJSON, KML, KMZ, or what OGR reads), or coordinates: "LON LAT, ..." """
    pattern: PatternName = setting("nadir", "Flight pattern.")
    vehicle: str = setting("", "Known vehicle with its camera, e.g. mavic-3e.", metavar="NAME")
    camera: str = setting(
        "", "Photograph of the camera, its calibration (TOML), the name of a known camera, or its format and camera "
        "constant in px.  [default: that of {vehicle}]", metavar="PHOTO|FILE|NAME|WxH,C",
    )  # fmt: skip
    gsd: float | None = setting(
        None, "Side of a pixel on the ground or facade [m].  [default: 0.02, or by {height}]", limits=METRES
    )
    height: float | None = setting(
        None, "Height above ground, or distance from a facade or object [m]. Instead of {gsd}.", limits=METRES
    )
    overlap: tuple[float, float] = setting(
        OVERLAP, "Overlap along a line and between lines.", metavar="ALONG ACROSS", limits=(SHARE, SHARE)
    )
    direction: float | None = setting(
        None, "Azimuth of the lines from grid north [deg].  [default: that of the fewest lines]",
        limits=Range(low=-360, high=360),
    )  # fmt: skip
    margin: float | None = setting(
        None, "Margin around the area [m].  [default: half the spacing of lines]", limits=HEIGHTS
    )
    tilt: float | None = setting(
        None, "Tilt of the view from the nadir [deg].  [default: 0, of oblique views 35]", limits=ANGLE
    )
    directions: int = setting(4, "Number of oblique views of an oblique grid.", limits=Range(low=1, high=8))
    heights: tuple[float, float] | None = setting(
        None,
        "Lower and upper end of a facade or object above ground [m].",
        metavar="LOW TOP",
        limits=(HEIGHTS, HEIGHTS),
    )
    rings: int = setting(1, "Number of rings of an orbit with {tilt}.", limits=Range(low=1, high=10))
    width: float = setting(0.0, "Width of a corridor [m].", limits=HEIGHTS)
    side: Literal["left", "right"] = setting("right", "Side of a facade's line for the flight, seen along the line.")
    dem: Path | None = setting(None, "Raster of ground heights to follow.", metavar="FILE")
    dem_unit: Literal["", "m", "ft", "us-ft"] = setting(
        "", "Unit of its heights, if the raster defines none.", unstated=True
    )
    dem_band: int = setting(1, "Band of the raster.", limits=Range(low=1, high=1000))
    follow: float = setting(1.0, "Tolerance of heights above ground [m].", limits=METRES)
    crs: str = setting(
        "", "Coordinate system of typed coordinates, or of a file that defines none.  [default: longitude, latitude]",
        metavar="EPSG:CODE",
    )  # fmt: skip
    take_off: tuple[float, float] | None = setting(
        None, "Take-off place, in the coordinates of the area.  [default: below the first photograph]",
        metavar="X Y", limits=(ANY, ANY),
    )  # fmt: skip
    no_go: tuple[Path, ...] = setting((), "Files with no-fly areas.", metavar="FILE")
    speed: float | None = setting(
        None,
        "Speed on the lines [m/s].  [default: as vehicle, camera and {blur} allow]",
        limits=Range(low=0, high=100, above=True),
    )
    blur: float = setting(1.0, "Largest motion during the exposure [px].", limits=POSITIVE)
    exposure: float | None = setting(None, "Exposure time [s].  [default: 1/800, or the photograph's]", limits=SECONDS)
    interval: float | None = setting(
        None, "Shortest time between photographs [s].  [default: the camera's, or 1]", limits=SECONDS
    )
    climb: float | None = setting(
        None, "Largest rate of climb [m/s].  [default: the vehicle's]", limits=Range(low=0, high=50, above=True)
    )
    battery: float | None = setting(
        None,
        "Flight time of one battery [min].  [default: the vehicle's]",
        limits=Range(low=0, high=1440, above=True),
    )
    reserve: float = setting(0.25, "Battery share in reserve.", limits=Range(low=0, high=0.9))
    height_limit: float = setting(120.0, "Largest height above ground [m]; EU 2019/947, open category.", limits=METRES)
    sight: float = setting(500.0, "Largest distance of visual line of sight [m].", limits=METRES)
    trigger: Literal["distance", "interval"] = setting("distance", "Camera trigger on a line.")
    to: tuple[str, ...] = setting(
        ("kml",),
        "Output formats of the plan: qgc, wpl, wpml, litchi, kml.",
        metavar="A,B,...",
        joined=True,
        typed="kml",
    )
    predict: bool = setting(False, "Predict precision without control, and list undetermined quantities.")
    rtk: tuple[float, float, float] = setting(
        (0.02, 0.02, 0.03), "Standard deviations of positions, for {predict} [m].", metavar="E N U",
        limits=(METRES, METRES, METRES),
    )  # fmt: skip
    free_lever_arm: bool = setting(False, "Estimate the lever arm of the antenna, for {predict}.")
    image_sigma: float = setting(0.3, "Sigma of an image coordinate, for {predict} [px].", limits=POSITIVE)
    name: str = setting("mission", "Name of the mission and of its files.")
    out: Path = setting(MISSING, "New folder for the plan.", metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedMission:
    """A mission with its figures, what speaks against it, and its files."""

    mission: Mission
    facts: MissionFacts
    warnings: tuple[Message, ...]
    files: tuple[Path, ...]
    remarks: tuple[str, ...]
    forecast: MissionForecast | None = None
    """What it will determine, where that was asked for"""


@keywords(MissionSettings)
def plan_mission(area: str | Path, out: str | Path, **settings: Any) -> PlannedMission:
    """Plan a flight and write it: mission.toml, a picture, and a file for each battery and format.

    area      a file with an area, line or place, or coordinates: "7.1 50.1, 7.2 50.1, 7.2 50.2"
    out       new folder
    settings  as of the command line, by the names of `MissionSettings`: vehicle="mavic-3e", gsd=0.02, dem="dsm.tif"
    raises    InputError for what cannot be flown as asked for
    """
    return run_plan_mission(made(MissionSettings, {"area": str(area), "out": Path(out), **settings}))


def run_plan_mission(settings: MissionSettings) -> PlannedMission:
    """Plan the mission that the settings ask for, and write it."""
    from raybundle.io.folders import check_new_folder
    from raybundle.io.missions import mission_formats, routes_of
    from raybundle.missions.build import plan_mission as build
    from raybundle.missions.report import mission_facts, warnings

    s = settings
    unknown = [f for f in s.to if f not in mission_formats]
    if unknown:
        raise InputError("format.unknown", format=unknown[0], known=list(mission_formats))
    if not re.fullmatch(r"[\w][\w .-]{0,60}", s.name):
        from raybundle.io.reading.words import quoted

        raise InputError("mission.name", name=quoted(s.name[:60]))
    check_new_folder(s.out)
    task, lenient, remarks = _task(s)
    mission = build(task)
    mission = replace(mission, remarks=(*remarks, *mission.remarks))
    facts = mission_facts(mission, lenient)
    found = warnings(mission, facts, limit_m=s.height_limit, sight_m=s.sight)
    routes = routes_of(mission, lenient if s.dem is not None else None)
    forecast = _forecast(s, mission, lenient) if s.predict else None
    files, line = _write(s, mission, facts, routes, forecast)
    return PlannedMission(
        mission=mission, facts=facts, warnings=found, files=files, remarks=(*mission.remarks, *line), forecast=forecast
    )


def _forecast(s: MissionSettings, mission: Mission, ground: Ground) -> MissionForecast:
    from raybundle.planning.flights.mission import Asked, mission_forecast

    asked = Asked(station_sigma=s.rtk, lever_arm=s.free_lever_arm, image_sigma_px=s.image_sigma)
    return mission_forecast(mission, ground, asked)


def _figures(f: MissionForecast) -> dict[str, object]:
    """What is written of a forecast; None where something is not determinable."""

    def of(p: Precision) -> dict[str, object]:
        mm = {
            "plan_mm": p.plan_m, "plan_worst_mm": p.plan_worst_m, "height_mm": float(p.sigma_m[2]),
            "height_worst_mm": p.height_worst_m,
        }  # fmt: skip
        c = None if "c" in p.lost else p.std["c"] / f.pixel_mm
        figures = {k: round(1000 * v, 2) if math.isfinite(v) else None for k, v in mm.items()}
        return {**figures, "c_px": c and round(c, 3), "not_determinable": list(p.lost)}

    return {
        "photographs": f.photographs, "computed_with": f.rtk.photographs, "points": f.rtk.points, "rtk": of(f.rtk),
        "without_rtk": None if f.without_rtk is None else of(f.without_rtk),
        "not_determinable_as_planned": list(f.lost_even),
        "what_determines_it": [{"change": m.kind, "control_points": m.control} for m in f.mends],
    }  # fmt: skip


def _task(s: MissionSettings) -> tuple[Any, Ground, tuple[str, ...]]:
    """What is to be flown, the ground as far as it is known, and remarks on how it was read."""
    import numpy as np

    from raybundle.io.missions.areas import in_crs, plane_crs, read_shapes
    from raybundle.missions.build import Task
    from raybundle.missions.patterns import patterns
    from raybundle.missions.terrain import ground_of, level_ground

    vehicle, camera = _vehicle(s), _camera(s)
    shape = _shape(read_shapes(s.area, s.crs), patterns[s.pattern].shape, s)
    crs = plane_crs(shape)
    outline = in_crs(shape.xy, shape.crs, crs)
    home = None if s.take_off is None else in_crs(np.array([s.take_off]), shape.crs, crs)[0]
    zones = tuple(
        in_crs(z.xy, z.crs, crs) for path in s.no_go for z in read_shapes(str(path), s.crs) if z.kind == "area"
    )
    wish = _wish(s, camera)
    ground = lenient = level_ground(0.0)
    remarks: tuple[str, ...] = ()
    if shape.holes:
        remarks += (phrase("mission.holes_flown_over"),)
    step, terrain = 5.0, ""
    if s.dem is not None:
        grid = _heights(s, crs, outline, home, wish)
        ground, lenient = ground_of(grid), grid.at
        remarks += (*grid.remarks, *_holes(grid, outline, shape.kind))
        step, terrain = max(1.0, min(grid.cell_m, 10.0)), s.dem.name
    task = Task(
        name=s.name, pattern=s.pattern, outline=outline, crs=crs, wish=wish, vehicle=vehicle, speed=s.speed,
        blur_px=s.blur, take_off=None if home is None else (float(home[0]), float(home[1])), no_go=zones, ground=ground,
        terrain=terrain, ground_step=step,
        tolerance=s.follow, trigger_by=s.trigger, settings=_settings(s),
    )  # fmt: skip
    return task, lenient, remarks


def _settings(s: MissionSettings) -> Mapping[str, object]:
    """The settings as numbers and texts; files by their names alone."""
    values: dict[str, object] = {"area": Path(s.area).name if Path(s.area).exists() else s.area}
    for field in settings_of(MissionSettings):
        value = getattr(s, field.name)
        if field.name == "out" or value is None or value == ():
            continue
        if field.name == "no_go":
            value = [p.name for p in s.no_go]
        values[field.name] = (
            value.name if isinstance(value, Path) else list(value) if isinstance(value, tuple) else value
        )
    return values


def _camera(s: MissionSettings) -> MissionCamera:
    from raybundle.io.missions.cameras import mission_camera

    camera = mission_camera(s.camera, s.vehicle)
    given = {k: v for k, v in (("exposure_s", s.exposure), ("interval_s", s.interval)) if v is not None}
    return replace(camera, **given)


def _vehicle(s: MissionSettings) -> Vehicle:
    from raybundle.io.missions.cameras import vehicle_of

    vehicle = vehicle_of(s.vehicle)
    given = {k: v for k, v in (("climb", s.climb), ("minutes", s.battery)) if v is not None}
    fastest = max(vehicle.speed, s.speed or 0.0) if not s.vehicle else vehicle.speed
    return replace(vehicle, reserve=s.reserve, speed=fastest, **given)


def _wish(s: MissionSettings, camera: MissionCamera) -> Wish:
    from raybundle.missions.patterns import Wish, patterns

    if s.gsd is not None and s.height is not None:
        raise InputError("option.exclusive", first="gsd", second="height")
    tilt = None if s.tilt is None else math.radians(s.tilt)
    distance = camera.distance(s.gsd or DEFAULT_GSD) if s.height is None else s.height
    if s.gsd is not None and distance > IMPLAUSIBLE * s.height_limit:
        unit = next((unit for factor, unit in SMALLER if camera.distance(s.gsd / factor) <= s.height_limit), "")
        raise InputError(
            "mission.gsd_too_large",
            gsd_m=s.gsd,
            distance_m=distance,
            limit_m=IMPLAUSIBLE * s.height_limit,
            times=IMPLAUSIBLE,
            unit=unit,
        )
    if s.height is not None and patterns[s.pattern].ground and s.pattern != "oblique-grid" and tilt:
        distance = s.height / math.cos(tilt)
    return Wish(
        camera=camera, distance=distance, overlap=s.overlap,
        direction=None if s.direction is None else math.radians(s.direction), margin=s.margin, tilt=tilt,
        directions=s.directions, heights=s.heights, rings=s.rings, width=s.width, side=s.side,
    )  # fmt: skip


def _shape(shapes: tuple[Shape, ...], wanted: str, s: MissionSettings) -> Shape:
    """The one shape that the pattern can be flown over."""
    shapes = tuple(replace(f, kind="line") if f.typed and wanted == "line" and len(f.xy) > 1 else f for f in shapes)
    fitting = [f for f in shapes if f.kind == wanted or (wanted == "place" and f.kind == "area")]
    if not fitting:
        raise InputError("mission.shape", pattern=s.pattern, area=str(s.area), wanted=wanted, kind=shapes[0].kind)
    if len(fitting) > 1:
        raise InputError("mission.several_outlines", area=str(s.area), n=len(fitting))
    return fitting[0]


def _heights(s: MissionSettings, crs: str, outline: Array, home: Array | None, wish: Wish) -> HeightGrid:
    """Heights below everything that is flown over and seen."""
    import numpy as np

    from raybundle.io.geo.rasters import read_heights
    from raybundle.missions.build import checked_outline
    from raybundle.missions.patterns import patterns

    assert s.dem is not None
    pattern = patterns[s.pattern]
    lines = pattern.lines(checked_outline(outline, pattern.shape), wish)
    places = [outline, *(line.xy for line in lines)] + ([] if home is None else [home[None]])
    every = np.concatenate(places)
    margin = max(wish.camera.footprint(wish.distance))
    box = np.array([every.min(axis=0) - margin, every.max(axis=0) + margin])
    return read_heights(s.dem, crs, box, unit=s.dem_unit, band=s.dem_band)


def _holes(grid: HeightGrid, outline: Array, kind: str) -> tuple[str, ...]:
    """Which holes of the heights lie within an area."""
    from raybundle.missions.polygons import inside

    if kind != "area":
        return ()
    centres = grid.centres()
    wanted = inside(outline, centres.reshape(-1, 2)).reshape(grid.heights.shape)
    holes = grid.holes(wanted)
    if not holes:
        return ()
    h = holes[0]
    share = sum(hole.cells for hole in holes) / max(int(wanted.sum()), 1)
    return (
        phrase(
            "mission.ground_holes", n=len(holes), share=share, width_m=h.size_m[0], length_m=h.size_m[1], x=h.xy[0],
            y=h.xy[1],
        ),
    )  # fmt: skip


def _write(
    s: MissionSettings, mission: Mission, facts: MissionFacts, routes: Any, forecast: MissionForecast | None
) -> tuple[tuple[Path, ...], tuple[str, ...]]:
    """The folder of the plan, whole or not at all; its files, and what formats do not take."""
    from raybundle.io.folders import new_folder
    from raybundle.io.missions import mission_formats
    from raybundle.io.missions.mission_file import NAME, write_mission
    from raybundle.report.figures.mission import plan_view

    line: list[str] = []
    names = [NAME, "mission.svg"]
    with new_folder(s.out) as folder:
        write_mission(mission, folder / NAME)
        (folder / "mission.svg").write_text(plan_view(mission, facts.coverage), encoding="utf-8", newline="\n")
        if forecast is not None:
            names.append("precision.json")
            text = json.dumps(_figures(forecast), indent=1) + "\n"
            (folder / names[-1]).write_text(text, encoding="utf-8", newline="\n")
        for chosen in dict.fromkeys(s.to):
            entry = mission_formats[chosen]
            for k, route in enumerate(routes):
                number = f"-{k + 1}" if len(routes) > 1 else ""
                names.append(f"{s.name}{number}{entry.suffix}")
                entry.write(route, folder / names[-1])
                if entry.most is not None and len(route) > entry.most:
                    program = entry.about.split(",")[0]
                    line.append(
                        Text.of(
                            warning(
                                "mission.too_many_way_points",
                                name=names[-1],
                                n=len(route),
                                program=program,
                                most=entry.most,
                            )
                        )
                    )
    return tuple(s.out / n for n in names), tuple(line)
