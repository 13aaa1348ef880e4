"""What a kind of object is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar, Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.objects.surface import Surface

Side = Literal["round", "front", "above"]
"""From where an object is photographed: from all round it, from before its plane y = 0 (y < 0), from above"""
LARGEST = 1e5
"""Metres; beyond that an object is no object, and numbers are in another unit."""


class ObjectKind(ABC):
    """A kind of object: its numbers and the surface that they make.  A file in this folder registers it."""

    registry: ClassVar[dict[str, ObjectKind]] = {}
    name: ClassVar[str]
    about: ClassVar[str]
    numbers: ClassVar[tuple[str, ...]]
    """Names of the lengths that it is made of [m]"""
    line: ClassVar[str] = ""
    """What a line of points (k, 2) given instead of or beside the numbers is; empty: it takes none"""
    line_for: ClassVar[int] = 0
    """How many of the numbers, from the first, such a line stands for"""
    side: ClassVar[Side]
    example: ClassVar[tuple[float, ...]]

    def __init_subclass__(cls) -> None:
        """Register the kind under its name."""
        ObjectKind.registry[cls.name] = cls()

    def surface(self, numbers: Sequence[float], line: Array | None = None) -> Surface:
        """The surface of an object of this kind.

        raises  InputError where there are too few or too many numbers, or one is no length
        """
        wanted = self.numbers if line is None else self.numbers[self.line_for :]
        if line is not None and not self.line:
            raise InputError("object.takes_no_line", name=self.name, needs=self.words)
        if len(numbers) != len(wanted):
            raise InputError("object.number_count", name=self.name, n=len(numbers), needs=self.words)
        for word, value in zip(wanted, numbers, strict=True):
            if not (np.isfinite(value) and 0 < value <= LARGEST):
                raise InputError(
                    "object.dimension_out_of_range", name=self.name, dimension=word, value_m=value, largest_m=LARGEST
                )
        if line is not None:
            _check_line(self.name, line)
        return self.made(tuple(float(n) for n in numbers), line)

    @property
    def words(self) -> str:
        """What it takes, in words."""
        stated = " x ".join(self.numbers) + " [m]"
        if not self.line:
            return stated
        rest = self.numbers[self.line_for :]
        return f"{stated}, or {self.line}" + (f" and {' x '.join(rest)}" if rest else "")

    @abstractmethod
    def made(self, numbers: tuple[float, ...], line: Array | None) -> Surface:
        """The surface; what is given was checked."""


def _check_line(name: str, line: Array) -> None:
    if line.ndim != 2 or line.shape[1] != 2 or len(line) < 2:
        raise InputError("object_line.too_few_points", name=name)
    if not np.isfinite(line).all():
        bad = int(np.flatnonzero(~np.isfinite(line).all(axis=1))[0])
        raise InputError("object_line.not_finite", name=name, point=bad + 1)
    step = np.linalg.norm(np.diff(line, axis=0), axis=1)
    if not step.min() > 0:
        bad = int(step.argmin())
        raise InputError("object_line.identical_points", name=name, first=bad + 1, second=bad + 2)
    size = float(np.ptp(line, axis=0).max())
    if size > LARGEST:
        raise InputError("object_line.too_long", name=name, length_m=size, largest_m=LARGEST)


def grid_triangles(rows: int, columns: int) -> Index:
    """Triangles (2 (rows - 1) (columns - 1), 3) of a grid of vertices, row by row, counterclockwise with rows up."""
    k = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = k[:-1, :-1].ravel(), k[:-1, 1:].ravel(), k[1:, 1:].ravel(), k[1:, :-1].ravel()
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
