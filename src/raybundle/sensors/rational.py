"""The rational distortion model of computer vision, for wide lenses and exchange."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel


class Rational(SensorModel):
    """Central projection, a quotient of two polynomials of the ideal radius, decentring; no pole within the format.

    p = (X / Z, Y / Z), r^2 = |p|^2, p' = p (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6) and two
    decentring terms (Claus and Fitzgibbon 2005 for rational functions; in the form with eight coefficients that OpenCV
    documents); x = x0 - c p'.  A is the affinity: y is scaled by c (1 + A).
    """

    name = "rational"
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 10.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("k1", "1", "parameter.radial_numerator", typical=0.05, kind="radial"),
        Parameter("k2", "1", "parameter.radial_numerator", typical=0.02, kind="radial"),
        Parameter("k3", "1", "parameter.radial_numerator", typical=0.001, kind="radial"),
        Parameter("k4", "1", "parameter.radial_denominator", typical=0.1, kind="radial"),
        Parameter("k5", "1", "parameter.radial_denominator", typical=0.01, kind="radial"),
        Parameter("k6", "1", "parameter.radial_denominator", typical=0.001, kind="radial"),
        Parameter("p1", "1", "parameter.decentring", typical=1e-4, kind="decentring"),
        Parameter("p2", "1", "parameter.decentring", typical=-1e-4, kind="decentring"),
        Parameter("A", "1", "parameter.affinity", typical=1e-4, kind="affinity"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar,
        k1: Scalar, k2: Scalar, k3: Scalar, k4: Scalar, k5: Scalar, k6: Scalar, p1: Scalar, p2: Scalar, A: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Image point minus distorted central projection; y points up, so that p1 has the opposite sign of y down."""
        p, q = -X / Z, -Y / Z
        r2 = p * p + q * q
        ratio = (1 + r2 * (k1 + r2 * (k2 + r2 * k3))) / (1 + r2 * (k4 + r2 * (k5 + r2 * k6)))
        dx = p * ratio + 2 * p1 * p * q + p2 * (r2 + 2 * p * p)
        dy = q * ratio + p1 * (r2 + 2 * q * q) + 2 * p2 * p * q
        return x - x0 - c * dx, y - y0 - c * (1 + A) * dy
