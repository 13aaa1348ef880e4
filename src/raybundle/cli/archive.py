"""`raybundle archive`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FILE, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.archive import ArchiveSettings, run_archive
from raybundle.errors import Severity, note
from raybundle.settings import made


@click.command("archive", cls=Command)
@click.argument("source", type=FOLDER, metavar="PROJECT")
@options_of(ArchiveSettings, out=NEW_FILE)
@common_options
def command(source: Path, progress: str, **given: Any) -> None:
    """Write a project as one package for deposit: result, record, parameters, checksums.

    The package is a ZIP file and an RO-Crate: ro-crate-metadata.json describes it for repositories. The record is that
    of `raybundle record`.

    \b
    Example:
      raybundle archive facade-project --out facade.zip --with-photographs
    """
    from raybundle.cli.progress import reporting

    settings = made(ArchiveSettings, {"source": source, **values_of(ArchiveSettings, given)})
    with reporting(progress) as notify:
        done = run_archive(settings, notify)
    facts(files=done.files, bytes=done.bytes)
    report(Summary(
        done=[note("deposit.written", n=done.files, mb=done.bytes / 1e6)], files=[done.file],
        notices=of_texts(done.notices, Severity.WARNING),
    ))  # fmt: skip
