"""`raybundle calibration zoom`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.calibrations import ZoomSettings, keep_zoom, run_zoom
from raybundle.errors import note
from raybundle.settings import made


@click.command("zoom", cls=Command)
@click.argument("results", type=FOLDER, nargs=-1, required=True, metavar="RESULT...")
@options_of(ZoomSettings, out=NEW_FOLDER)
def zoom(results: tuple[Path, ...], **given: Any) -> None:
    """Combine calibrations of a zoom lens at several settings into one for every focal length in between.

    RESULT are result folders of `raybundle calibrate`, all with the same --model and --parameters.

    \b
    Example:
      raybundle calibrate 24mm/ --target aicon14 --parameters c,x0,y0,K1,K2,P1,P2 --out z24
      raybundle calibration zoom z24 z35 z50 z70 --out lens --keep
    """
    from raybundle.calibration.zoom import zoom_residuals

    settings = made(ZoomSettings, {"results": results, **values_of(ZoomSettings, given)})
    done = run_zoom(settings)
    lens = done.lens
    low, high = lens.range_mm
    facts(focal_mm=lens.range_mm, symbols=lens.symbols, orders=lens.orders, variance_factor=lens.variance_factor)
    worst = abs(zoom_residuals(lens, done.settings)).max(axis=0)
    report(Summary(
        done=[
            note("zoom.settings", n=len(done.settings), low_mm=low, high_mm=high, resolution_mm=lens.resolution_mm),
            note("zoom.scatter", factor=lens.variance_factor),
        ],
        details=[
            note("zoom.curve", symbol=symbol, order=order, variable=variable, largest=most)
            for symbol, variable, order, most in zip(lens.symbols, lens.variables, lens.orders, worst, strict=True)
        ],
        files=[settings.out, *([keep_zoom(settings, done)] if settings.keep else [])],
    ))  # fmt: skip
