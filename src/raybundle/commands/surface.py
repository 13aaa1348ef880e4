"""`raybundle surface`: dense points of what the photographs show, each with its standard deviation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.convert import FREE_SCALE_HELP
from raybundle.commands.pages import PROJECT_LANGUAGE_HELP, language_in
from raybundle.commands.plane_settings import OF_PLANE, PlaneSettings
from raybundle.commands.record_settings import CLIENT, OPERATOR, TITLE
from raybundle.commands.worker import AWAITED_HELP, AWAITED_LIMIT_HELP, store_of
from raybundle.errors import InputError, as_detail
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import (
    ANY,
    NOT_NEGATIVE,
    POSITIVE,
    Range,
    keywords,
    made,
    other_than_usual,
    path_of,
    setting,
    toml_lines,
)
from raybundle.workflows.orienting.options import CLUSTER_HELP, STORE_HELP

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.commands.surface_pages import SurfacePages
    from raybundle.io.formats import Export
    from raybundle.surfaces.product import Written
    from raybundle.surfaces.product_grids import Grids
    from raybundle.surfaces.region import SurfaceRegion
    from raybundle.surfaces.run import Surface
    from raybundle.workflows.object_plane import Plane

MOST_JOBS = 1024
"""Processors of one machine"""
WORK = "work"
"""Of the folder: the project with all that is kept for the next run"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SurfaceSettings(PlaneSettings):
    """How a surface is measured."""

    source: Path
    """result folder or project of `orient`"""
    out: Path | None = setting(None, "New folder.  [default: SOURCE/surface]", metavar="FOLDER")
    density: Literal["1", "2", "4"] = setting(
        "1", "Measured pixels: each, or every second or fourth of rows and columns."
    )
    dsm: float | None = setting(
        None, "Also write heights above the plane, on a grid of this cell size in the object's unit. If the result "
        "has a coordinate system and no plane is given, heights are in its map.", limits=POSITIVE, metavar="CELL",
    )  # fmt: skip
    ortho: float | None = setting(
        None, "Also write a true orthophoto above the same plane, with this pixel size. Each pixel comes from the "
        "photograph with the best view and has its uncertainty.", limits=POSITIVE, metavar="CELL",
    )  # fmt: skip
    mesh: float | None = setting(
        None, "Also write a mesh above the same plane, with this vertex spacing: PLY, OBJ, glTF. The orthophoto is "
        "its texture.",
        limits=POSITIVE, metavar="CELL",
    )  # fmt: skip
    las: bool = setting(False, "Also write the points as LAZ, or as LAS without a LAZ library.")
    depths: bool = setting(False, "Also write the depth map of each photograph with its standard deviations, as TIFF.")
    thin: float | None = setting(
        None, "Thin the cloud: keep the best point per cube of this size.", limits=POSITIVE, metavar="LENGTH"
    )
    region: tuple[str, ...] = setting(
        (), "Measure only this part of the object: a file (GeoJSON, KML, CSV, OGR formats) or corners X Y, X Y, ... "
        "in plan of the plane or the map. All heights count.  [default: everything visible]",
        metavar="FILE|CORNERS",
    )  # fmt: skip
    extent: tuple[float, float, float, float] | None = setting(
        None, "Rectangle of the plane in its coordinates; of a map, east and north. Instead of a region.",
        metavar="LEFT BOTTOM RIGHT TOP", limits=(ANY, ANY, ANY, ANY),
    )  # fmt: skip
    photos: tuple[Path, ...] = setting(
        (), "Folder of the photographs.  [default: recorded in the project]", metavar="FOLDER"
    )
    masks: Path | None = setting(
        None, "Masks of the photographs, named as for `orient`. Where they are 0, neither points nor colours are "
        "taken.  [default: masks and drawn areas of the project]", metavar="DIR",
    )  # fmt: skip
    cluster: str = setting("", CLUSTER_HELP, metavar="FOLDER|shards")
    store: str = setting("", STORE_HELP, metavar="URL|project")
    wait_for_workers: int = setting(0, AWAITED_HELP, metavar="N", limits=NOT_NEGATIVE)
    wait_limit: float = setting(600.0, AWAITED_LIMIT_HELP, metavar="S", limits=Range(low=0, high=1e6))
    jobs: int = setting(0, "Number of processors; 0: all.", limits=Range(low=0, high=MOST_JOBS))
    memory: float = setting(
        2.0, "Memory limit of all depth maps in work. Beyond it, approximate depths are computed by bands of rows. "
        "At least one map is made.", limits=POSITIVE, metavar="GB",
    )  # fmt: skip
    free_scale: bool = setting(False, FREE_SCALE_HELP)
    title: str = setting("", TITLE, metavar="TEXT")
    client: str = setting("", CLIENT, metavar="TEXT")
    operator: str = setting("", OPERATOR, metavar="TEXT")
    pdf: bool = setting(False, "Also write surface.html as surface.pdf: A4, with page numbers and bookmarks.")
    language: str = setting("", PROJECT_LANGUAGE_HELP, metavar="CODE")


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredSurface:
    """A surface and where it was written."""

    surface: Surface
    written: tuple[tuple[str, Written], ...]
    """what was written, by the names of the products"""
    remarks: tuple[str, ...]
    unit: str
    """of coordinates and standard deviations; empty: the scale is free"""
    pages: SurfacePages
    """what was written for people, and what it states of the points and of the adjustment that they rest on"""

    @property
    def median_sigma(self) -> float:
        """Median standard deviation of a point's place in the datum of the result: root of the squares of x, y, z."""
        return self.pages.summary.position[0]

    @property
    def median_along_ray(self) -> float:
        """Median standard deviation along the ray."""
        return self.pages.summary.sigma[0]

    @property
    def shares(self) -> tuple[float, float, float]:
        """Of noise, roughness and orientation in the variance along the ray, in the mean."""
        return self.pages.summary.shares

    @property
    def points(self) -> Path:
        """The file of the cloud."""
        return dict(self.written)[""].files[0]


