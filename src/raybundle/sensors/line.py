"""A line sensor: what a pushbroom is but for its way."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel


class Line(SensorModel):
    """A line across the view that is carried along; y, the measured line, stands for the time.

    By itself it sees one line of the object and is no model: nothing of y enters its condition.  On a trajectory it is
    the model `pushbroom`.  The first lines stand on top of the image, so that vy > 0 is the length that one mm of the
    image covers on the way; it must be given.
    """

    name = "line"
    line = True
    called: ClassVar[Mapping[str, str]] = {"trajectory": "pushbroom"}
    frame = False
    one_exposure = False
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 50.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point_line", typical=0.05, kind="principal point"),
        Parameter("y0", "mm", "parameter.line_place", typical=-0.1),
        Parameter("K1", "mm^-2", "parameter.radial_line", typical=-2e-6, kind="radial"),
        Parameter("K2", "mm^-4", "parameter.radial_line", typical=1e-10, kind="radial"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar, c: Scalar, x0: Scalar, y0: Scalar, K1: Scalar, K2: Scalar
    ) -> tuple[Scalar, Scalar]:
        """Central projection along the line, and the distance from the plane of the line."""
        del y
        u = x - x0
        u2 = u * u
        return u + u * u2 * (K1 + K2 * u2) + c * X / Z, y0 + c * Y / Z

    def start(self, points: Array, values: Array) -> Array:
        """Along the line without distortion; on which line is for the platform to say."""
        x = values[1] - values[0] * points[0] / points[2]
        return np.stack([x, np.zeros_like(x)])

    def ray(self, image: Array, values: Array, start: Array | None = None) -> Array:
        """The direction itself."""
        del start
        c, x0, y0, K1, K2 = values[:5]
        u = image[0] - x0
        d = np.stack(np.broadcast_arrays(u + u**3 * (K1 + K2 * u * u), y0, -c))
        return d / np.linalg.norm(d, axis=0)
