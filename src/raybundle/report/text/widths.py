"""How much room words take, estimated: what tables need before a browser or a typesetter has seen them."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.report.parts import Table

WORDS = 26
"""Characters that a column of words has, unless all its cells are shorter: a camera's name takes one line or two."""
STEPS, MOST_WEIGHED = 60, 100
"""In which room is shared out, and rows of a table that are weighed by it."""
POWER = 8
"""Of the mean that stands for the largest of a row's cells: of columns that are equally high both have to be wider."""
NARROW_ONES = frozenset(" .,:;'|!()[]ijlftI/-\u202f\u00a0·")
SOFT = "\u00ad"
"""Where a word may be divided, with a hyphen"""
JOINTS = "-_/"
"""Behind which a name may be broken"""
UNIT = re.compile(r"(?<=\d) (?=(?:µm|um|mm|cm|km|m|px|ms|s|min|h|MB|GB|gon|rad|deg|°|%)(?![\w²³⁻]))")
"""Blank before a unit"""
WIDE_ONES = frozenset("mwMW@%‰—…∞√≥≤")


def least_width(table: Table, column: int) -> int:
    """Characters that a column of words has at least, so that names do not stand word by word below each other."""
    longest = max((len(row[column]) for row in table.rows), default=0)
    return min(longest, WORDS)


def advance(text: str) -> float:
    """Width of a text in ems, estimated for a serif such as Libertinus; rather more than less.

    Digits, signs and small letters take half of an em in nearly every face, capitals two thirds, ideographs one.
    """
    return sum(_character(c) for c in text)


def _character(c: str) -> float:
    if c == "\u00ad":
        return 0.0
    if c in NARROW_ONES:
        return 0.32
    if c in WIDE_ONES:
        return 0.85
    if c.isdigit() or c.islower():
        return 0.5
    if unicodedata.east_asian_width(c) in "WF":
        return 1.05
    return 0.68


def longest_word(text: str) -> float:
    """Width in ems of the longest word of a text."""
    return max((advance(w) for w in re.split("[ \u00ad]", text)), default=0.0)


def shared_out(room: float, least: Array, cells: Array) -> Array:
    """Widths (k,) of columns in a room, for which a table is as low as it can be.

    least  (k,) width that each has at least; where they need more than the room, each gets its share of it
    cells  (n, k) widths of all cells on one line

    A row is as high as its cell of most lines; room goes step by step to the column that saves most by it.
    """
    rest = room - float(least.sum())
    if rest <= 0:
        return least * room / max(float(least.sum()), 1e-9)
    cells = cells[:: max(1, len(cells) // MOST_WEIGHED)]
    widths = least.copy()
    step = rest / STEPS
    for _ in range(STEPS):
        wider = widths + step * np.eye(len(widths))
        heights = [_cost(cells, w) for w in wider]
        best = int(np.argmin(heights))
        if heights[best] >= _cost(cells, widths) - 1e-9:
            break
        widths = wider[best]
    return widths


def _cost(cells: Array, widths: Array) -> float:
    """Nearly the height in lines, a little less for every cell that becomes lower, and so for one of two alike, too."""
    high = np.maximum(cells / np.maximum(widths, 1e-9), 1.0)
    return float(((high**POWER).sum(axis=1) ** (1 / POWER)).sum())


def lines(cells: Array, widths: Array) -> float:
    """Height of a table (n, k) in lines, with parts of lines, so that a step towards a saving counts."""
    return float(np.maximum(cells / np.maximum(widths, 1e-9), 1.0).max(axis=1).sum()) if cells.size else 0.0


def broken(text: str, width: float) -> str:
    """A text in which a word that is wider than a column [em] may be broken: where it may be divided, else anywhere.

    A name is broken behind its last hyphen that the line holds, where there is one.
    """
    return " ".join(SOFT.join(_narrow(p, width) for p in w.split(SOFT)) for w in text.split(" "))


def _narrow(part: str, width: float) -> str:
    return _pieces(part, width) if advance(part) > width else part


def _pieces(word: str, width: float) -> str:
    parts, line = list[str](), ""
    for c in word:
        if line and advance(line + c) > width:
            at = max(line.rfind(j) for j in JOINTS) + 1 or len(line)
            parts.append(line[:at])
            line = line[at:]
        line += c
    return "\u200b".join([*parts, line])


def kept_together(text: str) -> str:
    """A text in which no line ends between a number and its unit."""
    return UNIT.sub("\u00a0", text)


def packed(widths: Iterable[float], room: float, gap: float) -> list[list[int]]:
    """Positions in rows that the room holds, in their order, as many in each as fit."""
    rows: list[list[int]] = []
    used = 0.0
    for k, width in enumerate(widths):
        if rows and used + gap + width <= room:
            rows[-1].append(k)
            used += gap + width
        else:
            rows.append([k])
            used = width
    return rows
