"""A report in three parts: for the client, for the specialist, and the appendix with what is looked up."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from raybundle.errors import phrase
from raybundle.report.parts import Figures, Folded, Heading, Part, Pointer, Section, Table

PartName = Literal["client", "specialist", "appendix"]
LONG = 20
"""Rows of a table that is read where it stands: a third of a page of A4 in print.  What is longer is looked up."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """A section in its place."""

    number: str
    """3, A2; empty: it has none"""
    section: Section


@dataclass(frozen=True, slots=True, kw_only=True)
class Division:
    """One part of a report, of those who read it."""

    name: PartName
    title: str
    """empty: the report has this one alone"""
    sections: tuple[Placed, ...]


def undivided(sections: Iterable[Section]) -> tuple[Division, ...]:
    """A page of one part, its sections numbered and their folded parts where they are."""
    placed = tuple(Placed(number=str(k), section=s) for k, s in enumerate(sections, 1))
    return (Division(name="specialist", title="", sections=placed),)


@dataclass(frozen=True, slots=True, kw_only=True)
class Measure:
    """How much of the specialist's sections stands where it is read."""

    rows: int = LONG
    """of a table; longer ones stand in the appendix"""
    figures: frozenset[int] | None = None
    """rows of figures that stay, by their place in `rows_of_figures`; None: all"""


def rows_of_figures(sections: Iterable[Section]) -> list[tuple[int, int]]:
    """Position of the section, and in it, of every row of figures, in the order in which they are wanted.

    Those that come `first`, then the first one of each section, then the second of each ...
    """
    found: list[tuple[bool, int, int, int]] = []
    for k, section in enumerate(sections):
        rows = [(at, p) for at, p in enumerate(section.parts) if isinstance(p, Figures)]
        found += [(not p.first, n, k, at) for n, (at, p) in enumerate(rows)]
    return [(k, at) for _, _, k, at in sorted(found)]


def as_it_is(text: str) -> str:
    """A text in English."""
    return text


def arranged(
    made: Iterable[tuple[PartName, Section]], measure: Measure | None = None, say: Callable[[str], str] = as_it_is
) -> tuple[Division, ...]:
    """Sections in three parts; those without a section are left out.

    made     the sections in the order in which they are read, and the part that each belongs to
    measure  what of the specialist's sections stands in the appendix: folded parts always, long tables, many figures
    say      what is added here, in the language of the sections

    What goes to the appendix stands there under the title and the number of its section, A7 of section 7; a pointer
    stays where it was.  A table that `stays` does so, whatever its length.  A section of which nothing stays is none of
    the specialist's: it stands in the appendix alone, behind the others.
    """
    every, m = list(made), measure or Measure()
    client = [Placed(number="", section=s) for part, s in every if part == "client"]
    numbered = [s for part, s in every if part == "specialist"]
    away = (
        set[tuple[int, int]]()
        if m.figures is None
        else {at for k, at in enumerate(rows_of_figures(numbered)) if k not in m.figures}
    )

    def parted(k: int, number: int) -> tuple[Section, Section | None]:
        return _parted(numbered[k], number, m.rows, {at for section, at in away if section == k}, say)

    places = range(len(numbered))
    empty = {k for k in places if all(isinstance(p, Pointer) for p in parted(k, 0)[0].parts)}
    empty = {k for k in empty if numbered[k].parts}
    body, looked_up, others = list[Placed](), list[Placed](), list[Section]()
    for number, k in enumerate((k for k in places if k not in empty), 1):
        kept, moved = parted(k, number)
        body.append(Placed(number=str(number), section=kept))
        looked_up += [] if moved is None else [Placed(number=f"A{number}", section=moved)]
    others += [moved for k in places if k in empty and (moved := parted(k, 0)[1]) is not None]
    others += [s for part, s in every if part == "appendix"]
    looked_up += [Placed(number=f"A{k}", section=s) for k, s in enumerate(others, len(body) + 1)]
    divisions: dict[PartName, list[Placed]] = {"client": client, "specialist": body, "appendix": looked_up}
    return tuple(
        Division(name=name, title=say(phrase("report_page.division", name=name)), sections=tuple(placed))
        for name, placed in divisions.items()
        if placed
    )


def _parted(
    section: Section, number: int, rows: int, away: set[int], say: Callable[[str], str]
) -> tuple[Section, Section | None]:
    """What of a section stays, with pointers, and what of it stands in the appendix.

    rows  of a table that stays
    away  positions of figures that do not
    """
    anchor = f"{section.anchor}-appendix"
    kept: list[Part] = []
    moved: list[Part] = []
    heading = section.title
    for k, part in enumerate(section.parts):
        if isinstance(part, Heading):
            heading = part.text
        folded = _folded(part, heading.partition(":")[0], rows, say, away=k in away)
        if folded is None:
            kept.append(part)
            continue
        moved.append(folded)
        before = kept[-1] if kept else None
        if isinstance(before, Pointer):
            kept[-1] = replace(before, items=tuple(dict.fromkeys((*before.items, folded.summary))))
        else:
            kept.append(Pointer(anchor=anchor, number=f"A{number}", items=(folded.summary,)))
    if not moved:
        return section, None
    return replace(section, parts=_without_bare_headings(kept)), Section(
        anchor=anchor, title=section.title, parts=tuple(moved)
    )


def _names(part: Part, heading: str) -> bool:
    """Whether a pointer states what a heading states."""
    return isinstance(part, Pointer) and any(i.startswith(heading) for i in part.items)


def _without_bare_headings(parts: Sequence[Part]) -> tuple[Part, ...]:
    """Parts without headings below which nothing but a pointer stands, which has their words; pointers in one."""
    made: list[Part] = []
    for k, part in enumerate(parts):
        rest = parts[k + 1 : k + 3]
        alone = len(rest) < 2 or isinstance(rest[1], Heading)
        if isinstance(part, Heading) and alone and rest and _names(rest[0], part.text):
            continue
        before = made[-1] if made else None
        if isinstance(part, Pointer) and isinstance(before, Pointer):
            made[-1] = replace(before, items=tuple(dict.fromkeys((*before.items, *part.items))))
        else:
            made.append(part)
    return tuple(made)


def _folded(part: Part, heading: str, rows: int, say: Callable[[str], str], *, away: bool) -> Folded | None:
    """A part as the appendix holds it; None: it stays where it is."""
    if isinstance(part, Folded):
        return part
    if isinstance(part, Table) and len(part.rows) > rows and not part.stays:
        name = part.caption or heading
        return Folded(
            summary=say(phrase("report_page.rows_of", name=name, n=len(part.rows))), parts=(replace(part, caption=""),)
        )
    if isinstance(part, Figures) and away:
        return Folded(summary=say(phrase("report_page.figures_of", name=heading, n=len(part.figures))), parts=(part,))
    return None


def all_sections(divisions: Iterable[Division]) -> Iterator[Placed]:
    """The sections of all parts as they are read."""
    for division in divisions:
        yield from division.sections
