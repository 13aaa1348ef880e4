"""`raybundle status`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from raybundle.cli.common import FOLDER, Command, counted, facts, significant

if TYPE_CHECKING:
    from raybundle.commands.status import Status


@click.command("status", cls=Command)
@click.argument("project", type=FOLDER)
def command(project: Path) -> None:
    """Show the stages of a project folder, calibration or surface, and products of the last run.

    Also shown: progress of a running stage, reused products, place and size of the products. A project with a surface
    shows both. A result folder shows the remaining parts of an interrupted adjustment beside it.

    \b
    Example:
      raybundle status facade-project
    """  # noqa: D301
    from raybundle.commands.status import status_of  # noqa: PLC0415  (what computes is loaded after the help)

    found = status_of(project)
    facts(
        stages=found.stages, running=found.running, works=found.works, listed=found.listed, store=found.store,
        bytes=found.bytes, left=found.left, outgrown=found.outgrown, surface=found.surface,
    )  # fmt: skip
    for line in lines(found):
        click.echo(line)


def lines(found: Status) -> Iterator[str]:
    """The status in words."""
    width = max([12, *map(len, found.stages)])
    if found.stages:
        yield f" {'stage':{width}s} {'seconds':>8s} {'CPU s':>8s} {'memory':>8s}  finished"
    for name, r in found.stages.items():
        if r is None:
            yield f" {name:{width}s} {'-':>8s} {'-':>8s} {'-':>8s}  not done"
            continue
        source = "from cache" if r.from_cache else r.finished.replace("T", " ").rstrip("Z")
        figures = f"{r.seconds:8.1f} {r.cpu_seconds:8.1f} {r.peak_memory_mb:6.0f}MB"
        yield f" {name:{width}s} {figures}  {source}  {r.summary}".rstrip()
    if found.elsewhere:
        yield " CPU s and memory are those of the machine where the command ran; what workers took is not counted"
    at = found.running
    if at is not None:
        how = "in work" if found.works else "cut short" if found.listed is None else "waits for shards"
        yield f" {how}: {at.stage}, {at.done} of {at.total} done ({at.noted})"
    elif found.works:
        yield " a run works in it now"
    if found.listed is not None:
        done, total = found.listed
        yield f" for shards: {counted(total, 'task')} in the list, {done} of them done"
    if found.stages:
        where = f"{found.store}, which the next run takes too; " if found.store else ""
        yield f" products: {where}in its folder {_size(found.bytes)}"
    if found.outgrown:
        yield f" warning: {found.outgrown}"
    if found.folder is not None and found.written and not found.works:
        yield f" {found.folder} may be deleted: what is measured stays, and the next run measures all of it again"
    if found.surface is not None:
        yield " surface:"
        yield from lines(found.surface)
    for left in found.left:
        what = "that works now" if left.in_use else "that was cut short: the same command goes on, or delete the folder"
        others = f", and in {', '.join(left.stores)}" if left.stores else ""
        yield f" {left.folder}: parts of an adjustment {what} ({_size(left.bytes)}{others})"


def _size(taken: float) -> str:
    for unit, size in (("GB", 1e9), ("MB", 1e6)):
        if taken >= size:
            return f"{significant(taken / size, 3)} {unit}"
    return f"{significant(taken / 1e3, 3)} kB"
