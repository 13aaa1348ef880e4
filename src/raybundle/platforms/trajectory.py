"""A trajectory: a sensor that is read line by line while it is carried along, polynomials in the measured line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from raybundle.errors import Message, message
from raybundle.numerics.arrays import Array
from raybundle.numerics.maths import Scalar
from raybundle.numerics.motion import Point, turned_axes
from raybundle.platforms.platform import Platform
from raybundle.sensors.model import Parameter, SensorModel

WAY = 0.05
"""Default of vy of a line sensor, which sees nothing where it stands."""


class Trajectory(Platform):
    """Polynomials of order 2 in y, the measured line, which stands for the time.

    Position and attitude of line y against the station (the exterior orientation, which is that of the line y = 0):
        P(y) = v y + a y^2 [length],   turn(y) = w y + q y^2 [rad],   in the axes of the station
    The motion belongs to each image (`per_image`).  With little relief position and attitude are hardly distinguished
    from each
    other, so give what GNSS and INS know as observed values.  Against `rolling` there is no read-out time, which a
    motion per line does not need, and the motion may change within an image.
    """

    name = "trajectory"
    order = 0
    uses_image = True
    moves = True
    looks_elsewhere = False
    parameters = (
        Parameter("vx", "length/mm", "parameter.motion_right", typical=0.002),
        Parameter("vy", "length/mm", "parameter.motion_along", typical=0.08),
        Parameter("vz", "length/mm", "parameter.motion_backwards", typical=0.001),
        Parameter("ax", "length/mm^2", "parameter.motion_change_right", typical=1e-5),
        Parameter("ay", "length/mm^2", "parameter.motion_change_along", typical=-1e-5),
        Parameter("az", "length/mm^2", "parameter.motion_change_backwards", typical=1e-5),
        Parameter("wx", "rad/mm", "parameter.turn_x", typical=1e-5),
        Parameter("wy", "rad/mm", "parameter.turn_y", typical=-2e-5),
        Parameter("wz", "rad/mm", "parameter.turn_viewing", typical=1e-5),
        Parameter("qx", "rad/mm^2", "parameter.turn_change_x", typical=1e-7),
        Parameter("qy", "rad/mm^2", "parameter.turn_change_y", typical=1e-7),
        Parameter("qz", "rad/mm^2", "parameter.turn_change_viewing", typical=-1e-7),
    )

    def carries(self, sensor: SensorModel) -> bool:
        """Lines, and frames that are read row by row."""
        return sensor.line or super().carries(sensor)

    def parameters_with(self, sensor: SensorModel) -> tuple[Parameter, ...]:
        """A frame stands still where nothing is stated, a line does not."""
        if not sensor.line:
            return self.parameters
        return tuple(replace(p, default=WAY) if p.symbol == "vy" else p for p in self.parameters)

    def objection(self, sensor: SensorModel, values: Mapping[str, float], free: Sequence[str]) -> Message | None:
        """A line that is not carried along sees one line of the object."""
        if not sensor.line or values.get("vy") or "vy" in free:
            return None
        return message("camera.no_motion")

    @staticmethod
    def point(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        vx: Scalar, vy: Scalar, vz: Scalar, ax: Scalar, ay: Scalar, az: Scalar,
        wx: Scalar, wy: Scalar, wz: Scalar, qx: Scalar, qy: Scalar, qz: Scalar,
    ) -> Point:  # fmt: skip
        """The point in the axes that the sensor had at the time of the line."""
        del x
        y2 = y * y
        moved = X - vx * y - ax * y2, Y - vy * y - ay * y2, Z - vz * y - az * y2
        return turned_axes(moved, (wx * y + qx * y2, wy * y + qy * y2, wz * y + qz * y2))

    def line_passing(self, points: Array, values: Array) -> Array:
        """For a motion that is steady along the way, and a line that looks straight ahead."""
        return points[1] / values[1]
