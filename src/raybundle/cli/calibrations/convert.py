"""`raybundle calibration convert`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.calibrations import CalibrationConvertSettings, converted, write_converted
from raybundle.errors import Message, Severity, note, warning
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.io.calibrations import Conversion


@click.command("convert", cls=Command)
@click.argument("source", type=FOLDER, metavar="INPUT")
@options_of(CalibrationConvertSettings, out=NEW_FILE)
def convert(source: Path, **given: Any) -> None:
    """Convert a calibration; INPUT is a file of any format, or a result folder.

    Photographs of a result that are stored rotated or reduced have their own camera, in their pixels. A format with one
    camera per file gets a second file beside the first, with the camera's name.

    In the same direction, the conversion is exact if the other model has all terms. Otherwise the simplest model within
    0.01 px is used, or else the best; --model chooses one. Deviations above 0.1 px need --approximate.

    \b
    Example:
      raybundle calibration convert camera.yaml --to metashape --out camera.xml
      raybundle calibration convert result --to opencv --model 8 --out camera.yaml
    """
    settings = made(CalibrationConvertSettings, {"source": source, **values_of(CalibrationConvertSettings, given)})
    found = converted(settings)
    files = write_converted(settings, found).files
    facts(files=files, cameras=[
        {
            "camera": c.calibration.id, "model": c.variant, "exact": c.exact, "rms_px": c.rms_px,
            "largest_px": c.largest_px,
        }
        for c in found.conversions
    ])  # fmt: skip
    report(Summary(
        done=[
            note("calibration.converted", camera=c.calibration.id, model=c.variant, exact=c.exact, rms_px=c.rms_px,
                 largest_px=c.largest_px)
            for c in found.conversions
        ],
        notices=[*of_texts(found.cautions, Severity.WARNING), *(m for c in found.conversions for m in _notices(c))],
        files=files,
    ))  # fmt: skip


def _notices(conversion: Conversion) -> list[Message]:
    c = conversion.calibration
    part = [warning("calibration.inverse_in_part", camera=c.id, share=conversion.covered)]
    return [
        *(part if conversion.covered < 1 else []),
        conversion.validity.message,
        *of_texts(c.remarks, Severity.NOTE),
    ]
