"""`raybundle calibration add, list, find`: the camera library."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.calibrations.given import CAMERA, GIVEN, LIBRARY, SIZE, of_result, one_of, our_camera
from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FILE, TRACEBACK, counted, significant
from raybundle.cli.numbers import POSITIVE
from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.io.cameras.library import LibraryEntry


@click.command("add", context_settings=COMMAND_SETTINGS)
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

    calibration = one_of(source, given, size, camera)
    facts: dict[str, Any] = {"source": str(source.name)}
    if given is None and (source / "result.json").is_file():
        facts = next(f for c, f in of_result(source) if c.id == calibration.id)
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
    own, words = our_camera(calibration)
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


@click.command("list", context_settings=COMMAND_SETTINGS)
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


@click.command("find", context_settings=COMMAND_SETTINGS)
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