@keywords(SurfaceSettings)
def surface(
    source: str | Path, out: str | Path | None = None, *, progress: Progress = silent, **settings: Any
) -> MeasuredSurface:
    """Measure dense surface points in the photographs of a result; OUT/points.ply holds them.

    source    result folder or project of `orient`
    out       new folder; a run that was stopped goes on there
    settings  as of the command line, by the names of `SurfaceSettings`: density="2"
    raises    InputError where no two photographs show the same part, and where the scale is free

    Limits: errors that all photographs of a place share, as of reflections, water and moving shadows.
    """
    given = {"source": path_of("source", source), **settings}
    if out is not None:
        given["out"] = path_of("out", out)
    return run_surface(made(SurfaceSettings, given), progress)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Asked:
    """What is measured, of what, into which folder."""

    settings: SurfaceSettings
    result: Path
    export: Export
    folders: tuple[Path, ...]
    """of the photographs"""
    out: Path
    wanted: frozenset[str]
    """names of products"""
    grids: Grids
    region: SurfaceRegion | None
    adjusted: Callable[[], Adjustment]
    fingerprint: str
    """of the result"""
    progress: Progress


def run_surface(settings: SurfaceSettings, progress: Progress = silent) -> MeasuredSurface:
    """Measure what the settings ask for, and write the points."""
    from raybundle.measuring.session import adjusted_again
    from raybundle.pipeline.choosing import await_workers, check_cluster
    from raybundle.pipeline.place import ProductGone
    from raybundle.results.fingerprint import fingerprint
    from raybundle.surfaces.products import PRODUCTS

    result, export, folders = _source_of(settings)
    s = replace(settings, language=language_in(result, settings.language))
    out = s.out or s.source / "surface"
    wanted = frozenset(name for name in PRODUCTS if not name or getattr(s, name) not in (None, False))
    _check_out(out)
    _check_needed(wanted, pdf=s.pdf)
    check_cluster(s.cluster)
    await_workers(s.cluster, s.wait_for_workers, s.wait_limit, progress)
    adjusted = cache(lambda: adjusted_again(result, progress))  # once for all that needs it
    grids, region = _grid_of(s, result, export, adjusted, progress)
    s = replace(s, store=store_of(out / WORK, s.store, (s.source, *folders)))
    asked = _Asked(
        settings=s, result=result, export=export, folders=folders, out=out, wanted=wanted, grids=grids, region=region,
        adjusted=adjusted, fingerprint=fingerprint(result), progress=progress,
    )  # fmt: skip
    mended = set[str]()
    while True:
        before = len(mended)
        try:
            return _delivered(asked, _measured(asked), mended)
        except ProductGone as error:  # found when products were written: its stage makes it
            mended.add(error.key)
            if len(mended) == before:
                raise


