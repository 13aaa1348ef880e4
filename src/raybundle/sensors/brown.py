"""Frame camera with Brown's additional parameters."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel


class Brown(SensorModel):
    """Collinearity with radial and decentring distortion, affinity and shear.

    The corrections are taken at the measured point (Brown 1971; Fraser 1997 for A and S), so the
    condition is closed form from image to object and projection needs an iteration.
    """

    name = "brown"
    by_image = True
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 28.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("K1", "mm^-2", "parameter.radial", typical=-3e-5, kind="radial"),
        Parameter("K2", "mm^-4", "parameter.radial", typical=1e-8, kind="radial"),
        Parameter("K3", "mm^-6", "parameter.radial", typical=1e-12, kind="radial"),
        Parameter("P1", "mm^-1", "parameter.decentring", typical=1e-5, kind="decentring"),
        Parameter("P2", "mm^-1", "parameter.decentring", typical=-1e-5, kind="decentring"),
        Parameter("A", "1", "parameter.affinity", typical=1e-4, kind="affinity"),
        Parameter("S", "1", "parameter.shear", typical=-5e-5, kind="affinity", shear=True),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar,
        K1: Scalar, K2: Scalar, K3: Scalar, P1: Scalar, P2: Scalar, A: Scalar, S: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Corrected image point minus central projection."""
        u, v = x - x0, y - y0
        r2 = u * u + v * v
        radial = r2 * (K1 + r2 * (K2 + r2 * K3))
        dx = u * radial + P1 * (r2 + 2 * u * u) + 2 * P2 * u * v + A * u + S * v
        dy = v * radial + P2 * (r2 + 2 * v * v) + 2 * P1 * u * v
        return u + dx + c * X / Z, v + dy + c * Y / Z
