"""CSV of exterior orientations with omega, phi, kappa.

image,X,Y,Z,omega_deg,phi_deg,kappa_deg[,sX,sY,sZ][,somega_deg,sphi_deg,skappa_deg][,time_s]

Angles also as _gon or _rad; positions also as longitude_deg, latitude_deg, height_m (WGS 84, above the ellipsoid), the
attitude then against east, north, up there.  R = R3(kappa) R2(phi) R1(omega) turns object axes to image axes, as
everywhere here: the angles that most programs of aerial triangulation write.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.io.trajectories.angle_csv import attitudes, has_angles, read_angles, write_angles
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory, TrajectoryFormat, register
from raybundle.numerics.attitude import opk_from_rotation, rotation_from_opk

ANGLES = ("omega", "phi", "kappa")


def read(path: Path) -> Trajectory:
    """Positions and attitudes of a table; raises InputError with line and column."""
    return read_angles(path, {ANGLES: rotation_from_opk}, true_north=False)


def write(trajectory: Trajectory, path: Path) -> None:
    """Write a table in degrees; attitudes stay against the axes they stand against."""
    rotation = attitudes(trajectory, path, true_north=trajectory.crs == WGS84_HEIGHT)
    known = np.isfinite(rotation).all(axis=(1, 2))
    angles = np.full((len(rotation), 3), np.nan)
    angles[known] = opk_from_rotation(rotation[known])
    write_angles(trajectory, path, ANGLES, angles)


register(
    TrajectoryFormat(
        name="opk",
        title="CSV with image, position, omega_deg, phi_deg, kappa_deg",
        read=read,
        write=write,
        recognises=lambda head, suffix: suffix in {".csv", ".txt"} and has_angles(head, ANGLES),
    )
)
