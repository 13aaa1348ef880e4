"""CSV of positions and attitudes with roll, pitch, yaw against north, east, down.

image,longitude_deg,latitude_deg,height_m,roll_deg,pitch_deg,yaw_deg[,sX,sY,sZ][,sroll_deg,spitch_deg,syaw_deg]
[,time_s]

roll, pitch, yaw                       of the aircraft; the camera is taken to look down, the image's upper side forward
gimbal_yaw, gimbal_pitch, gimbal_roll  of the camera itself, its viewing axis forward (pitch -90: nadir), as DJI's XMP

Angles also as _gon or _rad, positions also as X, Y, Z of a grid.  Yaw counts clockwise from true north, whatever system
the positions stand in; ARINC 705 and the user manuals of DJI aircraft (NED, order ZYX).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.io.trajectories.angle_csv import attitudes, has_angles, read_angles, write_angles
from raybundle.io.trajectories.base import Trajectory, TrajectoryFormat, register
from raybundle.numerics.attitude import rotation_from_gimbal, rotation_from_rpy, rpy_from_rotation

ANGLES = ("roll", "pitch", "yaw")
GIMBAL = ("gimbal_yaw", "gimbal_pitch", "gimbal_roll")


def read(path: Path) -> Trajectory:
    """Positions and attitudes of a table; raises InputError with line and column."""
    return read_angles(path, {ANGLES: rotation_from_rpy, GIMBAL: rotation_from_gimbal}, true_north=True)


def write(trajectory: Trajectory, path: Path) -> None:
    """Write roll, pitch, yaw in degrees, of a body under which the camera looks down."""
    rotation = attitudes(trajectory, path, true_north=True)
    known = np.isfinite(rotation).all(axis=(1, 2))
    angles = np.full((len(rotation), 3), np.nan)
    angles[known] = rpy_from_rotation(rotation[known])
    write_angles(trajectory, path, ANGLES, angles)


register(
    TrajectoryFormat(
        name="rpy",
        title="CSV with image, position, roll_deg, pitch_deg, yaw_deg (or gimbal_yaw_deg, ...)",
        read=read,
        write=write,
        recognises=lambda head, suffix: (
            suffix in {".csv", ".txt"} and (has_angles(head, ANGLES) or has_angles(head, GIMBAL))
        ),
    )
)
