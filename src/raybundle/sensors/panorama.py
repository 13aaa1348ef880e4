"""Rotating linear-array panoramic camera."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from raybundle.errors import Message, message
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.maths import Scalar, cos, sin
from raybundle.sensors.model import Parameter, SensorModel

MOST_TURNS = 1.25
"""Turns that the format of a panorama can span: one, and an overlap."""


def too_many_turns(width_mm: float, c: float) -> Message | None:
    """What is wrong with a format [mm] that is longer than a turn about an axis at the distance c; None for nothing."""
    whole = width_mm / (2 * np.pi)
    if whole / c <= MOST_TURNS:
        return None
    return message(
        "camera.too_many_turns", width_mm=width_mm, turns=whole / c, c_mm=c, limit=MOST_TURNS, whole_turn_c_mm=whole
    )


class Panorama(SensorModel):
    """A vertical line that turns about the y axis; x is the arc length on the image cylinder.

    The image point lies in the plane of the line at the turn (1 + A) x / c.  What a real camera adds (Schneider and
    Maas 2004, 2006): the projection centre beside the axis (e along the view, d across it), a line that is turned
    about the view (T) or leans along it (I), radial distortion along the line, and an axis that tumbles.  A tumbling
    of one turn in a turn stands still for the line or is a tilt of the axis; what is left of it runs twice round
    (u1, u2).
    """

    name = "panorama"
    frame = False
    one_exposure = False
    parameters = (
        Parameter("c", "mm", "parameter.camera_constant", 50.0, kind="scale"),
        Parameter("y0", "mm", "parameter.principal_point_line", typical=0.1, kind="principal point"),
        Parameter("e", "length", "parameter.eccentricity_along", typical=0.002),
        Parameter("K1", "mm^-2", "parameter.radial_line", typical=-3e-6, kind="radial"),
        Parameter("K2", "mm^-4", "parameter.radial_line", typical=1e-9, kind="radial"),
        Parameter("d", "length", "parameter.eccentricity_across", typical=0.001),
        Parameter("T", "1", "parameter.line_tilt", typical=5e-4),
        Parameter("I", "1", "parameter.line_inclination", typical=3e-4),
        Parameter("A", "1", "parameter.angular_scale", typical=1e-4),
        Parameter("u1", "rad", "parameter.tumbling_cosine", typical=1e-4),
        Parameter("u2", "rad", "parameter.tumbling_sine", typical=-1e-4),
    )

    def objection(self, values: Mapping[str, float], width_mm: float, free: Sequence[str]) -> Message | None:
        """A format of several turns would put points behind the camera."""
        del free
        return too_many_turns(width_mm, values["c"])

    @staticmethod
    def condition(
        x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar,
        c: Scalar, y0: Scalar, e: Scalar, K1: Scalar, K2: Scalar, d: Scalar, T: Scalar, I: Scalar, A: Scalar,
        u1: Scalar, u2: Scalar,
    ) -> tuple[Scalar, Scalar]:  # fmt: skip
        """Distance from the plane of the line, and central projection within it."""
        turn = (1 + A) * x / c
        side = cos(turn) * X + sin(turn) * Z
        depth = sin(turn) * X - cos(turn) * Z
        nod = u1 * cos(2 * turn) + u2 * sin(2 * turn)  # about the axis across the view
        roll = u2 * cos(2 * turn) - u1 * sin(2 * turn)  # about the view
        across, up, along = side + roll * Y - d, Y - roll * side - nod * depth, depth + nod * Y - e
        v = y - y0
        v2 = v * v
        return T * v - c * across / along, v + v * v2 * (K1 + K2 * v2) - (c + I * v) * up / along

    def start(self, points: Array, values: Array) -> Array:
        """Turn and height without corrections."""
        turn = np.arctan2(points[0], -points[2])
        return values[0] * np.stack([turn, points[1] / np.hypot(points[0], points[2])])

    def ray(self, image: Array, values: Array, start: Array | None = None) -> Array:
        """As of any model, from the turn and the height without corrections."""
        if start is None:
            turn = image[0] / values[0]
            start = np.stack([np.sin(turn), image[1] / values[0], -np.cos(turn)])
        return super().ray(image, values, start)

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """In front of the line at the turn at which it was measured; everywhere if none was."""
        if image is None or values is None:
            return np.hypot(points[0], points[2]) > 0
        turn = image[0] / values[0]
        return np.sin(turn) * points[0] - np.cos(turn) * points[2] - values[2] > 0
