"""Approximate values and the classical orientation problems, each with its precision."""

from raybundle.orientation.approximate import approximate_values, possible_values
from raybundle.orientation.assembly import ApproximateValues
from raybundle.orientation.intersection import Intersection, intersection
from raybundle.orientation.projective.dlt import Dlt, dlt
from raybundle.orientation.projective.epipolar import FundamentalMatrix, fundamental_matrix
from raybundle.orientation.projective.model import SelfCalibration, self_calibration
from raybundle.orientation.relative import RelativeOrientation, relative_orientation
from raybundle.orientation.resection import Resection, resection

__all__ = [
    "ApproximateValues",
    "Dlt",
    "FundamentalMatrix",
    "Intersection",
    "RelativeOrientation",
    "Resection",
    "SelfCalibration",
    "approximate_values",
    "dlt",
    "fundamental_matrix",
    "intersection",
    "possible_values",
    "relative_orientation",
    "resection",
    "self_calibration",
]
