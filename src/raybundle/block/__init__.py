"""The data model of a photogrammetric block, and its simulation."""

from raybundle.block.block import (
    Attitudes,
    Block,
    Camera,
    Distances,
    Images,
    Observations,
    PixelFrame,
    Points,
    Relation,
    Role,
    Stations,
    no_attitudes,
    no_distances,
    no_stations,
)

__all__ = [
    "Attitudes",
    "Block",
    "Camera",
    "Distances",
    "Images",
    "Observations",
    "PixelFrame",
    "Points",
    "Relation",
    "Role",
    "Stations",
    "no_attitudes",
    "no_distances",
    "no_stations",
]
