"""Tasks on other machines, handed out by Dask distributed, which this module and `dask_machines` alone know.

Dask carries tasks as text and hands small products back; what is done is known by the store, which all machines see.
A worker states what raybundle it runs as a resource, and a task asks for that resource: no other worker is given it.
"""

from __future__ import annotations

import logging
import math
import os
import socket
import time
import uuid
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any

from dask import config
from distributed import Client, Future, Security
from distributed import Worker as DaskWorker

from raybundle import words
from raybundle.errors import InputError, Message, Text, message_of_text, note, phrase
from raybundle.numerics.progress import Progress, Remark, silent
from raybundle.pipeline.clusters import (
    Cluster,
    check_answers,
    signature,
    token_of,
    unseen,
)
from raybundle.pipeline.executors import ONE_THREAD
from raybundle.pipeline.queues import drive
from raybundle.pipeline.store import Folder, store_at
from raybundle.pipeline.tasks import Done, Task, do, do_written, written

AHEAD_BY_DASK = 16
"""Tasks handed over for each worker: several go over the network at once, and none waits for the next."""
MESSAGE_S, MOST_TOGETHER = 1.0, 500
"""CPU seconds of the tasks that go in one message, and how many they are at most: a message takes 2 to 5 ms of the
scheduler, which is much for a pair of photographs, and what a killed worker loses is one message's work."""
LOOK_S = 1.0
"""Between two looks at which workers there are."""
PATIENCE_S = 120.0
"""That a run waits for a worker that can do its tasks, and for a scheduler that was lost: a machine starts in less."""
SAY_S, AGAIN_S = 5.0, 30.0
"""After which a run states that it waits for a worker or the scheduler, and after which once more."""
COUNTS = "RAYBUNDLE_WORKER_COUNTS"
"""Names to the processes of a worker the folder in which each states how many tasks it has done."""
BLIND = 3
"""Tasks that a worker could not do and this machine could, before the run ends: once may be a network that failed."""
CONFIGURED = {
    "distributed.comm.timeouts.connect": "10s",
    "distributed.comm.timeouts.tcp": "30s",
    # a line that is cut looks like a death: `queues` gets it when it has happened so often to the same tasks
    "distributed.scheduler.allowed-failures": 5,
    "distributed.scheduler.worker-ttl": "60s",
    # a task's memory is its own affair: what Dask takes for too much would be killed
    "distributed.worker.memory.terminate": False,
    "distributed.worker.memory.pause": False,
    "distributed.admin.low-level-log-length": 0,
    "distributed.nanny.pre-spawn-environ": {
        **dict.fromkeys(ONE_THREAD, "1"),
        "DASK_LOGGING__DISTRIBUTED": "critical",
    },
}


@dataclass(frozen=True, slots=True)
class Dask:
    """The workers of a scheduler; the store lies in a folder that all of them see under the same path, or at a URL."""

    cluster: Cluster
    memory: float = float("inf")
    patience: float = PATIENCE_S
    progress: Progress = silent

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        if not tasks:
            return
        check_answers(self.cluster)
        quiet()
        store.check_shared()
        store.path.mkdir(parents=True, exist_ok=True)
        hands = _Workers(self.cluster, store, token_of(store), self.patience, self.progress)
        try:
            yield from drive(tasks, hands, store, self.memory)
        finally:
            with suppress(Exception):  # it may be gone; what is kept is kept
                hands.client.close(timeout=2)


def security_of(cluster: Cluster) -> Security:
    """Encrypted where there are certificates, all of one kind for all ends."""
    if cluster.folder is None:
        return Security(require_encryption=False)
    ca, cert, key = map(str, cluster.files)
    ends = {f"tls_{end}_{what}": file for end in ("client", "scheduler", "worker")
            for what, file in (("cert", cert), ("key", key))}  # fmt: skip
    return Security(require_encryption=True, tls_ca_file=ca, **ends)


