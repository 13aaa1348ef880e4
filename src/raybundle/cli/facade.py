"""`raybundle facade`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.facade import FacadeSettings, run_facade
from raybundle.errors import Message, Severity, note, phrase
from raybundle.settings import made

if TYPE_CHECKING:
    from raybundle.commands.facade import Facade


@click.command("facade", cls=Command)
@click.argument("source", type=FOLDER, metavar="RESULT")
@options_of(FacadeSettings, out=NEW_FOLDER)
@common_options
def command(source: Path, progress: str, **given: Any) -> int:
    """Draw the elevation of a wall with relief.

    RESULT is a result folder or the project of `orient`. The wall is the plumb plane with most object points; --plane,
    --wall or --horizontal choose another. Cornices, reveals and columns stand right: the picture is a true orthophoto
    above the plane. SOURCE/facade has the picture, the sheet to scale (PDF), the drawing with the picture below it
    (DXF), two sections, and the measured surface. A stopped run continues at its last step.

    \b
    Example:
      raybundle facade facade-project
      raybundle facade facade-project --plane A,B,C --scale 50 --paper A2
      raybundle facade facade-project --wall 2 --density 4
    """
    from raybundle.cli.progress import reporting

    settings = made(FacadeSettings, {"source": source, **values_of(FacadeSettings, given)})
    try:
        with reporting(progress) as notify:
            done = run_facade(settings, notify)
    except KeyboardInterrupt:
        click.echo(phrase("interruption.kept", folder=str(settings.out or source / "facade")), err=True)
        return 130
    facts(width=done.grid.width, height=done.grid.height, pixel=done.grid.pixel, unit=done.unit, measured=done.measured,
          filled=done.filled, white=done.white, place_sigma=done.place_sigma, folder=str(done.folder))  # fmt: skip
    if done.sheet is not None:
        facts(scale=done.sheet.scale, paper=done.sheet.paper, lines=done.sheet.lines)
    report(_summary(done))
    return 0


def _summary(done: Facade) -> Summary:
    """What the command reports."""
    from raybundle.numerics.length_units import precision_unit
    from raybundle.results.state import state_messages

    plane, (back, front) = done.plane, done.relief
    lines: list[Message] = [
        note("facade.wall", kind=plane.kind, n=plane.points, of=plane.of, back=back, front=front, unit=done.unit),
        note("facade.picture", width=done.grid.width, height=done.grid.height, pixel=done.grid.pixel, unit=done.unit),
        note("facade.coverage", share=done.measured, filled=done.filled, white=done.white),
    ]  # fmt: skip
    if done.place_sigma > 0:
        factor, unit = precision_unit(done.place_sigma, done.unit)
        lines.append(note("facade.place_sigma", sigma=factor * done.place_sigma, unit=unit))
    if done.sheet is not None:
        s = done.sheet
        lines.append(note("drawing_sheet.sheets", scale=s.scale, paper=s.paper, n=s.sheets, columns=s.columns,
                          rows=s.rows))  # fmt: skip
    return Summary(
        done=lines, files=done.files, details=of_texts(done.surface.remarks),
        notices=[*state_messages(done.state), *done.warnings, *of_texts(done.remarks, Severity.NOTE)],
    )  # fmt: skip
