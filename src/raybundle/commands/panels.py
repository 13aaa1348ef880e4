"""Ground panels of a project found and marked by themselves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, cast

import numpy as np

from raybundle.block import Block, Role, Stations
from raybundle.commands.marked_results import passed_on
from raybundle.commands.marks import marks, open_journal
from raybundle.commands.new_project import standing_folder
from raybundle.errors import InputError, Message, as_detail
from raybundle.io.block.folder import read_block
from raybundle.io.geo.control_systems import sigma_in_metres
from raybundle.io.photos.photo import read_grey, read_photo
from raybundle.measuring.actions.masks import photograph_files
from raybundle.measuring.actions.verbs import Point, Put
from raybundle.measuring.panel_search import FEWEST, LEAST_RAYS, PanelSearch, pixel_size, search_panels
from raybundle.measuring.session import Session, block_folder
from raybundle.measuring.state import State
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.observations.coordinates import Coordinates
from raybundle.pipeline.project import photographs_of

WITH_POSITIONS = 6.0
"""Metres between the coordinates of control and of a block that positions of the photographs alone place"""
WITH_CONTROL_SIGMAS, LEAST_PX = 4.0, 40.0
"""The same of a block that control places: standard deviations of the control, and pixels for the block's own errors"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Panels:
    """What was found, and what was marked of it."""

    search: PanelSearch
    asked: tuple[str, ...]
    """points that were looked for"""
    marked: int
    """new marks"""
    length_unit: str
    unread: Message | None = None
    """why the control files of the project were not read"""
    lost: tuple[str, ...] = ()
    """photographs that are missing or cannot be read"""


def find_panels(
    folder: str | Path, points: Sequence[str] = (), *, reach: float = 0.0, operator: str = "",
    progress: Progress = silent,
) -> Panels:  # fmt: skip
    """Find the panels of control and check points in the photographs of a project, and mark them.

    folder  project with a result that positions of the photographs, or three control points, place
    points  names; empty: all with coordinates that fewer than three photographs show
    reach   largest difference between given coordinates and the block [length unit]; 0: 6 m where positions place the
            block, else four standard deviations of the control, and 40 px
    raises  InputError where nothing places the block, or no point has coordinates

    Each mark is an action of the journal. A panel is a cross, a chequered square, an iron cross or a disc. A point is
    marked if three photographs show it, if its place fits those of the other points, and if nothing else there looks
    alike; else the reason is stated.
    """
    project, state = standing_folder(folder) or Path(folder), marks(folder)
    block = read_block(block_folder(project))
    files, unread = _of_files(project)
    of_marks = _of_marks(state)
    given_points = {**files, **_of_block(block), **of_marks}
    at = {n: g.xyz for n, g in given_points.items()}
    sigma = {n: float(np.nanmean(g.sigma)) for n, g in given_points.items()}
    seen = _seen(block, state)
    enough = {n for n in at if sum(p == n for _, p in seen) >= LEAST_RAYS}
    asked = tuple(points) or tuple(n for n in at if n not in enough)
    unknown = [n for n in asked if n not in at]
    if unknown:
        raise InputError("panels.no_coordinates", point=unknown[0])
    if not at:
        raise InputError("panels.no_control")
    session = Session.of_block(block, None)
    reach = reach or _reach(block, session, sigma)
    photographs = photograph_files(block, photographs_of(project))
    if not photographs:
        raise InputError("image.photograph_missing", image=block.images.ids[0], file=project)
    lost: dict[str, None] = {}

    def picture(image: int) -> Array | None:
        path = photographs.get(block.images.file[image])
        try:
            if path is not None:
                return read_grey(read_photo(path))
        except InputError:  # it costs this photograph alone
            pass
        lost[block.images.ids[image]] = None
        return None

    given = {n: at[n] for n in at if n in asked or n in enough}
    search = search_panels(session, given, sigma, reach, picture, progress)
    marked = 0
    with open_journal(project) as journal:
        for found in search.found:
            point = given_points[found.point]
            if found.point in asked and found.point not in block.points.ids and found.point not in of_marks:
                xyz, s = (
                    tuple(None if np.isnan(v) else float(v) for v in values) for values in (point.xyz, point.sigma)
                )
                journal.append(
                    Point(point=found.point, role=point.role, xyz=cast("Any", xyz), sigma=cast("Any", s)),
                    author=operator,
                )
            for image, mark in found.marks.items() if found.point in asked else ():
                if (image, found.point) in seen:
                    continue
                journal.append(Put(
                    image=image, point=found.point, x_px=mark.x_px, y_px=mark.y_px, covariance=mark.covariance,
                    how=mark.kind, quality=mark.quality,
                ), author=operator)  # fmt: skip
                marked += 1
    return Panels(
        search=search, asked=asked, marked=marked, length_unit=block.length_unit, unread=unread, lost=tuple(lost)
    )  # fmt: skip


