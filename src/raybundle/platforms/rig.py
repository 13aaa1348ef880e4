"""A rig: a station that carries several cameras, each mounted with an offset of its own.

The rig has one exterior orientation at each station, in whose frame its cameras are mounted.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.maths import Scalar
from raybundle.numerics.motion import Point, mounted_axes
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_angles
from raybundle.platforms.platform import Platform
from raybundle.sensors.model import Parameter

OFFSET = ("bx", "by", "bz")
ANGLES = ("om", "ph", "ka")


class Rig(Platform):
    """The exterior orientation is that of the rig, in whose frame the sensor is mounted.

    (U, V, W) = R3(ka) R2(ph) R1(om) ((X, Y, Z) - (bx, by, bz)).  One camera of a rig may define the frame (without a
    mounting, or offsets held); those of the others are estimated, observed (a calibration with its sigma) or held.
    """

    name = "mounted"
    order = 1
    uses_image = False
    looks_elsewhere = True
    parameters = (
        Parameter("bx", "length", "parameter.rig_x", typical=0.11),
        Parameter("by", "length", "parameter.rig_y", typical=-0.02),
        Parameter("bz", "length", "parameter.rig_z", typical=0.03),
        Parameter("om", "rad", "parameter.rig_omega", typical=0.02),
        Parameter("ph", "rad", "parameter.rig_phi", typical=-0.03),
        Parameter("ka", "rad", "parameter.rig_kappa", typical=0.05),
    )

    @staticmethod
    def point(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        bx: Scalar, by: Scalar, bz: Scalar, om: Scalar, ph: Scalar, ka: Scalar,
    ) -> Point:  # fmt: skip
        """The point in the axes of the camera."""
        del x, y
        return mounted_axes((X - bx, Y - by, Z - bz), (om, ph, ka))


def orientation_of(centre: Array, rotation: Array, mounting: Mapping[str, float]) -> tuple[Array, Array]:
    """Projection centre (3,) and rotation (3, 3) of a camera from those of its rig and its mounting."""
    own = rotation_from_angles(np.array([mounting[s] for s in ANGLES]))
    return centre + rotation.T @ np.array([mounting[s] for s in OFFSET]), own @ rotation


def mounting_of(centre: Array, rotation: Array, camera_centre: Array, camera_rotation: Array) -> dict[str, float]:
    """The mounting of a camera from the exterior orientations of its rig and of itself; a start for the adjustment."""
    offset = rotation @ (camera_centre - centre)
    angles = angles_from_rotation(camera_rotation @ rotation.T)
    return dict(zip((*OFFSET, *ANGLES), (float(v) for v in (*offset, *angles)), strict=True))