def quiet() -> None:
    """What Dask has to say of lost connections is stated by us, in words that help."""
    config.set(CONFIGURED)
    for name in ("distributed", "tornado.application", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    for name in [n for n in logging.root.manager.loggerDict if n.startswith("distributed.")]:
        logging.getLogger(name).setLevel(logging.CRITICAL)


@dataclass(slots=True)
class _Workers:
    """Hands that are workers of a scheduler."""

    cluster: Cluster
    store: Folder
    token: str
    patience: float
    progress: Progress = silent
    client: Client = field(init=False)
    futures: dict[Future, tuple[Task, ...]] = field(default_factory=dict[Future, tuple[Task, ...]])
    waiting: list[Task] = field(default_factory=list[Task])
    """taken, and not sent yet"""
    done: SimpleQueue[Future] = field(default_factory=SimpleQueue)
    threads: int = 1
    cost: float = MESSAGE_S
    """CPU seconds of a task, of those that were taken last"""
    looked: float = 0.0
    seen: float = field(default_factory=time.monotonic)
    """when a worker was seen that can do our tasks"""
    most: int = 0
    """workers that were seen at once"""
    reported: float = -math.inf
    """when it was last stated that somebody is waited for"""
    blind: int = 0
    name: str = field(default_factory=lambda: uuid.uuid4().hex[:8])
    count: int = 0

    def __post_init__(self) -> None:
        """Connect; raises InputError."""
        try:
            self.client = Client(
                self.cluster.address, security=security_of(self.cluster), timeout=30, set_as_default=False,
            )  # fmt: skip
        except (OSError, TimeoutError) as error:
            raise InputError(
                "cluster.connection_lost",
                detail=str(error).partition("\n")[0],
                folder=str(self.store.path.parent),
                file=self.cluster.address,
            ) from None

    def room(self) -> int:
        """How many tasks may be in work or wait for it."""
        if time.monotonic() > self.looked + LOOK_S:
            self._look()
        in_message = min(max(MESSAGE_S / max(self.cost, 1e-6), 1.0), MOST_TOGETHER)
        return int(AHEAD_BY_DASK * self.threads * in_message)

    def submit(self, task: Task) -> None:
        """Take a task; it goes out with others when the next is waited for."""
        self.waiting.append(task)
        self.cost = 0.9 * self.cost + 0.1 * task.cost

    def _send(self) -> None:
        """Send what was taken; the key of each attempt is its own, so that Dask takes none for one of another run."""
        messages = together(self.waiting)
        self.waiting = []
        if not messages:
            return
        keys = [f"{m[0].key}-{self.name}-{self.count + k}" for k, m in enumerate(messages)]
        self.count += len(messages)
        about = (str(self.store.path.absolute()), self.store.url, self.token, words.reader().flags, str(Path.cwd()))
        futures: Any = self.client.map(
            _elsewhere, [[written(t) for t in m] for m in messages], *([part] * len(messages) for part in about),
            key=keys, resources={signature(): 1}, pure=False,
        )  # fmt: skip
        for future, message in zip(futures, messages, strict=True):
            self.futures[future] = message
            future.add_done_callback(self.done.put)

    def ended(self) -> list[tuple[str, Done | None]]:
        """Wait until some have ended."""
        while True:
            self._send()
            try:
                batch = [self.done.get(timeout=LOOK_S)]
            except Empty:
                self._look()
                continue
            while not self.done.empty():
                batch.append(self.done.get())
            found = self._found(batch)
            if found:
                return found

    def _found(self, batch: Sequence[Future]) -> list[tuple[str, Done | None]]:
        """What became of tasks; those that were lost with a connection are handed over again."""
        found: list[tuple[str, Done | None]] = []
        finished = [f for f in batch if f.status == "finished"]
        results: dict[Future, Any] = {}
        with suppress(Exception):  # a connection that is lost meanwhile: they are done again
            found_there: Any = self.client.gather(finished, errors="skip")
            results = dict(zip(finished, found_there, strict=True))
        again: list[Task] = []
        for future in batch:
            tasks = self.futures.pop(future, ())
            if future in results:
                reported, host, refused = results[future]
                found += [
                    (task.key, self._checked(task, done, host, refused))
                    for task, done in zip(tasks, reported, strict=True)
                ]
            elif future.status == "error":  # its worker died; what a task raises is handed back as what became of it
                found += [(task.key, None) for task in tasks]
            else:
                again += tasks
        if again:
            self._connected()
            for task in again:
                self.submit(task)
        return found

    def _checked(self, task: Task, done: Done, host: str, refused: str) -> Done:
        """What became of a task; raises InputError where its worker does not see what this machine sees."""
        if refused:
            raise InputError(
                "cluster.worker_blind",
                host=host,
                url=bool(self.store.url),
                details=[message_of_text(refused)],
                file=self.store.place.name,
            )
        if not done.failed or done.lost or done.trouble or done.stop:
            return done
        here = do(task, self.store)  # bad input is bad everywhere
        if not here.failed:
            self.blind += 1
            if self.blind >= BLIND:
                raise InputError("cluster.worker_fails", details=[done.failed], host=host, n=BLIND)
        return here

    def _connected(self) -> None:
        """Wait for the scheduler; raises InputError where it is gone."""
        began = time.monotonic()
        while self.client.status != "running":
            waited = time.monotonic() - began
            if self.client.status in {"closed", "closing"} or waited > self.patience:
                raise InputError(
                    "cluster.connection_lost",
                    detail=str(self.client.status),
                    folder=str(self.store.path.parent),
                    file=self.cluster.address,
                )
            self._say_waiting(note("cluster.scheduler_silent"), waited)
            time.sleep(LOOK_S / 5)

    def _say_waiting(self, why: Message, waited: float) -> None:
        """Say now and then for whom is waited, and for how long."""
        now = time.monotonic()
        if waited > SAY_S and now > self.reported + AGAIN_S:
            self.reported = now
            left = max(self.patience - waited, 0.0)
            self.progress(Text.of(why, note("cluster.waiting", seconds=left)), Remark())

    def _look(self) -> None:
        """See which workers there are; raises InputError where none can do our tasks for long."""
        self._connected()
        try:
            workers = self.client.scheduler_info(n_workers=-1)["workers"]
        except Exception:  # noqa: BLE001  (the connection was lost meanwhile: the next look shows)
            return
        self.looked = time.monotonic()
        fit = [w for w in workers.values() if signature() in w["resources"]]
        self.threads = max(sum(w["nthreads"] for w in fit), 1)
        if len(fit) < self.most:
            self.progress(phrase("cluster.workers_lost", n=self.most - len(fit), rest=len(fit)), Remark())
        self.most = len(fit)
        if fit:
            if self.reported > self.seen:
                self.progress(phrase("cluster.workers_found", n=len(fit)), Remark())
            self.seen = self.looked
        elif self.looked > self.seen + self.patience:
            others = sorted({f"{w['host']}: {', '.join(w['resources']) or 'no raybundle'}" for w in workers.values()})
            raise InputError(
                "cluster.no_worker",
                n=len(workers),
                version=signature(),
                others=others,
                file=self.cluster.folder or self.cluster.address,
            )
        else:
            self._say_waiting(note("cluster.no_fitting_worker", n=len(workers)), self.looked - self.seen)


def together(tasks: Sequence[Task]) -> list[tuple[Task, ...]]:
    """Tasks in their order, those that go in one message together; all of them can be done now."""
    messages: list[tuple[Task, ...]] = []
    message: list[Task] = []
    for task in tasks:
        if message and (sum(t.cost for t in message) + task.cost > MESSAGE_S or len(message) >= MOST_TOGETHER):
            messages.append(tuple(message))
            message = []
        message.append(task)
    return [*messages, tuple(message)] if message else messages


def _elsewhere(
    texts: Sequence[bytes],
    folder: str,
    url: str,
    token: str,
    flags: bool,  # noqa: FBT001  (as Dask hands it over)
    here: str,
) -> tuple[list[Done], str, str]:
    """Do tasks in a worker: what became of each, the machine, and why it does not see the store (empty: it does)."""
    words.read_by(words.Reader(flags=flags))
    refused = unseen(folder, url, token)
    if refused:
        nothing = Done(task=Task(key="", function="", options=None))
        return [nothing] * len(texts), socket.gethostname(), refused
    with suppress(OSError):  # where it is not, the files were given with their whole paths, or are named as missing
        os.chdir(here)
    done = [do_written(text, store_at(folder, url)) for text in texts]
    _count(sum(not d.failed for d in done))
    return done, socket.gethostname(), ""


def _count(more: int) -> None:
    """Say to who started this process how many tasks it has done."""
    where = os.environ.get(COUNTS)
    if where:
        file = Path(where) / str(os.getpid())
        with suppress(OSError, ValueError):
            file.write_text(str(more + (int(file.read_text()) if file.exists() else 0)))


def dask_setup(worker: DaskWorker) -> None:
    """Make a worker that somebody else started one of ours, where it is set to load this module before."""
    worker.state.total_resources[signature()] = 1
    worker.state.available_resources[signature()] = 1
