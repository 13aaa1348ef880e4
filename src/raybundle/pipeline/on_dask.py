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
from asyncio import run_coroutine_threadsafe
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import wait
from contextlib import suppress
from dataclasses import dataclass, field, replace
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
MEMORY, MEMORY_STEP = "memory", 2.0**26
"""Resource of a worker: bytes that its tasks may take; and to what multiples of bytes tasks ask for it"""
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


@dataclass(slots=True)
class Dask:
    """The workers of a scheduler; the store lies in a folder that all of them see under the same path, or at a URL."""

    cluster: Cluster
    memory: float = float("inf")
    patience: float = PATIENCE_S
    progress: Progress = silent
    noted: set[str] = field(default_factory=set[str])
    """codes of remarks that are stated once"""

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        if not tasks:
            return
        check_answers(self.cluster)
        quiet()
        store.check_shared()
        store.path.mkdir(parents=True, exist_ok=True)
        hands = _Workers(self.cluster, store, token_of(store), self.patience, self.progress, self.noted)
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
    noted: set[str] = field(default_factory=set[str])
    client: Client = field(init=False)
    futures: dict[Future, tuple[Task, ...]] = field(default_factory=dict[Future, tuple[Task, ...]])
    memory: dict[Future, float] = field(default_factory=dict[Future, float])
    """bytes that were asked of a worker for them"""
    largest: float = 0.0
    """bytes that a worker announces at most; 0: not all of them announce any"""
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
            self.client = _client(self.cluster)
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
        alike: dict[float, list[tuple[Task, ...]]] = {}
        for message in together(self.waiting):
            alike.setdefault(self._memory(message), []).append(message)
        self.waiting = []
        about = (str(self.store.path.absolute()), self.store.url, self.token, words.reader().flags, str(Path.cwd()))
        for memory, messages in alike.items():
            keys = [f"{m[0].key}-{self.name}-{self.count + k}" for k, m in enumerate(messages)]
            self.count += len(messages)
            futures: Any = self.client.map(
                _elsewhere, [[written(t) for t in m] for m in messages], *([part] * len(messages) for part in about),
                key=keys, resources={signature(): 1, **({MEMORY: memory} if memory else {})}, pure=False,
            )  # fmt: skip
            for future, message in zip(futures, messages, strict=True):
                self.futures[future], self.memory[future] = message, memory
                future.add_done_callback(self.done.put)

    def _memory(self, message: Sequence[Task]) -> float:
        """Bytes to ask of a worker for tasks, one behind the other; never more than one announces: they would wait."""
        needed = math.ceil(max(t.memory for t in message) / MEMORY_STEP) * MEMORY_STEP
        if needed > self.largest:
            code = "cluster.memory_short" if self.largest else "cluster.memory_unknown"
            if self.most and code not in self.noted:
                self.noted.add(code)
                self.progress(phrase(code, largest_gb=self.largest / 1e9, needed_gb=needed / 1e9), Remark())
        return min(needed, self.largest)

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
        try:
            gathered = self._gathered(finished)
            results = dict(zip([f for f in finished if f.status == "finished"], gathered, strict=True))
        except InputError:
            raise
        except Exception:  # noqa: BLE001, S110  (a connection that is lost meanwhile: they are done again)
            pass
        again: list[Task] = []
        for future in batch:
            tasks = self.futures.pop(future, ())
            self.memory.pop(future, None)
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
            self._look()
            for task in again:
                self.submit(task)
        return found

    def _gathered(self, finished: Sequence[Future]) -> list[Any]:
        """Results, without those that are lost.

        One that died with its worker is made again meanwhile, and what it asks for nobody may have any more.
        """
        loop: Any = self.client.loop
        gathering: Any = run_coroutine_threadsafe(self.client._gather(finished, errors="skip"), loop.asyncio_loop)  # noqa: SLF001
        while not wait([gathering], LOOK_S).done:
            self._look()
        return gathering.result()

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
            workers = _workers_of(self.client)
        except Exception:  # noqa: BLE001  (the connection was lost meanwhile: the next look shows)
            return
        self.looked = time.monotonic()
        fit = _fitting(workers)
        announced = [float(w["resources"].get(MEMORY, 0.0)) for w in fit]
        self.largest = max(announced) if announced and all(announced) else 0.0
        if fit:  # who announced more is gone: what asks for it would wait for ever, and is handed over again
            most = max(announced)
            self.client.cancel(
                [f for f, asked in self.memory.items() if asked > most and f.status in {"pending", "lost"}]
            )
        self.threads = max(sum(w["nthreads"] for w in fit), 1)
        if len(fit) < self.most:
            self.progress(phrase("cluster.workers_lost", n=self.most - len(fit), rest=len(fit)), Remark())
        self.most = len(fit)
        if fit:
            if self.reported > self.seen:
                self.progress(phrase("cluster.workers_found", n=len(fit)), Remark())
            self.seen = self.looked
        elif self.looked > self.seen + self.patience:
            others = _described(workers)
            raise InputError(
                "cluster.no_worker",
                n=len(workers),
                version=signature(),
                others=others,
                file=self.cluster.folder or self.cluster.address,
            )
        else:
            self._say_waiting(note("cluster.no_fitting_worker", n=len(workers)), self.looked - self.seen)


