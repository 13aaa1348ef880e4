"""`raybundle compare`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, NEW_PAGE, Command, common_options, facts
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.commands.compare import CompareSettings, run_compare
from raybundle.errors import Message, Severity, note
from raybundle.settings import made


@click.command("compare", cls=Command)
@click.argument("first", type=FOLDER, metavar="RESULT")
@click.argument("second", type=FOLDER, required=False, metavar="[RESULT]")
@options_of(CompareSettings, out=NEW_PAGE)
@common_options
def command(first: Path, second: Path | None, progress: str, **given: Any) -> None:
    """Compare two result folders: statistics, interior orientations, points after a similarity.

    A project stands for its current result; a project alone is compared with its result before that.

    Points are identified by name. Points with a running number (t100) also need agreeing image points.

    \b
    Example:
      raybundle compare camcal21-result free --out camcal21.html
      raybundle compare facade-project
    """
    from raybundle.cli.progress import reporting

    asked = {"first": first, "second": second, **values_of(CompareSettings, given)}
    settings = made(CompareSettings, asked)
    with reporting(progress) as notify:
        done = run_compare(settings, notify)
    lines: list[Message] = []
    for label, result in zip(("first", "second"), done.results, strict=True):
        found = {name: result.result[name] for name in ("sigma0", "redundancy")}
        facts(**{label: {"result": result.path, **found}})
        lines.append(note("comparison.result", name=str(result.path), known=found["sigma0"] is not None, **found))
    if done.same:
        facts(same=done.same)
    report(Summary(
        done=[*lines, *of_texts([done.same] if done.same else [])], files=[settings.out],
        notices=of_texts(done.cautions, Severity.WARNING),
    ))  # fmt: skip
