"""`raybundle sheet`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.sheet import run_drawing_sheet
from raybundle.commands.sheet_settings import DrawingSheetSettings
from raybundle.errors import Severity, note
from raybundle.settings import made


@click.command("sheet", cls=Command)
@click.argument("sources", type=FOLDER, nargs=-1, required=True, metavar="PICTURE|RESULT...")
@options_of(DrawingSheetSettings, out=NEW_FILE)
@common_options
def command(sources: tuple[Path, ...], progress: str, **given: Any) -> None:
    """Draw rectified pictures and measured points and lines on a sheet true to scale.

    PICTURE comes from `rectify` (NAME.toml beside it has its plane) or has a world file. RESULT is a result folder or
    project. Its points and lines are drawn on the picture, or without one on their own plane. The PDF has frame, grid,
    scale bar, title block and legend. Missing entries of the title block come from the project's record.

    \b
    Example:
      raybundle sheet facade.tif facade-project --scale 50 --paper A2 --out facade.pdf
      raybundle sheet facade-project --vertical --out points.pdf
      raybundle sheet ground.tif --scale 200 --several --out plan.pdf
    """
    from raybundle.cli.progress import reporting
    from raybundle.results.state import state_messages

    settings = made(DrawingSheetSettings, {"sources": sources, **values_of(DrawingSheetSettings, given)})
    with reporting(progress) as notify:
        done = run_drawing_sheet(settings, notify)
    facts(scale=done.scale, paper=done.paper, sheets=done.sheets, pictures=done.pictures, points=done.points)
    facts(lines=done.lines)
    report(Summary(
        done=[
            note("drawing_sheet.sheets", scale=done.scale, paper=done.paper, n=done.sheets, columns=done.columns,
                 rows=done.rows),
            note("drawing_sheet.content", pictures=done.pictures, points=done.points, lines=done.lines),
        ],
        notices=[*state_messages(done.state), *of_texts(done.remarks, Severity.NOTE)], files=[done.file],
    ))  # fmt: skip
