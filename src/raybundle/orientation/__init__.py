"""Approximate values and the classical orientation problems, each with its precision."""

from raybundle.orientation.assembly import ApproximateValues, approximate_values, possible_values
from raybundle.orientation.dlt import Dlt, dlt
from raybundle.orientation.intersection import Intersection, intersection
from raybundle.orientation.relative import RelativeOrientation, relative_orientation
from raybundle.orientation.resection import Resection, resection

__all__ = [
    "ApproximateValues",
    "Dlt",
    "Intersection",
    "RelativeOrientation",
    "Resection",
    "approximate_values",
    "dlt",
    "intersection",
    "possible_values",
    "relative_orientation",
    "resection",
]
