"""`raybundle calibration compare`."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING

import click

from raybundle.cli.calibrations.given import CAMERA, SIZE, one_of, our_camera
from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, TRACEBACK, significant
from raybundle.cli.numbers import POSITIVE

if TYPE_CHECKING:
    from raybundle.block import Camera
    from raybundle.calibration.maps import CalibrationDifference


@click.command("compare", context_settings=COMMAND_SETTINGS)
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
    d, expected_px, notes = _difference((first, second), size, camera, distance)
    if as_json:
        click.echo(json.dumps(_as_table(d, expected_px, notes)))
        return
    for line in _lines(d, expected_px, notes, distance):
        click.echo(f" {line}")


def _difference(
    files: tuple[Path, Path], size: tuple[int, int] | None, camera: str | None, distance: float | None
) -> tuple[CalibrationDifference, float | None, list[str]]:
    """How two calibrations differ, what their covariances let expect [px], and what was assumed."""
    import numpy as np  # noqa: PLC0415  (nothing numeric is loaded for the help)

    from raybundle.calibration.maps import calibration_difference, projection_uncertainty, scaled  # noqa: PLC0415

    cameras: list[Camera] = []
    notes: list[str] = []
    expected: float | None = 0.0
    for path in files:
        one = one_of(path, None, size, camera)
        own, words = our_camera(one)
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
    return d, None if expected is None else math.sqrt(expected), notes


def _as_table(d: CalibrationDifference, expected_px: float | None, notes: list[str]) -> dict[str, object]:
    """Everything, for JSON; 0 where there is no shift."""
    import numpy as np  # noqa: PLC0415

    return {
        "rms_px": d.rms, "largest_px": d.largest, "rotation_rad": d.rotation.tolist(),
        "translation": d.translation.tolist(), "xy_px": d.xy_px.tolist(),
        "shift_px": np.where(np.isfinite(d.shift_px), d.shift_px, 0).tolist(),
        "expected_rms_px": expected_px, "notes": notes,
    }  # fmt: skip


def _lines(d: CalibrationDifference, expected_px: float | None, notes: list[str], distance: float | None) -> list[str]:
    """What is printed."""
    import numpy as np  # noqa: PLC0415

    turn = float(np.degrees(np.linalg.norm(d.rotation)))
    where = "at infinity" if distance is None else f"at the distance {distance:g}"
    lines = [f"remark: {note}" for note in notes]
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
