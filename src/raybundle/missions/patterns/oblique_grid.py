"""A nadir grid, and one grid for each of several oblique views, whose azimuths are kept on the way back."""

from __future__ import annotations

import math

from raybundle.missions.patterns.base import Line, Pattern, Wish, register, straight_lines
from raybundle.missions.polygons import longest_direction
from raybundle.numerics.arrays import Array

TILT = math.radians(35)
"""From the nadir: facades are seen, and the far edge of a photograph is not yet twice as far as the near one."""


def lines(outline: Array, wish: Wish) -> list[Line]:
    """The nadir lines first, then those of each view; every place is seen from each side."""
    direction = longest_direction(outline) if wish.direction is None else wish.direction
    tilt = TILT if wish.tilt is None else wish.tilt
    found = straight_lines(outline, wish, direction=direction, tilt=0.0, group="line")
    for k in range(wish.directions):
        azimuth = (direction + 2 * math.pi * k / wish.directions) % (2 * math.pi)
        group = f"view to {math.degrees(azimuth):.0f} deg"
        found += straight_lines(outline, wish, direction=azimuth, tilt=tilt, group=group, fixed=True)
    return found


register(
    Pattern(
        name="oblique-grid",
        shape="area",
        lines=lines,
        steps=lambda wish: wish.steps(0.0),
    )
)
