"""Block folders that no memory holds: the image observations are read from their table a piece at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from raybundle.block import Block, Observations, Points
from raybundle.errors import InputError
from raybundle.io.block.folder import read_without_observations
from raybundle.io.block.image_points import columns_for, observations_of
from raybundle.io.block.observations import read_observation_tables
from raybundle.io.block.points import with_tie_points
from raybundle.io.parquet import rows_in
from raybundle.io.table_files import table_file
from raybundle.io.tables import check_pair_keys, table_pieces
from raybundle.numerics import large
from raybundle.numerics.arrays import Index, Mask
from raybundle.numerics.progress import Progress, silent

PIECE = 1 << 18
"""Object points of a piece."""


@dataclass(frozen=True, slots=True)
class InTables:
    """A block folder whose image observations stand in observations.parquet, as columns that are read piece by piece.

    Object points lie in memory, some 250 bytes each; image observations do not.
    """

    bare: Block
    """Without object points and image observations."""
    every_point: Points
    observations: int
    rejected: Mask
    """(m,) image observations that an adjustment before found wrong."""
    path: Path
    """observations.parquet"""
    at: dict[str, dict[str, int]] = field(repr=False)
    """"image", "point" -> id -> position."""

    @property
    def points(self) -> int:
        """How many object points."""
        return len(self.every_point)

    def pieces_of_points(self) -> Iterator[tuple[int, Points]]:
        """The object points, a piece at a time, each with the position of its first."""
        for begin in range(0, self.points, PIECE):
            yield begin, self.every_point.rows(np.arange(begin, min(begin + PIECE, self.points)))

    def pieces_of_observations(self) -> Iterator[tuple[int, Observations]]:
        """The image observations, a piece at a time, each with the position of its first."""
        for begin, found, _ in _pieces(self.path, self.at["image"], self.at["point"]):
            yield begin, found

    def points_at(self, at: Index) -> Points:
        """Some object points, by positions that ascend."""
        return self.every_point.rows(at)

    def whole(self) -> Block:
        """The block, as `read_block` reads it; its image observations are large arrays (`numerics.large`)."""
        kept = {"image": large.zeros(self.observations, np.int32), "point": large.zeros(self.observations, np.int32)}
        kept |= {"xy_px": large.zeros((self.observations, 2)), "cov_px2": large.zeros((self.observations, 3))}
        for begin, o in self.pieces_of_observations():
            for name, values in kept.items():
                values[begin : begin + len(o)] = getattr(o, name)
        o, ids = Observations(**kept), self.every_point.ids
        rows = np.flatnonzero(self.rejected)
        pairs = zip(o.image[rows].tolist(), o.point[rows].tolist(), strict=True)
        return replace(
            self.bare, points=self.every_point, observations=o,
            rejected=tuple((self.bare.images.ids[i], ids[p]) for i, p in pairs),
        )  # fmt: skip


def read_in_pieces(path: str | Path, *, progress: Progress = silent) -> InTables:
    """The block in a folder with observations.parquet, of whose image observations never all are in memory.

    raises  InputError as `read_block`, and where the table is not Parquet; every row is checked here, once

    Limits: whether the file is changed afterwards.
    """
    bare, points, at = read_without_observations(path)
    file = table_file(Path(path), "observations")
    if file.suffix != ".parquet":
        raise InputError("block.observations_not_parquet", file=file)
    images, names = at["image"], at["point"]
    keys, wrong = list[Index](), list[Mask]()
    for begin, found, rejected in _pieces(file, images, names):
        keys.append(np.asarray(found.image, np.int64) << 32 | np.asarray(found.point, np.int64))
        wrong.append(rejected)
        progress("reading", min(0.9, begin / 1e7))
    if not keys or not sum(map(len, keys)):
        raise InputError("table.too_few_rows", n=0, least=1, file=file)
    key = np.concatenate(keys)
    keys.clear()
    check_pair_keys(file, key, ("image", "point"))
    progress("reading", 1.0)
    bare = replace(bare, tables=read_observation_tables(Path(path), images, names, bare.instruments))
    return InTables(
        bare=bare, every_point=with_tie_points(points, tuple(names)[len(points) :]), observations=len(key),
        rejected=np.concatenate(wrong), path=file, at=at,
    )  # fmt: skip


def image_points_in(path: str | Path) -> int | None:
    """How many image observations a block folder holds that can be read in pieces; None of another folder."""
    file = table_file(Path(path), "observations")
    return rows_in(file) if file.suffix == ".parquet" else None


def _pieces(path: Path, images: dict[str, int], points: dict[str, int]) -> Iterator[tuple[int, Observations, Mask]]:
    for table in table_pieces(path, columns_for(images, points)):
        yield table.first_line - 2, *observations_of(path, table)
