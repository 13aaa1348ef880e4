"""Paper, usual scales, and how an object is divided on sheets."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import Literal

import numpy as np

from raybundle.errors import Text, phrase
from raybundle.numerics.arrays import Array

PaperName = Literal["A4", "A3", "A2", "A1", "A0"]
PAPERS: dict[str, tuple[float, float]] = {
    "A4": (210.0, 297.0), "A3": (297.0, 420.0), "A2": (420.0, 594.0), "A1": (594.0, 841.0), "A0": (841.0, 1189.0),
}  # fmt: skip
"""Width and height upright [mm] (ISO 216)."""
BINDING, EDGE = 20.0, 10.0
"""Between the paper's edge and the frame [mm]: left, where sheets are bound, and on the other sides (ISO 5457)."""
RING = 7.0
"""Between the frame and what is drawn, for the numbers of the grid [mm]."""
OVERLAP = 15.0
"""Of neighbouring sheets [mm]: room for a register mark."""
STEPS = (1, 2, 5)
SMALLEST = 100_000_000
"""Denominator beyond which nothing is drawn: the Earth on a table."""
MOST_SHEETS = 200


@dataclass(frozen=True, slots=True, kw_only=True)
class Paper:
    """A paper and what is on it beside the drawing."""

    name: str
    width: float
    height: float
    """[mm]"""
    strip: float
    """height of title block and legend at the bottom of the frame [mm]"""

    @property
    def frame(self) -> tuple[float, float, float, float]:
        """Left, bottom, right, top [mm]."""
        return BINDING, EDGE, self.width - EDGE, self.height - EDGE

    @property
    def window(self) -> tuple[float, float, float, float]:
        """Where the object is drawn, left, bottom, right, top [mm]."""
        left, bottom, right, top = self.frame
        return left + RING, bottom + self.strip + RING, right - RING, top - RING

    @property
    def room(self) -> Array:
        """(2,) width and height of that [mm]."""
        left, bottom, right, top = self.window
        return np.array([right - left, top - bottom])

    @property
    def words(self) -> Text:
        """As a title block has it."""
        return phrase("drawing_sheet.paper", name=self.name, landscape=self.width > self.height)


def usual_scales() -> list[int]:
    """Denominators 1, 2, 5, 10, 20, 50 ... from the largest scale on."""
    return [m * 10**e for e, m in product(range(9), STEPS) if m * 10**e <= SMALLEST]


def scale_that_fits(size: Array, room: Array) -> int | None:
    """The denominator of the largest usual scale at which a size [mm in nature] lies in a room [mm]; None: none."""
    return next((n for n in usual_scales() if (size / n <= room + 1e-6).all()), None)


def usual_length(wanted: float) -> float:
    """The usual length 1, 2, 5 ... that is the greatest not above the one that is wanted."""
    digits = 10.0 ** math.floor(math.log10(wanted))
    return max(m * digits for m in STEPS if m * digits <= wanted * (1 + 1e-9))


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """What one sheet shows."""

    number: int
    column: int
    row: int
    """from the top"""
    corner: Array
    """(2,) lower left corner of its window, in the plane"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Division:
    """An object on one sheet or several."""

    parts: tuple[Part, ...]
    columns: int
    rows: int
    overlap: Array
    """(2,) in the plane; 0 where there is one sheet in that direction"""
    size: Array
    """(2,) of a window in the plane"""


def divided(low: Array, high: Array, room: Array, overlap: float) -> Division | None:
    """Sheets over an area (2,) to (2,) of the plane, in rows from the top.

    room     (2,) of a window, in the plane
    overlap  of neighbours, in the plane
    returns  None where it would be more than 200
    What is left over is shared by both sides, so that the object stands in the middle.
    """
    size = high - low
    lap = np.zeros(2)
    counts = np.ones(2, int)
    for k in range(2):
        if size[k] > room[k] * (1 + 1e-9):
            lap[k] = overlap
            counts[k] = math.ceil((size[k] - lap[k]) / (room[k] - lap[k]) - 1e-9)
    if float(np.prod(counts.astype(float))) > MOST_SHEETS:
        return None
    covered = counts * room - (counts - 1) * lap
    begin = (low + high - covered) / 2
    parts = [
        Part(
            number=r * int(counts[0]) + c + 1, column=c, row=r,
            corner=begin + np.array([c, counts[1] - 1 - r]) * (room - lap),
        )
        for r in range(int(counts[1])) for c in range(int(counts[0]))
    ]  # fmt: skip
    return Division(parts=tuple(parts), columns=int(counts[0]), rows=int(counts[1]), overlap=lap, size=room)
