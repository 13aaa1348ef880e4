"""The rational model with thin-prism terms: the twelve coefficients of computer vision."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar
from raybundle.sensors.model import Parameter, SensorModel
from raybundle.sensors.rational import Rational


class ThinPrism(SensorModel):
    """The rational model, and what lenses that are not parallel to the sensor add: a thin prism.

    To the distorted point of `rational` s1 r^2 + s2 r^4 is added in x, s3 r^2 + s4 r^4 in y, r the ideal radius (Weng,
    Cohen and Herniou 1992 for the first of each pair; with the second in the form with twelve coefficients that OpenCV
    documents; y points up here, so that s3 and s4 have the opposite sign).  In a narrow angle s1 and s3 are hardly
    distinguished from the principal point, and p1, p2: estimate them where residuals ask for them.
    """

    name = "thin_prism"
    parameters = (
        *Rational.parameters[:-1],
        Parameter("s1", "1", "parameter.thin_prism_x", typical=1e-3, kind="decentring"),
        Parameter("s2", "1", "parameter.thin_prism_x", typical=-5e-4, kind="decentring"),
        Parameter("s3", "1", "parameter.thin_prism_y", typical=-8e-4, kind="decentring"),
        Parameter("s4", "1", "parameter.thin_prism_y", typical=3e-4, kind="decentring"),
        Rational.parameters[-1],
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar,
        k1: Scalar, k2: Scalar, k3: Scalar, k4: Scalar, k5: Scalar, k6: Scalar, p1: Scalar, p2: Scalar,
        s1: Scalar, s2: Scalar, s3: Scalar, s4: Scalar, A: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Image point minus distorted central projection."""
        p, q = -X / Z, -Y / Z
        r2 = p * p + q * q
        ratio = (1 + r2 * (k1 + r2 * (k2 + r2 * k3))) / (1 + r2 * (k4 + r2 * (k5 + r2 * k6)))
        dx = p * ratio + 2 * p1 * p * q + p2 * (r2 + 2 * p * p) + r2 * (s1 + r2 * s2)
        dy = q * ratio + p1 * (r2 + 2 * q * q) + 2 * p2 * p * q + r2 * (s3 + r2 * s4)
        return x - x0 - c * dx, y - y0 - c * (1 + A) * dy
