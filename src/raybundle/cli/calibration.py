"""`raybundle calibration`: calibrations from and to other programs, compared, and kept in the camera library."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import APPROXIMATE, COMMAND_SETTINGS, FOLDER, NEW_FILE, NEW_FOLDER, counted, significant
from raybundle.cli.numbers import NOT_NEGATIVE, POSITIVE
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.block.zoom import ZoomSetting
    from raybundle.io.calibrations import Calibration, Conversion
    from raybundle.io.cameras.library import CameraKey, LibraryEntry

TRACEBACK = click.option(
    "--traceback", is_flag=True, expose_value=False, help="After an error, show where in the program it arose."
)
SIZE = click.option(
    "--size", nargs=2, type=click.IntRange(1), metavar="WIDTH HEIGHT", help="Format [px], where the file lacks it."
)
GIVEN = click.option("--from", "given", metavar="FORMAT", help="Format of the file.  [default: recognised]")
CAMERA = click.option("--camera", metavar="ID", help="One camera of a file that holds several.")
LIBRARY = click.option(
    "--library", type=FOLDER, metavar="FOLDER", help="The library.  [default: RAYBUNDLE_CAMERAS, or the user's folder]"
)


@click.group("calibration", context_settings=COMMAND_SETTINGS)
def command() -> None:
    """Calibrations of other programs: convert, compare; the camera library: add, list, find.

    \b
    Formats: opencv, opencv-fisheye, colmap, metashape, kalibr, mrcal, australis, photomodeler, micmac, and
    raybundle, our own TOML file.

    Our model corrects the measured point, most programs distort the ideal one: where the direction changes, the
    distortion is fitted over the whole format, and what the fit leaves is printed.

    \b
    Example:
      raybundle calibration convert camera.yaml --to metashape --out camera.xml
      raybundle calibration compare may.toml october.toml
      raybundle calibration add result --photo images/DSC_0001.JPG
      raybundle calibration find images/DSC_0001.JPG
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)


@command.command("convert", context_settings=COMMAND_SETTINGS)
@click.argument("source", type=FOLDER, metavar="INPUT")
@GIVEN
@click.option("--to", "target", required=True, metavar="FORMAT", help="Format to write.")
@click.option("--out", type=NEW_FILE, required=True, metavar="FILE", help="New file; nothing is overwritten.")
@click.option("--model", metavar="NAME", help="Distortion model of FORMAT, as 8 (opencv) or OPENCV (colmap).")
@click.option("--pixel-mm", type=POSITIVE, metavar="MM", help="Size of a pixel, where INPUT does not tell it.")
@SIZE
@CAMERA
@APPROXIMATE
@TRACEBACK
def convert(
    source: Path,
    given: str | None,
    target: str,
    out: Path,
    model: str | None,
    pixel_mm: float | None,
    size: tuple[int, int] | None,
    camera: str | None,
    *,
    approximate: bool,
) -> None:
    """Convert a calibration; INPUT is a file of any format, or a result folder.

    Photographs of a result that are stored turned or reduced have a camera of their own, in their pixels; a format of
    one camera a file gets a second file beside the first, with the camera's name.

    In the same direction the conversion is exact where the other model has all terms. Otherwise the simplest model
    within 0.01 px is taken, or else the best; --model chooses one. What is off by more than 0.1 px is not written
    without --approximate.

    \b
    Example:
      raybundle calibration convert camera.yaml --to metashape --out camera.xml
      raybundle calibration convert result --to opencv --model 8 --out camera.yaml
    """  # noqa: D301
    from raybundle.cli.stored_calibrations import calibrations_of_files, with_names  # noqa: PLC0415
    from raybundle.io.calibrations import convert_calibration, write_calibrations  # noqa: PLC0415
    from raybundle.io.calibrations.base import format_named  # noqa: PLC0415

    found = _calibrations(source, given, size)
    turned = calibrations_of_files(source) if given is None and (source / "result.json").is_file() else ()
    chosen = _chosen((*found, *turned), camera, source)
    conversions = [convert_calibration(c, target, variant=model, pixel_mm=pixel_mm) for c in chosen]
    for conversion in conversions:
        _tell(conversion)
    files = with_names(conversions, {c.id for c in turned}, out, several=format_named(target).several)
    for path, held in files:
        write_calibrations(target, held, path, approximate=approximate)
        click.echo(f" {target}: {path}")


