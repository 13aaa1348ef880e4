"""Tables: CSV, read in pieces and checked cell by cell only where a piece does not convert at once.

A good table costs a few hundred nanoseconds a row.  A bad one is left at the first piece that holds an
error, so that a file of rubbish costs seconds and little memory however long it is.
"""

from __future__ import annotations

import codecs
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, Message, message
from raybundle.io.cells import SHOWN, Column, Problem, converted, earlier_place, fail, numbers_good, texts_good
from raybundle.io.digits import EVERY, Digits, rounded
from raybundle.io.parquet import groups, names_of, write_parquet
from raybundle.io.reading import words
from raybundle.io.reading.dialects import (
    NAMES,
    PLAIN,
    TABLE_BYTES,
    Dialect,
    TwoSigns,
    decimal_sign,
    dialect_of_file,
    table_text,
)
from raybundle.io.reading.files import as_utf8, decoded, opened, read_bytes
from raybundle.io.reading.rows import BadRow
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.rows import rows_of
from raybundle.numerics import native
from raybundle.numerics.arrays import Array, Index

PARQUET = ".parquet"
PIECE_BYTES = 1 << 22
LINE_BYTES = 1 << 20
MOST_LISTED = 100
"""Columns of a message"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """The columns of a table; row k stands in line k + first_line of its file."""

    rows: int
    first_line: int = 2
    text: Mapping[str, tuple[str, ...]]
    number: Mapping[str, Array]
    """(rows,) each; NaN where the cell is empty."""
    index: Mapping[str, Index]
    """(rows,) positions in the table that a reference points to."""

    def numbers(self, *names: str) -> Array:
        """Columns side by side (rows, len(names)); NaN for a column that the table lacks."""
        lacking = np.full(self.rows, np.nan)
        return np.stack([self.number.get(name, lacking) for name in names], axis=1)


def read_table(
    path: Path, columns: Sequence[Column], *, unique: tuple[str, ...] = (), least_rows: int = 1, own: bool = False
) -> Table:
    """The table in a Parquet file, or in a CSV file as raybundle or a spreadsheet of any country writes it.

    The header shows what separates the cells: commas, semicolons or tabs.  With the latter two the decimal sign may be
    a comma (`raybundle.io.reading.dialects`), and a file that is not UTF-8 is Windows-1252.

    own     as raybundle writes it and no other way: cells separated by commas, decimal points, UTF-8
    unique  two reference columns whose pairs of values must differ from row to row

    raises  InputError with file, line, column, the offending text and what to do
    """
    dialect = PLAIN if own or path.suffix == PARQUET else dialect_of_file(path)
    if path.suffix == PARQUET:
        table = _read_parquet(path, columns, unique)
    elif dialect.plain:
        table = _read_plain(path, columns, unique) or _read_cells(path, columns, unique)
    else:
        table = _read_dialect(path, columns, unique, dialect)
    if table.rows < least_rows:
        raise InputError("table.too_few_rows", n=table.rows, least=least_rows, file=path, line=table.first_line - 1)
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
        return None  # which the other way shows, with all that there is to it
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
            if values is None or not numbers_good(column, values):
                return None
            numbers[column.name] = values
            continue
        codes, joined = reader.text(k)
        try:
            different = joined.decode().split("\n")[:-1]
        except UnicodeDecodeError:
            return None
        texts[column.name] = codes, different
        if not texts_good(column, different, reader.rows):
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
            part.append(converted(column, values, first_line, ids, problems))
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


def _read_parquet(path: Path, columns: Sequence[Column], unique: tuple[str, ...]) -> Table:
    """The table in a Parquet file."""
    present: Sequence[Column] = ()
    parts: list[list[object]] = []
    rows = 0
    for piece in groups(path, lambda names: _check_names(path, names, columns)):
        present, parts = piece.columns, parts or [[] for _ in piece.columns]
        for part, found in zip(parts, piece.parts, strict=True):
            part.append(found)
        rows += piece.rows
        if unique and rows > math.prod(len(c.known) for c in present if c.name in unique):
            break  # some stand twice, and there may be no end to them
    table = _join(present, parts, rows)
    if unique and rows:
        _check_pairs(path, [table.index[name] for name in unique], unique, 0)
    return table


def table_pieces(path: Path, columns: Sequence[Column]) -> Iterator[Table]:
    """The table in a Parquet file, a group of rows at a time; `first_line` states where in the table each begins.

    Limits: whether a pair of references stands twice.
    """
    first_line = 2
    for piece in groups(path, lambda names: _check_names(path, names, columns)):
        made = _join(piece.columns, [[part] for part in piece.parts], piece.rows)
        yield replace(made, first_line=first_line)
        first_line += piece.rows


def _read_dialect(path: Path, columns: Sequence[Column], unique: tuple[str, ...], dialect: Dialect) -> Table:
    """The table of a spreadsheet, all of it at once: its decimal sign is one."""
    lines = table_text(path).split("\n")
    header, lines = "".join(lines[dialect.above : dialect.above + 1]), lines[dialect.above + 1 :]
    first_line = dialect.above + 2
    present = _check_header(path, header, columns, dialect)
    cells = _cells_one_by_one(path, lines, len(present), first_line, dialect) if lines else [[] for _ in present]
    numbers = [(c.name, values) for c, values in zip(present, cells, strict=True) if c.kind == "number"]
    try:
        sign = "." if dialect.separator == "," else decimal_sign(numbers)
    except TwoSigns as two:
        at = first_line + two.later.row
        fail(path, [Problem(at, two.later.column, two.problem(first_line + two.first.row))])
    problems: list[Problem] = []
    parts: list[list[object]] = []
    for c, values in zip(present, cells, strict=True):
        parts.append([converted(c, values, first_line, {}, problems, sign)])
    if problems:
        fail(path, problems)
    table = replace(_join(present, parts, len(cells[0]) if cells else 0), first_line=first_line)
    if unique:
        _check_pairs(path, [table.index[name] for name in unique], unique, dialect.above)
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
                block, whole = _as_utf8(path, block)
                if whole:
                    file.seek(0, os.SEEK_END)
            block = rest + block
            cut = block.rstrip(b"\r\n").rfind(b"\n") + 1
            rest = block[cut:]
            if cut:
                yield block[: cut - 1].removesuffix(b"\r"), line
                line += block.count(b"\n", 0, cut)
            if len(rest) > LINE_BYTES:
                blank = len(rest) - len(rest.rstrip(b"\r\n"))
                raise InputError(
                    "table.line_too_long", empty=blank > LINE_BYTES // 2, limit_bytes=LINE_BYTES, file=path, line=line
                )
    rest = rest.rstrip(b"\r\n")
    if rest:
        yield rest, line


def _as_utf8(path: Path, block: bytes) -> tuple[bytes, bool]:
    """The first piece without a mark; of a file in UTF-16 all of it, as UTF-8, and that it is all."""
    begin = as_utf8(block, whole=False)
    if begin == block.removeprefix(codecs.BOM_UTF8):
        return begin, False
    return as_utf8(read_bytes(path, TABLE_BYTES)), True


def _decoded(path: Path, data: bytes, line: int) -> str:
    return decoded(path, data, line).replace("\r\n", "\n")


def _header_and_rest(path: Path, pieces: Iterator[str]) -> tuple[str, tuple[str, ...]]:
    """The header line, and the rest of its piece if there is any."""
    first = next(pieces, None)
    if first is None:
        raise InputError("table.empty", file=path, line=1)
    header, end, rest = first.partition("\n")
    return header, (rest,) if end else ()


def _check_header(path: Path, line: str, columns: Sequence[Column], dialect: Dialect = PLAIN) -> list[Column]:
    """The columns in the order of the file."""
    at = dialect.above + 1
    try:
        names = next(dialect.cells([line]), [])
    except BadRow as error:
        raise InputError(error.problem, file=path, line=at) from None
    return _check_names(path, names, columns, at)


def holds_values(header: Sequence[str]) -> bool:
    """Whether the first line of a table is one of its rows: most of its cells are numbers."""
    return 2 * sum(number_of(name) is not None for name in header) > len(header)


def _check_names(path: Path, names: Sequence[str], columns: Sequence[Column], at: int = 1) -> list[Column]:
    """The columns in the order of their names in the file, which stand in line `at`."""
    by_name = {c.name: c for c in columns}
    needed = [c.name for c in columns if not c.optional]
    if holds_values(names):
        raise InputError("table.no_header", header=header_shown(names), needed=needed, file=path, line=at)
    for position, name in enumerate(names):
        if name not in by_name:
            raise InputError(
                "table.unknown_column", name=quoted(name), needed=needed,
                optional=[c.name for c in columns if c.optional] or ["-"], file=path, line=at, column=name[:40],
            )  # fmt: skip
        if name in names[:position]:
            raise InputError("table.column_twice", name=name, file=path, line=at, column=name)
    missing = [name for name in needed if name not in names]
    if missing:
        raise InputError(
            "table.columns_missing", names=missing, header=header_shown(names), needed=needed, file=path, line=at,
            column=missing[0],
        )  # fmt: skip
    return [by_name[name] for name in names]


def header_shown(names: Sequence[str]) -> list[str]:
    """The names in a header, as a message lists them."""
    return [quoted(name)[1:-1] for name in names[:MOST_LISTED]]


def _cells(path: Path, piece: str, width: int, first_line: int) -> list[list[str]]:
    """The cells of a piece by columns; the quick way if no cell is quoted and every row has `width` cells."""
    if '"' not in piece and "\r" not in piece and width > 1:
        data = np.frombuffer(piece.encode(), np.uint8)
        breaks = data[(data == ord(",")) | (data == ord("\n"))]
        rows = int(np.count_nonzero(breaks == ord("\n"))) + 1
        if len(breaks) == rows * width - 1 and (breaks[width - 1 :: width] == ord("\n")).all():
            flat = piece.replace("\n", ",").split(",")
            return [flat[k::width] for k in range(width)]
    return _cells_one_by_one(path, piece.split("\n"), width, first_line)


def _cells_one_by_one(
    path: Path, lines: Sequence[str], width: int, first_line: int, dialect: Dialect = PLAIN
) -> list[list[str]]:
    rows: list[list[str]] = []
    problems: list[Problem] = []
    try:
        for row in dialect.cells(lines):
            if len(row) != width:
                problems.append(Problem(first_line + len(rows), None, _wrong_width(row, width, dialect)))
                if len(problems) > SHOWN:
                    break
            rows.append(row)
    except BadRow as error:
        problems.append(Problem(first_line + error.position, None, error.problem))
    if problems:
        fail(path, problems)
    return [list(column) for column in zip(*rows, strict=True)]


def _wrong_width(row: Sequence[str], width: int, dialect: Dialect) -> Message:
    if not any(row):
        return message("table.empty_line")
    hint = "none"
    if not dialect.plain:
        hint = NAMES[dialect.separator]
    elif len(row) > width:
        hint = "decimal_comma"
    elif any(";" in cell for cell in row):
        hint = "commas"
    return message("table.cell_count", n=len(row), needed=width, row=quoted(dialect.separator.join(row)), hint=hint)


def _pairs_again(pair: Sequence[object]) -> tuple[Index, Index]:
    """An order of the rows in which equal pairs stand together, and where in it one stands again."""
    a, b = (np.asarray(p, np.int64) for p in pair)
    return _keys_again((a << 32) | b)


def _keys_again(key: Index) -> tuple[Index, Index]:
    if (key[1:] > key[:-1]).all():
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    in_order = np.sort(key)  # several times as quick as their order
    if (in_order[1:] > in_order[:-1]).all():
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    order = np.argsort(key, kind="stable")
    return order, np.flatnonzero(np.diff(key[order]) == 0)


def _check_pairs(path: Path, pair: Sequence[object], names: tuple[str, ...], first_row: int) -> None:
    """Raise where a pair of references stands twice."""
    _fail_again(path, *_pairs_again(pair), names, first_row)


def check_pair_keys(path: Path, key: Index, names: tuple[str, ...]) -> None:
    """Raise InputError where a pair stands twice, of which the first number stands in the upper half of its key."""
    _fail_again(path, *_keys_again(key), names, 0)


def _fail_again(path: Path, order: Index, again: Index, names: tuple[str, ...], first_row: int) -> None:
    if len(again) == 0:
        return
    problems: list[Problem] = []
    for k in sorted(again, key=lambda k: int(order[k + 1]))[: SHOWN + 1]:
        line, earlier = (first_row + int(order[j]) + 2 for j in (k + 1, k))
        number, rows = earlier_place(path, earlier)
        problems.append(Problem(line, names[-1], message("table.pair_twice", names=names, earlier=number, rows=rows)))
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


def header_of(path: Path) -> list[str]:
    """The names of the columns in a table's file, as they stand there."""
    if path.suffix == PARQUET:
        return names_of(path)
    with path.open("rb") as file:
        head = as_utf8(file.read(PIECE_BYTES), whole=False).decode("utf-8", errors="replace")
    return [h.strip().strip('"') for h in head.partition("\n")[0].split(",")]


