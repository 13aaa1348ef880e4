"""What a report is made of: sections of paragraphs, tables, figures and folded parts.  The template sets them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from raybundle.errors import Text, joined_texts, phrase
from raybundle.report.figures.svg import Drawing

MOST_ROWS = 2000
"""Rows of a table that a report shows; the rest stands in the result folder."""
PRINTED = 70
"""Rows of a long list that are printed: so many as a page holds"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Column:
    """Heading of a table's column."""

    label: str
    unit: str = ""
    text: bool = False
    """Words, set flush left; numbers are set flush right."""
    whole: bool = False
    """Words that are never broken into lines: names, dates, a value with its unit."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """Rows of cells as they are printed."""

    kind: ClassVar[str] = "table"
    columns: tuple[Column, ...]
    rows: Sequence[Sequence[str]]
    caption: str = ""
    note: str = ""
    marked: frozenset[int] = frozenset()
    """Rows that stand out."""
    stays: bool = False
    """Whether it stands where it is however long it is, as warnings do; other long tables go to the appendix."""
    printed: Table | None = None
    """What of it is printed on paper, where nobody reads row by row; None: all"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Paragraph:
    """A paragraph; `note` sets it small."""

    kind: ClassVar[str] = "paragraph"
    text: str
    note: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Heading:
    """A heading within a section."""

    kind: ClassVar[str] = "heading"
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """A drawing with its caption."""

    drawing: Drawing
    caption: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Figures:
    """Figures side by side, as many as fit."""

    kind: ClassVar[str] = "figures"
    figures: tuple[Figure, ...]
    small: bool = False
    first: bool = False
    """Whether a specialist wants them before others where there is no room for all"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Fact:
    """A key figure: what, how much, and what that means."""

    label: str
    value: str
    remark: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Facts:
    """Key figures side by side."""

    kind: ClassVar[str] = "facts"
    facts: tuple[Fact, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Statements:
    """A list of sentences, each with a word in front."""

    kind: ClassVar[str] = "statements"
    statements: tuple[tuple[str, str], ...]
    rests: tuple[str, ...] = ()
    """Where the first k alone may be printed: what is stated of the others, for each k; empty: nothing is left out"""

    def first(self, most: int) -> Statements:
        """So many of them, where they may be cut."""
        if not self.rests or len(self.statements) <= most:
            return self
        return replace(self, statements=self.statements[:most], rests=self.rests[: most + 1])


@dataclass(frozen=True, slots=True, kw_only=True)
class Folded:
    """Parts that are shown on demand; of a section that specialists read they stand in the appendix."""

    kind: ClassVar[str] = "folded"
    summary: str
    parts: tuple[Part, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Pointer:
    """Where in the appendix to read on."""

    kind: ClassVar[str] = "pointer"
    anchor: str
    number: str
    items: tuple[str, ...]
    """What stands there."""


Part = Table | Paragraph | Heading | Figures | Facts | Statements | Folded | Pointer


@dataclass(frozen=True, slots=True, kw_only=True)
class Section:
    """A section of the report; it is numbered where it is put in its place."""

    anchor: str
    title: str
    parts: tuple[Part, ...]


def text(label: str) -> Column:
    """Heading of a column of words."""
    return Column(label=label, text=True)


def whole(label: str) -> Column:
    """Heading of a column of short words that stay on one line."""
    return Column(label=label, text=True, whole=True)


def number(label: str, unit: str = "") -> Column:
    """Heading of a column of numbers."""
    return Column(label=label, unit=unit)


def table(
    columns: Sequence[Column],
    values: Iterable[Sequence[str]],
    *,
    caption: str = "",
    note: str = "",
    rest: str = "",
    most: int = MOST_ROWS,
    marked: Iterable[int] = (),
    stays: bool = False,
) -> Table:
    """A table from its columns' cells, cut after `most` rows; `rest` states where the others are."""
    by_column = [list(v) for v in values]
    count = len(by_column[0]) if by_column else 0
    if count > most:
        cut = (
            phrase("label.rows_shown_of", n=most, of=count, rest=rest)
            if rest
            else phrase("label.rows_shown", n=most, of=count)
        )
        note = joined_texts(note, cut) if isinstance(note, Text) else f"{note} {cut}".strip()
    rows = list(zip(*(c[:most] for c in by_column), strict=True))
    return Table(columns=tuple(columns), rows=rows, caption=caption, note=note, marked=frozenset(marked), stays=stays)


def on_a_page(t: Table, rows: Iterable[int], note: str) -> Table:
    """A long list of which paper holds these rows, which the note explains; one that fits a page is printed whole."""
    if len(t.rows) <= PRINTED:
        return t
    kept = sorted({int(k) for k in rows})
    marked = frozenset(i for i, k in enumerate(kept) if k in t.marked)
    return replace(t, printed=replace(t, rows=[t.rows[k] for k in kept], note=note, marked=marked))


def pick(rows: Iterable[int], values: Sequence[str]) -> list[str]:
    """The cells at these positions."""
    return [values[int(r)] for r in rows]
