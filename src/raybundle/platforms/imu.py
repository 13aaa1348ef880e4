"""What stands between the attitude of an image and that which an inertial measurement unit measures of it."""

from __future__ import annotations

from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import left_jacobian, rotation_from_vector
from raybundle.platforms.instrument import InstrumentModel
from raybundle.sensors.model import Parameter


class Imu(InstrumentModel):
    """Misalignment (boresight) of an IMU against the images that are taken with it.

    R = exp([b]x) R_observed, with b a small rotation about the axes of the image and R_observed that of omega, phi,
    kappa as the IMU shows them for the nominal mounting.  A constant error of the IMU's roll and pitch hides in b; with
    one heading alone that of its yaw as well.
    """

    name = "imu"
    section = "imus"
    noun = "IMU"
    formula = "R = exp([b]x) R_IMU"
    parameters = (
        Parameter("bx", "rad", "parameter.misalignment_x"),
        Parameter("by", "rad", "parameter.misalignment_y"),
        Parameter("bz", "rad", "parameter.misalignment_viewing"),
    )


def reported(rotation: Array, boresight: Array) -> tuple[Array, Array, Array]:
    """What an IMU shows (n, 3, 3) for images of rotations (n, 3, 3), with a boresight (3,).

    Also how a small rotation of it, about its own axes, follows from one of the image (3, 3) and from a change of the
    boresight (3, 3): exp(-[b]x) and -exp(-[b]x) J, exp([b + d]x) = exp([J d]x) exp([b]x) to first order.
    """
    back = rotation_from_vector(-boresight)
    return back @ rotation, back, -back @ left_jacobian(boresight)
