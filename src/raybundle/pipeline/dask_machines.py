"""Scheduler and workers of a cluster: processes of Dask distributed that a user starts, and that hold for long."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from dask import config
from distributed import Nanny, Scheduler, Security

from raybundle.errors import InputError, Text, message_of_text, note, phrase, text_of_error
from raybundle.numerics.machine import available_memory
from raybundle.pipeline.clusters import (
    CERTIFICATES,
    Cluster,
    NoScheduler,
    check_answers,
    check_certificates,
    cluster_at,
    signature,
    write_scheduler,
)
from raybundle.pipeline.on_dask import COUNTS, LOOK_S, PATIENCE_S, announced, quiet, security_of
from raybundle.pipeline.store import writing

TELL_S = 60.0
"""Between two lines of a worker that say what it has done."""
MOST_PORT = 65535
SHARE = 0.8
"""Of the free memory that tasks may take where nothing is stated"""
FOLDER_S = 600.0
"""For which a worker waits for the folder of a cluster: for whoever starts workers first, and the scheduler then."""


def make_certificates(folder: Path) -> None:
    """Write certificates for the machines of one cluster, valid for a year (Dask's own: one for all ends)."""
    made = Security.temporary()
    texts = (made.tls_ca_file, made.tls_scheduler_cert, made.tls_scheduler_key)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in zip(CERTIFICATES, texts, strict=True):
            number = os.open(folder / name, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
            with os.fdopen(number, "w", encoding="utf-8") as file:
                file.write(text)


def schedule(folder: Path, host: str, port: int, notify: Callable[[str], None], dashboard: str = "") -> None:
    """Be the scheduler of a cluster until interrupted; its folder gets certificates where it has none.

    host    name or address of this machine for the others; empty: the one by which it reaches the network
    port    0: any that is free
    dashboard  port of Dask's pages on this machine, or HOST:PORT; empty: there are none
    raises  InputError where one answers there already, where it cannot listen, and for certificates that are none or
            whose time is over; nothing is left then that was not there before
    """
    pages = _dashboard(dashboard)
    _refuse_second(folder)
    missing = [name for name in CERTIFICATES if not (folder / name).is_file()]
    stood, made = folder.exists(), len(missing) == len(CERTIFICATES)
    if made:
        make_certificates(folder)
    elif missing:
        raise InputError("cluster.certificates_incomplete", names=missing, file=folder)
    quiet()
    try:
        check_certificates(folder)
        with suppress(asyncio.CancelledError):
            asyncio.run(_schedule(folder, host, port, notify, pages))
    except InputError:
        for name in CERTIFICATES if made else ():
            (folder / name).unlink(missing_ok=True)
        if not stood:
            with suppress(OSError):
                folder.rmdir()
        raise


def _refuse_second(folder: Path) -> None:
    """Raise InputError where a scheduler of this cluster answers: workers and runs would not all find the same one."""
    try:
        found = cluster_at(str(folder))
        check_answers(found)
    except InputError:
        return
    raise InputError(
        "cluster.second_scheduler",
        address=found.address,
        file=folder,
    )


def _dashboard(given: str) -> str:
    """Where Dask's pages are to be seen: HOST:PORT; raises InputError for what is no address, and without Bokeh."""
    if not given:
        return ""
    host, colon, port = given.rpartition(":")
    if not port.isdecimal() or int(port) > MOST_PORT or (colon and not host):
        raise InputError("cluster.dashboard_address", given=given)
    if find_spec("bokeh") is None:
        raise InputError("cluster.dashboard_package", package="bokeh")
    return f"{host or '127.0.0.1'}:{port}"


async def _schedule(folder: Path, host: str, port: int, notify: Callable[[str], None], pages: str) -> None:
    security = security_of(Cluster("", folder))
    _end_on_signal()
    try:
        scheduler = Scheduler(
            host=host or None, port=port, protocol="tls", security=security, dashboard=bool(pages),
            dashboard_address=pages or "127.0.0.1:0",
        )  # fmt: skip
        await scheduler
    except (OSError, ValueError, RuntimeError) as error:  # Dask states the last one, with the reason behind it
        why = error.__cause__ if isinstance(error, RuntimeError) and error.__cause__ is not None else error
        found = getattr(why, "strerror", None) or str(why)
        raise InputError("cluster.cannot_listen", host=host or "-", port=str(port), detail=found) from None
    try:
        write_scheduler(folder, scheduler.address)
        notify(f"scheduler: {scheduler.address} ({signature()})")
        if pages:
            shown = pages.rpartition(":")[0] or host or socket.gethostname()
            notify(f"dashboard: http://{shown}:{scheduler.http_server.port}/status")
        await scheduler.finished()
    finally:
        await scheduler.close()


def work(where: str, jobs: int, notify: Callable[[str], None], memory: float = 0.0) -> None:
    """Be workers of a cluster until interrupted, with one thread each; a scheduler that is not there is waited for.

    where   folder or address, as `cluster_at` takes it
    memory  bytes that the tasks of all of them may take together; 0: four fifths of what is free
    raises  InputError for a scheduler of another version, and for certificates that are not of the cluster
    """
    quiet()
    with suppress(asyncio.CancelledError):
        asyncio.run(_work(where, jobs or os.cpu_count() or 1, notify, memory or SHARE * available_memory()))


async def _work(where: str, jobs: int, notify: Callable[[str], None], memory: float) -> None:
    _end_on_signal()
    with tempfile.TemporaryDirectory() as folder:
        notifying = _Notifying(notify, Path(folder))
        _checked_version(await _there(where, notifying, NoScheduler), where)
        now_and_then = asyncio.create_task(notifying.now_and_then())
        try:
            await asyncio.gather(*(_one_worker(where, notifying, memory / jobs) for _ in range(jobs)))
        finally:
            now_and_then.cancel()
            notify(phrase("cluster.tasks_done", n=notifying.count(), final=True))


@dataclass(slots=True)
class _Notifying:
    """What workers of one command say: what stays as it is once."""

    notify: Callable[[str], None]
    folder: Path
    """in which each process states how many tasks it has done"""
    waits: str = ""

    def waiting(self, why: str) -> None:
        """Say for what is waited."""
        if why != self.waits:
            self.notify(Text.of(note("cluster.waits_for_scheduler"), message_of_text(why)))
        self.waits = why

    def count(self) -> int:
        """Tasks that were done."""
        with suppress(OSError, ValueError):
            return sum(int(f.read_text() or 0) for f in self.folder.iterdir())
        return 0

    async def now_and_then(self) -> None:
        """Say how many tasks were done, where there are more of them."""
        before = 0
        while True:
            await asyncio.sleep(TELL_S)
            count = self.count()
            if count > before:
                self.notify(phrase("cluster.tasks_done", n=count, final=False))
            before = count


async def _there(where: str, notifying: _Notifying, waited_for: type[InputError]) -> Cluster:
    """The cluster, when its scheduler answers; raises InputError of other kinds than what is waited for.

    A folder that does not exist is waited for, too, for `FOLDER_S`: a scheduler makes it, and so does a name mistyped.
    """
    until = time.monotonic() + FOLDER_S
    while True:
        try:
            cluster = cluster_at(where)
            await asyncio.to_thread(check_answers, cluster)
        except waited_for as error:
            if _has_folder(where):
                notifying.waiting(error.why if isinstance(error, NoScheduler) else text_of_error(error))
                until = time.monotonic() + FOLDER_S
            elif time.monotonic() > until:
                raise InputError(
                    "cluster.no_folder",
                    wait_s=FOLDER_S,
                    folder=where,
                    file=where,
                ) from None
            else:
                notifying.waiting(phrase("cluster.folder_awaited", folder=where, seconds=FOLDER_S))
            await asyncio.sleep(LOOK_S)
        else:
            notifying.waits = ""
            return cluster


def _has_folder(where: str) -> bool:
    """Whether a cluster's folder is there; an address needs none."""
    return "://" in where or Path(where).is_dir()


async def _one_worker(where: str, notifying: _Notifying, memory: float) -> None:
    """One worker after the other: each lives as long as its connection to the scheduler, and takes so many bytes."""
    while True:
        cluster = await _there(where, notifying, InputError)  # it was there when this began
        _checked_version(cluster, where)
        nanny = Nanny(
            cluster.address, nthreads=1, security=security_of(cluster), resources={signature(): 1, **announced(memory)},
            memory_limit="0", death_timeout=PATIENCE_S, dashboard=False, host=_listens(cluster),
            dashboard_address="127.0.0.1:0", config=config.config, env={COUNTS: str(notifying.folder)},
        )  # fmt: skip
        try:
            await nanny
            notifying.notify(f"worker of {cluster.address} ({signature()})")
            await nanny.finished()
        except (OSError, TimeoutError, RuntimeError):  # the scheduler went away meanwhile
            await asyncio.sleep(LOOK_S)
        finally:
            await nanny.close()


def _listens(cluster: Cluster) -> str | None:
    """Where a worker listens: what is not encrypted is not to be reached from elsewhere."""
    return "127.0.0.1" if cluster.folder is None else None


def _checked_version(cluster: Cluster, where: str) -> None:
    """Raise InputError where the scheduler is of another version: nobody would give this worker a task."""
    if cluster.runs and cluster.runs != signature():
        raise InputError(
            "cluster.other_version",
            found=cluster.runs,
            version=signature(),
            file=where,
        )


def _end_on_signal() -> None:
    """End as by an interrupt where the system asks for it."""
    task = asyncio.current_task()
    assert task is not None
    if sys.platform != "win32":  # which has no such signal, and whose loops take none
        asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, task.cancel)