def write_table(
    path: Path, columns: Mapping[str, Sequence[str] | Array], digits: Digits | Mapping[str, Digits]
) -> None:
    """Write a CSV or Parquet file: text as it is, numbers with their digits, NaN as an empty cell (null).

    path    NAME.csv or NAME.parquet
    digits  of each column of numbers, by its name; one rule for all: `EVERY` where the numbers must read back equal

    Cells are made for some rows at a time: as text they take ten times the memory of the numbers.
    """
    rows = {len(c) for c in columns.values()}
    if len(rows) > 1:
        raise ValueError(f"columns of {sorted(rows)} rows in {path.name}")
    rules = digits if isinstance(digits, Mapping) else dict.fromkeys(columns, digits)
    if without := [name for name, c in columns.items() if isinstance(c, np.ndarray) and name not in rules]:
        raise ValueError(f"how many digits {', '.join(without)} of {path.name} have is unknown")
    if path.suffix == PARQUET:
        write_parquet(path, columns, rules)
        return
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(columns) + "\n")
        for start in range(0, max(rows, default=0), WRITTEN_ROWS):
            piece = slice(start, start + WRITTEN_ROWS)
            file.write(rows_of([rounded(c, rules.get(name, EVERY), piece) for name, c in columns.items()]))


WRITTEN_ROWS = 1 << 13
"""Rows whose cells are made at a time: some 10 MB of text in a table of twenty columns."""


def times_in_order(table: Table, file: Path) -> Array:
    """The column time_s; raises InputError where a time does not follow the one before."""
    time = table.number["time_s"]
    late = np.flatnonzero(np.diff(time) <= 0)
    if len(late):
        k = int(late[0])
        raise InputError(
            "table.time_order", time_s=time[k + 1], before_s=time[k], file=file, line=table.first_line + k + 1,
            column="time_s",
        )  # fmt: skip
    return time
