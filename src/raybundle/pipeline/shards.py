"""Tasks without a scheduler: a list in the store, of which each job of an array does its share.

    STORE/tasks.jsonl  what the stage needs that is not kept yet: a line of facts, then a task a line

A run with this executor takes what shards have handed over and writes down what is still to be done; then it ends, and
the same command goes on when the shards are through.  Which shard does what makes no difference to any product.
"""

from __future__ import annotations

import hashlib
import json
import os
import time
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np

from raybundle import words
from raybundle.errors import InputError, Message, TasksWaiting, message_of
from raybundle.io.block.arrays import value_of_text
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Counted, Progress, silent
from raybundle.pipeline.clusters import TOKEN, signature
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.keys import KEY, key_of
from raybundle.pipeline.project import products_of
from raybundle.pipeline.queues import Queue
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Done, Task, read_task, written

TASKS = "tasks.jsonl"
HANDED = "handed"
"""Kind of the products in which shards hand small ones over, many in one archive."""
FAILED, LOST = "!failed", "!lost"
HAND_OVER_S = 5.0
"""Small products are handed over so often: what a killed shard loses."""
ALONE_S, TOGETHER_S = 60.0, 1.0
"""CPU seconds that one task, or several, take at most that the run does itself: a queue takes longer to begin."""
LOOK_S = 1.0
"""Between two looks whether other shards have made what is needed."""


@dataclass(frozen=True, slots=True)
class Shards:
    """Jobs of an array, each with a share of the tasks."""

    def run(self, tasks: Sequence[Task], store: Folder) -> Iterator[Done]:
        """Yield what was handed over; raises TasksWaiting where there is more to be done."""
        wanted, queue = {t.key: t for t in tasks}, Queue.of(tasks)
        for archive in store.keys_of_kind(HANDED):
            products = _unpacked(store.load(archive) or {})
            found = {key: product for key, product in products.items() if key in wanted}
            for key, product in found.items():
                stated, lost = (str(product.get(name, "")) for name in (FAILED, LOST))
                failed = message_of(value_of_text(stated)) if stated else None
                last = key == next(reversed(found))
                done = Done(task=wanted.pop(key), product=product, failed=failed, lost=lost, keep_now=last)
                yield done
                if failed:
                    for follows in queue.ended(done):
                        wanted.pop(follows.task.key, None)
                        yield follows
            if found or all(FAILED in product for product in products.values()):
                store.forget(archive)  # kept by now; what failed is tried again by the next run
        if wanted and _little(wanted.values()):
            yield from Threads(1).run([*wanted.values()], store)
            wanted = {}
        if not wanted:
            store.place.forget_text(TASKS)
            return
        lines = [written(t).decode() for t in wanted.values()]
        facts = {
            "raybundle": signature(), "tasks": len(wanted), "flags": words.reader().flags, "folder": str(Path.cwd()),
            "sum": _sum(lines),
        }  # fmt: skip
        lines = [json.dumps(facts), *lines]
        file = store.place.keep_text(TASKS, "\n".join(lines) + "\n")
        project = store.url or store.path.parent
        raise TasksWaiting("task.shards_waiting", n=len(wanted), file_name=str(file), project=str(project))


def _little(tasks: Collection[Task]) -> bool:
    """Whether it takes less to do tasks here than to wait in a queue for them."""
    cost = sum(t.cost for t in tasks)
    return cost <= (ALONE_S if len(tasks) == 1 else TOGETHER_S)


def _sum(lines: Sequence[str]) -> str:
    """By which a list is known that is not as it was written."""
    found = hashlib.sha256()
    for k, line in enumerate(lines):
        found.update(f"\n{line}".encode() if k else line.encode())
    return found.hexdigest()


@dataclass(frozen=True, slots=True, kw_only=True)
class _Facts:
    """First line of a list."""

    raybundle: str
    tasks: int
    flags: bool
    folder: str
    sum: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Listed:
    """What a shard has to know of a task that another one does."""

    key: str
    small: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class ShardDone:
    """What a shard did."""

    made: int
    failed: tuple[tuple[str, Message], ...]
    """tasks that could not be done, and why: the run that wanted them states what follows from it"""
    waiting: int
    """tasks that need what other shards have not made"""


def do_shard(
    project: Path | str, number: int, of: int, *, jobs: int = 1, wait_s: float = 60.0, progress: Progress = silent
) -> ShardDone:
    """Do each task whose number modulo `of` is `number`, in the order of the list; what is made already is left.

    project  its folder, or the URL of the store of its products
    jobs    processes, of one thread each
    wait_s  that others are waited for where nothing else is left to do
    raises  InputError where there is no list, or it is of another version of raybundle
    """
    of_url = isinstance(project, str) and "://" in project
    store = Folder(Path.cwd() / "cache", str(project)) if of_url else products_of(Path(project).absolute())
    store.check_shared()
    listed = _listed(store, None if of_url else Path(project), number, of)
    if listed is None:
        return ShardDone(made=0, failed=(), waiting=0)
    mine, tasks = listed
    made, small = {t.key for t in tasks}, {t.key for t in tasks if t.small}
    failed: dict[str, Message] = {}
    handed_over = _keys_handed(store)
    there = store.those([t.key for t in mine if not t.small])
    waiting = [t for t in mine if t.key not in (handed_over if t.small else there)]
    begun, count, before = time.monotonic(), 0, len(mine) - len(waiting)
    while waiting:
        ready = _ready(waiting, made, small, store)
        if not ready:
            if time.monotonic() > begun + wait_s:
                break
            time.sleep(LOOK_S)
            continue
        handing, handed = dict[str, Mapping[str, Array]](), time.monotonic()
        try:
            for done in Processes(jobs).run(ready, store):
                count += not done.failed
                if done.failed:
                    failed[done.task.key] = done.failed
                    stated = {FAILED: np.array(json.dumps(done.failed.json())), LOST: np.array(done.lost)}
                    _hand_over(store, {done.task.key: stated})
                elif done.task.small:
                    handing[done.task.key] = done.product
                if time.monotonic() > handed + HAND_OVER_S:
                    _hand_over(store, handing)
                    handing, handed = {}, time.monotonic()
                over = before + count + len(failed)
                progress("shard", Counted(over / len(mine), over, len(mine), 0.0))
        finally:
            _hand_over(store, handing)
        tried = {t.key for t in ready}
        waiting, begun = [t for t in waiting if t.key not in tried], time.monotonic()
    names = {t.key: t.name or t.key for t in mine}
    return ShardDone(made=count, failed=tuple((names[k], why) for k, why in failed.items()), waiting=len(waiting))


