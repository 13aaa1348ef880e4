"""Beside the title block: scale bar, north arrow, which sheet this is, symbols and what is known of the precision."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from raybundle.errors import phrase
from raybundle.report.drawing.content import Drawing
from raybundle.report.drawing.fonts import BOLD, PLAIN, width, wrapped
from raybundle.report.drawing.paper import Division, Part, usual_length
from raybundle.report.drawing.symbols import draw_line, draw_north, draw_symbol

LETTER, SMALL = 2.7, 2.3
"""Sizes of letters [mm]"""
LINE = 4.0
"""Distance of entries [mm]"""
BAR_TALL, BAR = 15.0, 70.0
"""Height of scale bar with its words, and its longest length [mm]"""
ITEM = 48.0
"""Width of an entry with its symbol [mm]"""
NORTH = 9.0
MOST_NOTE = 4
PAD = 2.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Legend:
    """What it holds, in a width."""

    width: float
    items: tuple[tuple[str, str], ...]
    """("point" or "line", kind)"""
    notes: tuple[str, ...]
    """lines"""
    columns: int
    index: tuple[int, int]
    """columns and rows of sheets; (1, 1): this is the only one"""

    @property
    def height(self) -> float:
        """[mm]."""
        rows = -(-len(self.items) // self.columns)
        return BAR_TALL + rows * LINE + len(self.notes) * SMALL * 1.3 + 2 * PAD + (PAD if self.notes else 0)


def legend(drawing: Drawing, wide: float, division: Division) -> Legend:
    """What stands in it, of a width [mm]."""
    kinds = list(dict.fromkeys(p.kind for p in drawing.points if len(p.xy)))
    lines = list(dict.fromkeys(line.kind for line in drawing.lines))
    notes = [line for n in drawing.notes for line in wrapped(n, SMALL, wide - 2 * PAD, MOST_NOTE)]
    return Legend(
        width=wide, items=tuple([("point", k) for k in kinds] + [("line", k) for k in lines]), notes=tuple(notes),
        columns=max(int((wide - 2 * PAD) // ITEM), 1), index=(division.columns, division.rows),
    )  # fmt: skip


def draw_legend(c: Any, found: Legend, drawing: Drawing, scale: int, part: Part, left: float, top: float) -> None:
    """Draw it below `top` [mm]."""
    x, y = left + PAD, top - PAD
    _scale_bar(c, drawing, scale, x, y, found.width - 2 * PAD)
    right = left + found.width - PAD
    if drawing.north:
        draw_north(c, right - 4, y - NORTH - 4.5, NORTH, BOLD)
        right -= 14
    if found.index != (1, 1):
        _index(c, found.index, part, right, y)
    y -= BAR_TALL
    for k, (what, kind) in enumerate(found.items):
        at = x + (k % found.columns) * ITEM
        line = y - (k // found.columns) * LINE - 0.5 * LINE
        if what == "point":
            draw_symbol(c, kind, at + 4, line)
        else:
            draw_line(c, kind, [(at, line), (at + 8, line)], closed=False)
        c.setFillGray(0)
        c.setFont(PLAIN, LETTER)
        c.drawString(
            at + 10.5,
            line - 0.35 * LETTER,
            drawing.language.text(phrase("drawing_sheet.kind", kind=kind.replace(" ", "_"))),
        )
    y -= -(-len(found.items) // found.columns) * LINE + (PAD if found.notes else 0)
    c.setFont(PLAIN, SMALL)
    c.setFillGray(0.15)
    for k, line in enumerate(found.notes):
        c.drawString(x, y - SMALL * (0.8 + 1.3 * k), line)


def _scale_bar(c: Any, drawing: Drawing, scale: int, x: float, top: float, room: float) -> None:
    """Four parts of a usual length, alternately black and white, with the scale in words."""
    per_unit = drawing.millimetres / scale  # paper mm in a unit
    part = usual_length(min(BAR, room - 20) / 4 / per_unit)
    long = part * per_unit
    y = top - 9.5
    c.setStrokeGray(0)
    c.setLineWidth(0.25)
    for k in range(4):
        c.setFillGray(0 if k % 2 == 0 else 1)
        c.rect(x + k * long, y, long, 1.6, stroke=1, fill=1)
    c.setFillGray(0)
    c.setFont(PLAIN, SMALL)
    for k in (0, 1, 2, 4) if long > 9 else (0, 2, 4) if long > 6 else (0, 4):
        words = drawing.language.text(f"{k * part:.10g}")
        at = x + k * long
        c.drawString(at, y + 2.5, words) if k == 0 else c.drawCentredString(at, y + 2.5, words)
    c.drawString(x + 4 * long + 0.5 * width(f"{4 * part:.10g}", SMALL) + 1, y + 2.5, drawing.unit)
    c.setFont(BOLD, LETTER)
    c.drawString(x, top - 0.8 * LETTER, f"1 : {scale:,}".replace(",", " "))


def _index(c: Any, counts: Sequence[int], part: Part, right: float, top: float) -> None:
    """Small boxes, one a sheet, of which this one is filled."""
    columns, rows = counts
    size = min(24 / columns, (BAR_TALL - 2) / rows, 6)
    left = right - columns * size
    c.setStrokeGray(0)
    c.setLineWidth(0.15)
    for row in range(rows):
        for column in range(columns):
            here = (column, row) == (part.column, part.row)
            x, y = left + column * size, top - (row + 1) * size
            c.setFillGray(0.25 if here else 1)
            c.rect(x, y, size, size, stroke=1, fill=1)
            if size >= 3:
                c.setFillGray(1 if here else 0)
                c.setFont(PLAIN, 0.5 * size)
                c.drawCentredString(x + size / 2, y + 0.32 * size, str(row * columns + column + 1))
