"""Files of tables: a table NAME stands in a folder as NAME.csv or as NAME.parquet."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Literal, overload

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.files import stands
from raybundle.numerics.arrays import Index

TableFormat = Literal["auto", "csv", "parquet"]
"""auto: CSV for what a spreadsheet can hold, Parquet beyond, where pyarrow is installed"""
SHEET_ROWS = (1 << 20) - 1
"""Rows below the header that a sheet of Excel, Calc or Numbers holds: a longer CSV file no spreadsheet opens whole."""
SUFFIXES = (".csv", ".parquet")


def table_file(folder: Path, name: str) -> Path:
    """The file in which a table stands; NAME.csv where it stands in none.

    raises  InputError where both are there: nothing states which of them is meant
    """
    csv, parquet = (folder / f"{name}{suffix}" for suffix in SUFFIXES)
    if not stands(parquet):
        return csv
    if stands(csv):
        raise InputError("table.csv_and_parquet", csv=csv.name, file=parquet)
    return parquet


def new_table_file(folder: Path, name: str, rows: int, tables: TableFormat) -> Path:
    """The file into which a table of so many rows is written; a table without rows is a header, as text."""
    large = tables == "auto" and rows > SHEET_ROWS and find_spec("pyarrow") is not None
    return folder / f"{name}{'.parquet' if rows and (tables == 'parquet' or large) else '.csv'}"


class Named(Sequence[str]):
    """A column of ids: those of other tables' rows, without a list of as many texts."""

    __slots__ = ("at", "ids")

    def __init__(self, ids: Sequence[str], index: Index) -> None:
        self.ids, self.at = ids, np.asarray(index)

    def __len__(self) -> int:
        return len(self.at)

    @overload
    def __getitem__(self, rows: int) -> str: ...
    @overload
    def __getitem__(self, rows: slice) -> list[str]: ...
    def __getitem__(self, rows: int | slice) -> str | list[str]:
        """One id, or those of a slice."""
        if isinstance(rows, slice):
            return list(map(self.ids.__getitem__, self.at[rows].tolist()))
        return self.ids[int(self.at[rows])]
