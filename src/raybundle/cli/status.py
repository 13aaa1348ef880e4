"""`raybundle status`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from raybundle.cli.common import FOLDER, Command, facts, significant
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.errors import Message, Severity, note

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
    """
    from raybundle.commands.status import status_of

    found = status_of(project)
    facts(
        stages=found.stages, running=found.running, works=found.works, listed=found.listed, store=found.store,
        bytes=found.bytes, left=found.left, outgrown=found.outgrown, surface=found.surface,
        results=found.results,
    )  # fmt: skip
    report(Summary(done=[], table=list(rows(found, project)), notices=of_texts(outgrown(found), Severity.WARNING)))


def outgrown(found: Status) -> list[str]:
    """That what is shown was made of an earlier adjustment."""
    own = [found.outgrown] if found.outgrown else []
    return own if found.surface is None else [*own, *outgrown(found.surface)]


def rows(found: Status, project: Path) -> Iterator[Message | str]:
    """The stages, and what is known of the run."""
    width = max([16, *map(len, found.stages)])
    if found.stages:
        yield f"{'stage':{width}s} {'seconds':>8s} {'CPU s':>8s} {'memory':>8s}  finished"
    for name, r in found.stages.items():
        if r is None:
            yield f"{name:{width}s} {'-':>8s} {'-':>8s} {'-':>8s}  not done"
            continue
        source = "from cache" if r.from_cache else r.finished.replace("T", " ").rstrip("Z")
        figures = f"{r.seconds:8.1f} {r.cpu_seconds:8.1f} {r.peak_memory_mb:6.0f}MB"
        yield f"{name:{width}s} {figures}  {source}  {r.summary}".rstrip()
    if found.elsewhere:
        yield note("project_status.without_workers", shards=found.elsewhere == "shards")
    at = found.running
    if at is not None:
        state = "working" if found.works else "stopped" if found.listed is None else "waiting"
        yield note(
            "project_status.running", state=state, stage=at.stage, done=at.done, total=at.total, at=str(at.noted)
        )  # fmt: skip
    elif found.works:
        yield note("project_status.works")
    if found.listed is not None:
        done, total = found.listed
        yield note("project_status.listed", n=total, done=done)
    if found.stages:
        yield note("project_status.products", size=_size(found.bytes), store=found.store or "none")
    if found.results:
        yield f"{'result':{width}s} {'made by':>8s} {'sigma0':>8s} {'scale':>8s}  written"
    for k in found.results:
        name = k.path.name if k.path.parent == project else f"{k.path.parent.name}/{k.path.name}"
        sigma0 = "-" if k.sigma0 is None else f"{k.sigma0:.4f}"
        written = k.written.replace("T", " ").rstrip("Z")
        yield f"{name:{width}s} {k.by:>8s} {sigma0:>8s} {'yes' if k.scale else 'no':>8s}  {written}"
    if found.folder is not None and found.written and not found.works:
        yield note("project_status.deletable", folder=str(found.folder))
    if found.surface is not None:
        yield note("project_status.surface")
        yield from rows(found.surface, project)
    for left in found.left:
        yield note("project_status.parts", folder=str(left.folder), in_use=left.in_use, size=_size(left.bytes),
                   n=len(left.stores), stores=list(left.stores))  # fmt: skip


def _size(taken: float) -> str:
    for unit, size in (("GB", 1e9), ("MB", 1e6)):
        if taken >= size:
            return f"{significant(taken / size, 3)} {unit}"
    return f"{significant(taken / 1e3, 3)} kB"
