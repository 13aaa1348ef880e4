"""Brown's terms at the ideal point with a zero crossing R0, the form of AICON 3D Studio and JAiCov."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel


class Aicon(SensorModel):
    """Distortion added to the undistorted image point; radial terms balanced at the radius R0.

    Luhmann, Robson, Kyle and Boehm 2020, section 3.3 (forward form with r0).
    """

    name = "aicon"
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 28.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("K1", "mm^-2", "parameter.radial", typical=-3e-5, kind="radial"),
        Parameter("K2", "mm^-4", "parameter.radial", typical=1e-8, kind="radial"),
        Parameter("P1", "mm^-1", "parameter.decentring", typical=1e-5, kind="decentring"),
        Parameter("P2", "mm^-1", "parameter.decentring", typical=-1e-5, kind="decentring"),
        Parameter("C1", "1", "parameter.affinity", typical=1e-4, kind="affinity"),
        Parameter("C2", "1", "parameter.shear", typical=-5e-5, kind="affinity", shear=True),
        Parameter("R0", "mm", "parameter.zero_radius", typical=8.0),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar,
        K1: Scalar, K2: Scalar, P1: Scalar, P2: Scalar, C1: Scalar, C2: Scalar, R0: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Measured image point minus distorted central projection."""
        p, q = -c * X / Z, -c * Y / Z
        r2, z2 = p * p + q * q, R0 * R0
        radial = K1 * (r2 - z2) + K2 * (r2 * r2 - z2 * z2)
        dx = p * radial + P1 * (r2 + 2 * p * p) + 2 * P2 * p * q + C1 * p + C2 * q
        dy = q * radial + P2 * (r2 + 2 * q * q) + 2 * P1 * p * q
        return x - x0 - p - dx, y - y0 - q - dy
