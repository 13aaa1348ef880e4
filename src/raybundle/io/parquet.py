"""Tables as Parquet files, written and read by groups of rows, with the checks of CSV tables (`raybundle.io.tables`).

pyarrow reads and writes them; it is an extra, and loaded where a table is one.  What a file may unfold to in memory is
bounded before anything is decoded.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from raybundle.errors import InputError
from raybundle.io.cells import Column, Problem, converted, fail, numbers_good, texts_good
from raybundle.io.digits import EVERY, Digits, exact, rounded
from raybundle.io.reading import words
from raybundle.io.reading.files import opened
from raybundle.io.reading.parquet_pages import BadPage, Chunk, pages, row_groups
from raybundle.io.table_files import Named, TableFormat
from raybundle.numerics.arrays import Array, Index

GROUP_ROWS = 1 << 17
"""Rows that are written, and later read, at a time: some 20 MB in a table of twenty columns."""
MOST_GROUP_ROWS, MOST_GROUP_BYTES = 1 << 22, 1 << 29
"""Of a group of rows that is read: four times what pandas writes by default, and sixteen columns of that."""
MOST_FOOTER_BYTES = 1 << 26
"""Of the list of all groups and columns: that of 10^9 rows in twenty columns has a third of it."""
ROWS_OF_A_BYTE = 8
"""Rows that differ from each other take a bit each; measured ones take a hundred."""
UNFOLDING = {7: "DELTA_BYTE_ARRAY"}
"""Encodings that repeat a text of any length in a few bits."""
REPEATED = 4
"""A column of numbers is written by the different ones where they are less than this part of the rows."""
SAMPLE = 1 << 12


def arrow() -> Any:
    """Module pyarrow with its Parquet part; raises InputError where it is not installed."""
    try:
        import_module("pyarrow.parquet")  # an extra, and 50 MB
        return import_module("pyarrow")
    except ImportError:
        raise InputError("package.pyarrow_missing") from None


def check_tables(tables: TableFormat) -> None:
    """Raise InputError where tables cannot be written as asked for, before something is computed for them."""
    if tables == "parquet":
        arrow()


def write_parquet(path: Path, columns: Mapping[str, Sequence[str] | Array], rules: Mapping[str, Digits]) -> None:
    """Write a Parquet file: text as it is, numbers as float64 with their digits; NaN and empty texts as null.

    rules  digits of the columns of numbers, as of `write_table`

    Groups of rows are made one after the other, so that beside the columns themselves little memory is needed.
    """
    pa = arrow()
    rows = max(map(len, columns.values()), default=0)
    numbers = [name for name, c in columns.items() if isinstance(c, np.ndarray)]
    coded = [name for name, c in columns.items() if not isinstance(c, np.ndarray) or _repeats(c)]
    schema = pa.schema([(name, pa.float64() if name in numbers else pa.string()) for name in columns])
    with pa.parquet.ParquetWriter(
        str(path), schema, compression="zstd", use_dictionary=coded, dictionary_pagesize_limit=1 << 24,
        column_encoding={name: "BYTE_STREAM_SPLIT" for name in numbers if name not in coded},
        write_page_checksum=True, store_schema=False,
    ) as file:  # fmt: skip
        for start in range(0, rows, GROUP_ROWS):
            piece = slice(start, start + GROUP_ROWS)
            made = [_cells(pa, c, rules.get(name, EVERY), piece) for name, c in columns.items()]
            file.write_batch(pa.record_batch(made, schema=schema), row_group_size=GROUP_ROWS)


def _repeats(values: Array) -> bool:
    first = np.asarray(values[:SAMPLE], float)
    return len(np.unique(first)) * REPEATED <= len(first)


def _cells(pa: Any, values: Sequence[str] | Array, digits: Digits, rows: slice) -> Any:
    """Rows of a column as Arrow has them."""
    if isinstance(values, Named):
        here, codes = np.unique(values.at[rows], return_inverse=True)
        ids = pa.array([values.ids[k] for k in here.tolist()], pa.string())
        return ids.take(pa.array(codes.reshape(-1)))
    part = rounded(values, digits, rows)
    if isinstance(part, np.ndarray):
        return pa.array(np.ascontiguousarray(part), pa.float64(), from_pandas=True)  # NaN as null
    return pa.array([text or None for text in part], pa.string())


@dataclass(frozen=True, slots=True)
class Group:
    """Rows of a table: what stands in each of its columns, as `raybundle.io.cells.converted` gives it."""

    rows: int
    columns: tuple[Column, ...]
    parts: tuple[object, ...]


def groups(path: Path, present_in: Callable[[Sequence[str]], list[Column]]) -> Iterator[Group]:
    """The table in a Parquet file, a group of rows at a time, each checked.

    present_in  the columns by the names of the file; raises InputError where one is unknown or missing
    raises      InputError with file, row, column, the offending text and what to do
    """
    with _opened(path) as (pa, raw, file):
        schema = file.schema_arrow
        present = present_in(schema.names)
        for column in present:
            _check_kind(pa, path, column, schema.field(column.name).type)
        seen: list[dict[str, int]] = [{} for _ in present]
        row, whole = 0, row_groups(_footer(raw))
        if len(whole) != file.num_row_groups:
            raise InputError("parquet.damaged", file=path)
        if not file.num_row_groups:
            none = {"number": np.zeros(0), "id": (), "text": ()}
            yield Group(0, tuple(present), tuple(none.get(c.kind, np.zeros(0, np.int32)) for c in present))
        for k in range(file.num_row_groups):
            rows, chunks = whole[k]
            _check_group(path, raw, rows, chunks)
            read = file.read_row_group(k, [c.name for c in present], use_threads=False)
            if read.num_rows != rows:
                raise InputError("parquet.column_lengths", file=path)
            problems: list[Problem] = []
            parts = tuple(_part(path, pa, read.column(j), c, seen[j], problems, row + 2) for j, c in enumerate(present))
            if problems:
                fail(path, problems)
            yield Group(read.num_rows, tuple(present), parts)
            row += read.num_rows


def rows_in(path: Path) -> int:
    """How many rows the file states that it holds; raises InputError for what is no such file."""
    with _opened(path) as (_, _, file):
        return int(file.metadata.num_rows)


def names_of(path: Path) -> list[str]:
    """The names of the columns of a Parquet file; raises InputError where it is none."""
    with _opened(path) as (_, _, file):
        return list(file.schema_arrow.names)


@contextmanager
def _opened(path: Path) -> Generator[tuple[Any, BinaryIO, Any]]:
    """pyarrow, the file as bytes, and as Parquet file; what is wrong with it becomes an InputError that names it."""
    pa = arrow()
    with opened(path) as raw:
        size = os.fstat(raw.fileno()).st_size
        _check_footer(path, raw, size)
        try:
            schema = pa.parquet.read_schema(raw, memory_map=False)
            texts = [f.name for f in schema if pa.types.is_string(f.type) or pa.types.is_large_string(f.type)]
            file = pa.parquet.ParquetFile(
                raw, read_dictionary=texts, pre_buffer=False, page_checksum_verification=True
            )  # fmt: skip
            if file.metadata.num_rows > ROWS_OF_A_BYTE * size:
                raise InputError("parquet.too_many_rows", n=file.metadata.num_rows, size_bytes=size, file=path)
            yield pa, raw, file
        except BadPage:
            raise InputError("parquet.damaged", file=path) from None
        except (pa.ArrowException, OSError, UnicodeDecodeError) as error:
            detail = str(error).strip().split("\n")[0][:120]
            raise InputError("parquet.not_readable", detail=detail, file=path) from None
        except MemoryError:
            raise InputError("file.memory", file=path) from None


def _check_footer(path: Path, raw: BinaryIO, size: int) -> None:
    """Raise where the list of what is in the file cannot be there, or would be larger than any table's."""
    raw.seek(max(size - 8, 0))
    end = raw.read(8)
    if size < 12 or end[4:] != b"PAR1":
        raise InputError("parquet.no_footer", file=path)
    length = int.from_bytes(end[:4], "little")
    if length > min(MOST_FOOTER_BYTES, size - 12):
        raise InputError("parquet.footer_too_large", footer_bytes=length, size_bytes=size, file=path)
    raw.seek(0)


