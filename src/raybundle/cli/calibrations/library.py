"""`raybundle calibration add, list, find`: the camera library."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.calibrations import (
    CalibrationAddSettings,
    CalibrationFindSettings,
    CalibrationListSettings,
    run_add,
    run_find,
    run_list,
    write_best,
)
from raybundle.errors import Message, Severity, message_of_text, note, warning
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
    """
    asked = {"source": source, **values_of(CalibrationAddSettings, given)}
    kept = run_add(made(CalibrationAddSettings, asked))
    facts(key=str(kept.key), kept=kept.place)
    report(Summary(
        done=[note("calibration.stored", key=str(kept.key))], files=[kept.place],
        notices=of_texts(kept.remarks, Severity.NOTE),
    ))  # fmt: skip


def _rows(entry: LibraryEntry) -> list[Message | str]:
    c = entry.camera
    return [entry.name, note(
        "calibration.entry", key=str(entry.key), width_px=c.width_px, height_px=c.height_px, model=c.model,
        date=str(entry.date), source=entry.source, photographs=entry.photographs or 0, sigma0=entry.sigma0 or 0.0,
        grade=entry.grade or "none",
    )]  # fmt: skip


@click.command("list", cls=Command)
@click.option("--json", "as_json", is_flag=True, help="Print everything as JSON.")
@options_of(CalibrationListSettings)
def list_(*, as_json: bool, **given: Any) -> None:
    """Show the calibrations of the library.

    \b
    Example:
      raybundle calibration list
    """
    from raybundle.io.cameras.library import as_table

    found = run_list(made(CalibrationListSettings, values_of(CalibrationListSettings, given)))
    if as_json:
        click.echo(json.dumps([as_table(e) for e in found.entries], indent=1))
        return
    report(Summary(
        done=[note("calibration.library", n=len(found.entries), folder=str(found.folder))],
        table=[row for entry in found.entries for row in _rows(entry)],
        notices=[
            warning("calibration.file_unusable", name=path.name, details=[message_of_text(why)])
            for path, why in found.refused
        ],
    ))  # fmt: skip


@click.command("find", cls=Command)
@click.argument("photo", type=FOLDER)
@options_of(CalibrationFindSettings, out=NEW_FILE)
def find(photo: Path, **given: Any) -> int:
    """Find calibrations of the library for a photograph, and reasons against the others.

    Exit status 2 if none does.

    \b
    Example:
      raybundle calibration find images/DSC_0001.JPG
    """
    from raybundle.io.cameras.library import key_of

    settings = made(CalibrationFindSettings, {"photo": photo, **values_of(CalibrationFindSettings, given)})
    found = run_find(settings)
    facts(matches=[{"name": m.entry.name, "fits": m.fits, "reasons": m.reasons} for m in found.matches])
    first = note("calibration.photograph", name=photo.name, key=str(key_of(found.photo)),
                 width_px=found.photo.width_px, height_px=found.photo.height_px)  # fmt: skip
    rows = [
        note("calibration.match", name=m.entry.name, fits=m.fits, reasons="; ".join(m.reasons)) for m in found.matches
    ]  # fmt: skip
    if found.best is None:
        report(Summary(done=[first], table=rows, notices=[warning("calibration.none_fits", name=photo.name)]))
        return 2
    write_best(settings, found)
    report(Summary(done=[first], table=rows, files=[] if settings.out is None else [settings.out]))
    return 0
