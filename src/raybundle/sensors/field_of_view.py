"""The field-of-view model of wide lenses: one angle states the distortion."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar, angle_ratio, cos, sin
from raybundle.sensors.model import Parameter, SensorModel


class FieldOfView(SensorModel):
    """Image radius c / w atan(2 r tan(w / 2)), r the ideal radius; no decentring.

    Devernay and Faugeras 2001, equation 13, with w the angle of the field of view in radians.  A is the affinity: y is
    scaled by c (1 + A).  w = 0, a lens without distortion, is not a value of this model.
    """

    name = "field_of_view"
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 10.0, kind="scale"),
        Parameter("x0", "mm", "parameter.principal_point", typical=0.03, kind="principal point"),
        Parameter("y0", "mm", "parameter.principal_point", typical=-0.02, kind="principal point"),
        Parameter("w", "1", "parameter.radial", 0.9, kind="radial"),
        Parameter("A", "1", "parameter.affinity", typical=1e-4, kind="affinity"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, w: Scalar, A: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Image point minus its place at the distorted radius; smooth on the axis."""
        t = 2 * sin(w) / (1 + cos(w))  # 2 tan(w / 2)
        scale = c * t / w * angle_ratio(t * t * (X * X + Y * Y), -Z)
        return x - x0 - scale * X, y - y0 - scale * (1 + A) * Y
