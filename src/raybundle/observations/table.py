"""Tables of observations: what their columns hold is declared, so that selecting, merging, keeping and reading is one.

A table is a frozen dataclass whose fields are arrays with a row for each observation, made by `cells`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any, ClassVar, Literal, cast

import numpy as np

from raybundle.numerics.arrays import Index, Mask
from raybundle.numerics.records import Column, Records, Refers, Stuck, as_field
from raybundle.numerics.transform import SimilarityTransform


@dataclass(frozen=True, slots=True, kw_only=True)
class Cells(Column):
    """What a field of a table holds, and its columns in a file."""

    of: Literal["number", "text", "point", "image", "instrument"]
    """Numbers, texts, or positions of object points, images or instruments of the block."""
    names: tuple[str, ...]
    """Names of its columns in a file; of more than one the field is (k, len(names))"""
    unit: Literal["", "deg"] = ""
    """Of the file where it is not that of the field: degrees for radians"""
    limit: Literal["", "> 0", ">= 0"] = ""
    model: str = ""
    """Of an instrument: its model"""


def cells(of: Literal["number", "text", "point", "image", "instrument"], *names: str, **how: Any) -> Any:
    """A field of a table, see `Cells`; numbers say how they follow a transformation."""
    if of == "number" and "follows" not in how:
        raise TypeError(f"{', '.join(names)}: say how it follows a transformation (follows=)")
    return as_field(Cells(of=of, names=names, shape=(len(names),) if len(names) > 1 else (), **how))


@dataclass(frozen=True, slots=True)
class Wrong:
    """Rows that a table must not hold."""

    rows: Mask
    """(k,)"""
    column: str
    message: Callable[[int], str]
    """Of a row"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Table(Records):
    """Observations of one kind, a row each."""

    name: ClassVar[str]
    """Of its file, without the ending"""
    upright: ClassVar[bool] = False
    """Whether its rows are true only of what stands upright in the frame of the object"""

    @classmethod
    def cells(cls) -> Iterator[tuple[str, Cells]]:
        """Fields and what they hold."""
        return cast("Iterator[tuple[str, Cells]]", cls.columns())

    def stuck(self, by: SimilarityTransform) -> Sequence[Stuck]:
        """Rows that cannot follow a transformation: those of its columns, all that are upright where it tilts."""
        return [*Records.stuck(self, by), *self.tilted(by)]

    def tilted(self, by: SimilarityTransform) -> Sequence[Stuck]:
        """Rows that a transformation tilts although they are true only of what is upright."""
        if not (self.upright and by.tilts):
            return []
        angle = np.degrees(np.arccos(np.clip(by.rotation[2, 2], -1, 1)))
        return [Stuck(np.ones(len(self), bool), f"it is about the vertical, which is turned by {angle:.3g} deg")]

    def pairs(self, to: Refers) -> Index:
        """(k, 2) points, images or instruments that stand in one row."""
        found = [f for name, c in self.cells() if c.of == to and (f := getattr(self, name)) is not None]
        pairs = [np.stack([a, b], axis=1) for a, b in combinations(found, 2)]
        return np.concatenate([np.zeros((0, 2), np.int32), *pairs])

    def wrong(self) -> Sequence[Wrong]:
        """What no file may hold beyond what `cells` says."""
        return ()


def again(positions: Index) -> Mask:
    """(k,) whether what a row names stands in an earlier row."""
    found = np.ones(len(positions), bool)
    found[np.unique(positions, return_index=True)[1]] = False
    return found