def _tell(conversion: Conversion) -> None:
    c = conversion.calibration
    how = (
        "exact"
        if conversion.exact
        else f"fitted over the format: rms {significant(conversion.rms_px)} px, "
        f"largest {significant(conversion.largest_px)} px"
    )
    click.echo(f" camera {c.id}: {conversion.variant}, {how}")
    if conversion.covered < 1:
        click.echo(f" caution: its distortion has an inverse over {conversion.covered:.1%} of the format alone")
    click.echo(f" {'remark' if conversion.validity.whole_format else 'caution'}: {conversion.validity}")
    for remark in c.remarks:
        click.echo(f" remark: {remark}")


def _calibrations(source: Path, given: str | None, size: tuple[int, int] | None) -> tuple[Calibration, ...]:
    from raybundle.io.calibrations import read_calibrations  # noqa: PLC0415

    if given is None and (source / "result.json").is_file():
        return tuple(c for c, _ in _of_result(source))
    return read_calibrations(source, given, size_px=size)


def _of_result(folder: Path) -> list[tuple[Calibration, dict[str, Any]]]:
    """The adjusted cameras of a result folder with their covariance, and what the library wants to know of them."""
    import numpy as np  # noqa: PLC0415  (nothing numeric is loaded for the help)

    from raybundle.io.calibrations import Calibration  # noqa: PLC0415
    from raybundle.results.folder import read_result  # noqa: PLC0415

    result = read_result(folder)
    images = result.block.images
    found: list[tuple[Calibration, dict[str, Any]]] = []
    for k, camera in enumerate(result.block.cameras):
        table: dict[str, dict[str, float]] = result.result.get("correlations", {}).get(camera.id, {})
        free = tuple(table)
        std = [result.result["cameras"][camera.id][s]["std"] for s in free]
        covariance = None
        if free and all(s is not None for s in std):
            covariance = np.array([[table[a][b] for b in free] for a in free]) * np.outer(std, std)
        verdict: dict[str, Any] = result.result.get("calibration", {}).get(camera.id, {})
        facts = {
            "sigma0": result.result.get("sigma0"),
            "photographs": int(verdict.get("photographs", (np.asarray(images.camera) == k).sum())),
            "grade": verdict.get("grade", ""),
            "source": f"adjustment {folder.name} of {result.block.name}",
        }
        calibration = Calibration(
            id=camera.id,
            camera=camera,
            pixel_mm=camera.pixel_mm,
            free=free if covariance is not None else (),
            covariance=covariance,
        )
        found.append((calibration, facts))
    return found


def _chosen(found: tuple[Calibration, ...], id_: str | None, source: Path) -> tuple[Calibration, ...]:
    if id_ is None:
        return found
    chosen = tuple(c for c in found if c.id == id_)
    if not chosen:
        raise InputError(f"holds no camera {id_!r}; known: {', '.join(c.id for c in found)}", file=source)
    return chosen


def _one(source: Path, given: str | None, size: tuple[int, int] | None, id_: str | None) -> Calibration:
    found = list(_chosen(_calibrations(source, given, size), id_, source))
    if len(found) != 1:
        raise InputError(
            f"holds {len(found)} cameras ({', '.join(c.id for c in found)}); choose one: --camera", file=source
        )
    return found[0]


def _our_camera(calibration: Calibration) -> tuple[Camera, str]:
    """The calibration as one of our cameras, and what the fit left, in words."""
    from raybundle.block import Camera  # noqa: PLC0415
    from raybundle.io.calibrations import convert_calibration  # noqa: PLC0415

    conversion = convert_calibration(calibration, "raybundle")
    camera = conversion.calibration.camera
    assert isinstance(camera, Camera)
    words = "" if conversion.exact else f"camera {calibration.id} was fitted: largest {conversion.largest_px:.2g} px"
    return camera, words


