"""In which order tasks are handed to whoever does them, and what becomes of those that fail.

A task is handed over when those that it needs are done, a bounded number ahead.  One that fails for another reason than
bad input is tried three times, in whatever process.  One whose process dies is handed over again; where that happens
to it twice it is done alone, so that of several tasks in work the one is found that kills its process.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Generator, Sequence
from dataclasses import dataclass, field, replace
from typing import Protocol

from raybundle.errors import InputError, as_error, message
from raybundle.pipeline.processor_time import add_worker_time
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Done, Task

TRIES = 3
"""Times that a task is done that fails for another reason than bad input."""
DEATHS = 2
"""Processes that may die with a task in work, among others, before it is done alone."""
LOG = "failed-tasks.log"
"""File beside the store: what tasks that fail say, with tracebacks."""


class Hands(Protocol):
    """Who does tasks that are ready."""

    def room(self) -> int:
        """How many tasks may be in work or wait for it."""
        ...

    def submit(self, task: Task) -> None:
        """Take a task."""
        ...

    def ended(self) -> list[tuple[str, Done | None]]:
        """Wait until some have ended: their keys and what became of them; None: the process that did it died."""
        ...


@dataclass(slots=True)
class Queue:
    """Tasks in the order in which they can be done."""

    waiting: dict[str, tuple[Task, set[str]]]
    """those that wait, and the keys of the tasks for which each does"""
    wanted_by: dict[str, list[str]]
    """keys of the tasks that wait for a task"""
    ready: deque[Task] = field(default_factory=deque[Task])

    @classmethod
    def of(cls, tasks: Sequence[Task]) -> Queue:
        """All of them; products that no task makes are there already."""
        made = {t.key for t in tasks}
        if len(made) < len(tasks):
            raise ValueError("two tasks have the same key: their products would be the same")
        queue = cls({}, {})
        for t in tasks:
            needs = {k for k in (*t.inputs, *t.after) if k in made}
            if not needs:
                queue.ready.append(t)
                continue
            queue.waiting[t.key] = (t, needs)
            for key in needs:
                queue.wanted_by.setdefault(key, []).append(t.key)
        return queue

    def ended(self, done: Done) -> list[Done]:
        """Take note of a task; those that fail with it."""
        lost: list[Done] = []
        ended = [done]
        for one in ended:
            for key in self.wanted_by.pop(one.task.key, ()):
                if key not in self.waiting:
                    continue
                task, needs = self.waiting[key]
                needs.discard(one.task.key)
                if done.failed:
                    del self.waiting[key]
                    lost.append(
                        Done(task=task, failed=message("task.needs_failed", details=[done.failed]), lost=done.lost)
                    )
                    ended.append(lost[-1])
                elif not needs:
                    del self.waiting[key]
                    self.ready.append(task)
        return lost


@dataclass(slots=True)
class _Work:
    """Tasks that are handed over, and how often some were."""

    hands: Hands
    store: Folder
    memory: float
    queue: Queue
    in_work: dict[str, Task] = field(default_factory=dict[str, Task])
    held: float = 0.0
    """bytes that those in work need"""
    failures: Counter[str] = field(default_factory=Counter[str])
    deaths: Counter[str] = field(default_factory=Counter[str])
    alone: deque[Task] = field(default_factory=deque[Task])
    """those that are done when nothing else is in work"""
    tested: str = ""
    """key of the one of them that is in work"""

    def hand_over(self) -> None:
        """Hand over what may be done now."""
        if self.alone:
            if not self.in_work:
                self.tested = self.alone[0].key
                self._submit(self.alone.popleft())
            return
        room = self.hands.room()
        while self.queue.ready and len(self.in_work) < room:
            if self.in_work and self.held + self.queue.ready[0].memory > self.memory:
                break
            self._submit(self.queue.ready.popleft())

    def _submit(self, task: Task) -> None:
        self.in_work[task.key] = task
        self.held += task.memory
        self.hands.submit(task)

    def taken(self, key: str, done: Done | None) -> Done | None:
        """What became of a task; None: it is to be done again."""
        task = self.in_work.pop(key)
        self.held = self.held - task.memory if self.in_work else 0.0
        by_itself, self.tested = key == self.tested, ""
        if done is None:
            self.deaths[key] += 1
            if by_itself:
                died = message("task.process_died")
                done = Done(task=task, failed=died, trouble=f"{died.text()}\n")
        elif done.stop:
            raise as_error(done.stop)
        if done is not None and done.trouble:
            self.failures[key] += 1
            attempt = self.failures[key]
            log = self._log(task, done, attempt)
            if attempt >= TRIES:
                details = [done.failed] if done.failed else []
                failed = message("task.failed_repeatedly", details=details, name=task.name or key, n=TRIES, log=log)
                return Done(task=task, failed=failed)
        elif done is not None:
            return replace(done, task=task)
        if self.deaths[key] >= DEATHS:
            self.alone.append(task)
        else:
            self.queue.ready.append(task)
        return None

    def _log(self, task: Task, done: Done, attempt: int) -> str:
        """Write down what a task states that failed; where."""
        file = self.store.path.parent / LOG
        try:
            with file.open("a", encoding="utf-8", errors="replace") as log:
                log.write(f"{task.name or task.key}: {task.function}, {task.key}, attempt {attempt}\n{done.trouble}\n")
        except OSError:  # the task is reported anyway
            return f"{file} (which cannot be written)"
        return str(file)


def drive(tasks: Sequence[Task], hands: Hands, store: Folder, memory: float) -> Generator[Done, None, None]:
    """Hand tasks over, and yield them as they end.

    raises  InputError where nothing can be written any more, and for tasks that wait for each other
    """
    work = _Work(hands, store, memory, Queue.of(tasks))
    queue = work.queue
    while queue.ready or work.alone or work.in_work:
        work.hand_over()
        for key, found in hands.ended():
            add_worker_time(0.0 if found is None else found.cpu_s)
            done = work.taken(key, found)
            if done is not None:
                lost = queue.ended(done)
                yield done
                yield from lost
    if queue.waiting:
        raise InputError("task.cycle", n=len(queue.waiting), names=[t.name or t.key for t, _ in queue.waiting.values()])
