"""Positions and attitudes from GNSS and INS; every module in this folder that holds a format registers it on import.

A new format is one new file: it makes a `TrajectoryFormat` and hands it to `register`.
"""

from importlib import import_module
from pkgutil import iter_modules

from raybundle.io.trajectories.attitudes import PhotoAttitudes, attitudes_of_file, attitudes_of_gimbals
from raybundle.io.trajectories.base import (
    Reading,
    Trajectory,
    TrajectoryFormat,
    decided,
    in_wgs84,
    matched,
    read_trajectory,
    rotations_in,
    stations_of,
    trajectory_formats,
    write_trajectory,
)
from raybundle.io.trajectories.photographs import with_positions

for _module in iter_modules(__path__):
    import_module(f"{__name__}.{_module.name}")

__all__ = [
    "PhotoAttitudes",
    "Reading",
    "Trajectory",
    "TrajectoryFormat",
    "attitudes_of_file",
    "attitudes_of_gimbals",
    "decided",
    "in_wgs84",
    "matched",
    "read_trajectory",
    "rotations_in",
    "stations_of",
    "trajectory_formats",
    "with_positions",
    "write_trajectory",
]
