"""What stands between a projection centre and the position that GNSS measures of it."""

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
        Parameter("ax", "length", "parameter.lever_arm_right"),
        Parameter("ay", "length", "parameter.lever_arm_up"),
        Parameter("az", "length", "parameter.lever_arm_backwards"),
        Parameter("sx", "length", "parameter.shift_x"),
        Parameter("sy", "length", "parameter.shift_y"),
        Parameter("sz", "length", "parameter.shift_z"),
        Parameter("dx", "length/s", "parameter.drift_x"),
        Parameter("dy", "length/s", "parameter.drift_y"),
        Parameter("dz", "length/s", "parameter.drift_z"),
        Parameter("dt", "s", "parameter.time_of_positions"),
    )