@dataclass(frozen=True, slots=True)
class _GivenPoint:
    """Coordinates (3,) and standard deviations (3,) of a point; NaN: not known."""

    role: Literal["control", "check"]
    xyz: Array
    sigma: Array


def _of_files(project: Path) -> tuple[dict[str, _GivenPoint], Message | None]:
    """Of the files that `orient` was given, in the frame of the block, and why they are not read.

    They hold check points without image points, too, which a block leaves out.
    """
    from raybundle.commands.orient import settings_asked
    from raybundle.commands.record import run_of

    if run_of(project) is None:  # begun by hand
        return {}, None
    found: dict[str, _GivenPoint] = {}
    try:
        files = settings_asked(project).given().control
        frame = passed_on(project).frame
        for c in files:
            local = c.xyz if frame is None or not c.crs else frame.local_from_crs(c.xyz)
            for name, role, xyz, s in zip(c.ids, c.role.tolist(), local, sigma_in_metres(c), strict=True):
                if role != Role.TIE and np.isfinite(xyz[:2]).all():
                    found[name] = _GivenPoint("check" if role == Role.CHECK else "control", xyz, s)
    except InputError as error:
        return {}, as_detail(error)
    return found, None


def _of_block(block: Block) -> dict[str, _GivenPoint]:
    p = block.points
    found: dict[str, _GivenPoint] = {}
    for k in np.flatnonzero(np.asarray(p.role) != Role.TIE).tolist():
        known = np.isfinite(p.sigma[k])
        if known[:2].all():
            role = "check" if p.role[k] == Role.CHECK else "control"
            found[p.ids[k]] = _GivenPoint(role, np.where(known, p.xyz[k], np.nan), p.sigma[k])
    return found


def _of_marks(state: State) -> dict[str, _GivenPoint]:
    found: dict[str, _GivenPoint] = {}
    for name, point in state.points.items():
        xyz, sigma = (np.array([np.nan if v is None else v for v in values]) for values in (point.xyz, point.sigma))
        if point.reported and point.role != "tie" and np.isfinite(xyz[:2]).all():
            found[name] = _GivenPoint(point.role, xyz, np.where(np.isfinite(sigma), sigma, 0.0))
    return found


def _seen(block: Block, state: State) -> set[tuple[str, str]]:
    """Image and point of all that is measured of named points."""
    o = block.observations
    named = np.asarray(block.points.role)[o.point] != Role.TIE
    rows = zip(o.image[named].tolist(), o.point[named].tolist(), strict=True)
    return {(block.images.ids[i], block.points.ids[p]) for i, p in rows} | set(state.marks)


def _reach(block: Block, session: Session, sigma: Mapping[str, float]) -> float:
    """How far panels may lie from their coordinates; raises InputError where nothing places the block."""
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    if int((block.points.is_control.any(axis=1) & (rays > 1)).sum()) >= FEWEST:
        middle = np.nanmedian(block.points.xyz, axis=0)
        pixels = [pixel_size(session, i, middle) for i in np.flatnonzero(block.images.oriented).tolist()]
        return WITH_CONTROL_SIGMAS * max(sigma.values()) + LEAST_PX * float(np.median(pixels))
    if len(block.table(Stations)) or len(block.table(Coordinates)):
        return WITH_POSITIONS
    raise InputError("panels.not_placed", least=FEWEST)
