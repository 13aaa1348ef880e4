"""`raybundle record`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, Command, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.record import RecordSettings, rows, run_record
from raybundle.errors import note
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
    """
    reported = run_record(made(RecordSettings, {"project": project, **values_of(RecordSettings, given)}))
    facts(record={name: words for name, words, _ in rows(reported)}, files=reported.files)
    table = list[str]()
    for name, words, source in rows(reported):
        first, *more = words.split("\n")
        table += [f"{name:<12} {first}" + (f"  [{source}]" if source else ""), *(f"{'':<12} {line}" for line in more)]
    empty = [] if reported.record.as_mapping() else [note("record.empty")]
    step = note("record.next", oriented=(project / "result").is_dir()) if reported.files else None
    report(Summary(done=empty, table=table, next_step=step, files=reported.files))
