"""`raybundle datum`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.marks_settings import DatumSettings
from raybundle.errors import note


@click.command("datum", cls=Command)
@click.argument("result", type=FOLDER)
@options_of(DatumSettings)
@click.option(
    "--out",
    type=NEW_FOLDER,
    required=True,
    metavar="FOLDER",
    help="Output folder for points.csv and transformation.json.",
)
def command(result: Path, out: Path, **given: Any) -> None:
    """Transform points of a result to axes defined by points: origin, X axis, XY plane or a level.

    Writes a folder with points.csv (coordinates, standard deviations, covariances) and transformation.json (rotation
    and translation). The errors of these points are carried into all coordinates; scale and residuals stay.

    \b
    Example:
      raybundle datum facade-project --origin A --axis B --plane C --out facade-axes
      raybundle datum pond-project --origin A --axis B --level W1 --level W2 --level W3 --out pond-axes
    """
    from raybundle.commands.marks import transform_to_points

    transform_to_points(result, out, **values_of(DatumSettings, given))
    files = [out / "points.csv", out / "transformation.json"]
    report(Summary(done=[note("block.transformed", **values_of(DatumSettings, given))], files=files))
