"""The tables of a result in Python: the same columns as the files of a result folder."""

from __future__ import annotations

from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from raybundle.adjustment.records.arrays import as_table
from raybundle.adjustment.result import Adjustment
from raybundle.errors import InputError
from raybundle.results.tables import result_tables


@overload
def table(result: Adjustment, name: str, to: Literal["numpy"] = "numpy") -> NDArray[np.void]: ...
@overload
def table(result: Adjustment, name: str, to: Literal["pandas", "polars"]) -> Any: ...
def table(result: Adjustment, name: str, to: Literal["numpy", "pandas", "polars"] = "numpy") -> Any:
    """One table of a result, with the columns and units of NAME.csv in a result folder.

    name     points, images, observations, control, check, distances ...: what the result has, see `table_names`
    to       numpy: a structured array; pandas, polars: a data frame, where that library is installed
    raises   InputError for a table that the result has not, or a library that is not installed
    """
    every = result_tables(result)
    if name not in every:
        raise InputError("report.no_table", name=name, known=list(every))
    columns = every[name]
    return as_table(columns, to)


def table_names(result: Adjustment) -> tuple[str, ...]:
    """Names of the tables that a result has."""
    return tuple(result_tables(result))
