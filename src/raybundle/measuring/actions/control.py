"""A table of control as one action: the rows that were read, and what is checked of each."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import ClassVar

import numpy as np

from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.geo.control_files import read_control
from raybundle.io.reading.dialects import table_text
from raybundle.measuring.actions.base import Action
from raybundle.measuring.actions.checks import check_given, check_name
from raybundle.measuring.names import Known
from raybundle.measuring.state import Draft, MeasuredPoint, Numbers3, RoleName, State


@dataclass(frozen=True, slots=True, kw_only=True)
class Given:
    """A row of the table: a point with its role and what is known of its coordinates."""

    point: str
    role: RoleName
    xyz: Numbers3
    """[length unit of the block]; None: not known"""
    sigma: Numbers3
    """0: held"""


@dataclass(frozen=True, slots=True, kw_only=True)
class GiveControl(Action):
    """Roles and coordinates of all points of a table: one action, which holds the rows."""

    verb: ClassVar[str] = "control"
    file: str
    """the table, as it was called; it is not read again"""
    points: tuple[Given, ...]

    def settled(self, state: State, known: Known) -> Action:
        del state, known
        check_name("table", self.file)
        if not self.points:
            raise InputError("control_table.no_coordinates", table=self.file)
        names = [p.point for p in self.points]
        twice = next((n for n in names if names.count(n) > 1), None) if len(set(names)) < len(names) else None
        if twice is not None:
            raise InputError("control_table.point_twice", table=self.file, point=twice)
        for p in self.points:
            check_given(p.point, p.role, p.xyz, p.sigma)
        return self

    def apply(self, draft: Draft) -> None:
        for p in self.points:
            draft.points[p.point] = MeasuredPoint(role=p.role, xyz=p.xyz, sigma=p.sigma, reported=True)


def control_of(path: str | Path) -> tuple[GiveControl, tuple[str, ...]]:
    """The action that a table point,X,Y,Z[,sX,sY,sZ][,role] makes, and what was assumed; see `control_of_text`."""
    return control_of_text(table_text(Path(path)), str(path))


def control_of_text(text: str, file: str) -> tuple[GiveControl, tuple[str, ...]]:
    """The same of a table's text; points are control unless their row states otherwise.

    file    what the table is called
    raises  InputError that names line and column
    """
    with TemporaryDirectory() as folder:
        table = Path(folder) / "table.csv"
        table.write_text(text, encoding="utf-8")
        try:
            read = read_control(table)
        except InputError as error:
            if error.message is None:
                raise InputError(error.text().replace(str(table), file)) from None
            raise InputError(error.message, file=file, line=error.line, column=error.column) from None
        except csv.Error as error:
            raise InputError("control_table.not_readable", table=file, detail=str(error)) from None
    found: list[Given] = []
    for k, name in enumerate(read.ids):
        xyz = [None if not np.isfinite(v) else float(v) for v in read.xyz[k]]
        if all(v is None for v in xyz):
            continue
        sigma = [None if v is None else float(s) for v, s in zip(xyz, read.sigma[k], strict=True)]
        role: RoleName = "check" if read.role[k] == Role.CHECK else "control"
        found.append(Given(point=name, role=role, xyz=_three(xyz), sigma=_three(sigma)))
    if not found:
        raise InputError("control_table.no_coordinates", table=file)
    return GiveControl(file=file, points=tuple(found)), read.remarks


def _three(values: list[float | None]) -> Numbers3:
    a, b, c = values
    return a, b, c
