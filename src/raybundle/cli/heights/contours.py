"""`raybundle heights contours`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, facts
from raybundle.cli.heights.words import free_scale
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.heights.contours import HeightsContoursSettings, run_contours
from raybundle.errors import Severity, note, warning
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
    """
    found = run_contours(made(HeightsContoursSettings, {"source": source, **values_of(HeightsContoursSettings, given)}))
    lines = sum(len(c.lines) for c in found.contours)
    facts(levels=[c.height for c in found.contours], lines=lines, unit=found.unit, files=[str(f) for f in found.files])
    low, high, unit = found.contours[0].height, found.contours[-1].height, found.unit
    close = found.interval < 2 * found.sigma
    wrong = [warning("contours.interval_too_small", interval=found.interval, sigma=found.sigma, unit=unit)]
    report(Summary(
        done=[note("heights.contours", lines=lines, n=len(found.contours), low=low, high=high, unit=unit),
              *free_scale(unit)],
        notices=[*(wrong if close else []), *of_texts(found.cautions, Severity.WARNING)], files=found.files,
    ))  # fmt: skip
