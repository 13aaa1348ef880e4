"""The division model: distortion by one coefficient, at the measured point."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel


class Division(SensorModel):
    """The ideal radius is r / (1 + k r^2), r the measured radius divided by c; no decentring.

    Fitzgibbon 2001, equation 6.  A is the affinity: y is scaled by c (1 + A).
    """

    name = "division"
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 20.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("k", "1", "parameter.radial", typical=-0.05, kind="radial"),
        Parameter("A", "1", "parameter.affinity", typical=1e-4, kind="affinity"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, k: Scalar, A: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Measured point plus central projection, stretched by the divisor."""
        a, b = (x - x0) / c, (y - y0) / (c * (1 + A))
        scale = c * (1 + k * (a * a + b * b)) / Z
        return x - x0 + scale * X, y - y0 + scale * (1 + A) * Y
