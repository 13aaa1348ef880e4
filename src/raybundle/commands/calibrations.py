"""`raybundle calibration convert | compare | add | list | find | zoom`: calibrations, and the camera library."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import MISSING, dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.commands.calibration_files import (
    calibrations_of,
    calibrations_of_files,
    chosen_of,
    of_result,
    one_of,
    our_camera,
    with_names,
)
from raybundle.commands.convert import APPROXIMATE_HELP
from raybundle.errors import InputError, Text, named, phrase
from raybundle.io.folders import check_free
from raybundle.settings import NOT_NEGATIVE, POSITIVE, Range, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.block.zoom import ZoomCalibration, ZoomSetting
    from raybundle.calibration.maps import CalibrationDifference
    from raybundle.io.calibrations import Calibration, Conversion
    from raybundle.io.cameras.library import CameraKey, Library, Match
    from raybundle.io.photos.photo import Photo

FROM_HELP = "Format of the file.  [default: recognised]"
SIZE_HELP = "Format [px], if the file lacks it.  [x>=1]"
CAMERA_HELP = "Name of one camera, if the file has several."
LIBRARY_HELP = "Folder of the camera library.  [default: RAYBUNDLE_CAMERAS, or the user's folder]"
PIXEL = Range(low=1)


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationConvertSettings:
    """What calibration is converted, into what."""

    source: Path
    """file of any format, or a result folder"""
    read_as: str | None = setting(None, FROM_HELP, flag="from", metavar="FORMAT")
    to: str = setting(MISSING, "Format to write.", metavar="FORMAT")
    out: Path = setting(MISSING, "New file; nothing is overwritten.", metavar="FILE")
    model: str | None = setting(None, "Distortion model of FORMAT, e.g. 8 (opencv) or OPENCV (colmap).", metavar="NAME")
    pixel_mm: float | None = setting(None, "Pixel size, if INPUT lacks it.", metavar="MM", limits=POSITIVE)
    format: tuple[int, int] | None = setting(None, SIZE_HELP, metavar="WIDTH HEIGHT", limits=(PIXEL, PIXEL))
    camera: str | None = setting(None, CAMERA_HELP, metavar="ID")
    approximate: bool = setting(False, APPROXIMATE_HELP)


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationCompareSettings:
    """Which two calibrations are compared, and where."""

    first: Path
    """file of any format, or a result folder"""
    second: Path
    object_distance: float | None = setting(
        None, "Distance of the object. Without it: infinity.", metavar="D", limits=POSITIVE
    )
    format: tuple[int, int] | None = setting(None, SIZE_HELP, metavar="WIDTH HEIGHT", limits=(PIXEL, PIXEL))
    camera: str | None = setting(None, CAMERA_HELP, metavar="ID")


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationAddSettings:
    """Settings of a calibration to store, with the entries that identify it."""

    source: Path
    """file of any format, or a result folder"""
    read_as: str | None = setting(None, FROM_HELP, flag="from", metavar="FORMAT")
    photo: Path | None = setting(None, "Photograph of the set, for make, model, serial, lens, focal length and focus.")
    camera_make: str | None = setting(None, "Camera make, instead of the photograph's entry.")
    camera_model: str | None = setting(None, "Camera model, instead of the photograph's entry.")
    serial: str | None = setting(None, "Serial number of the camera, instead of the photograph's entry.")
    lens: str | None = setting(None, "Name of the lens, instead of the photograph's entry.")
    focal: float | None = setting(
        None, "EXIF focal length, instead of the photograph's entry.", metavar="MM", limits=POSITIVE
    )
    focus: float | None = setting(
        None, "Focus distance of the lens, instead of the photograph's entry.", metavar="M", limits=POSITIVE
    )
    date: str | None = setting(None, "Date of the calibration.  [default: today]")
    format: tuple[int, int] | None = setting(None, SIZE_HELP, metavar="WIDTH HEIGHT", limits=(PIXEL, PIXEL))
    camera: str | None = setting(None, CAMERA_HELP, metavar="ID")
    library: Path | None = setting(None, LIBRARY_HELP, metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationListSettings:
    """Which library is shown."""

    library: Path | None = setting(None, LIBRARY_HELP, metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationFindSettings:
    """For which photograph a calibration is looked for."""

    photo: Path
    """photograph"""
    out: Path | None = setting(None, "Write the best calibration as a file for {calibration}.", metavar="FILE")
    library: Path | None = setting(None, LIBRARY_HELP, metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoomSettings:
    """Which calibrations of a zoom lens are combined."""

    results: tuple[Path, ...]
    """result folders of `calibrate`"""
    out: Path = setting(MISSING, "New folder for camera.toml and zoom.toml.", metavar="FOLDER")
    focal: tuple[float, ...] = setting(
        (), "EXIF focal length of each camera in order, if the photographs lack it.", metavar="MM",
        limits=POSITIVE,
    )  # fmt: skip
    resolution: float | None = setting(
        None, "Step of the focal lengths; 0: not rounded.", metavar="MM", limits=NOT_NEGATIVE
    )
    keep: bool = setting(False, "Store it in the camera library. orient finds it there for any focal length.")
    library: Path | None = setting(None, LIBRARY_HELP, metavar="FOLDER")


@dataclass(frozen=True, slots=True, kw_only=True)
class ConvertedCalibrations:
    """Calibrations in another format, and the files that hold them."""

    conversions: tuple[Conversion, ...]
    """one a camera; each states how far it deviates"""
    files: tuple[Path, ...]
    cautions: tuple[str, ...]
    """stored ways of photographs that no camera could be made for"""
    of_files: frozenset[str]
    """ids of the cameras of photographs that are stored turned or reduced"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ComparedCalibrations:
    """How far apart two calibrations place the image of the same ray."""

    difference: CalibrationDifference
    expected_px: float | None
    """rms difference that their covariances let expect; None where one has none"""
    notes: tuple[str, ...]
    """what was assumed"""


