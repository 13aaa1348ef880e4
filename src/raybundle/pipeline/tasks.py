"""Tasks: what a process that shares nothing but the store can do by itself.

A task names a function, not an object: it can be written down, sent to another process or another machine and done
there, and its product depends on nothing but its options and the products that it names.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from importlib import import_module
from typing import Any, cast, get_type_hints

from raybundle.errors import InputError
from raybundle.pipeline.store import Folder, Product

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
    failed: str = ""
    """why it has no product; empty: it has"""


@lru_cache
def function_of(name: str) -> TaskFunction:
    """The function "module:name"; raises TypeError for a name that is none."""
    module, _, attribute = name.partition(":")
    found = getattr(import_module(module), attribute, None) if attribute else None
    if not callable(found):
        raise TypeError(f"{name!r} names no function; a task's function is called module:name")
    return cast("TaskFunction", found)


def options_of(name: str) -> type:
    """The data class of the options of a function, by its annotation."""
    hints = get_type_hints(function_of(name))
    hints.pop("return", None)
    return list(hints.values())[1]


def do(task: Task, store: Folder) -> Done:
    """Do a task; bad input costs this task alone."""
    try:
        product = function_of(task.function)(store, task.options)
    except InputError as error:
        return Done(task=task, failed=str(error))
    if task.small:
        return Done(task=task, product=product)
    store.store(task.key, product)
    return Done(task=task)
