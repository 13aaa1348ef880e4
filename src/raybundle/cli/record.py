"""`raybundle record`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, Command, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.record import RecordSettings, rows, run_record
from raybundle.settings import made


@click.command("record", cls=Command)
@click.argument("project", type=FOLDER)
@options_of(RecordSettings)
def command(project: Path, **given: Any) -> None:
    """Show the recording sheet of a project, or write entries of it: object, place, client, operator, rights ...

    The entries are in the table [record] of PROJECT/project.toml. Edit it by hand if you like; runs of `orient` keep
    it. They appear in record.toml of the result, in its report, in drawings, maps and sheets made from it. Facts from
    the photographs (camera, dates, number) are filled in automatically. An empty TEXT removes an entry. --new begins a
    new PROJECT, so that its first report is complete.

    \b
    Example:
      raybundle record facade-project
      raybundle record facade-project --object "Town hall, south side" --client "Monument office" --rights "CC BY 4.0"
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)
    reported = run_record(made(RecordSettings, {"project": project, **values_of(RecordSettings, given)}))
    facts(record={name: words for name, words, _ in rows(reported)}, files=reported.files)
    for name, words, source in rows(reported):
        first, *more = words.split("\n")
        click.echo(f" {name:<12} {first}" + (f"  [{source}]" if source else ""))
        for line in more:
            click.echo(f" {'':<12} {line}")
    if not reported.record.as_mapping():
        click.echo(" nothing is written yet; see raybundle record --help")
    if reported.files:
        run = "after the next run of orient" if (project / "result").is_dir() else "when orient has run there"
        click.echo(f" written: {', '.join(map(str, reported.files))}; the report has it {run}")
