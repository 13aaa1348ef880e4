"""Rotating linear-array panoramic camera."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.maths import Scalar, cos, sin
from raybundle.sensors.model import Parameter, SensorModel


class Panorama(SensorModel):
    """A vertical line that turns about the y axis; x is the arc length on the image cylinder.

    The image point lies in the plane of the line at the turn x / c (Schneider and Maas 2004).
    """

    name = "panorama"
    parameters = (
        Parameter("c", "mm", "camera constant", 50.0, kind="scale"),
        Parameter("y0", "mm", "principal point on the line", typical=0.1, kind="principal point"),
        Parameter("e", "length", "eccentricity of the projection centre along the view", typical=0.002),
        Parameter("K1", "mm^-2", "radial distortion along the line", typical=-3e-6, kind="radial"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, y0: Scalar, e: Scalar, K1: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Distance from the plane of the line, and central projection within it."""
        turn = x / c
        side = cos(turn) * X + sin(turn) * Z
        depth = sin(turn) * X - cos(turn) * Z - e
        v = y - y0
        return -c * side / depth, v + v * v * v * K1 - c * Y / depth

    def start(self, points: Array, values: Array) -> Array:
        """Turn and height without corrections."""
        turn = np.arctan2(points[0], -points[2])
        return values[0] * np.stack([turn, points[1] / np.hypot(points[0], points[2])])

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """In front of the line at the turn at which it was measured; everywhere if none was."""
        if image is None or values is None:
            return np.hypot(points[0], points[2]) > 0
        turn = image[0] / values[0]
        return np.sin(turn) * points[0] - np.cos(turn) * points[2] - values[2] > 0
