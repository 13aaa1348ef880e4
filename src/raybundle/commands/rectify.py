"""`raybundle rectify`: photographs of a plane object to a picture to scale."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.convert import FREE_SCALE_HELP
from raybundle.commands.plane_settings import OF_PLANE, PlaneSettings, plane_in
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.results.record import STATE
from raybundle.settings import ANY, POSITIVE, Range, keywords, made, other_than_usual, path_of, setting

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.io.photos.photo import Photo
    from raybundle.io.pictures.rectified import Rectified
    from raybundle.numerics.arrays import Array
    from raybundle.workflows.object_plane import Plane
    from raybundle.workflows.rectify import Grid, SinglePhoto


OF_PHOTO = ("control", "calibration", "transformation", "mark_sigma")
OF_RESULT = (*OF_PLANE, "photos", "only", "relief", "free_scale")


@dataclass(frozen=True, slots=True, kw_only=True)
class RectifySettings(PlaneSettings):
    """What is brought to scale, and how."""

    source: Path
    """result folder, project of `orient`, or one photograph"""
    out: Path = setting(MISSING, "New picture: .tif, .png or .jpg.", metavar="FILE")
    pixel: float | None = setting(
        None, "Size of a pixel in the object's unit.  [default: that of the photographs]", metavar="SIZE",
        limits=POSITIVE,
    )  # fmt: skip
    extent: tuple[float, float, float, float] | None = setting(
        None, "Part of the plane, in its coordinates; of a map, east and north.  [default: extent of the points]",
        metavar="LEFT BOTTOM RIGHT TOP", limits=(ANY, ANY, ANY, ANY),
    )  # fmt: skip
    photos: tuple[Path, ...] = setting(
        (), "Folder of the photographs.  [default: recorded in the project]", metavar="FOLDER"
    )
    only: tuple[str, ...] = setting((), "Use only these photographs.", metavar="A,B,C,...", joined=True)
    relief: float | None = setting(
        None, "Largest displacement by the relief of a wall, in the object's unit. Beyond it, use `facade`.  "
        "[default: 3 pixels]", metavar="LENGTH", limits=POSITIVE,
    )  # fmt: skip
    control: Path | None = setting(
        None, "For a PHOTO: points of the plane with their image points, as for orient.", metavar="FILE"
    )
    transformation: Literal["projective", "affine"] = setting(
        "projective", "For a PHOTO: transformation. affine: for a distant view or a flat copy."
    )
    calibration: Path | None = setting(
        None, "For a PHOTO: calibration of the lens, to correct distortion.", metavar="CAMERA.toml"
    )
    mark_sigma: float = setting(
        0.5, "For a PHOTO: standard deviation of a marked point.", metavar="PX", limits=Range(low=0.001, high=1e5)
    )
    free_scale: bool = setting(False, FREE_SCALE_HELP)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rectification:
    """A picture to scale, and what it was made by."""

    picture: Rectified
    grid: Grid
    """its pixels in the plane"""
    source: Plane | SinglePhoto
    """the plane of a result's points, or what was fitted to the points of one photograph"""
    unit: str = ""
    """empty: not known, or none"""
    state: str = ""
    """why the result that it was made of is not to be used yet; empty: nothing states it"""
    remarks: tuple[str, ...] = ()


@keywords(RectifySettings)
def rectify(source: str | Path, out: str | Path, *, progress: Progress = silent, **settings: Any) -> Rectification:
    """Bring photographs of a plane object to scale; beside the picture stand a world file and NAME.toml.

    source    result folder or project of `orient`, or one photograph, which needs control="marks.csv"
    out       new picture: .tif, .png or .jpg
    settings  as of the command line, by the names of `RectifySettings`: pixel=0.002, plane=("A", "B", "C")
    raises    InputError for what cannot be read or does not fit together, and where the scale is free

    Limits: what lies off the plane is displaced, and what hides it is in the picture.
    """
    given = {"source": path_of("source", source), "out": path_of("out", out), **settings}
    return run_rectify(made(RectifySettings, given), progress)


def run_rectify(settings: RectifySettings, progress: Progress = silent) -> Rectification:
    """Rectify what the settings ask for, and write the picture."""
    from raybundle.commands.record import known_record
    from raybundle.io.pictures.rectified import check_picture
    from raybundle.workflows.object_plane import MapLevel
    from raybundle.workflows.sources import result_within

    s = settings
    check_picture(s.out)
    if not s.source.exists():
        raise InputError("file.missing", file=s.source)
    if s.source.is_dir():
        _check_without(s, OF_PHOTO, of_result=False)
        done, about = _of_result(s, progress)
        record = known_record(result_within(s.source)).as_mapping()
        record = {**record, **({STATE: done.state} if done.state else {})}
    else:
        _check_without(s, OF_RESULT, of_result=True)
        if s.control is None:
            raise InputError("picture.no_plane_points", file=s.source)
        done, about = _of_photo(s, s.control)
        record = {}
    picture, grid = done.picture, done.grid
    head = {
        "left": grid.left, "top": grid.top, "pixel": grid.pixel, "width_px": grid.width, "height_px": grid.height,
    }  # fmt: skip
    reported = {**head, **about, "photographs": picture.shares}
    wkt = done.source.system.to_wkt() if isinstance(done.source, MapLevel) else ""
    more = picture.write(s.out, left=grid.left, top=grid.top, pixel=grid.pixel, about=reported, wkt=wkt, record=record)
    return replace(done, remarks=(*done.remarks, *more))