@command.command("compare", context_settings=COMMAND_SETTINGS)
@click.argument("first", type=FOLDER, metavar="A")
@click.argument("second", type=FOLDER, metavar="B")
@click.option("--distance", type=POSITIVE, metavar="D", help="Of the object; else infinity.")
@click.option("--json", "as_json", is_flag=True, help="Everything, the map too, as JSON.")
@SIZE
@CAMERA
@TRACEBACK
def compare(
    first: Path,
    second: Path,
    distance: float | None,
    size: tuple[int, int] | None,
    camera: str | None,
    *,
    as_json: bool,
) -> None:
    """Say how far apart two calibrations place the image of the same ray, after the best rotation.

    The rotation is what the exterior orientation of a user takes up; at --distance a translation too.

    \b
    Example:
      raybundle calibration compare may.toml october.toml
      raybundle calibration compare may.toml october.toml --distance 5
    """  # noqa: D301
    import numpy as np  # noqa: PLC0415

    from raybundle.calibration.maps import calibration_difference, projection_uncertainty, scaled  # noqa: PLC0415

    cameras: list[Camera] = []
    notes: list[str] = []
    expected: float | None = 0.0
    for path in (first, second):
        one = _one(path, None, size, camera)
        own, words = _our_camera(one)
        notes += [f"{path}: {words}"] if words else []
        if cameras and (own.width_px, own.height_px) != (cameras[0].width_px, cameras[0].height_px):
            notes.append(
                f"{path} is of {own.width_px} x {own.height_px} px; it is compared as if its pictures were reduced or "
                f"enlarged as a whole to {cameras[0].width_px} x {cameras[0].height_px} px"
            )
            own = scaled(own, cameras[0].width_px, cameras[0].height_px)
        cameras.append(own)
        if one.covariance is None or words:
            expected = None
        elif expected is not None:
            spread = projection_uncertainty(own, one.free, one.covariance, distance=distance).covariance
            expected += float(np.nanmean(np.trace(spread, axis1=2, axis2=3)))
    a, b = cameras
    d = calibration_difference(a, b, distance=distance)
    length = np.linalg.norm(d.shift_px, axis=2)
    expected_px = None if expected is None else float(np.sqrt(expected))
    if as_json:
        values = {
            "rms_px": d.rms, "largest_px": d.largest, "rotation_rad": d.rotation.tolist(),
            "translation": d.translation.tolist(), "xy_px": d.xy_px.tolist(),
            "shift_px": np.where(np.isfinite(d.shift_px), d.shift_px, 0).tolist(),
            "expected_rms_px": expected_px, "notes": notes,
        }  # fmt: skip
        click.echo(json.dumps(values))
        return
    for note in notes:
        click.echo(f" remark: {note}")
    turn = float(np.degrees(np.linalg.norm(d.rotation)))
    where = "at infinity" if distance is None else f"at the distance {distance:g}"
    click.echo(f" difference {where}, after a rotation of {turn:.4f} deg: rms {significant(d.rms)} px, "
               f"largest {significant(d.largest)} px")  # fmt: skip
    if expected_px is not None and expected_px > 0:
        ratio = d.rms / expected_px
        verdict = "as far apart as they may be" if ratio < 2 else "they are not of one camera in one state"
        click.echo(f" their covariances let expect {significant(expected_px)} px: {ratio:.1f} times that, {verdict}")
    click.echo(" largest difference [px] in 3 x 3 parts of the format, as seen in the picture:")
    for row in np.array_split(length, 3, axis=0):
        parts = [float(np.nanmax(part)) for part in np.array_split(row, 3, axis=1)]
        click.echo("  " + " ".join(f"{p:10.3f}" for p in parts))


@command.command("add", context_settings=COMMAND_SETTINGS)
@click.argument("source", type=FOLDER, metavar="FILE")
@GIVEN
@click.option("--photo", type=FOLDER, help="A photograph of the set: make, model, serial, lens, focal length, focus.")
@click.option("--make", help="Instead, or in place of what the photograph says.")
@click.option("--model", help="As --make.")
@click.option("--serial", help="As --make.")
@click.option("--lens", help="As --make.")
@click.option("--focal", type=POSITIVE, metavar="MM", help="EXIF focal length; as --make.")
@click.option("--focus", type=POSITIVE, metavar="M", help="Distance to which the lens was focused; as --make.")
@click.option("--date", help="Of the calibration.  [default: today]")
@SIZE
@CAMERA
@LIBRARY
@TRACEBACK
def add(
    source: Path,
    given: str | None,
    photo: Path | None,
    make: str | None,
    model: str | None,
    serial: str | None,
    lens: str | None,
    focal: float | None,
    focus: float | None,
    date: str | None,
    size: tuple[int, int] | None,
    camera: str | None,
    library: Path | None,
) -> None:
    """Keep a calibration; FILE is a file of any format, or the result folder of an adjustment (with covariance).

    \b
    Example:
      raybundle calibration add result --photo images/DSC_0001.JPG
    """  # noqa: D301
    from dataclasses import replace  # noqa: PLC0415

    from raybundle.io.cameras.library import CameraKey, LibraryEntry, add_entry, key_of  # noqa: PLC0415
    from raybundle.io.photos.photo import read_photo  # noqa: PLC0415

    calibration = _one(source, given, size, camera)
    facts: dict[str, Any] = {"source": str(source.name)}
    if given is None and (source / "result.json").is_file():
        facts = next(f for c, f in _of_result(source) if c.id == calibration.id)
    key = CameraKey()
    if photo is not None:
        taken = read_photo(photo)
        key = key_of(taken)
        c = calibration.camera
        if (taken.width_px, taken.height_px) != (c.width_px, c.height_px):
            raise InputError(
                f"has {taken.width_px} x {taken.height_px} px, the calibration {c.width_px} x {c.height_px}; give a "
                "photograph of the set that was calibrated",
                file=photo,
            )
    told = {"make": make, "model": model, "serial": serial, "lens": lens, "focal_mm": focal, "focus_m": focus}
    key = replace(key, **{k: v for k, v in told.items() if v is not None})
    own, words = _our_camera(calibration)
    kept = calibration.covariance if own == calibration.camera else None
    entry = LibraryEntry(
        key=key,
        camera=own,
        free=calibration.free if kept is not None else (),
        covariance=kept,
        date=date or datetime.now(UTC).date().isoformat(),
        **facts,
    )
    place = add_entry(entry, library)
    for remark in (*calibration.remarks, *([words] if words else [])):
        click.echo(f" remark: {remark}")
    click.echo(f" {key}: kept as {place}")


