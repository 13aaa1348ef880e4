"""`raybundle calibration compare`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Command
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.calibrations import CalibrationCompareSettings, run_compare
from raybundle.errors import Severity, note
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.calibrations import ComparedCalibrations


@click.command("compare", cls=Command)
@click.argument("first", type=FOLDER, metavar="A")
@click.argument("second", type=FOLDER, metavar="B")
@options_of(CalibrationCompareSettings)
@click.option("--json", "as_json", is_flag=True, help="Print everything as JSON, including the map.")
def compare(first: Path, second: Path, *, as_json: bool, **given: Any) -> None:
    """Compare two calibrations: distance of the image points of the same ray, after the best rotation.

    The exterior orientation of a user absorbs this rotation; at --object-distance a translation too.

    \b
    Example:
      raybundle calibration compare may.toml october.toml
      raybundle calibration compare may.toml october.toml --object-distance 5
    """
    asked = {"first": first, "second": second, **values_of(CalibrationCompareSettings, given)}
    settings = made(CalibrationCompareSettings, asked)
    found = run_compare(settings)
    if as_json:
        click.echo(json.dumps(_as_table(found)))
        return
    report(_summary(found, settings.object_distance))


def _as_table(found: ComparedCalibrations) -> dict[str, object]:
    """Everything, for JSON; 0 where there is no shift."""
    import numpy as np

    d = found.difference
    return {
        "rms_px": d.rms, "largest_px": d.largest, "rotation_rad": d.rotation.tolist(),
        "translation": d.translation.tolist(), "xy_px": d.xy_px.tolist(),
        "shift_px": np.where(np.isfinite(d.shift_px), d.shift_px, 0).tolist(),
        "expected_rms_px": found.expected_px, "notes": list(found.notes),
    }  # fmt: skip


def _summary(found: ComparedCalibrations, distance: float | None) -> Summary:
    """What the command reports."""
    import numpy as np

    d, expected_px = found.difference, found.expected_px
    turn = float(np.degrees(np.linalg.norm(d.rotation)))
    done = [note("calibration.difference", infinity=distance is None, distance=distance, turn_deg=turn, rms_px=d.rms,
                 largest_px=d.largest)]  # fmt: skip
    if expected_px is not None and expected_px > 0:
        ratio = float(d.rms / expected_px)
        done.append(note("calibration.expected", expected_px=expected_px, ratio=ratio, same=ratio < 2))
    length = np.linalg.norm(d.shift_px, axis=2)
    rows = [
        " ".join(f"{float(np.nanmax(part)):10.3f}" for part in np.array_split(row, 3, axis=1))
        for row in np.array_split(length, 3, axis=0)
    ]
    return Summary(done=[*done, note("calibration.parts")], table=rows, notices=of_texts(found.notes, Severity.NOTE))
