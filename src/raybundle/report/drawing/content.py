"""What stands on drawing sheets, as data: nothing here knows the paper."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.report.languages.language import Language


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawnPicture:
    """A picture to scale."""

    file: Path
    left: float
    top: float
    """outer corner of the upper left pixel, in the plane"""
    pixel: float
    width_px: int
    height_px: int

    @property
    def extent(self) -> Array:
        """(4,) left, bottom, right, top."""
        right, bottom = self.left + self.pixel * self.width_px, self.top - self.pixel * self.height_px
        return np.array([self.left, bottom, right, self.top])


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawnPoints:
    """Points with a symbol and, where they have one, a name."""

    kind: str
    """control, check, point or tie"""
    names: tuple[str, ...]
    """(n,) empty: without"""
    xy: Array
    """(n, 2) in the plane"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawnLine:
    """A line or outline."""

    kind: str
    name: str
    xy: Array
    """(k, 2)"""
    closed: bool = False
    words: str = ""
    """what is written along it"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Field:
    """An entry of the title block."""

    label: str
    text: str
    span: int = 1
    """columns, of three"""
    first: bool = False
    """whether it begins a row"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawing:
    """All that is drawn, in the unit of the plane."""

    title: str
    fields: tuple[Field, ...]
    low: Array
    high: Array
    """(2,) corners of what is to be shown"""
    millimetres: float
    """in a unit of the plane"""
    unit: str
    axes: tuple[str, str]
    """what the coordinates are called: X, Y or E, N"""
    grid: float | None
    """distance of its lines; None: a usual one; 0: none"""
    pictures: tuple[DrawnPicture, ...] = ()
    points: tuple[DrawnPoints, ...] = ()
    lines: tuple[DrawnLine, ...] = ()
    north: bool = False
    author: str = ""
    """of whom the file states that they made it"""
    notes: tuple[str, ...] = ()
    """of precision and plane, for the legend"""
    language: Language = field(default_factory=Language)
    """of what the sheet adds by itself; all else is in it already"""

    @property
    def size(self) -> Array:
        """(2,) [mm in nature]."""
        return (self.high - self.low) * self.millimetres


def within(xy: Array, low: Array, high: Array) -> Mask:
    """(n,) which places lie in a window."""
    return np.asarray(((xy >= low) & (xy <= high)).all(axis=1), bool)