def _row(entry: LibraryEntry) -> str:
    c = entry.camera
    sigma0 = "" if entry.sigma0 is None else f", sigma0 {significant(entry.sigma0)}"
    count = "" if entry.photographs is None else f", {counted(entry.photographs, 'photograph')}"
    size = f"{c.width_px} x {c.height_px} px"
    verdict = f", called {entry.grade}" if entry.grade else ""
    return f" {entry.name}\n   {entry.key}; {size}, {c.model}; {entry.date}, {entry.source}{count}{sigma0}{verdict}"


@command.command("list", context_settings=COMMAND_SETTINGS)
@click.option("--json", "as_json", is_flag=True, help="Everything as JSON.")
@LIBRARY
@TRACEBACK
def list_(library: Path | None, *, as_json: bool) -> None:
    """Show the calibrations of the library.

    \b
    Example:
      raybundle calibration list
    """  # noqa: D301
    from raybundle.io.cameras.library import as_table, read_library  # noqa: PLC0415

    found = read_library(library)
    if as_json:
        click.echo(json.dumps([as_table(e) for e in found.entries], indent=1))
        return
    click.echo(f" {counted(len(found.entries), 'calibration')} in {found.folder}")
    for entry in found.entries:
        click.echo(_row(entry))
    for path, why in found.refused:
        click.echo(f" caution: {path.name} cannot be used: {why}")


@command.command("find", context_settings=COMMAND_SETTINGS)
@click.argument("photo", type=FOLDER)
@click.option("--out", type=NEW_FILE, metavar="FILE", help="Write the best one as a file for --calibration.")
@LIBRARY
@TRACEBACK
def find(photo: Path, out: Path | None, library: Path | None) -> int:
    """Say which calibrations of the library serve a photograph, and why the others do not.

    Exit status 2 if none does.

    \b
    Example:
      raybundle calibration find images/DSC_0001.JPG
    """  # noqa: D301
    from raybundle.io.calibrations.base import write_whole  # noqa: PLC0415
    from raybundle.io.calibrations.ours import cameras_text  # noqa: PLC0415
    from raybundle.io.cameras.library import find_calibrations, key_of  # noqa: PLC0415
    from raybundle.io.photos.photo import read_photo  # noqa: PLC0415

    taken = read_photo(photo)
    click.echo(f" {photo.name}: {key_of(taken)}; {taken.width_px} x {taken.height_px} px")
    matches = find_calibrations(taken, library)
    for m in matches:
        click.echo(f" {'fits' if m.fits else 'no  '} {m.entry.name}: {'; '.join(m.reasons)}")
    best = matches[0].camera if matches else None
    if best is None:
        click.echo(" the library has no calibration for it; calibrate, then keep it: raybundle calibration add")
        return 2
    if out is not None:
        if out.exists():
            raise InputError("stands there already and is not overwritten; choose another name", file=out)
        write_whole(out, cameras_text([best]))
        click.echo(f" written: {out}")
    return 0


