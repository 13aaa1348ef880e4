"""Which executor does the tasks of a run, from what its user states of a cluster."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.clusters import cluster_at
from raybundle.pipeline.executors import Executor, Staying, Threads
from raybundle.pipeline.shards import Shards

SHARDS = "shards"


def executor_for(cluster: str, jobs: int, memory: float, progress: Progress = silent) -> Executor:
    """Threads of this process, or those elsewhere.

    cluster  empty: here; "shards"; or a folder or address as `cluster_at` takes it
    jobs     threads here; 0: as many as there are processors
    memory   bytes that tasks in work here may need together; elsewhere it is for who starts the workers
    progress is reported where workers or a scheduler are waited for
    raises   InputError where there is no such cluster, or the extra [cluster] is not installed
    """
    if not cluster:
        return Threads(jobs, memory)
    if cluster == SHARDS:
        return Shards()
    return on_dask().Dask(cluster_at(cluster), progress=progress)


def staying_for(cluster: str, jobs: int, memory: float, progress: Progress = silent) -> Executor:
    """Processes that stay from one list of tasks to the next, here or elsewhere: for sweeps, one behind the other.

    cluster  empty: here; or a folder or address as `cluster_at` takes it
    jobs     processes here; 0: as many as there are processors
    memory   as of `executor_for`
    raises   InputError as `executor_for`, and for shards: there are dozens of sweeps
    """
    if cluster == SHARDS:
        raise InputError("cluster.no_shards")
    return executor_for(cluster, jobs, memory, progress) if cluster else Staying(jobs, memory)


def check_cluster(cluster: str) -> None:
    """Raise InputError as `executor_for` would, before anything is computed."""
    if cluster not in {"", SHARDS}:
        on_dask()
        cluster_at(cluster)


def await_workers(cluster: str, wanted: int, limit_s: float, progress: Progress = silent) -> None:
    """Wait until so many workers of a cluster are there, before anything is computed; 0: for none.

    raises  InputError where they do not come within the limit, as `executor_for`, and where there is no scheduler
    """
    if not wanted:
        return
    if cluster in {"", SHARDS}:
        raise InputError("cluster.nothing_awaited")
    on_dask().await_workers(cluster_at(cluster), wanted, limit_s, progress)


def on_dask(module: str = "on_dask") -> ModuleType:
    """A module that knows Dask; raises InputError where that is not installed."""
    try:
        return import_module(f"raybundle.pipeline.{module}")  # an extra, and a second to load
    except ImportError as error:
        missing = error.name or "distributed"
        raise InputError("cluster.package_missing", package=missing) from None
