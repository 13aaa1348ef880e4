"""`raybundle epochs`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import NEW_FOLDER, Command, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import of_adjustment, report
from raybundle.commands.epochs import EXCEEDED, EpochsSettings, messages_of, run_epochs
from raybundle.commands.pages import page_files
from raybundle.errors import phrase
from raybundle.settings import made


@click.command("epochs", cls=Command)
@click.argument("project", type=NEW_FOLDER)
@options_of(EpochsSettings)
@common_options
def command(project: Path, progress: str, **given: Any) -> int:
    """Adjust photographs of several dates together and detect what moved between them.

    PROJECT holds the photographs of all dates. A further date is matched with the earlier ones; nothing of these is
    matched again. Stable points are found by a congruence test with the covariances between the dates. They carry the
    datum and become one point of all dates; moved points have a place at each date. Tables: displacements.csv,
    epochs.json.

    \b
    Exit status: 0 adjusted; 2 bad input; 3 no two photographs fit; 6 a displacement exceeds --limit.

    \b
    Example:
      raybundle epochs dam --add may/ --date 2026-05-01 --add june/ --date 2026-06-01
      raybundle epochs dam --add july/ --limit 10mm --confidence 0.99
      raybundle epochs dam --group rock:R1,R2,R3 --group wall:outline.csv
    """
    from raybundle.cli.progress import reporting

    settings = made(EpochsSettings, {"out": project, **values_of(EpochsSettings, given)})
    try:
        with reporting(progress) as notify:
            done = run_epochs(settings, notify)
    except KeyboardInterrupt:
        click.echo(phrase("interruption.kept", folder=str(project)), err=True)
        return 130
    first, grave = messages_of(done, settings)
    result = project / "result"
    files = [result, *page_files(result, report=settings.report, pdf=settings.pdf)]
    if done.movements is not None:
        files.append(result / "displacements.csv")
    report(of_adjustment(done.adjustment, files, done=first, notices=grave))
    return EXCEEDED if done.exceeded else 0
