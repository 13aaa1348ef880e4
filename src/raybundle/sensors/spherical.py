"""Spherical panorama: stitched images on a sphere about one projection centre."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from raybundle.errors import Message
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.maths import Scalar, cos, sin
from raybundle.sensors.model import Parameter, SensorModel
from raybundle.sensors.panorama import too_many_turns


class Spherical(SensorModel):
    """Longitude and latitude on a sphere as image coordinates (equirectangular), y along its axis.

    A stitched panorama has one projection centre only as far as its photographs had; near objects show the seams as
    residuals.  For a full sphere c = width / (2 pi).
    """

    name = "spherical"
    one_exposure = False
    parameters = (
        Parameter("c", "mm", "parameter.sphere_radius", 50.0, kind="scale"),
        Parameter("y0", "mm", "parameter.horizon", typical=0.1, kind="principal point"),
    )

    def objection(self, values: Mapping[str, float], width_mm: float, free: Sequence[str]) -> Message | None:
        """A format of several turns would put points behind the camera."""
        del free
        return too_many_turns(width_mm, values["c"])

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar, c: Scalar, y0: Scalar
    ) -> tuple[Scalar, Scalar]:
        """Angles between the measured direction and the point, across and along the meridian, times c."""
        turn, rise = x / c, (y - y0) / c
        side = cos(turn) * X + sin(turn) * Z
        depth = sin(turn) * X - cos(turn) * Z
        return -c * side / depth, c * (sin(rise) * depth - cos(rise) * Y) / (cos(rise) * depth + sin(rise) * Y)

    def start(self, points: Array, values: Array) -> Array:
        """The projection itself."""
        turn = np.arctan2(points[0], -points[2])
        rise = np.arctan2(points[1], np.hypot(points[0], points[2]))
        return np.stack([values[0] * turn, values[1] + values[0] * rise])

    def ray(self, image: Array, values: Array, start: Array | None = None) -> Array:
        """The direction itself."""
        del start
        turn, rise = image[0] / values[0], (image[1] - values[1]) / values[0]
        return np.stack([np.sin(turn) * np.cos(rise), np.sin(rise), -np.cos(turn) * np.cos(rise)])

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """On the side of the axis on which it was measured; everywhere if it was not."""
        if image is None or values is None:
            return np.any(points != 0, axis=0)
        turn = image[0] / values[0]
        return np.sin(turn) * points[0] - np.cos(turn) * points[2] > 0
