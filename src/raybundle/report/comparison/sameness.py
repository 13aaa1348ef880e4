"""Whether two results say the same, number by number: as of runs by one machine and by many."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import phrase
from raybundle.io.reading.rows import BadRow, cells_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Sameness:
    """How tables of two result folders differ that both have."""

    tables: int
    equal: int
    """of them those that are the same to the last bit"""
    difference: float = 0.0
    """largest one of two numbers at the same place, over the largest number of their column"""
    where: tuple[str, str] = ("", "")
    """column and table of it"""
    unlike: str = ""
    """table whose rows or texts are others; empty: none"""

    @property
    def sentence(self) -> str:
        """What there is to report; empty where there is nothing to compare."""
        if not self.tables:
            return ""
        if self.unlike:
            return phrase("sameness.unlike", table=self.unlike)
        if self.equal == self.tables:
            return phrase("sameness.all", n=self.tables)
        return phrase(
            "sameness.some", n=self.equal, of=self.tables, difference=self.difference, name=self.where[0],
            table=self.where[1],
        )  # fmt: skip


def _in_both(first: Path, second: Path) -> list[str]:
    return sorted({p.name for p in first.glob("*.csv")} & {p.name for p in second.glob("*.csv")})


def all_same(first: Path, second: Path) -> bool:
    """Whether the CSV tables that two result folders both have are the same to the last bit, and there are any."""
    names = _in_both(first, second)
    return bool(names) and all((first / n).read_bytes() == (second / n).read_bytes() for n in names)


def sameness(first: Path, second: Path) -> Sameness:
    """Compare the CSV tables that two result folders both have."""
    names = _in_both(first, second)
    equal, worst, where, unlike = 0, 0.0, ("", ""), ""
    for name in names:
        a, b = ((folder / name).read_bytes() for folder in (first, second))
        if a == b:
            equal += 1
            continue
        found = _differences(a.decode("utf-8", "replace"), b.decode("utf-8", "replace"))
        if found is None:
            unlike = unlike or name
            continue
        for column, value in found:
            if value > worst:
                worst, where = value, (column, name)
    return Sameness(tables=len(names), equal=equal, difference=worst, where=where, unlike=unlike)


def _differences(a: str, b: str) -> Iterator[tuple[str, float]] | None:
    """Largest difference of each column; None where rows, columns or texts are others."""
    try:
        one, other = (list(cells_of(text.splitlines())) for text in (a, b))
    except BadRow:
        return None
    if [len(row) for row in one] != [len(row) for row in other] or one[0] != other[0]:
        return None
    found: list[tuple[str, float]] = []
    for k, column in enumerate(one[0]):
        mine, yours = ([row[k] for row in rows[1:] if k < len(row)] for rows in (one, other))
        if mine == yours:
            continue
        try:
            x, y = np.array(mine, object), np.array(yours, object)
            empty = x == ""
            if not np.array_equal(empty, y == ""):
                return None
            u, v = x[~empty].astype(float), y[~empty].astype(float)
        except ValueError:
            return None
        largest = float(max(np.abs(u).max(initial=0.0), np.abs(v).max(initial=0.0)))
        found.append((column, float(np.abs(u - v).max(initial=0.0)) / max(largest, 1e-300)))
    return iter(found)
