"""Ledger of the elements of a file that its reader passed over.

JSON and XML trees count for themselves: what the reader never asked for.  Readers of text and binary files enter what
they pass over.  A reader declares names that carry no geometry.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Generator, Iterable, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import Protocol

from raybundle.errors import Text, phrase
from raybundle.io.reading.words import quoted

NAMED = 6
"""Kinds of elements that a sentence names; the data hold all of them."""
LONGEST = 80
"""Characters of a kind that stand without quotes; longer ones are cut."""


class Tree(Protocol):
    """A file as a tree that knows which of its elements were asked for."""

    def passed_over(self) -> Iterable[tuple[str, str]]:
        """Name and kind, the name with the place, of each element that nothing asked for."""
        ...


@dataclass(slots=True)
class Ledger:
    """Elements passed over, by kind."""

    trees: list[Tree] = field(default_factory=list["Tree"])
    entries: Counter[str] = field(default_factory=Counter[str])
    declared: set[str] = field(default_factory=set[str])
    """Names that carry no geometry, and kinds."""

    def counts(self) -> dict[str, int]:
        """Number of elements of each kind, the most frequent first."""
        total = Counter(self.entries)
        for tree in self.trees:
            total.update(kind for name, kind in tree.passed_over() if not self.declared & {name, kind})
        return dict(total.most_common())


_open: ContextVar[Ledger | None] = ContextVar("ledger", default=None)


@contextmanager
def ledger() -> Generator[Ledger]:
    """A ledger of everything that is read within."""
    found = Ledger()
    token = _open.set(found)
    try:
        yield found
    finally:
        _open.reset(token)


def enter_tree(tree: Tree) -> None:
    """Enter a file whose elements count for themselves."""
    if (found := _open.get()) is not None:
        found.trees.append(tree)


def enter(kind: str, count: int = 1) -> None:
    """Enter elements that a reader passes over."""
    if count and (found := _open.get()) is not None:
        found.entries[_printed(kind)] += count


def declare(*names: str) -> None:
    """Declare names, or kinds, of elements that carry no geometry; they do not count as passed over."""
    if (found := _open.get()) is not None:
        found.declared.update(names)


def not_read(counts: Mapping[str, int]) -> tuple[Text, ...]:
    """A remark on the elements passed over; () where there is none."""
    if not counts:
        return ()
    kinds = [f"{n} {kind}" for kind, n in counts.items()]
    return (phrase("import.not_read", n=sum(counts.values()), kinds=kinds),)


def _printed(kind: str) -> str:
    return kind if kind.isprintable() and len(kind) <= LONGEST and kind.strip() == kind else quoted(kind)
