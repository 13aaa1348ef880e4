"""Elements of a file that a reader passes over: counted by name, reported in one note."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable

from raybundle.io.reading.words import quoted

SHOWN = 8
"""Names in the note."""


class PassedOver:
    """Elements that a reader does not use."""

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()

    def count(self, name: str, times: int = 1) -> None:
        """Add an element."""
        self.counts[name] += times

    def unknown(self, names: Iterable[str], known: Collection[str], where: str = "") -> None:
        """Add those of some names that a reader does not know, each with the place of its group before it."""
        for name in names:
            if name not in known:
                self.count(f"{where}{name}")

    def note(self) -> tuple[str, ...]:
        """One note; none where everything is used."""
        if not self.counts:
            return ()
        shown = [f"{_word(n)} ({k})" if k > 1 else _word(n) for n, k in list(self.counts.items())[:SHOWN]]
        more = len(self.counts) - len(shown)
        return (f"not read: {', '.join(shown)}{f' and {more} more' if more > 0 else ''}",)


def _word(name: str) -> str:
    return name if name.isprintable() and len(name) <= 60 and name.strip() == name else quoted(name)
