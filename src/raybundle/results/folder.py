"""Result folders: written whole or not at all, and read again."""

from __future__ import annotations

import json
from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast

import numpy as np

from raybundle.adjustment.readjust import block_again
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.block.folder import block_files, read_block, write_block_files
from raybundle.io.digits import reported
from raybundle.io.folders import check_place, names_in, new_folder
from raybundle.io.ids import check_ids_of
from raybundle.io.reading.trees import read_json
from raybundle.io.reading.words import quoted
from raybundle.io.table_files import SUFFIXES, Named, TableFormat, new_table_file, table_file
from raybundle.io.tables import Column, Table, read_table, write_table
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.readable import readable, without_controls
from raybundle.results.contents import clean, result_json
from raybundle.results.digits import result_digits
from raybundle.results.tables import ALWAYS, DATE, DATED, LATER, P_WRONG, TABLES, result_table

PROJECT = "project"
"""Folder in a result folder where `raybundle calibrate` keeps what is finished"""
MAP, MAP_CONTROL = "map.csv", "map_control.csv"
"""The tables of adjusted coordinates in the system of the control, and of its control and check points"""
ENTRIES = {
    "block",
    "result.json",
    "report.html",
    "report.pdf",
    "network.html",
    MAP,
    MAP_CONTROL,
    "calibration.toml",
    "record.toml",
    "coordinate_list.csv",
    "nominal.csv",
    "lengths.csv",
    "README.txt",
    "displacements.csv",
    "velocities.csv",
    "surface_strain.csv",
    "epochs.json",
    "animation.gif",
}
"""Of a result folder beside its tables"""
EXACT = {"frame", "calibration"}
"""Keys of result.json beside those of the adjustment that later commands compute with"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ResultFolder:
    """A result folder as it was read: `table.text["point"]`, `table.number["sX"]` (NaN where empty)."""

    path: Path
    result: Mapping[str, Any]
    """result.json: sigma0, redundancy, cameras, correlations, warnings ...; see the reference of the format."""
    block: Block
    """RESULT/block: the adjusted values."""
    images: Table
    """text image, camera, file; number X ... kappa_deg, sX ... skappa_deg, p_wrong"""
    points: Table
    """text point, role; number X, Y, Z, sX, sY, sZ, rays, window, roughness, rXY, rXZ, rYZ"""
    observations: Table
    """text image, point, rejected; number x_px ... mdby_px"""
    control: Table
    check: Table
    distances: Table
    stations: Table
    attitudes: Table | None
    """None where there are none."""
    others: Mapping[str, Table] = field(default_factory=dict[str, Table])
    """Tables of further kinds of observations, by their names: "planes" ..."""


def check_target(path: str | Path) -> None:
    """Raise InputError where a result must not be written: over anything but a result folder."""
    folder = Path(path)
    check_place(folder)
    if not folder.exists():
        return
    if not folder.is_dir():
        raise InputError("result.not_a_folder", file=folder)
    present = names_in(folder)
    if (folder / PROJECT / "project.db").is_file():
        present -= {PROJECT}  # of a run that is to be continued, or of one that ended
    if not present:
        return
    if "result.json" not in present or not _is_ours(folder / "result.json"):
        raise InputError("result.other_folder", file=folder)
    inner = names_in(folder / "block") if (folder / "block").is_dir() else set[str]()
    tables = {f"{name}{suffix}" for name in TABLES for suffix in SUFFIXES}
    foreign = sorted(present - ENTRIES - tables) + sorted(f"block/{name}" for name in inner - block_files())
    if foreign:
        raise InputError(
            "result.foreign_files",
            names=foreign,
            n=len(foreign),
            file=folder,
        )


def _is_ours(path: Path) -> bool:
    try:
        content = read_json(path).value
    except InputError:
        return False
    return isinstance(content, dict) and {"sigma0", "redundancy", "cameras"} <= cast("dict[str, Any]", content).keys()


@contextmanager
def written_folder(
    adjustment: Adjustment, path: str | Path, additions: Mapping[str, object] | None = None,
    progress: Progress = silent, tables: TableFormat = "auto",
) -> Generator[Path]:  # fmt: skip
    """A new result folder with its tables, block and result.json; what is put in it before the end stands beside them.

    adjustment  what is written
    path        where; an older result there is replaced when the new one is complete
    additions   further keys of result.json
    tables      how tables are written, as of `write_block`
    raises      InputError where something else stands at `path`, or an id is empty or there twice
    """
    check_target(path)
    check_ids_of(adjustment.adjusted, Path(path))
    with new_folder(Path(path), replacing=True) as folder:
        progress("writing tables", 0.0)
        (folder / "block").mkdir()
        write_block_files(block_again(adjustment), folder / "block", tables)
        progress("writing tables", 0.2)
        for name in TABLES:  # one after the other: those of the image observations are large
            columns = {n: _readable(v) for n, v in result_table(adjustment, name).items()}
            rows = max(map(len, columns.values()))
            if not rows and name not in ALWAYS:
                continue
            file = new_table_file(folder, name, rows, tables)
            write_table(file, columns, result_digits(adjustment, name, columns))
        added = {k: v if k in EXACT else reported(v) for k, v in (additions or {}).items()}
        contents = {**result_json(adjustment), **added}
        text = json.dumps(_written(clean(contents)), indent=1, ensure_ascii=False, allow_nan=False)
        (folder / "result.json").write_text(text + "\n", encoding="utf-8")
        progress("writing tables", 1.0)
        yield folder
        if (Path(path) / PROJECT / "project.db").is_file():  # stays for the next run
            (Path(path) / PROJECT).rename(folder / PROJECT)


def _readable(column: Sequence[str] | Array) -> Sequence[str] | Array:
    """A column whose names are those of the block that stands beside it."""
    if isinstance(column, np.ndarray):
        return column
    if isinstance(column, Named):
        return Named(tuple(map(readable, column.ids)), column.at)
    new = {name: readable(name) for name in set(column)}
    return tuple(map(new.__getitem__, column))


def _written(value: Any) -> Any:
    """The contents of result.json, in which names are written as in the tables."""
    if isinstance(value, dict):
        return {_written(k): _written(v) for k, v in cast("dict[str, Any]", value).items()}
    if isinstance(value, list | tuple):
        return [_written(v) for v in cast("list[Any]", value)]
    return without_controls(value) if isinstance(value, str) else value


def columns_of_table(name: str) -> tuple[Column, ...]:
    """What the columns of one table of a result folder hold."""
    first, numbers, last = TABLES[name]
    return (
        *(Column(name=n, kind="text", empty=True) for n in first),
        *(Column(name=n, kind="number", empty=True, optional=n in LATER) for n in numbers),
        *(Column(name=n, kind="text", empty=True) for n in last),
        *(Column(name=DATE, kind="text", empty=True, optional=True) for _ in range(name in DATED)),
        *(Column(name=P_WRONG, kind="number", empty=True, optional=True) for _ in range(name == "images")),
    )


def read_result(path: str | Path) -> ResultFolder:
    """Tables and result.json of a result folder, or of the current result of a project; raises InputError."""
    folder = Path(path)
    if (folder / "project.db").is_file():
        folder /= "result"
    if not (folder / "result.json").is_file():
        raise InputError("result.no_result", file=folder)
    if not _is_ours(folder / "result.json"):
        raise InputError("result.not_of_adjustment", file=folder / "result.json")
    result = cast("dict[str, Any]", read_json(folder / "result.json").value)
    block = read_block(folder / "block")
    known = {"image": frozenset(block.images.ids), "point": frozenset(block.points.ids)}
    tables: dict[str, Table] = {}
    for name in TABLES:
        file = table_file(folder, name)
        if name not in ALWAYS and not file.is_file():
            continue
        tables[name] = read_table(file, columns_of_table(name), least_rows=0, own=True)
        for column, ids in known.items():
            _check_ids(file, column, tables[name].text.get(column, ()), ids)
    return ResultFolder(
        path=folder,
        result=result,
        block=block,
        images=tables["images"],
        points=tables["points"],
        observations=tables["observations"],
        control=tables["control"],
        check=tables["check"],
        distances=tables["distances"],
        stations=tables["stations"],
        attitudes=tables.get("attitudes"),
        others={name: tables[name] for name in tables if name not in {*ALWAYS, "attitudes"}},
    )


def _check_ids(path: Path, column: str, ids: Sequence[str], known: frozenset[str]) -> None:
    """Raise where a table names what the block beside it does not hold."""
    for row, id_ in enumerate(ids):
        if id_ not in known:
            raise InputError(
                "result.unknown_id",
                id=quoted(id_),
                table=f"block/{column}s.csv",
                file=path,
                line=row + 2,
                column=column,
            )