def await_workers(cluster: Cluster, wanted: int, limit_s: float, progress: Progress = silent) -> None:
    """Wait until so many workers are there that can do our tasks; raises InputError where they do not come in time."""
    check_answers(cluster)
    quiet()
    began, reported, before = time.monotonic(), -math.inf, -1
    with _client(cluster) as client:
        while True:
            workers: Mapping[str, Any] = {}
            with suppress(OSError, TimeoutError):  # a connection that is lost comes back
                workers = _workers_of(client)
            count, now = len(_fitting(workers)), time.monotonic()
            if count >= wanted:
                return
            if now > began + limit_s:
                others = _described({k: w for k, w in workers.items() if signature() not in w["resources"]})
                raise InputError(
                    "cluster.too_few_workers", n=count, wanted=wanted, wait_s=limit_s, others=others,
                    differing=len(others),
                    file=cluster.folder or cluster.address,
                )  # fmt: skip
            if count != before or now > reported + AGAIN_S:
                before, reported = count, now
                left = began + limit_s - now
                progress(Text.of(note("cluster.workers_awaited", n=count, wanted=wanted),
                                 note("cluster.waiting", seconds=left)), Remark())  # fmt: skip
            time.sleep(min(LOOK_S, limit_s / 10))


def _client(cluster: Cluster) -> Client:
    return Client(cluster.address, security=security_of(cluster), timeout=30, set_as_default=False)


def _workers_of(client: Client) -> Mapping[str, Any]:
    """Workers of a scheduler, by itself: what its client holds ready is at times only some of them, or none."""
    scheduler: Any = client.scheduler
    identity: Any = client.sync(scheduler.identity, n_workers=-1)
    return identity["workers"]


def _fitting(workers: Mapping[str, Any]) -> list[Any]:
    """Workers of our version."""
    return [w for w in workers.values() if signature() in w["resources"]]


def _described(workers: Mapping[str, Any]) -> list[str]:
    """Machines and what they run."""
    return sorted({f"{w['host']}: {', '.join({*w['resources']} - {MEMORY}) or '-'}" for w in workers.values()})


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
    done = [_timed(text, store_at(folder, url)) for text in texts]
    _count(sum(not d.failed for d in done))
    return done, socket.gethostname(), ""


def _timed(text: bytes, store: Folder) -> Done:
    began = time.process_time()
    done = do_written(text, store)
    return replace(done, cpu_s=time.process_time() - began)


def _count(more: int) -> None:
    """Say to who started this process how many tasks it has done."""
    where = os.environ.get(COUNTS)
    if where:
        file = Path(where) / str(os.getpid())
        with suppress(OSError, ValueError):
            file.write_text(str(more + (int(file.read_text()) if file.exists() else 0)))


def dask_setup(worker: DaskWorker) -> None:
    """Make a worker that somebody else started one of ours, where it is set to load this module before."""
    ours: dict[str, float] = {signature(): 1, **announced(worker.memory_manager.memory_limit or 0.0)}
    for resources in (worker.state.total_resources, worker.state.available_resources):
        resources.update({name: amount for name, amount in ours.items() if name not in resources})


def announced(memory: float) -> dict[str, float]:
    """The resource of a worker whose tasks may take so many bytes; 0: it announces none."""
    return {MEMORY: memory} if memory else {}
