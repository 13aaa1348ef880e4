"""Equidistant fisheye with radial and decentring distortion."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.maths import Scalar, angle_ratio
from raybundle.sensors.model import Parameter, SensorModel


class Fisheye(SensorModel):
    """Image radius proportional to the angle off the axis, corrected as in Brown's model.

    Points up to 180 degrees off the axis have an image, so a point beside or behind the camera
    is a legitimate object point.  Equidistant projection: Schwalbe 2005.
    """

    name = "fisheye"
    all_round = True
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 10.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("K1", "mm^-2", "parameter.radial", typical=-3e-5, kind="radial"),
        Parameter("K2", "mm^-4", "parameter.radial", typical=1e-8, kind="radial"),
        Parameter("K3", "mm^-6", "parameter.radial", typical=1e-12, kind="radial"),
        Parameter("P1", "mm^-1", "parameter.decentring", typical=1e-5, kind="decentring"),
        Parameter("P2", "mm^-1", "parameter.decentring", typical=-1e-5, kind="decentring"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, K1: Scalar, K2: Scalar, K3: Scalar, P1: Scalar, P2: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Corrected image point minus equidistant projection; smooth on the axis."""
        u, v = x - x0, y - y0
        r2 = u * u + v * v
        radial = r2 * (K1 + r2 * (K2 + r2 * K3))
        dx = u * radial + P1 * (r2 + 2 * u * u) + 2 * P2 * u * v
        dy = v * radial + P2 * (r2 + 2 * v * v) + 2 * P1 * u * v
        scale = c * angle_ratio(X * X + Y * Y, -Z)
        return u + dx - scale * X, v + dy - scale * Y

    def start(self, points: Array, values: Array) -> Array:
        """Equidistant projection without corrections."""
        radius = np.hypot(points[0], points[1])
        scale = values[0] * np.arctan2(radius, -points[2]) / np.maximum(radius, 1e-300)
        return np.stack([values[1] + scale * points[0], values[2] + scale * points[1]])
