"""The parts of a report in the reader's language."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from html import escape, unescape

from raybundle.errors import Text, phrase
from raybundle.report.figures.svg import Drawing
from raybundle.report.languages.language import Language
from raybundle.report.parts import (
    Column,
    Fact,
    Facts,
    Figure,
    Figures,
    Folded,
    Heading,
    Paragraph,
    Part,
    Section,
    Statements,
    Table,
)
from raybundle.report.view import FREE_UNIT

SVG_TEXT = re.compile(r'(>)([^<>]*[^<>\s][^<>]*)(</(?:text|title|tspan)>)|(aria-label=")([^"]*)(")')


def section_in(section: Section, language: Language) -> Section:
    """A section with every text of it in a language."""
    return replace(section, title=language.text(section.title), parts=_parts(section.parts, language))


def _parts(parts: Iterable[Part], language: Language) -> tuple[Part, ...]:
    return tuple(_part(p, language) for p in parts)


def _part(p: Part, language: Language) -> Part:
    say = language.text
    match p:
        case Paragraph() | Heading():
            return replace(p, text=say(p.text))
        case Facts():
            facts = (Fact(label=say(f.label), value=say(f.value), remark=say(f.remark)) for f in p.facts)
            return replace(p, facts=tuple(facts))
        case Statements():
            reported = tuple((say(word), say(sentence)) for word, sentence in p.statements)
            return replace(p, statements=reported, rests=tuple(say(r) for r in p.rests))
        case Folded():
            return replace(p, summary=say(p.summary), parts=_parts(p.parts, language))
        case Figures():
            figures = (Figure(drawing=drawing_in(f.drawing, language), caption=say(f.caption)) for f in p.figures)
            return replace(p, figures=tuple(figures))
        case Table():
            return _table(p, language)
        case _:  # a pointer is made where parts are arranged
            return p


def _table(t: Table, language: Language) -> Table:
    say, cell = language.text, language.cell
    return replace(
        t, caption=say(t.caption), note=say(t.note), columns=tuple(_column(c, language) for c in t.columns),
        rows=[[cell(c) for c in row] for row in t.rows], printed=_table(t.printed, language) if t.printed else None,
    )  # fmt: skip


def _column(c: Column, language: Language) -> Column:
    unit = phrase("label.free_unit") if c.unit == FREE_UNIT else c.unit
    return replace(c, label=language.heading(c.label), unit=language.text(unit))


def drawing_in(drawing: Drawing, language: Language) -> Drawing:
    """A drawing with its words in a language."""

    def stated(found: re.Match[str]) -> str:
        before, words, behind = (found[1], found[2], found[3]) if found[1] else (found[4], found[5], found[6])
        return f"{before}{escape(language.text(unescape(words)))}{behind}"

    pieces = (
        escape(language.text(p)) if isinstance(p, Text) else SVG_TEXT.sub(stated, p) for p in drawing.pieces
    )  # fmt: skip
    return replace(drawing, pieces=("".join(pieces),))
