"""What each task of a run takes: CPU seconds, bytes read and written, and on which tasks it waits."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from raybundle.adjustment.system.dense import one_thread
from raybundle.numerics.arrays import Array
from raybundle.pipeline.place import Product
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Done, Task, do


@dataclass(frozen=True, slots=True, kw_only=True)
class TaskRecord:
    """A task as it was done."""

    name: str
    """its function, without the module"""
    node: int
    """tree node that it works on, -1: none"""
    key: str
    inputs: tuple[str, ...]
    """keys of the products that it waits for"""
    seconds: float
    """CPU"""
    read: int
    """bytes of the arrays that it asked for"""
    written: int
    """bytes of the arrays of its product"""


class CountingFolder(Folder):
    """A store that counts the bytes of the arrays that pass through it."""

    __slots__ = ("counts",)

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        object.__setattr__(self, "counts", {"read": 0, "written": 0})  # the class is frozen

    counts: dict[str, int]

    def _read_so(self, found: dict[str, Array]) -> dict[str, Array]:
        self.counts["read"] += sum(values.nbytes for values in found.values())
        return found

    def wanted(self, key: str, names: Sequence[str] = ()) -> dict[str, Array]:
        """A product that was there before."""
        return self._read_so(Folder.wanted(self, key, names))

    def lent(self, key: str, names: Sequence[str] = ()) -> dict[str, Array]:
        """The same, mapped; counted as if all of it were read."""
        return self._read_so(Folder.lent(self, key, names))

    def store(self, key: str, product: Product) -> None:
        """Keep a product."""
        self.counts["written"] += sum(values.nbytes for values in product.values())
        Folder.store(self, key, product)


@dataclass(slots=True)
class Recording:
    """Does tasks one after the other with one thread, and keeps what each took."""

    records: list[TaskRecord] = field(default_factory=list[TaskRecord])
    begun: float | None = None
    """CPU seconds of this process when the first task began"""

    def run(self, tasks: Sequence[Task], store: Any) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        if self.begun is None:
            self.begun = time.process_time()
        with one_thread():
            for task in tasks:
                before, began = dict(store.counts), time.process_time()
                done = do(task, store)
                took = time.process_time() - began
                self.records.append(
                    TaskRecord(
                        name=task.function.rpartition(":")[2],
                        node=int(getattr(task.options, "node", -1)),
                        key=task.key,
                        inputs=task.inputs,
                        seconds=took,
                        read=store.counts["read"] - before["read"],
                        written=store.counts["written"] - before["written"],
                    )
                )
                yield done
