"""What stands between a projection centre and the position that GNSS tells of it."""

from __future__ import annotations

from raybundle.platforms.instrument import InstrumentModel
from raybundle.sensors.model import Parameter


class Antenna(InstrumentModel):
    """Lever arm of an antenna, shift and drift of the positions of one flight line, and the offset of its clock.

    observed = X0 + R' a + s + d t + v dt, with a in the axes of the image, s and d in those of the object, v the
    velocity of the image.  With all images level and heads alike, a and s are one; at one speed dt and the lever arm
    along the flight are.
    """

    name = "antenna"
    section = "antennas"
    noun = "antenna"
    formula = "X_GNSS = X0 + Rᵀ a + s + d t + v dt"
    in_object = (("sx", "sy", "sz"), ("dx", "dy", "dz"))
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
        Parameter("dt", "s", "time of the positions minus that of the exposures"),
    )