@dataclass(frozen=True, slots=True, kw_only=True)
class KeptCalibration:
    """An entry of the camera library."""

    key: CameraKey
    """by what it is found again"""
    place: Path
    remarks: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundCalibrations:
    """What the camera library has for a photograph."""

    photo: Photo
    matches: tuple[Match, ...]
    """the best first, each with its reasons"""

    @property
    def best(self) -> Camera | None:
        """The camera to be taken; None: the library has none for it."""
        return self.matches[0].camera if self.matches else None


@dataclass(frozen=True, slots=True, kw_only=True)
class ZoomLens:
    """A calibration for every focal length between those of some settings."""

    lens: ZoomCalibration
    settings: tuple[ZoomSetting, ...]
    """by focal length"""
    keys: tuple[CameraKey, ...]
    """what the photographs of each say, in the order of the results"""


@keywords(CalibrationConvertSettings)
def convert_calibration(source: str | Path, out: str | Path, *, to: str, **settings: Any) -> ConvertedCalibrations:
    """Convert a calibration to the format of another program.

    source    file of any format, or a result folder
    out       new file; photographs that are stored turned or reduced have a second one where a file holds one camera
    to        "opencv", "metashape", "colmap" ..., "raybundle"
    settings  as of the command line, by the names of `CalibrationConvertSettings`: model="8", camera="nikon"
    raises    InputError for what cannot be read or written, and where a camera would deviate by more than 0.1 px
    """
    given = {"source": path_of("source", source), "out": path_of("out", out), "to": to, **settings}
    asked = made(CalibrationConvertSettings, given)
    return write_converted(asked, converted(asked))


@keywords(CalibrationCompareSettings)
def compare_calibrations(first: str | Path, second: str | Path, **settings: Any) -> ComparedCalibrations:
    """How far apart two calibrations place the image of the same ray, after the best rotation.

    first, second  files of any format, or result folders
    settings       as of the command line, by the names of `CalibrationCompareSettings`: object_distance=5.0
    raises         InputError for what cannot be read, and for a file of several cameras where none is named
    """
    given = {"first": path_of("first", first), "second": path_of("second", second), **settings}
    return run_compare(made(CalibrationCompareSettings, given))


@keywords(CalibrationAddSettings)
def keep_calibration(source: str | Path, **settings: Any) -> KeptCalibration:
    """Store a calibration in the camera library.

    source    file of any format, or the result folder of an adjustment (with covariance)
    settings  as of the command line, by the names of `CalibrationAddSettings`: photo="images/DSC_0001.JPG"
    raises    InputError for an unreadable source, and for a calibration without identifying entries
    """
    return run_add(made(CalibrationAddSettings, {"source": path_of("source", source), **settings}))


@keywords(CalibrationListSettings)
def kept_calibrations(**settings: Any) -> Library:
    """The calibrations of the camera library.

    settings  as of the command line, by the names of `CalibrationListSettings`: library="cameras"
    """
    return run_list(made(CalibrationListSettings, settings))


@keywords(CalibrationFindSettings)
def find_calibration(photo: str | Path, **settings: Any) -> FoundCalibrations:
    """Which calibrations of the camera library serve a photograph, and why the others do not.

    photo     photograph
    settings  as of the command line, by the names of `CalibrationFindSettings`: out="camera.toml"
    raises    InputError for a photograph that cannot be read
    """
    asked = made(CalibrationFindSettings, {"photo": path_of("photo", photo), **settings})
    found = run_find(asked)
    write_best(asked, found)
    return found


