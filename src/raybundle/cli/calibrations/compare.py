"""`raybundle calibration compare`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Command, significant
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.calibrations import CalibrationCompareSettings, run_compare
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
    """  # noqa: D301
    asked = {"first": first, "second": second, **values_of(CalibrationCompareSettings, given)}
    settings = made(CalibrationCompareSettings, asked)
    found = run_compare(settings)
    if as_json:
        click.echo(json.dumps(_as_table(found)))
        return
    for line in _lines(found, settings.object_distance):
        click.echo(f" {line}")


def _as_table(found: ComparedCalibrations) -> dict[str, object]:
    """Everything, for JSON; 0 where there is no shift."""
    import numpy as np  # noqa: PLC0415

    d = found.difference
    return {
        "rms_px": d.rms, "largest_px": d.largest, "rotation_rad": d.rotation.tolist(),
        "translation": d.translation.tolist(), "xy_px": d.xy_px.tolist(),
        "shift_px": np.where(np.isfinite(d.shift_px), d.shift_px, 0).tolist(),
        "expected_rms_px": found.expected_px, "notes": list(found.notes),
    }  # fmt: skip


def _lines(found: ComparedCalibrations, distance: float | None) -> list[str]:
    """What is printed."""
    import numpy as np  # noqa: PLC0415

    d, expected_px = found.difference, found.expected_px
    turn = float(np.degrees(np.linalg.norm(d.rotation)))
    where = "at infinity" if distance is None else f"at the distance {distance:g}"
    lines = [f"note: {note}" for note in found.notes]
    lines.append(
        f"difference {where}, after a rotation of {turn:.4f} deg: rms {significant(d.rms)} px, largest "
        f"{significant(d.largest)} px"
    )
    if expected_px is not None and expected_px > 0:
        ratio = d.rms / expected_px
        verdict = "as far apart as they may be" if ratio < 2 else "they are not of one camera in one state"
        lines.append(f"their covariances let expect {significant(expected_px)} px: {ratio:.1f} times that, {verdict}")
    lines.append("largest difference [px] in 3 x 3 parts of the format, as seen in the picture:")
    length = np.linalg.norm(d.shift_px, axis=2)
    for row in np.array_split(length, 3, axis=0):
        parts = [float(np.nanmax(part)) for part in np.array_split(row, 3, axis=1)]
        lines.append(" " + " ".join(f"{p:10.3f}" for p in parts))
    return lines
