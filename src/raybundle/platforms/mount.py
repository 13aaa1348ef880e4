"""What stands between a platform that carries several line sensors and one of them."""

from __future__ import annotations

from raybundle.platforms.instrument import InstrumentModel
from raybundle.sensors.model import Parameter


class Mount(InstrumentModel):
    """Misalignment and time offset of one line sensor of several on a trajectory.

    R_line = exp([b]x) M R_platform, with b a small rotation about the axes of the line's detector and M its nominal
    mounting; the tables of the trajectory hold for the time of the line + bt.  A rotation that all lines have in common
    is one of the trajectory: hold one mount, or give standard deviations.
    """

    name = "mount"
    section = "mounts"
    noun = "mount"
    formula = "R_line(t) = exp([b]x) M R_platform(t + bt)"
    parameters = (
        Parameter("bx", "rad", "parameter.misalignment_x"),
        Parameter("by", "rad", "parameter.misalignment_y"),
        Parameter("bz", "rad", "parameter.misalignment_viewing"),
        Parameter("bt", "s", "parameter.time_of_line"),
    )