def _measured(a: _Asked) -> Surface:
    """The surface; a folder in which nothing was kept is removed where it cannot be measured."""
    from raybundle.commands.drawn_masks import masks_of_result
    from raybundle.pipeline.project import discard_empty
    from raybundle.surfaces.run import surface as measured
    from raybundle.surfaces.state import SurfaceOptions
    from raybundle.surfaces.tasks import PART

    s, work = a.settings, a.out / WORK
    options = SurfaceOptions(
        density=int(s.density), grid=a.grids.heights, orthophoto=a.grids.orthophoto, region=a.region
    )  # fmt: skip
    try:
        _keep_settings(s, work)
        return measured(
            a.result, work, options, photos=a.folders, masks=masks_of_result(s.source, s.masks, a.folders, work),
            free_scale=s.free_scale, jobs=s.jobs, memory=s.memory * 1e9, cluster=s.cluster, store=s.store,
            progress=a.progress, adjusted=a.adjusted,
        )  # fmt: skip
    except InputError:
        discard_empty(work, PART)
        if a.out.is_dir() and not any(a.out.iterdir()):
            a.out.rmdir()
        raise


def _delivered(a: _Asked, done: Surface, mended: set[str]) -> MeasuredSurface:
    """Write what is asked for; `mended` gets the keys of kept products that were found damaged."""
    from raybundle.commands.previous_products import note_written, settle_earlier
    from raybundle.commands.surface_pages import PDF, heights_files, outside_words, write_pages
    from raybundle.io.folders import clear_left
    from raybundle.surfaces.product import Context
    from raybundle.surfaces.products import PRODUCTS
    from raybundle.surfaces.run import mended_words
    from raybundle.surfaces.thinning import thinned

    s, out, wanted = a.settings, a.out, a.wanted
    # of what was adjusted, not of what a folder states
    export = replace(a.export, block=replace(a.export.block, free_scale=done.free_scale))
    unit = "" if done.free_scale else export.block.length_unit
    try:
        context = Context(
            export=export, unit=unit, wanted=wanted, plane=a.grids.plane, mesh=s.mesh, progress=a.progress,
            points=done if s.thin is None else thinned(done, s.thin), fingerprint=a.fingerprint,
        )  # fmt: skip
        asked_for = wanted | ({"pdf"} if s.pdf else set[str]())
        clear_left(out)
        earlier = settle_earlier(done, out, out / WORK, asked_for, s.thin, {"pdf": PDF})
        written = tuple((name, p.write(done, out, context)) for name, p in sorted(PRODUCTS.items()) if name in wanted)
        note_written(done, out / WORK, wanted, s.thin, a.fingerprint)
        remarks = (
            *outside_words(done, a.grids), *heights_files(a.grids.reported, export), *done.remarks,
            *mended_words(mended | done.store.mended), *earlier.reported,
        )  # fmt: skip
        reported = (done.others, *remarks) if done.others else remarks
        pages = write_pages(done, a.result, out, context, reported, s, earlier.others, a.progress)
        if s.pdf:
            note_written(done, out / WORK, {"pdf"}, s.thin, a.fingerprint)
    finally:
        mended |= done.store.mended
    return MeasuredSurface(surface=done, written=written, remarks=remarks, unit=unit, pages=pages)


def _source_of(s: SurfaceSettings) -> tuple[Path, Export, tuple[Path, ...]]:
    """The result folder, its block, and the folders of its photographs."""
    from raybundle.pipeline.project import photographs_of
    from raybundle.surfaces.product import in_its_map
    from raybundle.workflows.sources import read_source, result_within

    if not s.source.is_dir():
        raise InputError("result.no_folder", file=s.source)
    result = result_within(s.source)
    if not any((result / name).is_file() for name in ("block.toml", "result.json")):
        raise InputError(
            "result.none_in_folder",
            file=s.source,
        )
    export = in_its_map(read_source(result)[0])
    folders = s.photos or photographs_of(result)
    if not folders:
        raise InputError("photograph.folder_unknown", file=s.source)
    return result, export, folders


