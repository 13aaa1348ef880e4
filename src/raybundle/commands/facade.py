"""`raybundle facade`: the elevation of a wall with relief: true orthophoto, sheet, drawing, sections."""

from __future__ import annotations

from contextlib import AbstractContextManager
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.pages import PROJECT_LANGUAGE_HELP, language_in
from raybundle.commands.plane_settings import OF_PLANE, PlaneSettings, plane_in
from raybundle.commands.record_settings import CLIENT, OPERATOR, TITLE
from raybundle.commands.surface import MOST_JOBS, WORK, MeasuredSurface, SurfaceSettings, run_surface
from raybundle.errors import InputError, Message, warning
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import ANY, NOT_NEGATIVE, POSITIVE, Range, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.commands.sheet import DrawingSheet
    from raybundle.io.formats import Export
    from raybundle.numerics.arrays import Array, Mask
    from raybundle.workflows.object_plane import Plane
    from raybundle.workflows.rectify import Grid

SURFACE, PICTURE, SHEET, DRAWING = "surface", "facade.tif", "sheet.pdf", "drawing.dxf"
SECTIONS = ("sections.dxf", "sections.csv")
WIDEST = 0.05
"""Depth of a hole that is filled, as a share of the longer side: windows and doors, not courtyards"""
PAPERS = ("A3", "A2", "A1")
LEAST_SEEN = 0.05
"""Of a row or column at the edge of the picture, as a share: where less is seen it is cut off"""
FINEST_MM = 0.25
"""Pixel on paper from which on a larger scale shows no more"""
DENSITY = "2"


@dataclass(frozen=True, slots=True, kw_only=True)
class FacadeSettings(PlaneSettings):
    """Which wall is drawn, how finely, and on what sheet."""

    source: Path
    """result folder or project of `orient`"""
    out: Path | None = setting(
        None, "Folder.  [default: SOURCE/facade; with {wall} N: SOURCE/facade-N]", metavar="FOLDER"
    )  # fmt: skip
    extent: tuple[float, float, float, float] | None = setting(
        None, "Part of the wall, in coordinates of its plane.  [default: extent of its points]",
        metavar="LEFT BOTTOM RIGHT TOP", limits=(ANY, ANY, ANY, ANY),
    )  # fmt: skip
    pixel: float | None = setting(
        None, "Pixel of the orthophoto in the object's unit.  [default: that of the photographs]", metavar="SIZE",
        limits=POSITIVE,
    )  # fmt: skip
    density: Literal["1", "2", "4"] = setting(
        DENSITY, "Measured pixels: each, or every second or fourth of rows and columns."
    )  # fmt: skip
    fill: float | None = setting(
        None, "Fill holes up to this depth from the next best photograph; 0: leave them white.  [default: 5 % of the "
        "longer side]", metavar="LENGTH", limits=NOT_NEGATIVE,
    )  # fmt: skip
    section: tuple[str, ...] = setting(
        (), "Section line: corners X Y, X Y, ... in the plane.  [default: one level, one plumb, through the middle]",
        metavar="CORNERS",
    )  # fmt: skip
    scale: int | None = setting(
        None, "Denominator of the scale of the sheet.  [default: the largest usual one that fits the pixel and A1]",
        metavar="N", limits=Range(low=1, high=1e8),
    )  # fmt: skip
    paper: Literal["auto", "A4", "A3", "A2", "A1", "A0"] = setting("auto", "Paper size. auto: A3, A2 or A1.")
    grid: float | None = setting(
        None, "Spacing of the grid crosses of the sheet; 0: none.  [default: a usual one]", metavar="LENGTH",
        limits=NOT_NEGATIVE,
    )  # fmt: skip
    photos: tuple[Path, ...] = setting(
        (), "Folder of the photographs.  [default: recorded in the project]", metavar="FOLDER"
    )
    masks: Path | None = setting(
        None, "Masks of the photographs, as for `surface`.  [default: masks and drawn areas of the project]",
        metavar="DIR",
    )  # fmt: skip
    jobs: int = setting(0, "Number of processors; 0: all.", limits=Range(low=0, high=MOST_JOBS))
    memory: float = setting(2.0, "Memory limit of all depth maps in work.", limits=POSITIVE, metavar="GB")
    title: str = setting("", TITLE, metavar="TEXT")
    client: str = setting("", CLIENT, metavar="TEXT")
    operator: str = setting("", OPERATOR, metavar="TEXT")
    language: str = setting("", PROJECT_LANGUAGE_HELP, metavar="CODE")