@keywords(ZoomSettings)
def calibrate_zoom(results: Sequence[str | Path], out: str | Path, **settings: Any) -> ZoomLens:
    """Combine calibrations of a zoom lens at several settings into one for every focal length in between.

    results   result folders of `calibrate`, all with the same model and parameters
    out       new folder for camera.toml and zoom.toml
    settings  as of the command line, by the names of `ZoomSettings`: focal=(24.0, 35.0), keep=True
    raises    InputError where the settings are too few or do not belong together
    """
    given = {"results": tuple(Path(r) for r in results), "out": path_of("out", out), **settings}
    asked = made(ZoomSettings, given)
    done = run_zoom(asked)
    if asked.keep:
        keep_zoom(asked, done)
    return done


def converted(settings: CalibrationConvertSettings) -> ConvertedCalibrations:
    """The conversions that are asked for; nothing is written."""
    from raybundle.io.calibrations import convert_calibration as as_format

    s = settings
    found = calibrations_of(s.source, s.read_as, s.format)
    of_a_result = s.read_as is None and (s.source / "result.json").is_file()
    turned, cautions = calibrations_of_files(s.source) if of_a_result else ((), ())
    chosen = chosen_of((*found, *turned), s.camera, s.source)
    return ConvertedCalibrations(
        conversions=tuple(as_format(c, s.to, variant=s.model, pixel_mm=s.pixel_mm) for c in chosen), files=(),
        cautions=cautions, of_files=frozenset(c.id for c in turned),
    )  # fmt: skip


def write_converted(settings: CalibrationConvertSettings, found: ConvertedCalibrations) -> ConvertedCalibrations:
    """Write the conversions."""
    from raybundle.io.calibrations import write_calibrations
    from raybundle.io.calibrations.base import format_named

    s = settings
    files = with_names(found.conversions, found.of_files, s.out, several=format_named(s.to).several)
    for path, held in files:
        write_calibrations(s.to, held, path, approximate=s.approximate)
    return replace(found, files=tuple(path for path, _ in files))


def run_compare(settings: CalibrationCompareSettings) -> ComparedCalibrations:
    """Compare what the settings ask for."""
    import numpy as np

    from raybundle.calibration.maps import calibration_difference, projection_uncertainty, scaled

    distance = settings.object_distance
    cameras: list[Camera] = []
    notes: list[str] = []
    expected: float | None = 0.0
    for path in (settings.first, settings.second):
        one = one_of(path, None, settings.format, settings.camera)
        own, fitted = our_camera(one)
        notes += [Text.of(named(str(path), fitted))] if fitted else []
        if cameras and (own.width_px, own.height_px) != (cameras[0].width_px, cameras[0].height_px):
            notes.append(
                phrase(
                    "calibration_remark.scaled", name=str(path), width_px=own.width_px, height_px=own.height_px,
                    other_width_px=cameras[0].width_px, other_height_px=cameras[0].height_px,
                )
            )  # fmt: skip
            own = scaled(own, cameras[0].width_px, cameras[0].height_px)
        cameras.append(own)
        if one.covariance is None or fitted:
            expected = None
        elif expected is not None:
            spread = projection_uncertainty(own, one.free, one.covariance, distance=distance).covariance
            expected += float(np.nanmean(np.trace(spread, axis1=2, axis2=3)))
    a, b = cameras
    d = calibration_difference(a, b, distance=distance)
    return ComparedCalibrations(
        difference=d, expected_px=None if expected is None else math.sqrt(expected), notes=tuple(notes)
    )


def run_add(settings: CalibrationAddSettings) -> KeptCalibration:
    """Keep what the settings name."""
    from raybundle.io.cameras.library import LibraryEntry, add_entry

    s = settings
    calibration = one_of(s.source, s.read_as, s.format, s.camera)
    facts: dict[str, Any] = {"source": str(s.source.name)}
    if s.read_as is None and (s.source / "result.json").is_file():
        facts = next(f for c, f in of_result(s.source) if c.id == calibration.id)
    key = _key(s, calibration)
    own, fitted = our_camera(calibration)
    kept = calibration.covariance if own == calibration.camera else None
    entry = LibraryEntry(
        key=key, camera=own, free=calibration.free if kept is not None else (), covariance=kept,
        date=s.date or _today(), **facts,
    )  # fmt: skip
    place = add_entry(entry, s.library)
    return KeptCalibration(key=key, place=place, remarks=(*calibration.remarks, *([fitted] if fitted else [])))


