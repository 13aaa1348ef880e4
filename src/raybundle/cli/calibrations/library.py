"""`raybundle calibration add, list, find`: the camera library."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, counted, facts, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.calibrations import (
    CalibrationAddSettings,
    CalibrationFindSettings,
    CalibrationListSettings,
    run_add,
    run_find,
    run_list,
    write_best,
)
from raybundle.errors import warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.io.cameras.library import LibraryEntry


@click.command("add", cls=Command)
@click.argument("source", type=FOLDER, metavar="FILE")
@options_of(CalibrationAddSettings)
def add(source: Path, **given: Any) -> None:
    """Store a calibration. FILE is a file of any format, or the result folder of an adjustment (with covariance).

    \b
    Example:
      raybundle calibration add result --photo images/DSC_0001.JPG
    """  # noqa: D301
    asked = {"source": source, **values_of(CalibrationAddSettings, given)}
    kept = run_add(made(CalibrationAddSettings, asked))
    for remark in kept.remarks:
        click.echo(f" note: {remark}")
    facts(key=str(kept.key), kept=kept.place)
    click.echo(f" {kept.key}: kept as {kept.place}")


def _row(entry: LibraryEntry) -> str:
    c = entry.camera
    sigma0 = "" if entry.sigma0 is None else f", sigma0 {significant(entry.sigma0)}"
    count = "" if entry.photographs is None else f", {counted(entry.photographs, 'photograph')}"
    size = f"{c.width_px} x {c.height_px} px"
    verdict = f", called {entry.grade}" if entry.grade else ""
    return f" {entry.name}\n   {entry.key}; {size}, {c.model}; {entry.date}, {entry.source}{count}{sigma0}{verdict}"


@click.command("list", cls=Command)
@click.option("--json", "as_json", is_flag=True, help="Print everything as JSON.")
@options_of(CalibrationListSettings)
def list_(*, as_json: bool, **given: Any) -> None:
    """Show the calibrations of the library.

    \b
    Example:
      raybundle calibration list
    """  # noqa: D301
    from raybundle.io.cameras.library import as_table  # noqa: PLC0415

    found = run_list(made(CalibrationListSettings, values_of(CalibrationListSettings, given)))
    if as_json:
        click.echo(json.dumps([as_table(e) for e in found.entries], indent=1))
        return
    click.echo(f" {counted(len(found.entries), 'calibration')} in {found.folder}")
    for entry in found.entries:
        click.echo(_row(entry))
    for path, why in found.refused:
        click.echo(f" {notice_line(warning('calibration.file_unusable', name=path.name))}\n   {why}")


@click.command("find", cls=Command)
@click.argument("photo", type=FOLDER)
@options_of(CalibrationFindSettings, out=NEW_FILE)
def find(photo: Path, **given: Any) -> int:
    """Find calibrations of the library for a photograph, and reasons against the others.

    Exit status 2 if none does.

    \b
    Example:
      raybundle calibration find images/DSC_0001.JPG
    """  # noqa: D301
    from raybundle.io.cameras.library import key_of  # noqa: PLC0415

    settings = made(CalibrationFindSettings, {"photo": photo, **values_of(CalibrationFindSettings, given)})
    found = run_find(settings)
    facts(matches=[{"name": m.entry.name, "fits": m.fits, "reasons": m.reasons} for m in found.matches])
    click.echo(f" {photo.name}: {key_of(found.photo)}; {found.photo.width_px} x {found.photo.height_px} px")
    for m in found.matches:
        click.echo(f" {'fits' if m.fits else 'no  '} {m.entry.name}: {'; '.join(m.reasons)}")
    if found.best is None:
        click.echo(" the library has no calibration for it; calibrate, then keep it: raybundle calibration add")
        return 2
    write_best(settings, found)
    if settings.out is not None:
        click.echo(f" written: {settings.out}")
    return 0
