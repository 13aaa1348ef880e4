"""`raybundle adjust`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_FOLDER, Command, common_options, print_outcome
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import of_adjustment, report
from raybundle.commands.adjust import AdjustSettings, accuracy_outcome, run_adjust
from raybundle.commands.pages import page_files
from raybundle.errors import phrase
from raybundle.settings import made


@click.command("adjust", cls=Command)
@click.argument("block", type=FOLDER)
@click.option(
    "--out", type=NEW_FOLDER, metavar="RESULT", help="Result folder. An older result is replaced.  [default: the "
    "current result of a project, PROJECT/result; the earlier one is kept in PROJECT/results]",
)  # fmt: skip
@options_of(AdjustSettings)
@common_options
def command(block: Path, out: Path | None, progress: str, **given: Any) -> int:
    """Adjust a block folder and write a result folder with its report.

    By default, nothing is rejected, and exactly the parameters named in block.toml are estimated. BLOCK may also be a
    result folder or a project: its current result is adjusted again.

    \b
    Exit status: 0 a result is written, and its faults are printed (one of them where the iteration did not come
    to an end); 2 bad input, named by file, line and column; 3 not solvable as given, the message names what is
    not determined; 4 the accuracy of --accuracy-class, or of the project, is not kept.

    \b
    Example:
      raybundle adjust camcal21 --out camcal21-result
      raybundle adjust facade-project --reject snooping
      raybundle adjust camcal21 --out free --datum inner --estimate auto --reject snooping
    """
    from raybundle.cli.progress import reporting
    from raybundle.results.project_results import RESULT, project_of
    from raybundle.workflows.unfinished_parts import left_beside

    project = None if out is not None else project_of(block)
    target = out or (block if project is None else project / RESULT)
    settings = made(AdjustSettings, {"block": block, "out": out, **values_of(AdjustSettings, given)})
    try:
        with reporting(progress) as notify:
            adjustment = run_adjust(settings, notify)
    except KeyboardInterrupt:
        kept = left_beside(target)
        if not kept:
            raise
        at = " and ".join(where for left in kept for where in (str(left.folder), *left.stores))
        click.echo(phrase("interruption.kept", folder=str(at)), err=True)
        return 130
    report(of_adjustment(adjustment, [target, *page_files(target, report=settings.report, pdf=settings.pdf)]))
    return print_outcome(accuracy_outcome(settings, adjustment))