def _check_kind(pa: Any, path: Path, column: Column, kind: Any) -> None:
    """Raise where a column does not hold what can become numbers, or texts."""
    t = pa.types
    kind = kind.value_type if t.is_dictionary(kind) and column.kind != "number" else kind
    whole, text = t.is_integer(kind) or t.is_null(kind), t.is_string(kind) or t.is_large_string(kind)
    if not (whole or (t.is_floating(kind) if column.kind == "number" else text)):
        raise InputError(
            "parquet.column_type", type=str(kind)[:40], numbers=column.kind == "number", file=path, column=column.name
        )


def _footer(raw: BinaryIO) -> bytes:
    """The list of what is in the file: pyarrow's view of it ends the process where sizes contradict each other."""
    size = os.fstat(raw.fileno()).st_size
    raw.seek(size - 8)
    length = int.from_bytes(raw.read(4), "little")
    raw.seek(size - 8 - length)
    return raw.read(length)


def _check_group(path: Path, raw: BinaryIO, rows: int, chunks: Sequence[Chunk]) -> None:
    """Raise where a group of rows would unfold to more than a table's does, or to more than it states."""
    unpacked = 0
    for chunk in chunks:
        for page in pages(raw, chunk.begin, chunk.length):
            unpacked += page.unpacked
            if page.encoding in UNFOLDING:
                encoding = UNFOLDING[page.encoding]
                raise InputError("parquet.encoding", encoding=encoding, file=path, column=chunk.name)
    if rows > MOST_GROUP_ROWS or unpacked > MOST_GROUP_BYTES:
        raise InputError(
            "parquet.group_too_large", n=rows, most=MOST_GROUP_ROWS, size_bytes=unpacked, limit_bytes=MOST_GROUP_BYTES,
            file=path,
        )  # fmt: skip