@command.command("zoom", context_settings=COMMAND_SETTINGS)
@click.argument("results", type=FOLDER, nargs=-1, required=True, metavar="RESULT...")
@click.option(
    "--out", type=NEW_FOLDER, required=True, metavar="FOLDER", help="New folder for camera.toml and zoom.toml."
)
@click.option(
    "--focal", type=POSITIVE, multiple=True, metavar="MM",
    help="EXIF focal length of each camera in its order, where the photographs do not tell it.",
)  # fmt: skip
@click.option("--resolution", type=NOT_NEGATIVE, metavar="MM", help="Step of the focal lengths; 0: not rounded.")
@click.option("--keep", is_flag=True, help="Keep it in the camera library, where orient finds it for any focal length.")
@LIBRARY
@TRACEBACK
def zoom(
    results: tuple[Path, ...], out: Path, focal: tuple[float, ...], resolution: float | None, library: Path | None,
    *, keep: bool,
) -> None:  # fmt: skip
    """Combine calibrations of a zoom lens at several settings into one for every focal length in between.

    RESULT are result folders of `raybundle calibrate`, all with the same --model and --estimate.

    \b
    Example:
      raybundle calibrate 24mm/ --target aicon14 --estimate c,x0,y0,K1,K2,P1,P2 --out z24
      raybundle calibration zoom z24 z35 z50 z70 --out lens --keep
    """  # noqa: D301
    from raybundle.calibration.zoom import calibrate_zoom, zoom_residuals  # noqa: PLC0415
    from raybundle.io.cameras.library import LibraryEntry, add_entry  # noqa: PLC0415
    from raybundle.io.cameras.zoom_files import write_zoom  # noqa: PLC0415
    from raybundle.io.folders import new_folder  # noqa: PLC0415

    settings, keys = _zoom_settings(results, focal)
    lens = calibrate_zoom(sorted(settings, key=lambda s: s.focal_mm), resolution_mm=resolution)
    if out.exists():
        raise InputError("stands there already and is not overwritten; choose another name", file=out)
    with new_folder(out) as folder:
        write_zoom(lens, folder)
    low, high = lens.range_mm
    rounded = f"rounded to {lens.resolution_mm:g} mm" if lens.resolution_mm else "not rounded"
    click.echo(f" {len(settings)} settings from {low:g} to {high:g} mm, focal lengths {rounded}")
    worst = abs(zoom_residuals(lens, sorted(settings, key=lambda s: s.focal_mm))).max(axis=0)
    for symbol, variable, order, most in zip(lens.symbols, lens.variables, lens.orders, worst, strict=True):
        click.echo(f"  {symbol}: order {order} in {variable}, largest residual {most:.2g}")
    click.echo(f" scatter about the curves: {lens.variance_factor:.2f} times what the calibrations' variances allow")
    click.echo(f" written: {out}")
    if keep:
        key = keys[0]
        if any((k.make, k.model, k.serial, k.lens) != (key.make, key.model, key.serial, key.lens) for k in keys):
            raise InputError("the settings are of different cameras or lenses by their EXIF; not kept")
        entry = LibraryEntry(
            key=_any_focal(key), camera=lens.camera, zoom=lens, date=datetime.now(UTC).date().isoformat(),
            source=f"zoom calibration of {len(settings)} settings",
        )  # fmt: skip
        click.echo(f" kept in the camera library: {add_entry(entry, library)}")


def _any_focal(key: CameraKey) -> CameraKey:
    """The key of a zoom lens: that of a setting without its focal length and focus."""
    from dataclasses import replace  # noqa: PLC0415

    return replace(key, focal_mm=None, focus_m=None)


def _zoom_settings(results: tuple[Path, ...], focal: tuple[float, ...]) -> tuple[list[ZoomSetting], list[CameraKey]]:
    """The settings and EXIF keys of all cameras in some result folders."""
    from raybundle.block.zoom import ZoomSetting  # noqa: PLC0415
    from raybundle.io.cameras.library import CameraKey  # noqa: PLC0415
    from raybundle.results.folder import read_result  # noqa: PLC0415

    settings: list[ZoomSetting] = []
    keys: list[CameraKey] = []
    for folder in results:
        told = read_result(folder).result.get("calibration", {})
        for calibration, _ in _of_result(folder):
            if calibration.covariance is None:
                raise InputError(
                    f"camera {calibration.id} has no covariance; calibrate it with statistics", file=folder
                )
            exif: dict[str, Any] = told.get(calibration.id, {}).get("exif", {})
            key = CameraKey(**exif)
            at = focal[len(settings)] if len(focal) > len(settings) else key.focal_mm
            if at is None:
                raise InputError(
                    f"the EXIF focal length of camera {calibration.id} is not known; give one --focal for each camera",
                    file=folder,
                )
            own, _ = _our_camera(calibration)
            settings.append(
                ZoomSetting(
                    focal_mm=at, camera=own, free=calibration.free, covariance=calibration.covariance,
                    focus_m=key.focus_m,
                )
            )  # fmt: skip
            keys.append(key)
    return settings, keys
