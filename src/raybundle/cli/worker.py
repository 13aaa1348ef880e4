"""`raybundle worker`."""

from __future__ import annotations

import contextlib
from dataclasses import replace
from typing import Any

import click

from raybundle.cli.common import Command, common_options
from raybundle.cli.settings import options_of, values_of
from raybundle.cli.summary import Summary, report
from raybundle.commands.worker import WorkerSettings
from raybundle.errors import Severity, note
from raybundle.settings import made

WAITING = 5
"""Exit status where tasks wait for what others make"""


@click.command("worker", cls=Command)
@click.argument("project", required=False)
@options_of(WorkerSettings)
@common_options
def command(project: str | None, progress: str, **given: Any) -> int:
    """Do tasks of runs on other machines: for a scheduler, or a share of the tasks in PROJECT.

    All machines need the project and photographs under the same paths, and the same version of raybundle. If the
    products of a project are in an object store, its URL replaces PROJECT. The result does not depend on the worker of
    a task.

    \b
    Exit status of a share: 0 all of it is done (what could not be is reported by the run that wanted it); 2 bad input;
    5 some of it waits for what other shares make.

    \b
    Example:
      raybundle worker --cluster office-cluster --jobs 8
      raybundle worker facade-project --shard 0/4
      raybundle worker s3://surveys/facade --shard 0/4
    """
    from raybundle.cli.progress import reporting
    from raybundle.commands.worker import run_worker

    settings = made(WorkerSettings, values_of(WorkerSettings, given))
    done = None
    with contextlib.ExitStack() as stack:
        if settings.cluster:
            stack.enter_context(contextlib.suppress(KeyboardInterrupt))  # the way in which it ends
        notify = stack.enter_context(reporting(progress))
        done = run_worker(settings, project, lambda line: click.echo(f" {line}"), notify)
    if done is None:
        return 0
    report(Summary(
        done=[note("task_share.done", n=done.made, waiting=done.waiting)],
        notices=[
            replace(note("task_share.failed", name=name), severity=Severity.WARNING, details=(why,))
            for name, why in done.failed
        ],
        next_step=note("task_share.again") if done.waiting else None,
    ))  # fmt: skip
    return WAITING if done.waiting else 0
