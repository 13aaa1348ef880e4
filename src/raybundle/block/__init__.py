"""The data model of a photogrammetric block, and its simulation."""

from raybundle.block.block import Block, Camera, Images, Observations, PixelFrame, Points, Role
from raybundle.observations.attitude import Attitudes, no_attitudes
from raybundle.observations.distance import Distances, no_distances
from raybundle.observations.relation import Relation
from raybundle.observations.station import Stations, no_stations

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
