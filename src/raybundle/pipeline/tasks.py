"""Tasks: what a process that shares nothing but the store can do by itself.

A task names a function, not an object: it can be written down, sent to another process or another machine and done
there, and its product depends on nothing but its options and the products that it names.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable
from dataclasses import dataclass, field, is_dataclass, replace
from functools import lru_cache
from importlib import import_module
from typing import Any, cast, get_type_hints

import msgspec

from raybundle.errors import InputError, Message, as_detail, as_error, message
from raybundle.io.copies import StoreLost
from raybundle.pipeline.place import Product, ProductGone
from raybundle.pipeline.store import Folder
from raybundle.pipeline.task_functions import is_registered

TaskFunction = Callable[[Folder, Any], Product]
"""(store, options) -> product; reads the products that the task names, and writes none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """One piece of a stage."""

    key: str
    """of its product: the hash of everything that it depends on"""
    function: str
    """as "module:name"; called with the store and the options"""
    options: object
    """frozen data class of plain data: numbers, texts, paths and data classes of them"""
    inputs: tuple[str, ...] = ()
    """keys of the products that it reads, kept before or made by other tasks"""
    after: tuple[str, ...] = ()
    """keys of tasks that must be done before, beside those of its inputs"""
    cost: float = 1.0
    """rough CPU seconds, for the order and the time that is left"""
    memory: float = 0.0
    """rough bytes that it needs beside its product"""
    small: bool = False
    """its product is a few numbers: it is handed back, not kept in the store"""
    name: str = ""
    """what it works on, in words, as a photograph's name"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Done:
    """A task that was done, or could not be."""

    task: Task
    product: Product = field(default_factory=dict[str, Any])
    """of a small task"""
    failed: Message | None = None
    """why it has no product; None: it has"""
    lost: str = ""
    """key of a product that it needs and that was found damaged or gone"""
    trouble: str = ""
    """what a program has to say of an error that is no bad input: it may be tried again"""
    keep_now: bool = False
    """small products so far are to be kept before the next is asked for: who did them forgets them then"""
    stop: Message | None = None
    """why no task can be done any more, as where the disk is full"""
    cpu_s: float = 0.0
    """CPU seconds of another process that did it; those of this process count by themselves"""


@lru_cache
def function_of(name: str) -> TaskFunction:
    """The function "module:name"; raises TypeError for a name that is not registered, before anything is imported."""
    module, _, attribute = name.partition(":")
    if not is_registered(module, attribute):
        raise TypeError(f"{name!r} is no function of tasks: it is not registered")
    found = getattr(import_module(module), attribute, None)
    if not callable(found):
        raise TypeError(f"{name!r} names no function; a task's function is called module:name")
    return cast("TaskFunction", found)


def options_of(name: str) -> type:
    """The data class of the options of a function, by its annotation; raises TypeError for what does no tasks."""
    try:
        hints = get_type_hints(function_of(name))
    except (TypeError, ImportError, ValueError, AttributeError, NameError) as error:
        raise TypeError(f"{name!r} is no function of tasks ({error})") from None
    hints.pop("return", None)
    kinds = [*hints.values()]
    if len(kinds) != 2 or not is_dataclass(kinds[1]):
        raise TypeError(f"{name!r} is no function of tasks")
    return cast("type", kinds[1])


def do(task: Task, store: Folder) -> Done:
    """Do a task; whatever goes wrong costs this task alone, but where products can be neither read nor written."""
    try:
        product = function_of(task.function)(store, task.options)
    except ProductGone as error:
        return Done(task=task, failed=as_detail(error), lost=error.key)
    except StoreLost as error:
        return Done(task=task, failed=as_detail(error), stop=as_detail(error))
    except InputError as error:
        return Done(task=task, failed=as_detail(error))
    except Exception as error:  # noqa: BLE001  (it is reported with its traceback in the log, after some attempts)
        failed = message("task.failed", kind=type(error).__name__, detail=str(error))
        return Done(task=task, failed=failed, trouble=traceback.format_exc())
    if task.small:
        return Done(task=task, product=product)
    try:
        store.store(task.key, product)
    except InputError as error:
        return Done(task=task, failed=as_detail(error), stop=as_detail(error))
    return Done(task=task)


def made(task: Task, store: Folder) -> None:
    """Do a task once more whose product was found damaged; raises InputError where it cannot be made."""
    done = do(task, store)
    if done.lost:
        raise ProductGone(done.lost, store.place.name)
    if done.failed:
        raise as_error(done.failed)


def written(task: Task) -> bytes:
    """A task as a line of text, as it could lie in a file."""
    return msgspec.json.encode(replace(task, options=msgspec.to_builtins(task.options, enc_hook=str)))


def read_task(text: bytes) -> Task:
    """The same task; its options are of the data class that its function takes."""
    task = msgspec.json.decode(text, type=Task)
    kind = options_of(task.function)
    return replace(task, options=msgspec.convert(task.options, kind, dec_hook=lambda wanted, given: wanted(given)))


def do_written(text: bytes, store: Folder) -> Done:
    """Do a task that was written down; what is handed back names it by its key.

    Where its product is there already, as after a process was killed, nothing is done again.
    """
    task = read_task(text)
    try:
        done = Done(task=task) if not task.small and store.has(task.key) else do(task, store)
    except StoreLost as error:
        done = Done(task=task, failed=as_detail(error), stop=as_detail(error))
    return replace(done, task=replace(task, options=None))
