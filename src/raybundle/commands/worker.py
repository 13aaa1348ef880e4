"""`raybundle worker` and `raybundle scheduler`: tasks of a run done by other processes and machines."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError, as_detail
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import NOT_NEGATIVE, Range, setting

if TYPE_CHECKING:
    from raybundle.pipeline.shards import ShardDone

AWAITED_HELP = "Start when so many workers of {cluster} are there."
AWAITED_LIMIT_HELP = "Seconds that workers are waited for. Then the run ends."
"""Of the settings `wait_for_workers` and `wait_limit`, which every command has that takes a cluster with a scheduler"""
DIGITS = 8
"""Of so many and more no array of jobs is: Slurm allows 4 million at most (MaxArraySize)"""


@dataclass(frozen=True, slots=True, kw_only=True)
class WorkerSettings:
    """What a worker works for: a cluster, or a share of the tasks in a project."""

    cluster: str = setting(
        "", "Work for the scheduler of this folder until interrupted. The worker waits for a scheduler, also at first.",
        metavar="FOLDER",
    )  # fmt: skip
    shard: str = setting(
        "", "Do share I of N of the tasks in PROJECT, by their numbers modulo N, and end. For the jobs of an array; "
        "needs no scheduler.", metavar="I/N",
    )  # fmt: skip
    jobs: int = setting(1, "Number of parallel tasks; 0: one per processor.", limits=NOT_NEGATIVE)
    memory: float = setting(
        0.0, "Memory that the parallel tasks of a cluster may take together [GB]; 0: four fifths of the free memory. "
        "A task that needs more than its share goes to another worker.", metavar="GB", limits=NOT_NEGATIVE,
    )  # fmt: skip
    wait: float = setting(
        60.0, "Seconds that a shard waits for results of others. Then it ends with status 5.", metavar="S",
        limits=Range(low=0, high=1e6),
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class SchedulerSettings:
    """How a scheduler is reached."""

    host: str = setting("", "Name or address of this machine for the others.  [default: as it reaches the network]")
    port: int = setting(0, "Port; 0: any free one.", limits=Range(low=0, high=65535))
    dashboard: str = setting(
        "", "Show Dask's dashboard at this port of this machine, or at HOST:PORT. It is not encrypted and has no "
        "password; it needs the package bokeh.", metavar="PORT|HOST:PORT",
    )  # fmt: skip


def run_worker(
    settings: WorkerSettings, project: str | None, notify: Callable[[str], None], progress: Progress = silent
) -> ShardDone | None:
    """Work for a cluster until interrupted (None), or do a share of the tasks in a project."""
    if bool(settings.cluster) == bool(settings.shard):
        raise InputError("worker.cluster_or_shard")
    if settings.cluster:
        from raybundle.pipeline.choosing import on_dask

        if project is not None:
            raise InputError("worker.project_of_cluster", project=project)
        on_dask("dask_machines").work(settings.cluster, settings.jobs, notify, settings.memory * 1e9)
        return None
    from raybundle.pipeline.shards import do_shard

    if project is None:
        raise InputError("worker.project_missing")
    if "://" in project:
        from raybundle.pipeline.confirmed_stores import confirm_store

        confirm_store(project)
    number, of = _share(settings.shard)
    return do_shard(project, number, of, jobs=settings.jobs, wait_s=settings.wait, progress=progress)


def store_of(project: Path, given: str, apart: Sequence[Path]) -> str:
    """Where the products of a run lie: as is stated, or as the last run in its project was reported.

    apart   what the run reads
    raises  InputError where they cannot lie there
    """
    from raybundle.pipeline.project import HERE, store_given
    from raybundle.pipeline.store import whole_url

    remembered = "" if given else store_given(project)
    url = given or remembered
    if url not in {"", HERE}:
        from raybundle.pipeline.confirmed_stores import check_confirmed
        from raybundle.pipeline.objects import refused_url
        from raybundle.pipeline.stores import check_store

        if remembered and "://" in url and not refused_url(url):  # what is no store is refused below
            check_confirmed(url, project / "project.toml")
        try:
            check_store(url, out=project, apart=apart)
        except InputError as error:
            if not remembered:
                raise
            raise InputError(
                "store.of_last_run", details=[as_detail(error)], here=HERE, file=project / "project.toml"
            ) from None
    return whole_url(url)


def _share(text: str) -> tuple[int, int]:
    """Which of how many, from "0/4"."""
    first, _, last = text.partition("/")
    if first.isdecimal() and last.isdecimal() and len(first) <= len(last) < DIGITS and int(first) < int(last):
        return int(first), int(last)
    if last.isdecimal() and len(last) >= DIGITS:
        from raybundle.io.reading.words import quoted

        raise InputError("worker.too_many_shards", share=quoted(text), most=10 ** (DIGITS - 1) - 1)
    raise InputError("worker.shard_form", share=text)


def run_scheduler(settings: SchedulerSettings, folder: Path, notify: Callable[[str], None]) -> None:
    """Be the scheduler of a cluster until interrupted; its folder gets certificates where it has none."""
    from raybundle.pipeline.choosing import on_dask

    on_dask("dask_machines").schedule(folder, settings.host, settings.port, notify, settings.dashboard)
