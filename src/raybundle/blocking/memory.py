"""A store in memory, and tasks done one after the other: a network in parts within one process."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from raybundle.adjustment.system.dense import one_thread
from raybundle.numerics.arrays import Array
from raybundle.pipeline.place import Product
from raybundle.pipeline.tasks import Done, Task, do


@dataclass(frozen=True, slots=True)
class Memory:
    """Products in memory; they are not copied, and nobody writes into them."""

    kept: dict[str, Product] = field(default_factory=dict[str, Product])

    def has(self, key: str) -> bool:
        """Whether a product is there."""
        return key in self.kept

    def wanted(self, key: str, names: tuple[str, ...] = ()) -> dict[str, Array]:
        """A product, or some of its arrays; KeyError where it is not there."""
        found = self.kept[key]
        return {name: found[name] for name in names} if names else dict(found)

    def lent(self, key: str, names: tuple[str, ...] = ()) -> dict[str, Array]:
        """The same."""
        return self.wanted(key, names)

    def store(self, key: str, product: Product) -> None:
        """Keep a product."""
        self.kept[key] = product

    def forget(self, key: str) -> None:
        """Let a product go, where it is there."""
        self.kept.pop(key, None)


@dataclass(frozen=True, slots=True)
class Serial:
    """Does tasks in their order, in this process, with one thread."""

    def run(self, tasks: Sequence[Task], store: Any) -> Iterator[Done]:
        """Do tasks and yield them as they end."""
        with one_thread():
            for task in tasks:
                yield do(task, store)
