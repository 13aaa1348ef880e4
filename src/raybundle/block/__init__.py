"""The data model of a photogrammetric block, and its simulation."""

from raybundle.block.block import ROLES, Block, Camera, Images, Instrument, Observations, PixelFrame, Points, Role
from raybundle.observations.attitude import Attitudes
from raybundle.observations.distance import Distances
from raybundle.observations.relation import Relation
from raybundle.observations.station import Stations

__all__ = [
    "ROLES",
    "Attitudes",
    "Block",
    "Camera",
    "Distances",
    "Images",
    "Instrument",
    "Observations",
    "PixelFrame",
    "Points",
    "Relation",
    "Role",
    "Stations",
]
