"""Setting a document as PDF, by Typst."""

from __future__ import annotations

import json
from collections.abc import Generator, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib.resources import as_file, files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.errors import InputError
from raybundle.io.reading.trees import json_of
from raybundle.report.arrangement import LONG, Measure, rows_of_figures
from raybundle.report.paper.copy import Copy, copy_of
from raybundle.report.parts import Section, Statements

if TYPE_CHECKING:
    from raybundle.report.document import Document


BODY = 6
"""Pages that client and specialist read; of a report that has more, more stands in the appendix."""
FILLED = 5
"""Further figures that are tried where one does not fit: each is a page make-up of a quarter of a second."""
ROWS = (LONG, 12, 6, 0)
"""Rows of a table in the body, tried one after the other where its words alone take too many pages."""


def pdf_of(document: Document) -> bytes:
    """The PDF: A4, bookmarks, running heads, every font in it; at most six pages before the appendix where that can be.

    raises  InputError where the typesetter is not installed
    """
    return _set(fitted(document))


def fitted(document: Document) -> Copy:
    """The copy with as many figures and rows as six pages before the appendix hold.

    Words, key figures and warnings stay whatever they take.
    """
    if not document.divided:
        return copy_of(document)
    document = with_client_page(document)
    count = len(rows_of_figures(s for part, s in document.made if part == "specialist"))
    for rows in ROWS:
        if _holds(document, rows, range(count)):
            return copy_of(document, Measure(rows=rows))
        if _holds(document, rows, ()):
            return copy_of(document, Measure(rows=rows, figures=frozenset(_kept(document, rows, count))))
    return copy_of(document, Measure(rows=ROWS[-1], figures=frozenset()))


def with_client_page(document: Document) -> Document:
    """The document with as many next steps as the client's page holds; all of them where even one is too many."""
    most = max((len(p.statements) for p in _cuttable(document)), default=0)
    for steps in range(most, 0, -1):
        made = tuple((part, _first(s, steps) if part == "client" else s) for part, s in document.made)
        shorter = replace(document, made=made)
        client = copy_of(replace(shorter, made=tuple((part, s) for part, s in made if part == "client")))
        client["divisions"].append({"name": "appendix", "title": "", "sections": []})  # pages are counted before it
        if body_pages(client) <= 1:
            return shorter
    return document


def _cuttable(document: Document) -> Iterator[Statements]:
    """Statements of the client's page of which some may be left to the warnings."""
    for part, section in document.made:
        if part == "client":
            yield from (p for p in section.parts if isinstance(p, Statements) and p.rests)


def _first(section: Section, most: int) -> Section:
    parts = tuple(p.first(most) if isinstance(p, Statements) else p for p in section.parts)
    return replace(section, parts=parts)


def _kept(document: Document, rows: int, count: int) -> list[int]:
    """Figures that stay: of the first ones as many as fit, found by bisection; of the next, those that fit as well."""
    low, high = 0, count
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if _holds(document, rows, range(middle)) else (low, middle)
    kept = list(range(low))
    for more in range(high, min(high + FILLED, count)):  # a high figure leaves blanks that lower ones fill
        if _holds(document, rows, [*kept, more]):
            kept.append(more)
    return kept


def _holds(document: Document, rows: int, figures: Iterable[int]) -> bool:
    measure = Measure(rows=rows, figures=frozenset(figures))
    return body_pages(copy_of(document, measure, appendix=False)) <= BODY


def body_pages(copy: Copy) -> int:
    """Pages of a copy before its appendix."""
    with _template() as template:
        pages = typesetter().query(template, "<pages>", field="value", one=True, sys_inputs=_inputs(copy))
    return int(json_of(pages, Path(template)))


def _set(copy: Copy) -> bytes:
    """Set what `copy_of` made; fonts of the machine serve characters alone that the typesetter's own have not."""
    with _template() as template:
        return bytes(typesetter().compile(template, format="pdf", sys_inputs=_inputs(copy)))


def _inputs(copy: Copy) -> dict[str, str]:
    return {"report": json.dumps(copy, ensure_ascii=False)}


@contextmanager
def _template() -> Generator[str]:
    with as_file(files("raybundle.report") / "templates" / "report.typ") as path:
        yield str(path)


def typesetter() -> Any:
    """The library; raises InputError where it is not installed."""
    try:
        import typst
    except ImportError as error:
        raise InputError("package.typst_missing") from error
    return typst
