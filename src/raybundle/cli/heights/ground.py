"""`raybundle heights ground`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, facts, significant
from raybundle.cli.heights.words import FREE, cautions
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import notice_line
from raybundle.commands.heights.ground import HeightsGroundSettings, run_ground
from raybundle.errors import warning
from raybundle.settings import made

SPANNED = 0.2
"""Share of a ground beyond which the gaps it spans are warned of: what a volume may have of filled holes"""


@click.command("ground", cls=Command)
@click.argument("source", type=FOLDER, metavar="SURFACE")
@options_of(HeightsGroundSettings, out=NEW_FOLDER)
def command(source: Path, **given: Any) -> None:
    """Separate the ground from objects on it, and write a digital terrain model.

    The simple morphological filter (Pingel and others 2013) opens the surface with discs that grow to the width of the
    largest object. A cell is an object if the opening lowers it by more than the slope and the standard deviations
    allow. Below objects, the ground is interpolated, with a standard deviation that grows with the gap. All commands of
    `heights` take the folder.

    \b
    Example:
      raybundle heights ground pit/surface --largest 12 --slope 30
      raybundle heights contours pit/surface/ground --interval 0.5 --out terrain.gpkg
    """  # noqa: D301
    found = run_ground(made(HeightsGroundSettings, {"source": source, **values_of(HeightsGroundSettings, given)}))
    facts(
        folder=str(found.folder), unit=found.unit, standing=found.standing, filled=found.filled, sigma=found.sigma,
        filled_sigma=found.filled_sigma,
    )  # fmt: skip
    unit = f" {found.unit}" if found.unit else ""
    click.echo(f" {found.standing:.1%} of the heights stand on the ground")
    if found.filled:
        click.echo(
            f" ground: sigma {significant(found.sigma)}{unit} in the median where it was measured; {found.filled:.1%} "
            f"of it spans gaps, sigma {significant(found.filled_sigma)}{unit}"
        )
    if found.filled > SPANNED:
        click.echo(f" {notice_line(warning('terrain.spans_gaps', share=found.filled))}")
    if not unit:
        click.echo(f" {FREE}")
    for line in cautions(found.cautions):
        click.echo(f" {line}")
    click.echo(f" {found.folder}")
