"""The enhanced unified camera model: central projection from an ellipsoid."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar, sqrt
from raybundle.sensors.model import Parameter, SensorModel


class EnhancedUnified(SensorModel):
    """x = c X / (alpha d + (1 - alpha) (-Z)) with d^2 = beta (X^2 + Y^2) + Z^2; no decentring.

    Khomutenko, Garcia and Martinet 2016, equation 9.  alpha = 0 is the central projection.  A is the affinity: y is
    scaled by c (1 + A).
    """

    name = "eucm"
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 20.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("alpha", "1", "parameter.radial", typical=0.4, kind="radial"),
        Parameter("beta", "1", "parameter.radial", 1.0, typical=1.1, kind="radial"),
        Parameter("A", "1", "parameter.affinity", typical=1e-4, kind="affinity"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, alpha: Scalar, beta: Scalar, A: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Image point minus its place in the projection from the ellipsoid."""
        distance = sqrt(beta * (X * X + Y * Y) + Z * Z)
        scale = c / (alpha * distance - (1 - alpha) * Z)
        return x - x0 - scale * X, y - y0 - scale * (1 + A) * Y
