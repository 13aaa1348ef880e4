"""The forward radial model of computer vision, for exchange and benchmarks."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel


class Radial(SensorModel):
    """Central projection, then two radial terms at the ideal point; principal point at the centre.

    x = -c (1 + k1 r^2 + k2 r^4) X / Z with r^2 = (X^2 + Y^2) / Z^2 (Snavely, Seitz and Szeliski 2006).
    """

    name = "radial"
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 28.0, kind="scale"),
        Parameter("k1", "1", "parameter.radial_ideal", typical=-0.02, kind="radial"),
        Parameter("k2", "1", "parameter.radial_ideal", typical=0.005, kind="radial"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar, c: Scalar, k1: Scalar, k2: Scalar
    ) -> tuple[Scalar, Scalar]:
        """Image point minus distorted central projection."""
        p, q = X / Z, Y / Z
        r2 = p * p + q * q
        scale = c * (1 + r2 * (k1 + r2 * k2))
        return x + scale * p, y + scale * q
