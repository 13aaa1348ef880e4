"""A block as columns that are read a piece at a time: what need not be in memory as a whole."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Protocol

import numpy as np

from raybundle.block import Block, Observations, Points
from raybundle.numerics.arrays import Array, Index

PIECE = 500_000
"""Rows that are read at once."""


class Columns(Protocol):
    """A block whose object points and image observations are read piece by piece."""

    @property
    def bare(self) -> Block:
        """The block without object points and image observations."""
        ...

    @property
    def points(self) -> int:
        """How many object points."""
        ...

    @property
    def observations(self) -> int:
        """How many image observations."""
        ...

    def pieces_of_points(self) -> Iterator[tuple[int, Points]]:
        """The object points, a piece at a time, each with the position of its first."""
        ...

    def pieces_of_observations(self) -> Iterator[tuple[int, Observations]]:
        """The image observations, a piece at a time, each with the position of its first."""
        ...

    def points_at(self, at: Index) -> Points:
        """Some object points, by positions that ascend."""
        ...


@dataclass(frozen=True, slots=True)
class InMemory:
    """A block that lies in memory, as columns."""

    block: Block

    @property
    def bare(self) -> Block:
        """The block without object points and image observations."""
        b = self.block
        return replace(b, points=b.points.empty(), observations=b.observations.empty(), rejected=())

    @property
    def points(self) -> int:
        """How many object points."""
        return len(self.block.points)

    @property
    def observations(self) -> int:
        """How many image observations."""
        return len(self.block.observations)

    def pieces_of_points(self) -> Iterator[tuple[int, Points]]:
        """The object points, a piece at a time."""
        for begin in range(0, self.points, PIECE):
            yield begin, self.block.points.rows(np.arange(begin, min(begin + PIECE, self.points)))

    def pieces_of_observations(self) -> Iterator[tuple[int, Observations]]:
        """The image observations, a piece at a time."""
        for begin in range(0, self.observations, PIECE):
            yield begin, self.block.observations.rows(np.arange(begin, min(begin + PIECE, self.observations)))

    def points_at(self, at: Index) -> Points:
        """Some object points."""
        return self.block.points.rows(at)


OBSERVATIONS: Mapping[str, tuple[str, tuple[int, ...]]] = {
    "image": ("<i4", ()), "point": ("<i4", ()), "xy_px": ("<f8", (2,)), "cov_px2": ("<f8", (3,)),
}  # fmt: skip
POINTS: Mapping[str, tuple[str, tuple[int, ...]]] = {
    "role": ("<i4", ()), "xyz": ("<f8", (3,)), "sigma": ("<f8", (3,)), "window": ("<f8", ()),
    "misfit": ("<f8", ()), "relief": ("<f8", ()), "sigma_curvature": ("<f8", ()), "ids": ("<U24", ()),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class InFiles:
    """Columns of object points and image observations in files of numbers, one each, beside the rest of a block."""

    bare: Block
    folder: Path

    @classmethod
    def of(cls, block: Block, folder: Path) -> InFiles:
        """Write the columns of a block into a folder."""
        folder.mkdir(parents=True, exist_ok=True)
        for table, columns in (("observations", OBSERVATIONS), ("points", POINTS)):
            for name, (kind, _) in columns.items():
                values = getattr(getattr(block, table), name)
                values = np.full(len(getattr(block, table)), np.nan) if values is None else np.array(values)
                values.astype(kind).tofile(folder / f"{table}.{name}")
        return cls(InMemory(block).bare, folder)

    def _count(self, table: str, name: str) -> int:
        columns = OBSERVATIONS if table == "observations" else POINTS
        kind, shape = columns[name]
        width = np.dtype(kind).itemsize * int(np.prod(shape, dtype=int))
        return (self.folder / f"{table}.{name}").stat().st_size // width

    @property
    def points(self) -> int:
        """How many object points."""
        return self._count("points", "role")

    @property
    def observations(self) -> int:
        """How many image observations."""
        return self._count("observations", "image")

    def _read(self, table: str, begin: int, end: int) -> dict[str, Array]:
        columns = OBSERVATIONS if table == "observations" else POINTS
        found = dict[str, Array]()
        for name, (kind, shape) in columns.items():
            width = np.dtype(kind).itemsize * int(np.prod(shape, dtype=int))
            with (self.folder / f"{table}.{name}").open("rb") as file:
                file.seek(begin * width)
                found[name] = np.frombuffer(file.read((end - begin) * width), kind).reshape(-1, *shape)
        return found

    def pieces_of_points(self) -> Iterator[tuple[int, Points]]:
        """The object points, a piece at a time."""
        for begin in range(0, self.points, PIECE):
            found = self._read("points", begin, min(begin + PIECE, self.points))
            yield begin, _points(found)

    def pieces_of_observations(self) -> Iterator[tuple[int, Observations]]:
        """The image observations, a piece at a time."""
        for begin in range(0, self.observations, PIECE):
            yield begin, Observations(**self._read("observations", begin, min(begin + PIECE, self.observations)))

    def points_at(self, at: Index) -> Points:
        """Some object points, by positions that ascend."""
        found = dict[str, Array]()
        for name, (kind, shape) in POINTS.items():
            values = np.memmap(self.folder / f"points.{name}", kind, "r").reshape(-1, *shape)
            found[name] = np.array(values[at])
        return _points(found)


def _points(found: Mapping[str, Array]) -> Points:
    return Points(
        ids=tuple(found["ids"].tolist()), role=found["role"], xyz=found["xyz"], sigma=found["sigma"],
        window=found["window"], misfit=found["misfit"], relief=found["relief"],
        sigma_curvature=found["sigma_curvature"],
    )  # fmt: skip


assert {f.name for f in fields(Observations)} == set(OBSERVATIONS)
assert {f.name for f in fields(Points)} == set(POINTS)