def _key(s: CalibrationAddSettings, calibration: Calibration) -> CameraKey:
    """By what a calibration is found again: what the photograph states, and what is stated in its place."""
    from raybundle.io.cameras.library import CameraKey, key_of
    from raybundle.io.photos.photo import read_photo

    key = CameraKey()
    if s.photo is not None:
        taken = read_photo(s.photo)
        key = key_of(taken)
        c = calibration.camera
        if (taken.width_px, taken.height_px) != (c.width_px, c.height_px):
            raise InputError(
                "photograph.size_of_calibration",
                width_px=taken.width_px,
                height_px=taken.height_px,
                camera_width_px=c.width_px,
                camera_height_px=c.height_px,
                file=s.photo,
            )
    reported = {
        "make": s.camera_make, "model": s.camera_model, "serial": s.serial, "lens": s.lens, "focal_mm": s.focal,
        "focus_m": s.focus,
    }  # fmt: skip
    return replace(key, **{k: v for k, v in reported.items() if v is not None})


def run_list(settings: CalibrationListSettings) -> Library:
    """Read the library."""
    from raybundle.io.cameras.library import read_library

    return read_library(settings.library)


def run_find(settings: CalibrationFindSettings) -> FoundCalibrations:
    """Look for what serves the photograph; nothing is written."""
    from raybundle.io.cameras.library import find_calibrations
    from raybundle.io.photos.photo import read_photo

    taken = read_photo(settings.photo)
    return FoundCalibrations(photo=taken, matches=tuple(find_calibrations(taken, settings.library)))


def write_best(settings: CalibrationFindSettings, found: FoundCalibrations) -> None:
    """Write the camera to be taken, where there is one and it is asked for."""
    from raybundle.io.calibrations.base import write_whole
    from raybundle.io.calibrations.ours import cameras_text

    if settings.out is None or found.best is None:
        return
    check_free(settings.out)
    write_whole(settings.out, cameras_text([found.best]))


def run_zoom(settings: ZoomSettings) -> ZoomLens:
    """Combine what the settings name, and write it."""
    from raybundle.calibration.zoom import calibrate_zoom as combined
    from raybundle.io.cameras.zoom_files import write_zoom
    from raybundle.io.folders import new_folder

    s = settings
    found, keys = _zoom_settings(s.results, s.focal)
    ordered = tuple(sorted(found, key=lambda z: z.focal_mm))
    lens = combined(ordered, resolution_mm=s.resolution)
    check_free(s.out)
    with new_folder(s.out) as folder:
        write_zoom(lens, folder)
    return ZoomLens(lens=lens, settings=ordered, keys=tuple(keys))


def keep_zoom(settings: ZoomSettings, done: ZoomLens) -> Path:
    """Keep a zoom lens in the camera library; raises InputError where its settings are of different lenses."""
    from raybundle.io.cameras.library import LibraryEntry, add_entry

    key = done.keys[0]
    if any((k.make, k.model, k.serial, k.lens) != (key.make, key.model, key.serial, key.lens) for k in done.keys):
        raise InputError("zoom.lenses_differ")
    entry = LibraryEntry(
        key=replace(key, focal_mm=None, focus_m=None), camera=done.lens.camera, zoom=done.lens, date=_today(),
        source=f"zoom calibration of {len(done.settings)} settings",
    )  # fmt: skip
    return add_entry(entry, settings.library)


def _today() -> str:
    return datetime.now(UTC).date().isoformat()


def _zoom_settings(results: tuple[Path, ...], focal: tuple[float, ...]) -> tuple[list[ZoomSetting], list[CameraKey]]:
    """The settings and EXIF keys of all cameras in some result folders."""
    from raybundle.block.zoom import ZoomSetting
    from raybundle.io.cameras.library import CameraKey
    from raybundle.results.folder import read_result

    settings: list[ZoomSetting] = []
    keys: list[CameraKey] = []
    for folder in results:
        reported = read_result(folder).result.get("calibration", {})
        for calibration, _ in of_result(folder):
            if calibration.covariance is None:
                raise InputError("camera.no_covariance", camera=calibration.id, file=folder)
            exif: dict[str, Any] = reported.get(calibration.id, {}).get("exif", {})
            key = CameraKey(**exif)
            at = focal[len(settings)] if len(focal) > len(settings) else key.focal_mm
            if at is None:
                raise InputError(
                    "zoom.focal_length_unknown",
                    camera=calibration.id,
                    file=folder,
                )
            own, _ = our_camera(calibration)
            settings.append(
                ZoomSetting(
                    focal_mm=at, camera=own, free=calibration.free, covariance=calibration.covariance,
                    focus_m=key.focus_m,
                )
            )  # fmt: skip
            keys.append(key)
    return settings, keys
