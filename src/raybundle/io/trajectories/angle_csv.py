"""What tables of attitudes share: positions in two systems, angles in three units, times and standard deviations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.digits import EVERY
from raybundle.io.reading.dialects import header_cells
from raybundle.io.tables import Column, Table, read_table, write_table
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory, no_attitudes
from raybundle.numerics.arrays import Array
from raybundle.numerics.attitude import GON

UNITS = {"deg": np.pi / 180, "gon": GON, "rad": 1.0}
GRID, GEOGRAPHIC = ("X", "Y", "Z"), ("longitude_deg", "latitude_deg", "height_m")
SIGMA = ("sX", "sY", "sZ")
CONVENTIONS = {"omega": "opk", "roll": "rpy-ned", "gimbal_yaw": "gimbal"}
"""Names of the conventions by the first of their angles."""


def has_angles(head: str, angles: Sequence[str]) -> bool:
    """Whether a table has these angles, in any unit."""
    names = header_cells(head)
    return "image" in names and any(all(f"{a}_{u}" in names for a in angles) for u in UNITS)


def read_angles(
    path: Path,
    choices: Mapping[tuple[str, str, str], Callable[[Array], Array]],
    *,
    true_north: bool,
) -> Trajectory:
    """A table `image, X, Y, Z` or `image, longitude_deg, latitude_deg, height_m`, and three angles.

    choices  names of the three angles without their unit, and the rotation that they make [rad]
    raises   InputError with line and column
    """
    columns = [Column(name="image", kind="id"), Column(name="time_s", kind="number", optional=True, empty=True)]
    columns += [Column(name=n, kind="number", optional=True, empty=True) for n in (*GRID, *GEOGRAPHIC)]
    columns += [Column(name=n, kind="number", optional=True, empty=True, limit=">= 0") for n in SIGMA]
    every = [(angles, unit) for angles in choices for unit in UNITS]
    for angles, unit in every:
        columns += [Column(name=f"{a}_{unit}", kind="number", optional=True, empty=True) for a in angles]
        columns += [Column(name=f"s{a}_{unit}", kind="number", optional=True, empty=True, limit=">= 0") for a in angles]
    table = read_table(path, columns)
    full = [(a, u) for a, u in every if all(f"{n}_{u}" in table.number for n in a)]
    if len(full) != 1:
        raise InputError(
            "table.three_angles", choices=[" ".join(f"{n}_deg" for n in a) for a in choices], file=path, line=1
        )
    angles, unit = full[0]
    given = table.numbers(*(f"{n}_{unit}" for n in angles)) * UNITS[unit]
    unknown = np.flatnonzero(np.isnan(given).any(axis=1))
    given[unknown] = 0.0
    rotation = choices[angles](given)
    rotation[unknown] = np.nan
    spread = table.numbers(*(f"s{n}_{unit}" for n in angles)) * UNITS[unit]
    xyz, crs = positions_of_table(path, table)
    time = table.number.get("time_s")
    return Trajectory(
        path=path,
        names=table.text["image"],
        xyz=xyz,
        sigma=table.numbers(*SIGMA),
        crs=crs,
        rotation=rotation,
        rotation_sigma=spread if np.isfinite(spread).any() else None,
        convention=CONVENTIONS[angles[0]],
        angles=np.where(np.isfinite(rotation[:, :, 0]), given, np.nan),
        true_north=true_north or crs == WGS84_HEIGHT,
        time=time,
        lines=np.arange(table.rows, dtype=np.int32) + table.first_line,
    )


def positions_of_table(path: Path, table: Table) -> tuple[Array, str | None]:
    """Positions (n, 3) of a table, and their coordinate system where its columns show it."""
    found = [names for names in (GRID, GEOGRAPHIC) if all(n in table.number for n in names)]
    if len(found) != 1:
        raise InputError("table.one_position", grid=list(GRID), geographic=list(GEOGRAPHIC), file=path, line=1)
    xyz = table.numbers(*found[0])
    if found[0] == GRID:
        return xyz, None
    for k, limit in ((0, 180.0), (1, 90.0)):
        bad = np.flatnonzero(np.abs(xyz[:, k]) > limit)
        if len(bad):
            row = int(bad[0])
            raise InputError(
                "position.beyond_degrees",
                value=xyz[row, k],
                limit=limit,
                file=path,
                line=row + table.first_line,
                column=found[0][k],
            )
    return xyz, WGS84_HEIGHT


def write_angles(trajectory: Trajectory, path: Path, angles: Sequence[str], values: Array) -> None:
    """Write such a table; angles (n, 3) [rad] are written in degrees."""
    place = GEOGRAPHIC if trajectory.crs == WGS84_HEIGHT else GRID
    columns: dict[str, Sequence[str] | Array] = {"image": trajectory.names}
    if trajectory.time is not None:
        columns["time_s"] = trajectory.time
    columns |= {n: trajectory.xyz[:, k] for k, n in enumerate(place)}
    columns |= {f"{n}_deg": np.degrees(values[:, k]) for k, n in enumerate(angles)}
    if np.isfinite(trajectory.sigma).any():
        columns |= {n: trajectory.sigma[:, k] for k, n in enumerate(SIGMA)}
    if trajectory.rotation_sigma is not None:
        columns |= {f"s{n}_deg": np.degrees(trajectory.rotation_sigma[:, k]) for k, n in enumerate(angles)}
    write_table(path, columns, EVERY)


def attitudes(trajectory: Trajectory, path: Path, *, true_north: bool) -> Array:
    """The rotations of a trajectory that is to be written with its attitudes, against these axes."""
    if trajectory.rotation is None:
        raise no_attitudes(trajectory, path)
    if trajectory.true_north != true_north:
        raise InputError("trajectory.attitude_reference", true_north=true_north, file=path)
    return trajectory.rotation
