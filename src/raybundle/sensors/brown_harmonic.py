"""Brown's model with angular harmonics, for what lenses and sensors have that is neither radial nor decentred."""

from __future__ import annotations

from raybundle.numerics.maths import Scalar
from raybundle.sensors.brown import Brown
from raybundle.sensors.model import Parameter, SensorModel


class BrownHarmonic(SensorModel):
    """Brown's model and distortion that repeats twice, three or four times around the principal point.

    With z = u + i v: dz = (B1 + i B2) |z|^2 conj(z) + (T1 + i T2) conj(z)^2 + (Q1 + i Q2) conj(z)^3, at the measured
    point.  Affinity and shear are conj(z), so that these are its relatives of the second and third degree: terms of
    the complete cubic polynomial (Gruen 1978) that Brown's parameters lack and that no rotation of the camera imitates.
    Sensors that are not flat, tilted elements of a lens, and distortion that a camera has corrected in its own way
    leave them, of some hundredths of a pixel; only targets of good size and contrast show it.
    """

    name = "brown_harmonic"
    by_image = True
    parameters = (
        *Brown.parameters,
        Parameter("B1", "mm^-2", "parameter.twofold", typical=5e-7, kind="harmonic"),
        Parameter("B2", "mm^-2", "parameter.twofold", typical=-3e-7, kind="harmonic"),
        Parameter("T1", "mm^-1", "parameter.threefold", typical=5e-6, kind="harmonic"),
        Parameter("T2", "mm^-1", "parameter.threefold", typical=-3e-6, kind="harmonic"),
        Parameter("Q1", "mm^-2", "parameter.fourfold", typical=5e-7, kind="harmonic"),
        Parameter("Q2", "mm^-2", "parameter.fourfold", typical=-3e-7, kind="harmonic"),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, K1: Scalar, K2: Scalar, K3: Scalar, P1: Scalar, P2: Scalar, A: Scalar,
        S: Scalar, B1: Scalar, B2: Scalar, T1: Scalar, T2: Scalar, Q1: Scalar, Q2: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Brown's condition and the harmonics."""
        dx, dy = Brown.condition(x, y, X, Y, Z, c, x0, y0, K1, K2, K3, P1, P2, A, S)
        u, v = x - x0, y - y0
        square, twice = u * u - v * v, 2 * u * v
        cubic, across = u * (u * u - 3 * v * v), v * (3 * u * u - v * v)
        r2 = u * u + v * v
        return (
            dx + r2 * (B1 * u + B2 * v) + T1 * square + T2 * twice + Q1 * cubic + Q2 * across,
            dy + r2 * (B2 * u - B1 * v) + T2 * square - T1 * twice + Q2 * cubic - Q1 * across,
        )
