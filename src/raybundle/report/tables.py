"""The tables of a result in Python: the same columns as the files of a result folder."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

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
    if to == "numpy":
        return _structured(columns)
    if to not in ("pandas", "polars"):
        raise InputError("value.not_one_of", entry="to", given=str(to), known=["numpy", "pandas", "polars"])
    try:
        library: Any = import_module(to)
    except ImportError:
        raise InputError("package.tables_missing", package=to) from None
    return library.DataFrame({key: _plain(values) for key, values in columns.items()})


def table_names(result: Adjustment) -> tuple[str, ...]:
    """Names of the tables that a result has."""
    return tuple(result_tables(result))


def _plain(values: Any) -> Any:
    return values if isinstance(values, np.ndarray) else list(values)


def _structured(columns: Mapping[str, Sequence[str] | Any]) -> Any:
    arrays = {key: np.asarray(values) for key, values in columns.items()}
    made = np.empty(len(next(iter(arrays.values()))), [(key, a.dtype, a.shape[1:]) for key, a in arrays.items()])
    for key, values in arrays.items():
        made[key] = values
    return made