@dataclass(frozen=True, slots=True, kw_only=True)
class Facade:
    """A drawn wall."""

    plane: Plane
    relief: tuple[float, float]
    """depths of the wall's object points, in front of the plane positive"""
    grid: Grid
    """pixels of the picture in the plane"""
    measured: float
    """share of the pixels on measured heights"""
    filled: float
    """share of the pixels on interpolated heights"""
    place_sigma: float
    """median standard deviation of the place of a pixel, in the unit"""
    unit: str
    """empty: the scale is free"""
    folder: Path
    files: tuple[Path, ...]
    sheet: DrawingSheet | None
    """None: without a scale there is none"""
    surface: MeasuredSurface
    warnings: tuple[Message, ...] = ()
    remarks: tuple[str, ...] = ()
    state: str = ""
    """why the result is not to be used yet; empty: nothing states it"""

    @property
    def white(self) -> float:
        """Share of the pixels without colours."""
        return max(1.0 - self.measured - self.filled, 0.0)


@keywords(FacadeSettings)
def facade(
    source: str | Path, out: str | Path | None = None, *, progress: Progress = silent, **settings: Any
) -> Facade:
    """Draw a wall with relief: true orthophoto, sheet to scale, drawing and sections.

    source    result folder or project of `orient`
    out       folder; a run that was stopped goes on there
    settings  as of the command line, by the names of `FacadeSettings`: wall=2, scale=50, paper="A2"
    raises    InputError where no wall is found, and where no two photographs show it

    Limits: what hides the wall is in the picture; pixels on interpolated heights may be displaced.
    """
    given = {"source": path_of("source", source), **settings}
    if out is not None:
        given["out"] = path_of("out", out)
    return run_facade(made(FacadeSettings, given), progress)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Wall:
    """What is drawn."""

    settings: FacadeSettings
    """with its folder, its language and a plane that is plumb where no other one is asked for"""
    result: Path
    export: Export
    plane: Plane
    extent: Array
    relief: tuple[float, float]
    remarks: tuple[str, ...]
    pixel: float
    cell: float

    @property
    def out(self) -> Path:
        """The folder."""
        assert self.settings.out is not None
        return self.settings.out


def run_facade(settings: FacadeSettings, progress: Progress = silent) -> Facade:
    """Draw the wall that the settings ask for."""
    from raybundle.io.folders import overwriting
    from raybundle.results.record import STATE

    wall = _wall_of(settings, progress)
    measured = run_surface(_surface_settings(wall), progress)
    with _own(wall.out, overwriting()):
        picture = _picture(wall, measured, progress)
        files = [wall.out / PICTURE, *_sections(wall)]
        sheet = None
        wrong = list[Message]()
        if measured.surface.free_scale:
            wrong.append(warning("facade.no_scale"))
            for name in (SHEET, DRAWING):  # of an earlier run
                (wall.out / name).unlink(missing_ok=True)
        else:
            sheet = _sheet(wall, progress)
            files += [sheet.file, _drawing(wall)]
    return replace(
        picture, files=tuple(files), sheet=sheet, warnings=(*wrong, *measured.pages.warnings),
        remarks=tuple(dict.fromkeys((*wall.remarks, *(() if sheet is None else sheet.remarks), *measured.remarks))),
        state=wall.export.record.get(STATE, ""),
    )  # fmt: skip


def _own(folder: Path, overwriting: AbstractContextManager[None]) -> AbstractContextManager[None]:
    """Within it the files of an earlier run are replaced."""
    folder.mkdir(parents=True, exist_ok=True)
    return overwriting


def _wall_of(s: FacadeSettings, progress: Progress) -> _Wall:
    import numpy as np

    from raybundle.block.frames import in_file_frames
    from raybundle.workflows.object_plane import MapLevel
    from raybundle.workflows.rectify import two_digits, usual_pixel, whole_pixels
    from raybundle.workflows.sources import read_source, result_within
    from raybundle.workflows.wall_extent import wall_extent

    if not s.source.is_dir():
        raise InputError("result.no_folder", file=s.source)
    result = result_within(s.source)
    export, _ = read_source(result)
    export = replace(export, block=in_file_frames(export.block))
    out = s.out or s.source / ("facade" if s.wall == 1 else f"facade-{s.wall}")
    plumb = s.vertical or not (s.horizontal or len(s.plane) > 2)
    s = replace(s, out=out, vertical=plumb, language=language_in(result, s.language))
    plane, remarks = plane_in(result, export, s, progress)
    extent, relief = wall_extent(plane, export.block.points.xyz)
    pixel = s.pixel or usual_pixel(export.block, plane)
    cell = max(two_digits(2.0 * int(s.density) * usual_pixel(export.block, plane)), pixel)
    area = np.array(s.extent) if s.extent is not None else extent
    if s.extent is None or isinstance(plane, MapLevel):
        area = whole_pixels(area, cell)
    return _Wall(
        settings=s, result=result, export=export, plane=plane, extent=area, relief=relief,
        remarks=(*plane.cautions, *remarks), pixel=pixel, cell=cell,
    )  # fmt: skip


