"""Control coordinates dropped on the page: the table is read as `control` of orient reads it, each row is an action."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from raybundle.errors import InputError
from raybundle.io.geo.control_files import read_control
from raybundle.measuring.actions import Numbers3, Point


def control_actions(text: str) -> tuple[list[Point], tuple[str, ...]]:
    """Points of a table point,X,Y,Z[,sX,sY,sZ], and what was assumed; raises InputError that names line and column."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / "dropped.csv"
        file.write_text(text, encoding="utf-8")
        try:
            read = read_control(file)
        except InputError as error:
            raise InputError(str(error).replace(f"{folder}/", "")) from None
    found: list[Point] = []
    for k, name in enumerate(read.ids):
        xyz = [None if not np.isfinite(v) else float(v) for v in read.xyz[k]]
        if all(v is None for v in xyz):
            continue
        sigma = [None if v is None else float(s) for v, s in zip(xyz, read.sigma[k], strict=True)]
        found.append(Point(point=name, role="control", xyz=_three(xyz), sigma=_three(sigma)))
    if not found:
        raise InputError("no row has a coordinate; a table has a head line point,X,Y,Z and may have sX,sY,sZ")
    return found, read.remarks


def _three(values: list[float | None]) -> Numbers3:
    a, b, c = values
    return a, b, c
