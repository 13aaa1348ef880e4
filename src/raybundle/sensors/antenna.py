"""What stands between a projection centre and the position that GNSS tells of it."""

from __future__ import annotations

from typing import ClassVar

from raybundle.sensors.model import Parameter, SensorModel


class Antenna(SensorModel, registered=False):
    """Lever arm of an antenna, and shift and drift of the positions of one flight line.

    observed = X0 + R' a + s + d t, with a in the axes of the image, s and d in those of the object.  It has no images;
    its parameters are adjusted with those of the cameras.  With all images level and heads alike, a and s are one.
    """

    name = "antenna"
    has_images: ClassVar[bool] = False
    parameters = (
        Parameter("ax", "length", "lever arm to the right in the image"),
        Parameter("ay", "length", "lever arm upwards in the image"),
        Parameter("az", "length", "lever arm backwards"),
        Parameter("sx", "length", "shift of X"),
        Parameter("sy", "length", "shift of Y"),
        Parameter("sz", "length", "shift of Z"),
        Parameter("dx", "length/s", "drift of X"),
        Parameter("dy", "length/s", "drift of Y"),
        Parameter("dz", "length/s", "drift of Z"),
    )


ANTENNA = Antenna()
