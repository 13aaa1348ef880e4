"""A camera of a rig: Brown's model behind an offset from the rig's own frame."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.maths import Scalar
from raybundle.numerics.motion import mounted_axes
from raybundle.sensors.brown import Brown
from raybundle.sensors.model import Parameter, SensorModel

OFFSET = slice(10, 13)
ANGLES = slice(13, 16)


class BrownMounted(SensorModel):
    """Brown's model; the exterior orientation is that of the rig, in whose frame the camera is mounted.

    (U, V, W) = R3(ka) R2(ph) R1(om) ((X, Y, Z) - (bx, by, bz)).  One camera of a rig may define the frame (`brown`, or
    offsets held); those of the others are estimated, observed (a calibration with its sigma) or held.
    """

    name = "brown_mounted"
    one_exposure = False
    parameters = (
        *Brown.parameters,
        Parameter("bx", "length", "offset of the projection centre, x of the rig", typical=0.11),
        Parameter("by", "length", "offset of the projection centre, y of the rig", typical=-0.02),
        Parameter("bz", "length", "offset of the projection centre, z of the rig", typical=0.03),
        Parameter("om", "rad", "omega of the camera against the rig", typical=0.02),
        Parameter("ph", "rad", "phi of the camera against the rig", typical=-0.03),
        Parameter("ka", "rad", "kappa of the camera against the rig", typical=0.05),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, K1: Scalar, K2: Scalar, K3: Scalar, P1: Scalar, P2: Scalar, A: Scalar,
        S: Scalar, bx: Scalar, by: Scalar, bz: Scalar, om: Scalar, ph: Scalar, ka: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Brown's condition in the axes of the camera."""
        U, V, W = mounted_axes((X - bx, Y - by, Z - bz), (om, ph, ka))
        return Brown.condition(x, y, U, V, W, c, x0, y0, K1, K2, K3, P1, P2, A, S)

    def start(self, points: Array, values: Array) -> Array:
        """Central projection in the axes of the camera."""
        U, V, W = _own(points, values)
        return -values[0] * np.stack([U, V]) / W

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """In front of the camera, not of the rig; everywhere if the mounting is not told."""
        del image
        if values is None:
            return np.any(points != 0, axis=0)
        return _own(points, values)[2] < 0


def _own(points: Array, values: Array) -> Array:
    """Points (3, n) in the axes of the camera."""
    X, Y, Z = (p - b for p, b in zip(points, values[OFFSET], strict=True))
    om, ph, ka = values[ANGLES]
    return np.stack(mounted_axes((X, Y, Z), (om, ph, ka)))
