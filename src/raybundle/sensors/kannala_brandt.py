"""The fisheye of computer vision: the image radius is a polynomial of the angle off the axis."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.maths import Scalar, angle_ratio
from raybundle.sensors.model import Parameter, SensorModel


class KannalaBrandt(SensorModel):
    """Image radius c (t + k1 t^3 + k2 t^5 + k3 t^7 + k4 t^9), t the angle off the axis; no decentring.

    Kannala and Brandt 2006, equation 6, the coefficient of the first term being the camera constant; in the form with
    four coefficients that OpenCV documents.  A is the affinity: y is scaled by c (1 + A).  Points up to 180 degrees off
    the axis have an image.
    """

    name = "kannala_brandt"
    all_round = True
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 10.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("k1", "1", "parameter.radial", typical=-0.02, kind="radial"),
        Parameter("k2", "1", "parameter.radial", typical=0.005, kind="radial"),
        Parameter("k3", "1", "parameter.radial", typical=-0.001, kind="radial"),
        Parameter("k4", "1", "parameter.radial", typical=1e-4, kind="radial"),
        Parameter("A", "1", "parameter.affinity", typical=1e-4, kind="affinity"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, k1: Scalar, k2: Scalar, k3: Scalar, k4: Scalar, A: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Image point minus its place at the distorted angle; smooth on the axis."""
        h2 = X * X + Y * Y
        ratio = angle_ratio(h2, -Z)
        t2 = ratio * ratio * h2
        scale = c * ratio * (1 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4))))
        return x - x0 - scale * X, y - y0 - scale * (1 + A) * Y

    def start(self, points: Array, values: Array) -> Array:
        """The image point itself: the model states it without a start."""
        zero = np.zeros(points.shape[1])
        x, y = self.condition_at(np.stack([zero, zero]), points, values)
        return np.stack([-x, -y])
