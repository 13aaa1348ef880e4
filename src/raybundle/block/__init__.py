"""The data model of a photogrammetric block, and its simulation."""

from raybundle.block.block import (
    Block,
    Camera,
    Distances,
    Images,
    Observations,
    Points,
    Role,
    Stations,
    no_distances,
    no_stations,
)

__all__ = [
    "Block",
    "Camera",
    "Distances",
    "Images",
    "Observations",
    "Points",
    "Role",
    "Stations",
    "no_distances",
    "no_stations",
]