def _check_without(s: RectifySettings, names: tuple[str, ...], *, of_result: bool) -> None:
    """Raise InputError where settings are given that belong to the other kind of source."""
    if given := [name for name in names if name in other_than_usual(s)]:
        raise InputError("picture.setting_of_other_source", setting=given[0], result=of_result)


def _of_result(s: RectifySettings, progress: Progress) -> tuple[Rectification, Mapping[str, Any]]:
    """The picture from all photographs of a result, and what NAME.toml states of its plane."""
    import numpy as np

    from raybundle.block.frames import in_file_frames
    from raybundle.io.pictures.plane_file import stations_of
    from raybundle.pipeline.project import photographs_of
    from raybundle.workflows.object_plane import MapLevel
    from raybundle.workflows.rectify import (
        check_area,
        grid_over,
        rectify_block,
        usual_pixel,
        whole_pixels,
    )  # fmt: skip
    from raybundle.workflows.sources import read_source, result_within

    result = result_within(s.source)
    export, _ = read_source(result)
    block = in_file_frames(export.block)
    if block.free_scale and not s.free_scale:
        raise InputError(
            "block.scale_free",
            optional=True,
            file=s.source,
        )
    folders = s.photos or photographs_of(result)
    if not folders:
        raise InputError("photograph.folder_unknown", file=s.source)
    plane, reported = plane_in(result, replace(export, block=block), s, progress)
    pixel = s.pixel or usual_pixel(block, plane)
    area = plane.extent if s.extent is None else np.array(s.extent)
    if isinstance(plane, MapLevel):
        if s.extent is None:
            area = whole_pixels(area, pixel)
        else:
            check_area(plane, area)
    grid = grid_over(area, pixel)
    picture, remarks = rectify_block(
        block, folders, plane, grid, only=s.only, sigma=export.sigma, tolerated=s.relief, progress=progress
    )  # fmt: skip
    unit = "" if block.free_scale else plane.unit if isinstance(plane, MapLevel) else block.length_unit
    state = export.record.get(STATE, "")
    about = {"block": block.name, "unit": unit, **({STATE: state} if state else {}), **_about(plane, picture)}
    if block.free_scale:
        about["scale"] = "free"
    if export.frame is not None:
        about["frame"] = export.frame.as_mapping()
    about["stations"] = stations_of(export, tuple(picture.shares))
    done = Rectification(
        picture=picture, grid=grid, source=plane, unit=unit, state=state, remarks=(*reported, *remarks)
    )
    return done, about


def _about(plane: Plane, picture: Rectified) -> dict[str, Any]:
    """What NAME.toml states of the plane."""
    slope, largest = picture.slope
    return {
        **plane.as_mapping(), "slope_rms": slope, "slope_largest": largest, "displacement_rms": slope * plane.rms,
    }  # fmt: skip


def _of_photo(s: RectifySettings, control: Path) -> tuple[Rectification, Mapping[str, Any]]:
    """The picture from one photograph, and what NAME.toml states of its transformation."""
    import numpy as np

    from raybundle.io.photos.photo import read_photo
    from raybundle.workflows.rectify import fit_photo, grid_over, rectify_photo

    photo = read_photo(s.source)
    camera = None if s.calibration is None else _camera_of(s.calibration, photo)
    names, xyz, xy = _marks(control, s.source)
    single = fit_photo(names, xyz, xy, model=s.transformation, sigma_px=s.mark_sigma, camera=camera)
    grid = grid_over(single.extent if s.extent is None else np.array(s.extent), s.pixel or single.usual_pixel)
    picture = rectify_photo(s.source, single, grid, (photo.width_px, photo.height_px))
    fit = single.fit
    about = {
        "model": fit.model.name, "control_points": len(names), "sigma0": fit.sigma0, "redundancy": fit.redundancy,
        "differences": {n: d.tolist() for n, d in zip(names, single.differences, strict=True)},
    }  # fmt: skip
    return Rectification(picture=picture, grid=grid, source=single), about


def _camera_of(calibration: Path, photo: Photo) -> Camera:
    """The one camera of a file that has the format of a photograph."""
    from raybundle.io.block.toml import read_cameras

    size = (photo.width_px, photo.height_px)
    fitting = [c for c in read_cameras(calibration) if (c.width_px, c.height_px) == size]
    if len(fitting) != 1:
        raise InputError(
            "calibration.no_camera_of_size",
            n=len(fitting),
            width_px=size[0],
            height_px=size[1],
            file=calibration,
        )
    return fitting[0]


def _marks(control: Path, photo: Path) -> tuple[list[str], Array, Array]:
    """Names, coordinates (n, 3) and pixels (n, 2) of the control points marked in this photograph."""
    import numpy as np

    from raybundle.io.geo.control_files import read_control

    file = read_control(control)
    m = file.measurements
    rows = [
        k for k, (name, p) in enumerate(zip(m.image, m.point.tolist(), strict=True))
        if name in {photo.name, photo.stem} and np.isfinite(file.xyz[p, :2]).all()
    ]  # fmt: skip
    if not rows:
        raise InputError("control.none_in_photograph", photograph=photo.name, file=control)
    points = m.point[rows]
    return [file.ids[p] for p in points.tolist()], file.xyz[points], m.xy_px[rows]
