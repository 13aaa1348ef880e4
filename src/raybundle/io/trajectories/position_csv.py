"""CSV of positions without attitudes, as the stations.csv of a block or a result.

image,X,Y,Z[,sX,sY,sZ][,rXY,rXZ,rYZ][,time_s]

Positions also as longitude_deg, latitude_deg, height_m (WGS 84, above the ellipsoid).  Of a stations.csv, what it
states beside the positions that were observed is left out: antennas, adjusted values and residuals.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.io.digits import EVERY
from raybundle.io.reading.dialects import header_cells
from raybundle.io.tables import Column, read_table, write_table
from raybundle.io.trajectories.angle_csv import GEOGRAPHIC, GRID, SIGMA, positions_of_table
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory, TrajectoryFormat, register
from raybundle.numerics.arrays import Array
from raybundle.numerics.deviations import PAIRS

BESIDE = ("antenna", *(f"{axis}_adjusted" for axis in GRID), *(f"{kind}{axis}" for kind in "vrw" for axis in GRID))
"""Columns of a stations.csv that are no part of what was observed, or mean nothing elsewhere."""
CORRELATION = tuple(f"r{GRID[i]}{GRID[j]}" for i, j in PAIRS)
KNOWN = {"image", "time_s", *GRID, *GEOGRAPHIC, *SIGMA, *CORRELATION, *BESIDE}


def read(path: Path) -> Trajectory:
    """Positions of a table; raises InputError with line and column."""
    columns = [Column(name="image", kind="id"), Column(name="time_s", kind="number", optional=True, empty=True)]
    columns += [Column(name=n, kind="number", optional=True, empty=True) for n in (*GRID, *GEOGRAPHIC)]
    columns += [Column(name=n, kind="number", optional=True, empty=True, limit=">= 0") for n in SIGMA]
    columns += [Column(name=n, kind="number", optional=True, empty=True) for n in CORRELATION]
    columns += [Column(name=n, kind="text", optional=True, empty=True) for n in BESIDE]
    table = read_table(path, columns)
    xyz, crs = positions_of_table(path, table)
    return Trajectory(
        path=path, names=table.text["image"], xyz=xyz, sigma=table.numbers(*SIGMA), crs=crs,
        correlation=table.numbers(*CORRELATION) if {*CORRELATION} & table.number.keys() else None,
        time=table.number.get("time_s"), lines=np.arange(table.rows, dtype=np.int32) + table.first_line,
    )  # fmt: skip


def write(trajectory: Trajectory, path: Path) -> None:
    """Write the positions and their standard deviations."""
    place = GEOGRAPHIC if trajectory.crs == WGS84_HEIGHT else GRID
    columns: dict[str, Sequence[str] | Array] = {"image": trajectory.names}
    if trajectory.time is not None:
        columns["time_s"] = trajectory.time
    columns |= {n: trajectory.xyz[:, k] for k, n in enumerate(place)}
    if np.isfinite(trajectory.sigma).any():
        columns |= {n: trajectory.sigma[:, k] for k, n in enumerate(SIGMA)}
    if trajectory.correlation is not None:
        columns |= {n: trajectory.correlation[:, k] for k, n in enumerate(CORRELATION)}
    write_table(path, columns, EVERY)


def _recognises(head: str, suffix: str) -> bool:
    """Whether a table has a position of each image, and nothing but what is known here: no angles of any name."""
    names = header_cells(head)
    placed = any(all(n in names for n in place) for place in (GRID, GEOGRAPHIC))
    return suffix in {".csv", ".txt"} and "image" in names and placed and {*names} <= KNOWN


register(
    TrajectoryFormat(
        name="positions", title="CSV with image, position and its standard deviations", read=read, write=write,
        recognises=_recognises,
    )
)  # fmt: skip
