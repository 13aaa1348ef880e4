"""`raybundle heights contours`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, counted, facts
from raybundle.cli.heights.words import FREE, cautions
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.heights.contours import HeightsContoursSettings, run_contours
from raybundle.errors import warning
from raybundle.settings import made


@click.command("contours", cls=Command)
@click.argument("source", type=FOLDER, metavar="SURFACE")
@options_of(HeightsContoursSettings, out=NEW_FILE)
def command(source: Path, **given: Any) -> None:
    """Write contour lines with their heights, for GIS and CAD.

    Heights are smoothed within their standard deviations. Edges stay sharp, and even ground gets even lines. --rough
    keeps measured heights.

    \b
    Example:
      raybundle heights contours pit/surface --interval 0.5 --out contours.gpkg
      raybundle heights contours facade-project/surface --interval 0.01 --out relief.svg --out relief.dxf
    """  # noqa: D301
    found = run_contours(made(HeightsContoursSettings, {"source": source, **values_of(HeightsContoursSettings, given)}))
    lines = sum(len(c.lines) for c in found.contours)
    facts(levels=[c.height for c in found.contours], lines=lines, unit=found.unit, files=[str(f) for f in found.files])
    low, high = found.contours[0].height, found.contours[-1].height
    unit = f" {found.unit}" if found.unit else ""
    click.echo(f" {counted(lines, 'line')} of {counted(len(found.contours), 'height')}, {low:.6g} to {high:.6g}{unit}")
    if found.interval < 2 * found.sigma:
        close = warning("contours.interval_too_small", interval=found.interval, sigma=found.sigma, unit=found.unit)
        click.echo(f" {notice_line(close)}")
    if not unit:
        click.echo(f" {FREE}")
    for line in cautions(found.cautions):
        click.echo(f" {line}")
    for path in found.files:
        click.echo(f" {path}")