def _listed(store: Folder, project: Path | None, number: int, of: int) -> tuple[list[Task], list[_Listed]] | None:
    """The tasks of a share and all of the list in a store; None: there is none, nothing is to be done.

    project  its folder; None: the URL of the store was given
    raises   InputError, with the line, for a list that is not as it was written: nothing of it is done
    """
    file = f"{store.place.name}/{TASKS}"
    if project is not None and not (project / "project.db").is_file():
        raise InputError("project.no_run", file=project)
    try:
        text = store.place.text(TASKS)
        if text is None and project is None and store.place.text(TOKEN) is None:
            raise InputError("store.no_products", file=store.url)
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(
            "task.list_not_readable", detail=str(getattr(error, "strerror", None) or error), file=file
        ) from None
    if text is None:
        return None
    first, *lines = text.splitlines() or [""]
    facts = _facts(first, file)
    if facts.raybundle != signature():
        raise InputError("cluster.other_version", found=facts.raybundle, version=signature(), file=file)
    mine, found = list[Task](), list[_Listed]()
    listed = msgspec.json.Decoder(_Listed)
    for k, line in enumerate(lines):
        try:
            task = listed.decode(line) if k % of != number else read_task(line.encode())
        except (ValueError, TypeError) as error:
            raise InputError("task.list_no_task", detail=str(error), file=file, line=k + 2) from None
        if isinstance(task, Task):
            mine.append(task)
            for key in (task.key, *task.inputs, *task.after):
                if not KEY.fullmatch(key):
                    raise InputError("task.list_no_key", name=repr(key), file=file, line=k + 2)
        found.append(_Listed(key=task.key, small=task.small))
    if len(found) != facts.tasks:
        raise InputError("task.list_count", n=len(found), needed=facts.tasks, file=file, line=len(lines) + 1)
    if _sum(lines) != facts.sum:
        raise InputError("task.list_checksum", file=file, line=2)
    with suppress(OSError):  # where it is not, the files were given with their whole paths, or are named as missing
        os.chdir(facts.folder)
    words.read_by(words.Reader(flags=facts.flags))
    return mine, found


def tasks_listed(project: Path, url: str) -> tuple[int, int] | None:
    """Tasks of the list of a project that are done, and all of them; None: there is no list that can be read.

    url  of the store of its products; empty: they lie in the folder
    """
    store = Folder(project / "cache", url)
    try:
        lines = (store.place.text(TASKS) or "").splitlines()[1:]
        tasks = [msgspec.json.decode(line, type=_Listed) for line in lines]
    except (OSError, ValueError):
        return None
    if not tasks:
        return None
    small = {t.key for t in tasks if t.small}
    done = len(store.those([t.key for t in tasks if not t.small])) + len(small & _keys_handed(store))
    return done, len(tasks)


def _facts(line: str, file: str) -> _Facts:
    try:
        return msgspec.json.decode(line, type=_Facts)
    except ValueError as error:
        raise InputError("task.list_damaged", detail=str(error) if line else "-", file=file, line=1) from None


def _keys_handed(store: Folder) -> set[str]:
    """Keys of the small products that shards have handed over so far."""
    found = set[str]()
    for archive in store.keys_of_kind(HANDED):
        found |= {name.partition(":")[0] for name in store.mapped(archive) or {}}
    return found


def _ready(waiting: Sequence[Task], made: set[str], small: set[str], store: Folder) -> list[Task]:
    """Those that can be done now: what they need is kept, or made by one of them before."""
    ready: dict[str, Task] = {}
    needed = {key for t in waiting for key in (*t.inputs, *t.after)}
    there = (needed - made) | (_keys_handed(store) if small else set[str]())
    there |= store.those(sorted((needed & made) - small))
    for t in waiting:
        if all(key in there or key in ready for key in (*t.inputs, *t.after)):
            ready[t.key] = t
    return [*ready.values()]


def _hand_over(store: Folder, products: Mapping[str, Mapping[str, Array]]) -> None:
    """Put small products where the next run takes them."""
    if products:
        arrays = {f"{key}:{name}": values for key, product in products.items() for name, values in product.items()}
        store.store(key_of(HANDED, sorted(products)), arrays)


def _unpacked(arrays: Mapping[str, Array]) -> dict[str, dict[str, Array]]:
    found: dict[str, dict[str, Array]] = {}
    for name, values in arrays.items():
        key, _, own = name.partition(":")
        found.setdefault(key, {})[own] = values
    return found
