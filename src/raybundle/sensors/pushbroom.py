"""A line sensor that is carried along: pushbroom, with polynomials in the measured line for its trajectory."""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.maths import Scalar
from raybundle.numerics.motion import turned_axes
from raybundle.sensors.model import Parameter, SensorModel

RAY_REACH = 1e3
"""Length of viewing rays, in extents of the trajectory within the image."""
MOTION = slice(5, 17)


class Pushbroom(SensorModel):
    """A line across the view; y, the measured line, stands for the time.

    Position and attitude of line y against the station (the exterior orientation, which is that of the line y = 0) are
    polynomials of order 1 and 2 in y; order 0 is the station itself:
        P(y) = v y + a y^2 [length],   turn(y) = w y + q y^2 [rad],   in the axes of the station
    The first lines stand on top of the image, so that vy > 0 is the length that one mm of the image covers on the way.
    Polynomials are the motion of each image (`per_image`); with little relief they are hardly told from each other, so
    give what GNSS and INS know as observed values.
    """

    name = "pushbroom"
    frame = False
    one_exposure = False
    parameters = (
        Parameter("c", "mm", "camera constant", 50.0, kind="scale"),
        Parameter("x0", "mm", "principal point on the line", typical=0.05, kind="principal point"),
        Parameter("y0", "mm", "place of the line in the focal plane, along the way", typical=-0.1),
        Parameter("K1", "mm^-2", "radial distortion along the line", typical=-2e-6, kind="radial"),
        Parameter("K2", "mm^-4", "radial distortion along the line", typical=1e-10, kind="radial"),
        Parameter("vx", "length/mm", "motion to the right", typical=0.002),
        Parameter("vy", "length/mm", "motion along the way", 0.05, typical=0.08),
        Parameter("vz", "length/mm", "motion backwards", typical=0.001),
        Parameter("ax", "length/mm^2", "change of the motion to the right", typical=1e-5),
        Parameter("ay", "length/mm^2", "change of the motion along the way", typical=-1e-5),
        Parameter("az", "length/mm^2", "change of the motion backwards", typical=1e-5),
        Parameter("wx", "rad/mm", "turn about the x axis", typical=1e-5),
        Parameter("wy", "rad/mm", "turn about the y axis", typical=-2e-5),
        Parameter("wz", "rad/mm", "turn about the viewing axis", typical=1e-5),
        Parameter("qx", "rad/mm^2", "change of the turn about the x axis", typical=1e-7),
        Parameter("qy", "rad/mm^2", "change of the turn about the y axis", typical=1e-7),
        Parameter("qz", "rad/mm^2", "change of the turn about the viewing axis", typical=-1e-7),
    )

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, x0: Scalar, y0: Scalar, K1: Scalar, K2: Scalar,
        vx: Scalar, vy: Scalar, vz: Scalar, ax: Scalar, ay: Scalar, az: Scalar,
        wx: Scalar, wy: Scalar, wz: Scalar, qx: Scalar, qy: Scalar, qz: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Central projection along the line, and the distance from the plane of the line, at the time of the line."""
        y2 = y * y
        moved = X - vx * y - ax * y2, Y - vy * y - ay * y2, Z - vz * y - az * y2
        U, V, W = turned_axes(moved, (wx * y + qx * y2, wy * y + qy * y2, wz * y + qz * y2))
        u = x - x0
        u2 = u * u
        return u + u * u2 * (K1 + K2 * u2) + c * U / W, y0 + c * V / W

    def start(self, points: Array, values: Array) -> Array:
        """Without turns and distortion, for a motion that is steady along the way."""
        y = points[1] / values[6]
        return np.stack([values[1] - values[0] * (points[0] - values[5] * y) / points[2], y])

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """Below the station."""
        del image, values
        return points[2] < 0

    def ray(self, image: Array, values: Array, start: Array | None = None) -> Array:
        """Points (3, n) far along the viewing rays: they do not pass through the station."""
        del start
        v, a = np.broadcast_to(values[MOTION].reshape(4, 3, -1), (4, 3, image.shape[1]))[:2]
        extent = np.abs(v * image[1] + a * image[1] ** 2).max(initial=0.0)
        return self.point_on_ray(image, values, RAY_REACH * max(float(extent), 1.0))

    def point_on_ray(self, image: Array, values: Array, distance: float) -> Array:
        """Points (3, n) at this distance from where the sensor was."""
        x, y = image
        c, x0, y0, K1, K2 = values[:5]
        v, a, w, q = np.broadcast_to(values[MOTION].reshape(4, 3, -1), (4, 3, len(x)))
        u = x - x0
        own = np.stack([u + u**3 * (K1 + K2 * u * u), y0 + 0 * y, -c + 0 * y])
        place = v * y + a * y * y
        back = -(w * y + q * y * y)
        direction = np.stack(turned_axes((own[0], own[1], own[2]), (back[0], back[1], back[2])))
        return place + distance * direction / np.linalg.norm(direction, axis=0)
