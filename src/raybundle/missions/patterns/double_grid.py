"""Two sets of parallel lines square to each other."""

from __future__ import annotations

import math

from raybundle.missions.patterns.base import Line, Pattern, Wish, register, straight_lines
from raybundle.missions.polygons import longest_direction
from raybundle.numerics.arrays import Array


def lines(outline: Array, wish: Wish) -> list[Line]:
    """Lines along the area and across it, the view tilted forward where that is asked for.

    A tilt of 10 to 30 deg makes heights and camera constant determinable; looking straight down on both does not.
    """
    direction = longest_direction(outline) if wish.direction is None else wish.direction
    tilt = wish.tilt or 0.0
    return [
        *straight_lines(outline, wish, direction=direction, tilt=tilt, group="line"),
        *straight_lines(outline, wish, direction=direction + math.pi / 2, tilt=tilt, group="cross line"),
    ]


register(
    Pattern(
        name="double-grid",
        shape="area",
        lines=lines,
        steps=lambda wish: wish.steps(wish.tilt or 0.0),
    )
)