def _surface_settings(w: _Wall) -> SurfaceSettings:
    """Of the surface of the wall: its folder is kept, so that a further run measures nothing again."""
    s = w.settings
    left, bottom, right, top = w.extent.tolist()
    alike = {name: getattr(s, name) for name in (
        "source", "density", "photos", "masks", "jobs", "memory", "title", "client", "operator", "language", *OF_PLANE,
    )}  # fmt: skip
    return SurfaceSettings(
        **alike, out=w.out / SURFACE, dsm=w.cell, ortho=w.pixel, extent=(left, bottom, right, top), free_scale=True
    )


def _picture(w: _Wall, measured: MeasuredSurface, progress: Progress) -> Facade:
    """The orthophoto with holes filled, as picture with world file and NAME.toml."""
    import numpy as np

    from raybundle.commands.record import known_record
    from raybundle.io.pictures.plane_file import stations_of
    from raybundle.io.pictures.rectified import Rectified
    from raybundle.io.raster_library import raster_library
    from raybundle.io.reading.trees import read_toml
    from raybundle.results.record import STATE
    from raybundle.surfaces.orthophoto_files import ABOUT, SIGMAS
    from raybundle.workflows.object_plane import MapLevel

    orthophoto = measured.surface.orthophoto
    assert orthophoto is not None
    colours, found = _coloured(w, measured, progress)
    with raster_library().open(w.out / SURFACE / SIGMAS) as file:
        sigma = np.hypot(file.read(1), file.read(2))
    g = orthophoto.grid
    if w.settings.extent is None:
        g, window = _shown(g, colours[..., 3] > 0)
        colours, found, sigma = colours[window], found[window], sigma[window]
    seen, known = colours[..., 3] > 0, np.isfinite(sigma)
    place_sigma = float(np.median(sigma[known])) if known.any() else float("nan")
    share, filled = float((seen & ~found).mean()), float(found.mean())
    stated = {k: v.value for k, v in read_toml(w.out / SURFACE / ABOUT).tree().mapping().items()}
    images = w.export.block.images
    names = [f or i for f, i in zip(images.file, images.ids, strict=True)]
    about = {
        **{k: v for k, v in stated.items() if not isinstance(v, dict)}, "left": g.left, "top": g.top,
        "width_px": g.width, "height_px": g.height, "measured": share, "filled": filled,
        **({"place_sigma": place_sigma} if known.any() else {}),
        **({"scale": "free"} if measured.surface.free_scale else {}),
        **{k: v for k, v in stated.items() if isinstance(v, dict)}, "stations": stations_of(w.export, names),
    }  # fmt: skip
    state = w.export.record.get(STATE, "")
    remarks = Rectified(colours=colours[..., :3], seen=seen).write(
        w.out / PICTURE, left=g.left, top=g.top, pixel=g.pixel, about=about,
        wkt=w.plane.system.to_wkt() if isinstance(w.plane, MapLevel) else "",
        record={**known_record(w.result).as_mapping(), **({STATE: state} if state else {})},
    )  # fmt: skip
    return Facade(
        plane=w.plane, relief=w.relief, grid=g, measured=share, filled=filled, place_sigma=place_sigma,
        unit=measured.unit, folder=w.out, files=(), sheet=None, surface=measured, remarks=remarks,
    )  # fmt: skip


