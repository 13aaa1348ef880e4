"""Exterior orientations of BINGO (itera.dat): lines `ORIA image X Y Z phi omega kappa`, phi primary, in gon.

Other records are passed over.  Where the photographs fit omega, phi, kappa or degrees alone, they are read so.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.io.reading.dialects import table_text
from raybundle.io.trajectories.angle_csv import UNITS
from raybundle.io.trajectories.attitudes import ROTATIONS
from raybundle.io.trajectories.base import Reading, Trajectory, TrajectoryFormat, register
from raybundle.io.trajectories.exterior_list import with_readings
from raybundle.io.trajectories.image_rows import ImageRow, listed
from raybundle.io.trajectories.patb_orientations import numbers

COLUMNS = ("X", "Y", "Z", "phi", "omega", "kappa")
READINGS = ("pok-gon", "opk-gon", "opk-deg")


def read(path: Path) -> Trajectory:
    """Positions and attitudes; raises InputError with line and column."""
    rows: list[ImageRow] = []
    angles: list[list[float]] = []
    for line, text in enumerate(table_text(path).split("\n"), 1):
        words = text.split()
        if words and words[0].upper() == "ORIA":
            x, y, z, *turn = numbers(words[2:], COLUMNS, path, line)
            rows.append(ImageRow(line, words[1], (x, y, z)))
            angles.append(turn)
    trajectory = listed(path, rows, None)
    readings: list[Reading] = []
    for name in READINGS:
        order, unit = name.split("-")
        a = np.array(angles) * UNITS[unit]
        readings.append(Reading(name=name, convention=order, angles=a, rotation=ROTATIONS[order](a)))
    return with_readings(trajectory, readings, " ".join(COLUMNS[3:]), preferred=True)


register(
    TrajectoryFormat(
        name="bingo-oria", title="BINGO (itera.dat)", read=read,
        recognises=lambda head, _: any(t[:5].upper() == "ORIA " for t in head.splitlines()),
    )
)  # fmt: skip
