"""Tables of observations: what their columns hold is declared, so that selecting, merging, keeping and reading is one.

A table is a frozen dataclass whose fields are arrays with a row for each observation, made by `cells`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from itertools import combinations
from typing import Any, ClassVar, Literal, Self

import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask

Refers = Literal["point", "image", "instrument"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Cells:
    """What a field of a table holds."""

    of: Literal["number", "text", "point", "image", "instrument"]
    """Numbers, texts, or positions of object points, images or instruments of the block."""
    names: tuple[str, ...]
    """Names of its columns in a file; of more than one the field is (k, len(names))"""
    unit: Literal["", "deg"] = ""
    """Of the file where it is not that of the field: degrees for radians"""
    limit: Literal["", "> 0", ">= 0"] = ""
    empty: bool = False
    """Whether a cell may be empty: NaN, or the position -1"""
    optional: bool = False
    """Whether the columns may be lacking: None"""
    fill: float = float("nan")
    """What a row holds whose table lacks the columns, beside rows that have them"""
    model: str = ""
    """Of an instrument: its model"""


def cells(of: Literal["number", "text", "point", "image", "instrument"], *names: str, **how: Any) -> Any:
    """A field of a table, see `Cells`."""
    made = Cells(of=of, names=names, **how)
    return field(metadata={"cells": made}, default=None) if made.optional else field(metadata={"cells": made})


@dataclass(frozen=True, slots=True)
class Wrong:
    """Rows that a table must not hold."""

    rows: Mask
    """(k,)"""
    column: str
    message: Callable[[int], str]
    """Of a row"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """Observations of one kind, a row each."""

    name: ClassVar[str]
    """Of its file, without the ending"""

    def __len__(self) -> int:
        first = next(iter(fields(self)))
        return len(getattr(self, first.name))

    @classmethod
    def cells(cls) -> Iterator[tuple[str, Cells]]:
        """Fields and what they hold."""
        for f in fields(cls):
            yield f.name, f.metadata["cells"]

    @classmethod
    def empty(cls) -> Self:
        """A table without rows."""
        return cls(**{name: None if c.optional else _nothing(c) for name, c in cls.cells()})

    def rows(self, keep: Mask | Index) -> Self:
        """Some of its rows: a mask (k,) or positions."""
        at: list[int] = (np.flatnonzero(keep) if np.asarray(keep).dtype == bool else np.asarray(keep)).tolist()

        def some(values: Any) -> Any:
            return (
                values if values is None else tuple(values[k] for k in at) if isinstance(values, tuple) else values[at]
            )

        return replace(self, **{name: some(getattr(self, name)) for name, _ in self.cells()})

    def refers(self, to: Refers) -> Index:
        """Positions of the object points, images or instruments that its rows name, each once."""
        found = [getattr(self, name) for name, c in self.cells() if c.of == to]
        used = np.unique(np.concatenate([np.zeros(0, np.int32), *(f for f in found if f is not None)]))
        return used[used >= 0].astype(np.int32)

    def pairs(self, to: Refers) -> Index:
        """(k, 2) points, images or instruments that stand in one row."""
        found = [f for name, c in self.cells() if c.of == to and (f := getattr(self, name)) is not None]
        pairs = [np.stack([a, b], axis=1) for a, b in combinations(found, 2)]
        return np.concatenate([np.zeros((0, 2), np.int32), *pairs])

    def renumbered(self, to: Refers, new: Index) -> Self:
        """With new positions of points, images or instruments, given for each old one; rows that name a -1 leave."""
        named = [(name, c) for name, c in self.cells() if c.of == to and getattr(self, name) is not None]
        if not named:
            return self
        keep, changed = np.ones(len(self), bool), dict[str, Any]()
        for name, c in named:
            old = np.asarray(getattr(self, name))
            at = np.where(old >= 0, np.append(np.asarray(new), -1)[old], -1).astype(np.int32)
            changed[name] = at
            if not c.empty:
                keep &= at >= 0
        moved = replace(self, **changed)
        return moved if keep.all() else moved.rows(keep)

    @classmethod
    def joined(cls, tables: Sequence[Self]) -> Self:
        """The rows of several tables one after the other."""

        def of(name: str, c: Cells) -> Any:
            parts = [getattr(t, name) for t in tables]
            if all(p is None for p in parts):
                return None if c.optional else _nothing(c)
            parts = [_filled(c, len(t)) if p is None else p for p, t in zip(parts, tables, strict=True)]
            return sum(parts, ()) if c.of == "text" else np.concatenate(parts)

        return cls(**{name: of(name, c) for name, c in cls.cells()})

    def arrays(self) -> dict[str, Array]:
        """Its fields as arrays, of which `of_arrays` makes the equal table."""
        found = {name: getattr(self, name) for name, _ in self.cells()}
        return {name: np.array(v, np.str_) if isinstance(v, tuple) else v for name, v in found.items() if v is not None}

    @classmethod
    def of_arrays(cls, found: Mapping[str, Array]) -> Self:
        """The table that `arrays` was called of."""
        made = {
            name: tuple(found[name].tolist()) if c.of == "text" else found[name]
            for name, c in cls.cells()
            if name in found
        }
        return cls(**made)

    def wrong(self) -> Sequence[Wrong]:
        """What no file may hold beyond what `cells` says."""
        return ()


def _nothing(c: Cells) -> Any:
    return () if c.of == "text" else _filled(c, 0)


def _filled(c: Cells, count: int) -> Any:
    if c.of == "text":
        return ("",) * count
    if c.of != "number":
        return np.full(count, -1, np.int32)
    return np.full((count, len(c.names)) if len(c.names) > 1 else count, c.fill)


def again(positions: Index) -> Mask:
    """(k,) whether what a row names stands in an earlier row."""
    found = np.ones(len(positions), bool)
    found[np.unique(positions, return_index=True)[1]] = False
    return found