def _coloured(w: _Wall, measured: MeasuredSurface, progress: Progress) -> tuple[Array, Mask]:
    """Colours (h, w, 4) of the orthophoto with holes filled, and which pixels (h, w) were."""
    import numpy as np

    from raybundle.commands.drawn_masks import masks_of_result
    from raybundle.io.photos.masks import find_masks
    from raybundle.io.raster_library import raster_library
    from raybundle.pipeline.project import photographs_of
    from raybundle.surfaces.files.input import opened
    from raybundle.surfaces.orthophoto_files import PICTURE as ORTHOPHOTO
    from raybundle.surfaces.orthophoto_holes import fill_holes
    from raybundle.surfaces.photographs import photographs_there

    s, surface = w.settings, measured.surface
    orthophoto, heights = surface.orthophoto, surface.heights
    assert orthophoto is not None
    assert heights is not None
    with raster_library().open(w.out / SURFACE / ORTHOPHOTO) as file:
        colours = np.ascontiguousarray(np.moveaxis(file.read(), 0, 2))
    left, bottom, right, top = w.extent.tolist()
    widest = WIDEST * max(right - left, top - bottom) if s.fill is None else s.fill
    if not widest:
        return colours, np.zeros(colours.shape[:2], bool)
    folders = s.photos or photographs_of(w.result)
    photos, _ = photographs_there(surface.block, folders)
    masks = masks_of_result(s.source, s.masks, folders, w.out / SURFACE / WORK)
    found = fill_holes(
        colours, orthophoto.grid, heights.grid, opened(w.out / SURFACE).model, widest=widest, block=surface.block,
        photos=photos, masks=None if masks is None else find_masks(masks, tuple(photos.values())),
        gains=orthophoto.gains, progress=progress,
    )  # fmt: skip
    return colours, found


def _shown(grid: Grid, seen: Mask) -> tuple[Grid, tuple[slice, slice]]:
    """The part of a picture between the outermost rows and columns of which a share is seen; all of an empty one."""
    import numpy as np

    rows, columns = (np.flatnonzero(seen.mean(axis=axis) > LEAST_SEEN) for axis in (1, 0))
    if not len(rows) or not len(columns):
        return grid, (slice(None), slice(None))
    (top, bottom), (left, right) = rows[[0, -1]].tolist(), columns[[0, -1]].tolist()
    part = grid.part(left, top, right - left + 1, bottom - top + 1)
    return part, (slice(top, bottom + 1), slice(left, right + 1))


def _sections(w: _Wall) -> list[Path]:
    """Profiles along lines of the plane."""
    from raybundle.commands.heights.section import HeightsSectionSettings, run_section

    left, bottom, right, top = w.extent.tolist()
    inner = 1e-6 * (right - left)  # rounding of coordinates must not lie beside the grid
    across, up = (left + right) / 2, (bottom + top) / 2
    lines = w.settings.section or (
        f"{left + inner!r} {up!r}, {right - inner!r} {up!r}",
        f"{across!r} {bottom + inner!r}, {across!r} {top - inner!r}",
    )  # fmt: skip
    out = tuple(w.out / name for name in SECTIONS)
    return list(run_section(HeightsSectionSettings(source=w.out / SURFACE, line=lines, out=out)).files)


def _sheet(w: _Wall, progress: Progress) -> DrawingSheet:
    """The sheet at the largest usual scale that the picture is good for and a paper takes."""
    from raybundle.commands.record import known_record
    from raybundle.commands.sheet import run_drawing_sheet
    from raybundle.commands.sheet_settings import DrawingSheetSettings
    from raybundle.report.drawing.paper import usual_scales

    s, known = w.settings, known_record(w.result)
    if not (s.title or known.title or known.object):  # not the name of the picture
        s = replace(s, title=s.source.resolve().name)
    common = {f.name: getattr(s, f.name) for f in fields(DrawingSheetSettings) if f.name in (
        "grid", "title", "client", "operator", "language",
    )}  # fmt: skip
    papers = PAPERS if s.paper == "auto" else (s.paper,)
    millimetres = 1000.0 if w.export.block.length_unit == "m" else 1.0
    scales = [s.scale] if s.scale else [n for n in usual_scales() if w.pixel * millimetres <= FINEST_MM * n]
    refused: InputError | None = None
    for scale in scales:
        for paper in papers:
            asked = DrawingSheetSettings(
                sources=(w.out / PICTURE, w.result), out=w.out / SHEET, scale=scale, paper=paper, **common
            )  # fmt: skip
            try:
                return run_drawing_sheet(asked, progress)
            except InputError as error:
                if error.message is None or error.message.code != "drawing.does_not_fit":
                    raise
                refused = error
    raise refused or InputError("drawing.no_source")


def _drawing(w: _Wall) -> Path:
    """Points and lines in the axes of the plane, with the picture below them."""
    from raybundle.commands.convert import ConvertSettings, run_convert

    file = w.out / DRAWING
    within = (w.out / PICTURE).with_suffix(".toml")
    run_convert(ConvertSettings(source=w.result, out=file, to="dxf", within=within))
    return file
