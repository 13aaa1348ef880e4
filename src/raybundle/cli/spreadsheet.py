"""`raybundle spreadsheet`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.spreadsheet import SpreadsheetSettings, run_spreadsheet
from raybundle.errors import Severity, note
from raybundle.settings import made


@click.command("spreadsheet", cls=Command)
@click.argument("source", type=FOLDER, metavar="RESULT")
@options_of(SpreadsheetSettings, out=NEW_FILE)
@common_options
def command(source: Path, progress: str, **given: Any) -> None:
    """Write the tables of a result as sheets of one workbook (.xlsx).

    A spreadsheet program of any language reads its numbers correctly. With CSV, some read one column of text. RESULT is
    a result folder, a project, or the folder of `moved`.

    \b
    Example:
      raybundle spreadsheet part-7 --out part-7.xlsx
      raybundle spreadsheet flight --tables map,check --out flight.xlsx
    """
    from raybundle.cli.progress import reporting

    settings = made(SpreadsheetSettings, {"source": source, **values_of(SpreadsheetSettings, given)})
    with reporting(progress) as notify:
        done = run_spreadsheet(settings, notify)
    facts(sheets=list(done.sheets))
    report(Summary(
        done=[note("workbook.written", n=len(done.sheets), names=list(done.sheets))], files=[done.file],
        notices=of_texts(done.left_out, Severity.WARNING),
    ))  # fmt: skip
