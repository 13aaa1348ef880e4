"""A station: six parameters that place a sensor at one point of object space."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array


def sensor_from_object(rotation: Array, centre: Array, xyz: Array) -> Array:
    """Points (3, n) in the sensor frame, (U, V, W) = R (X - X0).

    rotation  (n, 3, 3) object axes to image axes; centre (n, 3) projection centres; xyz (n, 3) object points
    """
    return np.einsum("nij,nj->in", rotation, xyz - centre)


def station_partials(rotation: Array, point: Array, by_point: Array) -> tuple[Array, Array]:
    """Derivatives by the station (..., 6: X0, delta) and by the object point (..., 3).

    rotation  (3, 3); point (3,) in the sensor frame; by_point (..., 3) derivatives by that point
    The small rotation acts on the left, R_new = exp([delta]x) R: dP = delta x P - R dX0 + R dX.
    """
    by_object = by_point @ rotation
    return np.concatenate([-by_object, np.cross(point, by_point)], axis=-1), by_object
