"""`raybundle moved`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import COMMAND_SETTINGS, FOLDER, NEW_FOLDER, common_options
from raybundle.cli.query import SeveralNames
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.moved import MovedSettings, run_moved, words_of
from raybundle.settings import made


@click.command("moved", cls=SeveralNames, context_settings=COMMAND_SETTINGS)
@click.argument("epochs", type=FOLDER, nargs=-1, required=True, metavar="RESULT RESULT...")
@options_of(MovedSettings, out=NEW_FOLDER)
@common_options
def command(epochs: tuple[Path, ...], progress: str, **given: Any) -> None:
    """What has moved between measurements of the same points: a congruence test in the datum of those that stayed.

    Points are the same by their names. Those that stayed are found by the test, with the full covariances of all
    measurements; each measurement is taken as a free network with the scale that it measured. FOLDER gets points.csv
    (displacements, their standard deviations, what could have been found) and moved.json.

    \b
    Example:
      raybundle moved spring-result autumn-result --out since-spring
      raybundle moved spring-result autumn-result --datum A B C D --out since-spring
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    settings = made(MovedSettings, {"epochs": epochs, **values_of(MovedSettings, given)})
    with reporting(progress) as tell:
        done = run_moved(settings, tell)
    click.echo("\n".join(f" {line}" for line in words_of(done)))
    click.echo(f" {settings.out}: points.csv, moved.json")
