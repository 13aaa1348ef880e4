"""Who does tasks: threads of this process, or processes of their own.

`Executor.run` yields each task as it ends, in any order: what is made of the products must not depend on it.
"""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Protocol

import msgspec

from raybundle.errors import InputError
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Done, Task, do, options_of
from raybundle.settings import read_with_flags, with_flags

AHEAD = 4
"""Tasks handed over for each worker, so that none waits and what is held in memory stays bounded."""
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
"""Processes of their own use one thread each."""


class Executor(Protocol):
    """Does tasks."""

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks, each after those that it needs, and yield them as they end.

        raises  InputError for tasks that wait for each other.  A task that needs one that failed fails, too; what a
                task raises beside InputError ends the run, and what is kept by then stays
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
        with ThreadPoolExecutor(jobs) as pool:
            yield from _run(tasks, lambda t: pool.submit(do, t, store), AHEAD * jobs, self.memory)


@dataclass(frozen=True, slots=True)
class Processes:
    """Processes that share nothing but the store; they begin anew (spawn) and use one thread each."""

    jobs: int = 0
    memory: float = float("inf")

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        jobs = min(self.jobs or os.cpu_count() or 1, max(len(tasks), 1))

        def submit(task: Task) -> Future[Done]:
            return pool.submit(_elsewhere, _written(task), str(store.path))

        with (
            _one_thread_each(),
            ProcessPoolExecutor(
                jobs, get_context("spawn"), initializer=read_with_flags, initargs=(with_flags(),)
            ) as pool,
        ):
            yield from _run(tasks, submit, AHEAD * jobs, self.memory)


def _written(task: Task) -> bytes:
    """A task as text, as it could lie in a file."""
    return msgspec.json.encode(replace(task, options=msgspec.to_builtins(task.options, enc_hook=str)))


def _read(text: bytes) -> Task:
    """The same task; its options are of the data class that its function takes."""
    task = msgspec.json.decode(text, type=Task)
    kind = options_of(task.function)
    return replace(task, options=msgspec.convert(task.options, kind, dec_hook=lambda wanted, given: wanted(given)))


def _elsewhere(text: bytes, folder: str) -> Done:
    """Do a task in a process of its own."""
    task = _read(text)
    if folder not in _stores:
        _stores[folder] = Folder(Path(folder))
    return replace(do(task, _stores[folder]), task=replace(task, options=None))


_stores: dict[str, Folder] = {}
"""Of a process of its own: what it has read stays in memory from task to task."""


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


@dataclass(slots=True)
class _Queue:
    """Tasks in the order in which they can be done."""

    waiting: dict[str, tuple[Task, set[str]]]
    """those that wait, and the keys of the tasks for which each does"""
    ready: deque[Task] = field(default_factory=deque[Task])

    @classmethod
    def of(cls, tasks: Sequence[Task]) -> _Queue:
        """All of them; products that no task makes are there already."""
        made = {t.key for t in tasks}
        if len(made) < len(tasks):
            raise ValueError("two tasks have the same key: their products would be the same")
        queue = cls({})
        for t in tasks:
            needs = {k for k in (*t.inputs, *t.after) if k in made}
            if needs:
                queue.waiting[t.key] = (t, needs)
            else:
                queue.ready.append(t)
        return queue

    def ended(self, done: Done) -> list[Done]:
        """Take note of a task; those that fail with it."""
        lost: list[Done] = []
        for key, (task, needs) in [*self.waiting.items()]:
            if done.task.key not in needs:
                continue
            needs.discard(done.task.key)
            if done.failed:
                del self.waiting[key]
                mine = Done(task=task, failed=f"needs what could not be made: {done.failed}")
                lost += [mine, *self.ended(mine)]
            elif not needs:
                del self.waiting[key]
                self.ready.append(task)
        return lost


def _run(
    tasks: Sequence[Task], submit: Callable[[Task], Future[Done]], most: int, memory: float
) -> Generator[Done, None, None]:
    """Hand tasks over, so many at a time, and yield them as they end; where this ends early, so do they."""
    queue, in_work = _Queue.of(tasks), dict[Future[Done], Task]()
    try:
        while queue.ready or in_work:
            while queue.ready and len(in_work) < most:
                held = sum(t.memory for t in in_work.values())
                if in_work and held + queue.ready[0].memory > memory:
                    break
                task = queue.ready.popleft()
                in_work[submit(task)] = task
            ended, _ = wait(in_work, return_when=FIRST_COMPLETED)
            for future in ended:
                done: Any = replace(future.result(), task=in_work.pop(future))
                lost = queue.ended(done)
                yield done
                yield from lost
    finally:
        for future in in_work:
            future.cancel()
    if queue.waiting:
        names = ", ".join(t.name or t.key for t, _ in [*queue.waiting.values()][:5])
        raise InputError(f"{len(queue.waiting)} tasks wait for each other: {names}")
