"""The title block of a drawing: entries in rows of three columns, as high as their words need (after ISO 7200)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from raybundle.errors import phrase
from raybundle.report.drawing.content import Field
from raybundle.report.drawing.fonts import BOLD, PLAIN, wrapped

WIDTH = 180.0
"""[mm], as ISO 7200 has it: it fits on A4 upright"""
COLUMNS = 3
LABEL, VALUE, HEAD = 2.0, 2.7, 4.4
"""Sizes of letters [mm]: names of entries, entries, title"""
PAD, AIR = 1.2, 1.25
"""Round the words of a cell [mm], and distance of lines by their size"""
MOST_LINES, TITLE_LINES = 4, 3


@dataclass(frozen=True, slots=True, kw_only=True)
class _Cell:
    left: float
    width: float
    label: str
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class TitleBlock:
    """Where everything in it stands."""

    title: tuple[str, ...]
    rows: tuple[tuple[float, tuple[_Cell, ...]], ...]
    """height and cells of each row, from the top"""

    @property
    def title_height(self) -> float:
        """[mm]."""
        return len(self.title) * HEAD * AIR + 2 * PAD

    @property
    def height(self) -> float:
        """[mm]."""
        return self.title_height + sum(h for h, _ in self.rows)

    @property
    def shortened(self) -> tuple[str, ...]:
        """Names of entries whose words did not fit in."""
        cells = [c for _, row in self.rows for c in row]
        cut = [c.label for c in cells if c.lines and c.lines[-1].endswith("…")]
        return (
            (phrase("drawing_sheet.field", name="title"),) if self.title and self.title[-1].endswith("…") else ()
        ) + tuple(cut)


def title_block(title: str, fields: Sequence[Field]) -> TitleBlock:
    """The block of a title and its entries, in their order; those without words are left out.

    The last entry of a row takes what is left of it.
    """
    rows: list[list[Field]] = [[]]
    for f in (f for f in fields if f.text.strip()):
        if f.first or sum(g.span for g in rows[-1]) + f.span > COLUMNS:
            rows.append([])
        rows[-1].append(f)
    found: list[tuple[float, tuple[_Cell, ...]]] = []
    for row in filter(None, rows):
        cells, left = list[_Cell](), 0.0
        for k, f in enumerate(row):
            wide = WIDTH - left if k == len(row) - 1 else f.span * WIDTH / COLUMNS
            lines = wrapped(f.text, VALUE, wide - 2 * PAD, MOST_LINES)
            cells.append(_Cell(left=left, width=wide, label=f.label, lines=tuple(lines)))
            left += wide
        most = max(len(c.lines) for c in cells)
        found.append((2 * PAD + LABEL * AIR + most * VALUE * AIR, tuple(cells)))
    head = wrapped(title, HEAD, WIDTH - 2 * PAD, TITLE_LINES, BOLD)
    return TitleBlock(title=tuple(head), rows=tuple(found))


def draw_title_block(canvas: Any, block: TitleBlock, left: float, bottom: float) -> None:
    """Draw it with its lower left corner there [mm]."""
    c, y = canvas, bottom + block.height
    c.setStrokeGray(0)
    c.setFillGray(0)
    c.setLineWidth(0.5)
    c.rect(left, bottom, WIDTH, block.height, stroke=1, fill=0)
    c.setFont(BOLD, HEAD)
    for k, line in enumerate(block.title):
        c.drawString(left + PAD, y - PAD - HEAD * (0.8 + k * AIR), line)
    y -= block.title_height
    for height, cells in block.rows:
        c.setLineWidth(0.25)
        c.line(left, y, left + WIDTH, y)
        for cell in cells:
            if cell.left:
                c.line(left + cell.left, y, left + cell.left, y - height)
            c.setFont(PLAIN, LABEL)
            c.setFillGray(0.35)
            c.drawString(left + cell.left + PAD, y - PAD - 0.8 * LABEL, cell.label)
            c.setFont(PLAIN, VALUE)
            c.setFillGray(0)
            for k, line in enumerate(cell.lines):
                at = y - PAD - LABEL * AIR - VALUE * (0.8 + k * AIR)
                c.drawString(left + cell.left + PAD, at, line)
        y -= height
