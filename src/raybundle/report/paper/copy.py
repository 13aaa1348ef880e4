"""A document as plain data for the typesetter: a text stays a text and is never read as markup, whatever is in it."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from html import unescape
from typing import TYPE_CHECKING, Any

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.report.arrangement import Division, Measure
from raybundle.report.paper.drawings import printed_svg, size_of, words_of
from raybundle.report.parts import (
    Facts,
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Pointer,
    Section,
    Statements,
    Table,
)
from raybundle.report.text.widths import WORDS, advance, broken, kept_together, lines, longest_word, packed, shared_out

if TYPE_CHECKING:
    from raybundle.report.document import Document

ROOM = 510.0
"""Width of the text [pt]: A4 within margins of 15 mm."""
SCREEN = 924.0
"""Width of the pages that drawings were laid out for [px]."""
TALLEST = 400.0
"""Height of a figure [pt]: with its caption more than half a page, so that words stand beside it."""
GAP = 8.0
"""Between figures [pt]."""
SIZES = (8.0, 7.5, 7.0, 6.5, 6.0, 5.5)
"""Sizes of type of a table [pt], the first at which it fits."""
UNNOTICED = 3
"""Sizes of the first ones that are taken rather than a second line."""
PAD = 6.0
"""Blank beside the words of a cell, both sides together [pt]."""
BESIDE, COLUMN, SAVED = 12, 55, 0.7
"""A table of more rows may stand in columns of so many rows at most, where that saves as much of its height."""
WHOLE = 14
"""Lines of a table that is not broken over pages: a fifth of a page, so that none has one row on the next."""
STACKED, STACK = 100, 50
"""Longer tables are set in stacks of so many rows, a cell holding a line of each: cells take the time, not words."""

_TURNING = re.compile("[\u202a-\u202e\u2066-\u2069]")

Copy = dict[str, Any]


def copy_of(document: Document, measure: Measure | None = None, *, appendix: bool = True) -> Copy:
    """Everything that is printed.

    measure   how much of the specialist's part stands in the appendix
    appendix  whether more of this is wanted than its headings
    """
    w, say = document.written, document.language.text
    return {
        "language": document.language.code,
        "page": [say(phrase("report_page.page")), say(phrase("report_page.of_pages"))],
        "title": _clean(document.title), "subtitle": _clean(document.subtitle), "headline": _clean(document.headline),
        "grade": document.grade, "when": document.when, "date": [w.year, w.month, w.day],
        "divisions": _divisions(document, measure, appendix=appendix),
    }  # fmt: skip


def _divisions(document: Document, measure: Measure | None, *, appendix: bool) -> list[Copy]:
    """Those that are printed; in place of an appendix that is not, one line that states where its contents are."""
    made = document.divisions(measure)
    if document.appendix or not any(d.name == "appendix" for d in made):
        return [_division(d, whole=appendix or d.name != "appendix") for d in made]
    kept = [
        replace(d, sections=tuple(replace(p, section=_without_pointers(p.section)) for p in d.sections))
        for d in made if d.name != "appendix"
    ]  # fmt: skip
    copies = [_division(d, whole=True) for d in kept]
    note = Paragraph(text=document.language.text(phrase("report_page.not_printed")), note=True)
    copies[-1]["sections"][-1]["parts"] += part_copies([note])
    return copies


def _without_pointers(section: Section) -> Section:
    """A section without what points to the appendix, and without headings below which nothing else stands."""
    parts = [p for p in section.parts if not isinstance(p, Pointer)]
    last = [k + 1 == len(parts) or isinstance(parts[k + 1], Heading) for k in range(len(parts))]
    kept = (p for p, end in zip(parts, last, strict=True) if not (end and isinstance(p, Heading)))
    return replace(section, parts=tuple(kept))


def _division(division: Division, *, whole: bool) -> Copy:
    return {
        "name": division.name,
        "title": division.title,
        "sections": [
            {
                "number": p.number,
                "anchor": p.section.anchor,
                "title": _clean(p.section.title),
                "parts": part_copies(p.section.parts) if whole else [],
            }
            for p in division.sections
        ],
    }


def part_copies(parts: Sequence[Part]) -> list[Copy]:
    """The parts of a section; raises TypeError for a kind that paper does not know."""
    made: list[Copy] = []
    for part in parts:
        if type(part) not in COPIES:
            raise TypeError(f"the report in print does not know the part {type(part).__name__}")
        made.append({"kind": part.kind, **COPIES[type(part)](part)})
    return made


def _paragraph(p: Paragraph) -> Copy:
    return {"text": _words(p.text), "note": p.note}


def _heading(p: Heading) -> Copy:
    return {"text": _words(p.text)}


def _facts(p: Facts) -> Copy:
    return {"facts": [[_clean(f.label), _clean(f.value), _clean(f.remark)] for f in p.facts]}


def _statements(p: Statements) -> Copy:
    statements = [[broken(_clean(word), 11.0), _words(sentence)] for word, sentence in p.statements]
    return {"statements": statements, "rest": _words(p.rests[len(statements)]) if p.rests else ""}


def _folded(p: Folded) -> Copy:
    return {"summary": _words(p.summary), "parts": part_copies(p.parts)}


def _pointer(p: Pointer) -> Copy:
    return {"anchor": p.anchor, "number": p.number, "text": _words("; ".join(p.items))}


def _figures(p: Figures) -> Copy:
    made = [_figure(f) for f in p.figures]
    rows = packed((f["width"] for f in made), ROOM, GAP)
    return {"rows": [[made[k] for k in row] for row in rows]}


def _figure(f: Figure) -> Copy:
    wide, high = size_of(f.drawing)
    scale = min(ROOM / SCREEN, ROOM / wide, TALLEST / high)
    return {
        "svg": _clean(printed_svg(f.drawing)),
        "width": wide * scale,
        "words": _clean(unescape(words_of(f.drawing))),
        "caption": broken(_clean(f.caption), max(wide * scale, 60.0) / 8.0),
    }


def _table(t: Table) -> Copy:
    t = t.printed or t
    laid = laid_out(t)
    rows = [[_clean(cell) for cell in row] for row in t.rows]
    stacked = len(rows) > STACKED and laid.natural and not any("\n" in cell for row in rows for cell in row)
    if not stacked:
        rows = [[broken(cell, w) for cell, w in zip(row, laid.widths, strict=True)] for row in rows]
    heads = [[broken(_clean(c.label), w), _clean(c.unit), c.text] for c, w in zip(t.columns, laid.widths, strict=True)]
    return {
        "caption": _words(t.caption),
        "note": _words(t.note),
        "size": laid.size,
        "widths": [w * laid.size + PAD for w in laid.widths],
        "columns": heads,
        "whole": laid.height <= WHOLE,
        "beside": _shares(len(rows), laid.beside),
        "stacks": _stacks(rows, t.marked) if stacked else [],
        "rows": [] if stacked else rows,
        "marked": {} if stacked else {str(k): True for k in t.marked},
    }


def _shares(rows: int, columns: int) -> list[list[int]]:
    """First row and the one behind the last of each column; none where the table stands in one."""
    if columns < 2:
        return []
    each = -(-rows // columns)
    return [[a, min(a + each, rows)] for a in range(0, rows, each)]


def _stacks(rows: Sequence[Sequence[str]], marked: frozenset[int]) -> list[Copy]:
    return [
        {
            "columns": [[unbreakable(c) for c in column] for column in zip(*rows[a : a + STACK], strict=True)],
            "marked": {str(k - a): True for k in marked if a <= k < a + STACK},
        }
        for a in range(0, len(rows), STACK)
    ]


def unbreakable(text: str) -> str:
    """A text that stays on one line."""
    return text.replace(" ", "\u00a0").replace("-", "\u2011") if " " in text or "-" in text else text


@dataclass(frozen=True, slots=True, kw_only=True)
class Layout:
    """How a table is set."""

    size: float
    """of its type [pt]"""
    widths: list[float]
    """of its columns, without the blank beside their words [em]"""
    natural: bool
    """whether every cell stands on one line"""
    height: float
    """in lines, without its head"""
    beside: int = 1
    """in how many columns of the page its rows stand"""


def laid_out(t: Table) -> Layout:
    """In one column of the page, or in several where a long and narrow table is much lower so."""
    cells = np.array([[advance(cell) for cell in row] for row in t.rows], float).reshape(len(t.rows), len(t.columns))
    heads = np.array(
        [max(longest_word(c.label), advance(c.unit), advance(f"{c.label} {c.unit}") / 3) for c in t.columns], float
    )
    best = _layout(t, cells, heads, 1)
    for beside in range(2, 5):
        if not BESIDE < len(t.rows) <= beside * COLUMN:
            continue
        other = _layout(t, cells, heads, beside)
        if other.size == SIZES[0] and other.height < SAVED * best.height:
            best = other
    return best


def _layout(t: Table, cells: Array, heads: Array, beside: int) -> Layout:
    """The layout in so many columns of the page."""
    wanted = np.maximum(cells.max(axis=0, initial=0.0), heads)
    words = np.array([c.text and not c.whole for c in t.columns], bool)
    least = np.where(words, np.maximum(np.minimum(wanted, WORDS * 0.45), np.minimum(heads, 8.0)), wanted)
    width = (ROOM + 2 * GAP) / beside - 2 * GAP - PAD * len(least)
    fitting = [s for s in SIZES if least.sum() <= width / s] or [SIZES[-1]]
    on_one_line = [s for s in SIZES[:UNNOTICED] if wanted.sum() <= width / s]
    size = (on_one_line or fitting)[0]
    room = width / size
    natural = bool(wanted.sum() <= room)
    if natural:  # heads on one line where there is room
        more = np.maximum(np.array([advance(f"{c.label} {c.unit}".strip()) for c in t.columns]) - wanted, 0.0)
        wanted = wanted + more * min(1.0, (room - wanted.sum()) / max(float(more.sum()), 1e-9))
    widths = wanted if natural else shared_out(room, least, np.vstack([cells, heads[None]]))
    height = lines(cells, np.maximum(widths, 1e-9)) / beside
    fits = bool(least.sum() <= room + 1e-9)
    return Layout(
        size=size if fits else 0.0 if beside > 1 else size, widths=widths.tolist(), natural=natural, height=height,
        beside=beside,
    )  # fmt: skip


def _words(text: str) -> str:
    return broken(_clean(text), 55.0)


def _clean(text: str) -> str:
    """A text that can be set: half characters, as in names of files, are marked; what turns the way of writing goes.

    Words of right-to-left scripts keep their way without it; with it a name can pass for another one, and typst 0.13.0
    breaks down.
    """
    return kept_together(_TURNING.sub("", text).encode("utf-8", "replace").decode("utf-8"))


COPIES: dict[type, Callable[[Any], Copy]] = {
    Facts: _facts,
    Figures: _figures,
    Folded: _folded,
    Heading: _heading,
    Paragraph: _paragraph,
    Pointer: _pointer,
    Statements: _statements,
    Table: _table,
}
"""How each kind of part is handed to the typesetter; the template has a function of its name."""
