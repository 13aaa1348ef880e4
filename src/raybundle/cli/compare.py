"""`raybundle compare`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_PAGE, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.compare import CompareSettings, run_compare
from raybundle.settings import made


@click.command("compare", cls=Command)
@click.argument("first", type=FOLDER, metavar="RESULT")
@click.argument("second", type=FOLDER, metavar="RESULT")
@options_of(CompareSettings, out=NEW_PAGE)
@common_options
def command(first: Path, second: Path, progress: str, **given: Any) -> None:
    """Compare two result folders: statistics, interior orientations, points after a similarity.

    Points are identified by name. Points with a running number (t100) also need agreeing image points.

    \b
    Example:
      raybundle compare camcal21-result free --out camcal21.html
    """  # noqa: D301
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    asked = {"first": first, "second": second, **values_of(CompareSettings, given)}
    settings = made(CompareSettings, asked)
    with reporting(progress) as notify:
        done = run_compare(settings, notify)
    for label, result in zip(("first", "second"), done.results, strict=True):
        sigma0 = result.result["sigma0"]
        text = "none" if sigma0 is None else f"{sigma0:.6g}"
        facts(**{label: {"result": result.path, "sigma0": sigma0, "redundancy": result.result["redundancy"]}})
        click.echo(f" {label}: {result.path}, sigma0 {text}, redundancy {result.result['redundancy']}")
    if done.same:
        facts(same=done.same)
        click.echo(f" {done.same}")
    for caution in done.cautions:
        click.echo(f" warning: {caution}")
    click.echo(f" comparison: {settings.out}")
