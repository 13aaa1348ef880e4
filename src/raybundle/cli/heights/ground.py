"""`raybundle heights ground`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, facts
from raybundle.cli.heights.words import free_scale
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.heights.ground import HeightsGroundSettings, run_ground
from raybundle.errors import Severity, note, warning
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
    """
    found = run_ground(made(HeightsGroundSettings, {"source": source, **values_of(HeightsGroundSettings, given)}))
    facts(
        folder=str(found.folder), unit=found.unit, standing=found.standing, filled=found.filled, sigma=found.sigma,
        filled_sigma=found.filled_sigma,
    )  # fmt: skip
    gaps = note(
        "heights.gaps", share=found.filled, sigma=found.sigma, sigma_gaps=found.filled_sigma, unit=found.unit
    )  # fmt: skip
    wrong = [warning("terrain.spans_gaps", share=found.filled)] if found.filled > SPANNED else []
    report(Summary(
        done=[note("heights.ground", share=found.standing), *([gaps] if found.filled else []), *free_scale(found.unit)],
        notices=[*wrong, *of_texts(found.cautions, Severity.WARNING)], files=[found.folder],
    ))  # fmt: skip
