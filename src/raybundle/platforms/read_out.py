"""A sensor that is read out row by row while it moves: rolling shutter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from raybundle.errors import Message, message
from raybundle.numerics.maths import Scalar
from raybundle.numerics.motion import Point, turned_axes
from raybundle.platforms.platform import Platform
from raybundle.sensors.model import Parameter, SensorModel

MOTION = ("vx", "vy", "vz", "wx", "wy", "wz")


class ReadOut(Platform):
    """A short trajectory: the time of an image point is that of its measured row.

    t = -r y, zero in the middle of the format, growing downwards, with r = read-out time / height of the format.
    (U, V, W) = exp(-[w t]x) ((X, Y, Z) - v t), v and w in the axes of the middle row.  Motion belongs to each image
    (`per_image`).  r and the motion enter as products: r is held, or the motion is known from elsewhere (observed).
    """

    name = "rolling"
    order = 0
    uses_image = True
    moves = True
    looks_elsewhere = False
    parameters = (
        Parameter("r", "s/mm", "parameter.read_out", typical=1.5e-3, kind="read-out"),
        Parameter("vx", "length/s", "parameter.velocity_right", typical=0.8),
        Parameter("vy", "length/s", "parameter.velocity_up", typical=-0.5),
        Parameter("vz", "length/s", "parameter.velocity_backwards", typical=0.3),
        Parameter("wx", "rad/s", "parameter.rotation_rate_x", typical=0.1),
        Parameter("wy", "rad/s", "parameter.rotation_rate_y", typical=-0.2),
        Parameter("wz", "rad/s", "parameter.rotation_rate_viewing", typical=0.15),
    )

    def objection(self, sensor: SensorModel, values: Mapping[str, float], free: Sequence[str]) -> Message | None:
        """A rolling shutter without read-out time shows no motion."""
        del sensor
        moving = [s for s in free if s in MOTION]
        if not moving or values.get("r") or "r" in free:
            return None
        return message("camera.no_read_out_time", parameters=moving)

    @staticmethod
    def point(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        r: Scalar, vx: Scalar, vy: Scalar, vz: Scalar, wx: Scalar, wy: Scalar, wz: Scalar,
    ) -> Point:  # fmt: skip
        """The point in the axes that the sensor had when the row was read."""
        del x
        t = -r * y
        return turned_axes((X - vx * t, Y - vy * t, Z - vz * t), (wx * t, wy * t, wz * t))