def _part(
    path: Path, pa: Any, values: Any, column: Column, seen: dict[str, int], problems: list[Problem], first_line: int
) -> object:
    """What a column of a group must hold, or problems."""
    if column.kind == "number":
        numbers = _numbers(pa, values)
        empty = np.isnan(numbers)
        bounded = words.bounded(numbers.copy())
        if bounded is not None and numbers_good(column, bounded):
            return bounded
        cells = ["" if e else exact(v) for v, e in zip(numbers.tolist(), empty.tolist(), strict=True)]
        return converted(column, cells, first_line, seen, problems)
    codes, different = _texts(pa, values)
    if column.kind in {"id", "text"} or not texts_good(column, different, len(codes)):
        cells = list(map(different.__getitem__, codes.tolist()))
        return converted(column, cells, first_line, seen, problems, path=path)
    if column.kind == "new_reference":
        _add_new(column.known, codes, different)
    return np.fromiter(map(column.known.__getitem__, different), np.int32, len(different))[codes]


def _add_new(known: dict[str, int], codes: Index, different: Sequence[str]) -> None:
    """Give texts that are not known yet the next numbers, in the order in which they appear."""
    new = [k for k, text in enumerate(different) if text not in known]
    if new:
        first = np.empty(len(different), np.int64)
        first[codes[::-1]] = np.arange(len(codes))[::-1]  # of equal ones the last assignment stays
        for k in sorted(new, key=lambda k: int(first[k])):
            known.setdefault(different[k], len(known))


def _numbers(pa: Any, values: Any) -> Array:
    """(n,) as float64; NaN for null."""
    return np.array(values.cast(pa.float64()).to_numpy(zero_copy_only=False), float)


def _texts(pa: Any, values: Any) -> tuple[Index, list[str]]:
    """(n,) positions among the different texts, and these; null is an empty text."""
    if pa.types.is_integer(values.type) or pa.types.is_null(values.type):
        values = values.cast(pa.string())
    values = values.combine_chunks()
    if not pa.types.is_dictionary(values.type):
        values = values.dictionary_encode()
    if isinstance(values, pa.ChunkedArray):
        values = values.unify_dictionaries().combine_chunks()
    if isinstance(values, pa.ChunkedArray):  # of no rows
        values = values.chunk(0) if values.num_chunks else pa.array([], pa.string()).dictionary_encode()
    different = [text or "" for text in values.dictionary.to_pylist()]
    codes = values.indices.fill_null(len(different)).to_numpy(zero_copy_only=False)
    different.append("")
    if len(codes) and not 0 <= codes.min() <= codes.max() < len(different):
        raise BadPage("a row refers to a text that its dictionary does not have")
    used = np.flatnonzero(np.bincount(codes, minlength=len(different)))
    if len(used) == len(different):
        return codes, different
    place = np.zeros(len(different), np.int32)
    place[used] = np.arange(len(used))
    return place[codes], [different[k] for k in used.tolist()]
