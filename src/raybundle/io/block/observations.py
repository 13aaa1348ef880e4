"""Tables of observations outside the images in a block folder, as `raybundle.observations` declares them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.block import Block, Instrument
from raybundle.errors import InputError, message
from raybundle.io.block.tables import columns_of, named, problems_of, require
from raybundle.io.digits import EVERY
from raybundle.io.reading.files import stands
from raybundle.io.reading.words import quoted
from raybundle.io.table_files import TableFormat, new_table_file, table_file
from raybundle.io.tables import Column, Problem, header_of, read_table, write_table
from raybundle.io.tables import Table as Read
from raybundle.numerics.arrays import Array
from raybundle.observations import tables
from raybundle.observations.table import Cells, Table

Instruments = tuple[Instrument, ...]


def read_observation_tables(
    folder: Path, images: dict[str, int], points: dict[str, int], instruments: Instruments
) -> dict[str, Table]:
    """The tables that stand in a block folder, by their names.

    images, points  ids and their positions
    raises          InputError with file, line and column for what a table does not allow
    """
    paths = {name: table_file(folder, name) for name in tables}
    known: Mapping[str, dict[str, int]] = {"image": images, "point": points}
    return {
        name: _read(paths[name], table, known, instruments) for name, table in tables.items() if stands(paths[name])
    }


def _read(path: Path, table: type[Table], known: Mapping[str, dict[str, int]], instruments: Instruments) -> Table:
    where = {"image": "images.csv", "point": "points.csv"}
    gon = _in_gon(path, table)
    columns = [
        Column(name=name, kind="reference", known=known[c.of], where=where[c.of], optional=c.optional)
        if c.of in known
        else Column(
            name=gon.get(name, name),
            kind="number" if c.of == "number" else "text",
            empty=c.empty,
            optional=c.optional,
            limit=c.limit,
        )
        for _, c in table.cells()
        for name in c.names
    ]
    read = read_table(path, columns, own=True)
    read = replace(read, number={**read.number, **{deg: 0.9 * read.number[name] for deg, name in gon.items()}})
    problems = list[Problem]()
    made = table(**{field: _field(path, c, read, instruments, problems) for field, c in table.cells()})
    require(path, *(problems_of(w.rows, w.column, w.why) for w in made.faults()), problems)
    return made


def _in_gon(path: Path, table: type[Table]) -> dict[str, str]:
    """Columns of angles in degrees for which the file has those in gon: NAME_gon in place of NAME_deg."""
    angles = [name for _, c in table.cells() if c.unit == "deg" for name in c.names]
    if not angles:
        return {}
    header = header_of(path)
    both = {name: name.removesuffix("_deg") + "_gon" for name in angles}
    return {name: gon for name, gon in both.items() if name not in header and gon in header}


def _field(path: Path, c: Cells, read: Read, instruments: Instruments, problems: list[Problem]) -> Any:
    """A field of a table as it was read; None where its columns are lacking."""
    first = c.names[0]
    if c.of in {"image", "point"}:
        return read.index.get(first)
    if c.of == "text":
        return read.text.get(first)
    if c.of == "instrument":
        names = read.text.get(first, ())
        if not any(names):
            return None
        at = {i.id: k for k, i in enumerate(instruments) if i.model == c.model}
        strange = np.array([bool(n) and n not in at for n in names], bool)
        problems += problems_of(
            strange, first, lambda k: message("cell.unknown_id", id=quoted(names[k]), table="block.toml")
        )
        return np.array([at.get(n, -1) for n in names], np.int32)
    there = [n for n in c.names if n in read.number]
    if not there:
        return None
    if len(there) < len(c.names):
        lacking = [n for n in c.names if n not in there]
        raise InputError("table.columns_together", names=there, missing=lacking, file=path, line=1)
    values = read.numbers(*c.names)
    if np.isfinite(c.fill):
        values = np.where(np.isnan(values), c.fill, values)
    values = np.radians(values) if c.unit == "deg" else values
    return values if len(c.names) > 1 else values[:, 0]


def write_observation_tables(folder: Path, block: Block, format_: TableFormat) -> None:
    """Write each table that has rows."""
    for table in block.tables.values():
        if len(table):
            write_table(new_table_file(folder, table.name, len(table), format_), table_columns(table, block), EVERY)


def table_columns(table: Table, block: Block) -> dict[str, Sequence[str] | Array]:
    """The columns of a table as they stand in a file, with the names of the block's points, images and instruments."""
    columns: dict[str, Sequence[str] | Array] = {}
    for field, c in table.cells():
        values = getattr(table, field)
        if values is not None:
            columns |= _columns(c, values, block)
    return columns


def _columns(c: Cells, values: Any, block: Block) -> Mapping[str, Sequence[str] | Array]:
    if c.of == "text":
        return {c.names[0]: values}
    if c.of != "number":
        instruments = [i.id for i in block.instruments]
        ids = {"image": block.images.ids, "point": block.points.ids, "instrument": instruments}[c.of]
        return {c.names[0]: [ids[k] if k >= 0 else "" for k in values.tolist()] if c.empty else named(ids, values)}
    shown = values.reshape(len(values), len(c.names))
    if c.unit == "deg":
        shown = np.degrees(shown) if c.limit else np.round(np.degrees(shown), 12) + 0.0  # no -0
    return columns_of(c.names, shown)
