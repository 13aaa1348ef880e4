"""Where the files of products lie: what a folder and an object store have in common."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Protocol

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

Product = Mapping[str, Array]
"""What a task or a stage gives, as it is kept."""


class ProductGone(InputError):
    """A product that was there is damaged or gone: the folder was changed meanwhile."""

    def __init__(self, key: str, where: str) -> None:
        super().__init__("product.gone", stage=kind_of(key), file=where)
        self.key = key


class Place(Protocol):
    """Where the files of products lie."""

    @property
    def name(self) -> str:
        """As people know it."""
        ...

    @property
    def shared(self) -> bool:
        """Whether other processes see it."""
        ...

    def check(self) -> None:
        """Raise InputError where it cannot be reached, or nothing can be kept there."""
        ...

    def has(self, key: str) -> bool:
        """Whether a whole file of this product is there."""
        ...

    def those(self, keys: Sequence[str]) -> set[str]:
        """Those of which a whole file is there."""
        ...

    def file(self, key: str) -> Path | None:
        """A file on this machine; None: there is none.  Another process may take it away before it is opened."""
        ...

    def damaged(self, key: str, again: bool, which: FileMark | None) -> None:  # noqa: FBT001  (which of two)
        """Remove a file whose numbers are wrong; `again`: also the second one that was read.

        which   the file that was read: where another stands there now, someone has made the product again, and it stays
        """
        ...

    def keep(self, key: str, product: Product) -> None:
        """Keep a product; its file appears whole or not at all."""
        ...

    def keys_of_kind(self, kind: str) -> list[str]:
        """Keys of all products whose key begins with this word, in order."""
        ...

    def forget(self, *keys: str) -> None:
        """Remove files."""
        ...

    def text(self, name: str) -> str | None:
        """A text that is no product; None: there is none."""
        ...

    def keep_text(self, name: str, text: str) -> str:
        """Keep a text, whole or not at all; where."""
        ...

    def forget_text(self, name: str) -> None:
        """Remove a text."""
        ...

    def clear(self) -> None:
        """Remove everything that is ours."""
        ...


FileMark = tuple[int, int, int]
"""What shows a file from another one that is put in its place: number, time [ns], length."""


def mark_of(file: Path | int) -> FileMark | None:
    """Of a path, or a file that is open; None where there is none."""
    try:
        now = os.fstat(file) if isinstance(file, int) else file.stat()
    except OSError:
        return None
    return now.st_ino, now.st_mtime_ns, now.st_size


def kind_of(key: str) -> str:
    """The word with which a key begins."""
    return key.rpartition("-")[0]
