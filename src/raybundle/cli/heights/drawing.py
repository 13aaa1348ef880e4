"""`raybundle heights drawing`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, facts
from raybundle.cli.heights.words import free_scale
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.heights.drawing import HeightsDrawingSettings, run_drawing
from raybundle.errors import Severity, note, warning
from raybundle.settings import made


@click.command("drawing", cls=Command)
@click.argument("source", type=FOLDER, metavar="SURFACE")
@options_of(HeightsDrawingSettings, out=NEW_FILE)
def command(source: Path, **given: Any) -> None:
    """Write lines and areas drawn on a surface for CAD and GIS, with heights, lengths and areas.

    They are drawn in the studio (Products, Plan) or by `raybundle mark draw`.

    \b
    Example:
      raybundle heights drawing pit-project/surface --out plan.dxf --out plan.gpkg
    """
    done = run_drawing(made(HeightsDrawingSettings, {"source": source, **values_of(HeightsDrawingSettings, given)}))
    facts(drawings=list(done.names), layers=list(done.layers), files=[str(f) for f in done.files])
    notices = (
        [warning("surface_drawing.heights_between", n=len(done.between), names=list(done.between))]
        if done.between
        else []
    )
    if done.without:
        notices.append(warning("surface_drawing.left_out", n=len(done.without), names=list(done.without)))
    others = [note("surface_drawing.others", n=done.others)] if done.others else []
    report(Summary(
        done=[note("surface_drawing.written", n=len(done.names), layers=list(done.layers)), *others,
              *free_scale(done.unit)],
        notices=[*notices, *of_texts(done.cautions, Severity.WARNING)], files=done.files,
    ))  # fmt: skip
