"""CSV tables, read in pieces and checked cell by cell only where a piece does not convert at once.

A good table costs a few hundred nanoseconds a row.  A bad one is left at the first piece that holds an
error, so that a file of rubbish costs seconds and little memory however long it is.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from pathlib import Path
from typing import Any, Literal, NoReturn

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading import words
from raybundle.io.reading.files import decoded, opened
from raybundle.io.reading.rows import BadRow, cells_of
from raybundle.io.reading.words import quoted
from raybundle.io.rows import rows_of
from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index

PIECE_BYTES = 1 << 22
LINE_BYTES = 1 << 20
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """The columns of a table; row k stands in line k + 2 of its file."""

    rows: int
    text: Mapping[str, tuple[str, ...]]
    number: Mapping[str, Array]
    """(rows,) each; NaN where the cell is empty."""
    index: Mapping[str, Index]
    """(rows,) positions in the table that a reference points to."""

    def numbers(self, *names: str) -> Array:
        """Columns side by side (rows, len(names)); NaN for a column that the table lacks."""
        lacking = np.full(self.rows, np.nan)
        return np.stack([self.number.get(name, lacking) for name in names], axis=1)


@dataclass(frozen=True, slots=True)
class Problem:
    """One error in a file."""

    line: int
    column: str | None
    message: str


def fail(path: Path, problems: Sequence[Problem]) -> NoReturn:
    """Raise the InputError of the first problem, which also lists the next few."""
    ordered = sorted(problems, key=lambda p: p.line)
    first, others = ordered[0], ordered[1:SHOWN]
    message = first.message
    for p in others:
        message += f"\n  also line {p.line}{f', column {p.column}' if p.column else ''}: {p.message}"
    if len(ordered) > SHOWN:
        message += "\n  and more; the rest of the file was not looked at"
    raise InputError(message, file=path, line=first.line, column=first.column)


def read_table(
    path: Path, columns: Sequence[Column], *, unique: tuple[str, ...] = (), least_rows: int = 1,
    without: str = "delete the file if the block has none of these",
) -> Table:  # fmt: skip
    """The table in a CSV file.

    unique  two reference columns whose pairs of values must differ from row to row
    without  what to do in place of filling a table that has too few rows
    raises  InputError with file, line, column, the offending text and what to do
    """
    table = _read_plain(path, columns, unique) or _read_cells(path, columns, unique)
    if table.rows < least_rows:
        raise InputError(
            f"the table has a header but {'no' if not table.rows else 'too few'} rows; fill it, or {without}",
            file=path,
            line=1,
        )
    return table


def _read_plain(path: Path, columns: Sequence[Column], unique: tuple[str, ...]) -> Table | None:
    """The table by the compiled reader; None where that is not there or something wants a closer look."""
    module = native.module()
    if module is None:
        return None
    pieces = _raw_pieces(path)
    header, end, rest = next(pieces, (b"", 0))[0].partition(b"\n")
    if not end:
        return None
    try:
        present = _check_header(path, header.decode().removesuffix("\r"), columns)
    except (InputError, UnicodeDecodeError):
        return None  # which the other way tells, with all that there is to it
    pair = [k for k, c in enumerate(present) if c.name in unique]
    reader = module.Columns([c.kind == "number" for c in present])
    for piece in chain((rest,), (data for data, _ in pieces)):
        if not reader.add(piece):
            return None
        if pair and reader.rows > math.prod(reader.different(k) for k in pair):
            return None  # some stand twice, and there may be no end to them
    table = _of_plain(present, reader)
    return None if table and pair and len(_pairs_again([table.index[name] for name in unique])[1]) else table


def _of_plain(present: Sequence[Column], reader: Any) -> Table | None:
    numbers: dict[str, Array] = {}
    texts: dict[str, tuple[Index, list[str]]] = {}
    for k, column in enumerate(present):
        if column.kind == "number":
            values = words.bounded(reader.number(k))
            if values is None or not _numbers_good(column, values):
                return None
            numbers[column.name] = values
            continue
        codes, joined = reader.text(k)
        try:
            different = joined.decode().split("\n")[:-1]
        except UnicodeDecodeError:
            return None
        texts[column.name] = codes, different
        if not _texts_good(column, different, reader.rows):
            return None
    of = {c.name: c for c in present}
    text, index = dict[str, tuple[str, ...]](), dict[str, Index]()
    for name, (codes, different) in texts.items():
        column = of[name]
        if column.kind == "id":
            text[name] = tuple(different)
        elif column.kind == "text":
            text[name] = tuple(map(different.__getitem__, codes.tolist()))
        else:
            for t in different if column.kind == "new_reference" else ():
                column.known.setdefault(t, len(column.known))
            index[name] = np.fromiter(map(column.known.__getitem__, different), np.int32, len(different))[codes]
    return Table(rows=reader.rows, text=text, number=numbers, index=index)


def _texts_good(column: Column, different: Sequence[str], rows: int) -> bool:
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


def _read_cells(path: Path, columns: Sequence[Column], unique: tuple[str, ...]) -> Table:
    """The table cell by cell, quoted ones too; raises InputError for what is wrong."""
    pieces = _pieces(path)
    header_line, rest = _header_and_rest(path, pieces)
    present = _check_header(path, header_line, columns)
    parts: list[list[object]] = [[] for _ in present]
    seen: list[dict[str, int]] = [{} for _ in present]
    rows = 0
    for piece in chain(rest, pieces):
        first_line = rows + 2
        cells = _cells(path, piece, len(present), first_line)
        problems: list[Problem] = []
        for column, values, part, ids in zip(present, cells, parts, seen, strict=True):
            part.append(_convert(column, values, first_line, ids, problems))
        if problems:
            fail(path, problems)
        if unique:
            last = {c.name: part[-1] for c, part in zip(present, parts, strict=True)}
            _check_pairs(path, [last[name] for name in unique], unique, rows)
        rows += len(cells[0])
    table = _join(present, parts, rows)
    if unique:
        _check_pairs(path, [table.index[name] for name in unique], unique, 0)
    return table


def _pieces(path: Path) -> Iterator[str]:
    """The file's text in pieces of whole lines, without the last line's end; errors name the line."""
    for data, line in _raw_pieces(path):
        yield _decoded(path, data, line)


def _raw_pieces(path: Path) -> Iterator[tuple[bytes, int]]:
    """The file's bytes in pieces of whole lines, without the last line's end, each with the number of its first."""
    line = 1
    rest = b""
    with opened(path) as file:
        while block := file.read(PIECE_BYTES):
            if line == 1 and not rest:
                block = block.removeprefix(b"\xef\xbb\xbf")
            block = rest + block
            cut = block.rstrip(b"\r\n").rfind(b"\n") + 1
            rest = block[cut:]
            if cut:
                yield block[: cut - 1].removesuffix(b"\r"), line
                line += block.count(b"\n", 0, cut)
            if len(rest) > LINE_BYTES:
                blank = len(rest) - len(rest.rstrip(b"\r\n"))
                what = "1 MiB of empty lines" if blank > LINE_BYTES // 2 else "a line of more than 1 MiB"
                raise InputError(f"{what}: this is not a table; export it again", file=path, line=line)
    rest = rest.rstrip(b"\r\n")
    if rest:
        yield rest, line


def _decoded(path: Path, data: bytes, line: int) -> str:
    return decoded(path, data, line).replace("\r\n", "\n")


def _header_and_rest(path: Path, pieces: Iterator[str]) -> tuple[str, tuple[str, ...]]:
    """The header line, and the rest of its piece if there is any."""
    first = next(pieces, None)
    if first is None:
        raise InputError(
            "the file is empty; it needs a header line and rows, or delete it if the block has none of these",
            file=path,
            line=1,
        )
    header, end, rest = first.partition("\n")
    return header, (rest,) if end else ()


def _check_header(path: Path, line: str, columns: Sequence[Column]) -> list[Column]:
    """The columns in the order of the file."""
    by_name = {c.name: c for c in columns}
    needed = ",".join(c.name for c in columns if not c.optional)
    optional = [c.name for c in columns if c.optional]
    should = f"the header is {needed}" + (f", optional {', '.join(optional)}" if optional else "")
    try:
        names = next(cells_of([line]), [])
    except BadRow as error:
        raise InputError(f"the header cannot be read ({error}); {should}", file=path, line=1) from None
    for position, name in enumerate(names):
        if name not in by_name:
            raise InputError(f"unknown column {quoted(name)}; {should}", file=path, line=1, column=name[:40])
        if name in names[:position]:
            raise InputError(f"column {name!r} stands twice; {should}", file=path, line=1, column=name)
    missing = [c.name for c in columns if not c.optional and c.name not in names]
    if missing:
        raise InputError(f"column {missing[0]!r} is missing; {should}", file=path, line=1, column=missing[0])
    return [by_name[name] for name in names]


def _cells(path: Path, piece: str, width: int, first_line: int) -> list[list[str]]:
    """The cells of a piece by columns; the quick way if no cell is quoted and every row has `width` cells."""
    if '"' not in piece and "\r" not in piece and width > 1:
        data = np.frombuffer(piece.encode(), np.uint8)
        breaks = data[(data == ord(",")) | (data == ord("\n"))]
        rows = int(np.count_nonzero(breaks == ord("\n"))) + 1
        if len(breaks) == rows * width - 1 and (breaks[width - 1 :: width] == ord("\n")).all():
            flat = piece.replace("\n", ",").split(",")
            return [flat[k::width] for k in range(width)]
    return _cells_one_by_one(path, piece, width, first_line)


def _cells_one_by_one(path: Path, piece: str, width: int, first_line: int) -> list[list[str]]:
    lines = piece.split("\n")
    rows: list[list[str]] = []
    problems: list[Problem] = []
    try:
        for row in cells_of(lines):
            if len(row) != width:
                problems.append(Problem(first_line + len(rows), None, _wrong_width(row, width)))
                if len(problems) > SHOWN:
                    break
            rows.append(row)
    except BadRow as error:
        problems.append(Problem(first_line + error.position, None, str(error)))
    if problems:
        fail(path, problems)
    return [list(column) for column in zip(*rows, strict=True)]


def _wrong_width(row: Sequence[str], width: int) -> str:
    if not any(row):
        return "empty line; delete it"
    hint = ""
    if len(row) > width:
        hint = " (the decimal sign is a point, not a comma)"
    elif any(";" in cell for cell in row):
        hint = " (cells are separated by commas, not by semicolons)"
    return f"{len(row)} cells, the header has {width}{hint}: {quoted(','.join(row))}"


def _convert(
    column: Column, cells: list[str], first_line: int, seen: dict[str, int], problems: list[Problem]
) -> object:
    """The values of one column; what is wrong is added to `problems`."""
    if column.kind == "number":
        values = words.column_of(cells)
        if values is not None and _numbers_good(column, values):
            return values
        problems.extend(_bad_numbers(column, cells, first_line))
        return np.zeros(0)
    if column.kind == "text":
        if not column.empty and "" in cells:
            problems.append(Problem(first_line + cells.index(""), column.name, "the cell is empty; fill it"))
        return tuple(cells)
    if not "".join(cells).isprintable():
        problems.extend(_bad_text(column, cells, first_line))
        return np.zeros(0, np.int32)
    if column.kind == "id":
        return _new_ids(column, cells, first_line, seen, problems)
    return _references(column, cells, first_line, problems)


def _numbers_good(column: Column, values: Array) -> bool:
    """Whether numbers, NaN for an empty cell, are what a column allows."""
    finite = np.isfinite(values)
    if not (column.empty or finite.all()):
        return False
    known = values[finite]
    return not ((column.limit == "> 0" and (known <= 0).any()) or (column.limit == ">= 0" and (known < 0).any()))


def _bad_numbers(column: Column, cells: Iterable[str], first_line: int) -> Iterator[Problem]:
    found = 0
    for k, cell in enumerate(cells):
        message = _why_not_a_number(column, cell)
        if message:
            yield Problem(first_line + k, column.name, message)
            found += 1
            if found > SHOWN:
                return


def _why_not_a_number(column: Column, cell: str) -> str:
    if not cell:
        return "" if column.empty else "the cell is empty; a number is needed here"
    value = words.number_of(cell)
    if value is None:
        if words.NOT_FINITE.fullmatch(cell):
            empty = ", or leave the cell empty where it is not known" if column.empty else ""
            return f"{words.no_number(cell)}; give one that is{empty}"
        return f"{quoted(cell)} is not a number; the decimal sign is a point, an unknown value an empty cell"
    if column.limit == "> 0" and value <= 0:
        tiny = f" is nearer to 0 than {words.SMALLEST:g} and counts as 0; it" if words.vanishes(cell) else ""
        return f"{quoted(cell)}{tiny} must be greater than 0"
    if column.limit == ">= 0" and value < 0:
        return f"{quoted(cell)} is negative; a standard deviation is 0 (held) or greater"
    return ""


def _bad_text(column: Column, cells: Iterable[str], first_line: int) -> Iterator[Problem]:
    bad = [(k, cell) for k, cell in enumerate(cells) if not cell.isprintable()]
    for k, cell in bad[: SHOWN + 1]:
        yield Problem(
            first_line + k, column.name, f"{quoted(cell)} holds characters that cannot be printed; delete them"
        )


def _new_ids(
    column: Column, cells: list[str], first_line: int, seen: dict[str, int], problems: list[Problem]
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
            problems.append(
                Problem(line, column.name, f"{quoted(cell)} is no id: it is empty or has blanks at its ends")
            )
        elif cell in seen:
            problems.append(Problem(line, column.name, f"id {quoted(cell)} stands already in line {seen[cell] + 2}"))
        else:
            seen[cell] = line - 2
        if len(problems) > SHOWN:
            break
    return ()


def _references(column: Column, cells: list[str], first_line: int, problems: list[Problem]) -> Index:
    known = column.known
    if column.kind == "new_reference":
        for cell in dict.fromkeys(cells):
            if cell not in known:
                if not cell or cell != cell.strip():
                    message = f"{quoted(cell)} is no id: it is empty or has blanks at its ends"
                    problems.append(Problem(first_line + cells.index(cell), column.name, message))
                known[cell] = len(known)
    try:
        return np.fromiter(map(known.__getitem__, cells), np.int32, len(cells))
    except KeyError:
        pass
    found = 0
    for k, cell in enumerate(cells):
        if cell not in known:
            message = f"{quoted(cell)} stands nowhere in {column.where}; correct it or add it there"
            problems.append(Problem(first_line + k, column.name, message))
            found += 1
            if found > SHOWN:
                break
    return np.zeros(0, np.int32)


def _pairs_again(pair: Sequence[object]) -> tuple[Index, Index]:
    """An order of the rows in which equal pairs stand together, and where in it one stands again."""
    a, b = (np.asarray(p, np.int64) for p in pair)
    key = (a << 32) | b
    if (np.diff(key) > 0).all():
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    order = np.argsort(key, kind="stable")
    return order, np.flatnonzero(np.diff(key[order]) == 0)


def _check_pairs(path: Path, pair: Sequence[object], names: tuple[str, ...], first_row: int) -> None:
    """Raise where a pair of references stands twice."""
    order, again = _pairs_again(pair)
    if len(again) == 0:
        return
    problems: list[Problem] = []
    for k in sorted(again, key=lambda k: int(order[k + 1]))[: SHOWN + 1]:
        line, earlier = (first_row + int(order[j]) + 2 for j in (k + 1, k))
        message = f"this {' and '.join(names)} stand already in line {earlier}; delete one of the two"
        problems.append(Problem(line, names[-1], message))
    fail(path, problems)


def _join(columns: Sequence[Column], parts: Sequence[Sequence[object]], rows: int) -> Table:
    text: dict[str, tuple[str, ...]] = {}
    number: dict[str, Array] = {}
    index: dict[str, Index] = {}
    for column, part in zip(columns, parts, strict=True):
        if column.kind == "number":
            number[column.name] = np.concatenate([np.zeros(0), *(np.asarray(p, float) for p in part)])
        elif column.kind in {"reference", "new_reference"}:
            index[column.name] = np.concatenate([np.zeros(0, np.int32), *(np.asarray(p, np.int32) for p in part)])
        else:
            text[column.name] = tuple(cell for p in part if isinstance(p, tuple) for cell in p)
    return Table(rows=rows, text=text, number=number, index=index)


def write_table(path: Path, columns: Mapping[str, Sequence[str] | Array]) -> None:
    """Write a CSV file: text as it is, numbers shortest so that they read back equal, NaN as an empty cell.

    Cells are made for some rows at a time: as text they take ten times the memory of the numbers.
    """
    rows = {len(c) for c in columns.values()}
    if len(rows) > 1:
        raise ValueError(f"columns of {sorted(rows)} rows in {path.name}")
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(columns) + "\n")
        for start in range(0, max(rows, default=0), WRITTEN_ROWS):
            parts = [c[start : start + WRITTEN_ROWS] for c in columns.values()]
            file.write(rows_of(parts))


WRITTEN_ROWS = 1 << 13
"""Rows whose cells are made at a time: some 10 MB of text in a table of twenty columns."""


def times_in_order(table: Table, file: Path) -> Array:
    """The column time_s; raises InputError where a time does not follow the one before."""
    time = table.number["time_s"]
    late = np.flatnonzero(np.diff(time) <= 0)
    if len(late):
        k = int(late[0])
        raise InputError(
            f"time {time[k + 1]:.10g} s does not follow {time[k]:.10g} s; sort the table", file=file, line=k + 3,
            column="time_s",
        )  # fmt: skip
    return time
