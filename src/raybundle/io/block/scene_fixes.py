"""Orientation fixes of a line scene in block.toml: at equal distances, at given times, or as a file shows.

attitude_fixes = 5                        at equal distances, from the first line to the last
attitude_fixes = [300.0, 302.5, 309.1]    at these times [s] of the clock of the scene's trajectory
attitude_fixes = "table"                  at the times of the trajectory's own table of attitudes
attitude_fixes = "fixes.csv"              time_s; if known the corrections there, rx_rad ry_rad rz_rad (of positions
                                          along_m across_m up_m), and their standard deviations srx_rad ... salong_m
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, cast

import numpy as np

from raybundle.errors import InputError
from raybundle.io.block.toml_section import Section
from raybundle.io.tables import Column, read_table, times_in_order
from raybundle.numerics.arrays import Array
from raybundle.scenes.corrections import Curve, Fixes
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.trajectory import AXES

Part = Literal["position", "attitude"]
UNIT = {"position": "m", "attitude": "rad"}
TABLE = "table"


@dataclass(frozen=True, slots=True, kw_only=True)
class GivenFixes:
    """Fixes, and what a file states of the corrections there."""

    curve: Curve
    values: dict[str, float] = field(default_factory=dict[str, float])
    """rx_1 -> correction"""
    sigma: dict[str, float] = field(default_factory=dict[str, float])


def read_fixes(section: Section, key: str, line: LineScene) -> GivenFixes:
    """The fixes of a key position_fixes or attitude_fixes; raises InputError with file and line."""
    part = cast("Part", key.removesuffix("_fixes"))
    value = section.values[key]
    try:
        if value == TABLE:
            return GivenFixes(curve=line.fixes_of_table(part))
        if isinstance(value, str):
            return _of_file(section.file.parent / value, part, line)
        if isinstance(value, list):
            times = np.array([section.checked(key, v) for v in cast("list[Any]", value)])
            return GivenFixes(curve=line.fixes_at(times))
        return GivenFixes(curve=Fixes(count=section.whole(key)))
    except InputError as error:
        if error.file is not None:
            raise
        section.fail(key, error.message or str(error))


def _of_file(file: Path, part: Part, line: LineScene) -> GivenFixes:
    names = [f"{a}_{UNIT[part]}" for a in AXES[part]]
    columns = [Column(name="time_s", kind="number")]
    columns += [Column(name=n, kind="number", optional=True, empty=True) for n in names]
    columns += [Column(name=f"s{n}", kind="number", optional=True, empty=True, limit="> 0") for n in names]
    table = read_table(file, columns, least_rows=2, own=True)
    times = times_in_order(table, file)
    try:
        curve = line.fixes_at(times)
    except InputError as error:
        raise error.at(file) from None
    # where lines are scanned backwards in time, the first fix is the last of the file
    order = np.arange(len(times)) if line.middle_and_half[1] > 0 else np.arange(len(times))[::-1]
    return GivenFixes(
        curve=curve, values=_known(table.number, part, order, ""), sigma=_known(table.number, part, order, "s")
    )


def _known(numbers: Mapping[str, Array], part: Part, order: Array, before: str) -> dict[str, float]:
    """Parameter -> number, for the cells that are not empty."""
    found: dict[str, float] = {}
    for axis in AXES[part]:
        column = numbers.get(f"{before}{axis}_{UNIT[part]}")
        if column is None:
            continue
        for k, row in enumerate(order.tolist(), 1):
            if np.isfinite(column[row]):
                found[f"{axis}_{k}"] = float(column[row])
    return found
