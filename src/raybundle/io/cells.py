"""The cells of a column of a table become what the column must hold, or problems that name line and column."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, NoReturn

import numpy as np

from raybundle.errors import InputError, Message, Place, message
from raybundle.io.reading import words
from raybundle.io.reading.dialects import with_points, without_groups
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array, Index
from raybundle.readable import readable

SHOWN = 5
"""Errors that one message lists."""

Kind = Literal["id", "text", "number", "reference", "new_reference"]
Limit = Literal["", "> 0", ">= 0"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Column:
    """What a column of a table must hold."""

    name: str
    kind: Kind
    """id: unique text; reference: the id of a row of another table; new_reference: the same, where an id not
    yet known adds one to `known`."""
    optional: bool = False
    """Whether the header may lack it."""
    empty: bool = False
    """Whether a cell may be empty: "not known"."""
    limit: Limit = ""
    known: dict[str, int] = field(default_factory=dict[str, int])
    """Ids of the other table and their positions."""
    where: str = ""
    """Name of the other table."""


@dataclass(frozen=True, slots=True)
class Problem:
    """One error in a file."""

    line: int
    column: str | None
    message: Message


def fail(path: Path, problems: Sequence[Problem]) -> NoReturn:
    """Raise the InputError of the first problem, which also lists the next few."""
    ordered = sorted(problems, key=lambda p: p.line)
    first, others = ordered[0], ordered[1:SHOWN]
    more = len(ordered) > SHOWN
    rows = path.suffix == ".parquet"
    details = [replace(p.message, place=Place(line=p.line, column=p.column, rows=rows)) for p in others]
    found = replace(first.message, details=(*details, *([message("table.more_errors")] if more else ())))
    raise InputError(found, file=path, line=first.line, column=first.column)


def converted(
    column: Column, cells: list[str], first_line: int, seen: dict[str, int], problems: list[Problem],
    decimal: str = ".", path: Path | None = None,
) -> object:  # fmt: skip
    """The values of one column; what is wrong is added to `problems`.

    decimal  the sign before decimals: a comma only in tables whose cells no comma separates
    path     the file, where its rows are not lines
    """
    if column.kind == "number":
        values = words.column_of(with_points(cells) if decimal == "," else cells)
        if values is not None and numbers_good(column, values):
            return values
        problems.extend(_bad_numbers(column, cells, first_line, decimal))
        return np.zeros(0)
    if column.kind == "text":
        if not column.empty and "" in cells:
            problems.append(Problem(first_line + cells.index(""), column.name, message("cell.empty")))
        return tuple(cells)
    if column.kind == "reference" and not "".join(cells).isprintable():  # the name as the file system holds it
        cells = [new if (new := readable(c)) in column.known else c for c in cells]
    if not "".join(cells).isprintable():
        problems.extend(_bad_text(column, cells, first_line))
        return np.zeros(0, np.int32)
    if column.kind == "id":
        return _new_ids(column, cells, first_line, seen, problems, path)
    return _references(column, cells, first_line, problems)


def numbers_good(column: Column, values: Array) -> bool:
    """Whether numbers, NaN for an empty cell, are what a column allows."""
    finite = np.isfinite(values)
    if not (column.empty or finite.all()):
        return False
    known = values[finite]
    return not ((column.limit == "> 0" and (known <= 0).any()) or (column.limit == ">= 0" and (known < 0).any()))


def texts_good(column: Column, different: Sequence[str], rows: int) -> bool:
    """Whether the different texts of a column can be what they should."""
    if column.kind == "text":
        return column.empty or "" not in different
    if not "".join(different).isprintable():
        return False
    if column.kind == "reference":
        return column.known.keys() >= set(different)
    known = column.known if column.kind == "new_reference" else {}
    plain = not any((not t or t != t.strip()) and t not in known for t in different)
    return plain and (column.kind != "id" or len(different) == rows)


def _bad_numbers(column: Column, cells: Iterable[str], first_line: int, decimal: str) -> Iterator[Problem]:
    found = 0
    for k, cell in enumerate(cells):
        why = _why_not_a_number(column, cell, decimal)
        if why is not None:
            yield Problem(first_line + k, column.name, why)
            found += 1
            if found > SHOWN:
                return


def _why_not_a_number(column: Column, cell: str, decimal: str) -> Message | None:
    if not cell:
        return None if column.empty else message("cell.empty")
    value = words.number_of(with_points([cell])[0] if decimal == "," else cell)
    if value is None:
        if plain := without_groups(cell):
            return message("cell.grouped_thousands", value=quoted(cell), plain=plain)
        if words.NOT_FINITE.fullmatch(cell):
            return words.no_number(cell)
        sign = "comma" if decimal == "," else "point"
        return message("cell.not_a_number", value=quoted(cell), sign=sign)
    if column.limit == "> 0" and value <= 0:
        if words.vanishes(cell):
            return message("cell.counts_as_zero", value=quoted(cell), smallest=words.SMALLEST)
        return message("cell.not_positive", value=quoted(cell))
    if column.limit == ">= 0" and value < 0:
        return message("cell.negative_sigma", value=quoted(cell))
    return None


def _bad_text(column: Column, cells: Iterable[str], first_line: int) -> Iterator[Problem]:
    bad = [(k, cell) for k, cell in enumerate(cells) if not cell.isprintable()]
    for k, cell in bad[: SHOWN + 1]:
        yield Problem(first_line + k, column.name, message("cell.unprintable", value=quoted(cell)))


def _new_ids(
    column: Column, cells: list[str], first_line: int, seen: dict[str, int], problems: list[Problem], path: Path | None
) -> tuple[str, ...]:
    before = len(seen)
    fresh = dict(zip(cells, range(before, before + len(cells)), strict=True))
    edges = "" in fresh or any(c != c.strip() for c in fresh)
    if len(fresh) == len(cells) and not edges and seen.keys().isdisjoint(fresh):
        seen.update(fresh)
        return tuple(cells)
    for k, cell in enumerate(cells):
        line = first_line + k
        if not cell or cell != cell.strip():
            problems.append(Problem(line, column.name, message("cell.no_id", value=quoted(cell))))
        elif cell in seen:
            earlier, rows = earlier_place(path, seen[cell] + 2)
            problems.append(
                Problem(line, column.name, message("cell.id_twice", id=quoted(cell), earlier=earlier, rows=rows))
            )
        else:
            seen[cell] = line - 2
        if len(problems) > SHOWN:
            break
    return ()


def earlier_place(path: Path | None, line: int) -> tuple[int, bool]:
    """Line of a table's file, from 1, False; in Parquet, which has no lines, number of the row, from 1, True."""
    rows = path is not None and path.suffix == ".parquet"
    return (line - 1 if rows else line), rows


def _references(column: Column, cells: list[str], first_line: int, problems: list[Problem]) -> Index:
    known = column.known
    if column.kind == "new_reference":
        for cell in dict.fromkeys(cells):
            if cell not in known:
                if not cell or cell != cell.strip():
                    wrong = message("cell.no_id", value=quoted(cell))
                    problems.append(Problem(first_line + cells.index(cell), column.name, wrong))
                known[cell] = len(known)
    try:
        return np.fromiter(map(known.__getitem__, cells), np.int32, len(cells))
    except KeyError:
        pass
    found = 0
    for k, cell in enumerate(cells):
        if cell not in known:
            wrong = message("cell.unknown_id", id=quoted(cell), table=column.where)
            problems.append(Problem(first_line + k, column.name, wrong))
            found += 1
            if found > SHOWN:
                break
    return np.zeros(0, np.int32)
