"""Who does tasks: threads of this process, or processes of their own; `on_dask` and `shards` know those elsewhere.

`Executor.run` yields each task as it ends, in any order: what is made of the products must not depend on it.
"""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from concurrent.futures import BrokenExecutor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from multiprocessing import get_context, parent_process
from multiprocessing.process import BaseProcess
from queue import SimpleQueue
from threading import Thread
from typing import Protocol

from raybundle import words
from raybundle.pipeline.queues import drive
from raybundle.pipeline.store import Folder, store_at
from raybundle.pipeline.tasks import Done, Task, do, do_written, written

AHEAD = 4
"""Tasks handed over for each worker, so that none waits and what is held in memory stays bounded."""
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENCV_FOR_THREADS_NUM")
"""Processes of their own use one thread each."""


class Executor(Protocol):
    """Does tasks."""

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks, each after those that it needs, and yield them as they end.

        A task that needs one that failed fails, too.  What a task raises beside InputError, or the death of its
        process, is a reason to try it again, three times in all; then it fails, and the log beside the store states
        why.
        raises  InputError for tasks that wait for each other, where nothing can be written any more, and where those
                who did them cannot be reached; what is kept by then stays
        """
        ...


@dataclass(frozen=True, slots=True)
class Threads:
    """Threads of this process: for functions that let go of the interpreter, as the kernels and OpenCV do."""

    jobs: int = 0
    """0: as many as there are processors"""
    memory: float = float("inf")
    """bytes that the tasks in work may need together; one alone may need more"""

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        jobs = self.jobs or os.cpu_count() or 1
        hands = _Pool(
            AHEAD * jobs, lambda: ThreadPoolExecutor(jobs), lambda pool, task, store: pool.submit(do, task, store)
        )
        with hands.open(store):
            yield from drive(tasks, hands, store, self.memory)


@dataclass(frozen=True, slots=True)
class Processes:
    """Processes that share nothing but the store; they begin anew (spawn) and use one thread each."""

    jobs: int = 0
    memory: float = float("inf")

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        store.check_shared()
        hands = _processes(min(self.jobs or os.cpu_count() or 1, max(len(tasks), 1)))
        with _one_thread_each(), hands.open(store):
            yield from drive(tasks, hands, store, self.memory)


@dataclass(slots=True)
class Staying:
    """Processes that stay from one list of tasks to the next: what they hold ready for use they find again."""

    jobs: int = 0
    memory: float = float("inf")
    _hands: _Pool | None = None

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        store.check_shared()
        if self._hands is None:
            self._hands = _processes(self.jobs or os.cpu_count() or 1)
        self._hands.store = store
        try:
            with _one_thread_each():
                yield from drive(tasks, self._hands, store, self.memory)
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """End the processes; tasks in work are finished, and the next list begins with others."""
        if self._hands is not None:
            self._hands.close()
        self._hands = None


def _processes(jobs: int) -> _Pool:
    """So many processes of their own."""
    return _Pool(
        AHEAD * jobs,
        lambda: ProcessPoolExecutor(jobs, get_context("spawn"), initializer=_begin, initargs=(words.reader().flags,)),
        lambda pool, task, store: pool.submit(_elsewhere, written(task), str(store.path), store.url),
    )


def _begin(flags: bool) -> None:  # noqa: FBT001  (what a process begins with)
    """What a process of its own does first: an interrupt is its parent's affair, and it does not outlive that one."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    words.read_by(words.Reader(flags=flags))
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


_counted = [0.0]
"""CPU seconds of this process that its parent knows of"""


def _elsewhere(text: bytes, folder: str, url: str) -> Done:
    """Do a task in a process of its own; the first one counts what the process took to begin."""
    done = do_written(text, store_at(folder, url))
    before, _counted[0] = _counted[0], time.process_time()
    return replace(done, cpu_s=_counted[0] - before)


@contextmanager
def _one_thread_each() -> Generator[None]:
    """Processes that begin meanwhile use one thread each."""
    before = {name: os.environ.get(name) for name in ONE_THREAD}
    os.environ.update(dict.fromkeys(ONE_THREAD, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


Pool = ThreadPoolExecutor | ProcessPoolExecutor


@dataclass(slots=True)
class _Pool:
    """Hands of this machine; where a process dies its pool is broken, and the next tasks get another."""

    most: int
    begin: Callable[[], Pool]
    give: Callable[[Pool, Task, Folder], Future[Done]]
    pool: Pool | None = None
    store: Folder | None = None
    """of the tasks"""
    done: SimpleQueue[tuple[str, Future[Done]]] = field(default_factory=SimpleQueue)

    @contextmanager
    def open(self, store: Folder) -> Generator[None]:
        """Where it ends early, tasks that nobody has begun are not begun; those in work are finished and kept."""
        self.store = store
        try:
            yield
        finally:
            self.close()

    def close(self) -> None:
        """End it."""
        if self.pool is not None:
            if getattr(self.pool, "_broken", False):
                _end_processes(self.pool)
            self.pool.shutdown(wait=True, cancel_futures=True)

    def room(self) -> int:
        """How many tasks may be in work or wait for it."""
        return self.most

    def submit(self, task: Task) -> None:
        """Take a task."""
        assert self.store is not None
        future = None
        if self.pool is not None:
            with suppress(BrokenExecutor):
                future = self.give(self.pool, task, self.store)
        if future is None:
            self.close()
            self.pool = self.begin()
            future = self.give(self.pool, task, self.store)
        future.add_done_callback(lambda ended, key=task.key: self.done.put((key, ended)))

    def ended(self) -> list[tuple[str, Done | None]]:
        """Wait until some have ended."""
        found = [self.done.get()]
        while not self.done.empty():
            found.append(self.done.get())
        return [(key, _result(future)) for key, future in found]


def _end_processes(pool: Pool) -> None:
    """End all processes of a pool that is broken.

    It ends those that it had when one of them died, and waits for one that a task began at that instant, too: that one
    would not end where a lock died with the other (Python 3.11; later ones begin none then).
    """
    processes: Mapping[int, BaseProcess] = getattr(pool, "_processes", None) or {}
    for process in [*processes.values()]:
        process.kill()


def _result(future: Future[Done]) -> Done | None:
    """What became of a task; None: its process died, or never began."""
    if future.cancelled() or isinstance(future.exception(), BrokenExecutor):
        return None
    return future.result()
