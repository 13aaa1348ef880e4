"""`raybundle plan check`: photographs that were flown against their plan."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError, phrase
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import POSITIVE, Range, keywords, made, setting

if TYPE_CHECKING:
    from raybundle.io.photos.photo import Photo
    from raybundle.missions.check import FlightCheck
    from raybundle.missions.mission import Mission
    from raybundle.missions.terrain import Ground


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanCheckSettings:
    """Which photographs are held against which plan, and what counts."""

    plan: Path
    """mission.toml, or the folder that holds it"""
    photos: tuple[Path, ...]
    """folders and files"""
    positions: Path | None = setting(None, "Positions of the photographs, instead of their own.", metavar="FILE")
    crs: str = setting("", "Coordinate system of {positions}, if that file defines none.", metavar="EPSG:CODE")
    dem: Path | None = setting(None, "Raster of ground heights, if the plan followed one.", metavar="FILE")
    seen: int | None = setting(
        None, "Required number of photographs of each place.  [default: half of the planned number, at least 3]",
        limits=Range(low=1, high=1000),
    )  # fmt: skip
    blur_tolerance: float = setting(
        1.5, "Blur beyond that of the others that rejects a photograph [px].", limits=POSITIVE
    )
    tilt_tolerance: float = setting(
        10.0, "Deviation of the view that rejects a photograph [deg].", limits=Range(low=0, high=90)
    )
    sharpness: bool = setting(
        True, "Do not test sharpness: check only positions, times and angles.", flag="no-sharpness"
    )
    out: Path | None = setting(None, "New folder for the table of photographs, gaps and a picture.", metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class CheckedFlight:
    """Comparison of a plan with its photographs, and its files."""

    mission: Mission
    check: FlightCheck
    remarks: tuple[str, ...]
    refused: tuple[tuple[Path, str], ...]
    """files that are no photographs, with the reason"""
    files: tuple[Path, ...]


@keywords(PlanCheckSettings)
def check_flight(
    plan: str | Path, photos: str | Path | Sequence[str | Path], *, progress: Progress = silent, **settings: Any
) -> CheckedFlight:
    """Hold photographs against their plan: missing, blurred, tilted ones, and what is to be flown again.

    plan      mission.toml, or its folder
    photos    folders and files
    settings  as of the command line, by the names of `PlanCheckSettings`: seen=4, out="check"
    raises    InputError for what is no plan, and where no photograph lies where one was planned
    """
    inputs = (photos,) if isinstance(photos, str | Path) else photos
    given = {"plan": Path(plan), "photos": tuple(Path(p) for p in inputs), **settings}
    return run_plan_check(made(PlanCheckSettings, given), progress)


def run_plan_check(settings: PlanCheckSettings, progress: Progress = silent) -> CheckedFlight:
    """Check what the settings name, and write what they ask for."""
    from raybundle.io.folders import check_new_folder
    from raybundle.io.missions.flown import flown_of
    from raybundle.io.missions.mission_file import read_mission
    from raybundle.io.photos.photo import find_photos
    from raybundle.missions.check import Limits
    from raybundle.missions.check import check_flight as check

    s = settings
    if s.out is not None:
        check_new_folder(s.out)
    mission = read_mission(s.plan)
    if not mission.crs:
        raise InputError("flight_check.no_crs", file=s.plan)
    found = find_photos(s.photos, progress=progress)
    if not found.photos:
        raise InputError("photograph.none", file=s.photos[0])
    photos, remarks = _placed(s, found.photos)
    ground, reported = _ground(s, mission)
    flown, more = flown_of(photos, mission, sharp=s.sharpness, progress=progress)
    result = check(
        mission, flown, ground, Limits(blur_px=s.blur_tolerance, tilt=math.radians(s.tilt_tolerance), seen=s.seen)
    )
    files = () if s.out is None else _write(s.out, mission, result)
    return CheckedFlight(
        mission=mission, check=result, remarks=(*remarks, *reported, *more), refused=found.refused, files=files
    )


def _placed(s: PlanCheckSettings, photos: Sequence[Photo]) -> tuple[Sequence[Photo], tuple[str, ...]]:
    if s.positions is None:
        return photos, ()
    from raybundle.io.trajectories.base import read_trajectory
    from raybundle.io.trajectories.photographs import with_positions

    return with_positions(photos, read_trajectory(s.positions), s.crs or None)


def _ground(s: PlanCheckSettings, mission: Mission) -> tuple[Ground, tuple[str, ...]]:
    """Heights of the ground where they are known; without a raster those below a plan that followed none."""
    import numpy as np

    from raybundle.io.geo.rasters import read_heights
    from raybundle.missions.mission import exposures
    from raybundle.missions.terrain import below_photographs, level_ground

    if s.dem is not None:
        xy = np.concatenate([mission.way_points.xyz[:, :2], mission.outline])
        margin = max(mission.camera.footprint(mission.camera.distance(mission.gsd)))
        grid = read_heights(s.dem, mission.crs, np.array([xy.min(axis=0) - margin, xy.max(axis=0) + margin]))
        return grid.at, grid.remarks
    if not mission.terrain:
        return level_ground(mission.take_off[2]), ()
    planned = exposures(mission)
    above = mission.camera.distance(mission.gsd)
    remark = phrase("flight_check.ground_of_plan", terrain=mission.terrain)
    return below_photographs(planned.xyz, above), (remark,)


def _write(out: Path, mission: Mission, result: FlightCheck) -> tuple[Path, ...]:
    """photographs.csv, gaps and a picture."""
    from raybundle.io.folders import new_folder
    from raybundle.io.missions.gap_files import write_flown, write_gaps
    from raybundle.report.figures.mission import plan_view

    with new_folder(out) as folder:
        table, picture = folder / "photographs.csv", folder / "check.svg"
        write_flown(result, mission, table)
        gaps = write_gaps(result, mission, folder)
        view = plan_view(
            mission, result.coverage if mission.closed else None, gaps=[g.outline for g in result.gaps],
            flown=result.flown.xyz[:, :2],
        )  # fmt: skip
        picture.write_text(view, encoding="utf-8", newline="\n")
        names = [p.name for p in (table, *gaps, picture)]
    return tuple(out / n for n in names)
