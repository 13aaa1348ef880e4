"""Where the tasks of networks in parts keep their products."""

from __future__ import annotations

from typing import Protocol

from raybundle.numerics.arrays import Array
from raybundle.pipeline.place import Product

VERSION = 2
"""Raised with every change of what the tasks give."""


class Store(Protocol):
    """Where products are kept: `pipeline.store.Folder`, or memory."""

    def has(self, key: str) -> bool:
        """Whether a product is there."""
        ...

    def wanted(self, key: str, names: tuple[str, ...] = ()) -> dict[str, Array]:
        """A product, or some of its arrays; an error where it is not there."""
        ...

    def lent(self, key: str, names: tuple[str, ...] = ()) -> dict[str, Array]:
        """The same, not to be written into."""
        ...

    def store(self, key: str, product: Product) -> None:
        """Keep a product."""
        ...

    def forget(self, key: str) -> None:
        """Let a product go, where it is there."""
        ...
