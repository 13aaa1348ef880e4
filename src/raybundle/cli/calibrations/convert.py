"""`raybundle calibration convert`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from raybundle.cli.calibrations.given import CAMERA, GIVEN, SIZE, calibrations_of, chosen_of
from raybundle.cli.common import APPROXIMATE, COMMAND_SETTINGS, FOLDER, NEW_FILE, TRACEBACK, significant
from raybundle.cli.numbers import POSITIVE

if TYPE_CHECKING:
    from raybundle.io.calibrations import Conversion


@click.command("convert", context_settings=COMMAND_SETTINGS)
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
    from raybundle.cli.calibrations.stored import calibrations_of_files, with_names  # noqa: PLC0415
    from raybundle.io.calibrations import convert_calibration, write_calibrations  # noqa: PLC0415
    from raybundle.io.calibrations.base import format_named  # noqa: PLC0415

    found = calibrations_of(source, given, size)
    turned = calibrations_of_files(source) if given is None and (source / "result.json").is_file() else ()
    chosen = chosen_of((*found, *turned), camera, source)
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