def _grid_of(
    s: SurfaceSettings, result: Path, export: Export, adjusted: Callable[[], Adjustment], progress: Progress
) -> tuple[Grids, SurfaceRegion | None]:  # fmt: skip
    """The plane, its cells and the pixels of an orthophoto that are asked for, and the part that is measured."""
    from raybundle.commands.plane_settings import plane_in
    from raybundle.io.geo.parsed_names import plan_system
    from raybundle.surfaces.product_grids import Grids, grids_over
    from raybundle.workflows.object_plane import MapLevel
    from raybundle.workflows.rectify import check_area

    given = [name for name in OF_PLANE if name in other_than_usual(s)]
    if s.region and s.extent is not None:
        raise InputError("option.exclusive", first="region", second="extent")
    part = bool(s.region) or s.extent is not None
    gridded = any(asked is not None for asked in (s.dsm, s.ortho, s.mesh))
    if not gridded and not part:
        if given:
            raise InputError("surface.plane_without_heights", setting=given[0])
        return Grids(), None
    in_map = export.frame is not None and plan_system(export.frame.crs) is not None
    level = in_map and not (set(OF_PLANE) & set(other_than_usual(s)))
    plane, remarks = plane_in(result, export, replace(s, horizontal=True) if level else s, progress, adjusted)
    region = _region_in(s, export.block, plane) if part else None
    if isinstance(plane, MapLevel) and region is not None:
        check_area(plane, region.extent, setting="region" if s.region else "extent")
    if not gridded:
        return Grids(reported=remarks), region
    grids = grids_over(
        export.block, plane, None if region is None else region.extent, density=int(s.density), heights=s.dsm,
        orthophoto=s.ortho, mesh=s.mesh, reported=remarks,
    )  # fmt: skip
    return grids, region


def _region_in(s: SurfaceSettings, block: Block, plane: Plane) -> SurfaceRegion:
    """The part of a plane that is asked for."""
    from raybundle.surfaces.grid import HeightPlane
    from raybundle.surfaces.region_input import region_asked
    from raybundle.workflows.object_plane import MapLevel
    from raybundle.workflows.rectify import usual_pixel

    wkt = plane.system.to_wkt() if isinstance(plane, MapLevel) else ""
    apart = int(s.density) * usual_pixel(block, plane)
    return region_asked(HeightPlane.of(plane), wkt, s.region, s.extent, apart)


def _keep_settings(settings: SurfaceSettings, work: Path) -> None:
    """Write the settings into project.toml, as `orient` does: there the next run finds where products lie."""
    from raybundle.pipeline.project import HERE, Project
    from raybundle.pipeline.settings_file import with_table

    lines = ["# what the last run was asked for", *toml_lines("surface", settings)]
    text = "\n".join(lines).encode("utf-8", "replace").decode()
    project = Project.open(work, store=settings.store or HERE)  # not as the last run was reported
    try:
        project.write_settings(with_table(work / "project.toml", "surface", text))
    finally:
        project.close()


def _check_out(out: Path) -> None:
    """Raise InputError for a folder that holds anything but an earlier surface."""
    from raybundle.commands.surface_pages import PAGES
    from raybundle.io.folders import names_in
    from raybundle.surfaces.product import files_of_all

    if out.exists() and not out.is_dir():
        raise InputError("folder.is_a_file", file=out)
    others = names_in(out) - {WORK, *PAGES} - files_of_all() if out.is_dir() else set[str]()
    if others:
        raise InputError("surface.foreign_file", name=min(others), file=out)


def _check_needed(wanted: frozenset[str], *, pdf: bool) -> None:
    """Raise InputError for all packages at once that are missing for what is asked for."""
    from raybundle.report.paper.needed import check_typesetter
    from raybundle.surfaces.products import PRODUCTS

    lacking = dict[str, InputError]()
    for check in (*(PRODUCTS[name].check for name in sorted(wanted)), *([check_typesetter] if pdf else [])):
        try:
            check()
        except InputError as error:
            lacking[str(error)] = error
    if len(lacking) == 1:
        raise next(iter(lacking.values()))
    if lacking:
        raise InputError("package.several_missing", details=map(as_detail, lacking.values()), n=len(lacking))
