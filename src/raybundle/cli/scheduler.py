"""`raybundle scheduler`."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Any

import click

from raybundle.cli.common import FOLDER, Command
from raybundle.cli.settings import options_of, values_of
from raybundle.commands.worker import SchedulerSettings
from raybundle.settings import made


@click.command("scheduler", cls=Command)
@click.argument("cluster", type=FOLDER)
@options_of(SchedulerSettings)
def command(cluster: Path, **given: Any) -> None:
    """Run the scheduler of a cluster until interrupted.

    CLUSTER is a folder that all its machines can access. It gets the address and, if missing, certificates for
    scheduler, workers and runs. Any user who can read it may run programs on the workers.

    \b
    Example:
      raybundle scheduler office-cluster
      raybundle scheduler office-cluster --host 192.168.1.20 --port 8786
    """
    from raybundle.commands.worker import run_scheduler

    with contextlib.suppress(KeyboardInterrupt):  # the way in which it ends
        run_scheduler(
            made(SchedulerSettings, values_of(SchedulerSettings, given)), cluster, lambda line: click.echo(f" {line}")
        )
